#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

constexpr Eigen::Index most_modes = 3;

/// Elevation, the same for all panels of a figure.
Axis elevation_axis(const RunResults& run, const FigureOptions& options) {
  Axis axis{.label = with_unit(word(options, "Level z"), run.c.units.length)};
  axis.from = base_of(run.problem.buildings.front());
  for (const Building& building : run.problem.buildings) axis.from = std::min(*axis.from, base_of(building));
  std::vector<double> levels = {*axis.from};
  for (const Building& building : run.problem.buildings) {
    levels.insert(levels.end(), building.model.elevations.begin(), building.model.elevations.end());
  }
  std::sort(levels.begin(), levels.end());
  const double top = levels.back();
  axis.to = top + 0.03 * (top - *axis.from);
  const auto same = [&](double a, double b) { return b - a <= 1e-6 * (top - *axis.from); };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  axis.places = std::move(levels);
  return axis;
}

double frame_height(const RunResults& run) {
  std::size_t floors = 0;
  for (const Building& building : run.problem.buildings) floors = std::max(floors, building.model.elevations.size());
  return floors > 8 ? 7.5 : 5;
}

/// Those of the buildings shown that do not move with the ground.
std::vector<Eigen::Index> moving(const RunResults& run, const FigureOptions& options) {
  std::vector<Eigen::Index> shown = shown_buildings(run, options);
  std::erase_if(shown, [&](Eigen::Index b) { return run.problem.buildings[b].is_rigid(); });
  if (shown.empty()) throw NoFigure("every building shown moves with the ground");
  return shown;
}

/// One panel for each building, each as wide as `room` [cm] at least; where a row of more than two has no room the
/// figure takes a page's width, and then more rows.
Figure beside(const RunResults& run, const FigureOptions& options, const std::vector<Eigen::Index>& shown,
              double room) {
  constexpr double of_axis = 1.2;  // numbers and label of the elevations [cm]
  Figure figure{.width = options.width};
  const auto fitting = [&] {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::max(0.0, figure.width - of_axis) / room));
  };
  if (shown.size() > 2 && fitting() < shown.size()) figure.width *= page_over_column;
  const std::size_t rows = (shown.size() + fitting() - 1) / fitting();
  const std::size_t columns = (shown.size() + rows - 1) / rows;
  figure.columns = static_cast<int>(columns);
  const Axis elevation = elevation_axis(run, options);
  for (std::size_t b = 0; b < shown.size(); ++b) {
    Panel panel{.title = run.problem.buildings[shown[b]].name, .y = elevation, .height = frame_height(run)};
    if (b % columns != 0) leave_to_neighbour(panel.y);
    figure.panels.push_back(panel);
  }
  return figure;
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

}  // namespace

Figure envelope_figure(const RunResults& run, const FigureOptions& options) {
  const std::vector<Eigen::Index> shown = moving(run, options);
  Figure figure = beside(run, options, shown, 2);
  const bool has_impacts = !run.response.impacts.empty();  // else the responses with and without contact are one
  figure.title = "Largest displacements relative to the bases";
  if (has_impacts) figure.title += ", with and without contact";
  figure.shared_legend = true;
  double largest = 0;
  for (const Eigen::Index b : shown) {
    const BuildingPeaks& peaks = run.response.buildings[b];
    largest = std::max({largest, peaks.displacement.maxCoeff(), peaks.displacement_no_contact.maxCoeff()});
  }
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const Building& building = run.problem.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    panel.x = {.label = with_unit(word(options, "max |x|"), run.c.units.length), .from = 0, .to = 1.05 * largest};
    if (!(largest > 0)) panel.x.to = 1;
    const Curve with{.label = word(options, has_impacts ? "with contact" : "largest displacement"), .mark = Mark::disc};
    const Curve without{.label = word(options, "without contact"),
                        .tone = Tone::orange,
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
  const RunView view = run.view();
  Panel panel{.x = {.label = word(options, "Amplification of max |x| by contact [–]"), .least = {{0.95, 1.05}}},
              .y = elevation_axis(run, options),
              .height = frame_height(run),
              .rules = {{.at = 1, .vertical = true}}};
  const std::vector<Eigen::Index> shown = shown_buildings(run, options);
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const Building& building = run.problem.buildings[shown[b]];
    Curve curve{.label = building.name};
    for (const QuantityPlace& at : floors_of(run.problem, shown[b])) {
      const double value = value_of(amplification, view, at);
      if (std::isnan(value)) continue;
      curve.x.push_back(value);
      curve.y.push_back(building.model.elevations[at.floor]);
    }
    tell_apart(curve, static_cast<std::size_t>(shown[b]));
    if (!curve.x.empty()) panel.curves.push_back(curve);
  }
  if (panel.curves.empty()) throw NoFigure("nothing moves without contact, so that there is no amplification");
  return {.title = "Largest displacement with contact over that without", .panels = {panel}, .width = options.width};
}

