#include "bentur/elements/law.h"

namespace bentur {

double Law::force(const LawState& state, double deformation, double speed) const noexcept {
  const Branch now = branch(state);
  return now.base + now.stiffness * deformation + now.damping * speed;
}

}  // namespace bentur
