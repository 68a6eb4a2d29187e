#include "bentur/model/story/judgement_story.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <tuple>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {
namespace {

using Eigen::Index;
std::string reason_key(const Reason& reason, bool is_cut) {
  std::string key = "reason.";
  switch (reason.kind) {
    case Reason::Kind::contact:
      key += reason.value > 0 ? "contact" : "contact_impulse";
      break;
    case Reason::Kind::unmodelled:
      key += "unmodelled";
      break;
    case Reason::Kind::need:
      key += "need";
      break;
    case Reason::Kind::rule:
      return key + "rule";
    case Reason::Kind::collapse:
      key += reason.count == 1 ? "collapse_contact" : "collapse";
      break;
    case Reason::Kind::drift:
      key += "drift";
      break;
    case Reason::Kind::capacity:
      return key + "beyond_capacity";
    case Reason::Kind::phase:
      return key + "phase";
    case Reason::Kind::doubt:
      return key + "doubt";
    case Reason::Kind::motion_left:
      if (std::isinf(reason.value)) return key + (is_cut ? "record_left" : "touch_left");
      key += "motion_left";
      break;
    case Reason::Kind::not_looked_at:
      key += "not_looked_at";
      if (reason.count == static_cast<long>(NotLookedAt::masses)) return key + "_masses";
      if (reason.count == static_cast<long>(NotLookedAt::rules)) return key + "_rules";
      break;
  }
  return key + (reason.way == Way::reversed ? "_reversed" : "");
}

}  // namespace

std::vector<StoryValue> reason_item(const GapView& view, Index gap, const Reason& reason) {
  const GapFacts& facts = view.gaps.at(static_cast<std::size_t>(gap)).facts;
  const std::string& length = view.c.units.length;
  std::vector<StoryValue> item;
  if (reason.level) {
    const FacingLevel& at = facts.levels.at(*reason.level).at;
    add_level(view, at.is_point, at.index, at.elevation, item);
  }
  const auto lengths = [&](const char* name) {
    item.push_back(value_in(name, reason.value, length));
    item.push_back(value_in("short", reason.value - reason.width, length));
  };
  switch (reason.kind) {
    case Reason::Kind::contact: {
      const ShownUnits shown = shown_units(view.c.units, *view.response);
      item.push_back(count_of("times", reason.count));
      item.push_back(value_in("force", shown.force * reason.value, shown.units.force));
      break;
    }
    case Reason::Kind::unmodelled:
      item.push_back(value_in("depth", reason.value, length));
      break;
    case Reason::Kind::need:
    case Reason::Kind::phase:
    case Reason::Kind::motion_left:
      lengths("needed");
      break;
    case Reason::Kind::rule:
      lengths("asked");
      item.push_back(text_of("rule", reason.subject));
      break;
    case Reason::Kind::collapse:
      item.push_back(value_in("time", reason.value, "s"));
      break;
    case Reason::Kind::drift:
      item.push_back(value_in("drift", percent * reason.value, "%"));
      break;
    case Reason::Kind::capacity:
      item.push_back(value_in("ratio", reason.value));
      break;
    case Reason::Kind::doubt:
    case Reason::Kind::not_looked_at:
      break;
  }
  if (reason.kind == Reason::Kind::collapse || reason.kind == Reason::Kind::drift ||
      reason.kind == Reason::Kind::capacity) {
    item.push_back(text_of("building", reason.subject));
    item.push_back(count_of("storey", static_cast<long>(reason.storey)));
  }
  const std::vector<Reason>& all = view.gaps.at(static_cast<std::size_t>(gap)).judgement.reasons;
  const bool is_both = reason.way == Way::given && !acts_reversed(view.c) &&
                       std::any_of(all.begin(), all.end(), [&](const Reason& other) {
                         return other.kind == reason.kind && other.way == Way::reversed;
                       });
  item.push_back(is_both ? word_of("way", "reason.way.recorded") : text_of("way", ""));
  item.push_back(word_of("why", reason_key(reason, view.is_cut)));  // after the words that fill it
  return item;
}

