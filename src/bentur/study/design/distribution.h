#pragma once

#include <limits>

namespace bentur {

/// Φ(z) and Φ⁻¹(p), 0 < p < 1, of the standard normal distribution.
[[nodiscard]] double normal_probability(double z);
/// ln Φ(z), also where Φ is no number of the machine any more.
[[nodiscard]] double log_normal_probability(double z);
[[nodiscard]] double normal_quantile(double p);

/// How a quantity x of a study is distributed, in that quantity's own units. A normal or lognormal distribution may be
/// cut off at `low` and `high`; what remains is scaled up to one.
///   uniform      x = low + (high − low) u,
///   log_uniform  ln x = ln low + (ln high − ln low) u,   0 < low,
///   normal       x = μ + σ Φ⁻¹(u),
///   lognormal    ln x = ln μ + σ Φ⁻¹(u),   μ the median, σ² = ln(1 + cov²).
/// Symbols: u [-] probability in (0, 1); Φ standard normal distribution function.
struct Distribution {
  enum class Kind { uniform, log_uniform, normal, lognormal };

  Kind kind = Kind::uniform;
  double centre = 0;  ///< μ: mean of a normal, median of a lognormal distribution
  double spread = 0;  ///< σ > 0: of x (normal), of ln x (lognormal) [-]
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  /// x with probability u of not being exceeded; always within [low, high] and within the support.
  [[nodiscard]] double quantile(double u) const;
  /// How far [low, high] lies from the centre of a normal or lognormal distribution, in σ; 0 where it holds the centre.
  /// Beyond `farthest` no probability is left that a double could hold.
  [[nodiscard]] double deviations_off() const;
  static constexpr double farthest = 35;  ///< [-]
};

/// σ of ln x of a lognormal distribution whose x has coefficient of variation `cov` [-] > 0.
[[nodiscard]] double lognormal_spread(double cov);

/// The ends of a distribution's support, in the units of its quantity. Where it is unbounded, a value so far out that
/// any key with a limit on that side refuses it: below zero, above one.
struct Extremes {
  double low = 0, high = 0;
};
[[nodiscard]] Extremes extremes(const Distribution& distribution);

}  // namespace bentur
