#include "bentur/report/html/internal/page_figures.h"

#include <algorithm>

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
      // On paper three of a column's width stand one below another, and two of a page's.
      bound_height(figure, is_wide ? 8.7 : 6.5);
      figures.push_back({.caption = caption, .svg = figure_element(figure, caption), .wide = is_wide});
      if (!is_wide) continue;
      const auto made = [&](const FigureOptions& with) { return make(kind.name, with); };
      Figure slim = narrowest.width < figure.width ? narrowest : narrow_figure(made, options);
      bound_height(slim, 15);  // of a telephone's screen, of whose width it is
      if (slim.width < figure.width) figures.back().slim = figure_element(slim, caption);
    } catch (const NoFigure&) {  // this one has nothing to show
      continue;
    }
  }
  // Wide ones between two columns of others would leave holes: they come first as they are, else last.
  const auto is_narrow = [](const PageFigure& one) { return !one.wide; };
  std::stable_partition(std::find_if(figures.begin(), figures.end(), is_narrow), figures.end(), is_narrow);
  return figures;
}

}  // namespace bentur::html
