#include "bentur/io/exchange/house_tags.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"

namespace bentur {
namespace {

constexpr double feet = 0.3048, inches = feet / 12;  // [m]
constexpr double highest_house = 1000;               // [m]
constexpr double most_storeys = 200;

std::string_view text_before(std::string_view text, std::size_t at) { return trimmed(text.substr(0, at)); }

/// Feet and inches [m], of a text with a mark of feet.
std::optional<double> feet_of(std::string_view text, std::size_t mark) {
  const auto whole = parse_number(text_before(text, mark));
  std::string_view rest = trimmed(text.substr(mark + 1));
  if (!whole || rest.empty()) return whole ? std::optional(*whole * feet) : std::nullopt;
  if (!rest.ends_with('"')) return std::nullopt;
  const auto part = parse_number(text_before(rest, rest.size() - 1));
  if (!part || *part < 0 || *part >= 12) return std::nullopt;
  return *whole * feet + *part * inches;
}

/// A number whose decimals may stand behind a comma.
std::optional<double> number_with_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return parse_number(text);
  if (comma + 1 == text.size()) return std::nullopt;
  if (text.find_first_of(",.", comma + 1) != std::string_view::npos || text.find('.') < comma) return std::nullopt;
  std::string point(text);
  point[comma] = '.';
  return parse_number(point);
}

/// Storeys of a text that names one number, a range or a sum; below zero where it is none.
double storeys_of(std::string_view text) {
  constexpr double none = -1;
  text = trimmed(text);
  if (const auto whole = parse_number(text)) return *whole < 0 ? none : *whole;
  // A comma is a decimal one before a half; before others it may divide two numbers.
  if (const auto half = text.ends_with(",5") ? number_with_comma(text) : std::nullopt) return *half;
  for (const std::string_view dash : {"-", "\xE2\x80\x93"}) {
    const std::size_t at = text.find(dash);
    if (at == std::string_view::npos || at == 0) continue;
    const auto low = parse_number(text_before(text, at)), high = parse_number(trimmed(text.substr(at + dash.size())));
    return low && high && *low >= 0 && *high >= 0 ? std::max(*low, *high) : none;
  }
  const std::size_t plus = text.find('+');
  if (plus == std::string_view::npos || plus == 0) return none;
  const auto one = parse_number(text_before(text, plus)), other = parse_number(trimmed(text.substr(plus + 1)));
  return one && other && *one >= 0 && *other >= 0 ? *one + *other : none;
}

}  // namespace

std::optional<HouseTag<double>> height_tag(const std::string& text) {
  std::string_view rest = trimmed(text);
  HouseTag<double> read;
  std::optional<double> height;
  const std::size_t mark = rest.find('\'');
  if (mark != std::string_view::npos) {
    height = feet_of(rest, mark);
    read.as_written = false;
  } else if (rest.ends_with("ft")) {
    height = parse_number(text_before(rest, rest.size() - 2));
    if (height) *height *= feet;
    read.as_written = false;
  } else {
    if (rest.ends_with('m')) rest = text_before(rest, rest.size() - 1);
    height = number_with_comma(rest);
    read.as_written = rest.find(',') == std::string_view::npos;
  }
  if (!height || !(*height > 0 && *height <= highest_house)) return std::nullopt;
  read.value = *height;
  return read;
}

std::optional<HouseTag<int>> storeys_tag(const std::string& text) {
  double most = 0;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const double storeys = storeys_of(std::string_view(text).substr(at, end - at));
    if (!(storeys >= 0 && storeys <= most_storeys)) return std::nullopt;
    most = std::max(most, std::ceil(storeys));
    at = end + 1;
  }
  if (most < 1) return std::nullopt;
  return HouseTag<int>{static_cast<int>(most), parse_number(trimmed(text)) == most};
}

}  // namespace bentur
