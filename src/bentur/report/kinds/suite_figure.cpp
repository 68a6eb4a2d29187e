#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"

namespace bentur {

namespace {

constexpr double share_of_target = 0.9;  // that codes ask of the mean [-]

/// By how much the record that needs most of a gap needs more than is given; less than all where nothing is known.
double lack_of(const SuiteRun& run, std::size_t gap) {
  double most = -INFINITY;
  for (const SuiteRecordRun& one : run.records) {
    if (gap < one.needed.size() && one.judged[gap].is_facing()) {
      most = std::max(most, one.needed[gap] - one.judged[gap].width);
    }
  }
  return most;
}

/// The gap that lacks most.
std::size_t worst_gap(const SuiteRun& run) {
  const std::size_t gaps = gap_names(run.problem).size();
  if (gaps == 0) throw NoFigure("the case has no gap");
  std::size_t worst = 0;
  for (std::size_t gap = 1; gap < gaps; ++gap) worst = lack_of(run, gap) > lack_of(run, worst) ? gap : worst;
  return worst;
}

/// What the code that scales the records takes of a gap; nullptr where none does, or where it is not known.
const SuiteDemand* demand_of(const GapStudy& gaps, std::size_t gap) {
  if (gaps.needs.size() != 1 || gap >= gaps.needs.front().gaps.size() || !gaps.is_whole()) return nullptr;
  const std::optional<SuiteDemand>& demand = gaps.needs.front().gaps[gap].demand;
  return demand && demand->is_known() ? &*demand : nullptr;
}

/// What each record needs of a gap, by the tone of what is judged of it, an outline where that is of its motion
/// reversed, the first record uppermost.
Panel needs_panel(const SuiteRun& run, const GapStudy& gaps, std::size_t gap, const FigureOptions& options) {
  const std::string& length = run.c.units.length;
  const std::vector<SuiteRecord>& records = run.c.excitation.suite->records;
  const std::vector<std::string> names = gap_names(run.problem);
  const std::size_t count = run.records.size();
  std::vector<double> values;
  for (const SuiteRecordRun& one : run.records) {
    values.push_back(gap < one.needed.size() && std::isfinite(one.needed[gap]) ? one.needed[gap] : NAN);
  }
  Panel panel{.title = names.size() > 1 ? names[gap] : "",
              .x = {.label = with_unit(word(options, "Gap needed"), length), .from = 0},
              .height = 0.6 + 0.36 * static_cast<double>(count)};
  panel.y.names.resize(count);
  const std::vector<std::string> numbers = column(values);  // with digits alike
  bool some_unmodelled = false;
  std::set<std::pair<Sufficiency, bool>> named;
  const std::vector<const char*> judged_words = record_words(run, gap);
  double given = NAN, most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const SuiteRecordRun& one = run.records[i];
    const double place = static_cast<double>(count - 1 - i);
    panel.y.names[count - 1 - i] = records[i].name();
    if (std::isnan(values[i])) {
      const bool falls = gap < one.needed.size() && std::isinf(one.needed[gap]);
      panel.texts.push_back({.x = 0, .y = place, .text = word(options, falls ? "a building collapses" : "not known")});
      continue;
    }
    given = one.judged[gap].width;
    most = std::max({most, given, values[i]});
    const Sufficiency judged = without_rules(one.judged[gap].judgement);
    const bool is_reversed = governs_reversed(run, i, gap);
    panel.curves.push_back(is_reversed ? hollow_bar(0, values[i], place, 0.6, tone_of(judged))
                                       : bar(0, values[i], place, 0.6, area_tone_of(judged)));
    if (named.insert({judged, is_reversed}).second) {
      const std::string how = Words(options.language)(judged_words[i]);
      panel.curves.back().label = word(options, is_reversed ? "reversed: {}" : "as recorded: {}", how);
    }
    const bool is_unmodelled = one.is_not_modelled();
    panel.texts.push_back(
        {.x = values[i], .y = place, .text = numbers[i] + " " + length + (is_unmodelled ? " ×" : "")});
    some_unmodelled = some_unmodelled || is_unmodelled;
  }
  if (std::isnan(given)) throw NoFigure("no record has been run to its end, or no floors face one another");
  if (some_unmodelled) {  // marked behind the numbers, as a mark on a dark bar is lost in grey
    panel.curves.push_back({.label = word(options, "contact not modelled"),
                            .x = {not_known},
                            .y = {not_known},
                            .line = Line::none,
                            .mark = Mark::cross,
                            .complete = true});
  }
  const auto draw_across = [&](double at, const std::string& label, Line line) {  // over the bars
    panel.curves.push_back({.label = label + ": " + number(at) + " " + length,
                            .x = {at, at},
                            .y = {-0.5, static_cast<double>(count) - 0.5},
                            .line = line,
                            .width = 1.4});
  };
  draw_across(given, word(options, "given"), Line::dashed);
  if (const SuiteDemand* const demand = demand_of(gaps, gap)) {
    const bool is_mean = demand->measure.kind == SuiteMeasure::Kind::mean;
    draw_across(demand->taken(), word(options, is_mean ? "mean, by {}" : "largest, by {}", demand->measure.code),
                Line::dash_dot);
    most = std::max(most, demand->taken());
  }
  constexpr double of_names = 2.5;  // beside the bars [cm]
  double of_numbers = 0;
  for (const PlaceText& one : panel.texts) {
    if (one.x > 0) of_numbers = std::max(of_numbers, text_width(one.text) + 0.4);
  }
  const double room = options.width - of_names;  // of the frame
  panel.x.to = most / (1 - of_numbers / room);
  std::set<double> across;
  for (const Curve& line : panel.curves) {
    if (line.top.empty() && line.x.size() == 2) across.insert(line.x.front());
  }
  for (PlaceText& one : panel.texts) {  // behind the lines across the bars on which they would lie
    for (const double at : across) {
      if (at > one.x && at < one.x + (text_width(one.text) + 0.2) / room * *panel.x.to) one.x = at;
    }
  }
  return panel;
}

Figure needs_figure(const SuiteRun& run, const GapStudy& study, const FigureOptions& options) {
  const std::size_t gaps = gap_names(run.problem).size();
  if (options.gap && *options.gap >= gaps) throw NoFigure("there is no such gap: gaps are counted from 0");
  const std::size_t gap = options.gap ? *options.gap : worst_gap(run);
  Figure figure{.title = "What each record needs to stay apart without contact, the larger of both directions",
                .panels = {needs_panel(run, study, gap, options)},
                .width = options.width,
                .shared_legend = true};
  const std::size_t worst = governing_record(run, gap);
  const SuiteRecordRun& most = run.records[worst];
  const std::string& length = run.c.units.length;
  figure.finding = word(
      options, "largest {} under {}, given {}",
      std::isinf(most.needed[gap]) ? word(options, "a building collapses") : number(most.needed[gap]) + " " + length,
      run.c.excitation.suite->records[worst].name(), number(most.judged[gap].width) + " " + length);
  if (gaps > 1 && !options.gap) figure.part = word(options, "the most critical of {} gaps", std::to_string(gaps));
  return figure;
}

}  // namespace

