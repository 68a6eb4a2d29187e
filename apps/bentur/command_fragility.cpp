#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "arguments.h"
#include "bentur/core/not_known.h"
#include "bentur/core/version.h"
#include "bentur/files/ida_reading.h"
#include "bentur/report/story_text.h"
#include "bentur/study/fragility/fragility_report.h"
#include "commands.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct FragilityArguments {
  std::string file;
  FragilityRequest request;
  std::optional<double> at;
  std::string method = fragility_methods().front();
  std::string language = "en";
  bool json = false;
};

/// A unit as people write it, from UDUNITS: "cm s-2" is cm/s².
std::string shown(const std::string& units) {
  if (units == "1") return "";
  const std::string seconds = " s-2";
  return units.ends_with(seconds) ? units.substr(0, units.size() - seconds.size()) + "/s²" : units;
}

/// Columns for what the axes have in each of `cases`, but for axis `without`.
void add_case_columns(const IdaResults& results, const std::vector<std::size_t>& cases, std::size_t without,
                      Table& table) {
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (axis == without) continue;
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      std::vector<std::string> cells;
      for (const std::size_t c : cases) {
        const std::size_t place = results.places(c)[axis];
        cells.push_back(coordinate.texts.empty() ? number(coordinate.numbers[place]) : coordinate.texts[place]);
      }
      table.add(coordinate.name, shown(coordinate.units), cells);
    }
  }
}

/// What an axis-by-axis description of a case reads like: "width = 0.1 m".
std::string case_name(const IdaResults& results, std::size_t c) {
  std::string text;
  const std::vector<std::size_t> places = results.places(c);
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      const std::string units = shown(coordinate.units);
      text += fmt::format(
          "{}{} = {}{}", text.empty() ? "" : ", ", coordinate.name,
          coordinate.texts.empty() ? number(coordinate.numbers[places[axis]]) : coordinate.texts[places[axis]],
          units.empty() ? "" : " " + units);
    }
  }
  return text;
}

std::string with_unit_of(double x, const std::string& unit) {
  return unit.empty() ? number(x) : number(x) + " " + unit;
}

/// Where a single level has runs with the event and without: "no event below 0.2 g, in 3 of 10 runs at it, in all
/// above".
std::string one_level(const CaseFragility& fragility, const std::string& level, const Words& say) {
  long events = 0, runs = 0;
  bool below = false, above = false;
  for (const IntensityCount& count : fragility.counts) {
    below = below || (count.runs > 0 && count.intensity < fragility.fit.lower);
    above = above || (count.runs > 0 && count.intensity > fragility.fit.lower);
    if (count.intensity != fragility.fit.lower) continue;
    events = count.events;
    runs = count.runs;
  }
  if (runs == 0) return say("fragility.no_scatter", {{"level", level}});  // of a cloud, which no level lies on
  return say(std::string(below ? "fragility.none_below" : "fragility.some_at") + (above ? "" : "_largest"),
             {{"level", level}, {"events", fmt::format("{}", events)}, {"runs", fmt::format("{}", runs)}});
}

/// Why a case has no θ and β. @param is_cloud of the demands of runs that stand
std::string reason(const CaseFragility& fragility, const std::string& unit, const Words& say, bool is_cloud = false) {
  const Fragility& fit = fragility.fit;
  switch (fit.kind) {
    case Fragility::Kind::fitted:
      return {};
    case Fragility::Kind::separated:
      return fit.lower < fit.upper
                 ? say("fragility.separated",
                       {{"lower", with_unit_of(fit.lower, unit)}, {"upper", with_unit_of(fit.upper, unit)}})
                 : say("fragility.no_beta", {{"where", one_level(fragility, with_unit_of(fit.lower, unit), say)}});
    case Fragility::Kind::no_event:
      return say("fragility.no_event", {{"level", with_unit_of(fit.lower, unit)}});
    case Fragility::Kind::all_events:
      return say("fragility.all_events", {{"level", with_unit_of(fit.upper, unit)}});
    case Fragility::Kind::one_intensity:
      return say("fragility.one_intensity");
    case Fragility::Kind::falling:
      return say("fragility.falling");
    case Fragility::Kind::no_data:
      break;
  }
  return say(is_cloud && fragility.runs > 0 ? "fragility.few_stand" : "fragility.no_data");
}

