#pragma once

namespace bentur {

/// Coefficient of restitution e [-] of a free impact of two bodies, and the law's parameter that gives it. None of
/// these relations depends on masses, stiffness or closing speed. Derivations: docs/theory/contact.md.
///
/// The restitution that a parameter gives falls from 1 (no damping) towards 0. Each inverse is exact to round-off.
/// @throws InvalidParameter for a parameter that is negative or not finite, and by each inverse ("restitution") unless
///   1e-150 ≤ e ≤ 1, so that every number on the way there is finite.

/// F ∝ δⁿ (1 + d δ̇/v₀), any n:  d (1 + e) = ln[(1 + d)/(1 − d e)]. d [-] damping factor ≥ 0.                    (C-6)
[[nodiscard]] double damping_factor_restitution(double damping_factor);
[[nodiscard]] double exact_damping_factor(double restitution);

/// F = κ δⁿ + 2 ξ √(κ δⁿ⁻¹ m_e) δ̇ while closing, κ δⁿ after:  e = exp(−z A(z)), z = ξ √(2/(n+1)).               (C-9)
///   A(z) = arccos z/√(1 − z²) for z < 1,  1 for z = 1,  arcosh z/√(z² − 1) for z > 1.                         (C-10)
[[nodiscard]] double approach_restitution(double damping_ratio, double exponent);
[[nodiscard]] double exact_approach_damping_ratio(double restitution, double exponent);

/// F = k δ + 2 ξ √(k m_e) δ̇ until F = 0:  e = exp(−2 ξ A(ξ)), the monograph's (3.11) for ξ < 1.                 (C-13)
[[nodiscard]] double zero_force_restitution(double damping_ratio);
[[nodiscard]] double exact_zero_force_damping_ratio(double restitution);

/// The same until δ = 0:  e = exp(−π ξ/√(1 − ξ²)),  ξ = −ln e/√(π² + ln² e). Needs ξ < 1: with more damping two free
/// bodies never come apart.                                                                                    (C-15)
[[nodiscard]] double separation_restitution(double damping_ratio);
[[nodiscard]] double exact_separation_damping_ratio(double restitution);

/// Formulas of the literature, as printed; each misses the restitution it is given, by what docs/theory/contact.md
/// lists.
namespace published {

/// ξ = −ln e/√(π² + ln² e)  [Anagnostopoulos1988]; exact where the dashpot may pull (C-15).                     (C-16)
[[nodiscard]] double anagnostopoulos_damping_ratio(double restitution);
/// ξ = (1 − e²)/(e (e (π − 2) + 2))  [MahmoudJankowski2011], for force ∝ δ.                                    (C-17)
[[nodiscard]] double mahmoud_jankowski_damping_ratio(double restitution);
/// ξ = (9√5/2) (1 − e²)/(e (e (9π − 16) + 16))  [Jankowski2006], for force ∝ δ^1.5.                            (C-18)
[[nodiscard]] double jankowski_damping_ratio(double restitution);
/// d = ¾ (1 − e²)  [LankaraniNikravesh1990], [MuthukumarDesRoches2006].                                        (C-19)
[[nodiscard]] double muthukumar_desroches_damping_factor(double restitution);
/// d = 8 (1 − e)/(5 e)  [YeLiZhu2009].                                                                         (C-20)
[[nodiscard]] double ye_damping_factor(double restitution);

}  // namespace published
}  // namespace bentur
