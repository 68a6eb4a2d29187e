#pragma once

#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// Every figure that the results of a study can give, for a report.
[[nodiscard]] std::vector<ReportFigure> report_figures(const NetcdfReader& results, const std::string& language);
/// The same of a run.
[[nodiscard]] std::vector<ReportFigure> report_figures(const RunResults& results, const std::string& language);

}  // namespace bentur
