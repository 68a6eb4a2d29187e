#include "bentur/io/schema/case_keys.h"

namespace bentur {
namespace {

/// The points of one side of a backbone. @param yield where its stiffness ends. @param storeys of each storey a value
/// of its own may be given
std::vector<Key> points_of_backbone(const Key& yield, bool storeys) {
  std::vector<Key> points = {
      yield,
      Key::number("cap", dimension::none, Range::positive, {"Cap", "Puncak"},
                  "largest force over that at yielding, ≥ 1; above 1 with `plastic_drift`")
          .by_default(1),
      Key::number("plastic_drift", dimension::length, Range::positive, {"Drift to the cap", "Simpangan ke puncak"},
                  "from yielding to the cap: a of ASCE 41")
          .optional("it keeps its strength"),
      Key::number("softening_drift", dimension::length, Range::positive, {"Drift of softening", "Simpangan pelunakan"},
                  "from the cap to where the line that falls from it would come to zero")
          .goes_with("plastic_drift")
          .optional("it keeps the cap"),
      Key::number("residual", dimension::none, Range::ratio, {"Residual strength", "Kekuatan sisa"},
                  "share of the yield force that softening leaves: c of ASCE 41; 0: then it has failed")
          .by_default(0),
      Key::number("ultimate_drift", dimension::length, Range::positive, {"Ultimate drift", "Simpangan batas"},
                  "at which it fails and carries nothing")
          .optional("none")};
  if (!storeys) return points;
  for (Key& point : points) point.for_each("one per storey");
  return points;
}

std::vector<Key> points_of_storeys() {
  return points_of_backbone(
      Key::number("yield", dimension::force, Range::positive_or_infinite, {"Yield force", "Gaya leleh"},
                  "V_y, where the stiffness ends; `inf`: the storey stays elastic"),
      true);
}

Key wear(std::string_view name, Label label, std::string_view doc) {
  return Key::number(name, dimension::none, Range::positive, label, doc).optional("none");
}

Key wear_exponent() {
  return Key::number("wear_exponent", dimension::none, Range::positive, {"Exponent of wear", "Eksponen keausan"},
                     "c, in [1, 2]")
      .by_default(1);
}

}  // namespace

const KeyTable& backbone_side_keys() {
  static const KeyTable table = {"building.stick.backbone.negative", "where drifts are negative", points_of_storeys()};
  return table;
}

const KeyTable& hinge_backbone_keys() {
  static const KeyTable table = {
      "building.frame.section.backbone",
      "hinges that lose strength",
      {Key::number("plastic_rotation", dimension::none, Range::positive, {"Rotation to the cap", "Rotasi ke puncak"},
                   "from yielding to the cap: a of ASCE 41")
           .counted_in("rad"),
       Key::number("softening_rotation", dimension::none, Range::positive,
                   {"Rotation of softening", "Rotasi pelunakan"},
                   "from the cap to where the line that falls from it would come to zero")
           .counted_in("rad")
           .optional("it keeps the cap"),
       Key::number("residual", dimension::none, Range::ratio, {"Residual strength", "Kekuatan sisa"},
                   "share of the yield moment that softening leaves: c of ASCE 41; 0: then it has failed")
           .by_default(0),
       Key::number("ultimate_rotation", dimension::none, Range::positive, {"Ultimate rotation", "Rotasi batas"},
                   "beyond the cap, at which it fails and carries nothing: b of ASCE 41")
           .counted_in("rad")
           .optional("none"),
       wear("strength_wear", {"Wear of strength", "Keausan kekuatan"},
            "γ: strength is lost as γ M_y θ_c are dissipated, M_y the lesser capacity and θ_c `plastic_rotation`"),
       wear_exponent().goes_with("strength_wear")}};
  return table;
}

const KeyTable& infill_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "building.frame.infill",
        "masonry that fills every bay of a storey, as two diagonal struts; an empty table: the storey is open",
        {Key::number("thickness", dimension::length, Range::positive, {"Thickness", "Tebal"},
                     "t of the panel, with `modulus` and `strength`; or")
             .one_of("panel", Need::optional)
             .optional("no infill"),
         Key::number("modulus", dimension::pressure, Range::positive, {"Elastic modulus", "Modulus elastisitas"},
                     "E_me of the masonry")
             .goes_with("thickness")
             .optional("needed with `thickness`"),
         Key::number("strength", dimension::pressure, Range::positive_or_infinite,
                     {"Compressive strength", "Kuat tekan"},
                     "f'_m of the masonry, along its bed joints; `inf`: it is not crushed")
             .goes_with("thickness")
             .optional("needed with `thickness`"),
         Key::number("sliding_strength", dimension::pressure, Range::positive,
                     {"Strength against sliding", "Kuat geser siar"}, "f_v of the bed joints")
             .goes_with("thickness")
             .optional("it does not slide"),
         Key::number("stiffness", dimension::stiffness, Range::positive, {"Stiffness of a panel", "Kekakuan panel"},
                     "storey shear over drift, with `yield`; at most one of `thickness` and this")
             .one_of("panel", Need::optional)
             .optional("no infill")}};
    for (const Key& key : points_of_backbone(
             Key::number("yield", dimension::force, Range::positive_or_infinite, {"Yield force", "Gaya leleh"},
                         "storey shear at which a strut yields; `inf`: it stays elastic")
                 .goes_with("stiffness")
                 .optional("needed with `stiffness`"),
             false)) {
      made.keys.push_back(key);
    }
    return made;
  }();
  return table;
}

const KeyTable& backbone_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"building.stick.backbone", "storeys that lose strength", points_of_storeys()};
    made.keys.push_back(Key::sub_table("negative", backbone_side_keys(), {"Negative drifts", "Simpangan negatif"},
                                       "the same keys where drifts are negative")
                            .optional("the same both ways"));
    made.keys.push_back(
        Key::choice("hysteresis", {"bilinear", "peak-oriented", "pinching"}, {"Reloading", "Pembebanan ulang"})
            .called({{"bilinear", "bilinear"},
                     {"peak-oriented", "berorientasi puncak"},
                     {"pinching", "terjepit (pinching)"}})
            .optional());
    made.keys.push_back(Key::number("pinching_force", dimension::none, Range::restitution,
                                    {"Pinched force", "Gaya terjepit"},
                                    "κ_F, slope of reloading while pinched over that to the peak")
                            .by_default(0.5)
                            .when("hysteresis", {"pinching"}));
    made.keys.push_back(Key::number("pinching_drift", dimension::none, Range::ratio,
                                    {"Pinched drift", "Simpangan terjepit"},
                                    "κ_D: it is pinched up to 1 − κ_D of what the peak would leave when unloaded")
                            .by_default(0.5)
                            .when("hysteresis", {"pinching"}));
    made.keys.push_back(wear("strength_wear", {"Wear of strength", "Keausan kekuatan"},
                             "γ: strength after yielding is lost as γ V_y Δ_y are dissipated"));
    made.keys.push_back(
        wear("cap_wear", {"Wear beyond the cap", "Keausan pasca-puncak"}, "γ of the line that falls from the cap"));
    made.keys.push_back(wear("reloading_wear", {"Wear of reloading", "Keausan pembebanan ulang"},
                             "γ of the peaks that it heads for, which move outward; not of `\"bilinear\"`"));
    made.keys.push_back(
        wear("unloading_wear", {"Wear of unloading", "Keausan pelepasan beban"}, "γ of the stiffness of unloading"));
    made.keys.push_back(wear_exponent());
    return made;
  }();
  return table;
}

}  // namespace bentur
