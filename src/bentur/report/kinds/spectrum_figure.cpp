#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {

Figure spectrum_figure(const SpectrumCurves& curves, const FigureOptions& options) {
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one{.x = {.from = curves.from.value_or(curves.periods.front()),
                    .to = curves.to.value_or(curves.periods.back()),
                    .logarithmic = true},
              .y = {.label = label, .from = 0},
              .height = 3.2,
              .curves = {{.x = curves.periods, .y = values}}};
    std::size_t index = 0;
    for (const auto& [name, period] : curves.marks) {
      Curve style;
      tell_apart(style, ++index);
      one.rules.push_back({.at = period,
                           .vertical = true,
                           .label = word(options, "T₁ of {}", name),
                           .tone = style.tone,
                           .line = style.line});
    }
    return one;
  };
  Figure figure{
      .title = fmt::format("Response spectra of the ground motion, damping ratio {}", number_text(curves.damping)),
      .panels = {panel(with_unit("Sa", curves.acceleration_unit), curves.acceleration),
                 panel(with_unit("Sd", curves.length), curves.displacement)},
      .width = options.width,
      .shared_legend = true};
  figure.panels.front().curves.front().label = fmt::format("ζ = {:.3g} %", 100 * curves.damping);
  figure.panels.back().x.label = word(options, "Period T [s]");
  return figure;
}

Figure run_spectrum_figure(const RunResults& run, const FigureOptions& options) {
  if (run.figures.spectrum.empty()) {
    throw NoFigure("the file has no response spectrum: \"bentur run --figures\" adds that of a record");
  }
  SpectrumCurves curves;
  curves.periods = run.figures.spectrum_periods;
  for (const OscillatorPeaks& peaks : run.figures.spectrum) {
    curves.acceleration.push_back(peaks.pseudo_acceleration);
    curves.displacement.push_back(peaks.displacement);
  }
  curves.acceleration_unit = unit_text("L s-2", run.c.units);
  curves.length = run.c.units.length;
  curves.damping = run.figures.spectrum_damping;
  for (const Eigen::Index b : shown_buildings(run, options)) {
    const Building& building = run.problem.buildings[b];
    if (const auto period = first_period(building)) curves.marks.emplace_back(building.name, *period);
  }
  if (!curves.marks.empty()) {  // what lies around the buildings' periods
    const auto [least, most] = std::minmax_element(curves.marks.begin(), curves.marks.end(),
                                                   [](const auto& a, const auto& b) { return a.second < b.second; });
    constexpr double around = 5;
    const double from = std::max(curves.periods.front(), least->second / around);
    const double to = std::min(curves.periods.back(), most->second * around);
    if (from < to) std::tie(curves.from, curves.to) = std::pair(from, to);
  }
  return spectrum_figure(curves, options);
}

}  // namespace bentur
