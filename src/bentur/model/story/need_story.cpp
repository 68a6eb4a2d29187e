#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/story_parts.h"

// What is said of the gap that buildings need.
namespace bentur::story {
namespace {

/// What is needed at a level under the reversed motion; −1 where that is not known.
double reversed_at(const LevelSeparation& one) { return one.gap_needed_reversed.value_or(-1); }

/// The level that falls short the most of the reversed motion's need, as a governing level of that need.
std::optional<GoverningLevel> governing_reversed(std::vector<LevelSeparation> levels, double scale) {
  if (levels.empty() || std::any_of(levels.begin(), levels.end(), [](const auto& one) { return reversed_at(one) < 0; }))
    return std::nullopt;
  for (LevelSeparation& one : levels) one.gap_needed = *one.gap_needed_reversed;
  return governing_level(levels, scale);
}

Statement need_statement(const GapView& facts, Eigen::Index gap, const GoverningLevel& level, std::string kind) {
  const std::string& length = facts.c.units.length;
  Statement statement{.kind = std::move(kind),
                      .severity = level.is_short() ? Severity::warning : Severity::finding,
                      .level = level.elevation,
                      .values = {value_in("needed", level.needed_here, length)}};
  add_level(facts, !level.watched, level.watched.value_or(level.point), level.elevation, statement.values);
  statement.values.push_back(value_in("width", level.width_here, length));
  const double difference = without_round_off(std::abs(level.needed_here - level.width_here), facts.scale(gap));
  statement.values.push_back(value_in("difference", difference, length));
  statement.gap = gap;
  statement.buildings = buildings_of(facts.problem, gap);
  if (level.watched) {
    add_faces(facts.problem, facts.problem.watched[*level.watched], facts.plan != nullptr, statement.values);
    statement.values.push_back(word_of("faces", "story.faces"));
  } else {
    statement.values.push_back(text_of("faces", ""));
  }
  return statement;
}

/// Whether what may still come after the end leaves less to spare than what has been needed so far.
bool may_leave_less(const GapFacts& facts) {
  double so_far = -std::numeric_limits<double>::infinity(), later = so_far;
  for (const LevelFacts& level : facts.levels) {
    for (const Way way : ways_of_motion) {
      const LevelFacts::OneWay& one = level.in(way);
      if (one.need) so_far = std::max(so_far, *one.need - level.at.width);
      if (one.to_come) later = std::max(later, *one.to_come - level.at.width);
    }
  }
  return more_may_come(later, so_far, facts.scale);
}

/// "to spare" is said of what is judged enough alone.
/// @param leaves_less the motion reversed leaves less to spare, or what may still come does
const char* need_kind(const GoverningLevel& level, const Judgement& judged, bool leaves_less) {
  if (judged.alone) return level.is_short() ? "gap_short_alone" : "gap_need_alone";
  if (level.is_short()) return "gap_short";
  if (!judged.is_enough() || leaves_less) return "gap_need";
  return level.width == 0 && level.gap_needed == 0 ? "gap_touch" : "gap_enough";
}

/// Whether the motion reversed leaves less than that which is given.
bool leaves_less(const std::optional<GoverningLevel>& given, const std::optional<GoverningLevel>& reversed) {
  return reversed && (!given || reversed->gap_needed - reversed->width > given->gap_needed - given->width);
}

void tell_reversed(const GapView& facts, Eigen::Index gap, const std::vector<LevelSeparation>& levels,
                   std::vector<Statement>& statements) {
  const auto level = governing_reversed(levels, facts.scale(gap));
  const GapFacts& known = facts.gaps.at(static_cast<std::size_t>(gap)).facts;
  const bool is_known = std::all_of(known.levels.begin(), known.levels.end(),
                                    [](const LevelFacts& one) { return one.reversed.need.has_value(); });
  if (level && is_known) {
    // The larger of both is a sentence.
    const bool has_more = leaves_less(governing_level(levels, facts.scale(gap)), level);
    const Judgement& judged = judged_of(facts, gap);
    const bool has_spare = judged.is_enough() && has_more && !may_leave_less(known);
    const char* const kind = judged.alone        ? "reversed_alone"
                             : level->is_short() ? "reversed_short"
                             : has_spare         ? "reversed_spare"
                                                 : "reversed_enough";
    statements.push_back(need_statement(facts, gap, *level, kind));
    if (level->is_short() && !has_more) statements.back().shown = Shown::row;
  } else if (known.has_other_way) {
    statements.push_back({.kind = "reversed_unknown", .gap = gap, .buildings = buildings_of(facts.problem, gap)});
  }
}

/// Of masses that may stand elsewhere than expected where they stand when the gap needs the most.
void tell_worst_masses(const GapView& facts, Eigen::Index gap, const std::vector<LevelSeparation>& levels,
                       std::vector<Statement>& statements) {
  if (facts.masses.empty()) return;
  std::optional<GoverningLevel> worst = governing_level(levels, facts.scale(gap));
  const auto reversed = governing_reversed(levels, facts.scale(gap));
  const auto lacks = [](const GoverningLevel& level) { return level.gap_needed - level.width; };
  const bool is_reversed = worst && reversed && lacks(*reversed) > lacks(*worst);
  if (is_reversed) worst = reversed;
  if (!worst) return;
  const auto choice_of = [&](const auto& summary) { return is_reversed ? summary.masses_reversed : summary.masses; };
  const int choice = worst->watched ? choice_of(facts.response->watched.at(*worst->watched))
                                    : choice_of(facts.response->points.at(worst->point));
  Statement statement = need_statement(facts, gap, *worst, "masses_worst");
  statement.severity = Severity::finding;
  statement.shown = Shown::row;
  const std::vector<Eigen::Index> buildings = buildings_of(facts.problem, gap);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto b = static_cast<std::size_t>(buildings.at(side));
    const int at = choice == 0 ? -1 : facts.masses.at(static_cast<std::size_t>(choice) - 1).at(b);
    constexpr const char* ways[] = {"+{}\u00A0%\u00A0x", "−{}\u00A0%\u00A0x", "+{}\u00A0%\u00A0y", "−{}\u00A0%\u00A0y"};
    const std::string moved = at < 0 ? "0"
                                     : fmt::format(fmt::runtime(ways[static_cast<std::size_t>(at)]),
                                                   number(percent * facts.mass_parts.at(b)));
    statement.values.push_back(text_of(side == 0 ? "left" : "right", facts.problem.buildings[b].name));
    statement.values.push_back(text_of(side == 0 ? "left_masses" : "right_masses", moved));
  }
  statements.push_back(std::move(statement));
}

/// Of two that stay apart because they move alike: what they need is the small difference of two large movements, and
/// grows as soon as one is not built as modelled.
void tell_alike(const GapView& facts, Eigen::Index gap, const std::vector<LevelSeparation>& levels,
                std::vector<Statement>& statements) {
  constexpr double alike = 0.1;
  double needed = 0, sum = 0;
  for (const LevelSeparation& one : levels) {
    needed = std::max({needed, one.gap_needed, reversed_at(one)});
    sum = std::max(sum, one.abs);
  }
  if (!judged_of(facts, gap).is_enough() || !(needed < alike * sum)) return;
  statements.push_back(
      {.kind = "move_alike",
       .gap = gap,
       .buildings = buildings_of(facts.problem, gap),
       .values = {value_in("share", percent * needed / sum, "%"), value_in("sum", sum, facts.c.units.length),
                  text_of("left", facts.gaps.at(static_cast<std::size_t>(gap)).facts.left),
                  text_of("right", facts.gaps.at(static_cast<std::size_t>(gap)).facts.right)}});
}

}  // namespace

