#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

constexpr Eigen::Index most_modes = 3;

double frame_height(const RunResults& run, const std::vector<Eigen::Index>& shown) {
  std::size_t floors = 0;
  for (const Eigen::Index b : shown) floors = std::max(floors, run.problem.buildings[b].model.elevations.size());
  return floors > 8 ? 7.5 : floors > 1 ? 5 : 2;
}

/// Elevation, the same for all panels of a figure. @param above what is free above the highest floor, of the height
Axis elevation_axis(const RunResults& run, const FigureOptions& options, const std::vector<Eigen::Index>& shown,
                    double above = 0.03) {
  Axis axis{.label = with_unit(word(options, "Level z"), run.c.units.length)};
  axis.from = base_of(run.problem.buildings[shown.front()]);
  for (const Eigen::Index b : shown) axis.from = std::min(*axis.from, base_of(run.problem.buildings[b]));
  std::vector<double> levels = {*axis.from};
  for (const Eigen::Index b : shown) {
    const Building& building = run.problem.buildings[b];
    levels.insert(levels.end(), building.model.elevations.begin(), building.model.elevations.end());
  }
  std::sort(levels.begin(), levels.end());
  const double top = levels.back();
  axis.to = top + above * (top - *axis.from);
  const auto same = [&](double a, double b) { return b - a <= 1e-6 * (top - *axis.from); };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  axis.places = std::move(levels);
  return axis;
}

/// A panel of curves over the height, which have their names where they end, of the highest building above it.
Panel height_panel(const RunResults& run, const FigureOptions& options, const std::vector<Eigen::Index>& shown, Axis x,
                   double rule) {
  constexpr double name = 0.5;  // [cm]
  const double height = frame_height(run, shown);
  return {.x = std::move(x),
          .y = elevation_axis(run, options, shown, name / (height - name)),
          .height = height,
          .rules = {{.at = rule, .vertical = true}},
          .names_at_ends = true};
}

/// Ends an axis from 0 on a number that is easily quartered, with numbers at each quarter.
void end_round(Axis& axis, double largest) {
  if (!(largest > 0)) largest = 1;
  const double power = std::pow(10.0, std::floor(std::log10(largest)));
  for (const double digits : {1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0}) {
    if (digits * power < 1.02 * largest) continue;
    axis.from = 0;
    axis.to = digits * power;
    axis.places = {0, *axis.to / 4, *axis.to / 2, 3 * *axis.to / 4, *axis.to};
    return;
  }
}

/// Those of the buildings shown that do not move with the ground.
std::vector<Eigen::Index> moving(const RunResults& run, const FigureOptions& options) {
  std::vector<Eigen::Index> shown = shown_buildings(run, options, most_apart);
  std::erase_if(shown, [&](Eigen::Index b) { return run.problem.buildings[b].is_rigid(); });
  if (shown.empty()) throw NoFigure("every building shown moves with the ground");
  return shown;
}

/// One panel for each building, each as wide as `room` [cm] at least; where a row of more than two has no room the
/// figure takes a page's width, and then more rows.
Figure beside(const RunResults& run, const FigureOptions& options, const std::vector<Eigen::Index>& shown,
              double room) {
  constexpr double of_axis = 1.2, above = 1.5;  // numbers and label of the elevations, title and numbers of a row [cm]
  Figure figure{.width = options.width};
  const auto fitting = [&] {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::max(0.0, figure.width - of_axis) / room));
  };
  if (!options.narrow && shown.size() > 2 && fitting() < shown.size()) figure.width = broad(figure.width);
  const std::size_t rows = (shown.size() + fitting() - 1) / fitting();
  const std::size_t columns = (shown.size() + rows - 1) / rows;
  figure.columns = static_cast<int>(columns);
  const Axis elevation = elevation_axis(run, options, shown);
  const double highest = page_height / static_cast<double>(rows) - above;
  const double height = options.narrow ? frame_height(run, shown) : std::min(frame_height(run, shown), highest);
  for (std::size_t b = 0; b < shown.size(); ++b) {
    Panel panel{.title = run.problem.buildings[shown[b]].name, .y = elevation, .height = height};
    if (b % columns != 0) leave_to_neighbour(panel.y);
    if (!options.narrow && rows > 2 && b / columns != rows / 2) panel.y.label = "";  // one for all rows
    figure.panels.push_back(panel);
  }
  return figure;
}

