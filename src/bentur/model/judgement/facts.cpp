#include "bentur/model/judgement/facts.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

using Eigen::Index;

void raise(std::optional<double>& value, const std::optional<double>& other) {
  if (other) value = std::max(value.value_or(0), *other);
}

int touches(const PointSummary& point) { return point.impacts + point.settling; }

/// Of a contact point or a watched floor. @param others_close so that these buildings move as those that are struck
LevelFacts level_facts(const FacingLevel& at, const Response& response, bool others_close) {
  LevelFacts facts{.at = at};
  const auto take = [&](const auto& summary) {
    if (!response.collapse_no_contact) facts.given.need = summary.gap_needed;
    facts.given.to_come = summary.to_come;
    facts.reversed.need = summary.gap_needed_reversed;
    facts.reversed.to_come = summary.to_come_reversed;
    if (others_close) raise(facts.given.to_come, summary.to_come_struck);
  };
  const auto index = static_cast<std::size_t>(at.index);
  const ReversedRun* const other = response.reversed ? &*response.reversed : nullptr;
  if (at.is_point) {
    const PointSummary& point = response.points.at(index);
    take(point);
    facts.given.impacts = touches(point);
    facts.given.peak_force = point.peak_force;
    if (other != nullptr && other->has_contact) {
      facts.reversed.impacts = touches(other->points.at(index));
      facts.reversed.peak_force = other->points.at(index).peak_force;
      if (others_close) raise(facts.reversed.to_come, other->points.at(index).to_come_struck);
    }
  } else {
    const WatchedSummary& floor = response.watched.at(index);
    take(floor);
    if (floor.closes) facts.given.depth = -floor.least_opening;
    if (other != nullptr && other->has_contact) {
      const WatchedSummary& found = other->watched.at(index);
      if (found.closes) facts.reversed.depth = -found.least_opening;
      if (others_close) raise(facts.reversed.to_come, found.to_come_struck);
    }
  }
  return facts;
}

/// Of the doubts those about one of the two buildings or the gap, or about none.
std::vector<Remark> doubts_about(const RunFacts& run, const std::string& left, const std::string& right,
                                 const std::string& gap) {
  std::vector<Remark> doubts;
  for (const Remark& one : run.doubts) {
    const std::string of = one.subject.substr(0, one.subject.find(','));
    const bool is_shared = std::find(run.names.begin(), run.names.end(), of) == run.names.end();
    if (is_shared || of == left || of == right || one.subject == gap) doubts.push_back(one);
  }
  return doubts;
}

/// All of a gap but its levels.
GapFacts common_facts(const Problem& problem, Index gap, std::vector<RuleFinding> rules, const RunFacts& run) {
  const std::vector<Index> both = buildings_of(problem, gap);
  GapFacts facts{.left = problem.buildings[both[0]].name,
                 .right = problem.buildings[both[1]].name,
                 .levels = {},
                 .given = run.given,
                 .reversed = run.reversed,
                 .has_other_way = run.has_other_way,
                 .others_close = false,
                 .rules = std::move(rules),
                 .doubts = {},
                 .scale = 0};
  facts.doubts = doubts_about(run, facts.left, facts.right, gap_name(problem, gap));
  facts.lacks_rules = run.lacks_rules;
  for (WayFacts* const way : {&facts.given, &facts.reversed}) {
    const auto is_of_another = [&](const Beyond& one) {
      return one.building != facts.left && one.building != facts.right;
    };
    std::erase_if(way->drifts, is_of_another);
    std::erase_if(way->capacities, is_of_another);
  }
  return facts;
}

}  // namespace

GapFacts gap_facts(const Problem& problem, const Response& response, Index gap,
                   const std::vector<LevelSeparation>& levels, std::vector<RuleFinding> rules, const RunFacts& run,
                   bool others_close) {
  GapFacts facts = common_facts(problem, gap, std::move(rules), run);
  facts.others_close = others_close;
  facts.masses_moved = others_close && run.masses_elsewhere;
  facts.scale = displacement_scale(problem, response, gap);
  for (const LevelSeparation& level : levels) facts.levels.push_back(level_facts(level.level, response, others_close));
  // Where only this gap can close it does so exactly where it needs more than it has.
  facts.reversed.contact_looked_at = !others_close || (response.reversed && response.reversed->has_contact);
  for (const Way way : ways_of_motion) {
    const WayFacts& of = facts.in(way);
    if (!of.fall && of.drifts.empty()) continue;
    for (LevelFacts& level : facts.levels) {
      std::optional<double>& need = level.in(way).need;
      // What falls short by an elastic response does all the same.
      if (of.fall || (need && !is_below_target(level.at.width, *need, facts.scale))) need.reset();
    }
  }
  return facts;
}

GapFacts gap_facts(const Problem& problem, Index gap, const std::vector<LevelSeparation>& levels,
                   std::vector<RuleFinding> rules, const RunFacts& run) {
  GapFacts facts = common_facts(problem, gap, std::move(rules), run);
  for (const LevelSeparation& level : levels) {
    facts.levels.push_back({.at = level.level});
    LevelFacts::OneWay& given = facts.levels.back().given;
    (is_known_by_peaks(problem, gap) ? given.at_most : given.need) = level.gap_needed;
  }
  return facts;
}

double GapFacts::peak_force(Way way) const {
  double most = 0;
  for (const LevelFacts& level : levels) most = std::max(most, level.in(way).peak_force);
  return most;
}

bool GapFacts::touch(Way way) const {
  return std::any_of(levels.begin(), levels.end(), [&](const LevelFacts& level) { return level.in(way).impacts > 0; });
}

bool RunFacts::others_close(std::size_t gap) const {
  for (std::size_t g = 0; g < closes.size(); ++g) {
    if (g != gap && closes[g]) return true;
  }
  return false;
}

std::vector<Remark> doubts_of(const std::vector<Remark>& remarks) {
  std::vector<Remark> doubts;
  std::copy_if(remarks.begin(), remarks.end(), std::back_inserter(doubts),
               [](const Remark& one) { return one.is_doubt; });
  return doubts;
}

bool closes_either_way(const Problem& problem, const Response& response, Index gap) {
  for (const FacingLevel& level : facing_levels(problem, gap)) {
    const LevelFacts facts = level_facts(level, response, false);
    for (const Way way : ways_of_motion) {
      if (facts.in(way).impacts > 0) return true;
    }
    if (level.is_point &&
        is_below_target(level.width, facts.reversed.need.value_or(0), displacement_scale(problem, response, gap)))
      return true;
  }
  return false;
}

}  // namespace bentur
