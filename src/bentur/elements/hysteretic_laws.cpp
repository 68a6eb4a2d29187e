#include "bentur/elements/hysteretic_laws.h"

#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/peak_oriented.h"

namespace bentur {

const std::vector<LawEntryOf<HystereticLaw>>& hysteretic_laws() {
  static const std::vector<LawEntryOf<HystereticLaw>> laws = {KinematicHardening::entry(), PeakOriented::entry()};
  return laws;
}

}  // namespace bentur
