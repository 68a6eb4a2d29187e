#include "bentur/elements/hysteretic_laws.h"
#include "bentur/io/schema/case_keys.h"

namespace bentur {
namespace {

constexpr int most_floors = 1000;

Key elevations_of_floors() {
  return Key::number("elevations", dimension::length, Range::size, {"Levels above the base", "Elevasi dari dasar"},
                     "ascending, of the floors above the own base")
      .list()
      .up_to(most_floors);
}

/// Of a building whose floors do not turn.
Key columns_that_are_struck() {
  return Key::sub_table("columns", storey_columns_keys(), {"Columns", "Kolom"},
                        "that a neighbour's floor may strike, with `strikes_columns` of the gap")
      .optional("none are struck");
}

Key hardening_of_storeys() {
  return Key::number("hardening", dimension::none, Range::ratio, {"Hardening", "Pengerasan"},
                     "stiffness after yielding over that before")
      .by_default(0);
}

}  // namespace

const KeyTable& building_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building",
        "a building of the row, from left to right",
        {
            Key::of("name", Key::Kind::line, {"Name", "Nama"}, "not empty, different from the others"),
            Key::number("damping", dimension::none, Range::share, {"Damping", "Redaman"},
                        "of every mode, or a table that says it: see [Damping](case-foundations.md#damping)")
                .or_table(damping_keys())
                .optional("needed but for `matrices.damping`, `displacements` and a wall"),
            Key::choice("damping_stiffness", {"initial", "tangent"}, {"Stiffness of the damping", "Kekakuan redaman"},
                        "where storeys yield: see [Damping](case-foundations.md#damping)")
                .called({{"initial", "awal"}, {"tangent where a storey yields", "tangen bila tingkat leleh"}})
                .optional(),
            Key::number("calibrate_period", dimension::time, Range::positive,
                        {"Stiffness scaled to a first period of", "Kekakuan diskalakan ke periode pertama"},
                        "first period to which the stiffness is scaled, on a fixed base, without gravity loads; not "
                        "`axial` contact stiffness")
                .optional("none"),
            Key::number("base_elevation", dimension::length, Range::level, {"Base elevation", "Elevasi dasar"},
                        "of the base above the common datum")
                .by_default(0),
            Key::number("width", dimension::length, Range::size, {"Width", "Lebar"},
                        "for `wave_velocity` only; a frame has that of its bays")
                .optional("none"),
            Key::of("rigid", Key::Kind::flag, {"Rigid", "Kaku"},
                    "a [wall](case-buildings.md#walls-rigid--true) that moves with the ground; other keys: "
                    "`elevations`, `base_elevation`")
                .by_default(0),
            Key::number("elevations", dimension::length, Range::level, {"Levels above the base", "Elevasi dari dasar"},
                        "of a wall alone: ascending, where it can be struck")
                .list()
                .up_to(most_floors)
                .when("rigid", {"true"}),
            Key::of("p_delta", Key::Kind::flag, {"P-Δ", "P-Δ"},
                    "the floors' weights [soften the building](case-foundations.md#gravity-loads-p-δ)")
                .one_of("gravity", Need::optional)
                .by_default(0),
            Key::number("gravity_loads", dimension::force, Range::not_negative,
                        {"Gravity loads (P-Δ)", "Beban gravitasi (P-Δ)"},
                        "of the structure, none for a slab; in place of `p_delta`")
                .list("one per floor")
                .one_of("gravity")
                .optional("none"),
            Key::sub_table("soil", soil_keys(), {"Soil", "Tanah"},
                           "[soil](case-foundations.md#buildingsoil-sway-and-rocking) on which the foundation sways "
                           "and rocks; not with `isolation`")
                .one_of("support")
                .optional("none"),
            Key::sub_table("isolation", isolation_keys(), {"Bearings", "Bantalan"},
                           "[bearings](case-foundations.md#buildingisolation-bearings) below a slab")
                .one_of("support")
                .optional("none"),
            Key::sub_table("frame", frame_keys(), {"Frame", "Portal"},
                           "a [plane frame](case-buildings.md#buildingframe-a-plane-frame)")
                .one_of("structure"),
            Key::sub_table("stick", stick_keys(), {"Shear building", "Bangunan geser"},
                           "a [shear building](case-buildings.md#buildingstick-a-shear-building)")
                .one_of("structure"),
            Key::sub_table(
                "matrices", matrices_keys(), {"Matrices", "Matriks"},
                "[from another program](case-buildings.md#buildingmatrices-from-another-program), also beside `plan`")
                .one_of("structure")
                .may_join("plan"),
            Key::sub_table(
                "modal", modal_keys(), {"Modes", "Ragam"},
                "[known by its modes](case-buildings.md#buildingmodal-known-by-its-modes), also beside `plan`")
                .one_of("structure")
                .may_join("plan"),
            Key::sub_table("generic", generic_keys(), {"Generic", "Generik"},
                           "[known by little](case-buildings.md#buildinggeneric-known-by-little), also beside `plan`")
                .one_of("structure")
                .may_join("plan"),
            Key::sub_table("displacements", displacements_keys(), {"Displacements", "Perpindahan"},
                           "[known by its peak "
                           "displacements](case-buildings.md#buildingdisplacements-from-another-program): for gaps "
                           "alone")
                .one_of("structure"),
            Key::sub_table("plan", building_plan_keys(), {"In plan", "Dalam denah"},
                           "floors [in plan](case-plan.md#buildings-in-plan)")
                .one_of("structure"),
            Key::sub_table("plan", wall_plan_keys(), {"In plan", "Dalam denah"}, "of a wall beside buildings in plan")
                .optional("it stands in a row")
                .when("rigid", {"true"}),
            Key::sub_table("plane", plane_keys(), {"Planes", "Bidang"}, "frames and walls of a building in plan")
                .list()
                .goes_with("plan")
                .optional("none"),
            Key::sub_table("rigidity", rigidity_keys(), {"Rigidity", "Kekakuan tingkat"},
                           "of a building in plan, in place of planes or beside them")
                .goes_with("plan")
                .optional("none"),
        }};
    for (Key& key : made.keys) {
      const bool of_a_wall = key.name == "name" || key.name == "rigid" || key.name == "base_elevation";
      if (!of_a_wall && key.conditions.empty()) key.when("rigid", {"false"});
    }
    return made;
  }();
  return table;
}

