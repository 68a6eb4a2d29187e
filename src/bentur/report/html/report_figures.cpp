#include "bentur/report/html/report_figures.h"

#include <functional>
#include <map>
#include <string_view>

#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/html/internal/words.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

namespace {

/// A text of a figure in the report's language; what is not in the catalogue, such as a name, as it is.
std::function<std::string(std::string_view)> words_of_figures(const std::string& language) {
  constexpr std::string_view keys = "figure.text.";
  std::map<std::string, std::string, std::less<>> texts;
  for (const auto& [key, text] : html::catalogue().texts) {
    if (key.starts_with(keys)) texts.emplace(text.at("en"), text.at(language));
  }
  return [texts](std::string_view english) {
    const auto found = texts.find(english);
    return found == texts.end() ? std::string(english) : found->second;
  };
}

/// Every figure that `results`, of a run or a study, can give.
template <typename Results>
std::vector<ReportFigure> drawn(const Results& results, const std::string& family, const std::string& language) {
  if (!gnuplot_version()) return {};
  const html::Words say(language);
  std::vector<ReportFigure> figures;
  FigureOptions options;
  options.say = words_of_figures(language);
  options.choose = true;
  for (const FigureKind& kind : figure_kinds(results)) {
    const std::string caption = say(family + kind.name);
    try {
      const FigureText text = figure_text(make_figure(results, kind.name, options), kind.name);
      figures.push_back({.caption = caption, .svg = draw(text, kind.name, "svg")});
    } catch (const NoFigure&) {  // this one has nothing to show
      continue;
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
