#pragma once

#include <string>
#include <string_view>

namespace bentur {

/// A text made safe to be shown: one line, no control characters, and nothing that XML forbids in a text.
[[nodiscard]] std::string plain_text(std::string_view text);

/// "Force F [kgf]".
[[nodiscard]] std::string with_unit(const std::string& label, const std::string& unit);

/// "1350", "27.0", "0.0886": a number in a picture, of three significant digits whichever they are.
[[nodiscard]] std::string short_number(double value);

/// "−0.4": a number with the sign for minus; another text as it is.
[[nodiscard]] std::string signed_text(std::string text);

}  // namespace bentur