const KeyTable& damping_keys() {
  static const KeyTable table = {
      "building.damping",
      "damping of a building",
      {Key::number("modal", dimension::none, Range::share, {"Ratio of every mode", "Rasio setiap ragam"},
                   "one ratio per mode")
           .list("one per mode")
           .one_of("form"),
       Key::sub_table("rayleigh", rayleigh_keys(), {"Rayleigh damping", "Redaman Rayleigh"},
                      "α M + β K with two ratios at two different periods; no mode may come out negative")
           .one_of("form"),
       Key::number("mass_proportional", dimension::none, Range::share,
                   {"Mass-proportional, ratio in mode 1", "Sebanding massa, rasio pada ragam 1"},
                   "α M with this ratio in the first mode")
           .one_of("form"),
       Key::number("stiffness_proportional", dimension::none, Range::share,
                   {"Stiffness-proportional, ratio in mode 1", "Sebanding kekakuan, rasio pada ragam 1"},
                   "β K with this ratio in the first mode, β = 2ζ/ω₁: a dashpot in each storey of a stick")
           .one_of("form")}};
  return table;
}

const KeyTable& rayleigh_keys() {
  static const KeyTable table = {
      "building.damping.rayleigh",
      "two ratios at two periods",
      {Key::number("ratios", dimension::none, Range::share, {"Ratios", "Rasio"}).list("for two modes", 2),
       Key::number("periods", dimension::time, Range::positive, {"Periods", "Periode"}, "two different ones")
           .list("of two modes", 2)}};
  return table;
}

