#include "bentur/elements/link_laws.h"

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/kinematic_hardening.h"

namespace bentur {

SpringDashpot::SpringDashpot(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {
  require_not_negative("stiffness", stiffness);
  require_not_negative("damping", damping);
  if (stiffness == 0 && damping == 0) {
    throw InvalidParameter("stiffness", "0", "must be > 0 where there is no damping: such a link does nothing");
  }
}

LawEntryOf<Law> SpringDashpot::entry() {
  return {"spring-dashpot",
          "k δ + c δ̇",
          {Key::number("stiffness", dimension::stiffness, Range::not_negative, {"Stiffness", "Kekakuan"}, "k")
               .for_each("one per elevation")
               .by_default(0),
           Key::number("damping", dimension::dashpot, Range::not_negative, {"Damping", "Redaman"},
                       "c; at no elevation both zero")
               .for_each("one per elevation")
               .by_default(0)},
          {},
          [](const LawInput& in) -> std::shared_ptr<const Law> {
            return std::make_shared<SpringDashpot>(in.number("stiffness"), in.number("damping"));
          },
          {"spring and dashpot", "pegas dan peredam"}};
}

Branch SpringDashpot::branch(const LawState& /*state*/) const noexcept {
  return Branch{.stiffness = stiffness_, .damping = damping_};
}

LawState SpringDashpot::next(const LawState& state, std::size_t /*guard*/, double /*time*/, double /*deformation*/,
                             double /*speed*/) const noexcept {
  return state;
}

double SpringDashpot::stored_energy(const LawState& /*state*/, double deformation) const noexcept {
  return 0.5 * stiffness_ * deformation * deformation;
}

Cable::Cable(double stiffness, double slack) : stiffness_(stiffness), slack_(slack) {
  require_positive("stiffness", stiffness);
  require_not_negative("slack", slack);
}

LawEntryOf<Law> Cable::entry() {
  return {"cable",
          "pulls with k (−δ − slack) once the buildings are `slack` further apart than at rest",
          {Key::number("stiffness", dimension::stiffness, Range::positive, {"Stiffness", "Kekakuan"}, "k")
               .for_each("one per elevation"),
           Key::number("slack", dimension::length, Range::not_negative, {"Slack", "Kelonggaran"}, "before it pulls")
               .for_each("one per elevation")
               .by_default(0)},
          {},
          [](const LawInput& in) -> std::shared_ptr<const Law> {
            return std::make_shared<Cable>(in.number("stiffness"), in.number("slack"));
          },
          {"cable", "kabel"}};
}

Branch Cable::branch(const LawState& state) const noexcept {
  if (state.branch == 0) return Branch{}.guarded_by({{.constant = slack_, .deformation = 1}});
  return Branch{.base = stiffness_ * slack_, .stiffness = stiffness_}.guarded_by(
      {{.constant = -slack_, .deformation = -1}});
}

LawState Cable::next(const LawState& state, std::size_t /*guard*/, double time, double /*deformation*/,
                     double /*speed*/) const noexcept {
  return {.branch = state.branch == 0 ? 1 : 0, .since = time};
}

double Cable::stored_energy(const LawState& state, double deformation) const noexcept {
  if (state.branch == 0) return 0;
  return 0.5 * stiffness_ * (deformation + slack_) * (deformation + slack_);
}

LawEntryOf<Law> yielding_link_entry() {
  return {"yielding",
          "bilinear, as a storey that yields; a friction damper has `hardening = 0`",
          {Key::number("stiffness", dimension::stiffness, Range::positive, {"Stiffness", "Kekakuan"}, "before yielding")
               .for_each("one per elevation"),
           Key::number("yield_force", dimension::force, Range::positive, {"Yield force", "Gaya leleh"},
                       "at which it yields")
               .for_each("one per elevation"),
           Key::number("hardening", dimension::none, Range::ratio, {"Hardening", "Pengerasan"},
                       "stiffness after yielding over that before")
               .for_each("one per elevation")
               .by_default(0)},
          {},
          [](const LawInput& in) -> std::shared_ptr<const Law> {
            return std::make_shared<KinematicHardening>(in.number("stiffness"), in.number("yield_force"),
                                                        in.number("hardening"));
          },
          {"yielding", "leleh"}};
}

}  // namespace bentur
