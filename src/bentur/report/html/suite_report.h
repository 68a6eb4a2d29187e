#pragma once

#include <string>
#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/report.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/suite/suite_run.h"

namespace bentur {

/// One HTML page on a case with a suite of records: verdict, spectra against the target, records and what each of them
/// does, the gap by record with what the code takes, the case as it was given. Nothing moves in it: `--record N` gives
/// the page of one record. With [project] in the case, or a head, it is one to hand in, as that of a run.
[[nodiscard]] std::string suite_report_html(const SuiteRun& run, const GapStudy& gaps, const ReportOptions& options);

/// Its tables alone: the records and the buildings' periods, what each record does, the gap by record.
[[nodiscard]] std::vector<PagePart> table_parts(const SuiteRun& run, const GapStudy& gaps, const std::string& language);

}  // namespace bentur
