#include "bentur/model/plan/plan_quantities.h"

namespace bentur {

using Eigen::Index;

std::vector<PlanPlace> floors_of(const PlanProblem& problem, Index building, Index plane) {
  std::vector<PlanPlace> places;
  for (Index f = 0; f < problem.buildings[building].model.floors(); ++f) places.push_back({building, f, plane});
  return places;
}

namespace {

/// Of each frame of a building as many as there are of a list of its hinges.
template <class Item>
std::vector<PlanPlace> of_frames_of(const PlanProblem& problem, Index building, std::vector<Item> Hinges::*list) {
  std::vector<PlanPlace> places;
  const std::vector<PlanModel::Plane>& planes = problem.buildings[building].model.planes;
  for (Index plane = 0; plane < std::ssize(planes); ++plane) {
    const Index count = std::ssize(planes[plane].hinges.*list);
    for (Index i = 0; i < count; ++i) places.push_back({building, i, plane});
  }
  return places;
}

}  // namespace

std::vector<PlanPlace> hinges_of(const PlanProblem& problem, Index building) {
  return of_frames_of(problem, building, &Hinges::places);
}

std::vector<PlanPlace> breaking_columns_of(const PlanProblem& problem, Index building) {
  return of_frames_of(problem, building, &Hinges::columns);
}

std::vector<PlanPlace> planes_from_top(const PlanProblem& problem, Index building) {
  std::vector<PlanPlace> places;
  for (Index plane = 0; plane < std::ssize(problem.buildings[building].model.planes); ++plane) {
    const std::vector<PlanPlace> storeys = floors_of(problem, building, plane);
    places.insert(places.end(), storeys.rbegin(), storeys.rend() - problem.buildings[building].model.first_storey());
  }
  return places;
}

std::vector<PlanPlace> bearings_of(const PlanProblem& problem, Index building) {
  std::vector<PlanPlace> places;
  for (Index n = 0; n < std::ssize(problem.buildings[building].model.bearings); ++n) {
    places.push_back({.item = building, .plane = n});
  }
  return places;
}

PlanContactPlace contact_at(const PlanProblem& problem, Index contact) {
  std::size_t gap = 0;
  for (; contact >= std::ssize(problem.gaps.at(gap).contacts); ++gap) contact -= std::ssize(problem.gaps[gap].contacts);
  const PlanContact& found = problem.gaps[gap].contacts[contact];
  return {gap, &found, problem.gaps[gap].stretch.middle(found.along)};
}

Index first_contact(const PlanProblem& problem, std::size_t gap) {
  Index first = 0;
  for (std::size_t g = 0; g < gap; ++g) first += std::ssize(problem.gaps[g].contacts);
  return first;
}

Index contact_count(const PlanProblem& problem) { return first_contact(problem, problem.gaps.size()); }

}  // namespace bentur
