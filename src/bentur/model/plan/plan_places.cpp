#include "bentur/model/plan/plan_places.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

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

namespace {

/// An edge of an outline: how far along a direction its ends are, and how far across it, ascending [length].
struct Edge {
  double across[2], along[2];
  [[nodiscard]] double along_at(double at) const {
    return along[0] + (at - across[0]) / (across[1] - across[0]) * (along[1] - along[0]);
  }
};

/// The edges of an outline that look along a direction (side 1) or against it (-1); those that lie along it, nowhere.
std::vector<Edge> edges_of(const Footprint& footprint, const PlanPoint& n, int side) {
  std::vector<Edge> edges;
  const double tiny = 1e-9 * footprint.size.maxCoeff();
  for (const std::vector<PlanPoint>& ring : footprint.all_rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double across_a = n.x() * a.y() - n.y() * a.x(), across_b = n.x() * b.y() - n.y() * b.x();
      if (side * (across_b - across_a) <= tiny) continue;  // what is solid is to the left of a ring
      const bool ascends = across_b > across_a;
      const PlanPoint &low = ascends ? a : b, &high = ascends ? b : a;
      edges.push_back({{std::min(across_a, across_b), std::max(across_a, across_b)}, {n.dot(low), n.dot(high)}});
    }
  }
  return edges;
}

/// The same of all buildings.
std::vector<std::vector<Edge>> all_edges(const PlanProblem& problem, const PlanPoint& n, int side) {
  std::vector<std::vector<Edge>> all;
  for (const PlanBuilding& building : problem.buildings) all.push_back(edges_of(building.model.footprint, n, side));
  return all;
}

/// How far the one goes along a direction until it meets the other [length]; nothing: it does not.
/// @param front of the one, the edges that look along it @param back of the other, those that look against it
std::optional<double> way_to(const std::vector<Edge>& front, const std::vector<Edge>& back) {
  std::optional<double> least;
  for (const Edge& mine : front) {
    for (const Edge& other : back) {
      const double low = std::max(mine.across[0], other.across[0]), high = std::min(mine.across[1], other.across[1]);
      const double tiny = 1e-9 * (other.across[1] - other.across[0]);
      if (high - low <= tiny) continue;  // they pass
      const double way = std::min(other.along_at(low) - mine.along_at(low), other.along_at(high) - mine.along_at(high));
      if (way >= -tiny && (!least || way < *least)) least = std::max(0.0, way);
    }
  }
  return least;
}

}  // namespace

std::vector<Index> buildings_beyond(const PlanProblem& problem, std::size_t gap) {
  const PlanGap& joint = problem.gaps.at(gap);
  const Stretch& stretch = joint.stretch;
  const auto along_n = [&](const PlanPoint& at) { return stretch.n.dot(at); };
  const double limit = along_n(stretch.middle(stretch.corners.front().along));
  const std::vector<std::vector<Edge>> fronts = all_edges(problem, stretch.n, 1);
  const std::vector<std::vector<Edge>> backs = all_edges(problem, stretch.n, -1);
  std::set<Index> found = {joint.right};
  std::vector<Index> ends = {joint.right};
  const auto go_on_to = [&](Index to) {
    const Footprint& footprint = problem.buildings[to].model.footprint;
    const bool is_beyond = along_n(footprint.corner + footprint.middle()) > limit;
    if (to != joint.left && is_beyond && found.insert(to).second) ends.push_back(to);
  };
  while (!ends.empty()) {
    const Index from = ends.back();
    ends.pop_back();
    for (const PlanGap& other : problem.gaps) {
      if (other.left == from) go_on_to(other.right);
      if (other.right == from) go_on_to(other.left);
    }
    for (Index to = 0; to < std::ssize(problem.buildings); ++to) {
      if (found.count(to) == 0 && way_to(fronts[from], backs[to])) go_on_to(to);
    }
  }
  return {found.begin(), found.end()};
}

std::optional<InTheWay> first_in_the_way(const PlanProblem& problem, std::size_t gap,
                                         const std::vector<Index>& movers) {
  const PlanPoint& n = problem.gaps.at(gap).stretch.n;
  const std::vector<std::vector<Edge>> fronts = all_edges(problem, n, 1), backs = all_edges(problem, n, -1);
  std::optional<InTheWay> first;
  for (Index to = 0; to < std::ssize(problem.buildings); ++to) {
    if (std::find(movers.begin(), movers.end(), to) != movers.end()) continue;
    for (const Index mover : movers) {
      const std::optional<double> way = way_to(fronts[mover], backs[to]);
      if (way && !(first && first->way <= *way)) first = InTheWay{to, *way};
    }
  }
  return first;
}

std::vector<std::string> gap_names(const PlanProblem& problem) {
  std::vector<std::string> names;
  for (const PlanGap& gap : problem.gaps) names.push_back(gap_name(problem, gap));
  return names;
}

}  // namespace bentur
