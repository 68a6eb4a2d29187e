#include "bentur/elements/hysteretic_laws.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/footprint_keys.h"

namespace bentur {
namespace {

constexpr int most_floors_in_plan = 1000;

constexpr int most_corners = 100;

Key corner_of_footprint() {
  return Key::number(
             "corner", dimension::length, Range::level, {"Corner", "Sudut"},
             "the lower left one of the footprint, in the common plan; of a polygon the place that all in it is "
             "counted from")
      .list("x and y", 2)
      .optional("needed with `size`; of a polygon (0, 0)");
}

Key size_of_footprint() {
  return Key::number("size", dimension::length, Range::size, {"Size", "Ukuran"},
                     "of a rectangular footprint, along x and y; or")
      .list("along x and y", 2)
      .one_of("footprint");
}

Key polygon_of_footprint() {
  return Key::number("polygon", dimension::length, Range::level, {"Polygon", "Poligon"},
                     "x and y of the corners of a footprint, round it, from `corner`; exactly one of the two")
      .matrix()
      .up_to(most_corners)
      .one_of("footprint");
}

Key courts_of_footprint() {
  return Key::sub_table("court", court_keys(), {"Courts", "Halaman dalam"}, "open courts within the polygon")
      .list()
      .goes_with("polygon")
      .optional("none");
}

Key parts_of_footprint() {
  return Key::sub_table("part", part_keys(), {"Parts", "Bagian"},
                        "further parts of the same floors, which stand beside the polygon and move with it")
      .list()
      .goes_with("polygon")
      .optional("none");
}

Key ring() {
  return Key::number("polygon", dimension::length, Range::level, {"Polygon", "Poligon"},
                     "x and y of its corners, round it, from the `corner` of the footprint")
      .matrix()
      .up_to(most_corners);
}

}  // namespace

const KeyTable& court_keys() {
  static const KeyTable table = {"building.plan.court", "a court within a footprint", {ring()}};
  return table;
}

const KeyTable& part_keys() {
  static const KeyTable table = {"building.plan.part", "a part of a footprint beside its polygon", {ring()}};
  return table;
}

const KeyTable& plan_keys() {
  static const KeyTable table = {
      "plan",
      "buildings in plan: which of them may touch, and how",
      {Key::number("clearance", dimension::length, Range::distance, {"Neighbours are within", "Tetangga berada dalam"},
                   "footprints whose edges are at most this far apart may touch")
           .optional("pairs that a `[[gap]]` names, alone"),
       Key::whole("points", 2, 50, {"Contact points", "Titik kontak"},
                  "of each stretch and level, evenly spaced, ends included")
           .by_default(2),
       Key::sub_table("contact", contact_keys(), {"Contact", "Kontak"},
                      "of every pair without its own; numbers are one for all levels")
           .optional("each pair needs its own")}};
  return table;
}

const KeyTable& building_plan_keys() {
  static const KeyTable table = {
      "building.plan",
      "a building in plan",
      {corner_of_footprint(), size_of_footprint(), polygon_of_footprint(), courts_of_footprint(), parts_of_footprint(),
       Key::number("storey_heights", dimension::length, Range::size, {"Storey heights", "Tinggi tingkat"},
                   "bottom to top")
           .list("one per storey")
           .up_to(most_floors_in_plan)
           .optional("needed but with `building.generic`, which has them"),
       Key::number("masses", dimension::mass, Range::positive, {"Masses", "Massa"}, "of the floors")
           .list("one per storey")
           .optional("needed but with `building.generic`, which has them"),
       Key::number("centres_of_mass", dimension::length, Range::finite, {"Centres of mass", "Pusat massa"},
                   "from the corner: one pair for all floors, or a list of one per floor")
           .matrix("one per storey", true)
           .optional("the middle of the footprint"),
       Key::number("accidental_eccentricity", dimension::none, Range::finite,
                   {"Accidental eccentricity", "Eksentrisitas tak terduga"},
                   "parts of the size: a list moves all centres of mass, but not what holds the floors; a number is of "
                   "both ways, along x and along y")
           .for_each("along x and y")
           .optional("0"),
       Key::number("inertias", dimension::mass_inertia, Range::positive, {"Inertias", "Inersia"},
                   "of the floors about the vertical through their centre of mass")
           .list("one per storey")
           .optional("of an even floor: m (a² + b²)/12 of a footprint a × b")}};
  return table;
}

const KeyTable& wall_plan_keys() {
  static const KeyTable table = {"building.plan",
                                 "the footprint of a wall",
                                 {corner_of_footprint(), size_of_footprint(), polygon_of_footprint(),
                                  courts_of_footprint(), parts_of_footprint()}};
  return table;
}

/// Some of the keys of another table.
KeyTable part_of(const KeyTable& whole, std::initializer_list<std::string_view> names, std::string_view name,
                 std::string_view doc) {
  KeyTable part = {name, doc, {}};
  for (const std::string_view one : names) part.keys.push_back(whole.at(one));
  return part;
}

const KeyTable& plane_section_keys() {
  static const KeyTable table = [] {
    KeyTable made = part_of(section_keys(),
                            {"width", "depth", "area", "inertia", "moment_capacity", "hardening", "rotation_limits",
                             "backbone", "line_load", "shear_capacity", "residual_shear"},
                            "building.plane.frame.section",
                            "a section of a member of a frame in plan, of which the masses are those of the plan");
    made.keys.push_back(Key::number("density", dimension::density, Range::positive, {"Density", "Rapat massa"},
                                    "of columns that are struck: part of the floors' masses")
                            .optional("needed where a column is struck"));
    return made;
  }();
  return table;
}

const KeyTable& plane_frame_keys() {
  static const KeyTable table = [] {
    KeyTable made =
        part_of(frame_keys(), {"elastic_modulus", "bay_widths", "columns", "beams", "infill"}, "building.plane.frame",
                "a plane frame of a building in plan, of whose floors the masses are those of the plan");
    for (Key& key : made.keys) {
      if (key.name == "columns" || key.name == "beams") key.table = &plane_section_keys();
    }
    return made;
  }();
  return table;
}

const KeyTable& plane_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building.plane",
        "a frame or wall of a building in plan, on a line",
        {Key::of("name", Key::Kind::line, {"Name", "Nama"}, "different from the others").optional("`\"plane 1\"`, …"),
         Key::choice("along", {"x", "y"}, {"Along", "Sejajar"}, "the axis that its line is parallel to; or")
             .one_of("line"),
         Key::number("at", dimension::length, Range::finite, {"At", "Letak"},
                     "of a line along x its y, of one along y its x, from the corner")
             .optional("needed with `along`")
             .goes_with("along"),
         Key::number("angle", dimension::none, Range::finite, {"Angle", "Sudut arah"},
                     "of its line with x, counter-clockwise; exactly one of the two")
             .one_of("line")
             .counted_in("degrees"),
         Key::number("through", dimension::length, Range::finite, {"Through", "Melalui"},
                     "a point of its line, from the corner")
             .list("x and y", 2)
             .optional("needed with `angle`")
             .goes_with("angle"),
         Key::number("stiffnesses", dimension::stiffness, Range::not_negative, {"Stiffnesses", "Kekakuan"},
                     "of its storeys, one of them > 0; or")
             .for_each("one per storey")
             .one_of("holds"),
         Key::sub_table(
             "frame", plane_frame_keys(), {"Frame", "Portal"},
             "a [plane frame](case-buildings.md#buildingframe-a-plane-frame) on the line; exactly one of the two")
             .one_of("holds"),
         Key::number("yield_forces", dimension::force, Range::positive_or_infinite, {"Yield forces", "Gaya leleh"},
                     "the force at which the storey of the plane yields; `inf`: it stays elastic")
             .for_each("one per storey")
             .optional("none yields"),
         Key::number("hardening", dimension::none, Range::ratio, {"Hardening", "Pengerasan"},
                     "stiffness after yielding over that before")
             .for_each("one per storey")
             .goes_with("yield_forces")
             .by_default(0)}};
    add_laws(
        hysteretic_laws(),
        Key::choice("hysteresis", {}, {"Planes that yield", "Bidang yang leleh"}).optional().goes_with("yield_forces"),
        made.keys);
    made.keys.push_back(
        Key::sub_table("backbone", backbone_keys(), {"Loss of strength", "Kehilangan kekuatan"},
                       "a plane that yields and [loses strength](case-buildings.md#storeys-that-lose-strength); in "
                       "place of the keys of yielding above")
            .optional("no strength is lost"));
    return made;
  }();
  return table;
}

const KeyTable& rigidity_keys() {
  static const KeyTable table = {
      "building.rigidity",
      "what holds the storeys of a building in plan, in place of planes or beside them",
      {Key::number("centre", dimension::length, Range::finite, {"Centre of rigidity", "Pusat kekakuan"},
                   "from the corner: one pair for all storeys, or a list of one per storey")
           .matrix("one per storey", true),
       Key::number("x", dimension::stiffness, Range::not_negative, {"Along x", "Sejajar x"})
           .for_each("one per storey")
           .by_default(0),
       Key::number("y", dimension::stiffness, Range::not_negative, {"Along y", "Sejajar y"})
           .for_each("one per storey")
           .by_default(0),
       Key::number("torsion", dimension::moment, Range::not_negative, {"Against rotation", "Terhadap rotasi"},
                   "about that centre, per radian")
           .for_each("one per storey")
           .by_default(0)}};
  return table;
}

}  // namespace bentur
