#pragma once

#include <string>
#include <string_view>

namespace bentur {

/// The width of a text at 8 pt in DejaVu Sans, the widest of the fonts that figures are drawn with [cm].
[[nodiscard]] double text_width(std::string_view text);

/// The text, or as much of it as fits a width with an ellipsis [cm].
[[nodiscard]] std::string cut_to(const std::string& text, double width);

}  // namespace bentur
