#include "bentur/study/gap/gap_study_story.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/model/suite/suite_story.h"

namespace bentur {
namespace {

constexpr long fewest = 5;           // records whose quantiles are told in a sentence
constexpr double most_asked = 0.84;  // the part of the records that engineers ask of [-]

/// Records of one choice of whatever else varies, or of all choices together.
struct Told {
  const GapStudy& study;
  const RecordNeeds& needs;
  bool together = false;
  std::string others = {};                                 ///< "stiffness = 2, period = 0.4"
  const std::vector<JudgedOverRecords>* judged = nullptr;  ///< per gap; null: not known

  /// What follows where a rule or a code is content.
  [[nodiscard]] StoryValue alone(Eigen::Index gap) const {
    if (is_enough(gap)) return {"alone", std::string()};
    return {"alone", std::string("story.records_rules_alone"), {}, true};
  }
  /// What follows what buildings need that meet nobody, where others do.
  [[nodiscard]] StoryValue others_open(Eigen::Index gap) const {
    const bool is_alone = judged != nullptr && judged->at(static_cast<std::size_t>(gap)).is_alone;
    return {"others_open", std::string(is_alone ? "story.if_no_other_closed" : ""), {}, is_alone};
  }
  [[nodiscard]] bool is_enough(Eigen::Index gap) const {
    return judged != nullptr && judged->at(static_cast<std::size_t>(gap)).is_enough;
  }

