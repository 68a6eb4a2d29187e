#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "bentur/study/fragility/collapse_fit.h"

namespace bentur {

/// Lognormal fragility: the probability of an event (pounding, a force exceeded) at an intensity,
///
///   P(event | x) = Φ(ln(x/θ)/β),                                                                          (1)
///
/// fitted by maximum likelihood to k_i events in n_i runs at intensities x_i,
///
///   ln L(θ, β) = Σ k_i ln P(x_i) + (n_i − k_i) ln(1 − P(x_i)).                                             (2)
///
/// x, θ [the intensity's unit] > 0, θ the median intensity of the event; β [-] > 0 its logarithmic dispersion; Φ the
/// normal distribution. Binomial coefficients, which do not depend on θ and β, are left out of (2).
/// Source: (1), (2) [Baker2015, doi 10.1193/021113EQS025M].
/// Where runs collapse apart from the event, as those of a cloud, (1) is of the runs that stand, and of all
///
///   P(event | x) = P_C(x) + (1 − P_C(x)) Φ(ln(x/θ)/β).                                                    (4)
///
/// Source: (4) [JalayerEbrahimianMianoManfrediSezen2017, doi 10.1002/eqe.2922].
struct IntensityCount {
  double intensity = 0;  ///< x [any unit] > 0
  long runs = 0;         ///< n ≥ 0
  long events = 0;       ///< k, 0 ≤ k ≤ n
};

struct Fragility {
  enum class Kind {
    fitted,         ///< the maximum of (2) exists: θ > 0, β > 0
    separated,      ///< no event below and only events above some intensity: β → 0, θ anywhere between; see `lower`
    no_event,       ///< θ is beyond every intensity: θ = ∞
    all_events,     ///< θ is below every intensity: θ = 0
    one_intensity,  ///< events and none at the only intensity: P there is known, θ and β are not
    falling,        ///< events do not become likelier with intensity: (1) does not describe the data
    no_data
  };
  Kind kind = Kind::no_data;
  double median = 0;          ///< θ; between `lower` and `upper` where separated (geometric mean); NaN where unknown
  double dispersion = 0;      ///< β; 0 unless fitted; NaN where unknown
  double log_likelihood = 0;  ///< largest ln L, (2); 0 for separated data but for runs at the very intensity θ
  /// The largest intensity without and the smallest with an event: θ is between them where separated; lower is 0 where
  /// all runs were events, upper is ∞ where none was.
  double lower = 0, upper = 0;
  std::optional<CollapseFit> collapse = {};  ///< P_C of (4), where runs collapse apart; its θ and β are of the others

  /// P(event | intensity) of (1) or (4); a step at θ where separated. NaN where θ or P_C is unknown.
  [[nodiscard]] double probability(double intensity) const;
  /// The intensity at which the probability is p, 0 < p < 1: θ e^{β Φ⁻¹(p)}; of (4) found by halving, NaN as above.
  [[nodiscard]] double intensity_of(double p) const;
};

/// The maximum of (2). In a = −(ln θ)/β, b = 1/β (2) is strictly concave unless data are separated, so that Newton's
/// method with step halving finds the only maximum from anywhere; it ends when a step gains no more than round-off.
/// Φ and its ratio to its density are computed without cancellation however small they are.
/// Data are sorted and joined first: their order and how runs of one intensity are divided up do not matter.
/// Invariances: intensities times c give θ times c, β unchanged; every n and k times the same number give the same fit.
/// @throws InvalidParameter unless x > 0 finite and 0 ≤ k ≤ n.
[[nodiscard]] Fragility fit_fragility(const std::vector<IntensityCount>& counts);

/// ln L of (2) for given θ > 0, β > 0.
[[nodiscard]] double log_likelihood(const std::vector<IntensityCount>& counts, double median, double dispersion);

/// How far a fit is from what was observed: the largest |k_i/n_i − P(x_i)| over the intensities, the distance of
/// Kolmogorov and Smirnov [-]. Nothing unless θ and β are known.
[[nodiscard]] std::optional<double> fit_distance(const std::vector<IntensityCount>& counts, const Fragility& fit);

/// How far a lognormal whose two numbers are found from the same `runs` > 0 strays from what is observed of them, in 19
/// of 20 samples that it does describe, at most [-]:
///
///   D = 0.895 / (√n − 0.01 + 0.85/√n)                                                                      (3)
///
/// Source: [Stephens1974] table 1A, case 3, 5 %, for distances at all intensities: at the levels alone they are
/// smaller.
[[nodiscard]] double fit_distance_limit(long runs);

/// Whether θ and β are known, and at some intensity the part of the runs with the event is farther from the curve than
/// (3) of the runs there: then a lognormal does not describe them.
[[nodiscard]] bool is_misfit(const std::vector<IntensityCount>& counts, const Fragility& fit);

/// Whether θ is known and beyond the intensities of which there are runs: then the curve there is extrapolated.
[[nodiscard]] bool is_extrapolated(const std::vector<IntensityCount>& counts, const Fragility& fit);

struct Interval {
  double lower = 0, upper = 0;
};

/// The middle part of `values` that holds `confidence` of them, as many left out at either end; NaN without values.
[[nodiscard]] Interval percentile_interval(std::vector<double> values, double confidence);

/// Bounds of a fit from resampled data.
struct FragilityBounds {
  Interval median, dispersion;
  int usable = 0;  ///< resamples that gave θ and β; a separated one gives β = 0, no event θ = ∞, only events θ = 0
  std::vector<Fragility> fits;  ///< one per resample, in order
  double confidence = 0;        ///< of the intervals, as asked
};

struct BootstrapOptions {
  int resamples = 1000;
  double confidence = 0.95;  ///< of the interval between equal tails, in (0, 1)
  std::uint64_t seed = 1;
};

/// Bootstrap percentile bounds [EfronTibshirani1993]. What was observed together is resampled together: one entry of
/// `units` holds all runs of one record (of an incremental dynamic analysis), or one run (of a cloud). As many units as
/// there are are drawn with replacement and fitted, `resamples` times. The same seed gives the same bounds on every
/// machine. @throws InvalidParameter when there is no unit, or an option is out of range.
[[nodiscard]] FragilityBounds bootstrap_fragility(const std::vector<std::vector<IntensityCount>>& units,
                                                  const BootstrapOptions& options = {});
/// The same of any fit to what units hold. @param fit of the units whose numbers are drawn, some more than once
[[nodiscard]] FragilityBounds bootstrap_fragility(std::size_t units, const BootstrapOptions& options,
                                                  const std::function<Fragility(std::span<const std::size_t>)>& fit);

/// The gap for which P(pounding | intensity) ≤ p.
struct GapForProbability {
  enum class Kind {
    between,   ///< between two of the widths
    smallest,  ///< the smallest width already has P ≤ p: less may do
    beyond     ///< the largest width has P > p: more is needed
  };
  Kind kind = Kind::beyond;
  double width = 0;  ///< [length]; the largest width where beyond
};

/// The smallest gap from which on P(w) ≤ p at all `widths` [length], ascending, with `probabilities` P of pounding at
/// one intensity. Between the last width with P > p and the next, Φ⁻¹(P) is taken as linear in the width; where one of
/// the two probabilities is 0 or 1 there is nothing to interpolate and the wider gap is the answer, the safe side.
/// @throws InvalidParameter unless widths ascend, every P is in [0, 1], sizes agree, and 0 < p < 1.
[[nodiscard]] GapForProbability gap_for_probability(const std::vector<double>& widths,
                                                    const std::vector<double>& probabilities, double p);

}  // namespace bentur
