#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/report/words.h"
#include "bentur/study/fragility/ida_results.h"
#include "bentur/study/risk/hazard.h"
#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {

struct ReportOptions {
  std::string language = "en";  ///< one of report_languages()
  std::string version;          ///< of the program
  /// Of a run: sensitivity_of_report(); the report then says how peaks change.
  std::optional<Sensitivity> sensitivity = {};
  std::optional<HazardCurve> hazard = {};  ///< of the site: an incremental dynamic analysis then tells how often a year
  /// Of an incremental dynamic analysis: an event whose fragility is shown too, and by what it is found.
  std::string event = pounding_event;
  FragilityMethod method = FragilityMethod::likelihood;
};

/// Step of the histories a report of this problem moves by [s]: fine enough to see an impact in slow motion, and so
/// coarse that the samples take no more than 0.6 MB for 10 s and 3 MB for 50 s and longer.
[[nodiscard]] double report_output_step(const Problem& problem);
/// Of buildings in plan: fine enough for impacts, within some megabytes.
[[nodiscard]] double report_output_step(const PlanProblem& problem);

/// One HTML page that needs nothing else. With [project] in the case it is one to hand in: a title block,
/// numbered sections, assumptions, every input with the line it stands on, records, checks in the order of codes, what
/// was not checked. In all: verdict, gap needed, peaks, impacts, the buildings in motion, figures, input.
/// Text of a case cannot bring in markup or script, and the page's own policy lets it fetch nothing and run no other
/// script. The same run gives the same bytes. The response must have histories. A run read from result files
/// (files/result_reading.h) gives a report without the buildings as given, DDC and the rules of codes.
/// @throws InvalidParameter for an unknown language, or a response that is not that of the problem.
[[nodiscard]] std::string report_html(const RunResults& run, const ReportOptions& options);
/// The same of buildings in plan, which move as seen from above; results read back have their case.
[[nodiscard]] std::string report_html(const PlanRun& run, const ReportOptions& options);

}  // namespace bentur
