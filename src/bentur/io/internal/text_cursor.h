#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bentur {

/// Walks over a text character by character, counting lines and columns.
class TextCursor {
 public:
  explicit TextCursor(const std::string& text) : text_(text) {}

  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  [[nodiscard]] bool starts(std::string_view what) const {
    return std::string_view(text_).substr(at_).starts_with(what);
  }
  /// What stands here, up to the end.
  [[nodiscard]] std::string_view rest() const { return std::string_view(text_).substr(at_); }
  [[nodiscard]] char byte() const { return text_[at_]; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] int column() const { return column_; }

  /// The character here, or nothing when the bytes are not valid UTF-8 (RFC 3629: shortest form, no surrogates).
  [[nodiscard]] std::optional<char32_t> character() {
    const unsigned char lead = at(0);
    length_ = lead < 0x80                   ? 1
              : lead >= 0xC2 && lead < 0xE0 ? 2
              : (lead & 0xF0) == 0xE0       ? 3
              : lead >= 0xF0 && lead < 0xF5 ? 4
                                            : 0;
    if (length_ == 0) return std::nullopt;
    if (length_ == 1) return lead;
    char32_t value = lead & (0x7FU >> length_);
    for (std::size_t i = 1; i < length_; ++i) {
      if ((at(i) & 0xC0) != 0x80) return std::nullopt;
      value = (value << 6) | (at(i) & 0x3FU);
    }
    const char32_t least = length_ == 2 ? 0x80 : length_ == 3 ? 0x800 : 0x10000;
    if (value < least || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) return std::nullopt;
    return value;
  }

  /// Steps over the character last asked for.
  void next() {
    const bool line_ends = byte() == '\n';
    at_ += length_;
    line_ += line_ends ? 1 : 0;
    column_ = line_ends ? 1 : column_ + 1;
  }

 private:
  [[nodiscard]] unsigned char at(std::size_t offset) const {
    return at_ + offset < text_.size() ? static_cast<unsigned char>(text_[at_ + offset]) : 0;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::size_t length_ = 1;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace bentur