const KeyTable& frame_keys() {
  static const KeyTable table = {
      "building.frame",
      "a plane frame",
      {Key::number("elastic_modulus", dimension::pressure, Range::positive, {"Elastic modulus", "Modulus elastisitas"}),
       Key::number("storey_heights", dimension::length, Range::size, {"Storey heights", "Tinggi tingkat"},
                   "bottom to top")
           .list()
           .up_to(most_floors),
       Key::number("bay_widths", dimension::length, Range::size, {"Bay widths", "Lebar bentang"}, "left to right")
           .list()
           .up_to(100),
       Key::sub_table("columns", section_keys(), {"Columns", "Kolom"}).list("one for all, or one per storey"),
       Key::sub_table("beams", section_keys(), {"Beams", "Balok"}).list("one for all, or one per floor"),
       Key::sub_table("infill", infill_keys(), {"Infill", "Dinding pengisi"},
                      "[masonry](case-buildings.md#infill) in all bays of a storey")
           .list("one for all, or one per storey")
           .optional("none"),
       Key::number("floor_masses", dimension::mass, Range::not_negative, {"Floor masses", "Massa lantai"},
                   "added to the floor's sway (slab, live load)")
           .for_each("one per floor")
           .optional("zeros"),
       Key::sub_table("floor_load", floor_load_keys(), {"Floor load", "Beban lantai"},
                      "a load q on a strip w of every floor")
           .optional("none"),
       Key::choice("mass_matrix", {"consistent", "lumped"}, {"Mass matrix", "Matriks massa"},
                   "lumped: half of each column to the floors it joins, rotations without mass")
           .called({{"consistent", "konsisten"}, {"lumped", "tergumpal"}})
           .optional(),
       Key::choice("condensation", {"static", "dynamic", "none"}, {"Joint rotations", "Rotasi titik kumpul"},
                   "dynamic: the first mode is exact; none: joint rotations stay")
           .called({{"condensed statically", "dikondensasi statis"},
                    {"condensed dynamically", "dikondensasi dinamis"},
                    {"kept", "dipertahankan"}})
           .optional(),
       Key::of("base_coupling", Key::Kind::flag, {"Mass coupling to the base", "Kopel massa dengan dasar"},
               "the mass coupling between base and ground storey counts")
           .by_default(1)}};
  return table;
}

const KeyTable& section_keys() {
  static const KeyTable table = {
      "building.frame.section",
      "a section of a frame's members: width and depth, or area and inertia; and one of mass, density, unit_weight",
      {Key::number("width", dimension::length, Range::positive, {"Width", "Lebar"}, "with `depth`; or")
           .one_of("shape")
           .goes_with("depth"),
       Key::number("depth", dimension::length, Range::positive, {"Depth", "Tinggi penampang"},
                   "with `width`, in the plane of the frame; or")
           .optional()
           .goes_with("width"),
       Key::number("area", dimension::area, Range::positive, {"Area", "Luas"}, "with `inertia`; or")
           .one_of("shape")
           .goes_with("inertia"),
       Key::number("inertia", dimension::second_moment, Range::positive, {"Second moment of area", "Momen inersia"},
                   "with `area`; exactly one of the two pairs")
           .optional()
           .goes_with("area"),
       Key::number("mass", dimension::mass, Range::not_negative, {"Mass", "Massa"},
                   "of the whole member: one column of one storey, one beam of one bay; or")
           .one_of("weight"),
       Key::number("density", dimension::density, Range::not_negative, {"Density", "Rapat massa"}, "of the member; or")
           .one_of("weight"),
       Key::number("unit_weight", dimension::unit_weight, Range::not_negative, {"Unit weight", "Berat isi"},
                   "of the member; exactly one of the three")
           .one_of("weight"),
       Key::number("moment_capacity", dimension::moment, Range::positive_or_infinite,
                   {"Moment capacity", "Kapasitas momen"},
                   "at which its ends [yield](case-buildings.md#hinges); of beams also two: tension below, above")
           .for_each("one per column line, or below and above")
           .optional("it stays elastic"),
       Key::number("hardening", dimension::none, Range::ratio, {"Hardening", "Pengerasan"},
                   "stiffness after yielding over that before, of a member bent to an S")
           .goes_with("moment_capacity")
           .by_default(0),
       Key::number("rotation_limits", dimension::none, Range::positive, {"Limits of rotation", "Batas rotasi"},
                   "IO, LS and CP of ASCE 41, ascending: rotations of its hinges are reported as parts of them")
           .list("IO, LS, CP", 3)
           .counted_in("rad")
           .goes_with("moment_capacity")
           .optional("none"),
       Key::sub_table("backbone", hinge_backbone_keys(), {"Loss of strength", "Kehilangan kekuatan"},
                      "its hinges [lose strength](case-buildings.md#hinges-that-lose-strength) beyond a cap")
           .goes_with("moment_capacity")
           .optional("no strength is lost"),
       Key::number("line_load", dimension::stiffness, Range::not_negative, {"Line load", "Beban merata"},
                   "on a beam, downwards: it gives its hinges moments at rest")
           .by_default(0),
       Key::number("shear_capacity", dimension::force, Range::positive_or_infinite,
                   {"Shear capacity", "Kapasitas geser"},
                   "shear at which a column [breaks](case-buildings.md#columns-that-break)")
           .for_each("one per column line")
           .optional("it does not break"),
       Key::number("residual_shear", dimension::none, Range::ratio, {"Residual shear", "Gaya geser sisa"},
                   "the part of it that a broken column keeps")
           .goes_with("shear_capacity")
           .by_default(0)}};
  return table;
}

