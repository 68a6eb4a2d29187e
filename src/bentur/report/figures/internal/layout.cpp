#include "bentur/report/figures/internal/layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bentur/report/figures/internal/text.h"

namespace bentur {
namespace {

constexpr double label_room = 0.45;     // of an axis' label
constexpr double edge = 0.3;            // free to the right of a frame
constexpr double map_room = 1.95;       // of a colour scale with its numbers and label
constexpr double events_height = 0.09;  // of the frame, kept free for marks along its upper edge

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double value, bool positive_only) {
    if (!std::isfinite(value) || (positive_only && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void take(const std::vector<double>& values, bool positive_only) {
    for (const double value : values) take(value, positive_only);
  }
};

/// Names stand where there is room for all of them, else numbers.
Ticks ticks_of(const Axis& axis, Range range, int most) {
  if (!axis.names.empty()) return named_ticks(axis.names, axis.names.size() > static_cast<std::size_t>(most), most);
  return make_ticks({range.low, range.high, axis.from, axis.to, axis.logarithmic, most});
}

Ticks x_ticks(const Panel& panel, int most) {
  Range range;
  for (const Curve& curve : panel.curves) range.take(curve.x, panel.x.logarithmic);
  for (const Rule& rule : panel.rules) {
    if (rule.vertical) range.take(rule.at, panel.x.logarithmic);
  }
  if (panel.map) range.take(panel.map->x_edges, panel.x.logarithmic);
  return ticks_of(panel.x, range, most);
}

/// Only what lies between the ends of the x axis counts.
Ticks y_ticks(const Panel& panel, int most) {
  Range range;
  const double from = panel.x.from.value_or(-std::numeric_limits<double>::infinity());
  const double to = panel.x.to.value_or(std::numeric_limits<double>::infinity());
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!(curve.x[i] >= from && curve.x[i] <= to)) continue;
      range.take(curve.y[i], panel.y.logarithmic);
      if (!curve.top.empty()) range.take(curve.top[i], panel.y.logarithmic);
    }
  }
  for (const Rule& rule : panel.rules) {
    if (!rule.vertical) range.take(rule.at, panel.y.logarithmic);
  }
  if (panel.map) range.take(panel.map->y_edges, panel.y.logarithmic);
  if (!panel.events.x.empty() && !panel.y.to && panel.y.names.empty()) {
    range.high += events_height * std::max(range.high - range.low, 0.0);
  }
  return ticks_of(panel.y, range, most);
}

std::vector<LegendEntry> entries(const Panel& panel) {
  std::vector<LegendEntry> list;
  for (const Curve& curve : panel.curves) {
    if (curve.label.empty()) continue;
    list.push_back({.label = plain_text(curve.label),
                    .tone = curve.tone,
                    .line = curve.line,
                    .mark = curve.mark,
                    .width = curve.width,
                    .area = !curve.top.empty()});
  }
  for (const Rule& rule : panel.rules) {
    if (!rule.label.empty()) list.push_back({.label = plain_text(rule.label), .tone = rule.tone, .line = rule.line});
  }
  if (!panel.events.label.empty() && !panel.events.x.empty()) {
    list.push_back({.label = plain_text(panel.events.label), .tone = Tone::grey, .event = true});
  }
  return list;
}

/// Rows and columns of a legend in a given width; too long labels are cut.
struct Grid {
  int columns = 1, rows = 0;
  double step = 0;
};
Grid fit(std::vector<LegendEntry>& list, double width) {
  if (list.empty()) return {};
  constexpr double around = sample_width + 0.35;
  const auto most = static_cast<std::size_t>(std::max(4.0, (width - sample_width - 0.1) / character_width));
  std::size_t longest = 0;
  for (LegendEntry& entry : list) {
    entry.label = cut(entry.label, most);
    longest = std::max(longest, length_of(entry.label));
  }
  Grid grid;
  grid.step = around + static_cast<double>(longest) * character_width;
  const int count = static_cast<int>(list.size());
  grid.columns = std::clamp(static_cast<int>((width + 0.25) / grid.step), 1, count);
  grid.rows = (count + grid.columns - 1) / grid.columns;
  grid.columns = (count + grid.rows - 1) / grid.rows;
  return grid;
}

void place(std::vector<LegendEntry>& list, const Grid& grid, double left, double top) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::size_t column = i % static_cast<std::size_t>(grid.columns);
    const std::size_t row = i / static_cast<std::size_t>(grid.columns);
    list[i].x = left + static_cast<double>(column) * grid.step;
    list[i].y = top - (static_cast<double>(row) + 0.5) * line_height;
  }
}

/// Panels of one row or column of the figure have margins alike.
class Arrangement {
 public:
  explicit Arrangement(const Figure& figure) : figure_(figure), columns_(std::max(1, figure.columns)) {}

