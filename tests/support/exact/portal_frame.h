#pragma once

namespace bentur::exact {

/// Lateral stiffness [force/length] of a portal frame of one storey and one bay, fixed at the base, axially rigid:
///   k = (24 E I_c/h³) (1 + 6κ)/(4 + 6κ),   κ = (I_b/L)/(I_c/h).
/// From the joint's balance under sway Δ, both joints turning by θ: (4 E I_c/h + 6 E I_b/L) θ = 6 E I_c Δ/h²; limits
/// 2·3 E I_c/h³ for a beam without stiffness and 2·12 E I_c/h³ for a rigid one. The same as A. K. Chopra, Dynamics of
/// Structures, section 1.3, whose ρ = I_b/(4 I_c) for L = 2h is κ/2.
/// E [force/length²], I_c, I_b [length⁴], h storey height, L bay width [length].
inline double portal_stiffness(double e, double column_inertia, double beam_inertia, double h, double l) {
  const double kappa = (beam_inertia / l) / (column_inertia / h);
  return 24 * e * column_inertia / (h * h * h) * (1 + 6 * kappa) / (4 + 6 * kappa);
}

}  // namespace bentur::exact
