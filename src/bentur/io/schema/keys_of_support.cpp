#include "bentur/elements/bearing_laws.h"
#include "bentur/io/schema/case_keys.h"

namespace bentur {

namespace {

/// Of each law of bearings but the first its table; keys point to them.
const std::vector<KeyTable>& bearing_tables() {
  static const std::vector<KeyTable> tables = [] {
    std::vector<KeyTable> made;
    for (const auto& law : bearing_laws()) made.push_back({law.name, law.label.english, law.keys});
    made.erase(made.begin());
    return made;
  }();
  return tables;
}

}  // namespace

const KeyTable& isolation_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building.isolation",
        "bearings below a slab",
        {Key::number("mass", dimension::mass, Range::positive, {"Slab above the bearings", "Pelat di atas bantalan"},
                     "of the slab; the lower halves of a frame's lowest columns join it")}};
    const auto& laws = bearing_laws();
    for (Key key : laws.front().keys) {
      if (key.is_required()) key.optional("needed without another law of bearings");
      made.keys.push_back(key);
    }
    made.keys.push_back(Key::number("damping", dimension::dashpot, Range::not_negative, {"Damping", "Redaman"},
                                    "of a dashpot beside them")
                            .by_default(0));
    for (std::size_t i = 1; i < laws.size(); ++i) {
      made.keys.push_back(Key::sub_table(laws[i].name, bearing_tables()[i - 1], laws[i].label, laws[i].doc)
                              .one_of("law", Need::optional));
    }
    return made;
  }();
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
       Key::sub_table("sway_y", sway_keys(), {"Sway along y", "Goyangan arah y"},
                      "of buildings in plan: along y, where it is not as along x")
           .optional("as `sway`")
           .goes_with("sway"),
       Key::sub_table("rocking_y", rocking_keys(), {"Rocking along y", "Guling arah y"},
                      "of buildings in plan: the one that moves floors along y, where it is not as along x")
           .optional("as `rocking`")
           .goes_with("sway"),
       Key::choice("twist", {"rigid"}, {"Twist", "Puntir"},
                   "of buildings in plan: spring and dashpot of the rotation about the vertical; `\"rigid\"`: the "
                   "foundation does not turn")
           .or_table(twist_keys())
           .optional("needed in plan with `sway`")
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

const KeyTable& twist_keys() {
  static const KeyTable table =
      impedance("building.soil.twist", "twist on the soil", dimension::moment, dimension::rocking_dashpot);
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
       Key::number("inertia", dimension::mass_inertia, Range::positive, {"Rotational inertia", "Inersia rotasi"}),
       Key::number("inertia_y", dimension::mass_inertia, Range::positive,
                   {"Rotational inertia along y", "Inersia rotasi arah y"},
                   "of buildings in plan: of the rocking that moves floors along y")
           .optional("as `inertia`"),
       Key::number("twist_inertia", dimension::mass_inertia, Range::positive,
                   {"Inertia about the vertical", "Inersia terhadap sumbu tegak"}, "of buildings in plan")
           .optional("of an even footprint")}};
  return table;
}

}  // namespace bentur