/// That θ is beyond what was analysed.
std::string beyond(const CaseFragility& one, const std::string& unit, const Words& say) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const IntensityCount& count : one.counts) {
    if (count.runs == 0) continue;
    lowest = std::min(lowest, count.intensity);
    highest = std::max(highest, count.intensity);
  }
  return say(one.is_unscaled ? "fragility.beyond_unscaled" : "fragility.beyond",
             {{"from", with_unit_of(lowest, unit)}, {"to", with_unit_of(highest, unit)}});
}

/// θ and β of a part of the runs, or why there are none.
std::string part_text(const Fragility& fit, const std::vector<IntensityCount>& counts, const std::string& unit,
                      const Words& say) {
  CaseFragility part;
  part.counts = counts;
  part.fit = fit;
  if (fit.kind != Fragility::Kind::fitted) return reason(part, unit, say);
  return fmt::format("θ {}, β {}, KS {}{}", with_unit_of(fit.median, unit), number(fit.dispersion),
                     number(fit_distance(counts, fit).value_or(not_known)),
                     (is_misfit(counts, fit) ? "; " + say("fragility.misfit") : "") +
                         (is_extrapolated(counts, fit) ? "; " + beyond(part, unit, say) : ""));
}

/// "from 0.2 to 0.4", or nothing.
std::string from_to(const std::optional<Interval>& bounds, const Words& say) {
  return !bounds || std::isnan(bounds->lower)
             ? ""
             : say("fragility.from_to", {{"from", number(bounds->lower)}, {"to", number(bounds->upper)}});
}

/// Which runs of a cloud collapse, and P(event) of all.
std::string collapse_text(const CaseFragility& one, const std::string& unit, const Words& say) {
  if (!one.fit.collapse) return say("fragility.no_collapse");
  const CollapseFit& fit = *one.fit.collapse;
  const std::string counted = say(
      "fragility.collapsed", {{"collapsed", fmt::format("{}", fit.collapsed)}, {"runs", fmt::format("{}", fit.runs)}});
  switch (fit.kind) {
    case CollapseFit::Kind::fitted:
      break;
    case CollapseFit::Kind::separated:
      if (fit.upper < fit.lower) return say("fragility.collapse_below", {{"counted", counted}});
      return say(
          "fragility.collapse_apart",
          {{"counted", counted}, {"upper", with_unit_of(fit.upper, unit)}, {"lower", with_unit_of(fit.lower, unit)}});
    default:
      return say("fragility.collapse_falling", {{"counted", counted}});
  }
  std::string text = say("fragility.collapse_fitted", {{"counted", counted},
                                                       {"intercept", number(fit.intercept)},
                                                       {"slope", number(fit.slope)},
                                                       {"half", with_unit_of(fit.intensity_of(0.5), unit)}});
  if (const auto all = one.of_all()) {
    text +=
        say("fragility.collapse_all", {{"median", with_unit_of(all->median, unit) + from_to(all->median_bounds, say)},
                                       {"dispersion", number(all->dispersion) + from_to(all->dispersion_bounds, say)}});
  }
  return text;
}

/// Collapse by itself, and what a cloud or stripes are made of.
std::string more(const CaseFragility& one, const std::string& of, const std::string& unit, const Words& say) {
  std::string text;
  const auto add = [&](const std::string& what) { text += fmt::format("  {}{}.\n", of, what); };
  if (one.split) {
    add(say("fragility.collapse_alone",
            {{"what", part_text(one.split->collapse, one.split->collapse_counts, unit, say)}}));
    add(say("fragility.standing", {{"what", part_text(one.split->standing, one.split->standing_counts, unit, say)}}));
  }
  if (one.cloud) {
    add(say("fragility.line", {{"a", number(one.cloud->a)},
                               {"b", number(one.cloud->b)},
                               {"sigma", number(one.cloud->sigma)},
                               {"determination", number(one.cloud->determination)},
                               {"runs", fmt::format("{}", one.cloud->runs)}}));
    add(collapse_text(one, unit, say));
  }
  for (const Stripe& stripe : one.stripes) {
    add(say("fragility.stripe", {{"level", with_unit_of(stripe.intensity, unit)},
                                 {"median", number(stripe.median)},
                                 {"dispersion", number(stripe.dispersion)},
                                 {"collapsed", fmt::format("{}", stripe.collapsed)},
                                 {"runs", fmt::format("{}", stripe.runs)}}));
  }
  return text;
}

