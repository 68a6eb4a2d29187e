#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/model/gap/codes/height_rules.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur {
namespace story {
namespace {

const char* verdict_word(const HeightFinding& found) {
  switch (found.verdict) {
    case HeightFinding::Verdict::too_small:
      return "gap.too_close";
    case HeightFinding::Verdict::enough:
      return "gap.wide_enough";
    case HeightFinding::Verdict::least:
      return "gap.at_least";
    case HeightFinding::Verdict::not_evaluated:
      break;
  }
  return silence_word(found.silence);
}

void tell_height_rules(const Case& c, const Problem& problem, Eigen::Index gap,
                       const std::vector<HeightFinding>& findings, std::vector<Statement>& statements) {
  const std::string& length = c.units.length;
  Statement enough{.kind = "rules", .gap = gap, .buildings = buildings_of(problem, gap)};
  Statement too_small = enough, least = enough, silent = enough;
  too_small.kind = "rules_short";
  too_small.severity = Severity::warning;
  least.kind = "rules_least";
  silent.kind = "rules_silent";
  for (const HeightFinding& found : findings) {
    const StoryValue title = text_of("rule", std::string(find_code_rule(found.rule)->title));
    if (!found.at) {
      silent.items.push_back({title, word_of("why", silence_word(found.silence))});
      continue;
    }
    const HeightNeed& need = found.needs[*found.at];
    Statement& of = found.verdict == HeightFinding::Verdict::too_small ? too_small
                    : found.verdict == HeightFinding::Verdict::enough  ? enough
                                                                       : least;
    of.items.push_back(
        {title, value_in("gap", need.asked->asked.gap, length), value_in("level", need.level.elevation, length)});
  }
  for (Statement* const statement : {&too_small, &enough, &least, &silent}) {
    if (statement->items.empty()) continue;
    if (statement != &silent) tell_levels_once(*statement);
    statements.push_back(std::move(*statement));
  }
}

StoryTable height_table(const Case& c, Eigen::Index gap, const std::vector<HeightFinding>& findings) {
  const std::string& length = c.units.length;
  StoryColumn title{.label = "gap.code"}, clause{.label = "gap.clause"}, asked{"gap.asked", length};
  StoryColumn level{"column.elevation", length}, given{"column.given", length};
  StoryColumn verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn left{"gap.left_to_line", length}, right{"gap.right_to_line", length}, wording{.label = "gap.wording"};
  bool property_line = false;
  StoryTable table{.kind = "height_rules", .gap = gap};
  for (const HeightFinding& found : findings) {
    const CodeRule& rule = *find_code_rule(found.rule);
    const HeightNeed* const need = found.at ? &found.needs[*found.at] : nullptr;
    if (found.verdict == HeightFinding::Verdict::too_small) table.marked.push_back(title.texts.size());
    title.texts.emplace_back(rule.title);
    clause.texts.emplace_back(rule.clause);
    asked.numbers.push_back(need != nullptr ? need->asked->asked.gap : not_known);
    level.numbers.push_back(need != nullptr ? need->level.elevation : not_known);
    given.numbers.push_back(need != nullptr ? need->level.width : not_known);
    verdict.texts.emplace_back(verdict_word(found));
    left.numbers.push_back(need != nullptr ? need->asked->asked.to_left.value_or(not_known) : not_known);
    right.numbers.push_back(need != nullptr ? need->asked->asked.to_right.value_or(not_known) : not_known);
    wording.texts.emplace_back(rule.wording);
    property_line = property_line || !std::isnan(left.numbers.back());
  }
  table.columns = {title, clause, asked, level, given, verdict};
  if (property_line) table.columns.insert(table.columns.end(), {left, right});
  table.columns.push_back(wording);
  return table;
}

}  // namespace

void tell_heights(const Case& c, const Problem& problem, Eigen::Index gap, Story& told) {
  const std::vector<HeightFinding> findings = height_findings(problem, gap, c.code, c.units);
  if (findings.empty()) return;
  tell_height_rules(c, problem, gap, findings, told.statements);
  told.tables.push_back(height_table(c, gap, findings));
}

}  // namespace story

Story height_rules_story(const Case& c, const Problem& problem) {
  Story told;
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) story::tell_heights(c, problem, gap, told);
  sort_by_severity(told.statements);
  story::tell_quotations(c.code, told.statements);
  return told;
}

Story height_rules_story(const Case& c, const PlanProblem& problem) { return height_rules_story(c, row_of(problem)); }

}  // namespace bentur
