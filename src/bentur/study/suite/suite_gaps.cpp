#include "bentur/study/suite/internal/suite_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>
#include <variant>

#include "bentur/core/not_known.h"
#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

/// Of a gap under one record; of one that could not be run nothing is known.
Judgement judgement_of(const SuiteRecordRun& one, Eigen::Index gap) {
  if (!one.judged.empty()) return one.judged.at(static_cast<std::size_t>(gap)).judgement;
  Judgement unknown{.value = Sufficiency::unknown};
  unknown.reasons.push_back({.kind = Reason::Kind::not_looked_at});
  return unknown;
}

}  // namespace

std::vector<std::string> names_across(const Problem& problem, Eigen::Index gap) {
  std::vector<std::string> names;
  for (const Eigen::Index b : buildings_of(problem, gap)) names.push_back(problem.buildings[b].name);
  return names;
}

std::vector<Statement> told_of(const SuiteRun& run, Eigen::Index gap, const SuiteJudgement& judged) {
  std::vector<std::string> names;
  std::vector<ToldJudgement> of_records;
  ToldJudgement unknown;
  for (const SuiteRecordRun& one : run.records) {
    if (!one.judged.empty()) unknown = one.judged.at(static_cast<std::size_t>(gap));
  }
  unknown.judgement = judgement_of({}, gap);
  unknown.reasons = {{{"why", std::string("reason.not_looked_at"), {}, true}}};
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const SuiteRecordRun& one = run.records[i];
    names.push_back((*run.c.excitation.suite).records[i].name());
    of_records.push_back(one.judged.empty() ? unknown : one.judged.at(static_cast<std::size_t>(gap)));
  }
  if (of_records.empty()) return {};
  const std::vector<std::string> between = names_across(run.problem, gap);
  return judgement_of_many({.names = std::move(names),
                            .of_records = std::move(of_records),
                            .many = judged.many,
                            .left = between.front(),
                            .right = between.back(),
                            .length = run.c.units.length},
                           gap);
}

Statement counted_over_records(const std::vector<SuiteJudgement>& judged) {
  const auto count = [&](Sufficiency value) {
    return std::count_if(judged.begin(), judged.end(),
                         [&](const SuiteJudgement& one) { return one.many.value == value; });
  };
  return counted_gaps(std::ssize(judged), count(Sufficiency::too_small), count(Sufficiency::unknown),
                      "row_none_of_records");
}

StoryTable table_over_records(const SuiteRun& run, const std::vector<SuiteJudgement>& judged, const GapStudy& gaps) {
  const std::string& length = run.c.units.length;
  std::vector<double> given(judged.size(), not_known), largest(judged.size(), not_known);
  for (std::size_t gap = 0; gap < judged.size() && !gaps.needs.empty(); ++gap) {
    const GapOverRecords& over = gaps.needs.front().gaps.at(gap);
    if (!over.given.empty()) given[gap] = over.given.front().narrowest().value_or(not_known);
    largest[gap] = over.largest.gap_needed;
  }
  std::vector<std::size_t> order(judged.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto lacking = [&](std::size_t gap) {
    const double lacks = largest[gap] - given[gap];
    return std::isnan(lacks) ? -std::numeric_limits<double>::infinity() : lacks;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Sufficiency of_a = judged[a].many.value, of_b = judged[b].many.value;
    return of_a != of_b ? of_a < of_b : lacking(a) > lacking(b);
  });
  StoryTable table = begun_table(order, [&](std::size_t gap) { return judged[gap].many.value; });
  StoryColumn name{.label = "column.gap"}, verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn small{.label = "column.small_under", .are_counts = true}, width{"column.given", length};
  StoryColumn needed{"column.hardest_record", length};
  for (const std::size_t gap : order) {
    const JudgementOfMany& many = judged[gap].many;
    if (many.value == Sufficiency::too_small) table.marked.push_back(name.texts.size());
    name.texts.push_back(gap_name(run.problem, static_cast<Eigen::Index>(gap)));
    verdict.texts.emplace_back(judgement_word(many.value));
    small.texts.push_back(fmt::format("{} / {}", many.too_small, many.runs));
    width.numbers.push_back(given[gap]);
    needed.numbers.push_back(largest[gap]);
  }
  table.columns = {name, verdict, small, width, needed};
  return table;
}

void say_once(std::vector<Statement>& statements) {
  const auto is_said = [&](const std::optional<Eigen::Index>& gap, std::string_view kind) {
    return std::any_of(statements.begin(), statements.end(),
                       [&](const Statement& one) { return one.gap == gap && one.kind.starts_with(kind); });
  };
  constexpr std::string_view rows[] = {"storey_yields", "links", "amplified", "acceleration_ratio"};
  for (Statement& one : statements) {
    if (std::find(std::begin(rows), std::end(rows), one.kind) != std::end(rows)) one.shown = Shown::row;
    if (one.kind == "gaps_over_records") one.shown = Shown::table;
    const bool is_judged = is_said(one.gap, "records_too_small") || is_said(one.gap, "records_not_known");
    if (one.kind.starts_with("records_short") && is_judged) one.shown = Shown::table;
    if (one.kind != "records_too_small") continue;
    const auto has_sentence = [&](const std::vector<StoryValue>& item) {
      return std::any_of(item.begin(), item.end(), [&](const StoryValue& value) {
        const auto* const why = std::get_if<std::string>(&value.value);
        if (value.name != "why" || why == nullptr) return false;
        return (*why == "reason.unmodelled" && is_said(one.gap, "unmodelled")) ||
               ((*why == "reason.contact" || *why == "reason.contact_impulse") && is_said(one.gap, "pounding"));
      });
    };
    std::vector<std::vector<StoryValue>> left = one.items;
    std::erase_if(left, has_sentence);
    if (!left.empty()) one.items = std::move(left);
  }
}

std::vector<const char*> record_words(const SuiteRun& run, std::size_t gap) {
  std::vector<Judgement> judged;
  for (const SuiteRecordRun& one : run.records) judged.push_back(judgement_of(one, static_cast<Eigen::Index>(gap)));
  const bool all_enough = std::all_of(judged.begin(), judged.end(), std::mem_fn(&Judgement::is_enough));
  std::vector<const char*> words;
  for (const Judgement& one : judged) {
    const Sufficiency by_motion = without_rules(one);
    words.push_back(by_motion == Sufficiency::enough && !all_enough ? "gap.asks_less" : judgement_word(by_motion));
  }
  return words;
}

std::vector<SuiteJudgement> judged_gaps(const SuiteRun& run, const GapStudy& gaps) {
  std::vector<SuiteJudgement> all;
  for (Eigen::Index gap = 0; gap < gap_count(run.problem); ++gap) {
    SuiteJudgement made;
    if (!gaps.needs.empty()) {
      for (const RuleOverRecords& rule : gaps.needs.front().gaps.at(gap).rules) {
        if (!rule.is_short) continue;
        made.of_rules.push_back(
            {.kind = Reason::Kind::rule, .value = rule.asked, .width = rule.width, .subject = rule.title});
      }
    }
    std::vector<Judgement> of_records;
    for (const SuiteRecordRun& one : run.records) of_records.push_back(judgement_of(one, gap));
    made.many = judge(of_records, made.of_rules);
    made.alone = std::any_of(of_records.begin(), of_records.end(), [](const Judgement& one) { return one.alone; });
    all.push_back(std::move(made));
  }
  return all;
}

}  // namespace bentur
