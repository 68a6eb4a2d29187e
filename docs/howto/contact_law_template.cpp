#include "bentur/contact/laws/hardening_spring.h"

#include "bentur/core/require.h"

namespace bentur {

HardeningSpring::HardeningSpring(double stiffness, double hardening) : stiffness_(stiffness), hardening_(hardening) {
  require_positive("stiffness", stiffness);  // by the name of the key in a case
  require_not_negative("hardening", hardening);
}

LawEntry HardeningSpring::entry() {
  return {"hardening-spring",
          "k δ + k₃ δ³",
          {spring_stiffness(),
           Key::number("hardening", {-3, 1, 0}, Range::not_negative, {"Hardening", "Pengerasan"}, "k₃ of k δ + k₃ δ³")
               .for_each("one per contact point")},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<HardeningSpring>(in.number("stiffness"), in.number("hardening"));
          }};
}

LawParameters HardeningSpring::parameters() const { return {{"stiffness", stiffness_}, {"hardening", hardening_}}; }

Branch HardeningSpring::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}});
}

double HardeningSpring::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch == apart) return ContactLaw::force(state, penetration, closing_speed);
  const double spring = (stiffness_ + hardening_ * penetration * penetration) * penetration;
  return spring + 0 * closing_speed;  // NaN in, NaN out
}

double HardeningSpring::stored_energy(const LawState& state, double penetration) const noexcept {
  const double square = penetration * penetration;
  return state.branch == apart ? 0.0 : (0.5 * stiffness_ + 0.25 * hardening_ * square) * square;
}

}  // namespace bentur