std::string curves_text(const FragilityReport& report, const std::string& unit, bool is_cloud, const Words& say) {
  std::vector<std::size_t> cases;
  std::vector<double> median, median_low, median_high, dispersion, dispersion_low, dispersion_high, distance;
  std::vector<std::string> runs, events;
  std::string notes;
  for (std::size_t c = 0; c < report.fragilities.size(); ++c) {
    const CaseFragility& one = report.fragilities[c];
    const bool known = one.fit.kind == Fragility::Kind::fitted;
    cases.push_back(c);
    median.push_back(known ? one.fit.median : not_known);
    dispersion.push_back(known ? one.fit.dispersion : not_known);
    median_low.push_back(known && one.bounds ? one.bounds->median.lower : not_known);
    median_high.push_back(known && one.bounds ? one.bounds->median.upper : not_known);
    dispersion_low.push_back(known && one.bounds ? one.bounds->dispersion.lower : not_known);
    dispersion_high.push_back(known && one.bounds ? one.bounds->dispersion.upper : not_known);
    runs.push_back(fmt::format("{}", one.runs));
    events.push_back(fmt::format("{}", one.events));
    const std::string name = case_name(report.results, c);
    const std::string of = name.empty() ? "" : name + ": ";
    distance.push_back(one.distance().value_or(not_known));
    if (!known) notes += fmt::format("  {}{}.\n", of, reason(one, unit, say, is_cloud));
    if (one.is_misfit()) notes += fmt::format("  {}{}.\n", of, say("fragility.misfit"));
    if (is_extrapolated(one.counts, one.fit)) notes += fmt::format("  {}{}.\n", of, beyond(one, unit, say));
    notes += more(one, of, unit, say);
  }
  Table table;
  add_case_columns(report.results, cases, report.results.axes.size(), table);
  table.add("θ", unit, median);
  table.add(say("fragility.from"), unit, median_low);
  table.add(say("fragility.to"), unit, median_high);
  table.add("β", "", dispersion);
  table.add(say("fragility.from"), "", dispersion_low);
  table.add(say("fragility.to"), "", dispersion_high);
  table.add("KS", "", distance);
  table.add(say("fragility.events"), "", events);
  table.add(say("fragility.runs"), "", runs);
  return table.text() + (notes.empty() ? "" : "\n" + notes);
}

std::string gaps_text(const FragilityReport& report, const FragilityRequest& request, const std::string& unit,
                      const Words& say) {
  std::vector<std::size_t> cases;
  std::vector<std::string> probabilities, gaps, lower, upper;
  const auto bound = [](const std::optional<Interval>& bounds, double Interval::*end) {
    if (!bounds) return std::string("–");
    return std::isfinite((*bounds).*end) ? number((*bounds).*end) : "∞";
  };
  bool unknown = false;
  for (const GapAt& gap : report.gaps) {
    cases.push_back(gap.first_case);
    probabilities.push_back(number(gap.probability));
    lower.push_back(bound(gap.estimate.bounds, &Interval::lower));
    upper.push_back(bound(gap.estimate.bounds, &Interval::upper));
    if (!gap.estimate.gap) {
      gaps.emplace_back("–");
      unknown = true;
      continue;
    }
    const auto kind = gap.estimate.gap->kind;
    gaps.push_back((kind == GapForProbability::Kind::beyond     ? "> "
                    : kind == GapForProbability::Kind::smallest ? "≤ "
                                                                : "") +
                   number(gap.estimate.gap->width));
  }
  Table table;
  add_case_columns(report.results, cases, report.gap_axis, table);
  table.add("p", "", probabilities);
  table.add(report.gap_name, shown(report.gap_units), gaps);
  table.add(say("fragility.from"), shown(report.gap_units), lower);
  table.add(say("fragility.to"), shown(report.gap_units), upper);
  return "\n" + say("fragility.gaps", {{"at", with_unit_of(*request.at, unit)}}) + "\n\n" + table.text() +
         (unknown ? "\n  " + say("fragility.gap_unknown") + "\n" : "");
}

