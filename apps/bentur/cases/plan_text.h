#pragma once

#include <string>

#include "bentur/model/plan/plan_run.h"
#include "bentur/report/words.h"

namespace bentur::cli {

/// What is told of a run of buildings in plan on a terminal.
[[nodiscard]] std::string plan_summary_text(const PlanRun& run, const Words& say);

}  // namespace bentur::cli
