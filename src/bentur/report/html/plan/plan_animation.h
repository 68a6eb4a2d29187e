#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// What motion.js plays and plan.js draws, as JSON: the PlanScene, buildings with u_x, u_y [length] and θ times
/// an arm of their floors, contact points and the `listed` impacts. The response must have histories and contacts.
[[nodiscard]] std::string plan_animation_json(const PlanRun& run, const Words& say,
                                              const std::vector<Eigen::Index>& listed);

}  // namespace bentur::html
