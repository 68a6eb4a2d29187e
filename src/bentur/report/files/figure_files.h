#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/output/output_rules.h"
#include "bentur/model/run_results.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// A figure and what its files are called.
struct NamedFigure {
  std::string name;  ///< of its files, without ending
  Figure figure;
};

/// Draws the figures and writes NAME.svg, .pdf, .png for each format, all or none, and NAME-data.csv and NAME.py to
/// restyle it. @throws std::runtime_error naming the file, or with what rsvg-convert says. Where that is missing all
/// else is written all the same, and then NoConverter is thrown. RefusedOutput by the rules.
void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures,
                   const std::vector<std::string>& formats, const OutputRules& rules);

/// Refuses, before any work is done, what write_figures() would refuse for a figure of that name.
void expect_figure(const std::filesystem::path& folder, const std::string& name,
                   const std::vector<std::string>& formats, const OutputRules& rules);

/// All figures that a run can give, each called by its kind.
[[nodiscard]] std::vector<NamedFigure> run_figures(const RunResults& results, const FigureOptions& options = {});
[[nodiscard]] std::vector<NamedFigure> run_figures(const PlanRun& run, const FigureOptions& options = {});

/// Removes what an earlier run has drawn into a folder, and the folder if nothing else is in it. What is not a figure
/// by bentur (io/output/result_kind.h) stays, and so does an input.
void remove_run_figures(const std::filesystem::path& folder, const OutputRules& rules);

}  // namespace bentur
