#include "bentur/report/figures/internal/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bentur/core/number_text.h"
#include "bentur/report/utf8.h"

namespace bentur {

std::string plain_text(std::string_view text) {
  std::string result;
  for (const auto& [bytes, code] : characters(text)) {
    const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);  // a byte that is none has code -1
    const bool is_line_end = code == 0x2028 || code == 0x2029;
    const bool is_hidden = is_control || is_line_end || code == 0xFFFE || code == 0xFFFF;
    result += is_hidden ? " " : bytes;
  }
  for (std::size_t at = 0; (at = result.find("]]>", at)) != std::string::npos;) result.insert(at + 2, " ");
  return result;
}

std::string with_unit(const std::string& label, const std::string& unit) { return label + " [" + unit + "]"; }

std::string short_number(double value) {
  if (!(std::abs(value) >= 1e-4 && std::abs(value) < 1e7)) return number(value);
  const auto power_of = [](double of) { return static_cast<int>(std::floor(std::log10(std::abs(of)))); };
  const double unit = std::pow(10.0, power_of(value) - 2), rounded = std::round(value / unit) * unit;
  return fmt::format("{:.{}f}", rounded, std::max(0, 2 - power_of(rounded * (1 + 1e-12))));
}

std::string signed_text(std::string text) {
  const bool is_negative = text.size() > 1 && text[0] == '-' && (text[1] == '.' || (text[1] >= '0' && text[1] <= '9'));
  if (is_negative) text.replace(0, 1, "−");
  return text;
}

}  // namespace bentur
