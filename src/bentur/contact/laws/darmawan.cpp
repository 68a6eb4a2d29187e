#include "bentur/contact/laws/darmawan.h"

#include "bentur/core/require.h"

namespace bentur {

Darmawan::Darmawan(double stiffness, double alpha) : stiffness_(stiffness), alpha_(alpha) {
  require_positive("stiffness", stiffness);
  require_not_negative("alpha", alpha);
}

LawEntry Darmawan::entry() {
  return {"darmawan",
          "k δ (1 + α δ̇)",
          {spring_stiffness(), Key::number("alpha", dimension::slowness, Range::not_negative,
                                           {"Damping coefficient α", "Koefisien redaman α"}, "α")
                                   .for_each("one per contact point")},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Darmawan>(in.number("stiffness"), in.number("alpha"));
          }};
}

Branch Darmawan::branch(const LawState& state) const noexcept {
  switch (state.branch) {
    case apart:
      return Branch::apart();
    case cut:
      return Branch{.bodies = Bodies::touching}.guarded_by({{.deformation = 1}, {.constant = -1, .speed = -alpha_}});
    default:
      if (alpha_ == 0)
        return Branch{.bodies = Bodies::touching, .stiffness = stiffness_}.guarded_by({{.deformation = 1}});
      return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by(
          {{.deformation = 1}, {.constant = 1, .speed = alpha_}});
  }
}

double Darmawan::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch != pushing) return ContactLaw::force(state, penetration, closing_speed);
  return stiffness_ * penetration * (1 + alpha_ * closing_speed);
}

double Darmawan::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : 0.5 * stiffness_ * penetration * penetration;
}

}  // namespace bentur
