#pragma once

#include <vector>

namespace bentur {

struct IntensityCount;

/// The probability of collapse at an intensity by logistic regression of whether each run collapses,
///
///   P_C(x) = 1/(1 + e^{−(α₀ + α₁ ln x)}),                                                                  (1)
///
/// α₀, α₁ [-] of the largest likelihood Σ c ln P_C + (n − c) ln(1 − P_C), which exists where neither all runs that
/// collapse nor all that stand are on one side of some intensity.
/// Sources: (1) [JalayerEbrahimianMianoManfrediSezen2017, doi 10.1002/eqe.2922]; where the maximum exists
/// [AlbertAnderson1984, doi 10.1093/biomet/71.1.1].
struct CollapseFit {
  enum class Kind {
    none,       ///< no run collapses: P_C = 0
    all,        ///< every run does: P_C = 1
    fitted,     ///< α₁ > 0
    separated,  ///< all that collapse are above some intensity and all that stand below, or all that collapse below
    falling     ///< α₁ is not > 0, or there is one intensity alone: (1) does not describe the data
  };
  Kind kind = Kind::none;
  double intercept = 0, slope = 0;  ///< α₀ of ln x in the unit of x, α₁; NaN unless fitted
  double lower = 0, upper = 0;      ///< the largest intensity of a run that stands, the smallest of one that collapses
  long runs = 0, collapsed = 0;

  [[nodiscard]] bool is_known() const { return kind == Kind::none || kind == Kind::all || kind == Kind::fitted; }
  /// (1); NaN unless it is known. @param intensity x > 0
  [[nodiscard]] double probability(double intensity) const;
  /// The intensity at which (1) is p, 0 < p < 1: e^{(ln(p/(1 − p)) − α₀)/α₁}; of a fitted one.
  [[nodiscard]] double intensity_of(double p) const;
};

/// By Newton's method with step halving in standardised ln x, where the likelihood is strictly concave.
/// Invariances: intensities times c leave α₁ and add −α₁ ln c to α₀; every count times the same number changes nothing.
/// @param counts runs and, as events, collapses at each intensity, in any order
/// @throws InvalidParameter unless x > 0 finite and 0 ≤ c ≤ n
[[nodiscard]] CollapseFit fit_collapse(const std::vector<IntensityCount>& counts);

}  // namespace bentur
