#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bentur {

/// Whether DejaVu Sans, the font that figures name first, has this character.
[[nodiscard]] bool is_in_font(std::int32_t code);

/// What a raised or lowered figure is drawn as: a common letter, smaller. Of the fonts that figures are drawn with only
/// DejaVu Sans has "⁻⁶" and "₁" themselves.
struct SmallLetter {
  std::string_view common;  ///< a digit, or a minus
  bool is_raised = false;   ///< else lowered
};
constexpr double small_size = 0.65;  ///< of a small letter over that of a common one
/// Nothing for all other characters.
[[nodiscard]] std::optional<SmallLetter> small_letter(std::int32_t code);

/// The width of a text at 8 pt in DejaVu Sans, the widest of the fonts that figures are drawn with [cm]. What that
/// lacks is as wide as it is high, as letters of East Asia are.
[[nodiscard]] double text_width(std::string_view text);

/// The text, or as much of it as fits a width with an ellipsis [cm].
[[nodiscard]] std::string cut_to(const std::string& text, double width);

}  // namespace bentur
