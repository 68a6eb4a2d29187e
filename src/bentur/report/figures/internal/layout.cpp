#include "bentur/report/figures/internal/layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/utf8.h"

namespace bentur {
namespace {

constexpr double label_room = 0.45;     // of an axis' label
constexpr double edge = 0.3;            // free to the right of a frame
constexpr double map_room = 1.95;       // of a colour scale with its numbers and label
constexpr double events_height = 0.09;  // of the frame, kept free for marks along its upper edge

double text_width(const std::string& text) { return static_cast<double>(display_width(text)) * character_width; }

/// Of names all stand where there is room for them, else numbers. Along y only what lies between the ends of the x axis
/// counts.
Ticks ticks_of(const Panel& panel, bool is_upright, int most) {
  const Axis& axis = is_upright ? panel.y : panel.x;
  if (!axis.names.empty()) return named_ticks(axis.names, axis.names.size() > static_cast<std::size_t>(most), most);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity;
  double high = -infinity;
  const auto take = [&](double value) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!is_upright) {
        take(curve.x[i]);
      } else if (curve.x[i] >= panel.x.from.value_or(-infinity) && curve.x[i] <= panel.x.to.value_or(infinity)) {
        take(curve.y[i]);
        if (!curve.top.empty()) take(curve.top[i]);
      }
    }
  }
  for (const Rule& rule : panel.rules) {
    if (rule.vertical != is_upright) take(rule.at);
  }
  if (panel.map) {
    for (const double at : is_upright ? panel.map->y_edges : panel.map->x_edges) take(at);
  }
  if (is_upright && !panel.events.x.empty() && !axis.to) high += events_height * std::max(high - low, 0.0);
  return make_ticks({low, high, axis.from, axis.to, axis.logarithmic, most});
}

/// Whether two numbers of an axis of this length come too near to one another.
bool is_crowded(const Ticks& ticks, double length) {
  const auto place = [&](double at) {
    return ticks.logarithmic ? std::log(at / ticks.from) / std::log(ticks.to / ticks.from)
                             : (at - ticks.from) / (ticks.to - ticks.from);
  };
  for (std::size_t i = 1; i < ticks.labels.size(); ++i) {
    const auto& [at, text] = ticks.labels[i];
    const auto& [before, other] = ticks.labels[i - 1];
    if ((place(at) - place(before)) * length < (text_width(text) + text_width(other)) / 2 + 0.2) return true;
  }
  return false;
}

std::vector<LegendEntry> entries(const Panel& panel) {
  std::vector<LegendEntry> list;
  const auto add = [&](LegendEntry entry) {
    entry.label = plain_text(entry.label);
    if (!entry.label.empty()) list.push_back(std::move(entry));
  };
  for (const Curve& curve : panel.curves) {
    add({curve.label, curve.tone, curve.line, curve.mark, curve.width, !curve.top.empty()});
  }
  for (const Rule& rule : panel.rules) add({.label = rule.label, .tone = rule.tone, .line = rule.line});
  if (!panel.events.x.empty()) add({.label = panel.events.label, .tone = Tone::grey, .event = true});
  return list;
}

/// Cuts labels that are too long, and places the entries in rows and columns within a width, x and y measured from the
/// upper left corner. @return the height they take.
double arrange(std::vector<LegendEntry>& list, double width) {
  if (list.empty()) return 0;
  double longest = 0;
  for (LegendEntry& entry : list) {
    entry.label =
        cut(entry.label, static_cast<std::size_t>(std::max(4.0, (width - sample_width - 0.1) / character_width)));
    longest = std::max(longest, text_width(entry.label));
  }
  const double step = sample_width + 0.35 + longest;
  const auto fitting = std::min(static_cast<std::size_t>(std::max(1.0, (width + 0.25) / step)), list.size());
  const std::size_t rows = (list.size() + fitting - 1) / fitting;
  const std::size_t columns = (list.size() + rows - 1) / rows;
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].x = static_cast<double>(i % columns) * step;
    const std::size_t row = i / columns;
    list[i].y = -(static_cast<double>(row) + 0.5) * line_height;
  }
  return static_cast<double>(rows) * line_height;
}