std::size_t governing_record(const SuiteRun& run, std::optional<std::size_t> gap) {
  const std::size_t of_gap = gap ? *gap : worst_gap(run);
  const auto needed = [&](std::size_t record) {
    const std::vector<double>& all = run.records[record].needed;
    return of_gap < all.size() && !std::isnan(all[of_gap]) ? all[of_gap] : -1;
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < run.records.size(); ++i) worst = needed(i) > needed(worst) ? i : worst;
  return worst;
}

bool governs_reversed(const SuiteRun& run, std::size_t record, std::optional<std::size_t> gap) {
  const std::vector<bool>& all = run.records.at(record).is_of_reversed;
  const std::size_t of_gap = gap ? *gap : worst_gap(run);
  return of_gap < all.size() && all[of_gap];
}

std::vector<FigureKind> figure_kinds(const SuiteRun& /*run*/) {
  return {{"gap-needed", "gap that each record needs, beside the gap given"},
          {"suite", "spectra of the records, their mean, the target"}};
}

Figure make_figure(const SuiteRun& run, const GapStudy& gaps, const std::string& kind, const FigureOptions& options) {
  if (kind == "gap-needed") {
    Figure figure = needs_figure(run, gaps, options);
    figure.title = figure_title(options.language, "figure.gap-needed", std::move(figure.title));
    return figure;
  }
  if (kind == "suite") return suite_figure(*run.c.excitation.suite, run.c.units, options);
  refuse_figure(kind, "a suite", figure_kinds(run));
}