const char* judged_word(Sufficiency value, const Judgement& judged, bool is_cut) {
  if (value != Sufficiency::unknown) return judgement_word(value);
  const char* const left = is_cut ? "gap.not_known.cut" : "gap.not_known.left";
  for (const Reason& reason : judged.reasons) {
    switch (reason.kind) {
      case Reason::Kind::collapse:
        return "gap.not_known.collapse";
      case Reason::Kind::drift:
        return "gap.not_known.drift";
      case Reason::Kind::capacity:
        return "gap.not_known.capacity";
      case Reason::Kind::phase:
        return "gap.not_known.phase";
      case Reason::Kind::doubt:
        return "gap.not_known.doubt";
      case Reason::Kind::motion_left:
        return left;
      case Reason::Kind::not_looked_at:
        return reason.count == static_cast<long>(NotLookedAt::rules) ? "gap.not_known.rules"
                                                                     : "gap.not_known.not_looked_at";
      default:  // it says too small, of another level
        break;
    }
  }
  return left;  // beside what falls short at other levels
}

void tell_judgement(const GapView& view, Index gap, const std::function<void(Statement)>& hit,
                    std::vector<Statement>& statements) {
  const Judgement& judged = view.gaps.at(static_cast<std::size_t>(gap)).judgement;
  const GapFacts& facts = view.gaps.at(static_cast<std::size_t>(gap)).facts;
  const auto has = [&](Reason::Kind kind) {
    return std::any_of(judged.reasons.begin(), judged.reasons.end(),
                       [&](const Reason& one) { return one.kind == kind && one.way == Way::given; });
  };
  Statement statement{.kind = "no_pounding", .gap = gap, .buildings = buildings_of(view.problem, gap)};
  statement.values = {text_of("left", facts.left), text_of("right", facts.right)};
  if (const Response* const response = view.response) {
    const double duration = response->collapse ? response->collapse->time : view.problem.duration;
    statement.values.push_back(value_in("duration", duration, "s"));
  }
  if (has(Reason::Kind::contact)) return hit(std::move(statement));
  const bool has_points =
      std::any_of(facts.levels.begin(), facts.levels.end(), [](const LevelFacts& level) { return level.at.is_point; });
  if (has(Reason::Kind::unmodelled)) {
    statement.kind = "no_impact";
    if (has_points) statements.push_back(std::move(statement));
    return;
  }
  if (facts.levels.empty()) return;
  const bool is_need_alone = std::all_of(judged.reasons.begin(), judged.reasons.end(),
                                         [](const Reason& one) { return one.kind == Reason::Kind::need; });
  if (view.response == nullptr && is_need_alone) return;  // what is needed says so
  if (!judged.is_enough()) {
    const bool is_small = judged.value == Sufficiency::too_small;
    statement.kind = is_small ? "too_small" : "not_known";
    statement.severity = Severity::warning;
    double width = facts.levels.front().at.width;
    for (const LevelFacts& level : facts.levels) width = std::min(width, level.at.width);
    statement.values.push_back(value_in("width", width, view.c.units.length));
    bool has_doubt = false;  // each of which has a sentence of its own
    for (const Reason& reason : judged.reasons) {
      if (says_too_small(reason.kind) != is_small || (reason.kind == Reason::Kind::doubt && has_doubt)) continue;
      has_doubt = has_doubt || reason.kind == Reason::Kind::doubt;
      // A record that goes on does so in both directions.
      if (std::isinf(reason.value) && reason.way == Way::reversed) continue;
      statement.items.push_back(reason_item(view, gap, reason));
    }
  }
  statements.push_back(std::move(statement));
}

}  // namespace bentur::story

// What is said of several gaps together, of rows and of blocks in plan.
namespace bentur {
namespace {

/// By how much a gap falls short of what it needs, as recorded or reversed [length]; below zero where it does not.
double lacking(const GoverningNeed& need) {
  return std::max(need.given.needed.value_or(0), need.reversed.needed.value_or(0)) - need.at.width;
}

}  // namespace

std::vector<std::size_t> worst_first(const std::vector<JudgedGap>& gaps) {
  std::vector<std::size_t> order(gaps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> lacks;
  for (const JudgedGap& one : gaps) lacks.push_back(lacking(governing_need(one.facts).value_or(GoverningNeed{})));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Sufficiency of_a = gaps[a].judgement.value, of_b = gaps[b].judgement.value;
    if (of_a != of_b) return of_a < of_b;
    return lacks[a] != lacks[b] ? lacks[a] > lacks[b] : gaps[a].facts.peak_force() > gaps[b].facts.peak_force();
  });
  return order;
}

