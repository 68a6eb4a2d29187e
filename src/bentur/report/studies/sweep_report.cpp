#include "bentur/report/studies/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/story/remarks.h"
#include "bentur/model/story/study_story.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/story_text.h"
#include "bentur/report/studies/file_kinds.h"
#include "bentur/report/studies/sweep_data.h"
#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/fragility/ida_results.h"
#include "bentur/study/risk/risk_report.h"

namespace bentur {
namespace {

using html::element;
using html::Html;

/// Values of a quantity, run by run; of its points, floors or gaps the largest or the sum. NaN: the run has none.
std::vector<double> by_run(const SweepData& sweep, const std::string& quantity, bool sum) {
  if (sweep.results().find(quantity) == nullptr)
    return std::vector<double>(sweep.results().numbers("status").size(), 0.0);
  const std::vector<double>& all = sweep.all(quantity);
  const std::size_t owners = sweep.owners(quantity);
  std::vector<double> values;
  for (std::size_t run = 0; run < all.size() / owners; ++run) {
    double value = all[run * owners];
    for (std::size_t i = 1; i < owners; ++i) {
      const double other = all[run * owners + i];
      value = sum ? value + other : std::max(value, other);
    }
    values.push_back(value);
  }
  return values;
}

/// "width = 0.2, excitation = El Centro": where a run stands, without the directions in which `values` does not change.
std::string where(const SweepData& sweep, std::size_t run, const std::vector<double>& values) {
  std::vector<std::string> places;
  std::size_t stride = values.size();
  for (const SweepDimension& one : sweep.dimensions()) {
    stride /= one.size;
    const std::size_t at = run / stride % one.size;
    bool constant = true;
    for (std::size_t i = 0; i < one.size; ++i) {
      constant = constant && values[run - at * stride + i * stride] == values[run];
    }
    if (!constant && (one.is_text() || !one.numbers.empty())) places.push_back(one.choice(at));
  }
  for (const SweepDimension& one : sweep.sample_coordinates()) {
    places.push_back(one.choice(run));
  }
  return fmt::format("{}", fmt::join(places, ", "));
}

StudyOutcome outcome_of(const SweepData& sweep) {
  const std::vector<double> status = sweep.results().numbers("status");
  const std::vector<double> impacts = by_run(sweep, "impacts", true);
  const std::vector<double> forces = by_run(sweep, "peak_force", false);
  // Results of earlier versions watch no floors.
  const std::vector<double> unmodelled = by_run(sweep, "unmodelled_contacts", true);
  const std::vector<double> needed = by_run(sweep, "gap_needed", false);
  const std::vector<double> remarked = by_run(sweep, "remarks", true), doubted = by_run(sweep, "doubts", true);
  const std::vector<double> about = by_run(sweep, "remark_kinds", true), open = by_run(sweep, "open_needs", true);
  std::vector<long> in(remark_keys().size(), 0);  // runs with a remark about each
  StudyOutcome outcome{.runs = std::ssize(status)};
  std::optional<std::size_t> hardest, widest;
  for (std::size_t run = 0; run < status.size(); ++run) {
    if (status[run] != 0) {
      ++outcome.failed;
      continue;
    }
    if (unmodelled[run] > 0) ++outcome.unmodelled;
    if (impacts[run] > 0 || unmodelled[run] > 0) ++outcome.pounding;
    if (forces[run] > 0 && (!hardest || forces[run] > forces[*hardest])) hardest = run;
    outcome.remarked += remarked[run] > 0 ? 1 : 0;
    outcome.doubted += doubted[run] > 0 ? 1 : 0;
    for (std::size_t k = 0; about[run] > 0 && k < in.size(); ++k) {
      in[k] += (static_cast<std::uint64_t>(about[run]) >> k & 1U) != 0 ? 1 : 0;
    }
    const auto bits = static_cast<std::uint64_t>(open[run]);
    // Results of earlier versions say of collapse alone that it keeps a need from being known.
    outcome.open.add(bits == 0 && std::isnan(needed[run]) ? static_cast<unsigned>(OpenNeed::collapse) : bits);
    if (bits != 0 || std::isnan(needed[run])) continue;
    if (!widest || needed[run] > needed[*widest]) widest = run;
  }
  const auto placed = [&](std::size_t run, const std::vector<double>& values, const std::string& variable) {
    return PlacedValue{values[run], sweep.unit(variable), where(sweep, run, values)};
  };
  for (std::size_t k = 0; k < in.size(); ++k) {
    if (in[k] > 0) outcome.remarks.emplace_back(remark_keys()[k], in[k]);
  }
  if (hardest) outcome.hardest_force = placed(*hardest, forces, "peak_force");
  if (widest) outcome.gap_needed = placed(*widest, needed, "gap_needed");
  return outcome;
}

html::PageSection verdict(const SweepData& sweep, const Words& say) {
  Html block;
  bool grave = false;
  for (const SaidStatement& one : said(study_story(outcome_of(sweep)).statements, say)) {
    // The gravest has its badge first.
    if (block.str().empty() && !one.badge.empty()) block += element("p", one.badge, "class=\"badge\"");
    block += element("p", one.text, one.badge.empty() ? "" : "class=\"lead\"");
    grave = grave || is_grave(one.severity);
  }
  return {"verdict", say("heading.verdict"), element("div", block, html::verdict_class(grave))};
}

/// What varies, and within which bounds.
html::PageSection varied(const SweepData& sweep, const Words& say) {
  std::vector<std::string> names, counts, values;
  const auto add = [&](const SweepDimension& one) {
    names.push_back(one.label.empty() ? one.name : one.label);
    counts.push_back(std::to_string(one.size));
    if (one.numbers.empty()) {
      const auto shown = std::min<std::ptrdiff_t>(std::ssize(one.texts), 12);
      values.push_back(fmt::format("{}{}", fmt::join(one.texts.begin(), one.texts.begin() + shown, ", "),
                                   shown < std::ssize(one.texts) ? ", …" : ""));
    } else {
      const auto [least, most] = std::minmax_element(one.numbers.begin(), one.numbers.end());
      values.push_back(number(*least) + " … " + number(*most));
    }
  };
  for (const SweepDimension& one : sweep.dimensions()) add(one);
  for (const SweepDimension& one : sweep.sample_coordinates()) add(one);
  html::HtmlTable table;
  table.add(say("sweep.varies"), "", names, false);
  table.add(say("sweep.count"), "", counts);
  table.add(say("sweep.values"), "", values, false);
  return {"varied", say("heading.varied"), table.called(say("varied.table")).markup()};
}

/// "0.234", or why there is none.
std::string known(double value, bool is_known) { return is_known ? number(value) : "–"; }

std::string interval_text(double lower, double upper) {
  const auto end = [](double value) { return std::isfinite(value) ? number(value) : std::string("∞"); };
  return end(lower) + " … " + end(upper);
}

/// Columns that say which case each row is of, without one axis.
void add_cases(html::HtmlTable& table, const IdaResults& results, const std::vector<std::size_t>& cases,
               std::size_t without, const SweepData& sweep, const Words& say) {
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (axis == without) continue;
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      std::vector<std::string> cells;
      for (const std::size_t c : cases) {
        const std::size_t place = results.places(c)[axis];
        cells.push_back(coordinate.texts.empty() ? number(coordinate.numbers[place]) : coordinate.texts[place]);
      }
      const std::size_t d = sweep.index(coordinate.name);
      const std::string name = coordinate.is_gap_width()       ? say("column.gap")
                               : d < sweep.dimensions().size() ? sweep.dimensions()[d].short_name
                                                               : coordinate.name;
      const std::string unit = unit_text(coordinate.units);
      table.add(name, unit == "–" ? "" : unit, cells, coordinate.texts.empty());
    }
  }
}