  [[nodiscard]] long count() const { return std::ssize(needs.records); }
};

std::string others_of(const RecordNeeds& needs) {
  std::string text;
  for (const auto& [name, value] : needs.others) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

/// NaN where no floors face one another.
double width_of(const GivenGap& given) { return given.narrowest().value_or(not_known); }

/// Of the records that need more [%].
double share_of(const Told& told, const GivenGap& given) {
  return 100.0 * static_cast<double>(given.beyond) / static_cast<double>(told.count());
}

const GapNeed& quantile(const GapOverRecords& over, double probability) {
  const auto found = std::find_if(over.quantiles.begin(), over.quantiles.end(),
                                  [&](const GapQuantile& one) { return one.probability == probability; });
  return found->need;
}

/// The count of records, or of runs where they are of all choices.
StoryValue count_value(const Told& told) { return {told.together ? "runs" : "records", told.count()}; }

Statement statement_of(const Told& told, Eigen::Index gap, std::string kind) {
  const GapStudy::Between& between = told.study.gaps.at(gap);
  return {.kind = std::move(kind), .gap = gap, .buildings = {between.left, between.right}, .subject = told.others};
}

/// What the code takes of the records of a suite that it scales.
void tell_demand(const Told& told, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::string& length = told.study.units.length;
  const GapOverRecords& over = told.needs.gaps[gap];
  const SuiteDemand& demand = *over.demand;
  const SuiteMeasure& measure = demand.measure;
  const bool is_mean = measure.kind == SuiteMeasure::Kind::mean;
  std::string kind = is_mean ? "suite_takes_mean" : "suite_takes_largest";
  if (!demand.is_known()) kind = demand.collapsed > 0 ? "suite_gap_collapsed" : "suite_too_few";
  if (demand.is_known()) kind += demand.is_short ? "_short" : "_enough";
  Statement statement = statement_of(told, gap, std::move(kind));
  if (!demand.is_known() || demand.is_short) statement.severity = Severity::warning;
  statement.values = {{"code", std::string(measure.code)},
                      {"clause", std::string(measure.clause)},
                      {"fewest", static_cast<long>(measure.fewest)},
                      count_value(told)};
  if (demand.is_known()) {
    statement.values.push_back({"taken", demand.taken(), length});
    statement.values.push_back({"level", demand.elevation, length});
    statement.values.push_back({"width", width_of(over.given.front()), length});
    statement.level = demand.elevation;
    statement.values.push_back(told.others_open(gap));
    statement.values.push_back(told.alone(gap));
  } else if (demand.collapsed > 0) {
    statement.values.push_back({"collapsed", demand.collapsed});
  }
  statements.push_back(std::move(statement));
}

/// What rules of [code] ask of all records together.
void tell_rules(const Told& told, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::string& length = told.study.units.length;
  const GapOverRecords& over = told.needs.gaps[gap];
  if (over.rules.empty() || over.given.size() != 1 || over.given.front().widths.empty()) return;
  const std::string takes = over.rules.front().takes_mean ? "story.takes.mean" : "story.takes.largest";
  const auto begun = [&](const char* kind, Severity severity) {
    Statement one = statement_of(told, gap, kind);
    one.severity = severity;
    one.values = {count_value(told), {"takes", takes, {}, true}, told.alone(gap)};
    one.values.front().name = "records";
    return one;
  };
  Statement is_short = begun("records_rules_short", Severity::warning), met = begun("records_rules", Severity::finding);
  Statement unknown = begun("records_rules_unknown", Severity::warning);
  Statement few = begun("records_rules_few", Severity::warning);
  for (const RuleOverRecords& rule : over.rules) {
    std::vector<StoryValue> item = {{"rule", rule.title}};
    if (!std::isnan(rule.asked)) {
      item.push_back({"gap", rule.asked, length});
      item.push_back({"level", rule.elevation, length});
      item.push_back({"short", rule.asked - rule.width, length});
    }
    (rule.is_short            ? is_short
     : std::isnan(rule.asked) ? unknown
     : rule.too_few           ? few
                              : met)
        .items.push_back(std::move(item));
  }
  for (Statement* const one : {&is_short, &met, &few, &unknown}) {
    if (!one->items.empty()) statements.push_back(std::move(*one));
  }
}

/// Records under which a building falls without contact: they need more than any gap.
void tell_collapsed(const Told& told, Eigen::Index gap, std::vector<Statement>& statements) {
  const long collapsed = std::count_if(told.needs.records.begin(), told.needs.records.end(),
                                       [](const RecordNeed& one) { return one.falls; });
  if (collapsed == 0) return;
  Statement statement = statement_of(told, gap, "records_collapsed");
  statement.severity = Severity::danger;
  statement.values = {{"collapsed", collapsed}, count_value(told)};
  statement.values.back().name = "records";
  statements.push_back(std::move(statement));
}

void tell_gap(const Told& told, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::string& length = told.study.units.length;
  const GapOverRecords& over = told.needs.gaps[gap];
  if (!over.given.empty() && over.given.front().widths.empty()) {
    statements.push_back(statement_of(told, gap, "no_level"));
    return;
  }
  if (over.given.size() == 1) {
    const GivenGap& given = over.given.front();
    const bool is_open = given.open.runs > 0;
    Statement statement = statement_of(told, gap, std::string(told.together ? "runs" : "records") + "_short");
    if (is_open) statement.kind += "_open";
    if (given.beyond > 0 || is_open) statement.severity = Severity::warning;
    statement.values = {
        {"beyond", static_cast<long>(given.beyond)}, count_value(told),         {"share", share_of(told, given), "%"},
        {"width", width_of(given), length},          {"open", given.open.runs}, told.others_open(gap)};
    statement.items = open_needs_statement(given.open, told.count()).items;
    statements.push_back(std::move(statement));
  }
  tell_collapsed(told, gap, statements);
  if (over.demand) tell_demand(told, gap, statements);
  tell_rules(told, gap, statements);
  // Quantiles of a few say nothing.
  const bool few = told.count() < fewest;
  if (!std::isfinite(few ? over.largest.gap_needed : over.median.gap_needed)) return;
  const char* const kind = few ? (told.together ? "gaps_over_few_runs" : "gaps_over_few")
                               : (told.together ? "gaps_over_runs" : "gaps_over_records");
  Statement statement = statement_of(told, gap, kind);
  statement.values = {count_value(told), {"largest", over.largest.gap_needed, length}};
  if (!few) {
    statement.values.push_back({"median", over.median.gap_needed, length});
    statement.values.push_back({"most", quantile(over, most_asked).gap_needed, length});
  }
  const long open = std::count_if(told.needs.records.begin(), told.needs.records.end(),
                                  [](const RecordNeed& one) { return !one.falls && one.open != 0; });
  statement.values.push_back(told.others_open(gap));
  statement.values.push_back({"open", open});
  statement.values.push_back({"known", std::string(open > 0 ? "story.gaps_over_known" : ""), {}, open > 0});
  statements.push_back(std::move(statement));
}

std::vector<StoryValue> heading(const Told& told, Eigen::Index gap) {
  return {{"between", told.study.gaps.at(gap).name},
          {"others", told.others},
          {"with", std::string(told.others.empty() ? "" : "story.with"), {}, !told.others.empty()},
          count_value(told)};
}

/// A row a record, unless they are of all choices, and what holds over all of them.
StoryTable record_table(const Told& told, Eigen::Index gap) {
  StoryColumn name{.label = told.together ? "" : "column.record", .are_words = true};
  std::vector<const GapNeed*> rows;
  for (const RecordNeed& record : told.needs.records) {
    if (told.together) break;
    name.texts.push_back(record.record);
    rows.push_back(&record.gaps[gap]);
  }
  const GapOverRecords& over = told.needs.gaps[gap];
  if (told.count() > 1) {
    name.texts.emplace_back("story.largest_of_records");
    rows.push_back(&over.largest);
    if (told.study.suite) {
      name.texts.emplace_back("story.mean_of_records");
      rows.push_back(&over.mean);
    }
    for (auto one = over.quantiles.rbegin(); one != over.quantiles.rend(); ++one) {
      name.texts.push_back(one->probability == 0.5 ? "story.median_of_records"
                                                   : fmt::format("◄ {:.4g} %", 100 * one->probability));
      rows.push_back(&one->need);
    }
  }
  StoryTable table{.kind = told.together ? "records_together" : "records", .gap = gap, .values = heading(told, gap)};
  table.columns.push_back(std::move(name));
  if (!told.together && !told.needs.records.empty() && told.needs.records.front().intensity) {
    StoryColumn intensity{"column.intensity", told.study.intensity_unit};
    for (const RecordNeed& record : told.needs.records) intensity.numbers.push_back(*record.intensity);
    intensity.numbers.resize(rows.size(), not_known);  // of all records together it is none
    table.columns.push_back(std::move(intensity));
  }
  const std::string& length = told.study.units.length;
  const auto add = [&](std::string label, auto number_of) {
    StoryColumn column{std::move(label), length};
    for (const GapNeed* row : rows) column.numbers.push_back(number_of(*row));
    table.columns.push_back(std::move(column));
  };
  add(told.study.of_either_way ? "column.simulated_either" : "column.simulated",
      [](const GapNeed& need) { return need.gap_needed; });
  add("ABS", [](const GapNeed& need) { return need.abs; });
  add("SRSS", [](const GapNeed& need) { return need.srss; });
  add("DDC", [](const GapNeed& need) { return need.ddc; });
  for (std::size_t i = 0; i < told.study.code.rules.size(); ++i) {
    add(std::string(find_code_rule(told.study.code.rules[i].rule)->title),
        [i](const GapNeed& need) { return need.codes[i]; });
  }
  return table;
}

/// What each rule asks of all records together.
StoryTable rule_table(const Told& told, Eigen::Index gap) {
  const std::string& length = told.study.units.length;
  StoryColumn title{.label = "gap.code"}, clause{.label = "gap.clause"}, asked{"gap.asked", length};
  StoryColumn taken{.label = "gap.taken", .are_words = true}, level{"column.elevation", length};
  StoryColumn given{"column.given", length}, verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn wording{.label = "gap.wording"};
  StoryTable table{.kind = "rules", .gap = gap};
  for (const RuleOverRecords& rule : told.needs.gaps[gap].rules) {
    const CodeRule& code = *find_code_rule(rule.rule);
    if (rule.is_short) table.marked.push_back(title.texts.size());
    title.texts.push_back(rule.title);
    clause.texts.emplace_back(code.clause);
    asked.numbers.push_back(rule.asked);
    taken.texts.emplace_back(rule.takes_mean ? "gap.takes_mean" : "gap.takes_largest");
    level.numbers.push_back(rule.elevation);
    given.numbers.push_back(rule.width);
    verdict.texts.emplace_back(rule.is_short            ? "gap.too_close"
                               : std::isnan(rule.asked) ? "story.silence.unknown"
                               : rule.too_few           ? "check.too_few"
                               : told.is_enough(gap)    ? "gap.wide_enough"
                                                        : "gap.asks_less");
    wording.texts.emplace_back(code.wording);
  }
  table.columns = {title, clause, asked, taken, level, given, verdict, wording};
  return table;
}

/// How many need more than is given, a row a width.
StoryTable given_table(const Told& told, Eigen::Index gap) {
  StoryColumn width{"column.given", told.study.units.length}, beyond{.label = "column.beyond", .are_counts = true};
  StoryColumn share{"column.share", "%"}, open{.label = "gap.not_known", .are_counts = true};
  bool some_open = false;
  for (const GivenGap& one : told.needs.gaps[gap].given) {
    open.texts.push_back(fmt::format("{} / {}", one.open.runs, told.count()));
    some_open = some_open || one.open.runs > 0;
    width.numbers.push_back(width_of(one));
    beyond.texts.push_back(fmt::format("{} / {}", one.beyond, told.count()));
    share.numbers.push_back(share_of(told, one));
  }
  StoryTable table{.kind = "given", .gap = gap, .values = heading(told, gap), .columns = {width, beyond, share}};
  if (some_open) table.columns.push_back(std::move(open));
  return table;
}

/// A row for each choice of what else varies.
StoryTable choice_table(const GapStudy& study, Eigen::Index gap) {
  const std::string& length = study.units.length;
  StoryColumn choice{.label = "column.choice"}, median{"column.half", length}, most{"column.most_records", length};
  StoryColumn largest{"column.hardest_record", length}, beyond{.label = "column.beyond", .are_counts = true};
  StoryColumn open{.label = "gap.not_known", .are_counts = true};
  bool some_open = false;
  StoryTable table{.kind = "choices", .gap = gap, .values = {{"between", study.gaps.at(gap).name}}};
  for (const RecordNeeds& needs : study.needs) {
    const GapOverRecords& over = needs.gaps[gap];
    const std::size_t most_beyond = over.given.front().beyond;
    if (over.given.size() == 1 && most_beyond > 0) table.marked.push_back(choice.texts.size());
    choice.texts.push_back(others_of(needs));
    median.numbers.push_back(over.median.gap_needed);
    most.numbers.push_back(quantile(over, most_asked).gap_needed);
    largest.numbers.push_back(over.largest.gap_needed);
    beyond.texts.push_back(fmt::format("{} / {}", most_beyond, needs.records.size()));
    const long unknown = over.given.front().open.runs;
    open.texts.push_back(fmt::format("{} / {}", unknown, needs.records.size()));
    some_open = some_open || unknown > 0;
  }
  table.columns = {choice, median, most, largest};
  const bool is_one = study.needs.front().gaps[gap].given.size() == 1;
  if (is_one) table.columns.push_back(beyond);
  if (is_one && some_open) table.columns.push_back(std::move(open));
  return table;
}

/// Sentences of all records, and their tables.
void tell(const Told& told, bool in_words, Story& story) {
  for (Eigen::Index gap = 0; gap < std::ssize(told.needs.gaps); ++gap) {
    if (in_words) tell_gap(told, gap, story.statements);
    story.tables.push_back(record_table(told, gap));
    if (told.needs.gaps[gap].given.size() > 1) story.tables.push_back(given_table(told, gap));
    if (!told.needs.gaps[gap].rules.empty()) story.tables.push_back(rule_table(told, gap));
  }
}

}  // namespace

Story gap_study_story(const GapStudy& study, const std::vector<JudgedOverRecords>& judged) {
  Story story;
  const std::vector<JudgedOverRecords>* const known = judged.empty() ? nullptr : &judged;
  const bool are_choices = study.together.has_value();
  for (const RecordNeeds& needs : study.needs)
    tell({study, needs, false, others_of(needs), known}, !are_choices, story);
  if (are_choices) {
    for (Eigen::Index gap = 0; gap < std::ssize(study.together->gaps); ++gap) {
      story.tables.push_back(choice_table(study, gap));
    }
    tell({study, *study.together, true, {}, known}, true, story);
  }
  if (study.suite) {
    Story suite = suite_story(*study.suite, study.units);
    for (Statement& one : suite.statements) story.statements.push_back(std::move(one));
    for (StoryTable& one : suite.tables) story.tables.push_back(std::move(one));
  }
  if (study.is_one_way) story.statements.push_back({.kind = "records_one_way", .severity = Severity::warning});
  if (!study.is_whole()) {
    story.statements.push_back({.kind = "suite_stopped",
                                .severity = Severity::warning,
                                .values = {{"done", study.done}, {"records", study.asked}}});
  }
  sort_by_severity(story.statements);
  return story;
}

}  // namespace bentur
