#include "bentur/io/schema/case_keys.h"

namespace bentur {

const KeyTable& isolation_keys() {
  static const KeyTable table = {
      "building.isolation",
      "bearings below a slab",
      {Key::number("mass", dimension::mass, Range::positive, {"Slab above the bearings", "Pelat di atas bantalan"},
                   "of the slab; the lower halves of a frame's lowest columns join it"),
       Key::number("stiffness", dimension::stiffness, Range::positive, {"Stiffness", "Kekakuan"},
                   "after yielding; alone, of a linear bearing")
           .optional("needed but for `friction_pendulum`"),
       Key::number("characteristic_strength", dimension::force, Range::not_negative,
                   {"Characteristic strength", "Kekuatan karakteristik"},
                   "Q: the force where the yielding branch crosses zero displacement")
           .by_default(0),
       Key::number("yield_displacement", dimension::length, Range::positive,
                   {"Displacement at yield", "Perpindahan leleh"},
                   "Δ_y, goes with Q: the stiffness before yielding is `stiffness` + Q/Δ_y")
           .optional(),
       Key::number("damping", dimension::dashpot, Range::not_negative, {"Damping", "Redaman"},
                   "of a dashpot beside them")
           .by_default(0),
       Key::sub_table("friction_pendulum", pendulum_keys(), {"Friction pendulum", "Pendulum gesek"},
                      "in place of stiffness, strength and displacement: Q = μW, stiffness W/R, W all weight above, "
                      "the slab's too")
           .optional()}};
  return table;
}

const KeyTable& pendulum_keys() {
  static const KeyTable table = {
      "building.isolation.friction_pendulum",
      "friction pendulum bearings",
      {Key::number("coefficient", dimension::none, Range::positive, {"Friction", "Koefisien gesek"}, "μ"),
       Key::number("radius", dimension::length, Range::positive, {"Radius", "Jari-jari"}, "R"),
       Key::number("yield_displacement", dimension::length, Range::positive,
                   {"Displacement at yield", "Perpindahan leleh"}, "Δ_y")}};
  return table;
}

const KeyTable& soil_keys() {
  static const KeyTable table = {
      "building.soil",
      "sway and rocking of the foundation",
      {Key::sub_table("sway", sway_keys(), {"Sway", "Goyangan"}, "spring and dashpot of the sway")
           .one_of("ground")
           .goes_with("rocking"),
       Key::sub_table("rocking", rocking_keys(), {"Rocking", "Guling"}, "spring and dashpot of the rotation")
           .optional()
           .goes_with("sway"),
       Key::sub_table("foundation", foundation_keys(), {"Foundation", "Fondasi"},
                      "the lower halves of a frame's lowest columns join it"),
       Key::sub_table("half_space", half_space_keys(), {"Half-space", "Setengah ruang"},
                      "in place of `sway` and `rocking`: a rigid disc on the surface of an elastic half-space "
                      "([theory](theory/structure.md#soil))")
           .one_of("ground")}};
  return table;
}

namespace {

KeyTable impedance(std::string_view name, std::string_view title, PhysicalDimension stiffness,
                   PhysicalDimension dashpot) {
  return {name,
          title,
          {Key::number("stiffness", stiffness, Range::positive, {"Stiffness", "Kekakuan"}),
           Key::number("damping", dashpot, Range::not_negative, {"Damping", "Redaman"}).by_default(0)}};
}

}  // namespace

const KeyTable& sway_keys() {
  static const KeyTable table =
      impedance("building.soil.sway", "sway on the soil", dimension::stiffness, dimension::dashpot);
  return table;
}

const KeyTable& rocking_keys() {
  static const KeyTable table =
      impedance("building.soil.rocking", "rocking on the soil", dimension::moment, dimension::rocking_dashpot);
  return table;
}

const KeyTable& half_space_keys() {
  static const KeyTable table = {
      "building.soil.half_space",
      "a rigid disc on an elastic half-space",
      {Key::number("shear_wave_velocity", dimension::velocity, Range::positive,
                   {"Shear wave velocity", "Kecepatan gelombang geser"}),
       Key::number("density", dimension::density, Range::positive, {"Density", "Rapat massa"}),
       Key::number("poisson", dimension::none, Range::poisson, {"Poisson's ratio", "Rasio Poisson"}),
       Key::number("radius", dimension::length, Range::positive, {"Radius", "Jari-jari"}, "of the disc")}};
  return table;
}

const KeyTable& foundation_keys() {
  static const KeyTable table = {
      "building.soil.foundation",
      "mass of the foundation",
      {Key::number("mass", dimension::mass, Range::positive, {"Mass", "Massa"}),
       Key::number("inertia", dimension::mass_inertia, Range::positive, {"Rotational inertia", "Inersia rotasi"})}};
  return table;
}

}  // namespace bentur
