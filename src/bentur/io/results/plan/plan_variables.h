#pragma once

#include <string_view>

#include "bentur/io/results/result_variable.h"
#include "bentur/model/plan/plan_case.h"

namespace bentur {

/// What histories.nc holds of a run of buildings in plan (docs/result-files.md), as run_file() of a row's. Dimensions
/// `time`, `component` of the ground motion, `elevation_N` and `plane_N` of building N (1 the first of the case),
/// `gap`, `point`, `impact`. The values look into `run`, which must outlive them.
[[nodiscard]] ResultFile plan_file(const PlanRun& run, std::string_view version);

}  // namespace bentur