/// θ and β of every case with their bounds, and how many runs say so.
html::HtmlTable fragility_table(const FragilityReport& report, const SweepData& sweep, const Words& say) {
  const std::string unit = unit_text(report.results.units);
  html::HtmlTable table;
  std::vector<std::size_t> cases;
  std::vector<std::string> medians, median_bounds, dispersions, dispersion_bounds, distances, events;
  for (std::size_t c = 0; c < report.fragilities.size(); ++c) {
    const CaseFragility& one = report.fragilities[c];
    const bool fitted = one.fit.kind == Fragility::Kind::fitted;
    const bool bounded = fitted && one.bounds.has_value();
    cases.push_back(c);
    medians.push_back(one.fit.kind == Fragility::Kind::no_event     ? "> " + number(one.fit.lower)
                      : one.fit.kind == Fragility::Kind::all_events ? "< " + number(one.fit.upper)
                      : one.fit.kind == Fragility::Kind::separated  ? interval_text(one.fit.lower, one.fit.upper)
                      : is_extrapolated(one.counts, one.fit)
                          ? number(one.fit.median) + " (" + say("ida.extrapolated") + ")"
                          : known(one.fit.median, fitted));
    distances.push_back(!one.distance()   ? "–"
                        : one.is_misfit() ? number(*one.distance()) + " (" + say("ida.misfit") + ")"
                                          : number(*one.distance()));
    median_bounds.push_back(bounded ? interval_text(one.bounds->median.lower, one.bounds->median.upper) : "–");
    dispersions.push_back(known(one.fit.dispersion, fitted));
    dispersion_bounds.push_back(bounded ? interval_text(one.bounds->dispersion.lower, one.bounds->dispersion.upper)
                                        : "–");
    events.push_back(fmt::format("{} / {}", one.events, one.runs));
  }
  add_cases(table, report.results, cases, report.results.axes.size(), sweep, say);
  table.add(say("ida.median"), unit, medians);
  table.add(say("ida.bounds"), unit, median_bounds);
  table.add(say("ida.dispersion"), "", dispersions);
  table.add(say("ida.bounds"), "", dispersion_bounds);
  table.add(say("ida.distance"), "", distances);
  table.add(say("ida.events"), "", events);
  return table;
}

