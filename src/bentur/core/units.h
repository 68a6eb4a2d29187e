#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bentur {

/// The consistent units of a case. Mass is force·s²/length and time is seconds; no equation depends on the choice.
struct Units {
  std::string length = "m";  ///< m cm mm in ft
  std::string force = "N";   ///< N kN MN kgf tf lbf kip
  double gravity = 9.80665;  ///< [length/s²]
};

[[nodiscard]] const std::vector<std::string>& length_units();
[[nodiscard]] const std::vector<std::string>& force_units();
[[nodiscard]] const std::vector<std::string>& acceleration_units();  ///< g m/s2 cm/s2 mm/s2 in/s2 ft/s2

/// Metres in one unit of length. @throws InvalidParameter for an unknown unit.
[[nodiscard]] double metres(const std::string& length_unit);

/// Newtons in one unit of force. @throws InvalidParameter for an unknown unit.
[[nodiscard]] double newtons(const std::string& force_unit);

/// Standard gravity 9.80665 m/s² in length/s². @throws InvalidParameter for an unknown unit.
[[nodiscard]] double standard_gravity(const std::string& length_unit);

/// What a number in `acceleration_unit` is to be multiplied by to stand in the case's length/s²;
/// "g" is the case's own gravity. @throws InvalidParameter for an unknown unit.
[[nodiscard]] double acceleration_factor(const std::string& acceleration_unit, const Units& units);

/// The units in which people read of a run or a study: newtons become kN where its largest force is 10⁴ N or more,
/// so that all of its forces read alike. Files keep the units of the case.
struct ShownUnits {
  Units units;
  double force = 1;  ///< what forces are multiplied by
  /// What a value of this form of units ("F L") is multiplied by.
  [[nodiscard]] double factor(std::string_view form) const { return form.find('F') == form.npos ? 1.0 : force; }
};
[[nodiscard]] ShownUnits shown_units(const Units& units, double largest_force);

}  // namespace bentur