  Layout make() {
    for (const Panel& panel : figure_.panels) {
      PlacedPanel placed;
      placed.panel = &panel;
      placed.y = y_ticks(panel, std::max(2, static_cast<int>(panel.height / 0.55)));
      result_.panels.push_back(placed);
    }
    place_columns();
    place_rows();
    return result_;
  }

 private:
  void place_columns() {
    std::vector<double> left(columns_, 0.0), right(columns_, edge);
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      const Panel& panel = *result_.panels[i].panel;
      const double room = (panel.y.label.empty() ? 0.1 : label_room) + 0.2 +
                          static_cast<double>(result_.panels[i].y.longest()) * character_width;
      left[i % columns_] = std::max(left[i % columns_], room);
      if (panel.map) right[i % columns_] = map_room;
    }
    double free = figure_.width;
    for (std::size_t c = 0; c < columns_; ++c) free -= left[c] + right[c];
    const double width = std::max(1.0, free / static_cast<double>(columns_));
    double at = 0;
    for (std::size_t c = 0; c < columns_; ++c) {
      for (std::size_t i = c; i < result_.panels.size(); i += columns_) {
        PlacedPanel& placed = result_.panels[i];
        placed.cell_left = at;
        placed.left = at + left[c];
        placed.right = placed.left + width;
        int most = 10;
        do {  // fewer numbers until they do not touch
          placed.x = x_ticks(*placed.panel, most--);
        } while (most > 1 && crowded(placed.x, width));
      }
      at += left[c] + width + right[c];
    }
  }

  static bool crowded(const Ticks& ticks, double width) {
    const auto place = [&](double at) {
      return ticks.logarithmic ? std::log(at / ticks.from) / std::log(ticks.to / ticks.from)
                               : (at - ticks.from) / (ticks.to - ticks.from);
    };
    for (std::size_t i = 1; i < ticks.labels.size(); ++i) {
      const double apart = (place(ticks.labels[i].first) - place(ticks.labels[i - 1].first)) * width;
      const double text =
          static_cast<double>(length_of(ticks.labels[i].second) + length_of(ticks.labels[i - 1].second)) / 2 *
          character_width;
      if (apart < text + 0.2) return true;
    }
    return false;
  }

  /// What the labels along the upright axes need.
  static double label_height(const PlacedPanel& placed) {
    const std::string& map = placed.panel->map ? placed.panel->map->label : placed.panel->y.label;
    const std::size_t longest = std::max(length_of(scaled(placed.panel->y.label, placed.y)), length_of(map));
    return static_cast<double>(longest) * character_width;
  }

  /// From the top down; the height of the whole comes out at the end.
  void place_rows() {
    double at = 0.1;  // from the upper edge down
    const std::size_t count = result_.panels.size();
    if (figure_.shared_legend && count > 0) {
      PlacedPanel& first = result_.panels.front();
      first.legend = entries(*first.panel);
      const Grid grid = fit(first.legend, figure_.width - first.left - 0.1);
      place(first.legend, grid, first.left, -at);
      at += grid.rows * line_height;
    }
    for (std::size_t row = 0; row < count; row += columns_) {
      const std::size_t end = std::min(row + columns_, count);
      double height = 0;
      double bottom = 0;
      int legend_rows = 0;
      bool titles = false;
      std::vector<Grid> grids(end - row);
      for (std::size_t i = row; i < end; ++i) {
        PlacedPanel& placed = result_.panels[i];
        if (!figure_.shared_legend) {
          placed.legend = entries(*placed.panel);
          grids[i - row] = fit(placed.legend, placed.right - placed.left + edge - 0.1);
          legend_rows = std::max(legend_rows, grids[i - row].rows);
        }
        titles = titles || !placed.panel->title.empty();
        height = std::max({height, placed.panel->height, label_height(placed)});
        bottom = std::max(bottom, 0.55 + (placed.panel->x.label.empty() ? 0 : label_room));
      }
      if (titles) {
        for (std::size_t i = row; i < end; ++i) result_.panels[i].title_y = -(at + line_height / 2);
        at += line_height;
      }
      for (std::size_t i = row; i < end && !figure_.shared_legend; ++i) {
        place(result_.panels[i].legend, grids[i - row], result_.panels[i].left, -at);
      }
      at += legend_rows * line_height + 0.1;
      for (std::size_t i = row; i < end; ++i) {
        result_.panels[i].top = -at;
        result_.panels[i].bottom = -(at + height);
      }
      at += height + bottom + 0.1;
    }
    result_.width = figure_.width;
    result_.height = at;
    for (PlacedPanel& placed : result_.panels) {
      for (double* y : {&placed.top, &placed.bottom, &placed.title_y}) *y += at;
      for (LegendEntry& entry : placed.legend) entry.y += at;
    }
  }

  const Figure& figure_;
  std::size_t columns_;
  Layout result_;
};

}  // namespace

Layout layout(const Figure& figure) { return Arrangement(figure).make(); }

}  // namespace bentur
