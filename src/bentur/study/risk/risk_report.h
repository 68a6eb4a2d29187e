#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/risk/annual_rate.h"

namespace bentur {

/// What is asked of the results of an incremental dynamic analysis and a hazard curve.
struct RiskRequest {
  std::string event = pounding_event;
  FragilityMethod method = FragilityMethod::likelihood;
  BootstrapOptions bootstrap = {};
  double years = 50;
  std::optional<double> target = {};  ///< probability of pounding in `years` that a gap is sought for, in (0, 1)
};

/// The event's rate at one combination of what else varies.
struct CaseRisk {
  std::size_t c = 0;
  CaseFragility fragility;
  std::optional<AnnualRate> lognormal;  ///< where θ and β are known, and which runs collapse, if they do so apart
  std::optional<double> closed_form;    ///< (4) of AnnualRate [1/year], beside it; of a lognormal alone
  std::optional<Interval> bounds;       ///< of the lognormal's rate, by resampled records [1/year]
  AnnualRate observed;                  ///< of the shares observed at the levels, of a cloud rising_shares()
  /// Each record's part of `observed`, applied both ways together [1/year]; of a cloud none is known.
  std::vector<double> of_records;

  /// How many runs tell nothing, as their values make no case: rate and shares are of the others.
  [[nodiscard]] long failed() const { return fragility.failed; }
  [[nodiscard]] bool is_of_some() const { return fragility.runs > 0; }  ///< else nothing is known
  /// Whether the runs follow the lognormal; else the rate is that of the shares.
  [[nodiscard]] bool is_lognormal() const { return lognormal && !fragility.is_misfit(); }
  [[nodiscard]] const AnnualRate& told() const { return is_lognormal() ? *lognormal : observed; }
};

/// The gap for which buildings collide no more often than the target.
struct TargetGap {
  std::size_t c = 0;            ///< the first of the cases that need the same: they differ in gap widths and contact
  std::optional<double> width;  ///< [length]; nothing: no gap does, by what was run and what the hazard says
  double rate = 0;              ///< at that gap, else beyond what is known [1/year]
  long runs = 0, failed = 0;    ///< that tell what they need, and that make no case
  long open = 0;                ///< of the whole study, runs of which it is not known what they need
  /// Whether the width keeps the target: all runs tell what they need.
  [[nodiscard]] bool is_known() const { return width && failed == 0 && open == 0; }
};

struct RiskReport {
  IdaResults results;
  HazardCurve hazard;          ///< in the unit of the levels
  std::string measure;         ///< of the levels, as OpenQuake calls them: "PGA", "SA(0.5)"
  bool unit_is_taken = false;  ///< nothing says the hazard's unit: that of the levels is taken
  std::vector<CaseRisk> cases;
  std::vector<TargetGap> gaps;             ///< where a target was asked for
  std::vector<bool> gaps_vary_along = {};  ///< of each axis of the results, whether what is needed changes along it
  std::string gap_units;
};

/// @param results for the request's event @param needed the same results for "gap_needed > 0"; with a target alone
/// @param hazard its unit is converted to that of the levels; its measure, where it has one, must be theirs
/// @return nothing where they do not go together; `error` then says why.
[[nodiscard]] std::optional<RiskReport> risk_report(IdaResults results, const std::optional<IdaResults>& needed,
                                                    HazardCurve hazard, const RiskRequest& request, std::string& error);

/// What is to be said of it, case by case.
[[nodiscard]] Story risk_story(const RiskReport& report, const RiskRequest& request);

/// docs/risk.md. What does not exist is null.
[[nodiscard]] std::string risk_json(const RiskReport& report, const RiskRequest& request, std::string_view version);

}  // namespace bentur
