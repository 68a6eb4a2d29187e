#include "bentur/study/suite/suite_hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

constexpr double of_hundred = 100;
constexpr const char* not_known_word = "story.silence.unknown";
constexpr const char* collapsed_word = "story.silence.collapsed";

std::optional<double> known(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

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
    const double most = run.largest(static_cast<std::size_t>(found - run.quantities.begin()));
    CheckRow row{.check = building.has_gravity_loads ? "check.stability" : "check.drift",
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

/// What all records, the code that scales them, and the rules of [code] ask of a gap.
void check_gap(const GapStudy& study, Eigen::Index gap, std::vector<CheckRow>& rows) {
  const RecordNeeds& needs = study.needs.front();
  const GapOverRecords& over = needs.gaps[static_cast<std::size_t>(gap)];
  const GivenGap& given = over.given.front();
  const bool collapses =
      std::any_of(needs.records.begin(), needs.records.end(), [](const RecordNeed& one) { return one.collapsed; });
  const std::optional<double> narrowest = given.narrowest();
  const bool faces = narrowest.has_value();
  const auto row = [&](std::string check, std::string by, double demand, bool is_met) {
    CheckRow made{.check = std::move(check),
                  .by = std::move(by),
                  .where = study.gaps.at(gap).name,
                  .demand = known(demand),
                  .limit = narrowest,
                  .unit = study.units.length,
                  .is_met = is_met};
    if (!faces || std::isnan(demand)) made.result = faces ? not_known_word : "story.silence.no_level";
    if (collapses) made.result = collapsed_word;
    rows.push_back(std::move(made));
  };
  row("check.gap_records", "check.by_records", over.largest.gap_needed, given.beyond == 0);
  const SuiteDemand* const demand = over.demand ? &*over.demand : nullptr;
  if (demand != nullptr) {
    const std::string by = fmt::format("{}, {}", demand->measure.code, demand->measure.clause);
    const bool is_known = demand->is_known();
    row("check.gap_of_code", by, is_known ? demand->taken() : std::numeric_limits<double>::quiet_NaN(),
        !demand->is_short);
    if (demand->measure.kind == SuiteMeasure::Kind::too_few) rows.back().result = "check.too_few";
  }
  for (std::size_t i = 0; i < study.code.rules.size(); ++i) {
    const CodeRule* const code = find_code_rule(study.code.rules[i].rule);
    const double asked = demand != nullptr && demand->is_known() ? demand->codes[i] : over.largest.codes[i];
    row(std::string(code->title), std::string(code->clause), asked,
        faces && !falls_short(*narrowest, asked, over.largest.gap_needed));
  }
}

}  // namespace

HandIn suite_hand_in(const SuiteRun& run, const GapStudy& gaps) {
  std::vector<CheckRow> rows;
  check_drifts(run, rows);
  for (Eigen::Index gap = 0; gap < std::ssize(gaps.gaps); ++gap) check_gap(gaps, gap, rows);
  return hand_in(run.c, run.problem, rows);
}

}  // namespace bentur