/// Whether the panel has the label of the axes below: of rows of three or more the middle one of the last row, else all
/// of the last row, as there is nothing below the middle of two.
bool is_labelled(std::size_t panel, std::size_t count, int columns) {
  const auto of_row = static_cast<std::size_t>(columns), last = (count - 1) / of_row * of_row;
  return of_row < 3 ? panel + of_row >= count : panel == std::min(last + of_row / 2, count - 1);
}

/// A curve from the base, which does not move, up; with marks where there are few floors.
Curve over_height(const Building& building, const Eigen::VectorXd& values, Curve curve) {
  curve.x = {0};
  curve.y = {base_of(building)};
  curve.x.insert(curve.x.end(), values.begin(), values.end());
  curve.y.insert(curve.y.end(), building.model.elevations.begin(), building.model.elevations.end());
  if (building.model.elevations.size() > 20) curve.mark = Mark::none;
  return curve;
}

/// A curve through those floors that have a value.
Curve at_floors(const Building& building, const std::vector<double>& values) {
  Curve curve{.label = building.name};
  for (std::size_t floor = 0; floor < values.size(); ++floor) {
    if (std::isnan(values[floor])) continue;
    curve.x.push_back(values[floor]);
    curve.y.push_back(building.model.elevations[floor]);
  }
  return curve;
}

/// The same of storeys, each one value from the floor below it to its own: steps.
Curve over_storeys(const Building& building, const std::vector<double>& values) {
  Curve curve{.label = building.name};
  double below = base_of(building);
  for (std::size_t storey = 0; storey < values.size(); ++storey) {
    const double above = building.model.elevations[storey];
    for (const double level : {below, above}) {
      if (std::isnan(values[storey])) continue;
      curve.x.push_back(values[storey]);
      curve.y.push_back(level);
    }
    below = above;
  }
  return curve;
}

/// Made by over_storeys().
bool is_stepped(const Curve& curve) {
  bool is = curve.x.size() % 2 == 0;
  for (std::size_t i = 0; i + 1 < curve.x.size(); i += 2) is = is && curve.x[i] == curve.x[i + 1];
  return is;
}

constexpr std::size_t most_dashes = 4;  // of so many curves none has those of another; of more marks tell them apart

/// Of several buildings shown: in the tone of this one, with a mark that no other one of them has, and with dashes that
/// none has whose tone is as dark.
void tell_apart(Curve& curve, const std::vector<Tone>& tones, const std::vector<Eigen::Index>& shown,
                Eigen::Index building) {
  const auto tone = [&](std::size_t place) { return tones[shown[place]]; };
  const auto place = static_cast<std::size_t>(std::find(shown.begin(), shown.end(), building) - shown.begin());
  std::size_t alike = 0;  // before it
  for (std::size_t other = 0; other < place; ++other) alike += are_distinct_in_grey(tone(other), tone(place)) ? 0 : 1;
  bentur::tell_apart(curve, place, tone(place));
  Curve dashes;
  bentur::tell_apart(dashes, alike);
  curve.line = dashes.line;
  curve.width = dashes.width;
}

