#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {

namespace {

/// A point of a curve over the logarithm of the period, as it is drawn.
double value_at(const SpectrumCurves& curves, const std::vector<double>& values, double period) {
  const auto next = std::upper_bound(curves.periods.begin(), curves.periods.end(), period);
  if (next == curves.periods.begin() || next == curves.periods.end()) return NAN;
  const auto i = next - curves.periods.begin();
  const double part = std::log(period / *(next - 1)) / std::log(*next / *(next - 1));
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

}  // namespace

Figure spectrum_figure(const SpectrumCurves& curves, const FigureOptions& options) {
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one{.x = {.from = curves.from.value_or(curves.periods.front()),
                    .to = curves.to.value_or(curves.periods.back()),
                    .logarithmic = true},
              .y = {.label = label, .from = 0},
              .height = 3.2,
              .curves = {{.x = curves.periods, .y = values, .tone = Tone::grey, .width = 1.4}}};
    for (const SpectrumMark& mark : curves.marks) {
      Curve place{.label = word(options, "T₁ of {}", mark.name),
                  .x = {mark.period},
                  .y = {value_at(curves, values, mark.period)}};
      tell_apart(place, mark.number);
      one.rules.push_back({.at = mark.period, .vertical = true, .tone = place.tone, .line = place.line});
      one.curves.push_back(std::move(place));
    }
    return one;
  };
  Figure figure{.title = fmt::format("Response spectra of the ground motion, damping ratio {}", number(curves.damping)),
                .panels = {panel(with_unit("Sa", curves.acceleration_unit), curves.acceleration),
                           panel(with_unit("Sd", curves.length), curves.displacement)},
                .width = options.width,
                .shared_legend = true};
  const auto highest = std::max_element(curves.acceleration.begin(), curves.acceleration.end());
  figure.finding = word(options, "largest Sa {} at {}", number(*highest) + " " + curves.acceleration_unit,
                        seconds_text(curves.periods[highest - curves.acceleration.begin()]));
  for (const SpectrumMark& mark : curves.marks) {
    figure.finding += "; " + word(options, "T₁ of {}", mark.name) + " " + seconds_text(mark.period) + ": Sa " +
                      number(value_at(curves, curves.acceleration, mark.period)) + " " + curves.acceleration_unit;
  }
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
    curves.acceleration.push_back(peaks.pseudo_acceleration / standard_gravity(run.c.units.length));
    curves.displacement.push_back(peaks.displacement);
  }
  curves.acceleration_unit = "g";
  curves.length = run.c.units.length;
  curves.damping = run.figures.spectrum_damping;
  for (const Eigen::Index b : shown_buildings(run, options)) {
    const Building& building = run.problem.buildings[b];
    const auto period = first_period(building);
    if (period && *period >= curves.periods.front() && *period <= curves.periods.back())
      curves.marks.push_back({building.name, *period, static_cast<std::size_t>(b)});
  }
  if (!curves.marks.empty()) {  // what lies around the buildings' periods
    const auto [least, most] = std::minmax_element(curves.marks.begin(), curves.marks.end(),
                                                   [](const auto& a, const auto& b) { return a.period < b.period; });
    constexpr double around = 5;
    const double from = std::max(curves.periods.front(), least->period / around);
    const double to = std::min(curves.periods.back(), most->period * around);
    if (from < to) std::tie(curves.from, curves.to) = std::pair(from, to);
  }
  return spectrum_figure(curves, options);
}

}  // namespace bentur
