#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/files/ida_reading.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/internal/sweep_data.h"
#include "bentur/study/fragility/ida_fragility.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

constexpr std::size_t most_cases = 6;

/// An incremental dynamic analysis: levels of intensity, records, and what else varies.
struct Analysis {
  std::size_t level = 0;                      ///< number of the dimension of intensities
  std::vector<std::size_t> record, others;    ///< numbers of dimensions that are records, and that are neither
  std::vector<std::vector<std::size_t>> all;  ///< one place for each record, levels and others as chosen
};

/// All combinations of the values of some dimensions.
std::vector<std::vector<std::size_t>> combinations(const SweepData& sweep, std::vector<std::size_t> from,
                                                   const std::vector<std::size_t>& dimensions) {
  std::vector<std::vector<std::size_t>> list = {std::move(from)};
  for (const std::size_t d : dimensions) {
    if (list[0][d] != sweep.dimensions()[d].size) continue;  // chosen
    std::vector<std::vector<std::size_t>> longer;
    for (const std::vector<std::size_t>& one : list) {
      for (std::size_t i = 0; i < sweep.dimensions()[d].size; ++i) {
        longer.push_back(one);
        longer.back()[d] = i;
      }
    }
    list = std::move(longer);
  }
  return list;
}

Analysis analysis(const SweepData& sweep) {
  Analysis found;
  found.level = sweep.index("intensity");
  const std::vector<std::string>& records = sweep.results().at("record_intensity").dimensions;
  for (std::size_t d = 0; d < sweep.dimensions().size(); ++d) {
    if (d == found.level) continue;
    const bool is_record = std::find(records.begin(), records.end(), sweep.dimensions()[d].name) != records.end();
    (is_record ? found.record : found.others).push_back(d);
  }
  return found;
}

std::string case_name(const SweepData& sweep, const Analysis& ida, const std::vector<std::size_t>& at) {
  std::vector<std::string> choices;
  for (const std::size_t d : ida.others) {
    const SweepDimension& one = sweep.dimensions()[d];
    if (one.size > 1) choices.push_back(one.choice(at[d]));
  }
  return fmt::format("{}", fmt::join(choices, ", "));
}

/// The largest value of a quantity at one level of intensity; infinite where the run collapsed or its numbers failed,
/// NaN where there is none.
double largest(const SweepData& sweep, const std::string& quantity, std::vector<std::size_t> at, std::size_t dimension,
               std::size_t level) {
  at[dimension] = level;
  double result = NAN;
  constexpr double numbers_failed = 1;
  if (sweep.values("status", at).front() == numbers_failed) return INFINITY;
  if (sweep.results().find("collapsed") != nullptr && sweep.values("collapsed", at).front() > 0) return INFINITY;
  for (const double value : sweep.values(quantity, at)) result = std::fmax(result, value);
  return result;
}

/// Index of a case in the table of outcomes.
std::size_t case_number(const SweepData& sweep, const Analysis& ida, const std::vector<std::size_t>& at) {
  std::size_t number = 0;
  for (const std::size_t d : ida.others) number = number * sweep.dimensions()[d].size + at[d];
  return number;
}

IdaResults event_results(const SweepData& sweep, const std::string& event) {
  std::string error;
  const auto rule = parse_event(event, error);
  if (!rule) throw NoFigure(fmt::format("--event \"{}\" {}", event, error));
  try {
    return read_ida_results(sweep.results(), *rule);
  } catch (const NetcdfError& failure) {
    throw NoFigure(failure.what());
  }
}

Axis intensity_axis(const SweepDimension& levels) {
  return {.label = levels.label, .from = 0, .to = *std::max_element(levels.numbers.begin(), levels.numbers.end())};
}

}  // namespace

bool is_ida(const NetcdfReader& results) {
  return results.find("status") != nullptr && results.find("intensity") != nullptr &&
         results.find("record_intensity") != nullptr;
}

