#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/studies/sweep_data.h"

namespace bentur {
namespace {

constexpr std::size_t most_owner_curves = 6;  // points or floors drawn one by one
constexpr std::size_t most_level_curves = 4;  // values of a second parameter drawn as curves, not as a map

/// "Model 1" out of the long name of the floors, where it stands in quotes.
std::string building_name(const NetcdfReader& results, std::size_t number, const FigureWords& say) {
  const StoredVariable* floors = results.find(fmt::format("elevation_{}", number));
  if (floors != nullptr) {
    const std::string& text = floors->long_name;
    const std::size_t first = text.find('"');
    const std::size_t last = text.rfind('"');
    if (first < last && last != std::string::npos) return text.substr(first + 1, last - first - 1);
  }
  return word(say, "building {}", std::to_string(number));
}

/// One number for all points or floors; NaN where there is none.
double joined(const std::vector<double>& values, bool sum) {
  double result = NAN;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    result = std::isnan(result) ? value : sum ? result + value : std::max(result, value);
  }
  return result;
}

/// Draws one kind with what is left free of a sweep's dimensions.
class SweepDrawing {
 public:
  SweepDrawing(const SweepData& sweep, const SweepKind& kind, const FigureOptions& options)
      : sweep_(sweep), kind_(kind), options_(options), at_(sweep.chosen(options.at)) {
    for (std::size_t d = 0; d < at_.size(); ++d) {
      if (at_[d] == sweep.dimensions()[d].size) free_.push_back(d);
    }
  }

  Figure make() {
    const std::vector<SweepVariable> found = variables_of(sweep_.results(), kind_.quantity);
    Figure figure{.title = kind_.label, .width = options_.width};
    together_ = std::any_of(found.begin(), found.end(), [&](const SweepVariable& one) {
      return sweep_.owner_names(one.name).size() > most_owner_curves;
    });
    for (const SweepVariable& one : found) {
      Panel panel = this->panel(one.name);
      if (is_empty(panel)) continue;  // ratios of a building that stands still unless it is struck
      if (found.size() > 1) panel.title = building_name(sweep_.results(), one.building, options_.say);
      const std::string fixed = chosen_text();
      if (!fixed.empty() && figure.panels.empty()) {
        panel.title = panel.title.empty() ? fixed : panel.title + ", " + fixed;
      }
      figure.panels.push_back(std::move(panel));
    }
    if (figure.panels.empty()) throw NoFigure("no run has a value of this kind");
    for (Panel& panel : figure.panels) {
      if (&panel == &figure.panels.back()) break;
      panel.x.label = "";
      panel.x.numbers = panel.x.names.empty();  // names stand below the last panel alone
    }
    if (takes_a_page(figure)) figure.width *= page_over_column;
    figure.shared_legend = figure.panels.size() > 1 && same_legends(figure);
    share_range(figure);
    return figure;
  }

 private:
  static bool is_empty(const Panel& panel) {
    const auto nothing = [](const std::vector<double>& values) {
      return std::none_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    };
    return (!panel.map || nothing(panel.map->values)) &&
           std::all_of(panel.curves.begin(), panel.curves.end(), [&](const Curve& one) { return nothing(one.y); });
  }

  static bool same_legends(const Figure& figure) {
    const auto& first = figure.panels.front().curves;
    return std::all_of(figure.panels.begin(), figure.panels.end(), [&](const Panel& panel) {
      return std::equal(panel.curves.begin(), panel.curves.end(), first.begin(), first.end(),
                        [](const Curve& a, const Curve& b) { return a.label == b.label; });
    });
  }

