#include "bentur/report/kinds/figure_width.h"

#include <algorithm>
#include <utility>

namespace bentur {
namespace {

/// The panels one below another, each with the labels and numbers that those of neighbours served for.
Figure stacked(Figure figure, double width) {
  const auto columns = static_cast<std::size_t>(figure.columns);
  const auto takes_more = [](const Panel& one) { return one.rows > 1 || one.across > 1; };
  if (std::any_of(figure.panels.begin(), figure.panels.end(), takes_more)) return figure;
  const auto take = [](Axis& axis, const Axis& other) {
    if (axis.label.empty()) axis.label = other.label;
    axis.numbers = axis.numbers || other.numbers;
  };
  const std::size_t count = figure.panels.size();
  for (std::size_t i = 0; i < count && columns > 1; ++i) {
    Panel& panel = figure.panels[i];
    if (panel.to_scale) continue;
    take(panel.y, figure.panels[i - i % columns].y);
    take(panel.x, figure.panels[i + (count - 1 - i) / columns * columns].x);
  }
  figure.columns = 1;
  figure.shares = {};
  figure.width = width;
  return figure;
}

}  // namespace

Figure narrow_figure(const MakeFigure& make, FigureOptions options) {
  options.narrow = true;
  Figure figure = make(options);
  return figure.width > options.width ? stacked(std::move(figure), options.width) : figure;
}

Figure figure_of_width(const MakeFigure& make, FigureOptions options, double width) {
  constexpr double round_off = 1e-9, of_two_columns = 12;  // [cm], room for two panels side by side [cm]
  options.width = width;
  Figure figure = make(options);
  if (figure.width <= width + round_off) return figure;
  if (width < of_two_columns) return narrow_figure(make, options);
  options.width = width * column_width / page_width;  // of which a broad figure makes the whole
  figure = make(options);
  figure.width = width;  // but for round-off
  return figure;
}

}  // namespace bentur
