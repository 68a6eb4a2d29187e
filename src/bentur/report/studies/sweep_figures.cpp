#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/studies/sweep_data.h"
#include "bentur/study/quantiles.h"

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

/// Draws one kind with what is left free of a sweep's dimensions.
class SweepDrawing {
 public:
  SweepDrawing(const SweepData& sweep, const SweepKind& kind, const FigureOptions& options)
      : sweep_(sweep), kind_(kind), options_(options), at_(sweep.chosen(options.at)) {
    for (std::size_t d = 0; d < at_.size(); ++d) {
      if (at_[d] == sweep.dimensions()[d].size) free_.push_back(d);
    }
    take_records_together();
  }

  Figure make() {
    const std::vector<SweepVariable> found = variables_of(sweep_.results(), kind_.quantity);
    Figure figure{.title = kind_.label, .width = options_.width};
    together_ = !records_.empty() || std::any_of(found.begin(), found.end(), [&](const SweepVariable& one) {
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
    if (takes_a_page(figure)) figure.width = broad(figure.width);
    figure.shared_legend = figure.panels.size() > 1 && same_legends(figure);
    share_range(figure);
    if (most_ && least_) {
      if (!records_.empty())
        figure.finding = word(options_, "median of {} records", std::to_string(record_count_)) + ": ";
      figure.finding +=
          word(options_, "largest {} at {}, smallest {} at {}", most_->text, most_->place, least_->text, least_->place);
    }
    return figure;
  }

 private:
  /// Where more varies than the records, and there are some, their median and fractiles are shown in place of each.
  void take_records_together() {
    constexpr std::size_t fewest = 3;
    std::size_t count = 1;
    std::vector<std::size_t> records, others;
    for (const std::size_t d : free_) {
      const SweepDimension& one = sweep_.dimensions()[d];
      (one.is_of_records ? records : others).push_back(d);
      if (one.is_of_records) count *= one.size;
      if (one.is_of_records && one.name == options_.against) return;
    }
    if (others.empty() || count < fewest) return;
    free_ = others;
    records_ = records;
    record_count_ = count;
  }

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

  /// Several maps of one quantity have colours alike, so that panels can be compared.
  static void share_range(Figure& figure) {
    std::map<std::string, std::pair<double, double>> ranges;
    const auto is_alone = [&](const Panel& panel) {
      return std::count_if(figure.panels.begin(), figure.panels.end(),
                           [&](const Panel& other) { return other.map && other.map->label == panel.map->label; }) == 1;
    };
    for (const Panel& panel : figure.panels) {
      if (!panel.map || (is_alone(panel) && !panel.map->ratio)) continue;
      for (const double value : panel.map->values) {
        if (!std::isfinite(value)) continue;
        auto& range = ranges.try_emplace(panel.map->label, value, value).first->second;
        range = {std::min(range.first, value), std::max(range.second, value)};
      }
    }
    for (Panel& panel : figure.panels) {
      if (!panel.map) continue;
      if (const auto found = ranges.find(panel.map->label); found != ranges.end()) panel.map->range = found->second;
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
    if (!records_.empty() && free_.size() > 1) {
      texts.push_back(word(options_, "medians of {} records", std::to_string(record_count_)));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  [[nodiscard]] bool in_percent() const { return kind_.quantity == "peak_drift_ratio"; }
  [[nodiscard]] bool is_ratio() const {
    return kind_.quantity == "amplification" || kind_.quantity == "acceleration_ratio" ||
           kind_.quantity == "storey_shear_ratio";
  }

  [[nodiscard]] std::string unit_of(const std::string& quantity) const {
    return in_percent() ? "%" : sweep_.unit(quantity);
  }

  [[nodiscard]] std::string label(const std::string& quantity) const {
    const std::string unit = unit_of(quantity);
    return with_unit(word(options_, kind_.label), unit.empty() ? "–" : unit);
  }

  /// What values are multiplied by for the unit of the label.
  [[nodiscard]] double factor() const { return in_percent() ? 100 : 1; }

  /// A fractile over the records at a place; NaN where there is none, or so many were cut short.
  [[nodiscard]] double fractile(const std::string& quantity, double part) const {
    std::vector<double> all;
    for (const std::vector<std::size_t>& at : sweep_.combinations(at_, records_)) {
      const double value = sweep_.is_cut_short(at) ? INFINITY : sweep_.joined(quantity, at, kind_.sum);
      if (!std::isnan(value)) all.push_back(value);
    }
    const double found = all.empty() ? NAN : quantile_of(all, part);
    return std::isfinite(found) ? found * factor() : NAN;
  }

  /// What is shown of a place in one number, taken into account for what the figure tells.
  double told(const std::string& quantity, std::optional<std::size_t> owner) {
    const double value = !records_.empty() ? fractile(quantity, 0.5)
                         : owner           ? factor() * sweep_.values(quantity, at_)[*owner]
                                           : factor() * sweep_.joined(quantity, at_, kind_.sum);
    std::vector<std::string> places;
    for (const std::size_t d : free_) {
      const SweepDimension& one = sweep_.dimensions()[d];
      if (one.size > 1) places.push_back(one.choice(at_[d]));
    }
    take_into_account(value, quantity, fmt::format("{}", fmt::join(places, ", ")));
    return value;
  }

  void take_into_account(double value, const std::string& quantity, const std::string& place) {
    if (!std::isfinite(value)) return;
    const std::string unit = unit_of(quantity);
    const Extreme found{value, number(value) + (unit.empty() || unit == "–" ? "" : " " + unit), place};
    if (!most_ || value > most_->value) most_ = found;
    if (!least_ || value < least_->value) least_ = found;
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
      result.x.push_back(sweep_.dimensions()[d].place(i));
      result.y.push_back(told(quantity, owner));
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
    Panel panel{.x = x_axis(), .y = {.label = label(quantity)}, .height = 4.6, .names_at_ends = true};
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
      const std::size_t d = free_[0];
      Curve all = curve(quantity, std::nullopt);
      style(all, 0);
      all.label = word(options_, kind_.sum ? "all together" : "largest of all");
      if (!records_.empty()) {
        if (names.size() > 1) panel.title = all.label;
        all.label = word(options_, "median of {} records", std::to_string(record_count_));
        add_fractiles(panel, quantity, all);
      }
      at_[d] = sweep_.dimensions()[d].size;
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

  /// The 16 and 84 % fractiles over the records beside their median: an area, or beside several, and along names, bars
  /// and lines that stay apart where they cross.
  void add_fractiles(Panel& panel, const std::string& quantity, const Curve& median, bool is_one_of_some = false) {
    const std::size_t d = free_[0];
    Curve band{.label = panel.curves.empty() ? word(options_, "16 to 84 %") : "",
               .x = median.x,
               .tone = is_one_of_some ? median.tone : Tone::pale,
               .of_several = true};
    for (const std::size_t i : ascending(d)) {
      at_[d] = i;
      band.y.push_back(fractile(quantity, 0.16));
      band.top.push_back(fractile(quantity, 0.84));
    }
    const bool along_names = sweep_.dimensions()[d].is_text();
    if (!is_one_of_some && !along_names) {
      panel.curves.push_back(std::move(band));
      return;
    }
    Curve lower = band, upper = band;
    for (Curve* bound : {&lower, &upper}) {
      bound->top.clear();
      bound->width = 0.7;
      bound->line = along_names ? Line::none : Line::dotted;
      bound->mark = along_names ? Mark::triangle : Mark::none;
      bound->tone = along_names ? Tone::grey : median.tone;
    }
    upper.y = band.top;
    upper.label.clear();
    panel.curves.push_back(std::move(lower));
    panel.curves.push_back(std::move(upper));
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
      if (!records_.empty()) add_fractiles(panel, quantity, one, true);
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

  /// The cells of a map where nothing touches, taken out of it: they have a tint of their own.
  [[nodiscard]] std::optional<Curve> without_contact(HeatMap& map) const {
    Curve cells{.label = word(options_, "no contact"), .tone = Tone::pale};
    const std::size_t columns = map.x_edges.size() - 1;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      if (map.values[i] != 0) continue;
      map.values[i] = NAN;
      const std::size_t row = i / columns, column = i % columns;
      cells.x.insert(cells.x.end(), {map.x_edges[column], map.x_edges[column + 1], not_known});
      cells.y.insert(cells.y.end(), {map.y_edges[row], map.y_edges[row], not_known});
      cells.top.insert(cells.top.end(), {map.y_edges[row + 1], map.y_edges[row + 1], not_known});
    }
    return cells.x.empty() ? std::nullopt : std::optional(std::move(cells));
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
        map.values.push_back(told(quantity, std::nullopt));
      }
    }
    std::optional<Curve> apart;
    if (kind_.of_contact) apart = without_contact(map);
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
    Panel panel{.x = axis(x, map.x_edges), .y = axis(y, map.y_edges), .height = height, .map = map};
    if (apart) panel.curves.push_back(std::move(*apart));
    const auto is_known = [](double value) { return std::isfinite(value); };
    if (apart && std::none_of(map.values.begin(), map.values.end(), is_known)) {
      panel.map.reset();
      panel.note = word(options_, "no contact");
    }
    return panel;
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
      marks.y.push_back(factor() * sweep_.joined(quantity, {i}, kind_.sum));
      take_into_account(marks.y.back(), quantity, x->choice(i));
    }
    return {.x = {.label = x->label, .names = x->texts, .number = word(options_, "number")},
            .y = {.label = label(quantity)},
            .height = 4.6,
            .curves = {marks}};
  }

  /// A value and where it is.
  struct Extreme {
    double value = 0;
    std::string text, place;
  };
  std::optional<Extreme> most_, least_;

  const SweepData& sweep_;
  const SweepKind& kind_;
  const FigureOptions& options_;
  std::vector<std::size_t> at_, free_;
  std::vector<std::size_t> records_;  // dimensions whose fractiles are shown
  std::size_t record_count_ = 0;
  bool together_ = false;  // points or floors are too many to be drawn one by one
};

}  // namespace

Figure sweep_figure(const SweepData& sweep, const SweepKind& kind, const FigureOptions& options) {
  return SweepDrawing(sweep, kind, options).make();
}

}  // namespace bentur
