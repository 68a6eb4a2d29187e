#pragma once

#include <cstdint>
#include <string>
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

/// Any text as XML and HTML have it, between tags and within quotes. Control characters become U+FFFD.
[[nodiscard]] std::string markup_text(std::string_view text);

}  // namespace bentur
