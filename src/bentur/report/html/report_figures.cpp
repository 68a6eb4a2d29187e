#include "bentur/report/html/report_figures.h"

#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/html/internal/words.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

namespace {

/// Every figure that `results`, of a run or a study, can give.
template <typename Results>
std::vector<ReportFigure> drawn(const Results& results, const std::string& family, const std::string& language) {
  if (!gnuplot_version()) return {};
  const html::Words say(language);
  std::vector<ReportFigure> figures;
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

}  // namespace

std::vector<ReportFigure> report_figures(const NetcdfReader& results, const std::string& language) {
  return drawn(results, "figure.sweep.", language);
}

std::vector<ReportFigure> report_figures(const RunResults& results, const std::string& language) {
  return drawn(results, "figure.", language);
}

}  // namespace bentur