/// The gap for some probabilities of pounding at some intensities, by the fragilities of `report`; nothing where no one
/// gap width varies.
html::HtmlTable gaps_for_probabilities(FragilityReport& report, const SweepData& sweep, const Words& say) {
  constexpr std::size_t most_levels = 6;
  const std::vector<double> levels = report.results.table.intensities();
  html::HtmlTable table;
  std::vector<std::size_t> cases;
  std::vector<double> intensities;
  const std::vector<double> probabilities = {0.1, 0.5};
  std::vector<std::vector<std::string>> gaps(probabilities.size()), bounds(probabilities.size());
  const std::size_t count = std::min(levels.size(), most_levels);
  for (std::size_t n = 0; n < count; ++n) {
    FragilityRequest request;
    request.at = levels[count > 1 ? n * (levels.size() - 1) / (count - 1) : 0];
    request.probabilities = probabilities;
    std::string error;
    if (!find_gaps(report, request, error) || report.gaps.empty()) return {};
    for (std::size_t g = 0; g < report.gaps.size(); ++g) {
      const GapAt& gap = report.gaps[g];
      const std::size_t p = g % probabilities.size();
      if (p == 0) {
        cases.push_back(gap.first_case);
        intensities.push_back(*request.at);
      }
      const auto& found = gap.estimate.gap;
      gaps[p].push_back(!found ? "–"
                               : (found->kind == GapForProbability::Kind::beyond     ? "> "
                                  : found->kind == GapForProbability::Kind::smallest ? "≤ "
                                                                                     : "") +
                                     number(found->width));
      const auto& interval = gap.estimate.bounds;
      const bool beyond =
          interval && (!std::isfinite(interval->lower) ||  // what is analysed, at either end
                       (found && found->kind == GapForProbability::Kind::smallest && interval->upper == found->width));
      bounds[p].push_back(!interval ? "–" : beyond ? gaps[p].back() : interval_text(interval->lower, interval->upper));
    }
  }
  add_cases(table, report.results, cases, report.gap_axis, sweep, say);
  const std::string unit = unit_text(report.results.units);
  const std::string units = unit_text(report.gap_units);
  table.add(say("ida.at"), unit, intensities);
  for (std::size_t p = 0; p < probabilities.size(); ++p) {
    table.add(say("ida.gap_for", {{"p", number(100 * probabilities[p])}}), units, gaps[p]);
    table.add(say("ida.bounds"), units, bounds[p]);
  }
  return table;
}

/// Whether the fragility of something else than pounding is asked for, or by something else than likelihood.
bool asks_more(const ReportOptions& options) {
  return options.event != pounding_event || options.method != FragilityMethod::likelihood;
}

