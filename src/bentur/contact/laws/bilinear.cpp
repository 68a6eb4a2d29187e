#include "bentur/contact/laws/bilinear.h"

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {

Bilinear::Bilinear(double stiffness, double second_stiffness, double yield_penetration)
    : stiffness_(stiffness),
      second_stiffness_(second_stiffness),
      yield_penetration_(yield_penetration),
      plastic_stiffness_(stiffness - second_stiffness),
      limit_(plastic_stiffness_ * yield_penetration) {
  require_positive("stiffness", stiffness);
  require_positive("second_stiffness", second_stiffness);
  if (second_stiffness > stiffness) {
    throw InvalidParameter("second_stiffness", fmt::format("{}", second_stiffness),
                           fmt::format("must be in (0, {}], at most the stiffness", stiffness));
  }
  require_positive("yield_penetration", yield_penetration);
}

LawEntry Bilinear::entry() {
  return {"bilinear",
          "slope k₁ up to δ_y, k₂ beyond; unloads along k₁ down to k₂ δ",
          {spring_stiffness(),
           Key::number("second_stiffness", dimension::stiffness, Range::positive,
                       {"Second stiffness", "Kekakuan kedua"}, "k₂, at most `stiffness`")
               .for_each("one per contact point"),
           Key::number("yield_penetration", dimension::length, Range::positive,
                       {"Penetration at yield", "Penetrasi saat leleh"}, "δ_y")
               .for_each("one per contact point")},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Bilinear>(in.number("stiffness"), in.number("second_stiffness"),
                                              in.number("yield_penetration"));
          }};
}

LawParameters Bilinear::parameters() const {
  return {
      {"stiffness", stiffness_}, {"second_stiffness", second_stiffness_}, {"yield_penetration", yield_penetration_}};
}

Branch Bilinear::branch(const LawState& state) const noexcept {
  const Guard surface = {.deformation = 1};
  switch (state.branch) {
    case apart:
      return Branch::apart();
    case yielding:
      return Branch{.bodies = Bodies::touching, .base = limit_, .stiffness = second_stiffness_}.guarded_by(
          {surface, {.speed = 1}});
    case on_the_line:
      return Branch{.bodies = Bodies::touching, .stiffness = second_stiffness_}.guarded_by({surface, {.speed = -1}});
    default:
      break;
  }
  const Branch closed = {.bodies = Bodies::touching, .base = state.memory[0], .stiffness = stiffness_};
  if (plastic_stiffness_ == 0) return closed.guarded_by({surface});
  const Guard below_limit = {.constant = limit_ - state.memory[0], .deformation = -plastic_stiffness_};
  if (state.memory[0] == 0) return closed.guarded_by({surface, below_limit});  // here f = 0 only where δ = 0
  return closed.guarded_by({surface, below_limit, {.constant = state.memory[0], .deformation = plastic_stiffness_}});
}

LawState Bilinear::next(const LawState& state, std::size_t guard, double time, double penetration,
                        double closing_speed) const noexcept {
  if (state.branch == apart) return {.branch = elastic, .since = time, .closing_speed = closing_speed};
  if (guard == 0) return {.since = time};
  LawState after = {.since = time, .closing_speed = state.closing_speed};
  if (state.branch == elastic) {
    after.branch = guard == 1 ? yielding : on_the_line;
  } else {
    after.branch = elastic;
    after.memory[0] = (state.branch == yielding ? limit_ : 0) - plastic_stiffness_ * penetration;
  }
  return after;
}

double Bilinear::stored_energy(const LawState& state, double penetration) const noexcept {
  if (state.branch == apart) return 0;
  double plastic = 0;  // f
  if (state.branch == yielding) plastic = limit_;
  if (state.branch == elastic) plastic = state.memory[0] + plastic_stiffness_ * penetration;
  const double plastic_energy = plastic_stiffness_ > 0 ? 0.5 * plastic * plastic / plastic_stiffness_ : 0;
  return 0.5 * second_stiffness_ * penetration * penetration + plastic_energy;
}

}  // namespace bentur
