#pragma once

#include <string>

#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// `impacts.csv` of buildings in plan: as impacts_csv() of a row, with L and R of the stretch, x and y of the place,
/// and the impulse along the joint, empty where nothing rubs.
[[nodiscard]] std::string impacts_csv(const PlanRun& run);

}  // namespace bentur
