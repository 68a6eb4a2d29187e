#include "bentur/contact/laws/kelvin_voigt_approach.h"

#include <cmath>

#include "bentur/contact/restitution_relations.h"
#include "bentur/core/require.h"

namespace bentur {

KelvinVoigtApproach::KelvinVoigtApproach(double stiffness, double damping_ratio, double effective_mass,
                                         std::optional<double> restitution)
    : stiffness_(stiffness), damping_ratio_(damping_ratio), restitution_(restitution) {
  require_positive("stiffness", stiffness);
  require_not_negative("damping_ratio", damping_ratio);
  require_positive("effective_mass", effective_mass);
  damping_ = 2 * damping_ratio * std::sqrt(stiffness) * std::sqrt(effective_mass);
}

LawEntry KelvinVoigtApproach::entry() {
  return {"kelvin-voigt-approach",
          "k δ + c δ̇ while closing, k δ after",
          {spring_stiffness(), asked_restitution(), asked_damping_ratio()},
          {exact_or_published()},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            const auto asked = in.optional_number("restitution");
            const double ratio = !asked ? in.number("damping_ratio")
                                 : in.word(exact_or_published()) == "published"
                                     ? published::mahmoud_jankowski_damping_ratio(*asked)
                                     : exact_approach_damping_ratio(*asked, 1);
            return std::make_shared<KelvinVoigtApproach>(in.number("stiffness"), ratio, in.effective_mass, asked);
          }};
}

LawParameters KelvinVoigtApproach::parameters() const {
  LawParameters list = {{"stiffness", stiffness_}};
  if (restitution_) list.emplace_back("restitution", *restitution_);
  list.emplace_back("damping_ratio", damping_ratio_);
  list.emplace_back("damping", damping_);
  return list;
}

Branch KelvinVoigtApproach::branch(const LawState& state) const noexcept {
  switch (state.branch) {
    case apart:
      return Branch::apart();
    case closing:
      return Branch{.bodies = Bodies::touching, .stiffness = stiffness_, .damping = damping_}.guarded_by(
          {{.deformation = 1}, {.speed = 1}});
    default:
      return Branch{.bodies = Bodies::touching, .stiffness = stiffness_}.guarded_by(
          {{.deformation = 1}, {.speed = -1}});
  }
}

double KelvinVoigtApproach::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : 0.5 * stiffness_ * penetration * penetration;
}

}  // namespace bentur
