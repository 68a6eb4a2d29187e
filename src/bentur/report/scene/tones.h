#pragma once

#include <vector>

#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/report/figures/figure.h"

namespace bentur {

/// The colour of each building in every picture of a run: building_tone().
[[nodiscard]] std::vector<Tone> tones_of(const Problem& problem, const std::vector<Impact>& impacts);
[[nodiscard]] std::vector<Tone> tones_of(const PlanProblem& problem, const std::vector<Impact>& impacts);

}  // namespace bentur