void shift(std::vector<LegendEntry>& list, double right, double up) {
  for (LegendEntry& entry : list) {
    entry.x += right;
    entry.y += up;
  }
}

/// Panels of one row or column of the figure have margins alike.
class Arrangement {
 public:
  explicit Arrangement(const Figure& figure)
      : figure_(figure), columns_(static_cast<std::size_t>(std::max(1, figure.columns))) {
    result_.width = figure.width;
    for (const Panel& panel : figure.panels) {
      const int most = std::max(2, static_cast<int>(panel.height / 0.55));
      result_.panels.push_back({.panel = &panel, .y = ticks_of(panel, true, most)});
    }
  }

  Layout make() {
    place_columns();
    for (std::size_t row = 0; row < result_.panels.size(); row += columns_) {
      place_row(row, std::min(row + columns_, result_.panels.size()));
    }
    result_.height = depth_;
    for (PlacedPanel& placed : result_.panels) {  // measured from the upper edge so far
      for (double* y : {&placed.top, &placed.bottom, &placed.title_y}) *y += depth_;
      shift(placed.legend, 0, depth_);
    }
    return std::move(result_);
  }

 private:
  void place_columns() {
    std::vector<double> left(columns_, 0.0), right(columns_, edge);
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      const Panel& panel = *result_.panels[i].panel;
      double numbers = character_width;
      for (const auto& [at, text] : result_.panels[i].y.labels) numbers = std::max(numbers, text_width(text));
      left[i % columns_] = std::max(left[i % columns_], (panel.y.label.empty() ? 0.1 : label_room) + 0.2 + numbers);
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
          placed.x = ticks_of(*placed.panel, false, most--);
        } while (most > 1 && is_crowded(placed.x, width));
      }
      at += left[c] + width + right[c];
    }
  }

  /// Legends, titles and frames of panels `begin` to `end`, below what is placed already.
  void place_row(std::size_t begin, std::size_t end) {
    double legend = 0;
    double frame = 0;
    double below = 0;  // for numbers and label of the x axis
    bool is_titled = false;
    for (std::size_t i = begin; i < end; ++i) {
      PlacedPanel& placed = result_.panels[i];
      const Panel& panel = *placed.panel;
      if (!figure_.shared_legend || i == 0) {
        placed.legend = entries(panel);
        const double right = figure_.shared_legend ? figure_.width : placed.right + edge;
        legend = std::max(legend, arrange(placed.legend, right - placed.left - 0.1));
      }
      is_titled = is_titled || !panel.title.empty();
      frame = std::max({frame, panel.height, text_width(scaled(panel.y.label, placed.y)),
                        text_width(panel.map ? panel.map->label : "")});
      below = std::max(below, 0.55 + (panel.x.label.empty() ? 0 : label_room));
    }
    const double title = is_titled ? line_height : 0;
    const double above = figure_.shared_legend && begin == 0 ? legend : 0;  // all titles
    for (std::size_t i = begin; i < end; ++i) {
      PlacedPanel& placed = result_.panels[i];
      placed.title_y = -(depth_ + above + line_height / 2);
      shift(placed.legend, placed.left, -(depth_ + (above > 0 ? 0 : title)));
      placed.top = -(depth_ + title + legend + 0.1);
      placed.bottom = placed.top - frame;
    }
    depth_ += title + legend + 0.1 + frame + below + 0.1;
  }

  const Figure& figure_;
  std::size_t columns_;
  double depth_ = 0.1;  // of what is placed, from the upper edge
  Layout result_;
};

}  // namespace

Layout layout(const Figure& figure) { return Arrangement(figure).make(); }

}  // namespace bentur
