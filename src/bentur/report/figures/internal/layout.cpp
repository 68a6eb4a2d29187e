#include "bentur/report/figures/internal/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/figures/internal/visible.h"

namespace bentur {
namespace {

constexpr double label_room = 0.45;     // of an axis' label
constexpr double edge = 0.3;            // free to the right of a frame
constexpr double beside_number = 0.14;  // free beside the first and the last number of an x axis
constexpr double beside_label = 0.1;    // free on both sides of an x axis' label
constexpr double beyond_label = 0.3;    // free below the rows before one that begins others
constexpr double scale_width = 0.45;    // of a map's colours with the room to its left

/// The value below which so large a part of the others lies.
double percentile(std::vector<double> values, double part) {
  const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// Of ratios from `low` to `high`, and of 1: a half is as far from it as 2.
Ticks ratio_scale(double low, double high) {
  constexpr double least = 1.05;
  low = std::min(low > 0 ? low : 1, 1.0);
  high = std::max(high, 1.0);
  if (high / low < least) {
    low /= least;
    high *= least;
  }
  constexpr double narrow = 3;  // round numbers, evenly apart, are near enough to one another
  const bool is_narrow = std::max(high, 1 / low) <= narrow;
  Ticks ticks = make_ticks({.low = low, .high = high, .from = low, .to = high, .logarithmic = !is_narrow, .most = 6});
  ticks.logarithmic = true;
  return ticks;
}

/// The numbers of a map's colours.
Ticks scale_of(const HeatMap& map) {
  std::vector<double> values;
  std::copy_if(map.values.begin(), map.values.end(), std::back_inserter(values),
               [](double value) { return std::isfinite(value); });
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  double low = map.range ? map.range->first : *least;
  double high = map.range ? map.range->second : *most;
  if (map.ratio) return ratio_scale(low, high);
  constexpr double squashed = 0.1;
  const bool some_squash_others = !map.range && low > 0 && percentile(values, 0.5) < squashed * high;
  if (!some_squash_others) return make_ticks({.low = low, .high = high, .most = 6});
  // From end to end: to a whole decade much of the bar could be of no cell.
  return make_ticks({.low = low, .high = high, .from = low, .to = high, .logarithmic = true, .most = 6});
}

/// Of names all stand where there is room for them, else numbers. Along y only what lies between the ends of the x axis
/// counts.
Ticks ticks_of(const Panel& panel, bool is_upright, int most) {
  const Axis& axis = is_upright ? panel.y : panel.x;
  if (!axis.names.empty() && !panel.to_scale) {
    const double room = is_upright ? line_height * static_cast<double>(axis.names.size()) : 0;
    return named_ticks(axis.names, is_upright ? room > panel.height * (1 + 1e-9) : std::ssize(axis.names) > most, most);
  }
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
  for (const RuleLine& rule : panel.rules) {
    if (rule.vertical != is_upright) take(rule.at);
  }
  if (panel.map) {
    for (const double at : is_upright ? panel.map->y_edges : panel.map->x_edges) take(at);
  }
  if (is_upright && !panel.events.x.empty() && !axis.to) high += events_height * std::max(high - low, 0.0);
  if (panel.to_scale) return {.from = axis.from.value_or(low), .to = axis.to.value_or(high)};
  const bool plain = is_upright && !axis.places.empty();  // levels are said as they are
  Ticks ticks = make_ticks({low, high, axis.from, axis.to, axis.logarithmic, most, axis.least, plain});
  if (is_upright) put_at(ticks, axis.places, line_height / panel.height);
  if (!axis.numbers) ticks.exponent = 0;  // that of a neighbour
  return ticks;
}

/// Whether two numbers of an axis of this length come nearer to one another than is clear [cm].
bool is_crowded(const Ticks& ticks, double length, double clear = 0.2) {
  for (std::size_t i = 1; i < ticks.labels.size(); ++i) {
    const auto& [at, text] = ticks.labels[i];
    const auto& [before, other] = ticks.labels[i - 1];
    if ((along(ticks, at) - along(ticks, before)) * length < (text_width(text) + text_width(other)) / 2 + clear) {
      return true;
    }
  }
  return false;
}

/// Makes the scale of a panel's axes one: the longer way fills its frame, the other way it stands in the middle.
void fit(PlacedPanel& placed) {
  const double width = placed.right - placed.left, height = placed.top - placed.bottom;
  Ticks &x = placed.x, &y = placed.y;
  const double scale = std::max((x.to - x.from) / width, (y.to - y.from) / height);
  const auto widen = [](Ticks& axis, double length) {
    const double beside = (length - (axis.to - axis.from)) / 2;
    axis.from -= beside;
    axis.to += beside;
  };
  widen(x, scale * width);
  widen(y, scale * height);
}

/// Panels of one row or column of the figure have margins alike, but for names along upright axes.
class Arrangement {
 public:
  explicit Arrangement(const Figure& figure)
      : figure_(figure), columns_(static_cast<std::size_t>(std::max(1, figure.columns))) {
    result_.width = figure.width;
    std::vector<std::size_t> taken(columns_, 0);  // rows of each column
    for (const Panel& panel : figure.panels) {
      const std::size_t across = std::clamp<std::size_t>(static_cast<std::size_t>(panel.across), 1, columns_);
      if (panel.begins_row) std::fill(taken.begin(), taken.end(), *std::max_element(taken.begin(), taken.end()));
      const auto column = across > 1 ? taken.begin() : std::min_element(taken.begin(), taken.end());
      const auto beyond = column + static_cast<std::ptrdiff_t>(across);
      const std::size_t row = *std::max_element(column, beyond);
      const auto first = static_cast<std::size_t>(column - taken.begin());
      cells_.push_back({.row = row, .column = first, .last = first + across - 1});
      std::fill(column, beyond, row + static_cast<std::size_t>(panel.rows));
      rows_ = std::max(rows_, *column);
      const int most = std::max(2, static_cast<int>(panel.height / 0.55));
      result_.panels.push_back({.panel = &panel, .y = ticks_of(panel, true, most)});
    }
  }

  Layout make() {
    place_columns();
    for (PlacedPanel& placed : result_.panels) {
      placed.names = names_at_ends(*placed.panel, placed.x, placed.y, placed.right - placed.left, placed.panel->height);
    }
    // One way of naming in a figure: where one name has no room all stand in the legend.
    const auto lacks = [](const PlacedPanel& placed) { return lacks_names(*placed.panel, placed.names); };
    if (std::any_of(result_.panels.begin(), result_.panels.end(), lacks)) {
      for (PlacedPanel& placed : result_.panels) placed.names.clear();
    }
    for (std::size_t row = 0; row < rows_; ++row) place_row(row);
    for (PlacedPanel& placed : result_.panels) {
      if (placed.panel->to_scale) fit(placed);
    }
    result_.height = depth_;
    for (PlacedPanel& placed : result_.panels) {  // measured from the upper edge so far
      for (double* y : {&placed.top, &placed.bottom, &placed.title_y, &placed.x_label_y}) *y += depth_;
      shift(placed.legend, 0, depth_);
    }
    return std::move(result_);
  }

 private:
  struct Cell {
    std::size_t row = 0, column = 0;
    std::size_t last = 0;    // column
    double of_names = 0;     // what names along its upright axis take beyond the numbers of others in the column [cm]
    bool has_names = false;  // beside the frame or within it, so that there are none to the right
  };

  void place_columns() {
    std::vector<double> left(columns_, 0.0), right(columns_, edge);
    std::vector<double> labelled(columns_, 0.0);  // room of the numbers that a label stands beside
    std::vector<double> of_names(columns_, 0.0);  // along the upright axes
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      PlacedPanel& placed = result_.panels[i];
      const Panel& panel = *placed.panel;
      double numbers = 0;
      for (const auto& [at, text] : placed.y.labels) numbers = std::max(numbers, text_width(text));
      if (!panel.y.numbers) numbers = 0;
      const bool has_names = !panel.y.names.empty();
      double& before = (has_names ? of_names : left)[cells_[i].column];
      const bool has_label = !scaled(panel.y.label, placed.y).empty();
      before = std::max(before, (has_label ? label_room : 0.1) + 0.2 + numbers);
      if (has_label) labelled[cells_[i].column] = std::max(labelled[cells_[i].column], 0.2 + numbers);
      right[cells_[i].last] = std::max(right[cells_[i].last], room_of_names(panel));
      if (!panel.map) continue;
      placed.scale = scale_of(*panel.map);
      double widest = 0;
      for (const auto& [at, text] : placed.scale.labels) widest = std::max(widest, text_width(text));
      double& behind = right[cells_[i].last];
      behind = std::max(behind, scale_width + 0.2 + widest + 0.1 + label_room);
    }
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {  // frames beside numbers are not in line with names
      const std::size_t c = cells_[i].column;
      if (left[c] == 0) left[c] = of_names[c];
      const Panel& panel = *result_.panels[i].panel;
      if (!panel.y.names.empty()) cells_[i].of_names = std::max(0.0, of_names[c] - left[c]);
      cells_[i].has_names = !panel.y.names.empty() || panel.to_scale;
    }
    constexpr int attempts = 3;  // until the numbers at the ends of the x axes have room
    for (int attempt = 0; attempt < attempts; ++attempt) {
      place_frames(left, right);
      for (std::size_t i = 0; i < result_.panels.size(); ++i) {
        const PlacedPanel& placed = result_.panels[i];
        if (placed.x.labels.empty() || placed.x.upright || placed.panel->to_scale) continue;
        const auto beyond = [&](const auto& label, double of_end) {
          return text_width(label.second) / 2 -
                 std::abs(of_end - along(placed.x, label.first)) * (placed.right - placed.left) + beside_number;
        };
        double &before = left[cells_[i].column], &behind = right[cells_[i].last];
        before = std::max(before, beyond(placed.x.labels.front(), 0));
        behind = std::max(behind, beyond(placed.x.labels.back(), 1));
      }
    }
    place_frames(left, right);
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      PlacedPanel& placed = result_.panels[i];
      placed.y_label_x = placed.left - labelled[cells_[i].column] - label_room + 0.25;
    }
  }

