#pragma once

#include <string>

#include "bentur/model/plan/plan_run.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// The report of a run of buildings in plan, as report_html() of a row's, one to hand in likewise: the same verdict,
/// opening figure, remarks, moving picture (from above), tables, figures and input. The response must have histories.
/// @throws InvalidParameter for an unknown language, or without histories.
[[nodiscard]] std::string plan_report_html(const PlanRun& run, const ReportOptions& options);

/// A step for the histories of such a report [s]: fine enough for impacts, within some megabytes.
[[nodiscard]] double report_output_step(const PlanProblem& problem);

}  // namespace bentur
