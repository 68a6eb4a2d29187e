#include "bentur/report/kinds/figure_width.h"

#include <algorithm>
#include <utility>

#include "bentur/report/figures/internal/layout.h"

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

void bound_height(Figure& figure, double most) {
  constexpr double least = 1.7;  // of a frame [cm]
  // What is to scale is no lower, and neither are frames beside which names stand.
  const auto is_as_it_is = [](const Panel& one) { return one.to_scale || !one.y.names.empty(); };
  for (int tries = 0; tries < 4; ++tries) {
    const double excess = layout(figure).height - most;
    double frames = 0;  // of all rows
    for (const Panel& panel : figure.panels) frames += is_as_it_is(panel) ? 0 : panel.height / figure.columns;
    if (!(excess > 0) || !(frames > 0)) return;
    for (Panel& panel : figure.panels) {
      if (is_as_it_is(panel) || panel.height <= least) continue;
      panel.height = std::max(least, panel.height * std::max(0.3, 1 - excess / frames));
    }
  }
}

Figure narrow_figure(const MakeFigure& make, FigureOptions options) {
  options.narrow = true;
  Figure figure = make(options);
  return figure.width > options.width ? stacked(std::move(figure), options.width) : figure;
}

Figure figure_of_width(const MakeFigure& make, FigureOptions options, double width) {
  constexpr double round_off = 1e-9, of_two_columns = 12;  // [cm], room for two panels side by side [cm]
  options.width = width;
  Figure figure = make(options);
  if (figure.width > width + round_off && width < of_two_columns) {
    figure = narrow_figure(make, options);
  } else if (figure.width > width + round_off) {
    options.width = width * column_width / page_width;  // of which a broad figure makes the whole
    figure = make(options);
    figure.width = width;  // but for round-off
  }
  bound_height(figure, page_height);
  if (width >= of_two_columns || layout(figure).height <= page_height + round_off) return figure;
  Figure beside = make(options);  // where panels one below another take more than a page
  if (beside.columns != 2) return figure;
  beside.width = width;
  bound_height(beside, page_height);
  return layout(beside).height < layout(figure).height ? beside : figure;
}

}  // namespace bentur
