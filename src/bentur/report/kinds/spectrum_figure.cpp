#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/names.h"
#include "bentur/report/scene/tones.h"

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

constexpr double span_of_marks = 5;  // times the periods of the buildings

/// Shows what lies around the buildings' periods, with those of the modes that are marked.
void show_around_marks(SpectrumCurves& curves) {
  double least = INFINITY, most = 0;
  for (const SpectrumMark& mark : curves.marks) {
    least = std::min(least, mark.period / span_of_marks);
    most = std::max(most, mark.period * span_of_marks);
    for (const double period : mark.periods) least = std::min(least, 0.8 * period);
  }
  const double from = std::max(curves.periods.front(), least), to = std::min(curves.periods.back(), most);
  if (from < to) std::tie(curves.from, curves.to) = std::pair(from, to);
}

/// Names of buildings at the lines of their first periods, in rows so that none lies on another. @param width about
/// that of the frame [cm]
void name_periods(Panel& panel, const std::vector<SpectrumMark>& marks, double width) {
  const Curve& all = panel.curves.front();
  double highest = 0;
  for (std::size_t i = 0; i < all.x.size(); ++i) {
    if (all.x[i] >= *panel.x.from && all.x[i] <= *panel.x.to) highest = std::max(highest, all.y[i]);
  }
  std::vector<std::string> names;
  for (const SpectrumMark& mark : marks) names.push_back(mark.name);
  const std::vector<std::string> in_short = short_names(names);
  if (are_parts_of(in_short, names)) names = in_short;
  std::vector<std::size_t> order(marks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return marks[a].period < marks[b].period; });
  const double decades = std::log(*panel.x.to / *panel.x.from);
  std::vector<double> ends;  // of the rows [cm]
  std::vector<std::size_t> rows(marks.size());
  std::vector<bool> is_left(marks.size());  // the first one, so that its name lies on no other line
  for (const std::size_t i : order) {
    const double at = width * std::log(marks[i].period / *panel.x.from) / decades;
    const double wide = text_width(names[i]) + 0.12;
    is_left[i] = i == order.front() && wide < at;
    std::size_t row = 0;
    while (row < ends.size() && ends[row] > at) ++row;
    if (row == ends.size()) ends.push_back(0);
    ends[row] = at + (is_left[i] ? 0 : wide);
    rows[i] = row;
  }
  constexpr double of_row = 0.38;  // [cm]
  const double count = static_cast<double>(ends.size());
  const double top = highest * panel.height / (panel.height - of_row * count - 0.1), one_cm = top / panel.height;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    panel.texts.push_back(
        {.x = marks[i].period, .y = top - of_row * (static_cast<double>(rows[i]) + 0.5) * one_cm, .text = names[i]});
  }
  panel.y.to = top;
}

}  // namespace

