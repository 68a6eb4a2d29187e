#include "bentur/contact/laws.h"

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/filler.h"
#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/jankowski.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"

namespace bentur {

Key spring_stiffness() {
  return Key::number("stiffness", dimension::stiffness, Range::positive, {"Contact stiffness", "Kekakuan kontak"},
                     "k; of `\"axial\"`, between two frames, 1/k = 1/K₁ + 1/K₂ with K = EA/(L/2) of the floor beams "
                     "next to the gap, in plan of all frames across the joint together")
      .for_each("one per contact point")
      .or_one_of({"axial"})
      .called({{"axial, of the floor beams next to the gap", "aksial, dari balok lantai di sisi celah"}});
}

Key hertz_law_stiffness() {
  return Key::number("stiffness", dimension::hertz_stiffness, Range::positive, {"Contact stiffness", "Kekakuan kontak"},
                     "β of Hertz's laws")
      .for_each("one per contact point");
}

Key asked_restitution() {
  return Key::number("restitution", dimension::none, Range::restitution, {"Restitution", "Restitusi"},
                     "e, the separation speed of a free impact over its closing speed")
      .for_each("one per contact point")
      .one_of("damping of the contact");
}

Key asked_damping_ratio() {
  return Key::number("damping_ratio", dimension::none, Range::not_negative, {"Damping ratio", "Rasio redaman"},
                     "ξ; below 1 with `release = \"separation\"`")
      .for_each("one per contact point")
      .one_of("damping of the contact");
}

const Key& exact_or_published() {
  static const Key choice =
      Key::choice("calibration", {"exact", "published"}, {"Calibration", "Kalibrasi"},
                  "how the law's parameter follows from `restitution`: so that a free impact has just this, or by a "
                  "formula of the literature")
          .called({{"exact", "eksak"}, {"published", "menurut publikasi"}})
          .optional()
          .goes_with("restitution");
  return choice;
}

const std::vector<LawEntry>& contact_laws() {
  static const std::vector<LawEntry> laws = {
      Linear::entry(), KelvinVoigt::entry(), KelvinVoigtApproach::entry(), Darmawan::entry(),
      Hertz::entry(),  HertzDamp::entry(),   Jankowski::entry(),           Bilinear::entry(),
      Filler::entry(), Restitution::entry(),
  };
  return laws;
}

const LawEntry* find_law(std::string_view name) { return find_entry(contact_laws(), name); }

}  // namespace bentur
