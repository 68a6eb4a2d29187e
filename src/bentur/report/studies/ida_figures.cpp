#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/quantities.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/names.h"
#include "bentur/report/studies/sweep_data.h"
#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

constexpr std::size_t most_cases = 6;

/// An incremental dynamic analysis: levels of intensity, records, and what else varies.
struct Analysis {
  std::size_t level = 0;  ///< number of the dimension of intensities; of a cloud, which has none, that of dimensions
  SweepDimension levels;  ///< the intensities
  std::vector<std::size_t> record, others;    ///< numbers of dimensions that are records, and that are neither
  std::vector<std::vector<std::size_t>> all;  ///< one place for each record, levels and others as chosen
};

Tone pale_of(Tone tone) { return tone == Tone::teal ? Tone::pale_blue : Tone::pale; }

Analysis analysis(const SweepData& sweep) {
  Analysis found;
  found.level = is_cloud(sweep.results()) ? sweep.dimensions().size() : sweep.index("intensity");
  found.levels = sweep.intensities();
  for (std::size_t d = 0; d < sweep.dimensions().size(); ++d) {
    if (d == found.level) continue;
    (sweep.dimensions()[d].is_of_records ? found.record : found.others).push_back(d);
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

/// The largest value of a quantity at one level of intensity; infinite where the run was cut short, NaN where there is
/// none.
double largest(const SweepData& sweep, const std::string& quantity, std::vector<std::size_t> at, std::size_t dimension,
               std::size_t level) {
  at[dimension] = level;
  return sweep.is_cut_short(at) ? INFINITY : sweep.joined(quantity, at, false);
}

/// Some of them, evenly from the first to the last, where they are too many.
void thin_out(std::vector<std::vector<std::size_t>>& cases) {
  if (cases.size() <= most_cases) return;
  std::vector<std::vector<std::size_t>> some;
  for (std::size_t i = 0; i < most_cases; ++i) some.push_back(cases[i * (cases.size() - 1) / (most_cases - 1)]);
  cases = std::move(some);
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

/// "peak_force > 500" as "peak force > 500 kN"; drifts, which are ratios in files, in percent.
std::string event_text(const std::string& event, const std::string& unit) {
  std::string error;
  const EventRule rule = parse_event(event, error).value();
  const std::size_t number_at = event.find_last_of(" <>=") + 1;
  std::string text = event.substr(0, number_at);
  std::replace(text.begin(), text.end(), '_', ' ');
  constexpr double percent = 100;
  if (rule.quantity.find("drift") != std::string::npos) return text + number(percent * rule.threshold) + " %";
  return text + number(rule.threshold) + (unit.empty() || unit == "–" ? "" : " " + unit);
}

/// "peak_force > 500" as "Peak force".
std::string quantity_text(const std::string& event) {
  std::string error;
  std::string text = parse_event(event, error).value().quantity;
  std::replace(text.begin(), text.end(), '_', ' ');
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

/// "0.4 g".
std::string intensity_text(const SweepDimension& levels, double intensity) {
  return number(intensity) + (levels.unit.empty() || levels.unit == "–" ? "" : " " + levels.unit);
}

/// "Intensity Sa (1.2 s, 5 %) [g]"; other measures are words by themselves.
std::string intensity_words(const SweepDimension& levels, const FigureOptions& options) {
  return (levels.label.starts_with("Sa") ? word(options, "Intensity") + " " : "") + levels.label;
}

Axis intensity_axis(const SweepDimension& levels, const FigureOptions& options) {
  return {.label = intensity_words(levels, options),
          .from = 0,
          .to = *std::max_element(levels.numbers.begin(), levels.numbers.end())};
}

}  // namespace

bool is_ida(const NetcdfReader& results) {
  return results.find("status") != nullptr && results.find("intensity") != nullptr &&
         results.find("record_intensity") != nullptr;
}

bool is_cloud(const NetcdfReader& results) {
  return is_ida(results) && results.at("intensity").dimensions == results.at("record_intensity").dimensions;
}

namespace {

constexpr const char* median_label = "50 %";
constexpr std::size_t least_for_fractiles = 7;  ///< runs: the 16 % one of fewer is below all of them

/// "11 records"; where each was applied in both directions, so.
std::string records_text(const SweepData& sweep, const FigureOptions& options, const Analysis& ida, std::size_t runs) {
  const bool both = std::any_of(ida.record.begin(), ida.record.end(), [&](std::size_t d) {
    return sweep.dimensions()[d].name == "polarity" && sweep.dimensions()[d].size == 2;
  });
  const std::size_t records = both ? runs / 2 : runs;
  if (records == 1) return word(options, both ? "1 record in both directions" : "1 record");
  return word(options, both ? "{} records in both directions" : "{} records", fmt::format("{}", records));
}

/// One record a line, and the fractiles of all where there are enough, for one case.
Panel ida_panel(const SweepData& sweep, const FigureOptions& options, const Analysis& ida,
                const std::vector<std::vector<std::size_t>>& places) {
  const SweepDimension& levels = ida.levels;
  const std::string quantity = "peak_force";
  const std::string unit = sweep.unit(quantity);
  Panel panel{.x = {.label = with_unit(word(options, "Peak contact force F"), unit), .from = 0},
              .y = intensity_axis(levels, options),
              .height = 5.5,
              .names_at_ends = true};
  constexpr double above = 0.1;  // the ends of fractiles, for their names
  *panel.y.to *= 1 + above;
  std::vector<std::vector<double>> at_level(levels.size);
  Curve collapses{.label = word(options, "last level before collapse"),
                  .line = Line::none,
                  .mark = Mark::cross,
                  .complete = true,
                  .mark_size = 1.3};
  bool any_force = false;
  for (const std::vector<std::size_t>& place : places) {
    Curve record{.label = panel.curves.empty() ? records_text(sweep, options, ida, places.size()) : "",
                 .tone = Tone::grey,
                 .width = 0.7,
                 .of_several = true};
    bool has_collapsed = false;
    for (std::size_t i = 0; i < levels.size; ++i) {
      const double value = largest(sweep, quantity, place, ida.level, i);
      if (std::isinf(value) && !has_collapsed && i > 0 && std::isfinite(record.x.back())) {
        collapses.x.push_back(record.x.back());
        collapses.y.push_back(record.y.back());
      }
      has_collapsed = has_collapsed || std::isinf(value);
      record.x.push_back(std::isfinite(value) ? value : NAN);
      record.y.push_back(std::isfinite(value) ? levels.numbers[i] : NAN);
      if (!std::isnan(value)) at_level[i].push_back(value);
      any_force = any_force || value > 0;
    }
    panel.curves.push_back(std::move(record));
  }
  const std::pair<double, Line> fractiles[] = {{0.16, Line::dashed}, {0.5, Line::solid}, {0.84, Line::dash_dot}};
  for (const auto& [fraction, line] : fractiles) {
    if (places.size() < least_for_fractiles) break;
    Curve curve{
        .label = fraction == 0.5 ? median_label : fmt::format("{:.0f} %", 100 * fraction), .line = line, .width = 1.5};
    for (std::size_t i = 0; i < levels.size; ++i) {
      if (at_level[i].empty()) continue;
      const double value = quantile_of(at_level[i], fraction);
      if (!std::isfinite(value)) break;  // so many have collapsed
      curve.x.push_back(value);
      curve.y.push_back(levels.numbers[i]);
    }
    panel.curves.push_back(std::move(curve));
  }
  if (!collapses.x.empty()) panel.curves.push_back(std::move(collapses));
  if (!any_force) {
    panel.x.to = 1;
    panel.x.numbers = false;
    panel.note = word(options, "no run has a contact force");
  }
  return panel;
}

}  // namespace

Figure ida_figure(const SweepData& sweep, const FigureOptions& options) {
  const Analysis ida = analysis(sweep);
  const std::vector<std::size_t> chosen = sweep.chosen(options.at);
  std::vector<std::string> open;
  for (const std::size_t d : ida.others) {
    const SweepDimension& one = sweep.dimensions()[d];
    if (chosen[d] == one.size) open.push_back(fmt::format("{0} (such as --at {0}={1})", one.name, one.value(0)));
  }
  if (!open.empty() && !options.choose) {
    throw NoFigure(fmt::format("one analysis is shown at a time: choose {}", fmt::join(open, ", ")));
  }
  auto cases = sweep.combinations(chosen, ida.others);
  thin_out(cases);
  Figure figure{.title = "Incremental dynamic analysis: peak contact force of each record, and fractiles of all",
                .columns = cases.size() == 3  ? 3
                           : cases.size() > 1 ? 2
                                              : 1,
                .width = options.width,
                .shared_legend = true};
  if (cases.size() > 1) figure.width = broad(figure.width);
  double largest_force = 0;
  for (const std::vector<std::size_t>& one : cases) {
    Panel panel = ida_panel(sweep, options, ida, sweep.combinations(one, ida.record));
    panel.title = case_name(sweep, ida, one);
    if (cases.size() > 1) panel.height = 4.6;
    const auto median = std::find_if(panel.curves.begin(), panel.curves.end(),
                                     [](const Curve& each) { return each.label == median_label; });
    if (panel.note.empty() && median != panel.curves.end() && !median->x.empty()) {
      figure.finding += (figure.finding.empty() ? "" : "; ") + (panel.title.empty() ? "" : panel.title + ": ") +
                        word(options, "median {} at {}", number(median->x.back()) + " " + sweep.unit("peak_force"),
                             intensity_text(ida.levels, median->y.back()));
    } else if (!panel.note.empty()) {
      figure.finding += (figure.finding.empty() ? "" : "; ") + panel.note;
    }
    if (panel.note.empty()) {
      for (const Curve& curve : panel.curves) {
        for (const double force : curve.x) largest_force = std::fmax(largest_force, force);
      }
    }
    if (figure.panels.size() % static_cast<std::size_t>(figure.columns) != 0) leave_to_neighbour(panel.y);
    figure.panels.push_back(std::move(panel));
  }
  const auto has_median = [](const Panel& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const Curve& each) { return each.label == median_label; });
  };
  if (std::none_of(figure.panels.begin(), figure.panels.end(), has_median)) figure.lacks = "fractiles";
  for (Panel& panel : figure.panels) {  // all by one scale, so that they can be compared
    if (panel.note.empty() && cases.size() > 1 && largest_force > 0) panel.x.to = 1.04 * largest_force;
  }
  return figure;
}

Figure cloud_figure(const SweepData& sweep, const FigureOptions& options) {
  const Analysis cloud = analysis(sweep);
  const bool is_asked = options.event != pounding_event && options.event != collapse_event;
  const IdaResults results = event_results(sweep, is_asked ? options.event : gap_needed_event);
  const OutcomeTable& table = results.table;
  auto cases = sweep.combinations(sweep.chosen(options.at), cloud.others);
  thin_out(cases);
  const std::string unit = unit_text(results.quantity_units);
  Panel panel{.x = {.label = intensity_words(cloud.levels, options), .logarithmic = true},
              .y = {.label = with_unit(is_asked ? quantity_text(options.event) : word(options, "Gap needed"), unit),
                    .logarithmic = true},
              .height = 5.5};
  Figure figure{.title = "Cloud: demand of every record against its intensity", .width = options.width};
  std::vector<std::vector<double>> shown;
  for (const std::vector<std::size_t>& one : cases) {
    const std::size_t first = case_number(sweep, cloud, one) * table.records;
    Curve runs{.label = case_name(sweep, cloud, one), .complete = true};
    std::vector<RunDemand> demands;
    for (std::size_t record = 0; record < table.records; ++record) {
      const std::size_t run = first + record;
      const bool is_there = table.outcomes[run] != Outcome::failed && table.demands[run] > 0;
      if (!is_there || table.collapsed[run] != 0) continue;
      runs.x.push_back(table.own[record]);
      runs.y.push_back(table.demands[run]);
      demands.push_back({table.own[record], table.demands[run]});
    }
    // What does not depend on what varies, as the gap needed on the gap given, is drawn once.
    if (runs.x.empty() || std::find(shown.begin(), shown.end(), runs.y) != shown.end()) continue;
    shown.push_back(runs.y);
    tell_apart(runs, shown.size() - 1);
    runs.line = Line::none;
    runs.mark = Mark::disc;
    if (const auto fit = fit_cloud(demands)) {
      const auto [least, most] = std::minmax_element(runs.x.begin(), runs.x.end());
      for (const double sigmas : {-1.0, 0.0, 1.0}) {
        Curve line{.label = sigmas == 0  ? word(options, "line of the cloud")
                            : sigmas > 0 ? "± σ"
                                         : "",
                   .x = {*least, *most},
                   .tone = runs.tone,
                   .line = sigmas == 0 ? Line::solid : Line::dashed};
        for (const double x : line.x) line.y.push_back(std::exp(fit->a + fit->b * std::log(x) + sigmas * fit->sigma));
        if (shown.size() > 1) line.label.clear();
        panel.curves.push_back(std::move(line));
      }
      figure.finding +=
          (figure.finding.empty() ? "" : "; ") + word(options, "grows with intensity to the {}, dispersion {}, R² {}",
                                                      number(fit->b), number(fit->sigma), number(fit->determination));
    }
    panel.curves.push_back(std::move(runs));
  }
  if (shown.empty()) throw NoFigure("no run has a demand above 0");
  if (shown.size() == 1) panel.curves.back().label = word(options, "each record");
  figure.panels = {std::move(panel)};
  return figure;
}

namespace {

/// Why no curve stands for the runs of a case.
std::string why_unfitted(const SweepDimension& levels, const Fragility& fit, const FigureOptions& options) {
  switch (fit.kind) {
    case Fragility::Kind::separated:
      return word(options, "no fit: no event up to {}, events alone from {}", intensity_text(levels, fit.lower),
                  intensity_text(levels, fit.upper));
    case Fragility::Kind::no_event:
      return word(options, "no fit: no run has the event");
    case Fragility::Kind::all_events:
      return word(options, "no fit: every run has the event");
    case Fragility::Kind::one_intensity:
      return word(options, "no fit: one intensity alone");
    case Fragility::Kind::falling:
      return word(options, "no fit: events do not become likelier with intensity");
    case Fragility::Kind::no_data:
      return word(options, "no fit: no runs");
    case Fragility::Kind::fitted:
      break;
  }
  return {};
}

}  // namespace

namespace {

/// "observed, n = 20", without the number of runs of a level where that is not alike.
std::string observed_label(const std::vector<IntensityCount>& counts, const FigureOptions& options) {
  const auto has_runs = [](const IntensityCount& one) { return one.runs > 0; };
  const auto first = std::find_if(counts.begin(), counts.end(), has_runs);
  const bool are_alike = first != counts.end() && std::all_of(first, counts.end(), [&](const IntensityCount& one) {
                           return one.runs == 0 || one.runs == first->runs;
                         });
  if (!are_alike || first->runs < 2) return word(options, "observed");
  return word(options, "observed") + ", n = " + std::to_string(first->runs);
}

}  // namespace

Figure fragility_figure(const SweepData& sweep, const FigureOptions& options) {
  const Analysis ida = analysis(sweep);
  const SweepDimension& levels = ida.levels;
  const IdaResults results = event_results(sweep, options.event);
  if (const std::string fault = method_fault(results, options.method); !fault.empty()) throw NoFigure(fault);
  auto cases = sweep.combinations(sweep.chosen(options.at), ida.others);
  if (options.choose) thin_out(cases);
  if (cases.size() > most_cases) {
    std::vector<std::string> names;
    for (const std::size_t d : ida.others) names.push_back(sweep.dimensions()[d].name);
    throw NoFigure(fmt::format("{} combinations of {} are too many for one figure: fix some with --at NAME=VALUE",
                               cases.size(), fmt::join(names, ", ")));
  }
  const bool pounding = options.event == pounding_event;
  const bool collapse = options.event == collapse_event;
  const std::string event = event_text(options.event, unit_text(results.quantity_units));
  Panel panel{.x = intensity_axis(levels, options),
              .y = {.label = pounding   ? word(options, "Probability of pounding P [–]")
                             : collapse ? word(options, "Probability of collapse P [–]")
                                        : "P(" + event + ") [–]",
                    .from = 0,
                    .to = 1.12,  // names stand above those that have reached 1
                    .places = {0, 0.2, 0.4, 0.6, 0.8, 1}},
              .height = 5.5,
              .names_at_ends = true};
  std::vector<std::string> names;
  for (const std::vector<std::size_t>& one : cases) names.push_back(case_name(sweep, ida, one));
  std::vector<std::string> in_short = short_names(names);  // of all but the first
  if (!are_parts_of(in_short, names)) in_short = names;
  std::vector<Curve> areas, edges, lines;
  std::string finding;
  std::vector<std::string> unfitted;  // reasons, one a case
  bool any_event = false, is_observed_named = false;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Curve observed;
    tell_apart(observed, c);
    observed.line = Line::none;
    observed.mark = mark_of(c + 1);  // open, as discs hide the curve
    const CaseFragility fragility = fit_case(results.table, case_number(sweep, ida, cases[c]), {}, options.method);
    for (const IntensityCount& count : fragility.counts) {
      if (count.runs == 0) continue;
      observed.x.push_back(count.intensity);
      observed.y.push_back(static_cast<double>(count.events) / static_cast<double>(count.runs));
    }
    any_event = any_event || fragility.events > 0;
    const std::string observed_words = observed_label(fragility.counts, options);
    const Fragility& fit = fragility.fit;
    const std::string& name = names[c];
    if (fit.kind != Fragility::Kind::fitted) {
      unfitted.push_back(why_unfitted(levels, fit, options));
      finding += (finding.empty() ? "" : "; ") + (name.empty() ? "" : name + ": ") + unfitted.back();
    } else if (fit.median > 0 && std::isfinite(fit.median)) {
      finding += (finding.empty() ? "" : "; ") + (name.empty() ? "" : name + ": ") +
                 word(options, "median intensity {}, dispersion {}", intensity_text(levels, fit.median),
                      number(fit.dispersion));
      if (const auto distance = fragility.distance()) {
        finding += ", " + word(options, "distance from observed {}", number(*distance));
      }
      if (fragility.is_misfit()) finding += ", " + word(options, "not lognormal");
      if (is_extrapolated(fragility.counts, fit)) finding += ", " + word(options, "extrapolated");
    }
    if (fit.kind == Fragility::Kind::fitted) {
      Curve line{.label = name.empty() ? word(options, "lognormal fit") : c == 0 ? name : in_short[c], .width = 1.3};
      tell_apart(line, c);
      line.mark = Mark::none;
      Curve area{.label = areas.empty() ? word(options, "95 % bounds") : "", .tone = pale_of(line.tone)};
      // Beyond the levels analysed the curve is told apart.
      const double first = observed.x.front(), last = observed.x.back();
      Curve below = line, above = line;
      for (Curve* const part : {&below, &above}) {
        part->label.clear();
        part->line = Line::dashed;
      }
      constexpr int steps = 200;
      constexpr double confidence = 0.95;
      for (int i = 1; i <= steps; ++i) {
        const double x = *panel.x.to * i / steps;
        const double fitted = fit.probability(x);
        for (Curve* const part : {&below, &line, &above}) {
          const bool is_here = part == &below ? x <= first : part == &above ? x >= last : x >= first && x <= last;
          if (!is_here) continue;
          part->x.push_back(x);
          part->y.push_back(fitted);
        }
        const auto bounds = probability_bounds(fragility, x, confidence);
        if (!bounds) continue;
        area.x.push_back(x);
        area.y.push_back(bounds->lower);
        area.top.push_back(bounds->upper);
      }
      if (!area.x.empty()) {
        if (cases.size() > 1) {  // where bands of several curves lie over one another their edges tell them apart
          for (const std::vector<double>* const y : {&area.y, &area.top}) {
            edges.push_back({.x = area.x, .y = *y, .tone = line.tone, .line = Line::dotted, .width = 0.7});
          }
        }
        areas.push_back(std::move(area));
      }
      line.legend_mark = observed.mark;
      lines.push_back(std::move(line));
      for (Curve* const part : {&below, &above}) {
        if (part->x.size() > 1) lines.push_back(std::move(*part));
      }
    } else {  // nothing that a colour could stand for
      observed.label = name.empty() ? observed_words : word(options, "{}, no fit", name);
      observed.tone = Tone::grey;
    }
    if (fit.kind == Fragility::Kind::fitted && !is_observed_named) {
      observed.label = observed_words;
      is_observed_named = true;
    }
    lines.push_back(std::move(observed));
  }
  if (!any_event) {
    panel.note = word(options, "no run has the event");
  } else if (unfitted.size() == cases.size()) {
    const bool is_one = std::equal(unfitted.begin() + 1, unfitted.end(), unfitted.begin());
    panel.title = is_one ? unfitted.front() : word(options, "no fit of any: shares of runs as observed");
  } else if (!unfitted.empty()) {
    panel.title = unfitted.size() == 1 ? unfitted.front() : "";
  }
  panel.curves = areas;
  panel.curves.insert(panel.curves.end(), edges.begin(), edges.end());
  panel.curves.insert(panel.curves.end(), lines.begin(), lines.end());
  return {.title = fmt::format("Fragility: probability of {} against intensity, lognormal fits with bootstrap bounds",
                               pounding ? "pounding" : event),
          .finding = panel.note.empty() ? finding : panel.note,
          .lacks = areas.empty() ? "bounds" : "",
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
