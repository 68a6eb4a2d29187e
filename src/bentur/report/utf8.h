#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bentur {

/// A character of a UTF-8 text.
struct Utf8Character {
  std::string_view bytes;  ///< as they stand in the text
  std::int32_t code = -1;  ///< its code point of Unicode; -1: a byte that is not UTF-8
};

/// The characters of a text, in order, with views into it; each byte that is not UTF-8 is one by itself.
[[nodiscard]] std::vector<Utf8Character> characters(std::string_view text);

/// Columns that a text takes on a terminal: one for most characters, two for those of East Asia, none for combining
/// marks.
[[nodiscard]] std::size_t display_width(std::string_view text);

}  // namespace bentur
