#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/number_text.h"
#include "bentur/study/risk/risk_report.h"

namespace bentur {
namespace {

constexpr double worth_saying = 0.1;  // of a rate, which is worth saying

std::string level_unit(const std::string& unit) {
  const std::string squared = "/s2";
  return unit.ends_with(squared) ? unit.substr(0, unit.size() - squared.size()) + "/s²" : unit;
}

/// "width = 0.1 m": what varies, of one case. @param along of each axis, whether it is named; empty: all are
std::string risk_case_name(const IdaResults& results, std::size_t c, const std::vector<bool>& along = {}) {
  std::string text;
  const std::vector<std::size_t> places = results.places(c);
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (!along.empty() && !along[axis]) continue;
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      const std::size_t place = places[axis];
      text += (text.empty() ? "" : ", ") + coordinate.name + " = ";
      text += coordinate.texts.empty() ? number(coordinate.numbers[place]) : coordinate.texts[place];
      if (!coordinate.units.empty() && coordinate.units != "1") text += " " + coordinate.units;
    }
  }
  return text;
}

/// Adds how well the curve describes the runs, where that is known.
void add_distance(const CaseRisk& risk, std::vector<StoryValue>& values) {
  const std::optional<double> distance = risk.fragility.distance();
  values.push_back({"fit", std::string(distance ? "story.risk_distance" : ""), {}, distance.has_value()});
  if (distance) values.push_back({"distance", *distance});
}

void tell_fragility(const RiskReport& report, const CaseRisk& risk, std::vector<Statement>& statements,
                    const std::string& subject) {
  const std::string unit = level_unit(report.hazard.unit);
  const Fragility& fit = risk.fragility.fit;
  if (risk.is_lognormal() && fit.collapse) {
    statements.push_back({.kind = "risk_cloud",
                          .values = {{"median", fit.median, unit},
                                     {"dispersion", fit.dispersion},
                                     {"half", fit.collapse->intensity_of(0.5), unit},
                                     {"collapsed", static_cast<double>(fit.collapse->collapsed)},
                                     {"runs", static_cast<double>(fit.collapse->runs)},
                                     {"observed", risk.observed.rate}},
                          .subject = subject});
    add_distance(risk, statements.back().values);
  } else if (risk.lognormal) {
    statements.push_back({.kind = risk.is_lognormal() ? "risk_lognormal" : "risk_misfit",
                          .severity = risk.is_lognormal() ? Severity::finding : Severity::warning,
                          .values = {{"median", fit.median, unit},
                                     {"dispersion", fit.dispersion},
                                     {"lognormal", risk.lognormal->rate},
                                     {"observed", risk.observed.rate},
                                     {"closed", risk.closed_form.value_or(0)}},
                          .subject = subject});
    add_distance(risk, statements.back().values);
  } else if (!risk.fragility.is_of_all()) {
    const CollapseFit& collapse = *fit.collapse;
    const bool is_separated = collapse.kind == CollapseFit::Kind::separated;
    statements.push_back({.kind = is_separated ? "risk_collapse_separated" : "risk_collapse_falling",
                          .severity = Severity::warning,
                          .values = {{"collapsed", static_cast<double>(collapse.collapsed)},
                                     {"runs", static_cast<double>(collapse.runs)}},
                          .subject = subject});
  } else {
    statements.push_back({.kind = "risk_observed",
                          .severity = Severity::warning,
                          .values = {{"observed", risk.observed.rate}},
                          .subject = subject});
  }
}

/// Of a rate by a curve what comes from intensities above all that were run, as far as the hazard says [1/year].
double rate_above_levels(const RiskReport& report, const AnnualRate& rate) {
  const std::vector<double> levels = report.results.table.intensities();
  const std::vector<double>& at = report.hazard.intensity;
  double above = 0;
  for (std::size_t i = 0; !levels.empty() && i < report.hazard.segments(); ++i) {
    if (at[i + 1] <= levels.back()) continue;
    const double part = std::log(at[i + 1] / std::max(at[i], levels.back())) / std::log(at[i + 1] / at[i]);
    above += part * rate.parts[i];
  }
  return above;
}

