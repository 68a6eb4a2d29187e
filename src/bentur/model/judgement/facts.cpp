#include "bentur/model/judgement/facts.h"

#include <algorithm>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

using Eigen::Index;

int touches(const PointSummary& point) { return point.impacts + point.settling; }

/// Of a contact point; `with`: of the run the same way with contact, null: the other way, which was not run.
LevelFacts level_facts(const FacingLevel& at, const Response& response) {
  LevelFacts facts{.at = at};
  const auto take = [&](const auto& summary) {
    if (!response.collapse_no_contact) facts.given.need = summary.gap_needed;
    facts.given.to_come = summary.to_come;
    facts.reversed.need = summary.gap_needed_reversed;
    facts.reversed.to_come = summary.to_come_reversed;
  };
  const auto index = static_cast<std::size_t>(at.index);
  const ReversedRun* const other = response.reversed ? &*response.reversed : nullptr;
  if (at.is_point) {
    const PointSummary& point = response.points.at(index);
    take(point);
    facts.given.impacts = touches(point);
    facts.given.peak_force = point.peak_force;
    if (other != nullptr && !other->points.empty()) {
      facts.reversed.impacts = touches(other->points.at(index));
      facts.reversed.peak_force = other->points.at(index).peak_force;
    }
  } else {
    const WatchedSummary& floor = response.watched.at(index);
    take(floor);
    if (floor.closes) facts.given.depth = -floor.least_opening;
    if (other != nullptr && !other->watched.empty() && other->watched.at(index).closes) {
      facts.reversed.depth = -other->watched.at(index).least_opening;
    }
  }
  return facts;
}

/// Of the doubts those about the run as a whole or about one of the two buildings.
std::vector<Remark> doubts_of(const RunFacts& run, const std::string& left, const std::string& right,
                              const std::string& gap) {
  std::vector<Remark> doubts;
  for (const Remark& one : run.doubts) {
    const auto is_of = [&](const std::string& name) {
      return one.subject == name || one.subject.starts_with(name + ",");
    };
    if (one.subject.empty() || is_of(left) || is_of(right) || one.subject == gap) doubts.push_back(one);
  }
  return doubts;
}

}  // namespace

GapFacts gap_facts(const Problem& problem, const Response& response, Index gap,
                   const std::vector<LevelSeparation>& levels, std::vector<RuleFinding> rules, const RunFacts& run,
                   bool others_close) {
  GapFacts facts{.left = problem.buildings.at(static_cast<std::size_t>(gap)).name,
                 .right = problem.buildings.at(static_cast<std::size_t>(gap + 1)).name,
                 .levels = {},
                 .given = run.given,
                 .reversed = run.reversed,
                 .has_other_way = run.has_other_way,
                 .others_close = others_close,
                 .rules = std::move(rules),
                 .doubts = {},
                 .scale = displacement_scale(problem, response, gap)};
  for (const LevelSeparation& level : levels) facts.levels.push_back(level_facts(level.level, response));
  // Where only this gap can close it does so exactly where it needs more than it has.
  facts.struck_looked_at[1] = !others_close || (response.reversed && !response.reversed->points.empty());
  facts.doubts = doubts_of(run, facts.left, facts.right, gap_name(problem, gap));
  const auto of_both = [&](WayFacts& way) {
    std::erase_if(way.drifts, [&](const DriftBeyond& one) {
      return one.building != facts.left && one.building != facts.right;
    });
    if (!way.looked_at || way.fall || !way.drifts.empty()) {
      for (LevelFacts& level : facts.levels) (&way == &facts.given ? level.given : level.reversed).need.reset();
    }
  };
  of_both(facts.given);
  of_both(facts.reversed);
  return facts;
}

bool closes_either_way(const Problem& problem, const Response& response, Index gap) {
  for (const FacingLevel& level : facing_levels(problem, gap)) {
    const LevelFacts facts = level_facts(level, response);
    for (const Way way : both_ways) {
      if (facts.in(way).impacts > 0) return true;
    }
    if (level.is_point && facts.reversed.need.value_or(0) > level.width) return true;
  }
  return false;
}

}  // namespace bentur
