#include "bentur/contact/law.h"

namespace bentur {

double ContactLaw::force(const ContactState& state, double penetration, double closing_speed) const noexcept {
  const Branch now = branch(state);
  return now.base + now.stiffness * penetration + now.damping * closing_speed;
}

}  // namespace bentur