Figure ida_figure(const SweepData& sweep, const FigureOptions& options) {
  const Analysis ida = analysis(sweep);
  const SweepDimension& levels = sweep.dimensions()[ida.level];
  const std::vector<std::size_t> chosen = sweep.chosen(options.at);
  std::vector<std::string> open;
  for (const std::size_t d : ida.others) {
    const SweepDimension& one = sweep.dimensions()[d];
    if (chosen[d] == one.size) open.push_back(fmt::format("{0} (such as --at {0}={1})", one.name, one.value(0)));
  }
  if (!open.empty()) throw NoFigure(fmt::format("one analysis is shown at a time: choose {}", fmt::join(open, ", ")));
  const std::string quantity = "peak_force";
  const std::string unit = unit_text(sweep.results().at(quantity).units);
  Panel panel{
      .x = {.label = with_unit("Peak contact force F", unit), .from = 0}, .y = intensity_axis(levels), .height = 5.5};
  const auto places = combinations(sweep, chosen, ida.record);
  std::vector<std::vector<double>> at_level(levels.size);
  for (const std::vector<std::size_t>& place : places) {
    Curve record{.label = panel.curves.empty() ? fmt::format("{} records", places.size()) : "", .tone = Tone::pale};
    for (std::size_t i = 0; i < levels.size; ++i) {
      const double value = largest(sweep, quantity, place, ida.level, i);
      record.x.push_back(std::isfinite(value) ? value : NAN);
      record.y.push_back(std::isfinite(value) ? levels.numbers[i] : NAN);
      if (!std::isnan(value)) at_level[i].push_back(value);
    }
    panel.curves.push_back(std::move(record));
  }
  const std::pair<double, Line> fractiles[] = {{0.16, Line::dashed}, {0.5, Line::solid}, {0.84, Line::dash_dot}};
  for (const auto& [fraction, line] : fractiles) {
    Curve curve{.label = fmt::format("{:.0f} %", 100 * fraction), .line = line, .width = 1.5};
    for (std::size_t i = 0; i < levels.size; ++i) {
      if (at_level[i].empty()) continue;
      const double value = quantile_of(at_level[i], fraction);
      if (!std::isfinite(value)) break;  // so many have collapsed
      curve.x.push_back(value);
      curve.y.push_back(levels.numbers[i]);
    }
    panel.curves.push_back(std::move(curve));
  }
  return {.title = "Incremental dynamic analysis: peak contact force of each record, and fractiles of all",
          .panels = {panel},
          .width = options.width};
}

Figure fragility_figure(const SweepData& sweep, const FigureOptions& options) {
  const Analysis ida = analysis(sweep);
  const SweepDimension& levels = sweep.dimensions()[ida.level];
  const IdaResults results = event_results(sweep, options.event);
  const auto cases = combinations(sweep, sweep.chosen(options.at), ida.others);
  if (cases.size() > most_cases) {
    std::vector<std::string> names;
    for (const std::size_t d : ida.others) names.push_back(sweep.dimensions()[d].name);
    throw NoFigure(fmt::format("{} combinations of {} are too many for one figure: fix some with --at NAME=VALUE",
                               cases.size(), fmt::join(names, ", ")));
  }
  const bool pounding = options.event == FigureOptions().event;
  const std::string unit = unit_text(results.quantity_units);
  const std::string event = options.event + (unit.empty() || unit == "–" ? "" : " " + unit);
  Panel panel{.x = intensity_axis(levels),
              .y = {.label = pounding ? "Probability of pounding P [–]" : "P(" + event + ") [–]", .from = 0, .to = 1},
              .height = 5.5};
  std::vector<Curve> areas, lines;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Curve observed;
    tell_apart(observed, c);
    observed.line = Line::none;
    const CaseFragility fragility = fit_case(results.table, case_number(sweep, ida, cases[c]), {});
    for (const IntensityCount& count : fragility.counts) {
      if (count.runs == 0) continue;
      observed.x.push_back(count.intensity);
      observed.y.push_back(static_cast<double>(count.events) / static_cast<double>(count.runs));
    }
    const Fragility& fit = fragility.fit;
    const std::string name = case_name(sweep, ida, cases[c]);
    if (fit.kind == Fragility::Kind::fitted) {
      Curve line{.label = name.empty() ? "lognormal fit" : name, .width = 1.3};
      tell_apart(line, c);
      line.mark = Mark::none;
      Curve area{.label = c == 0 ? "95 % bounds" : "", .tone = Tone::pale};
      constexpr int steps = 200;
      for (int i = 1; i <= steps; ++i) {
        const double x = *panel.x.to * i / steps;
        line.x.push_back(x);
        line.y.push_back(fit.probability(x));
        std::vector<double> values;
        if (fragility.bounds) {
          for (const Fragility& one : fragility.bounds->fits) {
            const double p = one.probability(x);
            if (!std::isnan(p)) values.push_back(p);
          }
        }
        if (values.empty()) continue;
        area.x.push_back(x);
        area.y.push_back(quantile_of(values, 0.025));
        area.top.push_back(quantile_of(values, 0.975));
      }
      if (!area.x.empty()) areas.push_back(std::move(area));
      lines.push_back(std::move(line));
    } else {
      observed.label = name;
    }
    if (!name.empty() || fit.kind == Fragility::Kind::fitted) {
      if (c == 0 && observed.label.empty()) observed.label = "observed";
    }
    lines.push_back(std::move(observed));
  }
  panel.curves = areas;
  panel.curves.insert(panel.curves.end(), lines.begin(), lines.end());
  return {.title = fmt::format("Fragility: probability of {} against intensity, lognormal fits with bootstrap bounds",
                               pounding ? "pounding" : event),
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
