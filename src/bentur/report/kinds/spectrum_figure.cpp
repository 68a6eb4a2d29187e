#include <fmt/format.h>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {

Figure spectrum_figure(const SpectrumCurves& curves, double width) {
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one{.x = {.from = curves.periods.front(), .to = curves.periods.back(), .logarithmic = true},
              .y = {.label = label, .from = 0},
              .height = 3.2,
              .curves = {{.x = curves.periods, .y = values}}};
    std::size_t index = 0;
    for (const auto& [name, period] : curves.marks) {
      Curve style;
      tell_apart(style, ++index);
      one.rules.push_back({.at = period,
                           .vertical = true,
                           .label = fmt::format("T1 of {}", name),
                           .tone = style.tone,
                           .line = style.line});
    }
    return one;
  };
  Figure figure{
      .title = fmt::format("Response spectra of the ground motion, damping ratio {}", number_text(curves.damping)),
      .panels = {panel(with_unit("Sa", curves.acceleration_unit), curves.acceleration),
                 panel(with_unit("Sd", curves.length), curves.displacement)},
      .width = width,
      .shared_legend = true};
  figure.panels.front().curves.front().label = fmt::format("ζ = {:.3g} %", 100 * curves.damping);
  figure.panels.back().x.label = "Period T [s]";
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
  return spectrum_figure(curves, options.width);
}

}  // namespace bentur
