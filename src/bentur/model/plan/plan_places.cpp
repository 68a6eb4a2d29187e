#include "bentur/model/plan/plan_places.h"

#include <algorithm>
#include <set>

namespace bentur {

using Eigen::Index;

std::vector<QuantityPlace> floors_of(const PlanProblem& problem, Index building, Index plane) {
  std::vector<QuantityPlace> places;
  for (Index f = 0; f < problem.buildings[building].model.floors(); ++f) places.push_back({building, f, plane});
  return places;
}

namespace {

/// Of each frame of a building as many as there are of a list of its hinges.
template <class Item>
std::vector<QuantityPlace> of_frames_of(const PlanProblem& problem, Index building, std::vector<Item> Hinges::*list) {
  std::vector<QuantityPlace> places;
  const std::vector<PlanModel::Plane>& planes = problem.buildings[building].model.planes;
  for (Index plane = 0; plane < std::ssize(planes); ++plane) {
    const Index count = std::ssize(planes[plane].hinges.*list);
    for (Index i = 0; i < count; ++i) places.push_back({building, i, plane});
  }
  return places;
}

}  // namespace

std::vector<QuantityPlace> hinges_of(const PlanProblem& problem, Index building) {
  return of_frames_of(problem, building, &Hinges::places);
}

std::vector<QuantityPlace> breaking_columns_of(const PlanProblem& problem, Index building) {
  return of_frames_of(problem, building, &Hinges::columns);
}

std::vector<QuantityPlace> planes_from_top(const PlanProblem& problem, Index building) {
  std::vector<QuantityPlace> places;
  for (Index plane = 0; plane < std::ssize(problem.buildings[building].model.planes); ++plane) {
    const std::vector<QuantityPlace> storeys = floors_of(problem, building, plane);
    places.insert(places.end(), storeys.rbegin(), storeys.rend() - problem.buildings[building].model.first_storey());
  }
  return places;
}

std::vector<QuantityPlace> bearings_of(const PlanProblem& problem, Index building) {
  std::vector<QuantityPlace> places;
  for (Index n = 0; n < std::ssize(problem.buildings[building].model.bearings); ++n) {
    places.push_back({.item = building, .plane = n});
  }
  return places;
}

std::vector<QuantityPlace> places_in(const PlanProblem& problem, Owner owner, Index building) {
  if (owner == Owner::building) return {{.item = building}};
  if (owner == Owner::floor) return floors_of(problem, building);
  if (owner == Owner::hinge) return hinges_of(problem, building);
  if (owner == Owner::column) return breaking_columns_of(problem, building);
  if (owner == Owner::bearing) return bearings_of(problem, building);
  std::vector<QuantityPlace> places;
  for (Index plane = 0; plane < std::ssize(problem.buildings[building].model.planes); ++plane) {
    const std::vector<QuantityPlace> storeys = floors_of(problem, building, plane);
    places.insert(places.end(), storeys.begin(), storeys.end());
  }
  return places;
}

PlanContactPlace contact_at(const PlanProblem& problem, Index contact) {
  std::size_t gap = 0;
  for (; contact >= std::ssize(problem.gaps.at(gap).contacts); ++gap) contact -= std::ssize(problem.gaps[gap].contacts);
  const PlanContact& found = problem.gaps[gap].contacts[contact];
  return {gap, &found, problem.gaps[gap].middle(found)};
}

Index first_contact(const PlanProblem& problem, std::size_t gap) {
  Index first = 0;
  for (std::size_t g = 0; g < gap; ++g) first += std::ssize(problem.gaps[g].contacts);
  return first;
}

Index contact_count(const PlanProblem& problem) { return first_contact(problem, problem.gaps.size()); }

std::vector<StretchCorner> merged_corners(const PlanProblem& problem, const PlanGap& gap) {
  const auto is_convex = [&](std::size_t b) { return problem.buildings[b].model.footprint.is_convex(); };
  if (gap.contacts.empty() || !is_convex(gap.left) || !is_convex(gap.right)) return {};
  std::vector<StretchCorner> merged;
  for (const StretchCorner& corner : gap.stretch.corners) {
    const bool is_place = std::any_of(gap.contacts.begin(), gap.contacts.end(), [&](const PlanContact& one) {
      return one.is_of_joint() && one.elevation == gap.contacts.front().elevation && one.along == corner.along;
    });
    if (gap.stretch.includes(corner) && !is_place) merged.push_back(corner);
  }
  return merged;
}

std::vector<const Interface*> contact_interfaces(const PlanProblem& problem, const System& system) {
  const std::vector<Index> places = places_of(problem);
  std::vector<const Interface*> found(static_cast<std::size_t>(contact_count(problem)));
  std::size_t n = 0;
  const auto take = [&](const Interface& at) {
    const Index place = places[n++];
    if (place >= 0) found[static_cast<std::size_t>(place)] = &at;  // none of a seam
  };
  for (const Contact& one : system.contacts) take(one.at);
  for (const RubbingContact& one : system.rubbing) take(one.at);
  return found;
}

std::vector<Index> buildings_beyond(const PlanProblem& problem, std::size_t gap) {
  const PlanGap& joint = problem.gaps.at(gap);
  const Stretch& stretch = joint.stretch;
  const auto along_n = [&](const PlanPoint& at) { return stretch.n.dot(at); };
  const double limit = along_n(stretch.middle(stretch.corners.front().along));
  const auto is_beyond = [&](Index b) {
    const Footprint& footprint = problem.buildings[b].model.footprint;
    return along_n(footprint.corner + footprint.middle()) > limit;
  };
  std::set<Index> found = {joint.right};
  std::vector<Index> ends = {joint.right};
  while (!ends.empty()) {
    const Index from = ends.back();
    ends.pop_back();
    for (const PlanGap& other : problem.gaps) {
      if (other.left != from && other.right != from) continue;
      const Index to = other.left == from ? other.right : other.left;
      if (to != joint.left && is_beyond(to) && found.insert(to).second) ends.push_back(to);
    }
  }
  return {found.begin(), found.end()};
}

std::vector<std::string> gap_names(const PlanProblem& problem) {
  std::vector<std::string> names;
  for (const PlanGap& gap : problem.gaps) names.push_back(gap_name(problem, gap));
  return names;
}

}  // namespace bentur