  void place_frames(const std::vector<double>& left, const std::vector<double>& right) {
    double free = figure_.width;
    for (std::size_t c = 0; c < columns_; ++c) free -= left[c] + right[c];
    const std::vector<double> alike(columns_, 1.0);
    const std::vector<double>& shares = figure_.shares.size() == columns_ ? figure_.shares : alike;
    const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::vector<double> begins{0};  // of the columns
    for (std::size_t c = 0; c < columns_; ++c) {
      begins.push_back(begins.back() + left[c] + std::max(1.0, free * shares[c] / whole) + right[c]);
    }
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      PlacedPanel& placed = result_.panels[i];
      const auto& [row, first, last, of_names, has_names] = cells_[i];
      placed.cell_left = begins[first];
      placed.left = begins[first] + (placed.panel->to_scale ? edge : left[first] + of_names);
      placed.cell_right = begins[last + 1];
      placed.right = placed.cell_right - (has_names ? std::min(right[last], 1.5 * edge) : right[last]);
      place_numbers(placed, placed.right - placed.left);
    }
  }

  /// Fewer numbers until they do not touch; names that would are turned, as long as they are not too many.
  static void place_numbers(PlacedPanel& placed, double width) {
    const std::vector<std::string>& names = placed.panel->x.names;
    if (placed.panel->to_scale) {
      placed.x = ticks_of(*placed.panel, false, 2);
      place_names(placed, width);
      return;
    }
    if (!names.empty()) {
      placed.x = named_ticks(names, false, static_cast<int>(names.size()));
      if (!is_crowded(placed.x, width)) return;
      placed.x.upright = true;
      if (static_cast<double>(names.size()) * line_height * 0.9 <= width) return;
    }
    int most = 10;
    do {
      placed.x = ticks_of(*placed.panel, false, most--);
    } while (most > 1 && is_crowded(placed.x, width));
    std::vector<double> places = placed.panel->x.places;
    while (places.size() > 2) {  // else every second of them
      Ticks asked = placed.x;
      put_at(asked, places, 0);
      if (!is_crowded(asked, width)) {
        placed.x = asked;
        return;
      }
      for (std::size_t i = 1; 2 * i < places.size(); ++i) places[i] = places[2 * i];
      places.resize((places.size() + 1) / 2);
    }
  }