/// The event that was asked for, by the method asked for, and of a cloud what its line is.
Html asked_fragility(const SweepData& sweep, const ReportOptions& options, const Words& say) {
  std::string error;
  const auto rule = parse_event(options.event, error);
  if (!rule) throw std::runtime_error(fmt::format("--event \"{}\" {}", options.event, error));
  const FragilityRequest request{.event = options.event, .method = options.method};
  const auto report = fragility_report(read_ida_results(sweep.results(), *rule), request, error);
  if (!report) throw std::runtime_error(error);
  Html content = html::under(
      "h3", say("ida.of_event", {{"event", options.event}, {"method", say("ida.method." + name_of(options.method))}}),
      fragility_table(*report, sweep, say));
  std::vector<std::string> lines;  // several cases may have one: what is needed does not depend on the gap given
  for (const CaseFragility& one : report->fragilities) {
    if (!one.cloud) continue;
    std::string line = say("ida.cloud", {{"a", number(one.cloud->a)},
                                         {"b", number(one.cloud->b)},
                                         {"sigma", number(one.cloud->sigma)},
                                         {"determination", number(one.cloud->determination)},
                                         {"distance", number(one.cloud->distance)},
                                         {"runs", std::to_string(one.cloud->runs)}});
    if (one.fit.collapse)
      line += " " + say("ida.cloud_collapse", {{"collapsed", std::to_string(one.fit.collapse->collapsed)}});
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  for (const std::string& line : lines) content += element("p", line);
  return content;
}

/// What an incremental dynamic analysis answers: how likely pounding is, and the gap for a probability.
html::PageSection ida_section(const SweepData& sweep, const ReportOptions& options, const Words& say) {
  std::string error;
  FragilityRequest request;
  const auto rule = parse_event(request.event, error);
  const IdaResults results = read_ida_results(sweep.results(), *rule);
  std::optional<FragilityReport> report = fragility_report(results, request, error);
  if (!report) return {};
  const std::string unit = unit_text(results.units);
  const std::string records = std::to_string(results.table.records / results.table.together);
  const std::vector<double> intensities = results.table.intensities();
  if (intensities.empty()) return {};
  Html content = element("p", say(results.table.is_cloud() ? "ida.asked_cloud" : "ida.asked",
                                  {{"records", records},
                                   {"levels", std::to_string(intensities.size())},
                                   {"intensity", sweep.intensities().short_name},
                                   {"from", html::quantity(intensities.front(), unit)},
                                   {"to", html::quantity(intensities.back(), unit)}}));
  content += html::under("h3", say("ida.pounding"), fragility_table(*report, sweep, say));
  if (asks_more(options)) content += asked_fragility(sweep, options, say);
  request.event = collapse_event;
  if (sweep.results().find("collapsed") != nullptr) {
    const auto collapse = parse_event(request.event, error);
    const auto of_collapse = fragility_report(read_ida_results(sweep.results(), *collapse), request, error);
    const bool any = of_collapse && std::any_of(of_collapse->fragilities.begin(), of_collapse->fragilities.end(),
                                                [](const CaseFragility& one) { return one.events > 0; });
    if (any) {
      content += html::under("h3", say("ida.collapse"), fragility_table(*of_collapse, sweep, say));
    }
  }
  content += html::under("h3", say("ida.gaps"), gaps_for_probabilities(*report, sweep, say));
  content +=
      element("p", say("ida.note", {{"resamples", std::to_string(request.bootstrap.resamples)}}), "class=\"note\"");
  if (results.table.is_cloud()) content += element("p", say("ida.note_cloud"), "class=\"note\"");
  return {"probability", say("heading.probability"), content};
}

/// How often a year, by the hazard of the site.
html::PageSection risk_section(const SweepData& sweep, const HazardCurve& hazard, const ReportOptions& options,
                               const Words& say) {
  std::string error;
  const RiskRequest request{.event = options.event, .method = options.method};
  const auto needed = sweep.results().find("gap_needed") != nullptr
                          ? std::optional(read_ida_results(sweep.results(), *parse_event(gap_needed_event, error)))
                          : std::nullopt;
  Html content;
  for (const double target : {0.1, 0.02}) {
    RiskRequest asked = request;
    asked.target = target;
    const auto report = risk_report(read_ida_results(sweep.results(), *parse_event(request.event, error)), needed,
                                    hazard, asked, error);
    if (!report) throw std::runtime_error("--hazard " + error);
    for (const SaidStatement& one : said(risk_story(*report, asked).statements, say)) {
      if (one.kind == "study_not_known") continue;  // the verdict says so
      const bool is_gap = one.kind.starts_with("risk_gap") || one.kind == "risk_no_gap";
      if (is_gap || target == 0.1) content += element("p", one.text);
    }
  }
  return {"risk", say("heading.risk"), content};
}

/// Every run, folded away.
html::PageSection runs_table(const SweepData& sweep, const Words& say) {
  constexpr std::size_t most_rows = 300;
  const std::vector<double> status = sweep.results().numbers("status");
  const std::vector<double> impacts = by_run(sweep, "impacts", true), forces = by_run(sweep, "peak_force", false);
  const std::string need = "gap_needed";
  const std::vector<double> needed = by_run(sweep, need, false);
  const std::size_t rows = std::min(status.size(), most_rows);
  html::HtmlTable table;
  std::vector<std::string> numbers;
  for (std::size_t run = 0; run < rows; ++run) numbers.push_back(std::to_string(run + 1));
  table.add("#", "", numbers);
  std::size_t stride = status.size();
  for (const SweepDimension& one : sweep.dimensions()) {
    stride /= one.size;
    if (!one.is_text() && one.numbers.empty()) continue;
    std::vector<std::string> cells;
    for (std::size_t run = 0; run < rows; ++run) cells.push_back(one.value(run / stride % one.size));
    table.add(one.short_name, one.unit == "–" ? "" : one.unit, cells, !one.is_text());
  }
  for (const SweepDimension& one : sweep.sample_coordinates()) {
    std::vector<std::string> cells;
    for (std::size_t run = 0; run < rows; ++run) cells.push_back(one.value(run));
    table.add(one.short_name, one.unit == "–" ? "" : one.unit, cells, !one.is_text());
  }
  const auto column = [&](const std::vector<double>& values) {
    std::vector<std::string> cells;
    for (std::size_t run = 0; run < rows; ++run) {
      cells.push_back(status[run] == 0 && !std::isnan(values[run]) ? number(values[run]) : "–");
    }
    return cells;
  };
  table.add(say("column.impacts"), "", column(impacts));
  if (sweep.results().find("peak_force") != nullptr) {
    table.add(say("sweep.peak_force"), sweep.unit("peak_force"), column(forces));
  }
  table.add(say("sweep.gap_needed"), sweep.unit(need), column(needed));
  Html content =
      element("details", element("summary", say("sweep.every_run")) + table.called(say("sweep.every_run")).markup());
  if (rows < status.size()) {
    content +=
        element("p", say("sweep.runs_cut", {{"shown", std::to_string(rows)}, {"all", std::to_string(status.size())}}),
                "class=\"screen note\"");
  }
  if (rows > html::rows_in_print) {
    content += element("p", say("sweep.runs_print", {{"all", std::to_string(status.size())}}), "class=\"print note\"");
  }
  return {"runs", say("heading.runs"), content};
}

/// A file as it was given, where the results hold it.
Html source(const SweepData& sweep, const Words& say, const std::string& attribute) {
  const std::string text = sweep.results().attribute(attribute);
  if (text.empty()) return {};
  return element("h3", say("heading." + attribute)) + element("pre", text, "tabindex=\"0\"");
}

/// The study's own: what the case is called, and what varies in it.
std::string study_title(const SweepData& sweep, const Words& say) {
  std::vector<std::string> names;
  for (const SweepDimension& one : sweep.dimensions()) {
    if (one.size > 1 && one.name != "sample") names.push_back(one.short_name.empty() ? one.name : one.short_name);
  }
  for (const SweepDimension& one : sweep.sample_coordinates()) names.push_back(one.short_name);
  if (names.empty()) return say("report.untitled");
  return say(is_ida(sweep.results()) ? "sweep.title_ida" : "sweep.title",
             {{"names", fmt::format("{}", fmt::join(names, ", "))}});
}

}  // namespace