/// More curves than can be followed in one frame have one each, side by side at one scale, whose titles name them; of
/// more than six half of them below the others, if that leaves none over or they are more than eight; narrow ones two
/// side by side, or as many as it takes for the figure to be no higher than a page.
void set_apart(Figure& figure, bool narrow) {
  constexpr std::size_t in_one_frame = 3;
  const std::size_t count = figure.panels.front().curves.size();
  const bool are_alike = std::all_of(figure.panels.begin(), figure.panels.end(),
                                     [&](const Panel& one) { return one.curves.size() == count; });
  if (count <= in_one_frame || !are_alike) return;
  constexpr double highest = 5, beside = 1.5;  // of a frame [cm], of its title and numbers [cm]
  constexpr std::size_t most_narrow = 4;
  const std::size_t most_beside = figure.panels.size() > 1 ? 6 : 5;  // so that each has room for four numbers
  const auto rows_of = [&](std::size_t columns) { return figure.panels.size() * ((count + columns - 1) / columns); };
  const std::size_t rows_beside = (count + most_beside - 1) / most_beside;
  std::size_t columns = narrow ? 2 : (count + rows_beside - 1) / rows_beside;
  const auto are_high = [&] { return static_cast<double>(rows_of(columns)) * (highest + beside) > page_height; };
  while (narrow && columns < most_narrow && are_high()) ++columns;
  const std::size_t rows = rows_of(columns);
  const double most_high = std::max(2.0, std::min(highest, page_height / static_cast<double>(rows) - beside));
  std::vector<Panel> panels;
  for (const Panel& all : figure.panels) {
    double from = all.rules.front().at, to = from;
    for (const Curve& curve : all.curves) {
      from = std::min(from, *std::min_element(curve.x.begin(), curve.x.end()));
      to = std::max(to, *std::max_element(curve.x.begin(), curve.x.end()));
    }
    const double margin = 0.06 * (to - from);
    for (std::size_t i = 0; i < count; ++i) {
      Panel one = all;
      one.names_at_ends = false;
      one.title = all.curves[i].label;
      one.curves = {all.curves[i]};
      one.curves.front().label = "";
      one.curves.front().line = Line::solid;
      if (is_stepped(one.curves.front())) one.curves.front().mark = Mark::none;
      one.x.from = all.x.from.value_or(from == 0 ? 0 : from - margin);
      one.x.to = to + margin;
      if (!is_labelled(i, count, static_cast<int>(columns))) one.x.label = "";
      if (rows > 1) one.height = std::min(one.height, most_high);
      one.y = figure.panels.front().y;
      one.begins_row = i == 0;
      if (i % columns != 0) leave_to_neighbour(one.y);
      panels.push_back(std::move(one));
    }
  }
  figure.panels = std::move(panels);
  figure.columns = static_cast<int>(columns);
  if (!narrow) figure.width = broad(figure.width);
}

/// A quantity of the floors of a building, the lowest first.
std::vector<double> of_floors(const RunResults& run, const Quantity& quantity, Eigen::Index building) {
  const RunView view = run.view();
  std::vector<double> values(run.problem.buildings[building].model.elevations.size(), NAN);
  for (const QuantityPlace& at : floors_of(run.problem, building)) values[at.floor] = value_of(quantity, view, at);
  return values;
}

/// The largest of values told of floors, and where.
struct Largest {
  double value = NAN;
  Eigen::Index building = 0;
  double level = 0;

  void take(const RunResults& run, Eigen::Index of, const std::vector<double>& values) {
    for (std::size_t floor = 0; floor < values.size(); ++floor) {
      if (std::isnan(values[floor]) || values[floor] <= value) continue;
      value = values[floor];
      building = of;
      level = run.problem.buildings[of].model.elevations[floor];
    }
  }
  /// "Model 1, level 300 cm".
  [[nodiscard]] std::string place(const RunResults& run, const FigureOptions& options) const {
    return run.problem.buildings[building].name + ", " + word(options, "level {}", shown_value(run, level, "L"));
  }
};

}  // namespace

