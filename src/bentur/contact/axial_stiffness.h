#pragma once

namespace bentur {

/// Axial stiffness of half the floor beam next to a gap, K = E A/(L/2) [force/length] (3-4).
/// E [force/length²], A [length²], L [length] the bay next to the gap; all > 0.
[[nodiscard]] double half_beam_stiffness(double elastic_modulus, double area, double bay_width);

/// Two half beams in series: 1/K_b = 1/K₁ + 1/K₂ (3-4).
[[nodiscard]] double series_stiffness(double first, double second);

}  // namespace bentur