StoryTable begun_table(std::vector<std::size_t>& order, const std::function<Sufficiency(std::size_t)>& judged) {
  constexpr std::size_t most_lines = 12;
  const std::size_t count = order.size(), lines = count <= most_lines ? count : worst_gaps_shown;
  if (lines == count) std::iota(order.begin(), order.end(), std::size_t{0});
  const auto in_rest = [&](Sufficiency value) {
    return std::count_if(order.begin() + static_cast<std::ptrdiff_t>(lines), order.end(),
                         [&](std::size_t gap) { return judged(gap) == value; });
  };
  using story::count_of;
  StoryTable table{
      .kind = lines == count ? "row" : "row_worst",
      .values = {count_of("shown", static_cast<long>(lines)), count_of("count", static_cast<long>(count)),
                 count_of("rest", static_cast<long>(count - lines)), count_of("small", in_rest(Sufficiency::too_small)),
                 count_of("unknown", in_rest(Sufficiency::unknown)), count_of("enough", in_rest(Sufficiency::enough))}};
  order.resize(lines);
  return table;
}

namespace story {
namespace {

/// What is judged of a gap, and, of one that is too small, though not short of what it needs, why.
const char* verdict_of(const Judgement& judged, bool is_short, bool is_cut) {
  if (judged.value == Sufficiency::too_small && !is_short && !judged.reasons.empty()) {
    switch (judged.reasons.front().kind) {
      case Reason::Kind::contact:
        return "gap.pushed";
      case Reason::Kind::unmodelled:
        return "gap.unmodelled";
      case Reason::Kind::rule:
        return "gap.by_rule";
      default:
        break;
    }
  }
  if (judged.is_enough() && judged.alone) return "gap.enough_alone";
  return judged_word(judged.value, judged, is_cut);
}

/// Writes a length with as many more digits as it takes where it would read as the one that is given, or as nothing,
/// and is not. @param given beside it, else nullptr
void show_difference(const StoryColumn* given, std::size_t row, StoryColumn& column) {
  constexpr int most_digits = 4;  // more are round-off
  const double value = column.numbers[row];
  std::string& text = column.texts[row];
  const auto reads_alike = [&] {
    const std::optional<double> read = parse_number(text);
    const bool is_as_given =
        given != nullptr && read == parse_number(given->texts[row]) && value != given->numbers[row];
    return read && (is_as_given || (*read == 0 && value > 0));
  };
  const std::size_t point = text.find('.');
  const auto decimals = point == std::string::npos ? 0 : static_cast<int>(text.size() - point) - 1;
  for (int more = 1; more <= most_digits && reads_alike(); ++more) {
    text = fmt::format("{:.{}f}", value, decimals + more);
  }
}

/// Lengths of several columns with equally many decimals, of three digits; those that are given keep all of theirs.
/// @param lacks of `computed` the differences
void set_alike(StoryColumn& given, std::initializer_list<StoryColumn*> computed, const StoryColumn& lacks) {
  std::vector<double> all;
  for (const StoryColumn* const one : computed) all.insert(all.end(), one->numbers.begin(), one->numbers.end());
  all.insert(all.end(), given.numbers.begin(), given.numbers.end());
  const std::vector<std::string> texts = column(all, 3);
  auto text = texts.begin();
  for (StoryColumn* const one : computed) {
    one->are_counts = true;
    one->texts.assign(text, text + std::ssize(one->numbers));
    text += std::ssize(one->numbers);
  }
  const std::vector<std::string> own = column(given.numbers);
  given.are_counts = true;
  for (std::size_t i = 0; i < own.size(); ++i, ++text) {
    given.texts.push_back(text->size() < own[i].size() ? own[i] : *text);
  }
  for (StoryColumn* const one : computed) {
    for (std::size_t i = 0; i < own.size(); ++i) show_difference(one == &lacks ? nullptr : &given, i, *one);
  }
}

/// Of all in their order, or of many of the worst. @param order worst_first()
StoryTable table_of_gaps(const GapView& view, std::vector<std::size_t> order, const ShownUnits& shown) {
  const std::string& length = view.c.units.length;
  StoryTable table = begun_table(order, [&](std::size_t g) { return view.gaps[g].judgement.value; });
  StoryColumn name{.label = "column.gap"}, verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn given{"column.given", length}, needed{"column.recorded", length}, reversed{"column.reversed", length};
  StoryColumn lacks{"column.short_by", length};
  StoryColumn impacts{.label = "column.impacts", .are_counts = true}, hardest{"column.hardest", shown.units.force};
  for (const std::size_t g : order) {
    const auto& [facts, judgement] = view.gaps[g];
    const GoverningNeed need = governing_need(facts).value_or(GoverningNeed{});
    if (judgement.value == Sufficiency::too_small) table.marked.push_back(name.texts.size());
    name.texts.push_back(gap_name(view.problem, static_cast<Index>(g)));
    given.numbers.push_back(need.at.width);
    needed.numbers.push_back(need.given.needed.value_or(not_known));
    reversed.numbers.push_back(need.reversed.needed.value_or(not_known));
    if (is_bound(view, need.at, need.given.needed)) needed.at_most.push_back(needed.numbers.size() - 1);
    if (is_bound(view, need.at, need.reversed.needed)) reversed.at_most.push_back(reversed.numbers.size() - 1);
    const bool is_short = need.given.is_short || need.reversed.is_short;
    lacks.numbers.push_back(is_short ? lacking(need) : not_known);
    verdict.texts.emplace_back(verdict_of(judgement, is_short, view.is_cut));
    long count = 0;
    for (const LevelFacts& level : facts.levels) count += level.given.impacts;
    impacts.texts.push_back(std::to_string(count));
    hardest.numbers.push_back(facts.peak_force() > 0 ? shown.force * facts.peak_force() : not_known);
  }
  set_alike(given, {&needed, &reversed, &lacks}, lacks);
  if (acts_reversed(view.c)) std::swap(needed.label, reversed.label);
  table.columns = {name, verdict, given, needed, reversed, lacks, impacts, hardest};
  return table;
}

/// Of gaps that close though they are wider than their buildings need, of many of the worst, what that need is. It is
/// not said to do: a rule may ask for more, or the run end before the motion does.
void tell_pushed(const GapView& view, const std::vector<std::size_t>& order, std::vector<Statement>& statements) {
  constexpr std::size_t most = 5;
  std::size_t count = 0;
  for (const std::size_t g : order) {
    const auto& [facts, judgement] = view.gaps[g];
    const std::optional<GoverningNeed> need = governing_need(facts);
    if (judgement.value != Sufficiency::too_small || judgement.reasons.empty() || !need) continue;
    if (judgement.reasons.front().kind != Reason::Kind::contact || need->given.is_short || need->reversed.is_short)
      continue;
    if (!need->given.needed || (facts.has_other_way && !need->reversed.needed)) continue;
    if (++count > most) break;
    const double needed = std::max(*need->given.needed, need->reversed.needed.value_or(0));
    const std::string& length = view.c.units.length;
    statements.push_back({.kind = "row_pushed",
                          .gap = static_cast<Index>(g),
                          .buildings = buildings_of(view.problem, static_cast<Index>(g)),
                          .level = need->at.elevation,
                          .values = {value_in("needed", needed, length), value_in("level", need->at.elevation, length)},
                          .shown = Shown::row});
  }
}

}  // namespace

std::optional<Index> tell_gaps(const GapView& view, const ShownUnits& shown, Story& told) {
  if (view.gaps.size() < 2) return std::nullopt;
  const std::vector<std::size_t> order = worst_first(view.gaps);
  told.tables.push_back(table_of_gaps(view, order, shown));
  const auto judged = [&](Sufficiency as) {
    return std::count_if(view.gaps.begin(), view.gaps.end(),
                         [&](const JudgedGap& one) { return one.judgement.value == as; });
  };
  const long count = std::ssize(view.gaps), small = judged(Sufficiency::too_small),
             unknown = judged(Sufficiency::unknown);
  const auto cut_at = view.is_cut ? std::optional(view.problem.duration) : std::nullopt;
  told.statements.push_back(counted_gaps(count, small, unknown, "row_none", cut_at));
  tell_reversed_contact(view, shown, told.statements);
  tell_pushed(view, order, told.statements);
  return static_cast<Index>(order.front());
}

}  // namespace story

