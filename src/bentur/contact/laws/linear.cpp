#include "bentur/contact/laws/linear.h"

#include "bentur/core/require.h"

namespace bentur {

Linear::Linear(double stiffness) : stiffness_(stiffness) { require_positive("stiffness", stiffness); }

LawEntry Linear::entry() {
  return {"linear", "k δ", {spring_stiffness()}, {}, [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Linear>(in.number("stiffness"));
          }};
}

Branch Linear::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching, .stiffness = stiffness_}.guarded_by({{.deformation = 1}});
}

double Linear::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : 0.5 * stiffness_ * penetration * penetration;
}

}  // namespace bentur