Figure envelope_figure(const RunResults& run, const FigureOptions& options) {
  const std::vector<Eigen::Index> shown = moving(run, options);
  constexpr std::size_t most_in_a_row = 6;
  Figure figure = beside(run, options, shown, !options.narrow && shown.size() > most_in_a_row ? 3.6 : 2);
  const bool has_impacts = !run.response.impacts.empty();  // else the responses with and without contact are one
  figure.title = "Largest displacements relative to the bases";
  if (has_impacts) figure.title += ", with and without contact";
  figure.shared_legend = true;
  double largest = 0;
  Largest most;
  for (const Eigen::Index b : shown) {
    const BuildingPeaks& peaks = run.response.buildings[b];
    largest = std::max({largest, peaks.displacement.maxCoeff(), peaks.displacement_no_contact.maxCoeff()});
    most.take(run, b, {peaks.displacement.begin(), peaks.displacement.end()});
  }
  figure.finding = word(options, "largest {}: {}", shown_value(run, most.value, "L"), most.place(run, options));
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const Building& building = run.problem.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    if (is_labelled(b, shown.size(), figure.columns)) {
      panel.x.label = with_unit(word(options, "Displacement max |x|"), run.c.units.length);
    }
    end_round(panel.x, largest);
    const Curve with{.label = word(options, has_impacts ? "with contact" : "largest displacement"), .mark = Mark::disc};
    const Curve without{.label = word(options, "without contact"),
                        .tone = Tone::grey,
                        .line = Line::dashed,
                        .mark = Mark::circle,
                        .width = 1.2};
    const BuildingPeaks& peaks = run.response.buildings[shown[b]];
    panel.curves = {over_height(building, peaks.displacement, with)};
    if (has_impacts) panel.curves.push_back(over_height(building, peaks.displacement_no_contact, without));
  }
  return figure;
}

Figure amplification_figure(const RunResults& run, const FigureOptions& options) {
  const Quantity& amplification = quantity_named("amplification", Owner::floor);
  const std::vector<Eigen::Index> shown = shown_buildings(run, options, most_apart);
  const std::vector<Tone> tones = tones_of(run, options);
  Panel panel =
      height_panel(run, options, shown,
                   {.label = word(options, "Amplification of max |x| by contact [–]"), .least = {{0.95, 1.05}}}, 1);
  Largest most;
  for (const Eigen::Index b : shown) {
    const Building& building = run.problem.buildings[b];
    const std::vector<double> values = of_floors(run, amplification, b);
    most.take(run, b, values);
    Curve curve = at_floors(building, values);
    tell_apart(curve, tones, shown, b);
    if (!curve.x.empty()) panel.curves.push_back(curve);
  }
  if (panel.curves.empty()) throw NoFigure("nothing moves without contact, so that there is no amplification");
  Figure figure{.title = "Largest displacement with contact over that without",
                .finding = word(options, "largest {}: {}", number(most.value), most.place(run, options)),
                .panels = {panel},
                .width = options.width};
  set_apart(figure, options.narrow);
  return figure;
}

Figure forces_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Floor acceleration and storey shear with contact over those without",
                .columns = 2,
                .width = options.width,
                .shared_legend = true};
  struct Ratio {
    const char *key, *label, *finding;
    bool of_storeys = false;
  };
  const Ratio ratios[] = {
      {"acceleration_ratio", "Acceleration, contact / without [–]", "floor acceleration up to {} times: {}"},
      {"storey_shear_ratio", "Storey shear, contact / without [–]", "storey shear up to {} times: {}", true}};
  const std::vector<Eigen::Index> shown = moving(run, options);
  const std::vector<Tone> tones = tones_of(run, options);
  for (const auto& [key, label, finding, of_storeys] : ratios) {
    const Quantity& quantity = quantity_named(key, Owner::floor);
    Panel panel =
        height_panel(run, options, shown, {.label = word(options, label), .from = 0, .least = {{0, 1.05}}}, 1);
    Largest most;
    for (const Eigen::Index b : shown) {
      const Building& building = run.problem.buildings[b];
      const std::vector<double> values = of_floors(run, quantity, b);
      most.take(run, b, values);
      Curve curve = of_storeys ? over_storeys(building, values) : at_floors(building, values);
      tell_apart(curve, tones, shown, b);
      if (of_storeys && shown.size() <= most_dashes) curve.mark = Mark::none;
      if (!curve.x.empty()) panel.curves.push_back(curve);
    }
    if (panel.curves.empty()) continue;
    figure.finding +=
        (figure.finding.empty() ? "" : "; ") + word(options, finding, number(most.value), most.place(run, options));
    if (!figure.panels.empty()) leave_to_neighbour(panel.y);
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("nothing moves without contact, so that there are no ratios");
  set_apart(figure, options.narrow);
  return figure;
}

