#pragma once

#include <string>
#include <string_view>

#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// The summary of a run of buildings in plan, as summary_json() of a row's; lists run bottom to top.
[[nodiscard]] std::string plan_summary_json(const PlanRun& run, std::string_view version);

/// What gaps need and rules ask, as gap_json() of a row's; each level has its place `at`.
[[nodiscard]] std::string plan_gap_json(const PlanRun& run, std::string_view version);

/// What rules ask from heights alone, as height_rules_json() of a row's.
[[nodiscard]] std::string plan_height_rules_json(const Case& c, const PlanProblem& problem, std::string_view version);

/// Periods, participation and effective mass fractions along x and y, and mass-normalised shapes of x, y, θ per floor.
[[nodiscard]] std::string plan_modes_json(const PlanProblem& problem);

}  // namespace bentur
