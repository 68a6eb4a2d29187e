#include "bentur/study/remedy/remedy_story.h"

#include <cmath>

#include "bentur/model/quantities.h"

namespace bentur {
namespace {

std::string shown(const std::string& unit) { return unit == "1" ? "" : unit_text(unit); }

/// What a trial chooses and gives.
Statement told(std::string kind, const RemedySearch& search, const RemedyTrial& trial) {
  Statement statement{.kind = std::move(kind)};
  statement.values = {{"objective", search.spec().objective}, {"value", trial.objective, shown(search.unit)}};
  if (search.spec().limit) statement.values.push_back({"limit", *search.spec().limit, shown(search.unit)});
  for (std::size_t i = 0; i < search.parameters.size(); ++i) {
    const RemedyParameter& one = search.parameters[i];
    statement.items.push_back({{"name", one.name}, {"chosen", trial.values[i], shown(one.unit)}});
  }
  return statement;
}

void tell_bounds(const RemedySearch& search, const RemedyTrial& trial, std::vector<Statement>& statements) {
  for (const std::size_t i : search.at_bounds(trial)) {
    const RemedyParameter& one = search.parameters[i];
    statements.push_back({.kind = "remedy_at_bound",
                          .severity = Severity::warning,
                          .values = {{"name", one.name}, {"chosen", trial.values[i], shown(one.unit)}}});
  }
}

long failed_trials(const RemedySearch& search) {
  long failed = 0;
  for (const RemedyTrial& one : search.trials) failed += one.failed > 0 ? 1 : 0;
  return failed;
}

}  // namespace

Story remedy_story(const RemedySearch& search) {
  Story story;
  std::vector<Statement>& statements = story.statements;
  const RemedyTrial* const best = search.best();
  const RemedyTrial* const smallest = search.smallest();
  if (search.spec().limit && !search.trials.empty()) {
    if (smallest == nullptr) {
      statements.push_back(
          {.kind = "remedy_none",
           .severity = Severity::danger,
           .values = {{"objective", search.spec().objective}, {"limit", *search.spec().limit, shown(search.unit)}}});
    } else {
      statements.push_back(told(smallest->size > 0 ? "remedy_smallest" : "remedy_not_needed", search, *smallest));
      tell_bounds(search, *smallest, statements);
    }
  }
  const RemedyTrial* const first = smallest != nullptr ? smallest : best;
  if (first != nullptr && first->open.runs > 0) {
    statements.push_back(open_needs_statement(first->open, static_cast<long>(search.runs_each), "remedy_open"));
  }
  if (best != nullptr && best->size > 0) {
    statements.push_back(told("remedy_best", search, *best));
    if (smallest != best) tell_bounds(search, *best, statements);
  } else if (best != nullptr) {
    statements.push_back(told("remedy_no_better", search, *best));
  }
  if (!search.trials.empty() && std::isfinite(search.trials.front().objective)) {
    statements.push_back(told("remedy_start", search, search.trials.front()));
  }
  const auto count = static_cast<long>(search.trials.size());
  if (const long failed = failed_trials(search); failed > 0) {
    statements.push_back({.kind = "remedy_failed",
                          .severity = Severity::warning,
                          .values = {{"failed", failed}, {"evaluations", count}}});
  }
  if (search.stopped) {
    statements.push_back({.kind = "remedy_stopped",
                          .severity = Severity::warning,
                          .values = {{"evaluations", count}, {"most", static_cast<long>(search.spec().evaluations)}}});
  }
  // The search knows its objective alone, no rules; the motion reversed of needs, or where the study asks for it.
  if (best != nullptr || smallest != nullptr) {
    statements.push_back({.kind = search.both_ways ? "remedy_by_objective_both" : "remedy_by_objective",
                          .severity = search.both_ways ? Severity::remark : Severity::finding,
                          .values = {{"objective", search.spec().objective}}});
  }
  sort_by_severity(statements);
  return story;
}

}  // namespace bentur