std::string sweep_report_html(const NetcdfReader& results, const ReportOptions& options) {
  const Words say(options.language);
  const SweepData sweep(results, figure_words(options.language));
  const std::string given = results.attribute("title");
  const std::string title = study_title(sweep, say);
  std::vector<FigureKind> kinds = figure_kinds(results);
  if (is_ida(results) && asks_more(options)) kinds.push_back({"event", "probability of the event asked for"});
  const std::vector<html::PageFigure> figures = html::page_figures(
      kinds,
      [&](const std::string& kind, FigureOptions drawn) {
        if (kind == "event") {
          drawn.event = options.event;
          drawn.method = options.method;
        }
        return make_figure(results, kind, drawn);
      },
      "figure.sweep.", options.language);

  html::PageBody body;
  const std::optional<ProjectSpec> project = project_of(results.attribute("case"));
  body.header = html::title_block(project, title, say("sweep.by", {{"version", options.version}}), say) +
                element("p", given.empty() ? "" : say("sweep.of_case", {{"title", given}}), "class=\"note\"");
  body.sections = {verdict(sweep, say)};
  if (is_ida(results)) body.sections.push_back(ida_section(sweep, options, say));
  if (options.hazard && is_ida(results)) body.sections.push_back(risk_section(sweep, *options.hazard, options, say));
  body.sections.insert(body.sections.end(),
                       {html::figures_section(say, figures),
                        varied(sweep, say),
                        runs_table(sweep, say),
                        {"input", say("heading.input"), source(sweep, say, "study") + source(sweep, say, "case")}});
  if (project) body.running_head = html::running_head(project, title);
  return html::page(say, title, body, false);
}

}  // namespace bentur
