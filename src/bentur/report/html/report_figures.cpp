#include "bentur/report/html/report_figures.h"

#include <algorithm>

#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"

namespace bentur {

namespace {

/// Every figure that `results`, of a run or a study, can give.
template <typename Results>
std::vector<ReportFigure> drawn(const Results& results, const std::string& family, const std::string& language) {
  const Words say(language);
  std::vector<ReportFigure> figures;
  FigureOptions options;
  options.say = figure_words(language);
  options.choose = true;
  for (const FigureKind& kind : figure_kinds(results)) {
    if (!kind.tells) continue;
    const std::string caption = say(family + kind.name);
    try {
      const Figure figure = make_figure(results, kind.name, options);
      figures.push_back(
          {.caption = caption, .svg = figure_element(figure, caption), .wide = figure.width > column_width});
    } catch (const NoFigure&) {  // this one has nothing to show
      continue;
    }
  }
  // Wide ones between two columns of others would leave holes: they come first as they are, else last.
  const auto is_narrow = [](const ReportFigure& one) { return !one.wide; };
  std::stable_partition(std::find_if(figures.begin(), figures.end(), is_narrow), figures.end(), is_narrow);
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
