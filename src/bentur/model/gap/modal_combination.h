#pragma once

#include <Eigen/Core>

namespace bentur {

/// How peaks of modes become one.
enum class ModalCombination {
  srss,  ///< √Σ x_n²: modes far apart
  cqc    ///< √Σ_n Σ_m ρ_nm x_n x_m: modes of any periods
};

/// The peak of a sum of modal responses from their peaks x_n, with their signs, in any unit:
///
///   x = √(Σ_n x_n²),   or   x = √(Σ_n Σ_m ρ_nm x_n x_m),                                                      (1)
///
/// ρ_nm the correlation of two oscillators of ω_n, ζ_n and ω_m, ζ_m under white noise, as ddc_correlation() has it.
/// Source: A. Der Kiureghian, A response spectrum method for random vibration analysis of MDF systems, Earthquake
/// Engineering & Structural Dynamics 9 (1981) 419-435; E. L. Wilson, A. Der Kiureghian and E. P. Bayo, A replacement
/// for the SRSS method in seismic analysis, the same 9 (1981) 187-192.
/// Invariants (each has a test): one mode gives |x|; modes far apart give SRSS; two modes of one period and ratio give
/// |x_1 + x_2|.
/// @param omega [rad/s] > 0  @param damping ζ [-] ≥ 0; all of one size
[[nodiscard]] double combined_peak(const Eigen::VectorXd& peaks, const Eigen::VectorXd& omega,
                                   const Eigen::VectorXd& damping, ModalCombination combination);

}  // namespace bentur
