#include "bentur/core/physical_dimension.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bentur {
namespace {

std::string power_text(const std::string& unit, double power) {
  if (power == 1) return unit;
  if (power == 2 || power == 3 || power == 4) return unit + (power == 2 ? "²" : power == 3 ? "³" : "⁴");
  return fmt::format("{}^{}", unit, power);
}

/// "a·b²/c" of units and their powers.
std::string fraction(const std::vector<std::pair<std::string, double>>& units) {
  std::string above, below;
  for (const auto& [unit, power] : units) {
    if (power == 0) continue;
    std::string& side = power > 0 ? above : below;
    side += (side.empty() ? "" : "·") + power_text(unit, std::abs(power));
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace

double PhysicalDimension::factor(double lengths, double forces) const {
  return (length == 0 ? 1 : std::pow(lengths, length)) * (force == 0 ? 1 : std::pow(forces, force));
}

std::string PhysicalDimension::form() const {
  if (length != std::floor(length)) return "";
  std::string words;
  const auto add = [&](char unit, int power) {
    if (power == 0) return;
    words += (words.empty() ? "" : " ") + std::string(1, unit) + (power == 1 ? "" : std::to_string(power));
  };
  add('F', force);
  add('s', std::max(time, 0));
  add('L', static_cast<int>(length));
  add('s', std::min(time, 0));
  return words.empty() ? "1" : words;
}

std::string PhysicalDimension::text() const {
  if (force != 1 || time != 2) return text("length", "force");
  return fraction({{"mass", 1}, {"length", length + 1}});
}

std::string PhysicalDimension::text(const std::string& of_length, const std::string& of_force) const {
  return fraction({{of_force, force}, {of_length, length}, {"s", time}});
}

}  // namespace bentur
