#pragma once

#include <optional>
#include <vector>

#include "bentur/study/fragility/fragility.h"

namespace bentur {

/// What a run demands at an intensity.
struct RunDemand {
  double intensity = 0;    ///< x [any unit] > 0
  double value = 0;        ///< d [the event's unit] ≥ 0; of a run that collapses of no account
  bool collapsed = false;  ///< or whose numbers failed: beyond any threshold
};

/// A cloud: demands of runs that stand, lognormal about a power of the intensity,
///
///   ln d = a + b ln x + ε,   ε normal with standard deviation σ,                                          (1)
///
/// by least squares, σ² = Σ ε²/(n − 2). The probability that a demand exceeds d is then lognormal in x,
///
///   θ = e^{(ln d − a)/b},   β = σ/b.                                                                       (2)
///
/// Source: (1), (2) [CornellJalayerHamburgerFoutch2002, doi 10.1061/(ASCE)0733-9445(2002)128:4(526)].
struct CloudFit {
  double a = 0, b = 0, sigma = 0;  ///< [-]
  double determination = 0;        ///< R², share of the variance of ln d that (1) explains [-]
  double distance = 0;             ///< KS: the largest of the shares of ε/σ from the normal distribution [-]
  long runs = 0;                   ///< that stand and have a demand
};
/// Nothing from fewer than three runs with a demand > 0, or of one intensity alone.
[[nodiscard]] std::optional<CloudFit> fit_cloud(const std::vector<RunDemand>& demands);
/// (2); kind `falling` where b is not > 0, `separated` where σ is 0.
/// @param threshold d [the event's unit] > 0
[[nodiscard]] Fragility cloud_fragility(const CloudFit& cloud, double threshold);

/// A stripe: all runs of one intensity, those that stand with lognormal demands,
///
///   P(demand > d | x) = p_c + (1 − p_c) Φ(ln(η/d)/β_d),                                                    (3)
///
/// p_c the share that collapses, η the median and β_d the standard deviation (n − 1) of ln d of the others.
/// Source: (3) [JalayerCornell2009, doi 10.1002/eqe.876].
struct Stripe {
  double intensity = 0;
  long runs = 0, collapsed = 0;
  double median = 0, dispersion = 0;  ///< η, β_d; NaN where no run stands, β_d 0 of one alone
  double share = 1;                   ///< of the runs that stand: those with a demand > 0 [-]

  [[nodiscard]] double probability(double threshold) const;  ///< (3)
};
/// Ascending. A demand of 0 counts as below any threshold: the lognormal is of the others, and takes their share.
[[nodiscard]] std::vector<Stripe> stripes_of(const std::vector<RunDemand>& demands);
/// The lognormal fragility of largest likelihood to the probabilities of all stripes, each as heavy as its runs.
[[nodiscard]] Fragility stripe_fragility(const std::vector<Stripe>& stripes, double threshold);

}  // namespace bentur
