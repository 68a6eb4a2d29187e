#include "bentur/core/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <system_error>

namespace bentur {
namespace {

constexpr const char* times = "\u00A0×\u00A0";  // between no-break spaces

/// Takes zeros off the end of a decimal fraction, the one before a power of ten too.
std::string without_zeros(std::string text) {
  const std::size_t end = std::min(text.find(times), text.size());
  const std::size_t point = text.find('.');
  if (point >= end) return text;
  const std::size_t last = text.find_last_not_of('0', end - 1);
  const std::size_t kept = last == point ? point : last + 1;
  return text.erase(kept, end - kept);
}

/// Decimals that leave four significant digits of `largest`; −1 where an exponent reads better.
int decimals_for(double largest) {
  if (largest == 0) return 0;
  if (largest < 1e-4 || largest >= 1e7) return -1;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 7);
}

std::string with_decimals(double value, int decimals) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  if (decimals >= 0 || value == 0) return fmt::format("{:.{}f}", value, std::max(decimals, 0));
  const std::string text = fmt::format("{:.3e}", value);
  const std::size_t at = text.find('e');
  return text.substr(0, at) + times + power_of_ten(std::atoi(text.c_str() + at + 1));
}

}  // namespace

std::string power_of_ten(int exponent) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string power = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) power += digits[digit - '0'];
  return power;
}

std::string number(double value) { return without_zeros(with_decimals(value, decimals_for(std::abs(value)))); }

std::vector<std::string> column(const std::vector<double>& values, int digits, int of_least) {
  double largest = 0, least = INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value) || value == 0) continue;
    largest = std::max(largest, std::abs(value));
    least = std::min(least, std::abs(value));
  }
  int most = decimals_for(largest);
  for (int fewer = 4 - digits; fewer > 0 && most > 0 && least > std::pow(10.0, 1 - most); --fewer) --most;
  for (int more = 0; of_least > 0 && more < 2 && most >= 0 && least < std::pow(10.0, of_least - 1 - most); ++more)
    ++most;
  int needed = 0;
  for (const double value : values) {  // no more decimals than some number uses: 100 200 300, 0.2 0.25
    const std::string text = without_zeros(with_decimals(value, most));
    const std::size_t point = text.find('.');
    needed = std::max(needed, point == std::string::npos ? 0 : static_cast<int>(text.size() - point) - 1);
  }
  const int decimals = most < 0 ? most : needed;
  std::vector<std::string> cells;
  cells.reserve(values.size());
  for (const double value : values) cells.push_back(value == 0 ? "0" : with_decimals(value, decimals));
  return cells;
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, failure] = from_chars(text.data(), text.data() + text.size(), value);
  const bool good = failure == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return good ? std::optional(value) : std::nullopt;
}

#if defined(__cpp_lib_to_chars)

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}

#else

namespace {

/// Digits · 10^power where both are exact in a double, so that the result is the nearest one [Clinger1990]: the numbers
/// of records, which strtod takes ten times as long for.
std::optional<double> exact_product(std::string_view number) {
  constexpr std::array<double, 23> powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const bool negative = number.starts_with('-');
  std::uint64_t digits = 0;
  int power = 0, written = 0;
  bool fraction = false;
  std::size_t at = negative ? 1 : 0;
  for (; at < number.size() && number[at] != 'e' && number[at] != 'E'; ++at) {
    if (number[at] == '.') {
      fraction = true;
      continue;
    }
    if (++written > 15) return std::nullopt;  // 10^15 < 2^53
    digits = 10 * digits + static_cast<std::uint64_t>(number[at] - '0');
    power -= fraction ? 1 : 0;
  }
  if (at < number.size()) {
    if (number.size() - at > 4) return std::nullopt;
    int exponent = 0;
    const bool below = number[++at] == '-';
    for (at += below || number[at] == '+' ? 1 : 0; at < number.size(); ++at)
      exponent = 10 * exponent + number[at] - '0';
    power += below ? -exponent : exponent;
  }
  if (std::abs(power) > 22) return std::nullopt;
  const auto scale = powers[static_cast<std::size_t>(std::abs(power))];
  const double size = power < 0 ? static_cast<double>(digits) / scale : static_cast<double>(digits) * scale;
  return negative ? -size : size;
}

}  // namespace

// strtod reads more than std::from_chars does: blanks, a plus, hexadecimal digits, and on behind a number's end.
std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* at = first;
  const auto digits = [&] {
    const char* const begin = at;
    while (at != last && *at >= '0' && *at <= '9') ++at;
    return at - begin;
  };
  if (at != last && *at == '-') ++at;
  const char* const behind_sign = at;
  for (const std::string_view word : {"infinity", "inf", "nan"}) {
    const auto same = [](char a, char b) { return a == (b | 0x20); };
    if (static_cast<std::size_t>(last - at) < word.size() || !std::equal(word.begin(), word.end(), at, same)) continue;
    at += word.size();
    break;
  }
  if (at == behind_sign) {
    auto count = digits();
    if (at != last && *at == '.') {
      ++at;
      count += digits();
    }
    if (count == 0) return {first, std::errc::invalid_argument};
    const char* const behind_fraction = at;
    if (at != last && (*at == 'e' || *at == 'E')) {
      ++at;
      if (at != last && (*at == '-' || *at == '+')) ++at;
      if (digits() == 0) at = behind_fraction;
    }
  }
  const bool is_word = *behind_sign > '9';
  if (const auto exact = is_word ? std::nullopt : exact_product({first, static_cast<std::size_t>(at - first)})) {
    value = *exact;
    return {at, std::errc()};
  }
  const std::string text(first, at);
  errno = 0;
  const double read = std::strtod(text.c_str(), nullptr);
  const bool is_number = *behind_sign >= '0' && *behind_sign <= '9';
  if (errno == ERANGE && (std::isinf(read) || read == 0) && (is_number || *behind_sign == '.')) {
    return {at, std::errc::result_out_of_range};
  }
  value = read;
  return {at, std::errc()};
}

#endif

std::string written(double value) {
  const std::string text = fmt::format("{:.12g}", value);
  return fmt::format("{}", parse_number(text).value_or(value));
}

std::string written(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + written(value);
  return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace bentur
