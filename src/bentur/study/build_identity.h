#pragma once

#include <string_view>

namespace bentur {

/// A hash of the sources that this library was built from, of all modules up to `study`: what two builds of one version
/// may compute differently. 64 hexadecimal digits of SHA-256.
[[nodiscard]] std::string_view build_identity();

}  // namespace bentur
