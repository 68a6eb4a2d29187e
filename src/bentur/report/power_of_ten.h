#pragma once

#include <cstdlib>
#include <string>

namespace bentur {

/// "10⁻⁵".
[[nodiscard]] inline std::string power_of_ten(int exponent) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string power = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) power += digits[digit - '0'];
  return power;
}

}  // namespace bentur
