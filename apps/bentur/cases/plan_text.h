#pragma once

#include <string>

#include "bentur/model/plan/plan_run.h"
#include "bentur/report/words.h"

namespace bentur::cli {

/// Points, links, floors, foundations, bearings and planes of a run of buildings in plan, as tables.
[[nodiscard]] std::string run_tables(const PlanRun& run, const Words& say);

}  // namespace bentur::cli
