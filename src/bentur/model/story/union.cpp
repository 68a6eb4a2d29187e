#include <algorithm>
#include <cmath>
#include <string_view>

#include "bentur/model/story/story.h"

namespace bentur {
namespace {

/// By which value statements of a kind are compared, where it is not their first number.
struct Measure {
  std::string_view kind, value;
  bool least = false;  ///< the least is the worst
};
constexpr Measure measures[] = {
    {"collapse", "time", true},
    {"collapse_alone", "time", true},
    {"collapse_also_alone", "time", true},
    {"drift_beyond", "drift"},
    {"drift_beyond_alone", "drift"},
    {"unmodelled", "depth"},
    {"pounding", "force"},
    {"pounding_impulse", "speed"},
    {"column_shear", "ratio"},
    {"column_moment", "ratio"},
    {"storey_softens", "left", true},
    {"hinges_weaker", "left", true},
    {"hinges_snapped", "left", true},
    {"hinges_worn", "left", true},
    {"hinges_failed", "failed"},
    {"hinges_worn_out", "failed"},
    {"columns_break", "broken"},
    {"infill_weakens", "left", true},
    {"infill_fails", "time", true},
    {"storey_at_residual", "left", true},
    {"storey_fails", "time", true},
    {"soft_storey", "time", true},
    {"mechanism", "time", true},
    {"amplified", "factor"},
    {"acceleration_ratio", "factor"},
    {"storey_shear_ratio", "factor"},
    {"acceleration", "acceleration"},
    {"move_alike", "share", true},
};

/// What is told of all runs together, or says of a run that something did not happen.
constexpr std::string_view of_single_runs[] = {"row_all",
                                               "row_some",
                                               "row_pounding",
                                               "row_pounding_impulse",
                                               "row_unknown",
                                               "row_all_unknown",
                                               "row_none",
                                               "row_pushed",
                                               "no_pounding",
                                               "no_impact",
                                               "too_small",
                                               "not_known",
                                               "no_level",
                                               "need_unknown",
                                               "gap_short",
                                               "gap_need",
                                               "gap_enough",
                                               "gap_touch",
                                               "gap_short_alone",
                                               "gap_need_alone",
                                               "reversed_short",
                                               "reversed_enough",
                                               "reversed_spare",
                                               "reversed_alone",
                                               "reversed_unknown",
                                               "asked_more",
                                               "rules",
                                               "rules_less",
                                               "rules_short",
                                               "rules_understate",
                                               "rules_silent",
                                               "not_amplified",
                                               "acceleration_ratio_none",
                                               "storey_shear_ratio_none"};

/// The kind that a statement is counted as: by its drift a storey counts as collapsed with contact or without.
std::string_view counted_kind(const Statement& statement) {
  return statement.kind == "drift_beyond_alone" ? std::string_view("drift_beyond") : statement.kind;
}

/// How bad a statement is among those of its kind.
double badness(const Statement& statement) {
  if (statement.beyond > 0) return statement.beyond;
  const auto measure = std::find_if(std::begin(measures), std::end(measures),
                                    [&](const Measure& one) { return one.kind == statement.kind; });
  const bool is_measured = measure != std::end(measures);
  for (const StoryValue& value : statement.values) {
    if (is_measured && value.name != measure->value) continue;
    const auto* const count = std::get_if<long>(&value.value);
    if (count != nullptr && is_measured) return static_cast<double>(*count);
    const auto* const number = std::get_if<double>(&value.value);
    if (number == nullptr) continue;
    if (std::isnan(*number)) break;
    return is_measured && measure->least ? -*number : std::abs(*number);
  }
  return 0;
}

/// The level that hinges pass, of which each is a finding of its own; empty of other statements.
std::string_view limit_of(const Statement& statement) {
  if (statement.kind != "hinges_beyond") return {};
  for (const StoryValue& value : statement.values) {
    if (value.name == "limit") return std::get<std::string>(value.value);
  }
  return {};
}

/// Of many gaps the impact that is the hardest is a sentence, the others are rows: a run has them in a table of its
/// own.
void tell_impacts(std::vector<Statement>& statements) {
  const Statement* const hardest = hardest_impact_of(statements);
  for (Statement& one : statements) {
    if (one.shown != Shown::table || !one.kind.starts_with("pounding")) continue;
    one.shown = &one == hardest ? Shown::sentence : Shown::row;
  }
}

bool is_of_single_runs(const Statement& statement) {
  return std::find(std::begin(of_single_runs), std::end(of_single_runs), statement.kind) != std::end(of_single_runs);
}

/// The rule that an item of a statement is about.
const std::string& rule_of(const std::vector<StoryValue>& item) { return std::get<std::string>(item.front().value); }

bool is_silent(const SaidOfRun& run, std::optional<Eigen::Index> gap, const std::string& rule) {
  return std::any_of(run.statements.begin(), run.statements.end(), [&](const Statement& one) {
    return one.kind == "rules_silent" && one.gap == gap &&
           std::any_of(one.items.begin(), one.items.end(), [&](const auto& item) { return rule_of(item) == rule; });
  });
}

/// Rules that say nothing of a gap under any of the runs, and why.
std::vector<Statement> silent_under_all(const std::vector<SaidOfRun>& runs) {
  std::vector<Statement> all;
  if (runs.empty()) return all;
  for (const Statement& one : runs.front().statements) {
    if (one.kind != "rules_silent") continue;
    Statement silent = one;
    std::erase_if(silent.items, [&](const auto& item) {
      return !std::all_of(runs.begin(), runs.end(),
                          [&](const SaidOfRun& run) { return is_silent(run, one.gap, rule_of(item)); });
    });
    silent.rank.reset();
    if (!silent.items.empty()) all.push_back(std::move(silent));
  }
  return all;
}

}  // namespace

std::vector<Statement> union_of(const std::vector<SaidOfRun>& runs) {
  if (runs.size() == 1) return runs.front().statements;
  struct OfKind {
    const Statement* worst = nullptr;
    std::size_t run = 0, last = 0;
    long count = 0;
  };
  std::vector<OfKind> kinds;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const Statement& one : runs[run].statements) {
      if (is_of_single_runs(one)) continue;
      auto found = std::find_if(kinds.begin(), kinds.end(), [&](const OfKind& kind) {
        return counted_kind(*kind.worst) == counted_kind(one) && kind.worst->gap == one.gap &&
               limit_of(*kind.worst) == limit_of(one);
      });
      if (found == kinds.end()) {
        kinds.push_back({&one, run, run, 1});
        continue;
      }
      if (found->last != run) ++found->count;
      found->last = run;
      if (!(badness(one) > badness(*found->worst))) continue;
      found->worst = &one;
      found->run = run;
    }
  }
  std::vector<Statement> all;
  for (const OfKind& kind : kinds) {
    all.push_back(*kind.worst);
    if (kind.worst->kind.starts_with("model") || kind.worst->kind == "code_quotation" ||
        kind.worst->kind.starts_with("assumed_")) {
      continue;  // of all alike
    }
    all.back().rank.reset();  // each run has an order of its own
    all.back().many = {kind.count, static_cast<long>(runs.size()), runs[kind.run].name};
  }
  for (Statement& one : silent_under_all(runs)) all.push_back(std::move(one));
  tell_impacts(all);
  sort_by_severity(all);
  return all;
}

}  // namespace bentur
