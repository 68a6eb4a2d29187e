#pragma once

#include <vector>

#include "bentur/study/fragility/fragility.h"
#include "bentur/study/risk/hazard.h"

namespace bentur {

/// Mean annual frequency of an event: the hazard λ(x) times its fragility P(x),
///
///   λ_E = ∫ P(x) |dλ(x)|.                                                                                  (1)
///
/// With P = Φ(z), z = ln(x/θ)/β, a segment [a, b] of a HazardCurve, on which λ = λ_a (x/a)⁻ᵏ, gives exactly
///
///   [−λ Φ(z)]ₐᵇ + λ_a (a/θ)ᵏ e^{k²β²/2} [Φ(z + kβ)]ₐᵇ,                                                     (2)
///
/// and with P straight in ln x, P = p + q ln x,
///
///   [−λ P]ₐᵇ + (q/k) (λ_a − λ_b).                                                                          (3)
///
/// One segment from 0 to ∞ gives the closed form λ_E = λ(θ) e^{k²β²/2}.                                    (4)
///
/// Where runs collapse apart, P = Φ(z) + P_C (1 − Φ(z)), (4) of Fragility, its second part is integrated over pieces of
/// ln x no wider than half of β and of 1/α₁, by fifteen points of Gauss and Legendre.
///
/// Beyond the last number of the hazard nothing is known but that it is exceeded λ_n a year: all of it counts as the
/// event, the safe side. Below the first nothing is counted.
/// Sources: (1), (4) [CornellJalayerHamburgerFoutch2002, doi 10.1061/(ASCE)0733-9445(2002)128:4(526)].
struct AnnualRate {
  double rate = 0;    ///< λ_E [1/year], `beyond` in it, `below` not
  double beyond = 0;  ///< of it what counts as the event because nothing is known: beyond the last number [1/year]
  double below = 0;   ///< what the first segment would add if it went on to x = 0 [1/year]; ∞ where that has no end
  std::vector<double> parts;  ///< of each segment, and last of what is beyond [1/year]; their sum is `rate`
};

/// Of a lognormal P; β = 0: a step at θ. @throws InvalidParameter unless 0 < θ < ∞ and β ≥ 0.
[[nodiscard]] AnnualRate annual_rate(const HazardCurve& hazard, double median, double dispersion);

/// Of a lognormal of the runs that stand, and collapse apart. @throws InvalidParameter unless 0 < θ < ∞, β > 0 and the
/// collapse is fitted.
[[nodiscard]] AnnualRate annual_rate(const HazardCurve& hazard, double median, double dispersion,
                                     const CollapseFit& collapse);

/// What was observed at a level.
struct ObservedShare {
  double intensity = 0;    ///< x [unit] > 0
  double probability = 0;  ///< share of the runs with the event [-]
};
/// Of observed shares, straight in ln x between their levels. Below the lowest level P goes straight in x to 0 at x =
/// 0; above the highest, where nothing was run, all counts as the event, and is `beyond` but for the share there.
/// @throws InvalidParameter unless the levels ascend, and there is one.
[[nodiscard]] AnnualRate annual_rate(const HazardCurve& hazard, const std::vector<ObservedShare>& shares);

/// Of runs that each have an intensity of their own, as those of a cloud: the shares that do not fall with intensity
/// and have the largest likelihood. Where fewer runs have the event than at the intensities before, they are pooled
/// with these until none do. Source: [AyerBrunkEwingReidSilverman1955, doi 10.1214/aoms/1177728423].
[[nodiscard]] std::vector<ObservedShare> rising_shares(const std::vector<IntensityCount>& counts);

/// (4) with the slope of the hazard at θ.
[[nodiscard]] double closed_form_rate(const HazardCurve& hazard, double median, double dispersion);

/// The probability of one event or more in t years, of a Poisson process: 1 − e^{−λ t}, and its inverse.
[[nodiscard]] double probability_in(double years, double rate);
[[nodiscard]] double rate_of_probability(double years, double probability);

}  // namespace bentur
