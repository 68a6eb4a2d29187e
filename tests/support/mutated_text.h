#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace bentur::test {

inline std::string utf8(unsigned c) {
  std::string bytes;
  const auto put = [&](unsigned byte) { bytes += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xC0 | (c >> 6));
    put(0x80 | (c & 63));
  } else {
    put(0xE0 | (c >> 12));
    put(0x80 | ((c >> 6) & 63));
    put(0x80 | (c & 63));
  }
  return bytes;
}

/// The text with one to four pieces changed, put in, taken out or said twice. The generator is seeded, so that a
/// failure can be repeated.
inline std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> bits = {"[",
                                                "]",
                                                "{",
                                                "}",
                                                "#",
                                                "\"",
                                                "'",
                                                "\"\"\"",
                                                "'''",
                                                "\\",
                                                "\n",
                                                "\r",
                                                ",",
                                                ".",
                                                "=",
                                                "[[",
                                                "]]",
                                                "[#",
                                                "nan",
                                                "inf",
                                                "-",
                                                "1e999",
                                                "0x",
                                                "1979-05-27",
                                                "_",
                                                "\xEF\xBB\xBF",
                                                "\xC3\xA9",
                                                "\xEF\xBB\xAF",
                                                "\xEF\xBB\xB7",
                                                "\xFF",
                                                "true",
                                                "9223372036854775808",
                                                "\\ud800",
                                                "\t",
                                                "\v",
                                                "\x7F",
                                                std::string(1, '\0')};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t change = 0, changes = 1 + below(4); change < changes && !text.empty(); ++change) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(random() & 0xFF);
        break;
      case 1:
        text.insert(at, bits[below(bits.size())]);
        break;
      case 2:
        text.erase(at, 1 + below(12));
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), below(60)));
        break;
      default:
        text.insert(at, utf8(static_cast<unsigned>(0x80 + below(0xFF80))));
    }
  }
  return text;
}

}  // namespace bentur::test
