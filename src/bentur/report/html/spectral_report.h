#pragma once

#include <string>
#include <vector>

#include "bentur/model/gap/spectral_gap.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// One HTML page on the gaps of a case by its spectrum: verdict, gaps by every rule, screening, peaks of each building
/// by SRSS and CQC, the case as it was given. Nothing moves in it, as nothing was simulated.
/// @param problem make_still_problem() of the case @param spectral its gaps
[[nodiscard]] std::string spectral_report_html(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                               const ReportOptions& options);

/// Its tables alone: the gaps by every rule, and the peaks with the modes they are made of.
[[nodiscard]] std::vector<PagePart> table_parts(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                                const std::string& language);

}  // namespace bentur
