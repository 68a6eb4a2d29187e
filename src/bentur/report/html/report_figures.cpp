#include "bentur/report/html/report_figures.h"

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/html/internal/words.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

std::vector<ReportFigure> report_figures(const NetcdfReader& results, const std::string& language) {
  if (!gnuplot_version()) return {};
  const html::Words say(language);
  std::vector<ReportFigure> figures;
  const std::string family = results.find("status") != nullptr ? "figure.sweep." : "figure.";
  for (const FigureKind& kind : figure_kinds(results)) {
    const std::string caption = say(family + kind.name);
    try {
      const FigureText text = figure_text(make_figure(results, kind.name), kind.name);
      figures.push_back({.caption = caption, .svg = draw(text, kind.name, "svg")});
    } catch (const NoFigure& reason) {  // a sweep in many directions asks which of them to show
      figures.push_back({.caption = caption + ": " + reason.what(), .svg = ""});
    }
  }
  return figures;
}

std::vector<ReportFigure> report_figures(RunResults results, const std::string& language) {
  if (!gnuplot_version()) return {};
  results.figures = figure_data(results.problem, results.response, results.c.analysis.solver);
  return report_figures(NetcdfReader(histories_netcdf(results, ""), "histories"), language);
}

}  // namespace bentur