  /// Whether the names along the x axis need a page's width to stand upright.
  static bool takes_a_page(const Figure& figure) {
    constexpr std::size_t most_in_column = 18;
    constexpr std::size_t most_in_page = 42;
    return std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& panel) {
      return panel.x.names.size() > most_in_column && panel.x.names.size() <= most_in_page;
    });
  }

  /// Maps of a ratio have colours alike.
  static void share_range(Figure& figure) {
    std::optional<std::pair<double, double>> range;
    for (const Panel& panel : figure.panels) {
      if (!panel.map || !panel.map->ratio) continue;
      for (const double value : panel.map->values) {
        if (!std::isfinite(value)) continue;
        if (!range) range.emplace(value, value);
        range = {std::min(range->first, value), std::max(range->second, value)};
      }
    }
    for (Panel& panel : figure.panels) {
      if (panel.map && panel.map->ratio) panel.map->range = range;
    }
  }

  /// What stays fixed: "gap 0.15 m, Sa 0.4 g".
  [[nodiscard]] std::string chosen_text() const {
    std::vector<std::string> texts;
    for (std::size_t d = 0; d < at_.size(); ++d) {
      const SweepDimension& one = sweep_.dimensions()[d];
      const bool is_free = std::find(free_.begin(), free_.end(), d) != free_.end();
      if (!is_free && one.size > 1 && at_[d] < one.size) texts.push_back(one.choice(at_[d]));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  [[nodiscard]] bool in_percent() const { return kind_.quantity == "peak_drift_ratio"; }
  [[nodiscard]] bool is_ratio() const {
    return kind_.quantity == "amplification" || kind_.quantity == "acceleration_ratio" ||
           kind_.quantity == "storey_shear_ratio";
  }

  [[nodiscard]] std::string label(const std::string& quantity) const {
    const std::string unit = in_percent() ? "%" : unit_text(sweep_.results().at(quantity).units);
    return with_unit(word(options_, kind_.label), unit.empty() ? "–" : unit);
  }

  /// In the unit of the label.
  [[nodiscard]] std::vector<double> values(const std::string& quantity, const std::vector<std::size_t>& at) const {
    std::vector<double> result = sweep_.values(quantity, at);
    for (double& value : result) value *= in_percent() ? 100 : 1;
    return result;
  }

  /// Fixes all but the two directions that vary most, in the middle of numbers and at the first of names.
  void choose() {
    std::stable_sort(free_.begin(), free_.end(), [&](std::size_t a, std::size_t b) {
      const SweepDimension &one = sweep_.dimensions()[a], &other = sweep_.dimensions()[b];
      return one.is_text() != other.is_text() ? !one.is_text() : one.size > other.size;
    });
    while (free_.size() > 2) {
      const SweepDimension& last = sweep_.dimensions()[free_.back()];
      at_[free_.back()] = last.is_text() ? 0 : last.size / 2;
      free_.pop_back();
    }
  }

  /// The names of what is left free.
  [[nodiscard]] std::string choices() const {
    std::vector<std::string> names;
    for (const std::size_t d : free_) names.push_back(sweep_.dimensions()[d].name);
    return fmt::format("{}", fmt::join(names, ", "));
  }

  Panel panel(const std::string& quantity) {
    if (!sweep_.dimensions().empty() && sweep_.dimensions()[0].name == "sample") return samples(quantity);
    if (!options_.against.empty()) put_first(options_.against);
    if (free_.empty()) throw NoFigure("nothing is left to vary");
    if (free_.size() > 2 && options_.choose) choose();
    if (free_.size() > 2) {
      throw NoFigure(fmt::format("{} vary: fix all but one or two, with --at NAME=VALUE", choices()));
    }
    if (free_.size() == 1) return curves(quantity);
    if (options_.against.empty()) {  // numbers before names, and many before few
      const SweepDimension& a = sweep_.dimensions()[free_[0]];
      const SweepDimension& b = sweep_.dimensions()[free_[1]];
      if (a.is_text() ? !b.is_text() : (!b.is_text() && b.size > a.size)) std::swap(free_[0], free_[1]);
    }
    const SweepDimension& second = sweep_.dimensions()[free_[1]];
    const bool map = second.size > most_level_curves && sweep_.dimensions()[free_[0]].size > 1;
    return map ? this->map(quantity) : families(quantity);
  }

  void put_first(const std::string& name) {
    const auto found =
        std::find_if(free_.begin(), free_.end(), [&](std::size_t d) { return sweep_.dimensions()[d].name == name; });
    if (found == free_.end()) throw NoFigure(fmt::format("--against {}: what varies is {}", name, choices()));
    std::rotate(free_.begin(), found, found + 1);
  }

  Axis x_axis() const {
    const SweepDimension& one = sweep_.dimensions()[free_[0]];
    Axis axis{.label = one.label, .number = word(options_, "number")};
    if (one.is_text()) {
      axis.names = one.texts;
    } else {
      axis.from = *std::min_element(one.numbers.begin(), one.numbers.end());
      axis.to = *std::max_element(one.numbers.begin(), one.numbers.end());
    }
    return axis;
  }

  /// Places of a dimension's values by ascending x.
  [[nodiscard]] std::vector<std::size_t> ascending(std::size_t d) const {
    const SweepDimension& one = sweep_.dimensions()[d];
    std::vector<std::size_t> order(one.size);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return one.place(a) < one.place(b); });
    return order;
  }

  /// Values along the first free dimension, of one owner or all together, by ascending x.
  Curve curve(const std::string& quantity, std::optional<std::size_t> owner) {
    const std::size_t d = free_[0];
    Curve result;
    for (const std::size_t i : ascending(d)) {
      at_[d] = i;
      const std::vector<double> values = this->values(quantity, at_);
      result.x.push_back(sweep_.dimensions()[d].place(i));
      result.y.push_back(owner ? values[*owner] : joined(values, kind_.sum));
    }
    return result;
  }

  void style(Curve& curve, std::size_t index) const {
    tell_apart(curve, index);
    if (sweep_.dimensions()[free_[0]].is_text()) {
      curve.line = Line::none;
      curve.mark = mark_of(index);
    }
  }

  Panel framed(const std::string& quantity) const {
    Panel panel{.x = x_axis(), .y = {.label = label(quantity)}, .height = 4.6};
    if (is_ratio()) {
      panel.rules = {{.at = 1}};
      panel.y.least = {0.95, 1.05};
    } else {
      panel.y.from = 0;
    }
    return panel;
  }

  Panel curves(const std::string& quantity) {
    Panel panel = framed(quantity);
    const std::vector<std::string> names = sweep_.owner_names(quantity);
    if (together_) {
      Curve all = curve(quantity, std::nullopt);
      style(all, 0);
      all.label = word(options_, kind_.sum ? "all together" : "largest of all");
      panel.curves.push_back(all);
    }
    for (std::size_t i = 0; i < names.size() && !together_; ++i) {
      Curve one = curve(quantity, i);
      style(one, i);
      one.label = names.size() > 1 ? names[i] : "";
      if (std::any_of(one.y.begin(), one.y.end(), [](double y) { return std::isfinite(y); })) {
        panel.curves.push_back(std::move(one));
      }
    }
    return panel;
  }

  /// One curve for each value of the second dimension.
  Panel families(const std::string& quantity) {
    Panel panel = framed(quantity);
    const std::size_t d = free_[1];
    const SweepDimension& second = sweep_.dimensions()[d];
    for (std::size_t i = 0; i < second.size; ++i) {
      at_[d] = i;
      Curve one = curve(quantity, std::nullopt);
      style(one, i);
      one.label = second.choice(i);
      panel.curves.push_back(std::move(one));
    }
    at_[d] = second.size;
    return panel;
  }

  /// Edges of cells around places: half way, or for names half a step.
  [[nodiscard]] std::vector<double> edges(std::size_t d, const std::vector<std::size_t>& order) const {
    std::vector<double> places;
    for (const std::size_t i : order) places.push_back(sweep_.dimensions()[d].place(i));
    std::vector<double> list = {places[0] - (places[1] - places[0]) / 2};
    for (std::size_t i = 0; i + 1 < places.size(); ++i) list.push_back((places[i] + places[i + 1]) / 2);
    list.push_back(places.back() + (places.back() - places[places.size() - 2]) / 2);
    return list;
  }

  Panel map(const std::string& quantity) {
    const std::size_t x = free_[0];
    const std::size_t y = free_[1];
    const std::vector<std::size_t> columns = ascending(x);
    const std::vector<std::size_t> rows = ascending(y);
    HeatMap map;
    map.x_edges = edges(x, columns);
    map.y_edges = edges(y, rows);
    map.label = label(quantity);
    map.ratio = is_ratio();
    for (const std::size_t row : rows) {
      for (const std::size_t column : columns) {
        at_[x] = column;
        at_[y] = row;
        map.values.push_back(joined(values(quantity, at_), kind_.sum));
      }
    }
    at_[x] = sweep_.dimensions()[x].size;
    at_[y] = sweep_.dimensions()[y].size;
    const auto axis = [&](std::size_t d, const std::vector<double>& edges) {
      const SweepDimension& one = sweep_.dimensions()[d];
      return Axis{.label = one.label,
                  .from = edges.front(),
                  .to = edges.back(),
                  .names = one.texts,
                  .number = word(options_, "number")};
    };
    constexpr std::size_t most_names = 45;  // below one another
    const std::size_t names = sweep_.dimensions()[y].texts.size();
    const double height = names > most_names ? 4.6 : std::max(4.6, line_height * static_cast<double>(names));
    return {.x = axis(x, map.x_edges), .y = axis(y, map.y_edges), .height = height, .map = map};
  }

  /// A mark for every sample.
  Panel samples(const std::string& quantity) {
    const std::vector<SweepDimension> coordinates = sweep_.sample_coordinates();
    const auto x = std::find_if(coordinates.begin(), coordinates.end(), [&](const SweepDimension& one) {
      return options_.against.empty() ? !one.is_text() : one.name == options_.against;
    });
    if (x == coordinates.end()) {
      throw NoFigure(fmt::format("--against NAME must be one of {}", fmt::join(names_of(coordinates), ", ")));
    }
    Curve marks{.line = Line::none, .mark = Mark::circle};
    for (std::size_t i = 0; i < x->size; ++i) {
      marks.x.push_back(x->place(i));
      marks.y.push_back(joined(values(quantity, {i}), kind_.sum));
    }
    return {.x = {.label = x->label, .names = x->texts, .number = word(options_, "number")},
            .y = {.label = label(quantity)},
            .height = 4.6,
            .curves = {marks}};
  }

  const SweepData& sweep_;
  const SweepKind& kind_;
  const FigureOptions& options_;
  std::vector<std::size_t> at_, free_;
  bool together_ = false;  // points or floors are too many to be drawn one by one
};

}  // namespace

