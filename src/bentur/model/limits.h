#pragma once

#include <string>

#include "bentur/model/case.h"
#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/pounding.h"

namespace bentur {

/// "mode 3 of A".
[[nodiscard]] std::string fastest_source(const Case& c, const Problem& problem, const Effort::Fastest& fastest);
[[nodiscard]] std::string fastest_source(const Case& c, const PlanProblem& problem, const Effort::Fastest& fastest);

/// Why a run is refused before any work is done, with what makes it so; empty where it is within the case's limits.
[[nodiscard]] std::string beyond_limits(const Case& c, const Problem& problem, const Effort& effort);
[[nodiscard]] std::string beyond_limits(const Case& c, const PlanProblem& problem, const Effort& effort);

}  // namespace bentur