Figure forces_figure(const RunResults& run, const FigureOptions& options) {
  const RunView view = run.view();
  Figure figure{.title = "Floor acceleration and storey shear with contact over those without",
                .columns = 2,
                .width = options.width,
                .shared_legend = true};
  const std::pair<const char*, const char*> ratios[] = {{"acceleration_ratio", "Floor acceleration, ratio [–]"},
                                                        {"storey_shear_ratio", "Storey shear, ratio [–]"}};
  const std::vector<Eigen::Index> shown = moving(run, options);
  for (const auto& [key, label] : ratios) {
    const Quantity& quantity = quantity_named(key, Owner::floor);
    Panel panel{.x = {.label = word(options, label), .least = {{0.95, 1.05}}},
                .y = elevation_axis(run, options),
                .height = frame_height(run),
                .rules = {{.at = 1, .vertical = true}}};
    for (std::size_t b = 0; b < shown.size(); ++b) {
      const Building& building = run.problem.buildings[shown[b]];
      Curve curve{.label = building.name};
      for (const QuantityPlace& at : floors_of(run.problem, shown[b])) {
        const double value = value_of(quantity, view, at);
        if (std::isnan(value)) continue;
        curve.x.push_back(value);
        curve.y.push_back(building.model.elevations[at.floor]);
      }
      tell_apart(curve, static_cast<std::size_t>(shown[b]));
      if (!curve.x.empty()) panel.curves.push_back(curve);
    }
    if (panel.curves.empty()) continue;
    if (!figure.panels.empty()) leave_to_neighbour(panel.y);
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("nothing moves without contact, so that there are no ratios");
  return figure;
}

Figure modes_figure(const RunResults& run, const FigureOptions& options) {
  const std::vector<Eigen::Index> shown = moving(run, options);
  Figure figure = beside(run, options, shown, 2.7);
  figure.title = "Mode shapes, largest sway 1";
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const Building& building = run.problem.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    panel.x = {.label = word(options, "Shape φ [–]"), .from = -1.08, .to = 1.08};
    panel.rules = {{.at = 0, .vertical = true}};
    const Eigen::MatrixXd shapes = sway_shapes(building);
    for (Eigen::Index mode = 0; mode < std::min(shapes.cols(), most_modes); ++mode) {
      constexpr const char* names[] = {"T₁", "T₂", "T₃"};
      const double period = 2 * std::numbers::pi / building.modes.omega(mode);
      const std::string text = period < 99.95 ? fmt::format("{:#.3g}", period) : fmt::format("{:.0f}", period);
      Curve style{.label = fmt::format("{} {} s", names[mode], text)};
      tell_apart(style, static_cast<std::size_t>(mode));
      panel.curves.push_back(over_height(building, shapes.col(mode), style));
    }
  }
  return figure;
}

}  // namespace bentur
