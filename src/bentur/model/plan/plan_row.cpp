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

bool has_hinges(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(),
                     [](const PlanModel::Plane& plane) { return plane.hinges.size() > 0; });
}

bool hinges_weaken(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(),
                     [](const PlanModel::Plane& plane) { return !plane.hinges.backbones.empty(); });
}

bool loses_strength(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [](const PlanModel::Plane& plane) {
    return std::any_of(plane.laws.begin(), plane.laws.end(),
                       [](const auto& law) { return law != nullptr && law->loss({}, 0).has_value(); });
  });
}

bool bearings_yield(const PlanBuilding& building) {
  return std::any_of(building.model.bearings.begin(), building.model.bearings.end(),
                     [](const PlanModel::Bearing& bearing) { return bearing.law != nullptr; });
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
    const Index hinges = std::ssize(hinges_of(problem, b)), columns = std::ssize(breaking_columns_of(problem, b));
    const auto count_of = [&](PlanOwner owner) -> Index {
      if (owner == PlanOwner::floor) return floors;
      if (owner == PlanOwner::plane) return planes * floors;
      if (owner == PlanOwner::building) return building.model.soil ? 1 : 0;  // of foundations alone
      if (owner == PlanOwner::bearing) return std::ssize(building.model.bearings);
      if (owner == PlanOwner::hinge) return hinges;
      return owner == PlanOwner::column ? columns : 0;
    };
    for (const PlanQuantity& one : plan_quantities()) {
      if (count_of(one.owner) == 0) continue;
      if (one.when == When::of_what_moves && building.is_rigid()) continue;
      const bool of_edges = one.owner == PlanOwner::floor && one.when == When::where_known;
      if (of_edges && (planes > 0 || building.is_rigid())) continue;
      const bool of_planes = one.owner == PlanOwner::plane;
      const bool of_residuals = one.told.key == "residual_drift_ratio" && has_hinges(building);
      if (of_planes && one.when == When::where_known && !yields(building) && !of_residuals) continue;
      const bool of_yield = one.owner == PlanOwner::bearing && one.when == When::where_known;
      if (of_yield && !bearings_yield(building)) continue;
      const bool weakens = of_planes ? loses_strength(building) : hinges_weaken(building);
      if (one.when == When::where_strength_goes && !weakens) continue;
      RowPart& part = add(one, count_of(one.owner));
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
    if (one.owner == PlanOwner::run) add(one, 1);
  }
  return parts;
}

bool same_places(const PlanProblem& a, const PlanProblem& b) {
  const auto same_hinges = [](const PlanModel::Plane& x, const PlanModel::Plane& y) {
    return x.hinges.places.size() == y.hinges.places.size() && x.hinges.columns.size() == y.hinges.columns.size();
  };
  const auto alike = [&](const PlanBuilding& x, const PlanBuilding& y) {
    return x.model.floors() == y.model.floors() && x.model.planes.size() == y.model.planes.size() &&
           x.is_rigid() == y.is_rigid() && x.model.soil.has_value() == y.model.soil.has_value() &&
           x.model.slab.has_value() == y.model.slab.has_value() && x.model.bearings.size() == y.model.bearings.size() &&
           bearings_yield(x) == bearings_yield(y) && yields(x) == yields(y) && loses_strength(x) == loses_strength(y) &&
           hinges_weaken(x) == hinges_weaken(y) &&
           std::equal(x.model.planes.begin(), x.model.planes.end(), y.model.planes.begin(), same_hinges);
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
    const PlanOwner owner = part.in_plan->owner;
    const Index floors = part.is_of_building() ? run.problem.buildings[part.building].model.floors() : 1;
    if (owner == PlanOwner::hinge || owner == PlanOwner::column || owner == PlanOwner::bearing) {
      const std::vector<PlanPlace> places = owner == PlanOwner::hinge ? hinges_of(run.problem, part.building)
                                            : owner == PlanOwner::column
                                                ? breaking_columns_of(run.problem, part.building)
                                                : bearings_of(run.problem, part.building);
      for (Index i = 0; i < part.count; ++i) row[part.first + i] = part.in_plan->value(run, places[i]);
      continue;
    }
    for (Index i = 0; i < part.count; ++i) {
      const PlanPlace at = part.is_of_building() ? PlanPlace{part.building, i % floors, i / floors} : PlanPlace{i};
      row[part.first + i] = part.in_plan->value(run, at);
    }
  }
}

}  // namespace bentur
