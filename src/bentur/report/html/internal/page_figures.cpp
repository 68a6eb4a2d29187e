#include "bentur/report/html/internal/page_figures.h"

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/internal/kind_table.h"
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

/// Of what is on paper a line by itself, or half a line: three of pictures so high with their captions fill a page.
constexpr double third_of_page = 8.05;  // [cm]
/// Histories of one place come first, below the heading of all figures, two lines to a page.
constexpr double half_of_page = 11.9;  // [cm]
constexpr std::size_t lines_of_histories = 2, lines_of_page = 3;

/// Of a caption below a figure over the page, or over half of it, in lines as report.css prints them [cm].
double caption_height(const std::string& caption, bool is_wide) {
  constexpr double of_line = 0.34, free = 0.25;                                           // [cm]
  const double letters = is_wide ? 120 : 58;                                              // of a line
  return free + of_line * std::ceil(static_cast<double>(caption.size() + 10) / letters);  // with its number
}

/// As high as a line without its caption; somewhat higher where its frames would be too low.
void bound_to_lines(Figure& figure, double most) {
  constexpr double least = 2.2, higher = 1.2;  // of a frame, than a line [cm]
  Figure low = figure;
  bound_height(low, most);
  const bool is_too_low = std::any_of(low.panels.begin(), low.panels.end(),
                                      [](const Panel& one) { return !one.to_scale && one.height < least; });
  if (is_too_low)
    bound_height(figure, most + higher);
  else
    figure = std::move(low);
}

/// One that is higher than a line takes two, so that it and a line fill a page: with frames higher by a half at most.
void fill_two_lines(Figure& figure, double most) {
  constexpr double highest = 1.5;  // times as they were
  const auto is_to_scale = [](const Panel& one) { return one.to_scale; };
  if (std::any_of(figure.panels.begin(), figure.panels.end(), is_to_scale)) return;
  for (Panel& panel : figure.panels) panel.height *= highest;
  bound_height(figure, most);
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
  std::size_t first = low.size() - std::min(low.size(), high.size());
  const std::size_t last = first < lines_of_histories ? 0 : (first - lines_of_histories) % lines_of_page;
  if (!high.empty() && last == 2) --first;  // beside two lines none that is higher has room on a page
  std::size_t next = 0;
  while (next < first) put(low[next++]);
  for (std::vector<PageFigure>& one : high) {
    put(one);
    if (next < low.size()) put(low[next++]);
  }
  while (next < low.size()) put(low[next++]);
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
      const double below = caption_height(caption, is_wide);
      const bool is_history = !is_wide && is_of_a_place(kind.name) && kind.name != "loop";
      bound_to_lines(figure, (is_history ? half_of_page : third_of_page) - below);
      const bool is_high = is_wide && layout(figure).height + below > 1.3 * third_of_page;
      if (is_high) fill_two_lines(figure, 2 * third_of_page - below);
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
