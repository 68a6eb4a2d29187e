#include <cmath>

#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

std::optional<FrictionPendulum> read_pendulum(const TomlView& view) {
  if (!view.is_table_of({"coefficient", "radius", "yield_displacement"})) return std::nullopt;
  return FrictionPendulum{view.number("coefficient", Rule::positive).value_or(0),
                          view.number("radius", Rule::positive).value_or(0),
                          view.number("yield_displacement", Rule::positive).value_or(0)};
}

Soil::Impedance read_impedance(const TomlView& view, const std::string& key) {
  const auto table = view.get(key);
  if (!table || !table->is_table_of({"stiffness", "damping"})) return {};
  return {table->number("stiffness", Rule::positive).value_or(0),
          table->number("damping", Rule::not_negative, Need::optional).value_or(0)};
}

void read_gravity(const TomlView& view, ReadBuilding& building) {
  const auto loads = view.find("gravity_loads");
  const auto flag = view.flag("p_delta", Need::optional);
  building.spec.p_delta = flag.value_or(false);
  if (!loads) return;
  const Length per_floor = {building.elevations.size(), "one per floor"};
  building.spec.gravity_loads = loads->as_numbers(Rule::not_negative, per_floor);
  if (view.has("p_delta")) view.find("p_delta")->error("and gravity_loads exclude one another: give one of them");
}

void read_isolation(const TomlView& view, ReadBuilding& building) {
  if (!view.is_table_of(
          {"mass", "stiffness", "characteristic_strength", "yield_displacement", "damping", "friction_pendulum"})) {
    return;
  }
  IsolationSpec spec;
  Isolation& bearings = spec.bearings;
  bearings.mass = view.number("mass", Rule::positive).value_or(0);
  bearings.damping = view.number("damping", Rule::not_negative, Need::optional).value_or(0);
  if (const auto pendulum = view.find("friction_pendulum")) {
    spec.pendulum = read_pendulum(*pendulum);
    view.refuse({"stiffness", "characteristic_strength", "yield_displacement"},
                "follows from friction_pendulum and the weight above it");
  } else {
    bearings.stiffness = view.number("stiffness", Rule::positive).value_or(0);
    const auto strength = view.number("characteristic_strength", Rule::not_negative, Need::optional);
    bearings.characteristic_strength = strength.value_or(0);
    if (bearings.characteristic_strength > 0) {
      bearings.yield_displacement = view.number("yield_displacement", Rule::positive).value_or(0);
    } else {
      view.refuse({"yield_displacement"}, "goes with characteristic_strength > 0");
    }
  }
  building.spec.isolation = spec;
}

void read_soil(const TomlView& view, ReadBuilding& building) {
  if (!view.is_table_of({"sway", "rocking", "foundation", "half_space"})) return;
  SoilSpec spec;
  if (const auto half_space = view.find("half_space")) {
    view.refuse({"sway", "rocking"}, "follows from half_space: give one of them");
    if (half_space->is_table_of({"shear_wave_velocity", "density", "poisson", "radius"})) {
      HalfSpace given;
      given.shear_wave_velocity = half_space->number("shear_wave_velocity", Rule::positive).value_or(0);
      given.density = half_space->number("density", Rule::positive).value_or(0);
      given.radius = half_space->number("radius", Rule::positive).value_or(0);
      if (const auto poisson = half_space->get("poisson")) {
        given.poisson = poisson->as_number(Rule::not_negative).value_or(0);
        if (given.poisson > 0.5) poisson->error_value("must be in [0, 0.5]");
      }
      spec.half_space = given;
    }
  } else {
    spec.soil.sway = read_impedance(view, "sway");
    spec.soil.rocking = read_impedance(view, "rocking");
  }
  if (const auto foundation = view.get("foundation"); foundation && foundation->is_table_of({"mass", "inertia"})) {
    spec.soil.mass = foundation->number("mass", Rule::positive).value_or(0);
    spec.soil.inertia = foundation->number("inertia", Rule::positive).value_or(0);
  }
  building.spec.soil = spec;
}

}  // namespace

void read_support(const TomlView& view, double gravity, ReadBuilding& building) {
  building.spec.gravity = gravity;
  read_gravity(view, building);
  const auto isolation = view.find("isolation");
  const auto soil = view.find("soil");
  if (isolation) read_isolation(*isolation, building);
  if (soil) read_soil(*soil, building);
  if (isolation && soil) soil->error("and isolation exclude one another: a slab on bearings stands on firm ground");
}

}  // namespace bentur