Figure drift_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Largest storey drift, and what is left of it at the end where something yields",
                .columns = 2,
                .width = options.width,
                .shared_legend = true};
  struct Drift {
    const char *key, *label, *finding;
  };
  const Drift drifts[] = {{"peak_drift_ratio", "Storey drift Δ/h [%]", "drift up to {} %: {}"},
                          {"residual_drift_ratio", "Residual drift [%]", "left at the end up to {} %: {}"}};
  constexpr double percent = 100;
  const std::vector<Eigen::Index> shown = moving(run, options);
  const std::vector<Tone> tones = tones_of(run, options);
  for (const auto& [key, label, finding] : drifts) {
    const Quantity& quantity = quantity_named(key, Owner::floor);
    const bool is_signed = !figure.panels.empty();
    Panel panel = height_panel(run, options, shown, {.label = word(options, label)}, 0);
    double most = -1;
    std::string place;
    for (const Eigen::Index b : shown) {
      const Building& building = run.problem.buildings[b];
      std::vector<double> values = of_floors(run, quantity, b);
      for (std::size_t storey = 0; storey < values.size(); ++storey) {
        values[storey] *= percent;
        if (!(std::abs(values[storey]) > most)) continue;
        most = std::abs(values[storey]);
        place =
            building.name + ", " +
            word(options, "storey {}", std::to_string(building.model.storey_number(static_cast<Eigen::Index>(storey))));
      }
      Curve curve = over_storeys(building, values);
      tell_apart(curve, tones, shown, b);
      if (shown.size() <= most_dashes) curve.mark = Mark::none;
      if (!curve.x.empty()) panel.curves.push_back(curve);
    }
    if (panel.curves.empty()) continue;
    if (is_signed) leave_to_neighbour(panel.y);
    figure.finding += (figure.finding.empty() ? "" : "; ") + word(options, finding, number(most), place);
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("no building shown has storeys");
  if (figure.panels.size() == 1) {
    figure.columns = 1;
    figure.title = "Largest storey drift";
    figure.lacks = "residual";
  }
  set_apart(figure, options.narrow);
  return figure;
}

Figure modes_figure(const RunResults& run, const FigureOptions& options) {
  const std::vector<Eigen::Index> shown = moving(run, options);
  constexpr std::size_t most_of_room = 8;
  Figure figure = beside(run, options, shown, shown.size() > most_of_room ? 2.5 : 2.7);
  figure.title = "Mode shapes, largest sway 1";
  const bool has_shares = shown.size() <= 2;  // of more panels they have no room in one line
  if (!has_shares) figure.lacks = "shares";
  for (const Eigen::Index b : shown) {
    const Building& building = run.problem.buildings[b];
    figure.finding += (figure.finding.empty() ? "" : "; ") + word(options, "T₁ of {}", building.name) + " " +
                      seconds_text(*first_period(building));
  }
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const Building& building = run.problem.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    panel.x = {.label = word(options, "Shape φ [–]"), .from = -1.08, .to = 1.08};
    panel.rules = {{.at = 0, .vertical = true}};
    const Eigen::MatrixXd shapes = sway_shapes(building);
    const Eigen::VectorXd shares = modal_properties(building).effective_mass_fraction;
    for (Eigen::Index mode = 0; mode < std::min(shapes.cols(), most_modes); ++mode) {
      constexpr const char* names[] = {"T₁", "T₂", "T₃"};
      const double period = 2 * std::numbers::pi / building.modes.omega(mode);
      const std::string text = period >= 99.95                  ? fmt::format("{:.0f}", period)
                               : period < 0.1 && period >= 0.01 ? fmt::format("{:.3f}", period)  // no wider
                                                                : fmt::format("{:#.3g}", period);
      Curve style{.label = fmt::format("{} {} s", names[mode], text)};
      if (has_shares) {
        style.label += ", " + fmt::format("{:.0f} %", 100 * shares(mode));
      }
      tell_apart(style, static_cast<std::size_t>(mode), tone_of(run, options, shown[b]));
      panel.curves.push_back(over_height(building, shapes.col(mode), style));
    }
  }
  return figure;
}

}  // namespace bentur
