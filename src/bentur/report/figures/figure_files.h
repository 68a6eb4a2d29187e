#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

struct NamedFigure {
  std::string name;  ///< of its files, without ending
  Figure figure;
};

/// Draws the figures and writes NAME.dat, NAME.gp and a NAME.svg, .pdf, .png for each format, all or none.
/// @throws std::runtime_error naming the file, or with what gnuplot says. Where gnuplot is missing data and scripts are
/// written all the same, and then NoGnuplot is thrown.
void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures,
                   const std::vector<std::string>& formats);

/// Writes all figures that a run can give, from the contents of its histories.nc, and removes from the folder those of
/// an earlier run. @return their names. @throws as write_figures().
std::vector<std::string> write_run_figures(const std::filesystem::path& folder, const std::string& histories,
                                           const std::vector<std::string>& formats);

}  // namespace bentur
