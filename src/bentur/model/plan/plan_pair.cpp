#include "bentur/model/plan/plan_pair.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Eigen::Index;

/// The first component of the ground's motion that there is, which is told of.
std::size_t told_motion(const PlanProblem& problem) {
  return std::holds_alternative<NoMotion>(problem.motions[0]) ? 1 : 0;
}

Building building_of(const PlanBuilding& building) {
  Building row;
  row.name = building.name;
  row.model.elevations = building.model.elevations;
  row.model.storey_heights = building.model.storey_heights;
  row.model.floor_masses = building.model.floor_masses;
  row.modes.omega = building.modes.omega;
  return row;
}

/// Of lists over the buildings those of the two, of lists over the gaps that of theirs.
CodeSpec code_of(const CodeSpec& all, std::size_t gap, const PlanGapSpec& of) {
  const auto pick = [&](auto& list) {
    if (list.size() < 2) return;
    std::decay_t<decltype(list)> of_two{list.at(of.left), list.at(of.right)};
    list = std::move(of_two);
  };
  CodeSpec code = all;
  for (CodeRuleSpec& rule : code.rules) {
    for (auto& [key, list] : rule.numbers) pick(list);
    for (auto& [key, list] : rule.words) pick(list);
  }
  if (code.floors_aligned) code.floors_aligned = std::vector<bool>{code.floors_aligned->at(gap)};
  if (code.boundaries) code.boundaries = std::vector<Boundary>{code.boundaries->at(gap)};
  return code;
}

/// What contacts beside the joint did, as done by the first of the joint's at their level.
void add_beside(const PlanGap& gap, const PlanContact& contact, const PointSummary& did,
                std::vector<PointSummary>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (gap.contacts[i].elevation != contact.elevation) continue;
    points[i].impacts += did.impacts;
    points[i].settling += did.settling;
    points[i].peak_force = std::max(points[i].peak_force, did.peak_force);
    return;
  }
}

}  // namespace

Problem pair_of(const PlanProblem& problem, std::size_t gap) {
  const PlanGap& of = problem.gaps.at(gap);
  Problem pair;
  pair.buildings = {building_of(problem.buildings.at(of.left)), building_of(problem.buildings.at(of.right))};
  for (const PlanContact& contact : of.contacts) {
    if (!contact.is_of_joint()) break;
    pair.points.push_back({.left_floor = contact.left_floor,
                           .right_floor = contact.right_floor,
                           .elevation = contact.elevation,
                           .width = of.width_at(contact),
                           .beyond = of.at(contact).beyond,
                           .law = contact.law});
  }
  for (const PlanWatched& watched : of.watched) {
    WatchedFloor& floor = pair.watched.emplace_back();
    floor.floor_of = watched.floor_of == of.left ? 0 : 1;
    floor.floor = watched.floor;
    floor.facing_floor = watched.facing_floor;
    floor.elevation = watched.elevation;
    floor.width = of.stretch.width_at(watched.along);
    floor.beyond = of.stretch.at(watched.along).beyond;
  }
  pair.motion = problem.motions[told_motion(problem)];
  pair.kinematics = problem.kinematics;
  pair.duration = problem.duration;
  return pair;
}

RunResults pair_of(const PlanCase& c, const PlanProblem& problem, std::size_t gap) {
  RunResults pair;
  pair.c.title = c.title;
  pair.c.units = c.units;
  pair.c.analysis = c.analysis;
  pair.c.code = code_of(c.code, gap, c.gaps.at(gap));
  pair.problem = pair_of(problem, gap);
  pair.c.excitation = c.excitation[told_motion(problem)];
  return pair;
}

RunResults pair_of(const PlanRun& run, std::size_t gap) {
  std::size_t point = 0, watched = 0, points = 0, all_watched = 0;
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    if (g == gap) {
      point = points;
      watched = all_watched;
    }
    points += run.problem.gaps[g].contacts.size();
    all_watched += run.problem.gaps[g].watched.size();
  }
  if (run.response.points.size() != points || run.response.watched.size() != all_watched ||
      run.response.buildings_no_contact.size() != run.problem.buildings.size()) {
    throw InvalidParameter("response", std::to_string(run.response.points.size()) + " points",
                           "must be the response of this problem");
  }
  RunResults pair = pair_of(run.c, run.problem, gap);
  const std::size_t mover = applied_pga(run, 0) > 0 ? 0 : 1;  // of results read back no motion is known
  pair.problem.motion = run.problem.motions[mover];
  pair.c.excitation = run.c.excitation[mover];
  const PlanGap& of = run.problem.gaps[gap];
  const auto part = [](const auto& list, std::size_t from, std::size_t count) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(from);
    return std::decay_t<decltype(list)>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  pair.response.status = run.response.status;
  pair.response.collapse_no_contact = run.response.collapse_no_contact;
  const std::size_t of_joint = pair.problem.points.size();
  const auto with_others = [&](const std::vector<PointSummary>& all) {
    std::vector<PointSummary> joint = part(all, point, of_joint);
    for (std::size_t i = of_joint; i < of.contacts.size(); ++i) add_beside(of, of.contacts[i], all[point + i], joint);
    return joint;
  };
  pair.response.points = with_others(run.response.points);
  pair.response.watched = part(run.response.watched, watched, of.watched.size());
  pair.response.duration = run.response.duration;
  if (const auto& other = run.response.reversed) {
    ReversedRun& reversed = pair.response.reversed.emplace();
    reversed.collapse = other->collapse;
    reversed.collapse_no_contact = other->collapse_no_contact;
    reversed.has_contact = other->has_contact;
    if (other->has_contact) {
      reversed.points = with_others(other->points);
      reversed.watched = part(other->watched, watched, of.watched.size());
    }
  }
  for (const Index b : {of.left, of.right}) {
    const PlanPeaks& free = run.response.buildings_no_contact[b];
    BuildingPeaks& peaks = pair.response.buildings.emplace_back();
    const PlanPoint across = of.stretch.n.cwiseAbs();  // of an oblique one not less than they move
    peaks.displacement_no_contact =
        across.x() * free.south.cwiseMax(free.north) + across.y() * free.west.cwiseMax(free.east);
  }
  return pair;
}

PlanPoint place_of(const PlanGap& gap, bool is_point, Index index) {
  return is_point ? gap.middle(gap.contacts.at(index)) : gap.stretch.middle(gap.watched.at(index).along);
}

std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap) {
  const RunResults pair = pair_of(run, gap);
  if (pair.problem.points.empty() && pair.problem.watched.empty()) return std::nullopt;
  GoverningLevel level = governing_level(pair.problem, pair.response, 0);
  if (!run.c.analysis.both_ways) level.gap_needed_reversed.reset();
  return level;
}

}  // namespace bentur
