#include "bentur/contact/linear.h"

#include "bentur/core/require.h"

namespace bentur {

Linear::Linear(double stiffness) : stiffness_(stiffness) { require_positive("stiffness", stiffness); }

double Linear::force(double penetration, double /*closing_speed*/) const noexcept {
  // Written so that a NaN penetration passes through.
  return penetration <= 0 ? 0.0 : stiffness_ * penetration;
}

}  // namespace bentur
