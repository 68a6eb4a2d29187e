#pragma once

#include <string_view>

namespace bentur {

/// Which bentur this is: its version, and where that is no release the commit that it was built from, in the form of
/// PEP 440: "0.2.0", "0.2.0.dev874+g2e9c731a". docs/result-files.md#version has all forms, cmake/version.cmake makes
/// them.
[[nodiscard]] std::string_view version() noexcept;

}  // namespace bentur
