#include "bentur/core/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr double standard_gravity_si = 9.80665;  // [m/s²], CGPM 1901

// Metres in one unit; inch and foot are exact since 1959.
const std::vector<std::pair<std::string, double>>& lengths() {
  static const std::vector<std::pair<std::string, double>> table = {
      {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}};
  return table;
}

// Newtons in one unit; the pound is 0.45359237 kg, by the same agreement.
const std::vector<std::pair<std::string, double>>& forces() {
  static const std::vector<std::pair<std::string, double>> table = {{"N", 1.0},
                                                                    {"kN", 1e3},
                                                                    {"MN", 1e6},
                                                                    {"kgf", standard_gravity_si},
                                                                    {"tf", 1e3 * standard_gravity_si},
                                                                    {"lbf", 0.45359237 * standard_gravity_si},
                                                                    {"kip", 453.59237 * standard_gravity_si}};
  return table;
}

}  // namespace

const std::vector<std::string>& length_units() {
  static const std::vector<std::string> names = {"m", "cm", "mm", "in", "ft"};
  return names;
}

const std::vector<std::string>& force_units() {
  static const std::vector<std::string> names = {"N", "kN", "MN", "kgf", "tf", "lbf", "kip"};
  return names;
}

const std::vector<std::string>& acceleration_units() {
  static const std::vector<std::string> names = {"g", "m/s2", "cm/s2", "mm/s2", "in/s2", "ft/s2"};
  return names;
}

double metres(const std::string& length_unit) {
  for (const auto& [name, value] : lengths()) {
    if (name == length_unit) return value;
  }
  throw InvalidParameter("length unit", length_unit, fmt::format("must be one of {}", fmt::join(length_units(), " ")));
}

double newtons(const std::string& force_unit) {
  for (const auto& [name, value] : forces()) {
    if (name == force_unit) return value;
  }
  throw InvalidParameter("force unit", force_unit, fmt::format("must be one of {}", fmt::join(force_units(), " ")));
}

double standard_gravity(const std::string& length_unit) { return standard_gravity_si / metres(length_unit); }

double acceleration_factor(const std::string& acceleration_unit, const Units& units) {
  if (acceleration_unit == "g") return units.gravity;
  for (const auto& [name, value] : lengths()) {
    if (acceleration_unit == name + "/s2") return value / metres(units.length);
  }
  throw InvalidParameter("acceleration unit", acceleration_unit,
                         fmt::format("must be one of {}", fmt::join(acceleration_units(), " ")));
}

ShownUnits shown_units(const Units& units, double largest_force) {
  constexpr double most_newtons = 1e4;
  ShownUnits shown{.units = units};
  if (units.force == "N" && largest_force >= most_newtons) {
    shown.units.force = "kN";
    shown.force = newtons("N") / newtons("kN");
  }
  return shown;
}

}  // namespace bentur
