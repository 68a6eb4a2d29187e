#include "bentur/report/figures/internal/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

/// The smallest of 1, 2, 5, 10 · 10^n that is at least `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/// The power of ten, a third of them, that leaves short numbers.
int exponent_of(double largest) {
  if (!(largest > 0) || (largest >= 1e-3 && largest < 1e5)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
}

/// Of the number digit · 10^exponent of a logarithmic axis.
std::string decade_text(int digit, int exponent) {
  if (exponent >= -3 && exponent <= 3) return fmt::format("{:.4g}", digit * std::pow(10.0, exponent));
  return (digit == 1 ? "" : fmt::format("{}·", digit)) + power_of_ten(exponent);
}

Ticks linear(const TickRequest& request) {
  double low = request.from.value_or(request.low);
  double high = request.to.value_or(request.high);
  if (request.least && !request.from) low = std::min(low, request.least->first);
  if (request.least && !request.to) high = std::max(high, request.least->second);
  if (!request.from && !request.to) {  // no more than four digits tell two numbers apart
    const double room = 1e-3 * request.most * std::max(std::abs(low), std::abs(high)) - (high - low);
    if (room > 0 && high > low) {
      low -= room / 2;
      high += room / 2;
    }
  }
  if (!(high > low)) {  // a constant
    const double room = low == 0 ? 1 : std::abs(low) / 2;
    if (!request.to) high += room;
    if (!request.from) low -= room;
    if (!(high > low)) high = low + 1;
  }
  const double air = 0.04 * (high - low);  // between data and frame
  Ticks ticks;
  const double tiny = round_off * (high - low);
  const auto is_zero = [&](double end) { return std::abs(end) <= tiny; };
  ticks.from = request.from ? low : is_zero(low) ? 0 : low - air;
  ticks.to = request.to ? high : is_zero(high) ? 0 : high + air;
  double step = round_step((ticks.to - ticks.from) / request.most);
  const auto numbers = [&] { return std::floor(ticks.to / step + 1e-6) - std::ceil(ticks.from / step - 1e-6) + 1; };
  while (numbers() < 2) step = round_step(step / 2.5);  // one alone tells no scale
  ticks.exponent = request.plain ? 0 : exponent_of(std::max(std::abs(ticks.from), std::abs(ticks.to)));
  const double unit = std::pow(10.0, ticks.exponent);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step / unit) - 1e-9)));
  const auto last = std::lround(std::floor(ticks.to / step + 1e-6));
  for (auto i = std::lround(std::ceil(ticks.from / step - 1e-6)); i <= last; ++i) {
    const double at = std::clamp(static_cast<double>(i) * step, ticks.from, ticks.to);  // but for round-off within
    ticks.labels.emplace_back(at, i == 0 ? "0" : signed_text(fmt::format("{:.{}f}", at / unit, decimals)));
  }
  return ticks;
}

/// 1, 2 and 5 of each decade have a number where there are few decades, else 1 alone, and of many not each.
Ticks logarithmic(const TickRequest& request) {
  const double low = request.from.value_or(request.low);
  const double high = std::max(request.to.value_or(request.high), low * 1.001);
  const bool is_few = 3 * std::log10(high / low) < request.most + 1;
  const auto at_least = [&](double value) {  // the next number with a label
    return is_few ? round_step(value) : std::pow(10.0, std::ceil(std::log10(value) - 1e-12));
  };
  Ticks ticks;
  ticks.logarithmic = true;
  ticks.from = request.from ? low : 1 / at_least(1 / low);  // 1, 2, 5 are, up to a power of ten, 1/1, 1/5, 1/2
  ticks.to = request.to ? high : at_least(high);
  const int first = static_cast<int>(std::floor(std::log10(ticks.from) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(ticks.to) - 1e-9));
  const int stride = std::max(1, (last - first + request.most - 1) / request.most);
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit < 10; ++digit) {
      const double at = digit * std::pow(10.0, exponent);
      if (at < ticks.from * (1 - 1e-9) || at > ticks.to * (1 + 1e-9)) continue;
      const bool is_named = digit == 1 || (is_few && (digit == 2 || digit == 5));
      if (is_named && (exponent - first) % stride == 0) {
        ticks.labels.emplace_back(at, decade_text(digit, exponent));
      } else {
        ticks.minor.push_back(at);
      }
    }
  }
  return ticks;
}

}  // namespace

std::string scaled(const std::string& label, const Ticks& ticks, const std::string& number) {
  if (ticks.numbered) return label.empty() ? label : label + " (" + number + ")";
  if (ticks.exponent == 0) return label;
  const std::string power = power_of_ten(ticks.exponent);
  if (label.empty()) return "[" + power + "]";
  const std::size_t unit = label.rfind('[');
  if (unit == std::string::npos) return label + " [" + power + "]";
  const bool none = label.compare(unit, std::string::npos, "[–]") == 0;
  return label.substr(0, unit + 1) + power + (none ? "]" : " " + label.substr(unit + 1));
}

Ticks make_ticks(const TickRequest& request) { return request.logarithmic ? logarithmic(request) : linear(request); }

double along(const Ticks& ticks, double at) {
  return ticks.logarithmic ? std::log(at / ticks.from) / std::log(ticks.to / ticks.from)
                           : (at - ticks.from) / (ticks.to - ticks.from);
}

double value_at(const Ticks& ticks, double part) {
  return ticks.logarithmic ? ticks.from * std::pow(ticks.to / ticks.from, part)
                           : ticks.from + part * (ticks.to - ticks.from);
}

void put_at(Ticks& ticks, const std::vector<double>& places, double room) {
  const double least = room * (ticks.to - ticks.from);
  const auto near = [&](double a, double b) { return b - a < least; };
  if (places.empty() || ticks.exponent != 0) return;
  if (std::adjacent_find(places.begin(), places.end(), near) != places.end()) return;
  const std::vector<std::string> texts = column(places);
  ticks.labels.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] >= ticks.from && places[i] <= ticks.to) ticks.labels.emplace_back(places[i], signed_text(texts[i]));
  }
}

namespace {

/// A name as long as there is room for; the number that follows a colon stays whole.
std::string name_in_room(const std::string& name) {
  const std::size_t colon = name.rfind(": ");
  if (text_width(name) <= longest_name || colon == std::string::npos) return cut_to(name, longest_name);
  const std::string value = name.substr(colon);
  return cut_to(name.substr(0, colon), std::max(longest_name - text_width(value), 0.5)) + value;
}

}  // namespace

Ticks named_ticks(const std::vector<std::string>& names, bool numbered, int most) {
  Ticks ticks;
  ticks.from = -0.5;
  ticks.to = static_cast<double>(names.size()) - 0.5;
  ticks.numbered = numbered;
  const double count = static_cast<double>(names.size());
  const auto stride = numbered ? static_cast<std::size_t>(round_step(std::max(1.0, count / most))) : std::size_t{1};
  for (std::size_t i = stride - 1; i < names.size(); i += stride) {
    ticks.labels.emplace_back(static_cast<double>(i), numbered ? std::to_string(i + 1) : name_in_room(names[i]));
  }
  return ticks;
}

}  // namespace bentur