  /// Names below a picture of things, each below its own: in one line, in short where there are such names, in two or
  /// three lines by turns, or upright; where there is no room even so, of every second, third, … alone.
  static void place_names(PlacedPanel& placed, double width) {
    const Axis& axis = placed.panel->x;
    constexpr double longest = 3;  // [cm]
    const std::size_t count = std::min(axis.names.size(), axis.places.size());
    if (count == 0) return;
    Ticks& x = placed.x;
    const double scale = std::max((x.to - x.from) / width, (placed.y.to - placed.y.from) / placed.panel->height);
    const double length = (x.to - x.from) / scale;  // of what is drawn [cm]
    const auto labelled = [&](std::size_t stride, const std::vector<std::string>& names) {
      x.labels.clear();
      for (std::size_t i = 0; i < count; i += stride) x.labels.emplace_back(axis.places[i], cut_to(names[i], longest));
    };
    const auto fit_in = [&](int lines, double clear = 0.2) {
      for (int line = 0; line < lines; ++line) {
        Ticks of_line{.from = x.from, .to = x.to};
        for (auto i = static_cast<std::size_t>(line); i < count; i += static_cast<std::size_t>(lines)) {
          of_line.labels.push_back(x.labels[i]);
        }
        if (is_crowded(of_line, length, clear)) return false;
      }
      return true;
    };
    x.lines = 1;
    if (axis.short_names.size() == count) {
      for (const std::vector<std::string>* const names : {&axis.names, &axis.short_names}) {
        labelled(1, *names);
        if (fit_in(1, 0.1)) return;
      }
    }
    labelled(1, axis.names);
    for (; x.lines <= 3; ++x.lines) {
      if (fit_in(x.lines)) return;
    }
    x.lines = 1;
    x.upright = true;
    const auto touch = [&](const auto& a, const auto& b) {
      return (along(x, b.first) - along(x, a.first)) * length < 0.9 * line_height;
    };
    std::size_t stride = 1;
    do labelled(stride++, axis.names);
    while (std::adjacent_find(x.labels.begin(), x.labels.end(), touch) != x.labels.end());
  }

