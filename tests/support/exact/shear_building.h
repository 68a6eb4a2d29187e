#pragma once

#include <cmath>
#include <numbers>

// Exact solution: a uniform shear building of n storeys, mass m [mass] on every floor, stiffness k [force/length] in
// every storey, fixed base and free top. With x_i = sin(iθ) the equations of floors 1 … n−1 give ω² = (4k/m) sin²(θ/2),
// and that of the top floor, x_{n+1} = x_n, gives (2n+1) θ = (2j−1) π.

namespace bentur::exact {

/// ω_j = 2 √(k/m) sin((2j−1)π/(2(2n+1))) [rad/s], mode j = 1 … n.
inline double shear_building_omega(double stiffness, double mass, int storeys, int mode) {
  return 2 * std::sqrt(stiffness / mass) * std::sin((2 * mode - 1) * std::numbers::pi / (2 * (2 * storeys + 1)));
}

/// φ_j at floor i = 1 … n, mass-normalised [mass^-1/2]: √(4/((2n+1) m)) sin((2j−1)π i/(2n+1)).
inline double shear_building_shape(double mass, int storeys, int mode, int floor) {
  return std::sqrt(4 / ((2 * storeys + 1) * mass)) *
         std::sin((2 * mode - 1) * std::numbers::pi * floor / (2 * storeys + 1));
}

}  // namespace bentur::exact
