#include "bentur/core/physical_dimension.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bentur {
namespace {

std::string power_text(const char* unit, double power) {
  if (power == 1) return unit;
  if (power == 2 || power == 3 || power == 4) return std::string(unit) + (power == 2 ? "²" : power == 3 ? "³" : "⁴");
  return fmt::format("{}^{}", unit, power);
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
  const bool of_mass = force == 1 && time == 2;
  std::string above, below;
  const auto add = [&](const char* unit, double power) {
    if (power == 0) return;
    std::string& side = power > 0 ? above : below;
    side += (side.empty() ? "" : "·") + power_text(unit, std::abs(power));
  };
  if (of_mass) add("mass", 1);
  if (!of_mass) add("force", force);
  add("length", of_mass ? length + 1 : length);
  if (!of_mass) add("s", time);
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace bentur
