#include "bentur/report/html/internal/page_figures.h"

#include <algorithm>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/words.h"

namespace bentur::html {

std::vector<PageFigure> page_figures(const std::vector<FigureKind>& kinds, const MakeFigure& make,
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
      const Figure figure = make(kind.name, options);
      std::string caption = say(family + kind.name + (figure.lacks.empty() ? "" : ".without_" + figure.lacks));
      if (!figure.part.empty()) caption += ". " + figure.part;
      constexpr double tall = 0.6;  // of the width
      figures.push_back({.caption = caption,
                         .svg = figure_element(figure, caption),
                         .wide = figure.width > column_width,
                         .tall = layout(figure).height > tall * figure.width});
      if (!figures.back().wide) continue;
      FigureOptions narrow = options;
      narrow.narrow = true;
      const Figure slim = make(kind.name, narrow);
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
