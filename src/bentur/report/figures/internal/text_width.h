#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace bentur {

/// Whether DejaVu Sans, the font that figures name first, has this character.
[[nodiscard]] bool is_in_font(std::int32_t code);

/// The width of a text at 8 pt in DejaVu Sans, the widest of the fonts that figures are drawn with [cm]. What that
/// lacks is as wide as it is high, as letters of East Asia are.
[[nodiscard]] double text_width(std::string_view text);

/// The text, or as much of it as fits a width with an ellipsis [cm].
[[nodiscard]] std::string cut_to(const std::string& text, double width);

}  // namespace bentur
