#pragma once

#include <functional>
#include <vector>

#include "bentur/pounding/plan/free_touches.h"
#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/response.h"

// What the free response says of gaps whose contacts touch only while others are closed (docs/theory/plan.md).
namespace bentur {

/// Whether some contacts touch only while others are closed.
[[nodiscard]] bool has_meetings(const PlanProblem& problem);

/// Brings the needs of contacts down to what is given where buildings never touch there without contact: where one
/// family of their level never closes, or never all of them at once. What is left is what keeps them apart by this
/// joint alone, whatever the others do: not less than what they need.
/// @param given of the free response, by which `points` have their needs
/// @param reversed the same under the motion reversed, where that is asked for
void take_meetings(const PlanProblem& problem, FreeTouches& given, const std::function<FreeTouches&()>& reversed,
                   std::vector<PointSummary>& points);

}  // namespace bentur