const KeyTable& floor_load_keys() {
  static const KeyTable table = {
      "building.frame.floor_load",
      "a load on a strip of every floor",
      {Key::number("pressure", dimension::pressure, Range::not_negative, {"Pressure", "Tekanan"}, "q")
           .for_each("one per floor"),
       Key::number("width", dimension::length, Range::positive, {"Width of the strip", "Lebar jalur"}, "w")
           .for_each("one per floor")}};
  return table;
}

const KeyTable& storey_columns_keys() {
  static const KeyTable table = {
      "building.stick.columns",
      "columns on the sides of a stick or a generic building, which a neighbour's floor may strike; their stiffness "
      "and "
      "mass are part of those of storeys and floors",
      {Key::number("elastic_modulus", dimension::pressure, Range::positive, {"Elastic modulus", "Modulus elastisitas"}),
       Key::number("inertia", dimension::second_moment, Range::positive, {"Second moment of area", "Momen inersia"},
                   "of one column")
           .for_each("one per storey"),
       Key::number("mass", dimension::mass, Range::positive, {"Mass", "Massa"}, "of one column from floor to floor")
           .for_each("one per storey"),
       Key::whole("number", 1, 1000, {"Columns side by side", "Kolom berdampingan"},
                  "how many a floor strikes at once; reported forces are of all of them")
           .by_default(1)}};
  return table;
}

const KeyTable& stick_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building.stick",
        "a shear building; storeys with `yield_forces` yield",
        {Key::number("storey_heights", dimension::length, Range::size, {"Storey heights", "Tinggi tingkat"},
                     "bottom to top")
             .list("one per storey")
             .up_to(most_floors),
         Key::number("masses", dimension::mass, Range::positive, {"Masses", "Massa"}, "of the floors")
             .list("one per storey"),
         Key::number("stiffnesses", dimension::stiffness, Range::positive, {"Stiffnesses", "Kekakuan"},
                     "of the storeys")
             .list("one per storey"),
         Key::number("yield_forces", dimension::force, Range::positive_or_infinite, {"Yield forces", "Gaya leleh"},
                     "V_y, the shear at which the storey yields; `inf`: it stays elastic")
             .for_each("one per storey")
             .optional("none yields"),
         hardening_of_storeys().for_each("one per storey").goes_with("yield_forces")}};
    add_laws(hysteretic_laws(),
             Key::choice("hysteresis", {}, {"Storeys that yield", "Tingkat yang leleh"})
                 .optional()
                 .goes_with("yield_forces"),
             made.keys);
    made.keys.push_back(columns_that_are_struck());
    made.keys.push_back(Key::sub_table("backbone", backbone_keys(), {"Loss of strength", "Kehilangan kekuatan"},
                                       "storeys that yield and lose strength; in place of the keys of yielding above")
                            .optional("no strength is lost"));
    return made;
  }();
  return table;
}

