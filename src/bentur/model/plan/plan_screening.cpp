#include "bentur/model/plan/plan_screening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bentur {
namespace {

using Eigen::Index;

constexpr double in_percent = 100;

/// Out of one of the two buildings of a gap, towards the other.
PlanPoint outward(const PlanGap& gap, Index building) {
  return building == gap.left ? gap.stretch.n : PlanPoint(-gap.stretch.n);
}

bool is_backed(const PlanProblem& problem, std::size_t gap, Index building) {
  const PlanPoint out = outward(problem.gaps[gap], building);
  const double half_right_angle = std::sqrt(0.5);
  return std::any_of(problem.gaps.begin(), problem.gaps.end(), [&](const PlanGap& one) {
    if (one.left != building && one.right != building) return false;
    const Index other = one.left == building ? one.right : one.left;
    return !problem.buildings[other].is_rigid() && outward(one, building).dot(out) < -half_right_angle;
  });
}

/// The largest distance between a floor's centre of mass and the centre of rigidity of the storey below, along x or y
/// over what the footprint takes up there [%]. Nothing of one known by its modes.
std::optional<double> largest_eccentricity(const PlanModel& model, const Plan& plan) {
  if (plan.modes) return std::nullopt;
  double most = 0;
  const Index first = model.first_storey();  // above a slab
  for (Index floor = first; floor < model.floors(); ++floor) {
    const PlanPoint apart = model.centres[static_cast<std::size_t>(floor)] - centre_of_rigidity(plan, floor - first);
    most = std::max(most, in_percent * apart.cwiseAbs().cwiseQuotient(plan.footprint.size).maxCoeff());
  }
  return most;
}

StandingBuilding standing(const PlanModel& model, const Plan& plan, bool is_backed) {
  return {.floors = model.elevations,
          .height = std::accumulate(model.storey_heights.begin(), model.storey_heights.end(), 0.0),
          .mass = std::accumulate(model.floor_masses.begin(), model.floor_masses.end(), 0.0),
          .is_backed = is_backed,
          .eccentricity = largest_eccentricity(model, plan)};
}

double narrowest(const PlanGap& gap) {
  double width = std::numeric_limits<double>::infinity();
  for (const PlanContact& one : gap.contacts) {
    if (gap.is_of_pair(one)) width = std::min(width, gap.width_at(one));
  }
  for (const PlanWatched& one : gap.watched) width = std::min(width, gap.width_at(one));
  return width;
}

}  // namespace

std::vector<ScreeningFinding> plan_screening(const Case& c, const PlanProblem& problem, std::size_t gap) {
  const PlanGap& of = problem.gaps.at(gap);
  const auto plan_of = [&](Index b) {
    return b < std::ssize(c.buildings) ? std::get_if<Plan>(&c.buildings[static_cast<std::size_t>(b)].structure)
                                       : nullptr;
  };
  const Plan *const left = plan_of(of.left), *const right = plan_of(of.right);
  if (left == nullptr || right == nullptr || left->masses.empty() || right->masses.empty()) return {};
  return screening(standing(problem.buildings[of.left].model, *left, is_backed(problem, gap, of.left)),
                   standing(problem.buildings[of.right].model, *right, is_backed(problem, gap, of.right)),
                   narrowest(of), c.screening, c.units);
}

}  // namespace bentur