std::string text(const FragilityReport& report, const FragilityRequest& request, const Words& say) {
  const IdaResults& results = report.results;
  const std::string& unit = results.study_unit;
  const std::string quantity = shown(results.quantity_units);
  const bool is_cloud = request.method == FragilityMethod::cloud;
  std::string result = results.title.empty() ? "" : results.title + "\n";
  result +=
      say("fragility.event",
          {{"event", request.event + (quantity.empty() ? "" : " " + quantity)},
           {"records",
            say.count("fragility.count.records", static_cast<long>(results.table.records / results.table.together)) +
                (results.table.together > 1 ? say("fragility.both_ways") : "")},
           {"scaled", results.table.is_cloud()
                          ? say("fragility.unscaled")
                          : say("fragility.levels", {{"levels", fmt::format("{}", results.table.levels.size())}})},
           {"intensity", results.intensity + (unit.empty() ? "" : " [" + unit + "]")}});
  result += "\n";
  if (results.open.runs > 0) {
    Story open{.statements = {open_needs_statement(results.open, results.done)}};
    result += "\n" + story_text(std::vector<std::string>(), open, say, Told::all);
  }
  result += "\n" + curves_text(report, unit, is_cloud, say);
  if (!report.gaps.empty()) result += gaps_text(report, request, unit, say);
  std::string by = say("fragility.by." + std::string(name_of(request.method)));
  if (is_cloud && !results.table.is_cloud()) by += say("fragility.ks_of_that");
  result += "\n" + say("fragility.formula", {{"by", by}}) + " ";
  result += say(!results.table.is_cloud() ? "fragility.ks" : is_cloud ? "fragility.ks_cloud" : "fragility.ks_none");
  const bool bounds = std::any_of(report.fragilities.begin(), report.fragilities.end(),
                                  [](const CaseFragility& one) { return one.bounds.has_value(); });
  if (bounds) {
    result += say("fragility.bounds", {{"confidence", number(100 * request.bootstrap.confidence)},
                                       {"resamples", fmt::format("{}", request.bootstrap.resamples)}});
  }
  return result + "\n";
}

void run(const FragilityArguments& arguments) {
  FragilityRequest request = arguments.request;
  request.at = arguments.at;
  request.method = fragility_method(arguments.method);
  for (const double p : request.probabilities) {
    if (!(p > 0 && p < 1)) throw Failure(exit_bad_input, fmt::format("bentur: --probability {}: must be in (0, 1)", p));
  }
  if (!(request.bootstrap.confidence > 0 && request.bootstrap.confidence < 1)) {
    throw Failure(exit_bad_input,
                  fmt::format("bentur: --confidence {}: must be in (0, 1)", request.bootstrap.confidence));
  }
  Diagnostics diagnostics;
  auto results = read_ida_results(arguments.file, request.event, diagnostics);
  std::string error;
  const auto report = results ? fragility_report(std::move(*results), request, error) : std::nullopt;
  if (!error.empty()) diagnostics.error({arguments.file, 0, 0}, error);
  if (!report) throw Failure(diagnostics, arguments.language);
  long failed = 0;
  for (const CaseFragility& one : report->fragilities) failed += one.failed;
  if (failed > 0) message(fmt::format("warning: {} runs whose values make no case are left out", failed));
  print(arguments.json ? fragility_json(*report, request, version())
                       : fitted(text(*report, request, Words(arguments.language))));
}

}  // namespace

void add_fragility_command(CLI::App& app) {
  auto arguments = std::make_shared<FragilityArguments>();
  FragilityRequest& request = arguments->request;
  CLI::App* command = app.add_subcommand("fragility", "Fragility curves from an incremental dynamic analysis");
  command->add_option("FILE", arguments->file, "results of bentur ida (NetCDF-4)")->required()->check(not_empty());
  command->add_option(
      "--event", request.event,
      "a quantity of the results compared with a number in its unit there, true where any point or floor "
      "has it; default \"impacts > 0\"");
  command
      ->add_option("--method", arguments->method,
                   "of θ and β: likelihood (default), cloud or stripes (of demands, events that exceed a number)")
      ->check(CLI::IsMember(fragility_methods()));
  CLI::Option* at =
      command->add_option("--at", arguments->at, "intensity for the gaps, in the unit of the levels")->check(finite());
  CLI::Option* probability =
      command->add_option("--probability", request.probabilities, "gaps for which P(event | --at) is no more than that")
          ->delimiter(',')
          ->check(finite());
  at->needs(probability);
  probability->needs(at);
  command->add_option("--along", request.along, "the gap width that is meant, where several vary")->needs(probability);
  command->add_option("--resamples", request.bootstrap.resamples, "of the bootstrap; default 1000")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--confidence", request.bootstrap.confidence, "of the bounds; default 0.95")->check(finite());
  command->add_option("--seed", request.bootstrap.seed, "of the bootstrap; default 1")->check(whole_number());
  command->add_flag("--json", arguments->json, "JSON instead of tables");
  add_language(*command, arguments->language);
  command->footer(
      "Example: bentur fragility ida.nc --event \"peak_force > 500\"\n"
      "The gap for 1 % and 10 % pounding probability: bentur fragility ida.nc --at 0.5 --probability 0.01,0.1");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
