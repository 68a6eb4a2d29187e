#pragma once

#include <vector>

#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/report/figures/figure.h"

namespace bentur {

/// The buildings that stand out among many: those of the hardest impact, and those of the contact point that lacks
/// most.
struct PairsOfNote {
  BuildingPair struck = {}, worst = {};
};
[[nodiscard]] PairsOfNote pairs_of_note(const Problem& problem, const RunOutcome& outcome);
[[nodiscard]] PairsOfNote pairs_of_note(const PlanProblem& problem, const RunOutcome& outcome);

/// The colour of each building in every picture of a run: building_tone().
[[nodiscard]] std::vector<Tone> tones_of(const Problem& problem, const RunOutcome& outcome);
[[nodiscard]] std::vector<Tone> tones_of(const PlanProblem& problem, const RunOutcome& outcome);

}  // namespace bentur
