#include "bentur/elements/link_laws.h"

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {

SpringDashpot::SpringDashpot(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {
  require_not_negative("stiffness", stiffness);
  require_not_negative("damping", damping);
  if (stiffness == 0 && damping == 0) {
    throw InvalidParameter("stiffness", "0", "must be > 0 where there is no damping: such a link does nothing");
  }
}

Branch SpringDashpot::branch(const LawState& /*state*/) const noexcept {
  return Branch{.stiffness = stiffness_, .damping = damping_};
}

LawState SpringDashpot::next(const LawState& state, std::size_t /*guard*/, double /*time*/, double /*deformation*/,
                             double /*speed*/) const noexcept {
  return state;
}

double SpringDashpot::stored_energy(const LawState& /*state*/, double deformation) const noexcept {
  return 0.5 * stiffness_ * deformation * deformation;
}

Cable::Cable(double stiffness, double slack) : stiffness_(stiffness), slack_(slack) {
  require_positive("stiffness", stiffness);
  require_not_negative("slack", slack);
}

Branch Cable::branch(const LawState& state) const noexcept {
  if (state.branch == 0) return Branch{}.guarded_by({{.constant = slack_, .deformation = 1}});
  return Branch{.base = stiffness_ * slack_, .stiffness = stiffness_}.guarded_by(
      {{.constant = -slack_, .deformation = -1}});
}

LawState Cable::next(const LawState& state, std::size_t /*guard*/, double time, double /*deformation*/,
                     double /*speed*/) const noexcept {
  return {.branch = state.branch == 0 ? 1 : 0, .since = time};
}

double Cable::stored_energy(const LawState& state, double deformation) const noexcept {
  if (state.branch == 0) return 0;
  return 0.5 * stiffness_ * (deformation + slack_) * (deformation + slack_);
}

}  // namespace bentur