Figure spectrum_figure(const SpectrumCurves& curves, const FigureOptions& options) {
  constexpr double of_axis = 1.8;  // [cm]
  const bool are_named =
      !curves.marks.empty() && std::all_of(curves.marks.begin(), curves.marks.end(),
                                           [](const SpectrumMark& one) { return one.periods.empty(); });
  const auto panel = [&](const std::string& label, const std::vector<double>& values,
                         std::vector<double> SpectrumMark::*ordinates) {
    Panel one{.x = {.from = curves.from.value_or(curves.periods.front()),
                    .to = curves.to.value_or(curves.periods.back()),
                    .logarithmic = true},
              .y = {.label = label, .from = 0},
              .height = 3.2,
              .curves = {{.x = curves.periods, .y = values, .tone = Tone::grey, .width = 1.4}}};
    for (const SpectrumMark& mark : curves.marks) {
      const bool is_on_curve = mark.periods.empty();
      Curve place{.label = word(options, "T₁ of {}", mark.name),
                  .x = is_on_curve ? std::vector{mark.period} : mark.periods,
                  .y = is_on_curve ? std::vector{value_at(curves, values, mark.period)} : mark.*ordinates};
      tell_apart(place, mark.number, mark.tone);
      one.rules.push_back({.at = mark.period, .vertical = true, .tone = place.tone, .line = place.line});
      if (!is_on_curve) place.line = Line::none;
      place.in_legend = !is_on_curve;
      one.curves.push_back(std::move(place));
    }
    if (are_named) name_periods(one, curves.marks, std::min(options.width, column_width) - of_axis);
    return one;
  };
  Figure figure{.title = fmt::format("{}, damping ratio {}", curves.title, number(curves.damping)),
                .panels = {panel(with_unit(word(options, "Acceleration Sa"), curves.acceleration_unit),
                                 curves.acceleration, &SpectrumMark::acceleration),
                           panel(with_unit(word(options, "Displacement Sd"), curves.length), curves.displacement,
                                 &SpectrumMark::displacement)},
                .width = options.width,
                .shared_legend = true};
  const auto highest = std::max_element(curves.acceleration.begin(), curves.acceleration.end());
  figure.finding = word(options, "largest Sa {} at {}", number(*highest) + " " + curves.acceleration_unit,
                        seconds_text(curves.periods[highest - curves.acceleration.begin()]));
  for (const SpectrumMark& mark : curves.marks) {
    figure.finding += "; " + word(options, "T₁ of {}", mark.name) + " " + seconds_text(mark.period) + ": Sa " +
                      number(mark.acceleration.empty() ? value_at(curves, curves.acceleration, mark.period)
                                                       : mark.acceleration.front()) +
                      " " + curves.acceleration_unit;
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
      curves.marks.push_back({building.name, *period, static_cast<std::size_t>(b), tone_of(run, options, b)});
  }
  show_around_marks(curves);
  return spectrum_figure(curves, options);
}

Figure floor_spectrum_figure(const RunResults& run, const FigureOptions& options) {
  const FloorSpectra& spectra = run.figures.floor_spectra;
  if (spectra.floors.empty()) {
    throw NoFigure("the file has no spectra of floors: \"bentur run --figures\" adds them");
  }
  const bool has_impacts = !run.response.impacts.empty();  // else the motions with and without contact are one
  const bool is_broad = spectra.floors.size() > 1 && !options.narrow;
  const std::size_t columns = !is_broad ? 1 : spectra.floors.size() % 3 == 0 ? 3 : 2;  // so that rows are full
  Figure figure{.title = fmt::format("Response spectra of the motion of floors, damping ratio {}, S_a in g",
                                     number(spectra.damping)),
                .columns = static_cast<int>(columns),
                .width = is_broad ? broad(options.width) : options.width,
                .shared_legend = true};
  const double gravity = standard_gravity(run.c.units.length);
  double most = 0, most_ratio = 0;
  std::string largest, raised;
  for (const FloorSpectra::Floor& floor : spectra.floors) {
    const Building& building = run.problem.buildings[floor.building];
    std::string place =
        building.name + ", " + word(options, "level {}", shown_value(run, building.model.elevations[floor.floor], "L"));
    if (!floor.along.isZero(0)) place += ", " + word(options, "along {}", direction_text(floor.along));
    const auto curve = [&](std::vector<double> values, Curve style) {
      for (double& value : values) value /= gravity;
      style.x = spectra.periods;
      style.y = std::move(values);
      return style;
    };
    Panel panel{.title = place,
                .x = {.from = spectra.periods.front(), .to = spectra.periods.back(), .logarithmic = true},
                .y = {.label = with_unit(word(options, "Acceleration Sa"), "g"), .from = 0},
                .height = 3.6};
    panel.curves.push_back(curve(floor.with_contact,
                                 {.label = word(options, has_impacts ? "with contact" : "acceleration of the floor")}));
    if (has_impacts) {
      panel.curves.push_back(
          curve(floor.without_contact,
                {.label = word(options, "without contact"), .tone = Tone::grey, .line = Line::dashed, .width = 1.2}));
    }
    if (const auto period = first_period(building); period && *period > *panel.x.from && *period < *panel.x.to) {
      panel.rules.push_back(
          {.at = *period, .vertical = true, .tone = tone_of(run, options, floor.building), .line = Line::dotted});
    }
    for (std::size_t i = 0; i < spectra.periods.size(); ++i) {
      const double with = floor.with_contact[i], without = floor.without_contact[i];
      if (with > most) {
        most = with;
        largest =
            word(options, "largest Sa {} at {}", number(with / gravity) + " g", seconds_text(spectra.periods[i])) +
            ": " + place;
      }
      if (without > 0 && with > most_ratio * without) {
        most_ratio = with / without;
        raised = word(options, "up to {} times that without contact, at {}", number(most_ratio),
                      seconds_text(spectra.periods[i])) +
                 ": " + place;
      }
    }
    if (figure.panels.size() % columns > 0) panel.y.label = "";
    figure.panels.push_back(std::move(panel));
  }
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    Panel& panel = figure.panels[i];
    panel.y.least = {0, 1.08 * most / gravity};  // one scale, with room for names of periods
    for (const RuleLine& rule : panel.rules) panel.texts.push_back({rule.at, 1.04 * most / gravity, "T₁"});
    if (i + columns >= figure.panels.size()) panel.x.label = word(options, "Period T [s]");
  }
  figure.finding = largest + (has_impacts ? "; " + raised : "");
  return figure;
}

