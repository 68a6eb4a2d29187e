#include "bentur/model/plan/struck_in_plan.h"

#include <cmath>
#include <numbers>

#include "bentur/structure/frame/plane_frame.h"

namespace bentur {

using Eigen::Index;

std::vector<FrameAcross> frames_across(const BuildingSpec& building, const Stretch& stretch, int side) {
  std::vector<FrameAcross> found;
  const Plan* const plan = std::get_if<Plan>(&building.structure);
  if (plan == nullptr) return found;
  const PlanPoint outward = side == 0 ? stretch.n : PlanPoint(-stretch.n);
  for (std::size_t p = 0; p < plan->planes.size(); ++p) {
    const PlanPlane& plane = plan->planes[p];
    const double part = plane.direction.dot(outward);
    if (plane.frame == nullptr || std::abs(part) < std::numbers::sqrt2 / 2) continue;
    const auto along = crossing(stretch, side, plan->footprint.corner + plane.through, plane.direction);
    if (along) found.push_back({p, part < 0, *along});
  }
  return found;
}

std::vector<StruckInPlan> struck_columns(const BuildingSpec& building, const Stretch& stretch, int side,
                                         double elevation) {
  constexpr double round_off = 1e-9;  // of the elevation
  std::vector<StruckInPlan> found;
  const std::vector<FrameAcross> across = frames_across(building, stretch, side);
  if (across.empty()) return found;
  const Plan& plan = std::get<Plan>(building.structure);
  Index node = std::ssize(plan.storey_heights) + (plan.isolation ? 1 : 0);
  auto next = across.begin();
  for (std::size_t p = 0; p < plan.planes.size() && next != across.end(); ++p) {
    const PlanPlane& plane = plan.planes[p];
    const bool is_across = next->plane == p;
    for (Index n = 0; n < plane.nodes.count(); ++n, ++node) {
      const double off = building.base_elevation + plane.nodes.elevations[n] - elevation;
      if (!is_across || plane.frame->nodes[n].left != next->left) continue;
      if (std::abs(off) > round_off * (std::abs(elevation) + plan.storey_heights.front())) continue;
      const auto storey = static_cast<std::size_t>(plane.nodes.storeys[n]);
      const Index line = next->left ? 0 : std::ssize(plane.frame->bay_widths);
      found.push_back({.floor_or_node = node,
                       .along = next->along,
                       .mass = plane.nodes.masses[n],
                       .shear_capacity = plane.frame->columns.at(storey).shear_capacity_of(line),
                       .storey = storey});
    }
    if (is_across) ++next;
  }
  return found;
}

}  // namespace bentur
