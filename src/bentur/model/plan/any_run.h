#pragma once

#include <variant>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// A run of a row or of buildings in plan, where one holds either: std::visit with what both have.
using AnyRun = std::variant<RunResults, PlanRun>;

}  // namespace bentur
