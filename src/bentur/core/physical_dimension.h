#pragma once

#include <string>

namespace bentur {

/// What a number is, by exponents of the units that a case chooses: it stands for length^a force^b s^c. Mass is
/// force·s²/length. There is no dimension that nobody has named: none is one, `dimension::none`.
struct PhysicalDimension {
  constexpr PhysicalDimension(double of_length, int of_force, int of_time)
      : length(of_length), force(of_force), time(of_time) {}

  double length;  ///< [-]; 1.5 occurs
  int force, time;

  friend bool operator==(const PhysicalDimension&, const PhysicalDimension&) = default;

  /// What a number is to be multiplied by where a unit of length is `lengths` new ones and one of force `forces`.
  [[nodiscard]] double factor(double lengths, double forces) const;
  /// "F s2 L-1", as quantities have it; "1" of none; empty where UDUNITS has no such power.
  [[nodiscard]] std::string form() const;
  /// "force·s/length", or with mass "mass/length³"; empty of none.
  [[nodiscard]] std::string text() const;
  /// The same in units, "kN·s/m"; mass is kN·s²/m there.
  [[nodiscard]] std::string text(const std::string& of_length, const std::string& of_force) const;
};

namespace dimension {
inline constexpr PhysicalDimension none{0, 0, 0};
inline constexpr PhysicalDimension length{1, 0, 0};
inline constexpr PhysicalDimension area{2, 0, 0};
inline constexpr PhysicalDimension second_moment{4, 0, 0};
inline constexpr PhysicalDimension time{0, 0, 1};
inline constexpr PhysicalDimension velocity{1, 0, -1};
inline constexpr PhysicalDimension slowness{-1, 0, 1};
inline constexpr PhysicalDimension acceleration{1, 0, -2};
inline constexpr PhysicalDimension force{0, 1, 0};
inline constexpr PhysicalDimension moment{1, 1, 0};
inline constexpr PhysicalDimension pressure{-2, 1, 0};
inline constexpr PhysicalDimension unit_weight{-3, 1, 0};
inline constexpr PhysicalDimension stiffness{-1, 1, 0};
inline constexpr PhysicalDimension hertz_stiffness{-1.5, 1, 0};
inline constexpr PhysicalDimension dashpot{-1, 1, 1};
inline constexpr PhysicalDimension rocking_dashpot{1, 1, 1};
inline constexpr PhysicalDimension mass{-1, 1, 2};
inline constexpr PhysicalDimension density{-4, 1, 2};
inline constexpr PhysicalDimension mass_inertia{1, 1, 2};
}  // namespace dimension

}  // namespace bentur
