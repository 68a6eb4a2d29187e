#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/study/fragility/demand_fits.h"
#include "bentur/study/fragility/fragility.h"

namespace bentur {

/// How a run of an incremental dynamic analysis came out.
/// A run that collapses, or whose numbers fail, has the event; `failed` is one whose values make no case.
enum class Outcome : signed char { no_event = 0, event = 1, failed = 2 };

/// Outcomes of all runs. A case is what is neither record nor level: a gap width, say. A cloud, whose records are not
/// scaled, has one level in place of all, and each record has an intensity of its own.
struct OutcomeTable {
  std::vector<double> levels;  ///< of intensity [its unit] > 0; of a cloud one, NaN
  std::size_t cases = 0, records = 0;
  std::vector<Outcome> outcomes;  ///< cases × records × levels, the last fastest
  std::size_t together = 1;  ///< so many records in succession are one, applied in both directions: resampled together
  /// Of each run, in the order of the outcomes, where they are known: the event's quantity, the largest of all places,
  /// and whether the run collapses or its numbers failed. Empty: not known.
  std::vector<double> demands = {};
  std::vector<char> collapsed = {};
  /// The threshold that a demand has to exceed; nothing where the event is another one.
  std::optional<double> threshold = {};
  /// Of a cloud, the intensity of each record [its unit] > 0; NaN: it makes no case.
  std::vector<double> own = {};

  [[nodiscard]] bool is_cloud() const { return !own.empty(); }
  [[nodiscard]] double intensity(std::size_t record, std::size_t level) const {
    return is_cloud() ? own[record] : levels[level];
  }
  [[nodiscard]] std::vector<double> intensities() const;  ///< of all runs, each once, ascending
  [[nodiscard]] Outcome at(std::size_t c, std::size_t record, std::size_t level) const {
    return outcomes[(c * records + record) * levels.size() + level];
  }
};

/// By what θ and β are found.
enum class FragilityMethod {
  likelihood,  ///< of the events counted at each level, all runs
  cloud,       ///< of demands of runs that stand, (2) of CloudFit, and of collapse apart, (1) of CollapseFit
  stripes      ///< of the levels' lognormal demands and collapses, (3) of Stripe
};
/// What users call them, in the order of the enumeration; the first is the default.
[[nodiscard]] const std::vector<std::string>& fragility_methods();
/// @throws InvalidParameter where none has the name.
[[nodiscard]] FragilityMethod fragility_method(const std::string& name);
[[nodiscard]] const std::string& name_of(FragilityMethod method);

/// The fragility of one case.
struct CaseFragility {
  std::vector<IntensityCount> counts;  ///< per intensity, ascending, without those left out
  long runs = 0, events = 0;           ///< sums of them
  long failed = 0;                     ///< runs left out, whose values make no case
  Fragility fit;
  std::optional<FragilityBounds> bounds;  ///< where resampling can change the kind of fit: from two records on
  /// Where some run collapses and the event is another: collapse by itself, and the event of the runs that stand.
  struct Split {
    std::vector<IntensityCount> collapse_counts, standing_counts;  ///< per intensity
    Fragility collapse, standing;
  };
  std::optional<Split> split = {};
  std::optional<CloudFit> cloud = {};  ///< by that method
  std::vector<Stripe> stripes = {};    ///< by that method
  /// Whether the fit is of all runs: not where some collapse, and by a cloud no logistic curve describes which.
  [[nodiscard]] bool is_of_all() const { return !fit.collapse || fit.collapse->is_known(); }
  /// Of a cloud with collapses: the intensity at which (4) of Fragility is ½, and half the logarithm of the intensities
  /// at which it is Φ(1) and Φ(−1), which of a lognormal are θ and β.
  struct OfAll {
    double median = 0, dispersion = 0;
    std::optional<Interval> median_bounds = {}, dispersion_bounds = {};
    int usable = 0;  ///< resamples that have both
  };
  [[nodiscard]] std::optional<OfAll> of_all() const;
  bool is_unscaled = false;  ///< each record has an intensity of its own: no shares at levels
  /// fit_distance() of what was counted; of the runs that stand where the fit is of them alone. Of unscaled records
  /// that of the cloud's residuals, CloudFit::distance; by another method nothing, since of one run a share says
  /// nothing.
  [[nodiscard]] std::optional<double> distance() const;
  /// Whether it is beyond fit_distance_limit() of the runs that it is of.
  [[nodiscard]] bool is_misfit() const;

  /// P(event | intensity), collapses too, at an intensity from the lowest to the highest level. It is 0 where no run
  /// has the event and 1 where every run has it; where data are separated it is 1 above the last level without an
  /// event, the safe side; with a single level it is the fraction of its runs that have the event. Nothing where (1) or
  /// (4) of Fragility does not describe the data.
  [[nodiscard]] std::optional<double> probability(double intensity) const;
};

/// Fits one case. Whole records are resampled for the bounds, so that equal seeds draw the same records in each case.
/// @throws InvalidParameter when the table's sizes do not agree, or as bootstrap_fragility().
/// By a cloud or by stripes the table must have demands and a threshold > 0.
[[nodiscard]] CaseFragility fit_case(const OutcomeTable& table, std::size_t c, const BootstrapOptions& options,
                                     FragilityMethod method = FragilityMethod::likelihood);

/// Bounds of P(event | intensity) by the fits of the resamples that know it; nothing where there are none.
[[nodiscard]] std::optional<Interval> probability_bounds(const CaseFragility& fragility, double intensity,
                                                         double confidence);

/// The gap for which P(event | intensity) ≤ p, from the fragilities at several widths.
struct GapEstimate {
  std::optional<GapForProbability> gap;  ///< nothing where P at one of the widths is not known
  /// Of the same estimate from each resample of the records; upper is ∞ where the largest width is not enough. Nothing
  /// where a width has no resamples, unless none or all of its runs have the event.
  std::optional<Interval> bounds;
};

/// @param widths [length], ascending, with one fragility each.
/// @throws InvalidParameter as gap_for_probability().
[[nodiscard]] GapEstimate gap_estimate(const std::vector<double>& widths,
                                       const std::vector<const CaseFragility*>& fragilities, double intensity, double p,
                                       double confidence);

}  // namespace bentur
