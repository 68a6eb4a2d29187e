#include "bentur/model/plan/plan_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "bentur/pounding/plan/outline/near.h"

namespace bentur {
namespace {

using Eigen::Index;

/// Whether they meet along every direction in which they are apart.
bool could_meet(const PlanRun& run, Index left, Index right, const Stretch& joint) {
  const auto reaches = [&](const PlanPoint& n, double width) {
    return reach_of(run.response.buildings[left], n) + reach_of(run.response.buildings[right], n) >= width;
  };
  if (!reaches(joint.n, joint.width)) return false;
  const std::vector<FamilyBeside> apart = families_beside(run.problem.buildings[left].model.footprint,
                                                          run.problem.buildings[right].model.footprint, joint, 0);
  return std::all_of(apart.begin(), apart.end(), [&](const FamilyBeside& one) {
    return reaches(one.places.front().normal, joint.width + one.places.front().beyond);
  });
}

}  // namespace

double reach_of(const PlanPeaks& peaks, const PlanPoint& direction) {
  return std::abs(direction.x()) * std::max(peaks.south.maxCoeff(), peaks.north.maxCoeff()) +
         std::abs(direction.y()) * std::max(peaks.west.maxCoeff(), peaks.east.maxCoeff());
}

std::vector<PairWithoutContact> pairs_without_contact(const PlanRun& run) {
  const std::vector<PlanBuilding>& buildings = run.problem.buildings;
  std::set<std::pair<Index, Index>> modelled;
  for (const PlanGap& gap : run.problem.gaps) modelled.insert(std::minmax({gap.left, gap.right}));
  std::vector<Footprint> footprints;
  double furthest = 0;  // of a building, in any direction
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    footprints.push_back(buildings[b].model.footprint);
    furthest = std::max(furthest, reach_of(run.response.buildings[b], {1, 1}));
  }
  std::vector<PairWithoutContact> found;
  for (const auto& [first, second] : pairs_near(footprints, 2 * furthest)) {
    const auto a = static_cast<Index>(first), b = static_cast<Index>(second);
    if (modelled.contains({a, b}) || (buildings[a].is_rigid() && buildings[b].is_rigid())) continue;
    const auto joint = joint_between(footprints[first], footprints[second]);
    if (!joint || !(joint->swapped ? could_meet(run, b, a, *joint) : could_meet(run, a, b, *joint))) continue;
    found.push_back({a, b, joint->width,
                     reach_of(run.response.buildings[a], joint->n) + reach_of(run.response.buildings[b], joint->n)});
  }
  return found;
}

}  // namespace bentur
