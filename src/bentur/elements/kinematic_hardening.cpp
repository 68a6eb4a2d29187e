#include "bentur/elements/kinematic_hardening.h"

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {

KinematicHardening::KinematicHardening(double stiffness, double yield_force, double hardening)
    : stiffness_(stiffness), yield_force_(yield_force), hardening_(hardening) {
  require_positive("stiffness", stiffness);
  require_positive("yield_force", yield_force);
  if (!(hardening >= 0 && hardening < 1)) {
    throw InvalidParameter("hardening", fmt::format("{}", hardening), "must be in [0, 1)");
  }
  plastic_ = (1 - hardening) * stiffness;
  limit_ = (1 - hardening) * yield_force;
}

LawEntryOf<HystereticLaw> KinematicHardening::entry() {
  return {"bilinear",
          "kinematic hardening",
          {},
          {},
          [](const LawInput& in) -> std::shared_ptr<const HystereticLaw> {
            return std::make_shared<KinematicHardening>(in.number("stiffness"), in.number("yield_force"),
                                                        in.number("hardening"));
          },
          {"bilinear, kinematic hardening", "bilinear, pengerasan kinematik"}};
}

LawParameters KinematicHardening::parameters() const {
  return {{"stiffness", stiffness_}, {"yield_force", yield_force_}, {"hardening", hardening_}};
}

Branch KinematicHardening::branch(const LawState& state) const noexcept {
  const double tangent = hardening_ * stiffness_;
  if (state.branch == upper) return Branch{.base = limit_, .stiffness = tangent}.guarded_by({{.speed = 1}});
  if (state.branch == lower) return Branch{.base = -limit_, .stiffness = tangent}.guarded_by({{.speed = -1}});
  // Elastic between both lines, |(1 − r) k Δ − k p| ≤ (1 − r) V_y, told as lengths.
  const double yield = yield_force_ / stiffness_;
  const double centre = stiffness_ * state.memory[0] / plastic_;
  return Branch{.base = -stiffness_ * state.memory[0], .stiffness = stiffness_}.guarded_by(
      {{.constant = yield + centre, .deformation = -1}, {.constant = yield - centre, .deformation = 1}});
}

LawState KinematicHardening::next(const LawState& state, std::size_t guard, double time, double deformation,
                                  double /*speed*/) const noexcept {
  if (state.branch == elastic) return {.branch = guard == 0 ? upper : lower, .since = time};
  const double offset = (plastic_ * deformation - (state.branch == upper ? limit_ : -limit_)) / stiffness_;
  return {.branch = elastic, .since = time, .memory = {offset}};
}

double KinematicHardening::stored_energy(const LawState& state, double deformation) const noexcept {
  const double hardened = hardening_ * stiffness_ * deformation;
  const double rest = force(state, deformation, 0) - hardened;
  return 0.5 * hardened * deformation + 0.5 * rest * rest / plastic_;
}

double KinematicHardening::residual(const LawState& state, double deformation) const noexcept {
  if (state.branch == elastic) return state.memory[0];
  return deformation - force(state, deformation, 0) / stiffness_;
}

}  // namespace bentur