std::vector<SweepVariable> variables_of(const NetcdfReader& results, const std::string& quantity) {
  if (results.find(quantity) != nullptr) return {{quantity}};
  std::vector<SweepVariable> found;
  for (std::size_t b = 1; results.find(fmt::format("elevation_{}", b)) != nullptr; ++b) {
    std::string name = fmt::format("{}_{}", quantity, b);
    if (results.find(name) != nullptr) found.push_back({std::move(name), b});
  }
  return found;
}

const std::vector<SweepKind>& sweep_kinds() {
  static const std::vector<SweepKind> kinds = {
      {"peak-force", "peak_force", "Peak contact force F"},
      {"amplification", "amplification", "Amplification of max |x|"},
      {"contact-duration", "contact_duration", "Time in contact", true},
      {"impacts", "impacts", "Impacts", true},
      {"penetration", "peak_penetration", "Peak penetration δ"},
      {"impulse", "impulse", "Impulse of all impacts", true},
      {"displacement", "peak_displacement", "max |x|"},
      {"acceleration", "peak_acceleration", "Peak floor acceleration"},
      {"acceleration-ratio", "acceleration_ratio", "Floor acceleration, ratio"},
      {"shear", "peak_storey_shear", "Peak storey shear V"},
      {"shear-ratio", "storey_shear_ratio", "Storey shear, ratio"},
      {"drift", "peak_drift_ratio", "Peak storey drift Δ/h"},
  };
  return kinds;
}

Figure sweep_figure(const SweepData& sweep, const SweepKind& kind, const FigureOptions& options) {
  return SweepDrawing(sweep, kind, options).make();
}

}  // namespace bentur
