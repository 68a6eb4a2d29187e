#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// The summary of a run, also `summary.json`: every quantity but those of impacts, and what was asked. Lists run bottom
/// to top; a number that does not exist (amplification over a peak of zero, the time of a force that never was, energy
/// without an audit) is null.
[[nodiscard]] std::string summary_json(const RunResults& results, std::string_view version);
[[nodiscard]] std::string summary_json(const PlanRun& run, std::string_view version);

/// Periods, participation, effective mass fractions and mass-normalised shapes of each building; weight.
[[nodiscard]] std::string modes_json(const Problem& problem, const Units& units);
/// Of buildings in plan along x and y; shapes of x, y, θ per floor.
[[nodiscard]] std::string modes_json(const PlanProblem& problem, const Units& units);

/// The gap each level needs, contact points and watched floors: simulated, ABS, SRSS, DDC and the rules of the case's
/// [code]; a gap's own values are the largest of its levels'. What each rule says of the gap given, with the level that
/// governs.
[[nodiscard]] std::string gap_json(const RunResults& results, std::string_view version);
/// The same of buildings in plan; each level has its place `at`.
[[nodiscard]] std::string gap_json(const PlanRun& run, std::string_view version);

/// What rules ask of buildings in plan from heights alone, as of a row (rules_json.h).
[[nodiscard]] std::string height_rules_json(const Case& c, const PlanProblem& problem, std::string_view version);

/// The same by the case's spectrum: of each building periods, spectral displacements and peaks by SRSS and CQC; of each
/// gap the spectral difference as the gap needed.
[[nodiscard]] std::string spectral_gap_json(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                            std::string_view version);

}  // namespace bentur