constexpr auto beside_plan = "needed but beside `plan`";  // which has them

const KeyTable& matrices_keys() {
  static const KeyTable table = {
      "building.matrices",
      "mass and stiffness from another program, floors × floors",
      {elevations_of_floors().optional(beside_plan),
       Key::number("mass", dimension::mass, Range::finite, {"Mass", "Massa"},
                   "n rows of n numbers, or a list of n: the diagonal")
           .matrix("one per elevation", true)
           .optional(beside_plan),
       Key::number("stiffness", dimension::stiffness, Range::finite, {"Stiffness", "Kekakuan"},
                   "n rows of n numbers; in plan 3 n of 3 n: u_x, u_y [length] and rotation [rad] of the lowest "
                   "floor's centre of mass, of the next …")
           .matrix("one per elevation"),
       Key::number("damping", dimension::dashpot, Range::finite, {"Damping", "Redaman"},
                   "n rows of n numbers, in place of `building.damping`")
           .matrix("one per elevation")
           .optional("`building.damping`")}};
  return table;
}

const KeyTable& modal_keys() {
  static const KeyTable table = {
      "building.modal",
      "known by its modes",
      {elevations_of_floors().optional(beside_plan),
       Key::number("masses", dimension::mass, Range::positive, {"Masses", "Massa"}, "of the floors")
           .list("one per floor")
           .optional(beside_plan),
       Key::number("periods", dimension::time, Range::positive, {"Periods", "Periode"},
                   "of as many modes as are known, at most one per floor, in plan three")
           .list(),
       Key::number(
           "shapes", dimension::none, Range::finite, {"Shapes", "Bentuk ragam"},
           "one list per mode, floors bottom to top, of any scale; in plan u_x, u_y [length] and rotation [rad] "
           "of each floor's centre of mass; or")
           .matrix("one per mode")
           .one_of("shapes"),
       Key::of("shapes_file", Key::Kind::file, {"File of shapes", "Berkas bentuk ragam"},
               "a table, relative to the case: a row per floor, a column per mode (in plan three: u_x, u_y, rotation), "
               "or a row per storey and mode as of ETABS and SAP2000; exactly one of the two")
           .one_of("shapes"),
       Key::choice("shapes_column", {"UX", "UY", "U1", "U2"}, {"Column of the file", "Kolom berkas"},
                   "of a file with a row per storey and mode: the displacement along the row of buildings")
           .goes_with("shapes_file")
           .optional("needed for such a file but in plan, where UX, UY and RZ or U1, U2 and R3 are taken"),
       Key::number("shapes_modes", dimension::none, Range::positive, {"Modes of the file", "Ragam berkas"},
                   "of such a file: the numbers of the modes that `periods` are of")
           .list("one per period")
           .goes_with("shapes_file")
           .optional("all that the file has"),
       Key::of("floor_names", Key::Kind::text, {"Names in the file", "Nama dalam berkas"},
               "of its storeys or joints, lowest first, where neither elevations nor numbers in them give the order")
           .list("one per floor")
           .goes_with("shapes_file")
           .optional("none")}};
  return table;
}

const KeyTable& displacements_keys() {
  static const KeyTable table = {
      "building.displacements",
      "known by its peak displacements, from another program",
      {elevations_of_floors(),
       Key::number("u", dimension::length, Range::distance, {"Displacements", "Perpindahan"},
                   "peaks of the floors, relative to the base")
           .list("one per floor"),
       Key::number("amplification", dimension::none, Range::positive, {"Amplification", "Pembesaran"},
                   "to those expected, such as C_d/I_e under reduced forces: ABS, SRSS, DDC and rules that do not "
                   "amplify take u times it")
           .by_default(1),
       Key::number("period", dimension::time, Range::positive, {"First period", "Periode pertama"}, "for DDC")
           .optional("DDC is not known"),
       Key::number("damping_ratio", dimension::none, Range::share, {"Damping ratio", "Rasio redaman"},
                   "of the first mode")
           .goes_with("period")
           .optional("needed with `period`")}};
  return table;
}