namespace {

ToldJudgement told(const story::GapView& view, Eigen::Index gap) {
  const GapFacts& facts = view.gaps.at(static_cast<std::size_t>(gap)).facts;
  const GapPair sides = sides_of(view.problem, gap);
  ToldJudgement made{.left = sides.left,
                     .right = sides.right,
                     .width = not_known,
                     .judgement = view.gaps.at(static_cast<std::size_t>(gap)).judgement};
  for (const LevelFacts& level : facts.levels) {
    made.width = made.width == made.width ? std::min(made.width, level.at.width) : level.at.width;
  }
  for (const Reason& reason : made.judgement.reasons) {
    made.reasons.push_back(story::reason_item(view, gap, reason));
    made.elevations.push_back(reason.level ? facts.levels.at(*reason.level).at.elevation : not_known);
  }
  return made;
}

std::vector<ToldJudgement> told(const story::GapView& view) {
  std::vector<ToldJudgement> all;
  for (Eigen::Index gap = 0; gap < std::ssize(view.gaps); ++gap) all.push_back(told(view, gap));
  return all;
}

}  // namespace

const char* judgement_word(Sufficiency value) {
  return value == Sufficiency::too_small ? "gap.too_close"
         : value == Sufficiency::unknown ? "gap.not_known"
                                         : "gap.wide_enough";
}

