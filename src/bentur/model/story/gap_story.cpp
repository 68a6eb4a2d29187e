#include <algorithm>
#include <cmath>
#include <set>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/story_parts.h"
#include "bentur/model/story/judgement_story.h"

namespace bentur {
namespace story {

const Judgement& judged_of(const GapView& facts, Eigen::Index gap) {
  return facts.gaps.at(static_cast<std::size_t>(gap)).judgement;
}

namespace {

/// Where levels are in plan; in a row these columns are left out.
struct PlaceColumns {
  StoryColumn x, y;

  explicit PlaceColumns(const std::string& length) : x{"x", length}, y{"y", length} {}
  /// @param level null: there is none in this row
  void add(const GapView& facts, const FacingLevel* level) {
    if (facts.plan == nullptr) return;
    const bool known = level != nullptr;
    const PlanPoint at =
        known ? place_of(*facts.plan, facts.problem, level->is_point, level->index) : PlanPoint(not_known, not_known);
    x.numbers.push_back(at.x());
    y.numbers.push_back(at.y());
  }
  void put(const GapView& facts, StoryTable& table) const {
    if (facts.plan != nullptr) table.columns.insert(table.columns.end(), {x, y});
  }
};

StoryTable level_table(const GapView& facts, Eigen::Index gap, const std::vector<LevelSeparation>& levels) {
  const std::string& length = facts.c.units.length;
  const double scale = facts.scale(gap);
  std::vector<LevelSeparation> either = levels;  // as recorded and reversed, whichever needs more
  for (LevelSeparation& one : either) one.gap_needed = std::max(one.gap_needed, one.gap_needed_reversed.value_or(0));
  const auto governing = governing_level(either, scale);
  const Judgement& judged = judged_of(facts, gap);
  StoryColumn elevation{"column.elevation", length}, kind{.label = "gap.faces", .are_words = true};
  StoryColumn owner{.label = "gap.floor_of"}, given{"column.given", length};
  const bool is_alone = !facts.gaps.empty() && judged.alone;
  StoryColumn needed{facts.response == nullptr ? "spectral.difference"
                     : is_alone                ? "column.simulated_alone"
                                               : "column.simulated",
                     length};
  StoryColumn reversed{"column.reversed", length}, abs{"ABS", length}, srss{"SRSS", length}, ddc{"DDC", length};
  StoryColumn verdict{.label = "gap.given_is", .are_words = true}, governs{.label = "", .are_words = true};
  const auto shown = [&](double value) { return value > 0 ? without_round_off(value, scale) : value; };
  const auto of_peaks = [&](double asked) { return facts.falls ? not_known : asked; };  // are not all where one falls
  PlaceColumns place_columns(length);
  const char* const between = facts.plan != nullptr ? "gap.edge" : "gap.column";
  StoryTable table{.kind = "levels", .gap = gap};
  for (auto one = levels.rbegin(); one != levels.rend(); ++one) {
    const FacingLevel& level = one->level;
    const bool is_governing = governing && (level.is_point ? !governing->watched && governing->point == level.index
                                                           : governing->watched == level.index);
    const std::size_t place = static_cast<std::size_t>(levels.rend() - one) - 1;
    const Sufficiency value = judged.levels.at(place);
    if (is_governing && value == Sufficiency::too_small) table.marked.push_back(elevation.numbers.size());
    elevation.numbers.push_back(level.elevation);
    place_columns.add(facts, &level);
    given.numbers.push_back(level.width);
    const LevelFacts& facts_of_level = facts.gaps.at(static_cast<std::size_t>(gap)).facts.levels.at(place);
    needed.numbers.push_back(facts_of_level.given.need ? shown(one->gap_needed) : not_known);
    const std::optional<double>& other = facts_of_level.reversed.need;
    reversed.numbers.push_back(other ? shown(*other) : not_known);
    if (is_bound(facts, level, facts_of_level.given.need)) needed.at_most.push_back(needed.numbers.size() - 1);
    if (is_bound(facts, level, other)) reversed.at_most.push_back(reversed.numbers.size() - 1);
    abs.numbers.push_back(of_peaks(one->abs));
    srss.numbers.push_back(of_peaks(one->srss));
    ddc.numbers.push_back(of_peaks(shown(one->ddc)));
    const bool is_pushed = is_governing && value == Sufficiency::too_small && !governing->is_short() &&
                           !judged.reasons.empty() && judged.reasons.front().kind == Reason::Kind::contact;
    verdict.texts.emplace_back(is_pushed ? "gap.pushed" : judged_word(value, judged, facts.is_cut));
    governs.texts.emplace_back(is_governing ? "gap.governs" : "");
    const WatchedFloor* const floor = level.is_point ? nullptr : &facts.problem.watched[level.index];
    kind.texts.emplace_back(floor == nullptr                    ? "gap.contact"
                            : floor->facing_floor               ? "gap.floor"
                            : faces_base(facts.problem, *floor) ? "gap.base"
                                                                : between);
    owner.texts.push_back(floor == nullptr ? "" : facts.problem.buildings[floor->floor_of].name);
  }
  const auto known = [](const StoryColumn& column) {
    return std::any_of(column.numbers.begin(), column.numbers.end(), [](double x) { return !std::isnan(x); });
  };
  const bool watches = std::any_of(owner.texts.begin(), owner.texts.end(), [](const auto& name) { return name != ""; });
  table.columns = {elevation};
  place_columns.put(facts, table);
  table.columns.push_back(given);
  if (known(reversed)) {
    const bool is_reversed = acts_reversed(facts.c);
    needed.label = is_reversed ? "column.reversed" : "column.recorded";
    reversed.label = is_reversed ? "column.recorded" : "column.reversed";
  }
  if (known(needed) || !is_known_by_peaks(facts.problem, gap)) table.columns.push_back(needed);
  if (known(reversed)) table.columns.push_back(reversed);
  table.columns.insert(table.columns.end(), {abs, srss});
  if (known(ddc)) table.columns.push_back(ddc);
  table.columns.push_back(verdict);
  if (watches) table.columns.insert(table.columns.end(), {owner, kind});
  table.columns.push_back(governs);
  return table;
}

StoryTable rule_table(const GapView& facts, Eigen::Index gap, const std::vector<LevelSeparation>& levels) {
  const std::string& length = facts.c.units.length;
  StoryColumn title{.label = "gap.code"}, clause{.label = "gap.clause"}, asked{"gap.asked", length};
  StoryColumn level{"column.elevation", length}, verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn left{"gap.left_to_line", length}, right{"gap.right_to_line", length}, wording{.label = "gap.wording"};
  PlaceColumns place(length);
  bool property_line = false;
  const Judgement& judged = judged_of(facts, gap);
  const bool enough = judged.is_enough();
  StoryTable table{.kind = "rules", .gap = gap};
  for (const RuleFinding& found : findings_of(facts, levels, gap)) {
    const CodeRule* const code = find_code_rule(found.rule);
    if (found.is_short && code != nullptr) table.marked.push_back(title.texts.size());
    title.texts.push_back(found.title);
    clause.texts.emplace_back(code != nullptr ? code->clause : "–");
    asked.numbers.push_back(found.at ? found.gap : not_known);
    level.numbers.push_back(found.at ? levels[*found.at].level.elevation : not_known);
    place.add(facts, found.at ? &levels[*found.at].level : nullptr);
    verdict.texts.emplace_back(found.is_short        ? "gap.too_close"
                               : found.at && !enough ? "gap.asks_less"
                                                     : silence_word(found.silence));
    left.numbers.push_back(found.to_left.value_or(not_known));
    right.numbers.push_back(found.to_right.value_or(not_known));
    wording.texts.emplace_back(code != nullptr ? code->wording : "–");
    property_line = property_line || found.to_left || found.to_right;
  }
  table.columns = {title, clause, asked, level};
  place.put(facts, table);
  table.columns.push_back(verdict);
  if (property_line) table.columns.insert(table.columns.end(), {left, right});
  if (!facts.c.code.rules.empty()) table.columns.push_back(wording);
  return table;
}

StoryTable screening_table(const GapView& facts, Eigen::Index gap) {
  using Verdict = ScreeningFinding::Verdict;
  StoryColumn rule{.label = "screening.rule", .are_words = true}, value{.label = "screening.value"};
  StoryColumn limit{"screening.limit"}, unit{.label = "screening.unit"};
  StoryColumn verdict{.label = "screening.verdict", .are_words = true}, source{.label = "screening.source"};
  StoryTable table{.kind = "screening", .gap = gap};
  for (const ScreeningFinding& found : facts.screened.at(static_cast<std::size_t>(gap))) {
    const bool open = found.rule->yes_or_no && found.verdict == Verdict::needs_seismicity;
    if (found.verdict == Verdict::attention) table.marked.push_back(rule.texts.size());
    rule.texts.push_back("screening." + std::string(found.rule->name));
    value.texts.push_back(open                     ? "–"
                          : !found.rule->yes_or_no ? number(found.value)
                          : found.value > 0        ? "word.yes"
                                                   : "word.no");
    limit.numbers.push_back(found.limit.value_or(not_known));
    unit.texts.push_back(found.rule->unit == "length" ? facts.c.units.length : std::string(found.rule->unit));
    verdict.texts.emplace_back(found.verdict == Verdict::fine               ? "screening.fine"
                               : found.verdict == Verdict::attention        ? "screening.attention"
                               : found.verdict == Verdict::needs_seismicity ? "screening.needs_seismicity"
                                                                            : "screening.not_applicable");
    const std::string_view named = found.rule->source.substr(0, found.rule->source.find_first_of(",("));
    source.texts.push_back(found.rule->wording == "ours" ? "screening.ours" : std::string(named));
  }
  value.are_words = source.are_words = true;
  table.columns = {rule, value, limit, unit, verdict, source};
  return table;
}

}  // namespace

std::vector<RuleFinding> findings_of(const GapView& facts, const std::vector<LevelSeparation>& levels,
                                     Eigen::Index gap) {
  return rule_findings(facts.problem, levels, facts.c.code, facts.scale(gap), facts.falls, facts.plan != nullptr);
}

const char* motion_word(const GroundMotion& motion, const ExcitationSpec& excitation, bool cut) {
  // Of results read back the record's numbers are not known.
  if (std::holds_alternative<SampledMotion>(motion) || excitation.record) {
    return cut ? "story.this_motion_cut" : "story.this_motion";
  }
  if (!std::holds_alternative<HarmonicMotion>(motion)) return "story.this_vibration";
  return cut ? "story.this_harmonic_cut" : "story.this_harmonic";
}

const char* silence_word(RuleFinding::Silence silence) {
  switch (silence) {
    case RuleFinding::Silence::no_level:
      return "story.silence.no_level";
    case RuleFinding::Silence::collapsed:
      return "story.silence.collapsed";
    case RuleFinding::Silence::linked:
      return "story.silence.linked";
    case RuleFinding::Silence::unknown:
      return "story.silence.unknown";
    case RuleFinding::Silence::property_line:
      return "story.silence.property_line";
    case RuleFinding::Silence::displacements:
      return "story.silence.displacements";
    case RuleFinding::Silence::turning:
      return "story.silence.turning";
    case RuleFinding::Silence::periods:
      return "story.silence.periods";
    case RuleFinding::Silence::public_way:
      return "story.silence.public_way";
    case RuleFinding::Silence::none:
      break;
  }
  return "gap.wide_enough";
}

void tell_levels_once(Statement& statement) {
  const auto level_of = [](const std::vector<StoryValue>& item) { return std::get<double>(item[2].value); };
  const auto& items = statement.items;
  const bool alike = !items.empty() && std::all_of(items.begin(), items.end(), [&](const auto& item) {
    return level_of(item) == level_of(items.front());
  });
  for (auto& item : statement.items) {
    item.push_back(alike ? text_of("where", "") : word_of("where", "story.at_level"));
  }
  if (alike) {
    statement.level = level_of(statement.items.front());
    statement.values.push_back(value_in("level", *statement.level, statement.items.front()[2].unit));
  }
  statement.values.push_back(alike ? word_of("where", "story.at_level") : text_of("where", ""));
}

void tell_quotations(const CodeSpec& code, std::vector<Statement>& statements) {
  for (const CodeRuleSpec& given : code.rules) {
    const CodeRule* const rule = find_code_rule(given.rule);
    if (rule == nullptr || rule->quotation.empty()) continue;
    statements.push_back(
        {.kind = "code_quotation",
         .severity = Severity::remark,
         .values = {text_of("rule", std::string(rule->title)), text_of("quotation", std::string(rule->quotation)),
                    text_of("source", std::string(rule->quoted_from))}});
  }
}

double GapView::scale(Eigen::Index gap) const {
  return response != nullptr ? displacement_scale(problem, *response, gap) : 0;
}

void add_level(const GapView& facts, bool is_point, Eigen::Index index, double elevation,
               std::vector<StoryValue>& values) {
  if (facts.plan != nullptr) {
    const PlaceInGap at = place_in_gap(*facts.plan, facts.problem, is_point, index);
    add_place(*facts.plan, facts.plan->gaps[at.gap], is_point, at.index, facts.c.units.length, values);
  } else {
    values.push_back(value_in("level", elevation, facts.c.units.length));
  }
}

void tell_unmodelled(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::vector<WatchedSummary>* watched = &facts.response->watched;
  std::vector<Eigen::Index> met = unmodelled_contacts(facts.problem, *watched, gap);
  if (met.empty()) return;
  const std::optional<ReversedRun>& other = facts.response->reversed;
  bool is_reversed = acts_reversed(facts.c);
  if (other && other->has_contact) {  // of both ways the deeper one
    std::vector<Eigen::Index> there = unmodelled_contacts(facts.problem, other->watched, gap);
    if (!there.empty() && other->watched[there.front()].least_opening < (*watched)[met.front()].least_opening) {
      watched = &other->watched;
      met = std::move(there);
      is_reversed = !is_reversed;
    }
  }
  const bool in_plan = facts.plan != nullptr;
  const std::string& length = facts.c.units.length;
  const WatchedFloor& floor = facts.problem.watched[met.front()];
  const WatchedSummary& summary = (*watched)[met.front()];
  const Remedy remedy = remedy_for(facts.problem, floor, in_plan);
  std::set<std::pair<Eigen::Index, Eigen::Index>> floors;  // in plan one may be at both ends
  for (const Eigen::Index i : met) floors.emplace(facts.problem.watched[i].floor_of, facts.problem.watched[i].floor);
  const auto more = static_cast<long>(floors.size()) - 1;
  Statement statement{.kind = "unmodelled",
                      .severity = Severity::danger,
                      .gap = gap,
                      .buildings = buildings_of(facts.problem, gap),
                      .level = floor.elevation};
  add_level(facts, false, met.front(), floor.elevation, statement.values);
  statement.values.push_back(value_in("depth", -summary.least_opening, length));
  statement.values.push_back(value_in("time", summary.least_time, "s"));
  statement.values.push_back(!other        ? text_of("way", "")
                             : is_reversed ? word_of("way", "story.way.reversed")
                                           : word_of("way", "story.way.recorded"));
  statement.values.push_back(text_of("to_name", written(remedy.level) + "\u00A0" + length));
  add_faces(facts.problem, floor, in_plan, statement.values);
  if (more > 0) statement.values.push_back(count_of("more_floors", more));
  statement.values.push_back(more > 0 ? word_of("others", "story.unmodelled_others") : text_of("others", ""));
  switch (remedy.kind) {
    case Remedy::Kind::name_elevation:
      statement.values.push_back(word_of("remedy", "story.remedy.elevation"));
      break;
    case Remedy::Kind::raise_tolerance:
      statement.values.push_back(value_in("tolerance", remedy.tolerance));
      statement.values.push_back(word_of("remedy", "story.remedy.tolerance"));
      break;
    case Remedy::Kind::strike_column:
      statement.values.push_back(word_of("remedy", "story.remedy.strike"));
      break;
    case Remedy::Kind::give_columns:
      statement.values.push_back(word_of("remedy", "story.remedy.columns"));
      break;
    case Remedy::Kind::give_floor:
      statement.values.push_back(word_of("remedy", "story.remedy.floor"));
      break;
    case Remedy::Kind::give_wall:
      statement.values.push_back(word_of("remedy", "story.remedy.wall"));
      break;
  }
  statements.push_back(std::move(statement));
}

void tell_rules(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::string& length = facts.c.units.length;
  const std::vector<LevelSeparation> levels = of_gap(facts.levels, gap);
  Statement all{.kind = "rules", .gap = gap, .buildings = buildings_of(facts.problem, gap)};
  Statement too_close = all, too_small = all, silent = all, more = all;
  too_close.kind = "rules_short";
  more.kind = "asked_more";
  too_small.kind = "rules_understate";
  too_small.values = {text_of("more", "")};
  silent.kind = "rules_silent";
  const Sufficiency judged = judged_of(facts, gap).value;
  if (judged != Sufficiency::enough) all.kind = "rules_less";
  if (judged == Sufficiency::unknown) more.severity = Severity::warning;
  for (const RuleFinding& found : findings_of(facts, levels, gap)) {
    const StoryValue title = text_of("rule", found.title);
    // Rules of thumb do not decide.
    const bool decides = find_code_rule(found.rule) != nullptr || judged != Sufficiency::enough;
    if (found.is_short && decides) too_close.severity = Severity::warning;
    const bool understates = found.lacks && facts.response != nullptr;
    if (found.at) {
      const double elevation = levels[*found.at].level.elevation;
      auto& items = (found.is_short ? too_close : all).items;
      items.push_back({title, value_in("gap", found.gap, length), value_in("level", elevation, length)});
      if (understates) items.back().push_back(value_in("lacks", *found.lacks, length));
      items.back().push_back(understates ? word_of("note", "story.rules_note") : text_of("note", ""));
    } else {
      silent.items.push_back({title, word_of("why", silence_word(found.silence))});
    }
    if (understates) {
      too_small.items.push_back({title, value_in("gap", found.most, length), value_in("lacks", *found.lacks, length)});
    }
  }
  if (judged != Sufficiency::too_small) more.items = too_close.items;  // else it is too small by what decides
  tell_levels_once(too_close);
  tell_levels_once(more);
  tell_levels_once(all);
  for (Statement* const statement : {&more, &too_close, &all, &too_small, &silent}) {
    if (!statement->items.empty()) statements.push_back(std::move(*statement));
  }
  tell_assumed(facts.c.code, static_cast<std::size_t>(gap), statements);
}

void tell_assumed(const CodeSpec& code, std::optional<std::size_t> gap, std::vector<Statement>& statements) {
  const auto tell = [&](const char* kind, bool (*depends)(const CodeRuleSpec&), bool is_given, const char* answer) {
    Statement statement{.kind = kind, .severity = Severity::finding};
    for (const CodeRuleSpec& spec : code.rules) {
      if (depends(spec)) statement.items.push_back({text_of("rule", std::string(find_code_rule(spec.rule)->title))});
    }
    if (statement.items.empty()) return;
    if (gap) statement.gap = static_cast<Eigen::Index>(*gap);
    statement.kind += answer;
    statement.values = {is_given ? text_of("given", "") : word_of("given", std::string("story.") + kind + "_given")};
    statements.push_back(std::move(statement));
  };
  constexpr const char* boundaries[] = {"_no", "_yes", "_way"};  // of Boundary
  tell("assumed_owner", &depends_on_owner, code.boundaries.has_value(),
       boundaries[static_cast<std::size_t>(code.boundary_at(gap.value_or(0)))]);
  tell("assumed_aligned", &depends_on_alignment, code.floors_aligned.has_value(),
       code.is_aligned(gap.value_or(0)) ? "_yes" : "_no");
}

void put_screening(const GapView& facts, Eigen::Index gap, std::vector<StoryTable>& tables) {
  if (facts.screened.empty()) return;
  StoryTable standing = screening_table(facts, gap);
  if (!standing.columns.front().texts.empty()) tables.push_back(std::move(standing));
}

std::vector<StoryTable> gap_tables(const GapView& facts, Eigen::Index gap) {
  const std::vector<LevelSeparation> levels = of_gap(facts.levels, gap);
  std::vector<StoryTable> tables;
  if (!levels.empty()) {
    tables.push_back(level_table(facts, gap, levels));
    tables.push_back(rule_table(facts, gap, levels));
  }
  put_screening(facts, gap, tables);
  return tables;
}

}  // namespace story

std::vector<StoryTable> screening_tables(const Case& c, const Problem& row, const PlanProblem* plan) {
  story::GapView facts{.c = c, .problem = row, .levels = {}};
  facts.screened = plan != nullptr ? story::screened(c, *plan) : story::screened(c, row);
  std::vector<StoryTable> tables;
  for (Eigen::Index gap = 0; gap < gap_count(row); ++gap) story::put_screening(facts, gap, tables);
  return tables;
}

Story spectral_story(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  const story::GapView facts = story::judged_view_of(c, problem, spectral);
  Story told;
  for (const std::size_t g : worst_first(facts.gaps)) {
    const auto gap = static_cast<Eigen::Index>(g);
    story::tell_judgement(facts, gap, {}, told.statements);
    story::tell_need(facts, gap, told.statements);
    story::tell_rules(facts, gap, told.statements);
  }
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) {
    for (StoryTable& table : story::gap_tables(facts, gap)) told.tables.push_back(std::move(table));
  }
  sort_by_severity(told.statements);
  for (Statement& one : told.statements) {
    if (facts.gaps.size() > 1 && one.gap && one.subject.empty()) one.subject = gap_name(problem, *one.gap);
  }
  story::tell_quotations(c.code, told.statements);
  if (spectral.plan) told.statements.push_back({.kind = "spectrum_both"});
  put_remarks(spectral.plan ? remarks(c, *spectral.plan) : remarks(c, problem), told.statements);
  return told;
}

}  // namespace bentur