  /// Room below a frame for the numbers or names along it [cm].
  static double numbers_room(const PlacedPanel& placed) {
    if (placed.panel->to_scale ? placed.x.labels.empty() : !placed.panel->x.numbers) return 0.1;
    double room = 0.55 + line_height * (placed.x.lines - 1);
    if (placed.x.upright) {
      for (const auto& [at, text] : placed.x.labels) room = std::max(room, 0.3 + text_width(text));
    }
    return room;
  }

  /// Legends, titles and frames of the panels of a row, below what is placed already; of those that go on below it what
  /// stands above their frames.
  void place_row(std::size_t row) {
    const std::vector<std::size_t> begun = panels_where([&](std::size_t i) { return cells_[i].row == row; });
    if (row > 0 && !begun.empty() && result_.panels[begun.front()].panel->begins_row) depth_ += beyond_label;
    double legend = 0;
    double frame = 0;
    double numbers = 0.1, below = 0;  // room of the numbers and of the label of the x axis
    std::size_t titles = 0;
    std::vector<double> legends;  // heights, of the panels of the row
    for (const std::size_t i : begun) {
      PlacedPanel& placed = result_.panels[i];
      const Panel& panel = *placed.panel;
      if (!figure_.shared_legend) {
        add_entries(placed, placed.legend);
        legends.push_back(arrange(placed.legend, placed.cell_right - placed.left - 0.1));
        legend = std::max(legend, legends.back());
      } else if (i == 0) {
        for (const PlacedPanel& each : result_.panels) add_entries(each, placed.legend);
        std::stable_partition(placed.legend.begin(), placed.legend.end(), [](const auto& one) { return !one.event; });
        legend = arrange(placed.legend, figure_.width - placed.left - 0.1);
        centre(placed.legend, (result_.panels[begun.back()].right - placed.left) / 2,
               figure_.width - placed.left - 0.1);
      }
      placed.title = lines_of(plain_text(panel.title), placed.right - placed.left + 0.2, most_lines);
      titles = std::max(titles, placed.title.size());
      if (panel.rows > 1) continue;
      frame = std::max({frame, height_of(placed), text_width(scaled(panel.y.label, placed.y, panel.y.number)),
                        text_width(panel.map ? scaled(panel.map->label, placed.scale) : "")});
      numbers = std::max(numbers, numbers_room(placed));
      const std::string label = plain_text(scaled(panel.x.label, placed.x, panel.x.number));
      const auto [from, to] = span_of_label(placed, begun);
      placed.x_label = lines_of(label, to - from - 2 * beside_label, 3);
      below = std::max(below, 0.07 + line_height * static_cast<double>(placed.x_label.size()));
    }
    const double title = static_cast<double>(titles) * line_height;
    const double above = figure_.shared_legend && row == 0 ? legend : 0;  // all titles
    // Beside one that goes on below it what a panel has above its frame stands at the frame.
    const bool at_frames = !figure_.shared_legend && std::any_of(begun.begin(), begun.end(), [&](std::size_t i) {
      return result_.panels[i].panel->rows > 1;
    });
    for (std::size_t k = 0; k < begun.size(); ++k) {
      const std::size_t i = begun[k];
      PlacedPanel& placed = result_.panels[i];
      const double lower = at_frames ? legend - legends[k] : 0;
      const double of_title = line_height * static_cast<double>(placed.title.size());
      placed.title_y = -(depth_ + above + line_height / 2 + (at_frames ? lower + title - of_title : 0));
      shift(placed.legend, placed.left, -(depth_ + lower + (above > 0 ? 0 : title)));
      placed.top = -(depth_ + title + legend + 0.1);
      placed.bottom = placed.top - frame;
      placed.x_label_y = placed.bottom - numbers - 0.03 - line_height / 2;
      double widest = 0;
      for (const std::string& text : placed.x_label) widest = std::max(widest, text_width(text));
      const auto [from, to] = span_of_label(placed, begun);
      const bool is_of_row = from < placed.cell_left || to > placed.cell_right;
      const double middle = is_of_row ? (result_.panels[begun.front()].left + result_.panels[begun.back()].right) / 2
                                      : (placed.left + placed.right) / 2;
      const double room = widest / 2 + beside_label;
      placed.x_label_x = std::max(from + room, std::min(middle, to - room));
      placed.scale_label_x = placed.cell_right - 0.22;
    }
    const double bottom = -(depth_ + title + legend + 0.1 + frame);
    const auto ends = [&](std::size_t i) {
      return result_.panels[i].panel->rows > 1 &&
             cells_[i].row + static_cast<std::size_t>(result_.panels[i].panel->rows) == row + 1;
    };
    for (const std::size_t i : panels_where(ends)) {
      PlacedPanel& placed = result_.panels[i];
      placed.bottom = bottom + std::max(0.0, numbers_room(placed) - numbers - below);
    }
    depth_ = -bottom + numbers + below + 0.1;
  }

