#pragma once

#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/html/report.h"

namespace bentur {

/// Every figure that results (histories.nc of a run, or those of a sweep) can give, drawn by gnuplot for a report; none
/// where gnuplot is not installed.
/// @throws std::runtime_error with what gnuplot says when it cannot draw.
[[nodiscard]] std::vector<ReportFigure> report_figures(const NetcdfReader& results, const std::string& language);
/// The same of a run at hand.
[[nodiscard]] std::vector<ReportFigure> report_figures(RunResults results, const std::string& language);

}  // namespace bentur
