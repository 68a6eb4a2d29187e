#pragma once

#include <cstddef>
#include <string_view>

namespace bentur::cli {

/// Columns that a text takes on a terminal: one for most characters, two for those of East Asia, none for combining
/// marks.
[[nodiscard]] std::size_t display_width(std::string_view text);

}  // namespace bentur::cli
