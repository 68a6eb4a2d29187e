#include "docs/howto/origin_oriented.h"

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {

OriginOriented::OriginOriented(double stiffness, double yield_force, double hardening)
    : stiffness_(stiffness), yield_force_(yield_force), hardening_(hardening) {
  require_positive("stiffness", stiffness);  // by the name of the key in a case
  require_positive("yield_force", yield_force);
  if (!(hardening >= 0 && hardening < 1)) {
    throw InvalidParameter("hardening", fmt::format("{}", hardening), "must be in [0, 1)");
  }
}

LawParameters OriginOriented::parameters() const {
  return {{"stiffness", stiffness_}, {"yield_force", yield_force_}, {"hardening", hardening_}};
}

Branch OriginOriented::branch(const LawState& state) const noexcept {
  const double yield = yield_deformation();
  if (state.branch == virgin) {
    return Branch{.stiffness = stiffness_}.guarded_by(
        {{.constant = yield, .deformation = -1}, {.constant = yield, .deformation = 1}});
  }
  const double side = state.branch == backbone_above || state.branch == line_above ? 1 : -1;
  const double tangent = hardening_ * stiffness_;
  if (state.branch == backbone_above || state.branch == backbone_below) {
    return Branch{.base = side * (yield_force_ - tangent * yield), .stiffness = tangent}.guarded_by({{.speed = side}});
  }
  const double extreme = side * state.memory[side > 0 ? 0 : 1];  // its size
  const double slope = (yield_force_ + tangent * (extreme - yield)) / extreme;
  return Branch{.stiffness = slope}.guarded_by({{.constant = extreme, .deformation = -side}, {.deformation = side}});
}

LawState OriginOriented::next(const LawState& state, std::size_t guard, double time, double deformation,
                              double /*speed*/) const noexcept {
  const double yield = yield_deformation();
  if (state.branch == virgin) {
    return {.branch = guard == 0 ? backbone_above : backbone_below, .since = time, .memory = {yield, -yield}};
  }
  const bool above = state.branch == backbone_above || state.branch == line_above;
  LawState after = {.since = time, .memory = state.memory};
  if (state.branch == backbone_above || state.branch == backbone_below) {  // it turns
    after.branch = above ? line_above : line_below;
    after.memory[above ? 0 : 1] = deformation;
  } else if (guard == 0) {  // the extreme point is reached
    after.branch = above ? backbone_above : backbone_below;
  } else {  // the origin is
    after.branch = above ? line_below : line_above;
  }
  return after;
}

double OriginOriented::stored_energy(const LawState& state, double deformation) const noexcept {
  return 0.5 * force(state, deformation, 0) * deformation;
}

double OriginOriented::residual(const LawState& /*state*/, double /*deformation*/) const noexcept { return 0; }

}  // namespace bentur
