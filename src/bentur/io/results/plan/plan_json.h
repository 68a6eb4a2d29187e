#pragma once

#include <string>
#include <string_view>

#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// The summary of a run of buildings in plan, as of a row; lists run bottom to top.
[[nodiscard]] std::string summary_json(const PlanRun& run, std::string_view version);

/// What gaps need and rules ask, as of a row; each level has its place `at`.
[[nodiscard]] std::string gap_json(const PlanRun& run, std::string_view version);

/// What rules ask from heights alone, as of a row.
[[nodiscard]] std::string height_rules_json(const Case& c, const PlanProblem& problem, std::string_view version);

/// Periods, participation and effective mass fractions along x and y, and mass-normalised shapes of x, y, θ per floor.
[[nodiscard]] std::string modes_json(const PlanProblem& problem);

}  // namespace bentur
