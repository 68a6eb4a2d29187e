#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_data.h"

namespace bentur {
namespace {

constexpr std::size_t most_columns = 3;  // panels of a journal's column side by side
constexpr std::size_t most_modes = 3;

/// Elevation, the same for all panels of a figure.
Axis elevation_axis(const RunData& run) {
  Axis axis{.label = with_unit("Elevation z", run.length)};
  axis.from = run.buildings.front().base;
  for (const RunData::Building& building : run.buildings) axis.from = std::min(*axis.from, building.base);
  double top = *axis.from;
  for (const RunData::Building& building : run.buildings) top = std::max(top, building.elevations.back());
  axis.to = top + 0.03 * (top - *axis.from);
  return axis;
}

double frame_height(const RunData& run) {
  std::size_t floors = 0;
  for (const RunData::Building& building : run.buildings) floors = std::max(floors, building.elevations.size());
  return floors > 8 ? 7.5 : 5;
}

/// One panel for each building.
Figure beside(const RunData& run, const FigureOptions& options, const std::vector<std::size_t>& shown) {
  Figure figure{.columns = static_cast<int>(std::min(shown.size(), most_columns)), .width = options.width};
  const Axis elevation = elevation_axis(run);
  for (std::size_t b = 0; b < shown.size(); ++b) {
    Panel panel{.title = run.buildings[shown[b]].name, .y = elevation, .height = frame_height(run)};
    if (b % static_cast<std::size_t>(figure.columns) != 0) panel.y.label = "";
    figure.panels.push_back(panel);
  }
  return figure;
}

/// A curve from the base, which does not move, up; with marks where there are few floors.
Curve over_height(const RunData::Building& building, const std::vector<double>& values, Curve curve) {
  curve.x = {0};
  curve.y = {building.base};
  curve.x.insert(curve.x.end(), values.begin(), values.end());
  curve.y.insert(curve.y.end(), building.elevations.begin(), building.elevations.end());
  if (building.elevations.size() > 20) curve.mark = Mark::none;
  return curve;
}

}  // namespace

Figure envelope_figure(const RunData& run, const FigureOptions& options) {
  const std::vector<std::size_t> shown = run.shown(options);
  Figure figure = beside(run, options, shown);
  figure.title = "Largest displacements relative to the bases, with and without contact";
  figure.shared_legend = true;
  double largest = 0;
  for (const std::size_t b : shown) {
    const RunData::Building& building = run.buildings[b];
    for (const double x : building.peaks) largest = std::max(largest, x);
    for (const double x : building.peaks_no_contact) largest = std::max(largest, x);
  }
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const RunData::Building& building = run.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    panel.x = {.label = with_unit("max |x|", run.length), .from = 0, .to = 1.05 * largest};
    if (!(largest > 0)) panel.x.to = 1;
    const Curve with{.label = "with contact", .mark = Mark::disc};
    const Curve without{
        .label = "without", .tone = Tone::orange, .line = Line::dashed, .mark = Mark::circle, .width = 1.2};
    panel.curves = {over_height(building, building.peaks, with),
                    over_height(building, building.peaks_no_contact, without)};
  }
  return figure;
}

Figure amplification_figure(const RunData& run, const FigureOptions& options) {
  Panel panel{.x = {.label = "Amplification of max |x| by contact [–]"},
              .y = elevation_axis(run),
              .height = frame_height(run),
              .rules = {{.at = 1, .vertical = true}}};
  const std::vector<std::size_t> shown = run.shown(options);
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const RunData::Building& building = run.buildings[shown[b]];
    Curve curve{.label = building.name};
    for (std::size_t i = 0; i < building.peaks.size(); ++i) {
      if (!(building.peaks_no_contact[i] > 0)) continue;
      curve.x.push_back(building.peaks[i] / building.peaks_no_contact[i]);
      curve.y.push_back(building.elevations[i]);
    }
    tell_apart(curve, b);
    if (!curve.x.empty()) panel.curves.push_back(curve);
  }
  if (panel.curves.empty()) throw NoFigure("nothing moves without contact, so that there is no amplification");
  return {.title = "Largest displacement with contact over that without", .panels = {panel}, .width = options.width};
}

Figure modes_figure(const RunData& run, const FigureOptions& options) {
  const std::vector<std::size_t> shown = run.shown(options);
  Figure figure = beside(run, options, shown);
  figure.title = "Mode shapes, largest sway 1";
  for (std::size_t b = 0; b < shown.size(); ++b) {
    const RunData::Building& building = run.buildings[shown[b]];
    Panel& panel = figure.panels[b];
    panel.x = {.label = "Shape φ [–]", .from = -1.08, .to = 1.08};
    panel.rules = {{.at = 0, .vertical = true}};
    const std::size_t floors = building.elevations.size();
    for (std::size_t mode = 0; mode < std::min(building.periods.size(), most_modes); ++mode) {
      const auto row = building.shapes.begin() + static_cast<std::ptrdiff_t>(mode * floors);
      const std::vector<double> shape(row, row + static_cast<std::ptrdiff_t>(floors));
      const std::string period = fmt::format("{:.3g} s", building.periods[mode]);
      Curve style{.label = figure.columns > 2 ? period : fmt::format("T{} = {}", mode + 1, period)};
      tell_apart(style, mode);
      panel.curves.push_back(over_height(building, shape, style));
    }
  }
  return figure;
}

}  // namespace bentur