/// What makes the rate less sure than its digits.
void tell_unknown(const RiskReport& report, const CaseRisk& risk, std::vector<Statement>& statements,
                  const std::string& subject) {
  const AnnualRate& told = risk.told();
  const std::string unit = level_unit(report.hazard.unit);
  if (told.beyond > worth_saying * told.rate) {
    statements.push_back({.kind = "risk_beyond",
                          .severity = Severity::warning,
                          .values = {{"part", 100 * told.beyond / told.rate, "%"}},
                          .subject = subject});
  }
  const double above = risk.is_lognormal() ? rate_above_levels(report, told) : 0;
  if (above > worth_saying * told.rate) {
    statements.push_back(
        {.kind = "risk_above",
         .severity = Severity::warning,
         .values = {{"part", 100 * above / told.rate, "%"}, {"last", report.results.table.intensities().back(), unit}},
         .subject = subject});
  }
  if (told.below > worth_saying * told.rate) {
    const bool ends = std::isfinite(told.below);
    statements.push_back({.kind = ends ? "risk_below" : "risk_below_open",
                          .severity = Severity::warning,
                          .values = {{"first", report.hazard.intensity.front(), unit}, {"below", told.below}},
                          .subject = subject});
  }
}

/// From which intensities, and which record, most of the rate comes.
void tell_shares(const RiskReport& report, const CaseRisk& risk, std::vector<Statement>& statements,
                 const std::string& subject) {
  const AnnualRate& told = risk.told();
  const HazardCurve& hazard = report.hazard;
  if (!(told.rate > 0)) return;
  // The neighbouring segments that hold half of it.
  std::size_t best_first = 0, best_last = hazard.segments() - 1;
  double best_width = std::log(hazard.intensity.back() / hazard.intensity.front()), best_sum = 0;
  for (std::size_t first = 0; first < hazard.segments(); ++first) {
    double sum = 0;
    for (std::size_t last = first; last < hazard.segments(); ++last) {
      sum += told.parts[last];
      if (sum < 0.5 * told.rate) continue;
      const double width = std::log(hazard.intensity[last + 1] / hazard.intensity[first]);
      if (width <= best_width) {
        best_first = first;
        best_last = last;
        best_width = width;
        best_sum = sum;
      }
      break;
    }
  }
  const std::string unit = level_unit(hazard.unit);
  if (best_sum > 0) {
    statements.push_back({.kind = "risk_intensities",
                          .values = {{"from", hazard.intensity[best_first], unit},
                                     {"to", hazard.intensity[best_last + 1], unit},
                                     {"part", 100 * best_sum / told.rate, "%"}},
                          .subject = subject});
  }
  const auto most = std::max_element(risk.of_records.begin(), risk.of_records.end());
  const auto record = static_cast<std::size_t>(most - risk.of_records.begin());
  if (risk.of_records.size() > 1 && *most > 0 && record < report.results.records.size()) {
    statements.push_back({.kind = "risk_record",
                          .values = {{"record", report.results.records[record]},
                                     {"part", 100 * *most / risk.observed.rate, "%"},
                                     {"even", 100.0 / static_cast<double>(risk.of_records.size()), "%"}},
                          .subject = subject});
  }
}

/// Why runs that show no event, or what they need, bound nothing: of some it is not known, or they make no case.
void add_why(long failed, long open, std::vector<StoryValue>& values) {
  const char* const key = failed == 0 ? "story.risk_why_open"
                          : open == 0 ? "story.risk_why_failed"
                                      : "story.risk_why_both";
  values.push_back({"failed", static_cast<double>(failed)});
  values.push_back({"open", static_cast<double>(open)});
  values.push_back({"why", std::string(key), {}, true});
}

}  // namespace

