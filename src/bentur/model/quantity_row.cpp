#include "bentur/model/quantity_row.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {

namespace {

using Eigen::Index;

constexpr Owner of_buildings[] = {Owner::floor,   Owner::plane, Owner::building,
                                  Owner::bearing, Owner::hinge, Owner::column};

bool has_hinges(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(),
                     [](const PlanModel::Plane& plane) { return plane.hinges.size() > 0; });
}

bool yields(const PlanBuilding& building) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [](const PlanModel::Plane& plane) {
    return std::any_of(plane.laws.begin(), plane.laws.end(), [](const auto& law) { return law != nullptr; });
  });
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

bool has_infill(const PlanBuilding& building, bool on_columns) {
  return std::any_of(building.model.planes.begin(), building.model.planes.end(), [&](const PlanModel::Plane& plane) {
    return on_columns ? !struts_on_columns(plane.infills, plane.hinges).empty() : !plane.infills.empty();
  });
}

bool bearings_yield(const PlanBuilding& building) {
  return std::any_of(building.model.bearings.begin(), building.model.bearings.end(),
                     [](const PlanModel::Bearing& bearing) { return bearing.law != nullptr; });
}

bool some_point_has(const Quantity& quantity, const Problem& problem) {
  return std::any_of(problem.points.begin(), problem.points.end(),
                     [&](const ContactPoint& point) { return holds(quantity.source.when, problem, point); });
}

/// Whether a quantity is of a point of a row, or of a contact in plan.
template <class Point>
bool holds_at(When when, bool is_struck, const Point& point) {
  const bool shear = point.column_shear_capacity > 0, moment = point.column_moment_capacity > 0;
  switch (when) {
    case When::struck:
      return is_struck;
    case When::struck_shear:
      return is_struck && shear;
    case When::struck_moment:
      return is_struck && moment;
    case When::struck_capacity:
      return is_struck && (shear || moment);
    default:
      return true;
  }
}

bool holds(When when, const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact) {
  if (when == When::rubs) return contact.rubbing != nullptr;
  return holds_at(when, struck_column(problem, gap, contact).has_value(), contact);
}

bool some_point_has(const Quantity& quantity, const PlanProblem& problem) {
  const When when = quantity.source.when;
  const bool is_of_all = when != When::rubs && holds_at(when, false, PlanContact{});
  return is_of_all || std::any_of(problem.gaps.begin(), problem.gaps.end(), [&](const PlanGap& gap) {
           return std::any_of(gap.contacts.begin(), gap.contacts.end(),
                              [&](const PlanContact& contact) { return holds(when, problem, gap, contact); });
         });
}

/// How many values an owner has that is none of a building.
Index count_of(const Problem& problem, Owner owner) {
  return owner == Owner::point  ? std::ssize(problem.points)
         : owner == Owner::gap  ? std::ssize(problem.buildings) - 1
         : owner == Owner::link ? std::ssize(problem.links)
                                : 1;
}

Index count_of(const PlanProblem& problem, Owner owner) {
  return owner == Owner::point  ? contact_count(problem)
         : owner == Owner::gap  ? std::ssize(problem.gaps)
         : owner == Owner::link ? std::ssize(problem.links)
                                : 1;
}

template <class AnyProblem>
std::vector<RowPart> parts_of(const AnyProblem& problem, const Units& units, bool energy_audit, bool in_plan) {
  std::vector<RowPart> parts;
  const auto add = [&](const Quantity& quantity, Index count) -> RowPart& {
    parts.push_back({.name = file_name(quantity),
                     .units = udunits(quantity.units, units),
                     .long_name = std::string(quantity.long_name),
                     .owner = quantity.owner,
                     .count = count,
                     .first = row_size(parts),
                     .quantity = &quantity});
    return parts.back();
  };
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    for (const Owner owner : of_buildings) {
      const Index count = std::ssize(places_in(problem, owner, b));
      if (count == 0) continue;
      for (const Quantity* const quantity : quantities_of(owner, in_plan)) {
        if (!holds(quantity->source.when, problem.buildings[b])) continue;
        RowPart& part = add(*quantity, count);
        part.name += fmt::format("_{}", b + 1);
        part.long_name += fmt::format(", building \"{}\"", problem.buildings[b].name);
        part.building = b;
      }
    }
  }
  for (const Owner owner : {Owner::point, Owner::gap, Owner::link, Owner::run}) {
    for (const Quantity* const quantity : quantities_of(owner, in_plan)) {
      if (quantity->single_run || (quantity->audit_only && !energy_audit)) continue;
      if (owner == Owner::point && !some_point_has(*quantity, problem)) continue;
      add(*quantity, count_of(problem, owner));
    }
  }
  return parts;
}