const KeyTable& generic_keys() {
  static const KeyTable table = {
      "building.generic",
      "known by little",
      {Key::whole("storeys", 1, most_floors, {"Storeys", "Tingkat"}),
       Key::number("storey_height", dimension::length, Range::size, {"Storey height", "Tinggi tingkat"})
           .for_each("one per storey"),
       Key::number("floor_mass", dimension::mass, Range::positive, {"Floor mass", "Massa lantai"})
           .for_each("one per storey"),
       Key::number("period", dimension::time, Range::positive, {"First period", "Periode pertama"}, "the first; or")
           .one_of("period"),
       Key::sub_table("period_formula", period_formula_keys(), {"Formula for the period", "Rumus periode"},
                      "T₁ = coefficient · H^exponent, height H in metres, as of codes; exactly one of the two")
           .one_of("period"),
       Key::number("stiffness_ratio", dimension::none, Range::not_negative, {"Stiffness ratio", "Rasio kekakuan"},
                   "α = H √(GA/EI): 0 bends only, 30 and more shears only; or")
           .one_of("system"),
       Key::choice("system", {"wall", "dual", "frame"}, {"System", "Sistem"}, "α = 1, 4, 12; exactly one of the two")
           .called({{"wall, α = 1", "dinding, α = 1"},
                    {"dual, α = 4", "ganda, α = 4"},
                    {"frame, α = 12", "portal, α = 12"}})
           .one_of("system"),
       Key::number("yield_base_shear", dimension::none, Range::positive, {"Base shear at yield", "Geser dasar leleh"},
                   "over the weight: each shear spring yields in proportion to its shear in the first mode; needs "
                   "`stiffness_ratio` ≥ 30; or")
           .one_of("yields", Need::optional)
           .optional("none yields"),
       Key::number("design_base_shear", dimension::none, Range::positive, {"Design base shear", "Geser dasar rencana"},
                   "over the weight, by drawings or the code of its year: times `overstrength` the base shear at "
                   "yield; at most one of the two")
           .one_of("yields", Need::optional)
           .optional("none yields"),
       Key::number("overstrength", dimension::none, Range::positive, {"Overstrength", "Kuat lebih"},
                   "base shear at yield over `design_base_shear`, which needs it: "
                   "[what codes have](case-buildings.md#how-strong-a-building-is)")
           .goes_with("design_base_shear")
           .optional("none"),
       hardening_of_storeys(), columns_that_are_struck(),
       Key::number("period_y", dimension::time, Range::positive, {"First period along y", "Periode pertama arah y"},
                   "of buildings in plan: along y, where it is not the one along x")
           .optional("as along x"),
       Key::number("torsion_ratio", dimension::none, Range::positive,
                   {"Torsional over lateral frequency", "Frekuensi torsi terhadap lateral"},
                   "of buildings in plan: the uncoupled first frequency of rotation over the lower lateral one")
           .optional("1: stiffness as even over the floor as mass"),
       Key::number("eccentricity", dimension::length, Range::finite, {"Eccentricity", "Eksentrisitas"},
                   "of buildings in plan: from the centre of all mass to that of rigidity")
           .list("x and y", 2)
           .optional("none")}};
  return table;
}

const KeyTable& period_formula_keys() {
  static const KeyTable table = {
      "building.generic.period_formula",
      "T₁ = coefficient · H^exponent, H in metres",
      {Key::number("coefficient", dimension::none, Range::positive, {"Coefficient", "Koefisien"}),
       Key::number("exponent", dimension::none, Range::positive, {"Exponent", "Eksponen"})}};
  return table;
}

}  // namespace bentur
