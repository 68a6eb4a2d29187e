#pragma once

#include <string>

#include "bentur/files/netcdf.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// One HTML page on the results of a sweep or an incremental dynamic analysis: in how many runs the buildings collide,
/// the hardest run, the gap needed; what varied; the figures; the study and its case as they were given.
/// @throws std::runtime_error when the file holds no such results.
[[nodiscard]] std::string sweep_report_html(const NetcdfReader& results, const ReportOptions& options);

}  // namespace bentur
