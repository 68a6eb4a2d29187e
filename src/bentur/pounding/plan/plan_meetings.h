#pragma once

#include <functional>
#include <vector>

#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

// What the free response says of gaps whose contacts touch only while others are closed (docs/theory/plan.md).
namespace bentur {

/// Whether some contacts touch only while others are closed.
[[nodiscard]] bool has_meetings(const PlanProblem& problem);

/// Brings the needs of contacts down to what is given where buildings never touch there without contact: where one
/// family of their level never closes, or never all of them at once. What is left is what keeps them apart by this
/// joint alone, whatever the others do: not less than what they need.
/// @param system of the problem, of which `free` is the free response but for widths; `points` as it has them
/// @param reversed the same under the motion reversed, where that is asked for
void take_meetings(const PlanProblem& problem, const System& system, const FreeSolution& free,
                   const std::function<FreeSolution()>& reversed, const RunLimits& limits,
                   std::vector<PointSummary>& points);

}  // namespace bentur