Figure suite_figure(const SuiteSpec& suite, const Units& units, const FigureOptions& options) {
  const auto in_g = [&](std::vector<double> values) {
    for (double& value : values) value /= standard_gravity(units.length);
    return values;
  };
  const std::vector<double>& periods = suite.target.periods;
  const auto [first, last] = suite.target.band();
  Panel panel{.x = {.label = word(options, "Period T [s]"), .from = first, .to = last, .logarithmic = true},
              .y = {.label = with_unit(word(options, "Acceleration Sa"), "g"), .from = 0},
              .height = 4.6,
              .names_at_ends = true};
  for (const SuiteRecord& record : suite.records) {
    panel.curves.push_back({.label = panel.curves.empty() ? word(options, "each record") : "",
                            .x = periods,
                            .y = in_g(record.spectrum),
                            .tone = Tone::grey,
                            .width = 0.7,
                            .of_several = true});
  }
  const std::vector<double> target = in_g(suite.target.ordinates), mean = in_g(suite.mean);
  panel.curves.push_back({.label = word(options, "target"),
                          .x = periods,
                          .y = target,
                          .tone = Tone::teal,
                          .line = Line::dashed,
                          .width = 1.6});
  if (suite.request.is_of_code()) {
    std::vector<double> least = target;
    for (double& value : least) value *= share_of_target;
    panel.curves.push_back({.label = word(options, "0.9 of the target"),
                            .x = periods,
                            .y = least,
                            .tone = Tone::teal,
                            .line = Line::dotted});
  }
  panel.curves.push_back({.label = word(options, "mean"), .x = periods, .y = mean, .width = 1.8});
  constexpr std::size_t most_named = 4;  // of the buildings
  const bool are_named = suite.buildings.size() <= most_named;
  for (std::size_t i = 0; i < suite.buildings.size(); ++i) {
    constexpr Line lines[] = {Line::dotted, Line::dash_dot, Line::dashed, Line::solid};
    const SuitePeriods& one = suite.buildings[i];
    RuleLine rule{.at = one.first, .vertical = true, .line = Line::dotted};
    if (are_named) {
      rule.label = word(options, "T₁ of {}", one.name);
      rule.line = lines[i];
    } else if (i == 0) {
      rule.label = word(options, "T₁ of the buildings");
    }
    panel.rules.push_back(std::move(rule));
  }
  double least_ratio = mean.front() / target.front();
  for (std::size_t i = 0; i < mean.size(); ++i) least_ratio = std::min(least_ratio, mean[i] / target[i]);
  Figure figure{.title = figure_title(options.language, "figure.suite",
                                      "Spectra of the records as scaled, their mean, and the target, damping ratio "
                                      "0.05"),
                .finding = word(options, "mean at least {} of the target", number(least_ratio)),
                .panels = {panel},
                .width = options.width,
                .shared_legend = true};
  return figure;
}

}  // namespace bentur
