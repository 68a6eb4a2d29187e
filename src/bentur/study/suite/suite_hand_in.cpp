#include "bentur/study/suite/suite_hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

constexpr double of_hundred = 100;
constexpr const char* not_known_word = "check.not_known";
constexpr const char* collapsed_word = "story.silence.collapsed";

std::optional<double> known(double value) { return !std::isfinite(value) ? std::nullopt : std::optional(value); }

/// The largest drift of each building under any record; a record that ended before its time has no largest.
void check_drifts(const SuiteRun& run, std::vector<CheckRow>& rows) {
  const bool ends_early = std::any_of(run.records.begin(), run.records.end(),
                                      [](const SuiteRecordRun& one) { return one.status != Status::done; });
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
    const Building& building = run.problem.buildings[b];
    const std::string name = fmt::format("peak_drift_ratio_{}", b + 1);
    const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                    [&](const SuiteQuantity& one) { return one.name == name; });
    if (building.is_rigid() || found == run.quantities.end()) continue;
    if (!building.has_gravity_loads) continue;  // there is no limit to hold it against
    const double most = run.largest(static_cast<std::size_t>(found - run.quantities.begin()));
    CheckRow row{.check = "check.stability",
                 .by = "collapse_drift",
                 .where = building.name,
                 .demand = known(of_hundred * most),
                 .limit = of_hundred * run.problem.collapse_drift,
                 .unit = "%"};
    if (std::isnan(most)) row.result = not_known_word;
    row.is_met = !ends_early && most <= run.problem.collapse_drift;
    rows.push_back(std::move(row));
  }
}

/// Contact under the records, with it modelled and not; how far what they need, the code that scales them and the rules
/// of [code] are met, which is said of a gap alone that is judged enough.
void check_gap(const SuiteRun& run, const GapStudy& study, Eigen::Index gap, const SuiteJudgement& judged,
               std::vector<CheckRow>& rows) {
  const RecordNeeds& needs = study.needs.front();
  const GapOverRecords& over = needs.gaps[static_cast<std::size_t>(gap)];
  const GivenGap& given = over.given.front();
  const std::string& name = study.gaps.at(gap).name;
  const bool collapses =
      std::any_of(needs.records.begin(), needs.records.end(), [](const RecordNeed& one) { return one.falls; });
  const std::optional<double> narrowest = given.narrowest();
  const bool faces = narrowest.has_value();
  const auto found = [&](Reason::Kind kind) {
    long records = 0;
    for (const JudgementOfMany::Found& one : judged.many.reasons) {
      if (one.worst.kind == kind) records = std::max(records, one.runs);
    }
    return records;
  };
  const bool looked = !judged.many.is_open() && run.is_whole();
  const auto count_row = [&](const char* check, long records) {
    CheckRow made{.check = check,
                  .by = "check.by_records",
                  .where = name,
                  .demand = static_cast<double>(records),
                  .limit = 0.0,
                  .unit = "",
                  .is_met = records == 0};
    if (records == 0 && !looked) made.result = not_known_word;
    rows.push_back(std::move(made));
  };
  if (faces) {
    count_row("check.contact_records", found(Reason::Kind::contact));
    count_row("check.unmodelled_records", found(Reason::Kind::unmodelled));
  }
  if (const long fallen = found(Reason::Kind::collapse) + found(Reason::Kind::drift); fallen > 0) {
    count_row("check.collapse_records", fallen);
  }
  const auto row = [&](std::string check, std::string by, double demand, double limit, bool is_met) {
    CheckRow made{.check = std::move(check),
                  .by = std::move(by),
                  .where = name,
                  .demand = known(demand),
                  .limit = faces ? known(limit) : std::nullopt,
                  .unit = study.units.length,
                  .is_met = is_met};
    if (!faces || std::isnan(demand)) made.result = faces ? not_known_word : "story.silence.no_level";
    if (collapses) made.result = collapsed_word;
    const bool says_it = judged.many.is_enough() && !run.c.excitation.suite->is_below_target();
    if (made.result.empty() && is_met && !says_it) made.result = "gap.asks_less";
    rows.push_back(std::move(made));
  };
  const std::string alone = judged.alone ? "_alone" : "";
  row("check.gap_records" + alone, "check.by_records", over.largest.gap_needed, narrowest.value_or(0),
      given.beyond == 0);
  const SuiteDemand* const demand = over.demand ? &*over.demand : nullptr;
  if (demand != nullptr) {
    const std::string by = fmt::format("{}, {}", demand->measure.code, demand->measure.clause);
    const bool is_known = demand->is_known();
    row("check.gap_of_code" + alone, by, is_known ? demand->taken() : not_known, narrowest.value_or(0),
        !demand->is_short);
    if (demand->measure.kind == SuiteMeasure::Kind::too_few) rows.back().result = "check.too_few";
  }
  for (const RuleOverRecords& rule : over.rules) {
    // Of none of its levels it is known where records collapse.
    const double width = rule.width > 0 || rule.is_short ? rule.width : narrowest.value_or(not_known);
    row(rule.title, std::string(find_code_rule(rule.rule)->clause), rule.asked, width, !rule.is_short);
    if (rule.too_few && !rule.is_short && !std::isnan(rule.asked)) rows.back().result = "check.too_few";
  }
}

}  // namespace

HandIn suite_hand_in(const SuiteRun& run, const GapStudy& gaps) {
  std::vector<CheckRow> rows;
  const SuiteSpec& suite = *run.c.excitation.suite;
  rows.push_back({.check = "check.suite_target",
                  .by = "check.by_records",
                  .where = "",
                  .demand = known(suite.least_share()),
                  .limit = SuiteSpec::share_asked,
                  .unit = "",
                  .is_met = !suite.is_below_target()});
  check_drifts(run, rows);
  const std::vector<SuiteJudgement> judged = judged_gaps(run, gaps);
  for (Eigen::Index gap = 0; gap < std::ssize(gaps.gaps); ++gap) check_gap(run, gaps, gap, judged.at(gap), rows);
  return run.plan ? hand_in(run.c, *run.plan, rows) : hand_in(run.c, run.problem, rows);
}

}  // namespace bentur