  /// Along x, where the label of an axis may stand: below its panel, or of one alone below all panels of a row.
  [[nodiscard]] std::pair<double, double> span_of_label(const PlacedPanel& placed,
                                                        const std::vector<std::size_t>& row) const {
    const auto is_other = [&](std::size_t i) {
      const Panel& panel = *result_.panels[i].panel;
      return panel.to_scale || panel.map || panel.rows > 1 || !panel.x.numbers ||
             (&panel != placed.panel && !panel.x.label.empty());
    };
    constexpr std::size_t least = 3;
    const bool is_alone =
        row.size() >= least && !placed.panel->x.label.empty() && std::none_of(row.begin(), row.end(), is_other);
    if (!is_alone) return {placed.cell_left, placed.cell_right};
    return {result_.panels[row.front()].cell_left, result_.panels[row.back()].cell_right};
  }

  template <typename Condition>
  [[nodiscard]] std::vector<std::size_t> panels_where(const Condition& holds) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < result_.panels.size(); ++i) {
      if (holds(i)) found.push_back(i);
    }
    return found;
  }

  /// Of a frame; of a picture of things no higher than these at the width there is.
  [[nodiscard]] static double height_of(const PlacedPanel& placed) {
    if (!placed.panel->to_scale) return placed.panel->height;
    const double needed = (placed.y.to - placed.y.from) / (placed.x.to - placed.x.from) * (placed.right - placed.left);
    return std::min(placed.panel->height, needed);
  }

  const Figure& figure_;
  std::size_t columns_, rows_ = 0;
  std::vector<Cell> cells_;  // of the panels
  double depth_ = 0.1;       // of what is placed, from the upper edge
  Layout result_;
};

}  // namespace

std::vector<std::string> text_lines(const PlaceText& one, const PlacedPanel& placed) {
  if (!(one.room > 0)) return {one.text};
  const double room = one.room / (placed.x.to - placed.x.from) * (placed.right - placed.left);
  std::vector<std::string> lines = lines_of(plain_text(one.text), room, 3);
  const auto is_wide = [&](const std::string& line) { return line.ends_with("…") && line != one.text; };
  if (std::any_of(lines.begin(), lines.end(), is_wide)) lines.clear();
  return lines;
}

std::vector<std::string> part_lines(const Figure& figure, const Layout& layout) {
  return lines_of(plain_text(figure.part), layout.width - 0.4, 4);
}

double room_of_part(const std::vector<std::string>& lines) {
  return lines.empty() ? 0 : 0.1 + line_height * static_cast<double>(lines.size());
}

double text_x(const PlaceText& one, const std::vector<std::string>& lines, const Ticks& x, double width) {
  const double at = along(x, one.x) * width;
  if (one.side != PlaceText::Side::above && one.side != PlaceText::Side::below) return at;
  constexpr double clear = 0.14;  // of the frame and its ticks
  double half = 0;
  for (const std::string& text : lines) half = std::max(half, text_width(text) / 2 + clear);
  return std::clamp(at, half, std::max(half, width - half));
}

double colour_at(const HeatMap& map, const Ticks& scale, double along) {
  if (!map.ratio) return along;
  const double reach = std::log(std::max(scale.to, 1 / scale.from));
  const double begin = std::log(scale.from) / reach, end = std::log(scale.to) / reach;
  return (1 + begin + along * (end - begin)) / 2;
}

Layout layout(const Figure& figure) {
  check(figure);
  return Arrangement(figure).make();
}

}  // namespace bentur
