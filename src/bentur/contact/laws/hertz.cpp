#include "bentur/contact/laws/hertz.h"

#include <cmath>

#include "bentur/core/require.h"

namespace bentur {

double hertz_force(double stiffness, double penetration) noexcept {
  if (penetration < 0) return 0;
  return stiffness * penetration * std::sqrt(penetration);
}

double hertz_energy(double stiffness, double penetration) noexcept {
  return 0.4 * penetration * hertz_force(stiffness, penetration);
}

Hertz::Hertz(double stiffness) : stiffness_(stiffness) { require_positive("stiffness", stiffness); }

LawEntry Hertz::entry() {
  return {"hertz", "β δ^1.5", {hertz_law_stiffness()}, {}, [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Hertz>(in.number("stiffness"));
          }};
}

Branch Hertz::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}});
}

double Hertz::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch == apart) return ContactLaw::force(state, penetration, closing_speed);
  return hertz_force(stiffness_, penetration) + 0 * closing_speed;
}

double Hertz::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : hertz_energy(stiffness_, penetration);
}

}  // namespace bentur