std::vector<ToldJudgement> told_judgements(const RunResults& run) { return told(story::judged_view_of(run)); }

std::vector<ToldJudgement> told_judgements(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  return told(story::judged_view_of(c, problem, spectral));
}

std::vector<ToldJudgement> told_judgements(const PlanRun& run) { return told(story::judged_view_of(run)); }

namespace {

/// A reason with how many records have it, and under which it is the worst.
std::vector<StoryValue> item_of(const ManyToTell& told, const JudgementOfMany::Found& found, std::size_t record) {
  const ToldJudgement& worst = told.of_records.at(record);
  const auto& reasons = worst.judgement.reasons;
  const auto at = std::find_if(reasons.begin(), reasons.end(), [&](const Reason& one) {
    return one.kind == found.worst.kind && one.way == found.worst.way && one.value == found.worst.value &&
           one.subject == found.worst.subject;
  });
  std::vector<StoryValue> item = worst.reasons.at(static_cast<std::size_t>(at - reasons.begin()));
  item.push_back(story::count_of("under", found.runs));
  item.push_back(story::text_of("record", told.names.at(record)));
  return item;
}

}  // namespace

Statement counted_gaps(long count, long small, long unknown, std::string none, std::optional<double> cut_at) {
  Statement statement{.kind = small == count     ? "row_all"
                              : small > 0        ? "row_some"
                              : unknown == count ? "row_all_unknown"
                              : unknown > 0      ? "row_unknown"
                                                 : std::move(none),
                      .severity = small + unknown == 0 ? Severity::finding : Severity::warning};
  const bool more = small > 0 && unknown > 0;
  statement.values = {
      story::count_of("count", count),
      story::count_of("small", small),
      story::count_of("unknown", unknown),
      story::count_of("may_be", unknown),
      story::word_of("fall_short", small == 1 ? "story.is_small" : "story.are_small"),
  };
  const bool is_cut = unknown > 0 && cut_at;
  if (is_cut) statement.values.push_back(story::value_in("end", *cut_at, "s"));  // which fills {since}
  statement.values.push_back(is_cut ? story::word_of("since", "story.since_cut") : story::text_of("since", ""));
  statement.values.push_back(more ? story::word_of("others", "story.row_others") : story::text_of("others", ""));
  return statement;
}

std::vector<Statement> judgement_of_many(const ManyToTell& told, Eigen::Index gap) {
  using story::count_of;
  using story::text_of;
  const JudgementOfMany& many = told.many;
  const ToldJudgement& first = told.of_records.front();
  std::vector<Statement> statements;
  if (!first.is_facing()) return statements;
  const auto begun = [&](const char* kind, long count) {
    Statement one{.kind = kind, .severity = Severity::warning, .gap = gap, .buildings = {first.left, first.right}};
    one.values = {text_of("left", told.left), text_of("right", told.right),
                  story::value_in("width", first.width, told.length), count_of("count", count),
                  count_of("records", many.runs)};
    return one;
  };
  // Each of the two counts its reasons among its own records.
  for (const auto& [value, kind, count] : {std::tuple(Sufficiency::too_small, "records_too_small", many.too_small),
                                           {Sufficiency::unknown, "records_not_known", many.not_known}}) {
    std::vector<std::size_t> places;
    std::vector<Judgement> of_value;
    for (std::size_t i = 0; i < told.of_records.size(); ++i) {
      const Judgement& judged = told.of_records[i].judgement;
      if (without_rules(judged) != value) continue;
      places.push_back(i);
      of_value.push_back(judged);
    }
    if (places.empty()) continue;
    Statement one = begun(kind, count);
    for (const JudgementOfMany::Found& found : judge(of_value, {}).reasons) {
      if (says_too_small(found.worst.kind) != (value == Sufficiency::too_small)) continue;
      // A record that goes on does so in both directions.
      if (std::isinf(found.worst.value) && found.worst.way == Way::reversed) continue;
      one.items.push_back(item_of(told, found, places.at(found.run)));
    }
    statements.push_back(std::move(one));
  }
  if (many.too_small + many.not_known == 0) {
    statements.push_back(begun(many.is_enough() ? "records_enough" : "records_apart", many.enough));
    statements.back().severity = Severity::finding;
  }
  return statements;
}

}  // namespace bentur