/// @throws InvalidParameter unless the row is as long as these parts need.
template <class Run>
void fill(const std::vector<RowPart>& parts, const Run& run, std::span<double> row) {
  if (row.size() != row_size(parts)) {
    throw InvalidParameter("row", fmt::format("{} values", row.size()), fmt::format("must have {}", row_size(parts)));
  }
  std::vector<QuantityPlace> places;
  const RowPart* of = nullptr;  // whose places these are, and those of the parts that follow it
  for (const RowPart& part : parts) {
    if (part.is_of_building() && (of == nullptr || of->owner != part.owner || of->building != part.building)) {
      places = places_in(run.problem, part.owner, part.building);
      of = &part;
    }
    for (Index i = 0; i < part.count; ++i) {
      row[part.first + i] = value_of(*part.quantity, run, part.is_of_building() ? places[i] : QuantityPlace{i});
    }
  }
}

}  // namespace

bool holds(When when, const Building& building) {
  const StructuralModel& model = building.model;
  switch (when) {
    case When::moves:
      return !building.is_rigid();
    case When::yields:
      return building.storeys_yield();
    case When::yields_or_turns:
      return building.storeys_yield() || model.hinges.size() > 0;
    case When::loses_strength:
      return building.can_lose_strength();
    case When::infill:
      return !model.infills.empty();
    case When::infill_columns:
      return !struts_on_columns(model.infills, model.hinges).empty();
    case When::soil:
      return model.foundation.has_value();
    case When::hinges:
      return !model.hinges.places.empty();
    case When::weakening_hinges:
      return !model.hinges.backbones.empty();
    case When::breaking_columns:
      return !model.hinges.columns.empty();
    default:
      return true;
  }
}

bool holds(When when, const PlanBuilding& building) {
  switch (when) {
    case When::moves:
      return !building.is_rigid();
    case When::edges:
      return building.model.planes.empty() && !building.is_rigid();
    case When::yields:
      return yields(building);
    case When::yields_or_turns:
      return yields(building) || has_hinges(building);
    case When::loses_strength:
      return loses_strength(building);
    case When::soil:
      return building.model.soil.has_value();
    case When::hinges:
    case When::breaking_columns:
      return has_hinges(building);
    case When::weakening_hinges:
      return hinges_weaken(building);
    case When::infill:
    case When::infill_columns:
      return has_infill(building, when == When::infill_columns);
    case When::bearings_yield:
      return bearings_yield(building);
    default:
      return true;
  }
}

bool holds(When when, const Problem& problem, const ContactPoint& point) {
  return holds_at(when, struck_column(problem, point).has_value(), point);
}

std::vector<RowPart> row_parts(const Problem& problem, const Units& units, bool energy_audit) {
  return parts_of(problem, units, energy_audit, false);
}

std::vector<RowPart> row_parts(const PlanProblem& problem, const Units& units, bool energy_audit) {
  return parts_of(problem, units, energy_audit, true);
}

std::size_t row_size(const std::vector<RowPart>& parts) {
  return parts.empty() ? 0 : parts.back().first + parts.back().count;
}

bool same_places(const Problem& a, const Problem& b) {
  const auto floors = [](const Building& x, const Building& y) {
    return x.model.floors() == y.model.floors() && x.storeys_yield() == y.storeys_yield() &&
           x.model.foundation.has_value() == y.model.foundation.has_value() &&
           x.model.hinges.places.size() == y.model.hinges.places.size() &&
           x.model.hinges.columns.size() == y.model.hinges.columns.size() &&
           x.model.infills.empty() == y.model.infills.empty() &&
           struts_on_columns(x.model.infills, x.model.hinges).empty() ==
               struts_on_columns(y.model.infills, y.model.hinges).empty();
  };
  const auto left = [&](const ContactPoint& x, const ContactPoint& y) {
    return x.left == y.left && struck_column(a, x).has_value() == struck_column(b, y).has_value();
  };
  const auto sides = [](const Link& x, const Link& y) { return x.left == y.left && x.right == y.right; };
  const auto columns = [&](const Quantity& quantity) {
    return some_point_has(quantity, a) == some_point_has(quantity, b);
  };
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), floors) &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), left) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), sides) &&
         std::all_of(quantities().begin(), quantities().end(), columns);
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
  const bool have_alike = std::all_of(quantities().begin(), quantities().end(), [&](const Quantity& quantity) {
    return quantity.owner != Owner::point || some_point_has(quantity, a) == some_point_has(quantity, b);
  });
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), alike) &&
         std::equal(a.gaps.begin(), a.gaps.end(), b.gaps.begin(), b.gaps.end(), same_gap) && have_alike &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), same_link);
}

void fill_row(const std::vector<RowPart>& parts, const RunView& run, std::span<double> row) { fill(parts, run, row); }

void fill_row(const std::vector<RowPart>& parts, const PlanRun& run, std::span<double> row) { fill(parts, run, row); }

}  // namespace bentur
