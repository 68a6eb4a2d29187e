#include "bentur/report/html/internal/page_figures.h"

#include <algorithm>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/words.h"

namespace bentur::html {
namespace {

/// More panels one below another than stand beside other figures: two side by side over a page's width.
void spread(Figure& figure) {
  constexpr std::size_t most = 3;
  const std::size_t count = figure.panels.size();
  if (figure.columns > 1 || figure.width > column_width || count <= most || !figure.shares.empty()) return;
  const auto takes_room = [](const Panel& one) { return one.to_scale || one.rows > 1; };
  if (std::any_of(figure.panels.begin(), figure.panels.end(), takes_room)) return;
  figure.columns = 2;
  figure.width = page_width;
  Axis& beside = figure.panels[count - 2].x;
  if (beside.label.empty()) beside.label = figure.panels.back().x.label;
  beside.numbers = beside.numbers || figure.panels.back().x.numbers;
}

/// Of what is on paper a line by itself, or half a line: three lines of pictures so high, with captions, fill a page.
constexpr double third_of_page = 7.3;  // [cm]

/// As high as a line; somewhat higher where its frames would be too low.
void bound_to_lines(Figure& figure) {
  constexpr double least = 2.2, somewhat_higher = 8.7;  // of a frame, of the figure [cm]
  Figure low = figure;
  bound_height(low, third_of_page);
  const bool is_too_low = std::any_of(low.panels.begin(), low.panels.end(),
                                      [](const Panel& one) { return !one.to_scale && one.height < least; });
  if (is_too_low)
    bound_height(figure, somewhat_higher);
  else
    figure = std::move(low);
}

/// In an order that leaves no holes: those of a column's width two to a line, behind wide ones that come first, and
/// before those that do not. Behind each that is higher than a line there is, as far as there are enough, one that is
/// not: both fill a page.
std::vector<PageFigure> in_lines(std::vector<PageFigure> figures) {
  const auto is_narrow = [](const PageFigure& one) { return !one.wide; };
  std::stable_partition(std::find_if(figures.begin(), figures.end(), is_narrow), figures.end(), is_narrow);
  std::vector<std::vector<PageFigure>> low, high;
  for (PageFigure& one : figures) {
    const bool is_second = !one.wide && !low.empty() && low.back().size() == 1 && !low.back().front().wide;
    if (one.is_high) {
      high.push_back({std::move(one)});
    } else if (is_second) {
      low.back().push_back(std::move(one));
    } else {
      low.push_back({std::move(one)});
    }
  }
  figures.clear();
  const auto put = [&](std::vector<PageFigure>& line) {
    for (PageFigure& one : line) figures.push_back(std::move(one));
  };
  const std::size_t first = low.size() - std::min(low.size(), high.size());
  for (std::size_t i = 0; i < first; ++i) put(low[i]);
  for (std::size_t i = 0; i < high.size(); ++i) {
    put(high[i]);
    if (first + i < low.size()) put(low[first + i]);
  }
  return figures;
}

}  // namespace

std::vector<PageFigure> page_figures(const std::vector<FigureKind>& kinds, const MakeKind& make,
                                     const std::string& family, const std::string& language) {
  const Words say(language);
  std::vector<PageFigure> figures;
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  options.choose = true;
  for (const FigureKind& kind : kinds) {
    if (!kind.tells) continue;
    try {
      Figure figure = make(kind.name, options);
      std::string caption = say(family + kind.name + (figure.lacks.empty() ? "" : ".without_" + figure.lacks));
      if (!figure.part.empty()) caption += ". " + figure.part;
      const Figure narrowest = figure;
      spread(figure);
      const bool is_wide = figure.width > column_width;
      bound_to_lines(figure);
      const bool is_high = is_wide && layout(figure).height > 1.5 * third_of_page;
      figures.push_back(
          {.caption = caption, .svg = figure_element(figure, caption), .wide = is_wide, .is_high = is_high});
      if (!is_wide) continue;
      const auto made = [&](const FigureOptions& with) { return make(kind.name, with); };
      Figure slim = narrowest.width < figure.width ? narrowest : narrow_figure(made, options);
      bound_height(slim, 15);  // of a telephone's screen, of whose width it is
      if (slim.width < figure.width) figures.back().slim = figure_element(slim, caption);
    } catch (const NoFigure&) {  // this one has nothing to show
      continue;
    }
  }
  return in_lines(std::move(figures));
}

}  // namespace bentur::html
