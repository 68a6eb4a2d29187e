#pragma once

#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// The kinds of figure that a file of results can give: those of a run, of a sweep, or of an incremental dynamic
/// analysis. @throws NoFigure when it holds none of these.
[[nodiscard]] std::vector<FigureKind> figure_kinds(const NetcdfReader& results);

/// One figure from a file of results: of one of the kinds, or, of a study, of any quantity by its name.
/// @throws NoFigure when there is no such kind, or what the options ask for is not there.
[[nodiscard]] Figure make_figure(const NetcdfReader& results, const std::string& kind,
                                 const FigureOptions& options = {});

}  // namespace bentur
