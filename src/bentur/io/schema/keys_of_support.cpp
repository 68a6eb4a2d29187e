#include "bentur/elements/bearing_laws.h"
#include "bentur/elements/hinges/polygon_yield.h"
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

/// Of all laws and a dashpot. @param weight what W is, in place of what the laws say of all bearings as one
void add_bearing_laws(KeyTable& made, std::string_view otherwise, std::string_view dashpot, std::string_view weight) {
  const auto& laws = bearing_laws();
  for (Key key : laws.front().keys) {
    if (key.is_required()) key.optional(otherwise);
    made.keys.push_back(key);
  }
  made.keys.push_back(
      Key::number("damping", dimension::dashpot, Range::not_negative, {"Damping", "Redaman"}, dashpot).by_default(0));
  for (std::size_t i = 1; i < laws.size(); ++i) {
    made.keys.push_back(
        Key::sub_table(laws[i].name, bearing_tables()[i - 1], laws[i].label, weight.empty() ? laws[i].doc : weight)
            .one_of("law", Need::optional));
  }
}

}  // namespace

const KeyTable& isolation_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building.isolation",
        "bearings below a slab",
        {Key::number("mass", dimension::mass, Range::positive, {"Slab above the bearings", "Pelat di atas bantalan"},
                     "of the slab; the lower halves of a frame's lowest columns join it")}};
    add_bearing_laws(made, "needed without another law of bearings, but in plan", "of a dashpot beside them", "");
    made.keys.push_back(Key::sub_table("bearing", bearing_keys(), {"Bearings", "Bantalan"},
                                       "of buildings in plan: bearings and where they stand, in place of the above")
                            .list()
                            .optional("needed in plan"));
    made.keys.push_back(Key::number("centre", dimension::length, Range::finite, {"Centre of mass", "Pusat massa"},
                                    "of buildings in plan: of the slab, from the corner")
                            .list("x and y", 2)
                            .optional("the middle of the footprint"));
    made.keys.push_back(Key::number("inertia", dimension::mass_inertia, Range::positive, {"Inertia", "Inersia"},
                                    "of buildings in plan: of the slab, about the vertical through its centre of mass")
                            .optional("of an even slab on the footprint"));
    return made;
  }();
  return table;
}

const KeyTable& bearing_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"building.isolation.bearing",
                     "bearings of one kind; numbers are those of one of them, along x and along y",
                     {Key::number("at", dimension::length, Range::finite, {"At", "Letak"},
                                  "from the corner: one pair, or a list of one for each bearing of this kind")
                          .matrix("x and y", true)}};
    add_bearing_laws(made, "needed without another law of bearings", "of a dashpot beside it",
                     "in place of stiffness, strength and displacement: Q = μW, stiffness W/R, W its share of all "
                     "weight above, the slab's too");
    made.keys.push_back(Key::whole("yield_sides", PolygonYield::least_sides, PolygonYield::most_sides,
                                   {"Sides of its yield surface", "Sisi permukaan leleh"},
                                   "a multiple of 4, of the polygon that bounds the force which yields; 4: along x and "
                                   "along y, each by itself; n: a circle to 1/cos(π/n)")
                            .by_default(PolygonYield::least_sides));
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
       Key::choice(
           "twist", {"rigid"}, {"Twist", "Puntir"},
           "of buildings in plan: of the rotation about the vertical; `\"rigid\"`: the foundation does not turn")
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
