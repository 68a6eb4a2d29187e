#include "bentur/model/plan/plan_row.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Eigen::Index;

bool yields(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [](const PlanModel::Plane& plane) {
    return std::any_of(plane.laws.begin(), plane.laws.end(), [](const auto& law) { return law != nullptr; });
  });
}

bool rubs(const PlanProblem& problem) {
  return std::any_of(problem.gaps.begin(), problem.gaps.end(), [](const PlanGap& gap) {
    return std::any_of(gap.contacts.begin(), gap.contacts.end(),
                       [](const PlanContact& contact) { return contact.rubbing != nullptr; });
  });
}

Index contacts_of(const PlanProblem& problem) {
  Index count = 0;
  for (const PlanGap& gap : problem.gaps) count += std::ssize(gap.contacts);
  return count;
}

}  // namespace

std::vector<RowPart> row_parts(const PlanProblem& problem, const Units& units) {
  using When = PlanQuantity::When;
  std::vector<RowPart> parts;
  const auto add = [&](const PlanQuantity& one, Owner owner, Index count) -> RowPart& {
    parts.push_back({.name = file_name(one.told),
                     .units = udunits(one.told.units, units),
                     .long_name = std::string(one.told.long_name),
                     .owner = owner,
                     .count = count,
                     .first = row_size(parts),
                     .quantity = &one.told,
                     .in_plan = &one});
    return parts.back();
  };
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    const Index floors = building.model.floors(), planes = std::ssize(building.model.planes);
    for (const PlanQuantity& one : plan_quantities()) {
      const bool of_planes = one.owner == PlanOwner::plane;
      if (one.owner != PlanOwner::floor && !of_planes) continue;
      if (one.when == When::of_what_moves && building.is_rigid()) continue;
      if (of_planes && (planes == 0 || (one.when == When::where_known && !yields(building)))) continue;
      RowPart& part = add(one, Owner::floor, of_planes ? planes * floors : floors);
      part.name = fmt::format("{}{}_{}", of_planes ? "plane_" : "", part.name, b + 1);
      part.long_name += fmt::format(", building \"{}\"", building.name);
      part.building = b;
      part.of_planes = of_planes;
    }
  }
  for (const PlanQuantity& one : plan_quantities()) {
    if (one.told.single_run) continue;
    if (one.owner == PlanOwner::point && (one.when != When::where_known || rubs(problem))) {
      add(one, Owner::point, contacts_of(problem));
    }
    if (one.owner == PlanOwner::gap) add(one, Owner::gap, std::ssize(problem.gaps));
  }
  return parts;
}

bool same_places(const PlanProblem& a, const PlanProblem& b) {
  const auto alike = [](const PlanBuilding& x, const PlanBuilding& y) {
    return x.model.floors() == y.model.floors() && x.model.planes.size() == y.model.planes.size() &&
           x.is_rigid() == y.is_rigid() && yields(x) == yields(y);
  };
  const auto same_gap = [](const PlanGap& x, const PlanGap& y) {
    return x.left == y.left && x.right == y.right && x.contacts.size() == y.contacts.size();
  };
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), alike) &&
         std::equal(a.gaps.begin(), a.gaps.end(), b.gaps.begin(), b.gaps.end(), same_gap) && rubs(a) == rubs(b);
}

void fill_row(const std::vector<RowPart>& parts, const PlanRun& run, std::span<double> row) {
  if (row.size() != row_size(parts)) {
    throw InvalidParameter("row", fmt::format("{} values", row.size()), fmt::format("must have {}", row_size(parts)));
  }
  for (const RowPart& part : parts) {
    const Index floors = part.is_of_building() ? run.problem.buildings[part.building].model.floors() : 1;
    for (Index i = 0; i < part.count; ++i) {
      const PlanPlace at = part.is_of_building() ? PlanPlace{part.building, i % floors, i / floors} : PlanPlace{i};
      row[part.first + i] = part.in_plan->value(run, at);
    }
  }
}

}  // namespace bentur