std::string floors_text(const FloorSpectra& spectra, std::optional<std::size_t> hit,
                        const std::vector<std::string>& gaps, const std::vector<JudgedGap>& judged,
                        std::size_t buildings, const FigureOptions& options) {
  std::string text;
  if (hit && options.gap && *options.gap != *hit) {
    text = word(options, "Shown is {}, with the hardest impact of all; floors at other gaps have no spectra",
                gaps.at(*hit));
  } else if (hit && !options.gap) {
    if (const auto worst = worst_besides(judged, *hit)) text = place_text(gaps, *hit, *worst, true, options, false);
  } else if (!hit && spectra.floors.size() < buildings) {
    text = word(options, "Shown are roofs of {} of {} buildings, the first of the case",
                std::to_string(spectra.floors.size()), std::to_string(buildings));
  }
  constexpr double usual = 0.031;  // where samples are as near to one another as they ever are [s]
  if (spectra.periods.front() > usual) {
    text += (text.empty() ? "" : ". ") + word(options, "Periods begin at {}: of shorter ones samples are too far apart",
                                              seconds_text(spectra.periods.front()));
  }
  return text;
}

Figure design_spectrum_figure(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                              const FigureOptions& options) {
  const DesignSpectrum& spectrum = c.excitation.spectrum.value().spectrum;
  const double gravity = standard_gravity(c.units.length);
  SpectrumCurves curves;
  curves.title = "Design spectrum of the case";
  curves.acceleration_unit = "g";
  curves.length = c.units.length;
  curves.damping = spectrum.damping_ratio;
  const std::vector<Tone> tones = tones_of(problem, {});
  double last = 4;  // that may be of interest [s]
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto period = first_period(problem.buildings[b]);
    if (!period) continue;
    last = std::max(last, span_of_marks * *period);
    SpectrumMark mark{problem.buildings[b].name, *period, b, tones.at(b)};
    const SpectralModes& modes = spectral.modes[b];
    constexpr Eigen::Index most_modes = 3;
    for (Eigen::Index n = 0; n < std::min(most_modes, modes.omega.size()); ++n) {
      const double omega = modes.omega(n);
      mark.periods.push_back(2 * std::numbers::pi / omega);
      mark.displacement.push_back(modes.displacement(n));
      mark.acceleration.push_back(omega * omega * modes.displacement(n) / gravity);
    }
    curves.marks.push_back(std::move(mark));
  }
  if (const auto* table = std::get_if<TableSpectrum>(&spectrum.shape)) last = table->periods.back();
  curves.periods = logarithmic_periods(std::min(0.02, last / 2), last, 401);
  for (const double period : curves.periods) {
    curves.acceleration.push_back(spectral_acceleration(spectrum, period, spectrum.damping_ratio) / gravity);
    curves.displacement.push_back(spectral_displacement(spectrum, period, spectrum.damping_ratio));
  }
  show_around_marks(curves);
  return spectrum_figure(curves, options);
}

}  // namespace bentur
