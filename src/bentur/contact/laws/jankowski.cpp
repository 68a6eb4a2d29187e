#include "bentur/contact/laws/jankowski.h"

#include <cmath>

#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/restitution_relations.h"
#include "bentur/core/require.h"

namespace bentur {

Jankowski::Jankowski(double stiffness, double damping_ratio, double effective_mass, std::optional<double> restitution)
    : stiffness_(stiffness), damping_ratio_(damping_ratio), restitution_(restitution) {
  require_positive("stiffness", stiffness);
  require_not_negative("damping_ratio", damping_ratio);
  require_positive("effective_mass", effective_mass);
  damping_ = 2 * damping_ratio * std::sqrt(stiffness) * std::sqrt(effective_mass);
}

LawEntry Jankowski::entry() {
  return {"jankowski",
          "β δ^1.5 + 2ξ√(β√δ m_e) δ̇ while closing, β δ^1.5 after",
          {hertz_law_stiffness(), asked_restitution(), asked_damping_ratio()},
          {exact_or_published()},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            const auto asked = in.optional_number("restitution");
            const double ratio = !asked ? in.number("damping_ratio")
                                 : in.word(exact_or_published()) == "published"
                                     ? published::jankowski_damping_ratio(*asked)
                                     : exact_approach_damping_ratio(*asked, 1.5);
            return std::make_shared<Jankowski>(in.number("stiffness"), ratio, in.effective_mass, asked);
          }};
}

LawParameters Jankowski::parameters() const {
  LawParameters list = {{"stiffness", stiffness_}};
  if (restitution_) list.emplace_back("restitution", *restitution_);
  list.emplace_back("damping_ratio", damping_ratio_);
  return list;
}

Branch Jankowski::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  const double sense = state.branch == closing ? 1 : -1;
  return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}, {.speed = sense}});
}

double Jankowski::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch == apart) return ContactLaw::force(state, penetration, closing_speed);
  const double spring = hertz_force(stiffness_, penetration) + 0 * closing_speed;
  if (state.branch == rebound || penetration < 0) return spring;
  return spring + damping_ * std::sqrt(std::sqrt(penetration)) * closing_speed;
}

double Jankowski::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : hertz_energy(stiffness_, penetration);
}

}  // namespace bentur
