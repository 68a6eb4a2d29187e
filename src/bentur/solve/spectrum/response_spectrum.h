#pragma once

#include <vector>

#include "bentur/excitation/ground_motion.h"

namespace bentur {

/// Peaks of a linear oscillator under a record:
///
///   ẍ + 2ζω ẋ + ω² x = −a_g(t),   ω = 2π/T,   x(0) = ẋ(0) = 0,                                             (1)
///   S_d = max |x|,   S_v = ω S_d,   S_a = ω² S_d,   A = max |ẍ + a_g| = max |2ζω ẋ + ω² x|.               (2)
///
/// T [s] period, ζ [-] damping ratio, a_g [length/s²] linear between samples and zero after the last.
/// The maxima are over all t ≥ 0, the free vibration after the record included.
struct OscillatorPeaks {
  double displacement = 0;           ///< S_d [length]
  double pseudo_velocity = 0;        ///< S_v [length/s]
  double pseudo_acceleration = 0;    ///< S_a [length/s²], the Sa(T, ζ) of an incremental dynamic analysis
  double absolute_acceleration = 0;  ///< A [length/s²]; equals S_a where ζ = 0
};

/// No time stepping error: from sample to sample the solution of (1) is a fixed linear map of the state and the two
/// samples, and a maximum is an extremum of the continuous solution, not its largest sample. Round-off alone remains.
/// Limits: T → 0 gives A = S_a = peak ground acceleration; T → ∞ gives S_d = peak ground displacement.
/// @throws InvalidParameter unless 0 ≤ ζ < 1, T is finite and at least a thousandth of the record's step, and the
///   record has a sample, a step > 0 and finite values.
[[nodiscard]] OscillatorPeaks oscillator_peaks(const SampledMotion& motion, double period, double damping_ratio);

/// One entry per period.
[[nodiscard]] std::vector<OscillatorPeaks> response_spectrum(const SampledMotion& motion,
                                                             const std::vector<double>& periods, double damping_ratio);

/// S_a of each period at the samples and after the last one alone, in a fifth of the time: short of that of
/// response_spectrum() by (ω h)²/8 of A and the largest |a_g| together at most, for samples h apart.
/// @throws InvalidParameter as oscillator_peaks()
[[nodiscard]] std::vector<double> pseudo_accelerations_at_samples(const SampledMotion& motion,
                                                                  const std::vector<double>& periods,
                                                                  double damping_ratio);

/// S_a of two components together: ω² max |(x, y)| [length/s²], over all t ≥ 0 and so over all directions, x and y each
/// as (1) has it. The shorter record is zero after its end. Below the largest by less than 3·10⁻⁴ of it, as the path is
/// looked at every 0.05 rad of the oscillator.
/// @throws InvalidParameter as oscillator_peaks(), and unless both have the same step.
[[nodiscard]] double maximum_direction(const SampledMotion& x, const SampledMotion& y, double period,
                                       double damping_ratio);

/// `count` periods from `first` to `last` [s], evenly spaced on a logarithmic scale, both ends exact.
/// @throws InvalidParameter unless 0 < first < last and count ≥ 2, or first = last and count = 1.
[[nodiscard]] std::vector<double> logarithmic_periods(double first, double last, int count);

}  // namespace bentur
