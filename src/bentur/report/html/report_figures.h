#pragma once

#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// Every figure that the results of a study can give, drawn by gnuplot for a report; none
/// where gnuplot is not installed.
/// @throws std::runtime_error with what gnuplot says when it cannot draw.
[[nodiscard]] std::vector<ReportFigure> report_figures(const NetcdfReader& results, const std::string& language);
/// The same of a run.
[[nodiscard]] std::vector<ReportFigure> report_figures(const RunResults& results, const std::string& language);

}  // namespace bentur
