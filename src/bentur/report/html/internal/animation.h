#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// What motion.js plays and row.js draws, as JSON: units, buildings with the displacements of their floors,
/// contact points and the `listed` impacts. The response must have histories.
[[nodiscard]] std::string animation_json(const RunResults& run, const std::vector<Eigen::Index>& listed,
                                         const Words& say);
/// The same for plan.js: the PlanScene, buildings with u_x, u_y [length] and θ times an arm of their floors. There must
/// be contacts.
[[nodiscard]] std::string animation_json(const PlanRun& run, const std::vector<Eigen::Index>& listed, const Words& say);

}  // namespace bentur::html
