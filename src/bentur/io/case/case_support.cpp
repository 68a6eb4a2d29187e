#include <fmt/format.h>

#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/structure/plan/plan_support.h"

namespace bentur {
namespace {

Impedance read_impedance(const TableView& view, const std::string& key) {
  if (!view.has(key)) view.error_missing(key);
  const auto table = view.table(key);
  if (!table) return {};
  return {table->number("stiffness").value_or(0), table->number("damping").value_or(0)};
}

/// Numbers of a law of bearings, from the table that they stand in.
ReadBearings read_bearings(const TableView& view, const LawEntryOf<Bearings>& law) {
  ReadBearings read{.law = &law, .numbers = {}, .is_whole = true};
  for (const Key& key : law.keys) {
    const std::string name(key.name);
    if (key.is_required() && !view.key(name).is_required() && !view.has(name)) view.error_missing(name);
    if (const auto number = view.number(key.name)) read.numbers.emplace(name, *number);
    read.is_whole = read.is_whole && (!key.is_required() || read.numbers.contains(name));
  }
  return read;
}

void read_isolation(const TomlView& given, ReadBuilding& building) {
  const auto table = TableView::of(given, isolation_keys());
  if (!table) return;
  const TableView& view = *table;
  IsolationSpec spec;
  spec.mass = view.number("mass").value_or(0);
  spec.damping = view.number("damping").value_or(0);
  view.refuse({"bearing", "centre", "inertia"}, "goes with plan, which is not given");
  ReadBearings read = read_bearings(view);
  spec.law = read.law->name;
  spec.numbers = std::move(read.numbers);
  building.spec.isolation = spec;
}

std::optional<HalfSpace> read_half_space(const TableView& view) {
  const auto half_space = view.table("half_space");
  if (!half_space) return std::nullopt;
  return HalfSpace{.shear_wave_velocity = half_space->number("shear_wave_velocity").value_or(0),
                   .density = half_space->number("density").value_or(0),
                   .poisson = half_space->number("poisson").value_or(0),
                   .radius = half_space->number("radius").value_or(0)};
}

void read_soil(const TomlView& given_soil, ReadBuilding& building) {
  const auto table = TableView::of(given_soil, soil_keys());
  if (!table) return;
  const TableView& view = *table;
  view.refuse({"sway_y", "rocking_y", "twist"}, "goes with plan, which is not given");
  SoilSpec spec;
  if (view.has("half_space")) {
    view.refuse({"sway", "rocking"}, "follows from half_space: give one of them");
    spec.half_space = read_half_space(view);
  } else {
    spec.soil.sway = read_impedance(view, "sway");
    spec.soil.rocking = read_impedance(view, "rocking");
  }
  if (const auto foundation = view.table("foundation")) {
    foundation->refuse({"inertia_y", "twist_inertia"}, "goes with plan, which is not given");
    spec.soil.mass = foundation->number("mass").value_or(0);
    spec.soil.inertia = foundation->number("inertia").value_or(0);
  }
  building.spec.soil = spec;
}

}  // namespace

ReadBearings read_bearings(const TableView& view) {
  const auto& own = bearing_laws().front();
  const auto other = view.exactly_one("law");
  if (!other) {
    ReadBearings read = read_bearings(view, own);
    const bool yields = read.numbers["characteristic_strength"] > 0;
    if (yields && !view.has("yield_displacement")) view.error_missing("yield_displacement");
    if (!yields) view.refuse({"yield_displacement"}, "goes with characteristic_strength > 0");
    read.is_whole = read.is_whole && (!yields || read.numbers.contains("yield_displacement"));
    return read;
  }
  ReadBearings read{.law = find_entry(bearing_laws(), *other), .numbers = {}};
  if (const auto numbers = view.table(*other)) read = read_bearings(*numbers, *read.law);
  for (const Key& key : own.keys) {
    view.refuse({std::string(key.name)}, fmt::format("follows from {} and the weight above it", *other));
  }
  return read;
}

std::optional<PlanSoil> read_soil_in_plan(const TomlView& given, const Footprint& footprint) {
  const auto table = TableView::of(given, soil_keys());
  if (!table) return std::nullopt;
  const TableView& view = *table;
  PlanSoil soil;
  if (const auto foundation = view.table("foundation")) {
    soil.mass = foundation->number("mass").value_or(0);
    soil.inertia_x = foundation->number("inertia").value_or(0);
    soil.inertia_y = foundation->number("inertia_y").value_or(soil.inertia_x);
    soil.twist_inertia = foundation->number("twist_inertia").value_or(soil.mass * footprint.radius2());
    const auto twist = view.find("twist");
    if (twist && !twist->is(TomlValue::Kind::table)) {
      foundation->refuse({"twist_inertia"}, "goes with a twist that is not rigid");
    }
  }
  if (view.has("half_space")) {
    view.refuse({"sway", "rocking", "sway_y", "rocking_y", "twist"}, "follows from half_space: give one of them");
    const auto half_space = read_half_space(view);
    const bool is_whole = half_space && half_space->shear_wave_velocity > 0 && half_space->density > 0 &&
                          half_space->radius > 0 && soil.mass > 0 && soil.inertia_x > 0 && soil.inertia_y > 0;
    return is_whole ? std::optional(soil_in_plan(*half_space, soil)) : std::nullopt;
  }
  soil.sway_x = read_impedance(view, "sway");
  soil.rocking_x = read_impedance(view, "rocking");
  soil.sway_y = view.has("sway_y") ? read_impedance(view, "sway_y") : soil.sway_x;
  soil.rocking_y = view.has("rocking_y") ? read_impedance(view, "rocking_y") : soil.rocking_x;
  const auto twist = view.find("twist");
  if (!twist) {
    view.error_missing("twist", "the spring of the rotation about the vertical, or \"rigid\"");
  } else if (twist->is(TomlValue::Kind::table)) {
    soil.twist = read_impedance(view, "twist");
  } else {
    (void)view.word("twist");
  }
  return soil;
}

void read_gravity(const TableView& view, ReadBuilding& building) {
  building.spec.p_delta = view.flag("p_delta");
  if (!view.has("gravity_loads")) return;
  building.spec.gravity_loads = view.numbers("gravity_loads", building.elevations.size());
  if (view.has("p_delta")) view.find("p_delta")->error("and gravity_loads exclude one another: give one of them");
}

void read_support(const TableView& view, double gravity, ReadBuilding& building) {
  building.spec.gravity = gravity;
  read_gravity(view, building);
  const auto isolation = view.find("isolation");
  const auto soil = view.find("soil");
  if (isolation) read_isolation(*isolation, building);
  if (soil) read_soil(*soil, building);
  if (isolation && soil) soil->error("and isolation exclude one another: a slab on bearings stands on firm ground");
}

}  // namespace bentur
