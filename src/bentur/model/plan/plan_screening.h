#pragma once

#include <cstddef>
#include <vector>

#include "bentur/model/gap/screening.h"
#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// Every rule of screening() for a gap in plan, with that of eccentricity (8). A building is backed where another that
/// moves stands behind it: across a gap that faces away from this one, to within 45 degrees. None where one of the two
/// moves with the ground, or where what holds them is not known, as of results that are read back.
[[nodiscard]] std::vector<ScreeningFinding> plan_screening(const Case& c, const PlanProblem& problem, std::size_t gap);

}  // namespace bentur
