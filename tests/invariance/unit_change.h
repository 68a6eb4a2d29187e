#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

#include "tests/invariance/transforms.h"

// A case in other units, and the way back from its response.

namespace bentur::test {

/// `length` new units of length in an old one, `force` new units of force in an old one.
struct UnitChange {
  double length = 1, force = 1;
};

/// Of structures, their supports and links.
struct InUnits {
  UnitChange units;
  double mass = units.force / units.length, stiffness = units.force / units.length;
  double area = units.length * units.length;

  void member(Section& section) const {
    section.area *= area;
    section.inertia *= area * area;
    section.mass *= mass;
    section.line_mass *= mass / units.length;
  }
  void operator()(PlaneFrame& frame) const {
    frame.elastic_modulus *= units.force / area;
    scale(frame.storey_heights, units.length);
    scale(frame.bay_widths, units.length);
    for (Section& column : frame.columns) member(column);
    for (Section& beam : frame.beams) member(beam);
    scale(frame.floor_masses, mass);
  }
  void operator()(Stick& stick) const {
    scale(stick.storey_heights, units.length);
    scale(stick.masses, mass);
    scale(stick.stiffnesses, stiffness);
    scale(stick.yield_forces, units.force);
  }
  void operator()(MatricesSpec& matrices) const {
    scale(matrices.elevations, units.length);
    matrices.mass *= mass;
    matrices.stiffness *= stiffness;
  }
  void operator()(RigidSpec& rigid) const { scale(rigid.elevations, units.length); }
  void operator()(ModalBuilding& modal) const {
    scale(modal.elevations, units.length);
    scale(modal.masses, mass);
  }
  void operator()(DisplacementsSpec& given) const {
    scale(given.elevations, units.length);
    scale(given.displacements, units.length);
  }
  // Random plans have units of their own (plan/random_plans_test.cpp).
  void operator()(Plan& /*plan*/) const { throw std::logic_error("rows alone"); }
  void operator()(PlanWall& /*wall*/) const { throw std::logic_error("rows alone"); }
  void operator()(GenericBuilding& generic) const {
    scale(generic.storey_heights, units.length);
    scale(generic.floor_masses, mass);
  }
  void operator()(IsolationSpec& isolation) const {
    isolation.mass *= mass;
    isolation.damping *= stiffness;
    for (const Key& key : find_entry(bearing_laws(), isolation.law)->keys) {
      if (isolation.numbers.contains(key.name)) {
        isolation.numbers.find(key.name)->second *= key.dimension.factor(units.length, units.force);
      }
    }
  }
  void operator()(SoilSpec& spec) const {
    Soil& soil = spec.soil;
    for (double* x : {&soil.sway.stiffness, &soil.sway.damping}) *x *= stiffness;
    for (double* x : {&soil.rocking.stiffness, &soil.rocking.damping}) *x *= units.force * units.length;
    soil.mass *= mass;
    soil.inertia *= mass * area;
  }
  void operator()(LinkSpec& link) const {
    scale(link.elevations, units.length);
    for (auto& [key, values] : link.numbers) {
      scale(values, key == "slack" ? units.length : key == "yield_force" ? units.force : stiffness);
    }
  }
};

inline Case in_units(Case c, const UnitChange& units) {
  const InUnits changed{units};
  const double stiffness = changed.stiffness;
  for (BuildingSpec& building : c.buildings) {
    std::visit(changed, building.structure);
    if (building.isolation) changed(*building.isolation);
    if (building.soil) changed(*building.soil);
    building.gravity *= units.length;
    scale(building.gravity_loads, units.force);
    if (auto* damping = std::get_if<MatrixDamping>(&building.damping)) damping->matrix *= stiffness;
  }
  for (LinkSpec& link : c.links) changed(link);
  for (GapSpec& gap : c.gaps) {
    scale(gap.widths, units.length);
    scale(gap.elevations, units.length);
    for (const Key& key : find_law(gap.contact.law)->keys) {
      const auto found = gap.contact.numbers.find(key.name);
      if (found != gap.contact.numbers.end()) scale(found->second, key.dimension.factor(units.length, units.force));
    }
  }
  c.excitation.motion = scaled(c.excitation.motion, units.length);
  for (auto* initial : {&c.initial.displacements, &c.initial.velocities}) {
    for (auto& values : *initial) scale(values, units.length);
  }
  return c;
}

inline Response in_units_back(Response response, const UnitChange& units) {
  for (BuildingPeaks& peaks : response.buildings) {
    peaks.displacement /= units.length;
    peaks.displacement_no_contact /= units.length;
    peaks.acceleration /= units.length;
    peaks.storey_shear /= units.force;
  }
  for (PointSummary& point : response.points) point.gap_needed /= units.length;
  for (WatchedSummary& floor : response.watched) {
    floor.gap_needed /= units.length;
    floor.least_opening /= units.length;
  }
  for (Impact& impact : response.impacts) {
    for (double* x : {&impact.closing_speed, &impact.separation_speed, &impact.peak_penetration}) *x /= units.length;
    for (double* x : {&impact.peak_force, &impact.peak_tension, &impact.impulse}) *x /= units.force;
    impact.energy_lost /= units.length * units.force;
  }
  return response;
}

}  // namespace bentur::test
