#include "bentur/contact/laws/filler.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {

Filler::Filler(double crushing_force, double thickness, double crushing_strain, double locking_strain,
               double locked_stiffness)
    : crushing_force_(crushing_force),
      thickness_(thickness),
      crushing_strain_(crushing_strain),
      locking_strain_(locking_strain),
      locked_stiffness_(locked_stiffness),
      elastic_part_(crushing_strain * thickness),
      locking_(locking_strain * thickness),
      most_crushed_(locking_ - elastic_part_),
      stiffness_(crushing_force / elastic_part_) {
  require_positive("crushing_force", crushing_force);
  require_positive("thickness", thickness);
  require_positive("crushing_strain", crushing_strain);
  require_positive("locked_stiffness", locked_stiffness);
  if (!(locking_strain < 1) || !(locking_strain > crushing_strain)) {
    throw InvalidParameter("locking_strain", fmt::format("{}", locking_strain),
                           fmt::format("must be in ({}, 1), above the crushing strain", crushing_strain));
  }
  if (locked_stiffness < stiffness_) {
    throw InvalidParameter("locked_stiffness", fmt::format("{}", locked_stiffness),
                           fmt::format("must be >= {}, the stiffness before crushing, crushing_force / "
                                       "(crushing_strain thickness)",
                                       stiffness_));
  }
}

LawEntry Filler::entry() {
  return {"filler",
          "crushable foam: elastic, F_c while it is crushed, locked from ε_L t on; what is crushed stays so. `width` "
          "is what is free beside it",
          {Key::number("crushing_force", dimension::force, Range::positive, {"Crushing force", "Gaya remuk"},
                       "F_c, the strength of the foam times the area that is pressed")
               .for_each("one per contact point"),
           Key::number("thickness", dimension::length, Range::positive, {"Thickness", "Tebal"},
                       "t, of the foam as it was put in")
               .for_each("one per contact point"),
           Key::number("crushing_strain", dimension::none, Range::share, {"Crushing strain", "Regangan mulai remuk"},
                       "ε_c, where crushing begins")
               .for_each("one per contact point"),
           Key::number("locking_strain", dimension::none, Range::share, {"Locking strain", "Regangan memadat"},
                       "ε_L, where the cells are closed and crushing ends; above `crushing_strain`")
               .for_each("one per contact point"),
           Key::number("locked_stiffness", dimension::stiffness, Range::positive,
                       {"Locked stiffness", "Kekakuan padat"}, "k_L beyond it; at least F_c/(ε_c t)")
               .for_each("one per contact point")},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Filler>(in.number("crushing_force"), in.number("thickness"),
                                            in.number("crushing_strain"), in.number("locking_strain"),
                                            in.number("locked_stiffness"));
          }};
}

LawParameters Filler::parameters() const {
  return {{"crushing_force", crushing_force_},
          {"thickness", thickness_},
          {"crushing_strain", crushing_strain_},
          {"locking_strain", locking_strain_},
          {"locked_stiffness", locked_stiffness_}};
}

Branch Filler::branch(const LawState& state) const noexcept {
  const double crushed_part = state.memory[0];  // p
  switch (state.branch) {
    case apart:
      return Branch::apart();
    case crushing:
      return Branch{.bodies = Bodies::touching, .base = crushing_force_}.guarded_by(
          {{.speed = 1}, {.constant = locking_, .deformation = -1}});
    case locked:
      return Branch{.bodies = Bodies::touching,
                    .base = crushing_force_ - locked_stiffness_ * locking_,
                    .stiffness = locked_stiffness_}
          .guarded_by({{.constant = -locking_, .deformation = 1}});
    case crushed:
      return Branch{.bodies = Bodies::apart}.guarded_by({{.constant = crushed_part, .deformation = -1}});
    default:
      break;
  }
  return Branch{.bodies = Bodies::touching, .base = -stiffness_ * crushed_part, .stiffness = stiffness_}.guarded_by(
      {{.constant = -crushed_part, .deformation = 1}, {.constant = crushed_part + elastic_part_, .deformation = -1}});
}

LawState Filler::next(const LawState& state, std::size_t guard, double time, double penetration,
                      double closing_speed) const noexcept {
  LawState after = {.since = time, .closing_speed = state.closing_speed, .memory = state.memory};
  double& crushed_part = after.memory[0];
  switch (state.branch) {
    case apart:
    case crushed:
      after.branch = elastic;
      after.closing_speed = closing_speed;
      break;
    case crushing:
      after.branch = guard == 0 ? elastic : locked;
      crushed_part = guard == 0 ? std::clamp(penetration - elastic_part_, crushed_part, most_crushed_) : most_crushed_;
      break;
    case locked:
      after.branch = elastic;
      break;
    default:
      if (guard == 1) {
        after.branch = crushed_part < most_crushed_ ? crushing : locked;
      } else {
        after.branch = crushed_part > 0 ? crushed : apart;
        after.closing_speed = 0;
      }
  }
  return after;
}

double Filler::stored_energy(const LawState& state, double penetration) const noexcept {
  const double elastic_energy = 0.5 * crushing_force_ * elastic_part_;
  const double beyond = penetration - locking_, compressed = penetration - state.memory[0];
  switch (state.branch) {
    case elastic:
      return 0.5 * stiffness_ * compressed * compressed;
    case crushing:
      return elastic_energy;
    case locked:
      return elastic_energy + (crushing_force_ + 0.5 * locked_stiffness_ * beyond) * beyond;
    default:
      return 0;
  }
}

}  // namespace bentur