bool is_bound(const GapView& facts, const FacingLevel& level, const std::optional<double>& need) {
  return facts.plan != nullptr && need && *need > 0 && *need == level.width;
}

void tell_bounds(const GapView& facts, std::vector<Statement>& statements) {
  const auto has_bound = [&](const LevelFacts& level) {
    return is_bound(facts, level.at, level.given.need) || is_bound(facts, level.at, level.reversed.need);
  };
  const bool some = std::any_of(facts.gaps.begin(), facts.gaps.end(), [&](const JudgedGap& one) {
    return std::any_of(one.facts.levels.begin(), one.facts.levels.end(), has_bound);
  });
  if (some) statements.push_back({.kind = "needs_at_most", .severity = Severity::remark});
}

void tell_need(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements) {
  const std::vector<LevelSeparation> levels = of_gap(facts.levels, gap);
  const auto found = governing_level(levels, facts.scale(gap));
  if (!found) {
    statements.push_back({.kind = "no_level", .gap = gap, .buildings = buildings_of(facts.problem, gap)});
    return;
  }
  const GoverningLevel& level = *found;
  if (is_known_by_peaks(facts.problem, gap)) {
    const bool is_enough = judged_of(facts, gap).is_enough();
    statements.push_back(need_statement(facts, gap, level, is_enough ? "given_enough" : "given_peaks"));
    statements.back().severity = Severity::finding;
    return;
  }
  if (facts.response == nullptr) {
    const bool is_enough = judged_of(facts, gap).is_enough();
    statements.push_back(need_statement(facts, gap, level,
                                        level.is_short() ? "spectral_short"
                                        : is_enough      ? "spectral_enough"
                                                         : "spectral_need"));
    return;
  }
  const GapFacts& known = facts.gaps.at(static_cast<std::size_t>(gap)).facts;
  const bool is_known = std::all_of(known.levels.begin(), known.levels.end(),
                                    [](const LevelFacts& one) { return one.given.need.has_value(); });
  if (is_known) {
    const bool less = leaves_less(level, governing_reversed(levels, facts.scale(gap))) || may_leave_less(known);
    statements.push_back(need_statement(facts, gap, level, need_kind(level, judged_of(facts, gap), less)));
    if (facts.is_cut) statements.back().values.push_back(value_in("end", facts.problem.duration, "s"));
    statements.back().values.push_back(
        word_of("motion", motion_word(facts.problem.motion, facts.c.excitation, facts.is_cut)));
  } else {
    statements.push_back({.kind = "need_unknown", .gap = gap, .buildings = buildings_of(facts.problem, gap)});
    statements.back().values = {text_of("left", known.left), text_of("right", known.right)};
  }
  tell_reversed(facts, gap, levels, statements);
  tell_worst_masses(facts, gap, levels, statements);
  tell_alike(facts, gap, levels, statements);
}

}  // namespace bentur::story
