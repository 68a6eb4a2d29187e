#pragma once

namespace bentur {

/// Peak displacement, first period and damping ratio of one building at a contact level.
struct SeparationInput {
  double displacement = 0;   ///< u [length]
  double period = 0;         ///< T₁ [s]
  double damping_ratio = 0;  ///< ζ₁ [-]
};

/// u_A + u_B: the absolute sum; two free responses never need more.
[[nodiscard]] double separation_abs(const SeparationInput& a, const SeparationInput& b);
/// √(u_A² + u_B²).
[[nodiscard]] double separation_srss(const SeparationInput& a, const SeparationInput& b);
/// Double-difference combination √(u_A² + u_B² − 2ρ u_A u_B) (Jeng, Kasai & Maison 1992).
[[nodiscard]] double separation_ddc(const SeparationInput& a, const SeparationInput& b);
/// ρ [-] of the double-difference combination, r = T_B/T_A. Two undamped buildings of one period give 1.
[[nodiscard]] double ddc_correlation(const SeparationInput& a, const SeparationInput& b);

}  // namespace bentur
