#include "bentur/io/schema/case_keys.h"

namespace bentur {
namespace {

/// The points of one side of a backbone.
std::vector<Key> points_of_backbone() {
  constexpr std::string_view each = "one per storey";
  return {
      Key::number("yield", dimension::force, Range::positive_or_infinite, {"Yield force", "Gaya leleh"},
                  "V_y, where the stiffness ends; `inf`: the storey stays elastic")
          .for_each(each),
      Key::number("cap", dimension::none, Range::positive, {"Cap", "Puncak"},
                  "largest force over V_y, ≥ 1; above 1 with `plastic_drift`")
          .for_each(each)
          .by_default(1),
      Key::number("plastic_drift", dimension::length, Range::positive, {"Drift to the cap", "Simpangan ke puncak"},
                  "from yielding to the cap: a of ASCE 41")
          .for_each(each)
          .optional("it keeps V_y"),
      Key::number("softening_drift", dimension::length, Range::positive, {"Drift of softening", "Simpangan pelunakan"},
                  "from the cap to where the line that falls from it would come to zero")
          .for_each(each)
          .goes_with("plastic_drift")
          .optional("it keeps the cap"),
      Key::number("residual", dimension::none, Range::ratio, {"Residual strength", "Kekuatan sisa"},
                  "share of V_y that softening leaves: c of ASCE 41; 0: what has come down to it has failed")
          .for_each(each)
          .by_default(0),
      Key::number("ultimate_drift", dimension::length, Range::positive, {"Ultimate drift", "Simpangan batas"},
                  "at which it fails and bears nothing any more")
          .for_each(each)
          .optional("none")};
}

Key wear(std::string_view name, Label label, std::string_view doc) {
  return Key::number(name, dimension::none, Range::positive, label, doc).optional("none");
}

}  // namespace

const KeyTable& backbone_side_keys() {
  static const KeyTable table = {"building.stick.backbone.negative", "where drifts are negative", points_of_backbone()};
  return table;
}

const KeyTable& backbone_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"building.stick.backbone", "storeys that lose strength", points_of_backbone()};
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
    made.keys.push_back(Key::number("wear_exponent", dimension::none, Range::positive,
                                    {"Exponent of wear", "Eksponen keausan"}, "c, in [1, 2]")
                            .by_default(1));
    return made;
  }();
  return table;
}

}  // namespace bentur
