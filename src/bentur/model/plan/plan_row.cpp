#include "bentur/model/plan/plan_row.h"

#include <algorithm>

namespace bentur {
namespace {

using Eigen::Index;

bool yields(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [](const PlanModel::Plane& plane) {
    return std::any_of(plane.laws.begin(), plane.laws.end(), [](const auto& law) { return law != nullptr; });
  });
}

bool loses_strength(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [](const PlanModel::Plane& plane) {
    return std::any_of(plane.laws.begin(), plane.laws.end(),
                       [](const auto& law) { return law != nullptr && law->loss({}, 0).has_value(); });
  });
}

bool rubs(const PlanProblem& problem) {
  return std::any_of(problem.gaps.begin(), problem.gaps.end(), [](const PlanGap& gap) {
    return std::any_of(gap.contacts.begin(), gap.contacts.end(),
                       [](const PlanContact& contact) { return contact.rubbing != nullptr; });
  });
}

}  // namespace

std::vector<RowPart> row_parts(const PlanProblem& problem, const Units& units) {
  using When = PlanQuantity::When;
  std::vector<RowPart> parts;
  const auto add = [&](const PlanQuantity& one, Index count) -> RowPart& {
    RowPart& part = add_part(parts, one.told, count, units);
    part.in_plan = &one;
    return part;
  };
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    const Index floors = building.model.floors(), planes = std::ssize(building.model.planes);
    for (const PlanQuantity& one : plan_quantities()) {
      const bool of_planes = one.owner == PlanOwner::plane, of_all = one.owner == PlanOwner::building;
      if (one.owner != PlanOwner::floor && !of_planes && !of_all) continue;
      if (of_all && !building.model.soil) continue;  // foundations alone are told of as one
      if (one.when == When::of_what_moves && building.is_rigid()) continue;
      if (of_planes && (planes == 0 || (one.when == When::where_known && !yields(building)))) continue;
      if (one.when == When::where_strength_goes && !loses_strength(building)) continue;
      RowPart& part = add(one, of_all ? 1 : of_planes ? planes * floors : floors);
      if (of_planes) part.name = "plane_" + part.name;
      part.of_planes = of_planes;
      name_building(part, b, building.name);
    }
  }
  for (const PlanQuantity& one : plan_quantities()) {
    if (one.told.single_run) continue;
    if (one.owner == PlanOwner::point && (one.when != When::where_known || rubs(problem))) {
      add(one, contact_count(problem));
    }
    if (one.owner == PlanOwner::gap) add(one, std::ssize(problem.gaps));
    if (one.owner == PlanOwner::link) add(one, std::ssize(problem.links));
  }
  return parts;
}

bool same_places(const PlanProblem& a, const PlanProblem& b) {
  const auto alike = [](const PlanBuilding& x, const PlanBuilding& y) {
    return x.model.floors() == y.model.floors() && x.model.planes.size() == y.model.planes.size() &&
           x.is_rigid() == y.is_rigid() && x.model.soil.has_value() == y.model.soil.has_value() &&
           yields(x) == yields(y) && loses_strength(x) == loses_strength(y);
  };
  const auto same_gap = [](const PlanGap& x, const PlanGap& y) {
    return x.left == y.left && x.right == y.right && x.contacts.size() == y.contacts.size();
  };
  const auto same_link = [](const PlanLink& x, const PlanLink& y) {
    return x.link.left == y.link.left && x.link.right == y.link.right && x.direction == y.direction;
  };
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), alike) &&
         std::equal(a.gaps.begin(), a.gaps.end(), b.gaps.begin(), b.gaps.end(), same_gap) && rubs(a) == rubs(b) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), same_link);
}

void fill_row(const std::vector<RowPart>& parts, const PlanRun& run, std::span<double> row) {
  require_size(parts, row);
  for (const RowPart& part : parts) {
    const Index floors = part.is_of_building() ? run.problem.buildings[part.building].model.floors() : 1;
    for (Index i = 0; i < part.count; ++i) {
      const PlanPlace at = part.is_of_building() ? PlanPlace{part.building, i % floors, i / floors} : PlanPlace{i};
      row[part.first + i] = part.in_plan->value(run, at);
    }
  }
}

}  // namespace bentur
