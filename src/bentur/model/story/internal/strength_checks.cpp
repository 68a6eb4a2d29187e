#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bentur/model/story/internal/remark_checks.h"

namespace bentur::remarking {
namespace {

using Eigen::Index;

/// What a building weighs [force], and its mean storey height [length].
struct Size {
  double weight = 0, height = 0;
};

template <class AnyBuilding>
Size size_of(const AnyBuilding& building, const List& list) {
  const auto& model = building.model;
  const auto heights = model.storey_heights.begin() + model.first_storey();
  return {list.units().gravity * std::accumulate(model.floor_masses.begin(), model.floor_masses.end(), 0.0),
          std::accumulate(heights, model.storey_heights.end(), 0.0) /
              static_cast<double>(model.storey_heights.end() - heights)};
}

/// Of a storey or bearings. @param is_slab whose law is that of bearings
void check_law(const std::string& name, const HystereticLaw& law, bool is_slab, const Size& size, List& list) {
  list.check("yield_strength", name, law.initial_stiffness() * law.yield_deformation() / size.weight);
  if (is_slab) list.check(bearing_yield, name + ", yield_displacement", law.yield_deformation());
}

void check_hinges(const std::string& name, const Hinges& hinges, const Size& size, List& list) {
  const Index ends = std::ssize(hinges.places);
  for (Index h = 0; h < hinges.size(); ++h) {
    for (const double capacity : {hinges.clockwise(h), hinges.anticlockwise(h)}) {
      if (!std::isfinite(capacity)) continue;
      if (h < ends) {
        list.check("moment_capacity", name, capacity / (size.weight * size.height));
      } else {
        list.check("shear_capacity", name, capacity / size.weight);
      }
    }
  }
  for (const double limit : hinges.rotation_limits.reshaped()) {
    if (!std::isnan(limit)) list.check("rotation_limit", name, limit);
  }
}

/// By the stiffness that is left where they yield. @param stiffness of all bearings [force/length]
void check_bearings(const std::string& name, double stiffness, const Size& size, List& list) {
  const double mass = size.weight / list.units().gravity;
  if (stiffness > 0) list.check("bearing_period", name, 2 * std::numbers::pi * std::sqrt(mass / stiffness));
}

void check_laws(const BuildingSpec* spec, const Building& building, List& list) {
  const Size size = size_of(building, list);
  const StructuralModel& model = building.model;
  for (const BuildingElement& one : building.elements) {
    if (!one.infill) check_law(building.name, *one.law, model.slab == one.storey, size, list);
  }
  check_hinges(building.name, model.hinges, size, list);
  if (spec != nullptr && spec->isolation)
    check_bearings(building.name, bearings_of(*spec->isolation, size.weight).stiffness, size, list);
}

void check_laws(const BuildingSpec* spec, const PlanBuilding& building, List& list) {
  const Size size = size_of(building, list);
  for (const PlanModel::Plane& plane : building.model.planes) {
    for (const auto& law : plane.laws) {
      if (law) check_law(building.name, *law, false, size, list);
    }
    check_hinges(building.name, plane.hinges, size, list);
  }
  const auto* const plan = spec != nullptr ? std::get_if<Plan>(&spec->structure) : nullptr;
  if (plan == nullptr || !plan->isolation) return;
  double stiffness = 0;
  for (const PlanBearing& one : plan->isolation->bearings) {
    stiffness += one.bearing.stiffness;
    if (one.bearing.law) check_law(building.name, *one.bearing.law, true, size, list);
  }
  check_bearings(building.name, stiffness, size, list);
}

/// What is given of the column that is struck at a contact of a row or in plan.
template <class AnyBuilding, class Contact>
void check_column(const AnyBuilding& building, const Contact& at, List& list) {
  const double shear = at.column_shear_capacity, moment = at.column_moment_capacity;  // 0: nothing is given
  if (!(shear > 0) && !(moment > 0)) return;
  const Size size = size_of(building, list);
  if (shear > 0) list.check("shear_capacity", building.name, shear / size.weight);
  if (moment > 0) list.check("moment_capacity", building.name, moment / (size.weight * size.height));
}

const Link& link_of(const Link& link) { return link; }
const Link& link_of(const PlanLink& link) { return link.link; }

/// Dashpots between two buildings, over what would be critical of the one that they damp more.
template <class AnyProblem>
void check_links(const AnyProblem& problem, List& list) {
  for (const auto& one : problem.links) {
    const Link& link = link_of(one);
    double damping = 0, least = std::numeric_limits<double>::infinity();
    for (const auto& [key, value] : link.law->parameters()) damping += key == "damping" ? value : 0;
    std::string name;
    for (const Index b : {link.left, link.right}) {
      const auto& building = problem.buildings[static_cast<std::size_t>(b)];
      if (!(building.first_omega() > 0)) continue;
      const double critical = 2 * size_of(building, list).weight / list.units().gravity * building.first_omega();
      if (critical < least) least = critical, name = building.name;
    }
    if (damping > 0 && std::isfinite(least)) list.check("link_damping", name, damping / least);
  }
}

template <class AnyProblem>
void check_all(const Case& c, const AnyProblem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    check_laws(b < c.buildings.size() ? &c.buildings[b] : nullptr, building, list);
  }
  check_links(problem, list);
}

}  // namespace

void check_strengths(const Case& c, const Problem& problem, List& list) {
  check_all(c, problem, list);
  for (const ContactPoint& point : problem.points) {
    if (const auto struck = struck_column(problem, point))
      check_column(problem.buildings[struck->building], point, list);
  }
}

void check_strengths(const Case& c, const PlanProblem& problem, List& list) {
  check_all(c, problem, list);
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) {
      const auto struck = struck_column(problem, gap, contact);
      if (struck) check_column(problem.buildings[struck->building], contact, list);
    }
  }
}

}  // namespace bentur::remarking