Story risk_story(const RiskReport& report, const RiskRequest& request) {
  Story story;
  if (report.results.open.runs > 0) {
    story.statements.push_back(open_needs_statement(report.results.open, report.results.done));
  }
  const bool has_cases = report.cases.size() > 1;
  for (const CaseRisk& risk : report.cases) {
    const std::string subject = has_cases ? risk_case_name(report.results, risk.c) : "";
    const double rate = risk.told().rate;
    const bool is_pounding = request.event == pounding_event;
    const auto failed = static_cast<double>(risk.failed()), runs = static_cast<double>(risk.fragility.runs);
    if (!risk.is_of_some()) {
      story.statements.push_back(
          {.kind = "risk_nothing", .severity = Severity::warning, .values = {{"failed", failed}}, .subject = subject});
      continue;
    }
    const bool none = risk.fragility.events == 0;
    if (none && (risk.failed() > 0 || report.results.open.runs > 0)) {
      std::vector<StoryValue> why;
      add_why(risk.failed(), report.results.open.runs, why);
      if (!is_pounding) why.push_back({"event", request.event});
      story.statements.push_back({.kind = is_pounding ? "risk_no_pounding_known" : "risk_no_event_known",
                                  .severity = Severity::warning,
                                  .values = std::move(why),
                                  .subject = subject});
      continue;
    }
    if (risk.failed() > 0) {
      story.statements.push_back({.kind = "risk_of_others",
                                  .severity = Severity::warning,
                                  .values = {{"failed", failed}, {"all", failed + runs}},
                                  .subject = subject});
    }
    std::vector<StoryValue> values = {{"rate", rate},
                                      {"return", 1 / rate},
                                      {"probability", 100 * probability_in(request.years, rate), "%"},
                                      {"years", request.years}};
    if (!is_pounding) values.push_back({"event", request.event});
    if (risk.bounds && risk.is_lognormal()) {
      values.push_back({"low", risk.bounds->lower});
      values.push_back({"high", risk.bounds->upper});
      values.push_back({"confidence", 100 * request.bootstrap.confidence, "%"});
      values.push_back({"bounds", std::string("story.risk_bounds"), {}, true});
    } else {
      values.push_back({"bounds", std::string()});
    }
    story.statements.push_back({.kind = none          ? (is_pounding ? "risk_no_pounding" : "risk_no_event")
                                        : is_pounding ? "risk_pounding"
                                                      : "risk_event",
                                .severity = is_pounding && !none ? Severity::warning : Severity::finding,
                                .values = std::move(values),
                                .subject = subject});
    if (none) continue;
    tell_fragility(report, risk, story.statements, subject);
    tell_unknown(report, risk, story.statements, subject);
    tell_shares(report, risk, story.statements, subject);
  }
  for (const TargetGap& gap : report.gaps) {
    const std::string subject =
        report.gaps.size() > 1 ? risk_case_name(report.results, gap.c, report.gaps_vary_along) : "";
    const char* const kind = gap.is_known()  ? "risk_gap"
                             : gap.runs == 0 ? "risk_gap_nothing"
                             : gap.width     ? "risk_gap_open"
                                             : "risk_no_gap";
    std::vector<StoryValue> values = {{"gap", gap.width.value_or(0), report.gap_units},
                                      {"target", 100 * *request.target, "%"},
                                      {"years", request.years},
                                      {"rate", gap.rate}};
    if (!gap.is_known() && gap.width && gap.runs > 0) add_why(gap.failed, gap.open, values);
    story.statements.push_back({.kind = kind,
                                .severity = gap.is_known() ? Severity::finding : Severity::warning,
                                .values = std::move(values),
                                .subject = subject});
  }
  if (report.unit_is_taken) {
    const std::string unit = level_unit(report.hazard.unit);
    story.statements.push_back(
        {.kind = "risk_unit",
         .severity = Severity::warning,
         .values = {{"from", report.hazard.intensity.front(), unit}, {"to", report.hazard.intensity.back(), unit}}});
  }
  return story;
}

}  // namespace bentur
