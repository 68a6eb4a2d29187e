#include "bentur/elements/peak_oriented.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

// A side is +1 or −1: everything below is told for the upper side and mirrored by it.
enum : int { origin, backbone_up, backbone_down, unloading_above, unloading_below, heading_up, heading_down };

double side_of(int branch) {
  return branch == backbone_up || branch == unloading_above || branch == heading_up ? 1.0 : -1.0;
}
int backbone_of(double side) { return side > 0 ? backbone_up : backbone_down; }
int unloading_of(double side) { return side > 0 ? unloading_above : unloading_below; }
int heading_of(double side) { return side > 0 ? heading_up : heading_down; }

}  // namespace

struct PeakOriented::Past {
  double upper, lower;        ///< Δ of the extreme points [length]
  double deformation, force;  ///< of the point that the line goes through: Δ_u, V_u
  [[nodiscard]] double extreme(double side) const { return side > 0 ? upper : lower; }
  [[nodiscard]] decltype(LawState::memory) memory() const { return {upper, lower, deformation, force}; }
};

PeakOriented::PeakOriented(double stiffness, double yield_force, double hardening, double unloading_exponent)
    : stiffness_(stiffness), yield_force_(yield_force), hardening_(hardening), exponent_(unloading_exponent) {
  require_positive("stiffness", stiffness);
  require_positive("yield_force", yield_force);
  if (!(hardening >= 0 && hardening < 1)) {
    throw InvalidParameter("hardening", fmt::format("{}", hardening), "must be in [0, 1)");
  }
  if (!(unloading_exponent >= 0 && unloading_exponent <= 1)) {
    throw InvalidParameter("unloading_exponent", fmt::format("{}", unloading_exponent), "must be in [0, 1]");
  }
  yield_ = yield_force / stiffness;
}

LawEntryOf<HystereticLaw> PeakOriented::entry() {
  return {"peak-oriented",
          "unloads, then heads for the largest drift so far (concrete)",
          {Key::number("unloading_exponent", dimension::none, Range::share,
                       {"Unloading exponent", "Eksponen pelepasan beban"},
                       "it unloads with k (Δ_y/Δ_max)^a, a this exponent")
               .by_default(0)},
          {},
          [](const LawInput& in) -> std::shared_ptr<const HystereticLaw> {
            return std::make_shared<PeakOriented>(in.number("stiffness"), in.number("yield_force"),
                                                  in.number("hardening"), in.number("unloading_exponent"));
          },
          {"peak-oriented", "berorientasi puncak"}};
}

LawParameters PeakOriented::parameters() const {
  return {{"stiffness", stiffness_},
          {"yield_force", yield_force_},
          {"hardening", hardening_},
          {"unloading_exponent", exponent_}};
}

PeakOriented::Past PeakOriented::past(const LawState& state) const noexcept {
  if (state.branch == origin) return {yield_, -yield_, 0, 0};
  return {state.memory[0], state.memory[1], state.memory[2], state.memory[3]};
}

/// V at Δ on the backbone of a side.
double PeakOriented::backbone(double side, double deformation) const noexcept {
  return side * yield_force_ + hardening_ * stiffness_ * (deformation - side * yield_);
}

double PeakOriented::unloading_stiffness(double side, double extreme) const noexcept {
  const double softened = exponent_ == 0 ? stiffness_ : stiffness_ * std::pow(yield_ / std::abs(extreme), exponent_);
  return std::max(softened, backbone(side, extreme) / extreme);
}

double PeakOriented::stiffness_back(const LawState& state, double deformation, double force) const noexcept {
  if (state.branch == origin) return stiffness_;
  const double side = force < 0 ? -1.0 : 1.0;
  const double extreme = past(state).extreme(side);
  // The backbone takes its extreme along; what is remembered lags behind.
  return unloading_stiffness(
      side, state.branch == backbone_of(side) ? side * std::max(side * extreme, side * deformation) : extreme);
}

Branch PeakOriented::branch(const LawState& state) const noexcept {
  if (state.branch == origin) {
    return Branch{.stiffness = stiffness_}.guarded_by(
        {{.constant = yield_, .deformation = -1}, {.constant = yield_, .deformation = 1}});
  }
  const double side = side_of(state.branch);
  const Past at = past(state);
  const Guard outward = {.speed = side};
  if (state.branch == backbone_of(side)) {
    const double slope = hardening_ * stiffness_;
    return Branch{.base = side * (yield_force_ - slope * yield_), .stiffness = slope}.guarded_by({outward});
  }
  if (state.branch == unloading_of(side)) {
    const double slope = unloading_stiffness(side, at.extreme(side));
    const double rest = at.deformation - at.force / slope;  // Δ₀
    return Branch{.base = -slope * rest, .stiffness = slope}.guarded_by(
        {{.constant = side * at.deformation, .deformation = -side}, {.constant = -side * rest, .deformation = side}});
  }
  const double extreme = at.extreme(side);
  // Between 0 and the slope of unloading, but for round-off of a line that has hardly a length.
  const double slope = std::clamp((backbone(side, extreme) - at.force) / (extreme - at.deformation), 0.0,
                                  unloading_stiffness(side, extreme));
  return Branch{.base = at.force - slope * at.deformation, .stiffness = slope}.guarded_by(
      {{.constant = side * extreme, .deformation = -side}, outward});
}

LawState PeakOriented::next(const LawState& state, std::size_t guard, double time, double deformation,
                            double speed) const noexcept {
  Past at = past(state);
  if (state.branch == origin) {
    return {.branch = guard == 0 ? backbone_up : backbone_down, .since = time, .memory = at.memory()};
  }
  const double side = side_of(state.branch);
  const bool unloading = state.branch == unloading_of(side);
  if (state.branch == heading_of(side) && guard == 0) {  // the extreme point is reached
    return {.branch = backbone_of(side), .since = time, .memory = at.memory()};
  }
  if (!unloading) {  // a reversal
    const double force = this->force(state, deformation, speed);
    if (state.branch == backbone_of(side)) (side > 0 ? at.upper : at.lower) = deformation;
    const double of_force = force == 0 ? side : force < 0 ? -1.0 : 1.0;
    at.deformation = deformation;
    at.force = force;
    return {.branch = unloading_of(of_force), .since = time, .memory = at.memory()};
  }
  if (guard == 0) {  // back where the unloading began
    const bool from_backbone = side * at.deformation >= side * at.extreme(side);
    return {.branch = from_backbone ? backbone_of(side) : heading_of(side), .since = time, .memory = at.memory()};
  }
  at.deformation = deformation;  // no force is left
  at.force = 0;
  return {.branch = heading_of(-side), .since = time, .memory = at.memory()};
}

double PeakOriented::stored_energy(const LawState& state, double deformation) const noexcept {
  const double v = force(state, deformation, 0);
  return 0.5 * v * v / stiffness_back(state, deformation, v);
}

double PeakOriented::residual(const LawState& state, double deformation) const noexcept {
  if (state.branch == origin) return 0;
  const double v = force(state, deformation, 0);
  return deformation - v / stiffness_back(state, deformation, v);
}

}  // namespace bentur
