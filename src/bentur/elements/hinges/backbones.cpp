// What the hinges of HingeLaw bear as they lose strength: (H-17), (H-18).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/hinges/falling.h"

namespace bentur {

using Eigen::Index;
using Eigen::VectorXd;

bool HingeLaw::is_odd() const noexcept {
  return of_.upper == of_.lower && std::all_of(of_.backbones.begin(), of_.backbones.end(), [](const HingeBackbone& of) {
           return !of.loses_strength() || (of.clockwise == of.anticlockwise && of.at_rest == 0.0);
         });
}

/// Nothing of one that loses no strength.
const HingeBackbone* HingeLaw::backbone(Index h) const {
  if (of_.backbones.empty()) return nullptr;
  const HingeBackbone& of = of_.backbones[static_cast<std::size_t>(h)];
  return of.loses_strength() ? &of : nullptr;
}

HingeLaw::Stage HingeLaw::stage_of(const CoupledState& state, Index h) const {
  return weakens_ ? static_cast<Stage>(static_cast<int>(state.memory(h, stage))) : virgin;
}

bool HingeLaw::any_softened(const CoupledState& state) const {
  return !of_.backbones.empty() && (state.memory.col(stage).array() > 0.0).any();
}

/// Whether a hinge has turned beyond its cap, which its stage does not know of.
bool HingeLaw::past_a_cap(const CoupledState& state) const {
  for (Index h = 0; h < size(); ++h) {
    const HingeBackbone* of = backbone(h);
    if (of != nullptr && std::abs(state.memory(h, rotation)) > of->plastic) return true;
  }
  return false;
}

/// What follows from how long the members are is told where they have names (hinge_elements()).
void HingeLaw::check_backbones() const {
  for (Index h = 0; h < size(); ++h) {
    const HingeBackbone* of = backbone(h);
    if (of == nullptr) continue;
    const std::string name = indexed("backbones", h);
    require_positive(name + ".plastic", of->plastic);
    if (!(of->softening > 0))
      throw InvalidParameter(name + ".softening", fmt::format("{}", of->softening), "must be > 0");
    if (!(of->residual >= 0 && of->residual < 1)) {
      throw InvalidParameter(name + ".residual", fmt::format("{}", of->residual), "must be 0 … 1, less than 1");
    }
    if (!(of->ultimate > of->plastic)) {
      throw InvalidParameter(name + ".ultimate", fmt::format("{}", of->ultimate), "must be beyond the cap");
    }
    if (!(of->wear > 0)) throw InvalidParameter(name + ".wear", fmt::format("{}", of->wear), "must be > 0");
    if (!(of->wear_exponent >= 1 && of->wear_exponent <= 2)) {
      throw InvalidParameter(name + ".wear_exponent", fmt::format("{}", of->wear_exponent), "must be in [1, 2]");
    }
    const double hardens = of_.hardening(h) * of->plastic;
    const double least = std::min(of->clockwise, of->anticlockwise);
    if (!(hardens < least)) {
      throw InvalidParameter(name + ".plastic", fmt::format("{}", of->plastic),
                             fmt::format("must not harden to twice the capacity: {} of {}", hardens, least));
    }
    for (const double most : {of->clockwise, of->anticlockwise}) {
      if (!std::isfinite(most) || (most + hardens) / of->softening < of_.stiffness(h, h)) continue;
      throw InvalidParameter(name + ".softening", fmt::format("{}", of->softening),
                             fmt::format("must lose less than the {} that the member unloads by", of_.stiffness(h, h)));
    }
  }
}

/// What it could bear on a side when it came to its cap, moment at rest included, less what it has worn by since.
double HingeLaw::strength_at_cap(const CoupledState& state, Index h, double s) const {
  return left_by_wear(state, h, s) * state.memory(h, s > 0 ? at_cap_above : at_cap_below);
}

/// The share of that which it keeps for good.
double HingeLaw::level(const CoupledState& state, Index h) const {
  const HingeBackbone& of = *backbone(h);
  const double s = state.memory(h, cap_side);
  return of.residual * (s > 0 ? of.clockwise : of.anticlockwise) / state.memory(h, s > 0 ? at_cap_above : at_cap_below);
}

/// The rotation at which it is down to that.
double HingeLaw::levelled_at(const CoupledState& state, Index h) const {
  const HingeBackbone& of = *backbone(h);
  return of.plastic + (1.0 - level(state, h)) * of.softening;
}

double HingeLaw::share_left(const CoupledState& state, Index h) const {
  const HingeBackbone* of = backbone(h);
  if (of == nullptr) return 1.0;
  switch (stage_of(state, h)) {
    case virgin:
      return 1.0;
    case softened:
      return 1.0 - (state.memory(h, worn) - of->plastic) / of->softening;
    case levelled:
      return level(state, h);
    case spent:
      break;
  }
  return 0.0;
}

/// How far s M may rise beyond the cap. (H-18)
double HingeLaw::softened_line(const CoupledState& state, Index h, double s) const {
  const double at_rest = s * backbone(h)->at_rest;
  return stage_of(state, h) == spent ? -at_rest : share_left(state, h) * strength_at_cap(state, h, s) - at_rest;
}

/// What M rises by as it turns on along side s [force·length/rad]; H of one that has not come to its cap.
double HingeLaw::slope(const CoupledState& state, Index h, double s) const {
  const Stage of = stage_of(state, h);
  if (of == virgin) return of_.hardening(h);
  if (of != softened || s * state.memory(h, rotation) < state.memory(h, worn) * (1.0 - at_end)) return 0.0;
  return -strength_at_cap(state, h, s) / backbone(h)->softening;
}

/// The s θ at which turning on along side s has another slope.
double HingeLaw::stage_end(const CoupledState& state, Index h, double s) const {
  const HingeBackbone* of = backbone(h);
  if (of == nullptr) return std::numeric_limits<double>::infinity();
  switch (stage_of(state, h)) {
    case virgin:
      return of->plastic;
    case softened: {
      const double so_far = state.memory(h, worn);
      if (s * state.memory(h, rotation) < so_far * (1.0 - at_end)) return so_far;
      return std::min(levelled_at(state, h), of->ultimate);
    }
    case levelled:
      return of->ultimate;
    case spent:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

/// What hardening stored is lost, as it hardens no more. Of the side on which it does not flow with what had been left
/// when that began, since that is what wears it.
void HingeLaw::harden_no_more(CoupledState& state, Index h, double s) const {
  const HingeBackbone& of = *backbone(h);
  auto memory = state.memory.row(h);
  const double back = of_.hardening(h) * memory(rotation);
  for (const double to : {1.0, -1.0}) {
    const double left = !of.wears() ? 1.0 : to == s ? left_by_wear(state, h, to) : memory(left_before);
    memory(to > 0 ? at_cap_above : at_cap_below) =
        std::max(0.0, (to > 0 ? of.clockwise : of.anticlockwise) + to * back / left);
  }
  memory(lost) += 0.5 * back * memory(rotation);
  memory(cap_side) = s;
  memory(stage) = softened;
}

/// A hinge that turns along side s has come to where its stage ends. Returns whether it fails, so that what it still
/// bears has to go.
bool HingeLaw::end_stage(CoupledState& state, Index h, double s, double time) const {
  const HingeBackbone& of = *backbone(h);
  auto memory = state.memory.row(h);
  const double turned = s * memory(rotation);
  if (stage_of(state, h) == virgin) {
    harden_no_more(state, h, s);
    memory(cap_at) = time;
    memory(worn) = turned;
    return false;
  }
  if (turned >= of.ultimate * (1.0 - at_end)) return true;
  if (stage_of(state, h) != softened) return false;
  if (turned >= levelled_at(state, h) * (1.0 - at_end)) {
    memory(worn) = std::max(memory(worn), turned);
    memory(stage) = of.residual > 0.0 ? levelled : spent;
    if (of.residual == 0.0) memory(failed_at) = time;
    return false;
  }
  memory(worn) = turned;
  return false;
}

/// After flow along side s.
void HingeLaw::sync(CoupledState& state, Index h, double s) const {
  if (stage_of(state, h) == softened) {
    state.memory(h, worn) = std::max(state.memory(h, worn), s * state.memory(h, rotation));
  }
}

/// Hinges that flow and have come to where a stage of theirs ends. Returns whether any has failed, so that all have
/// been loaded anew.
bool HingeLaw::end_stages(CoupledState& state, double time, const VectorXd& deformation) const {
  if (of_.backbones.empty()) return false;
  std::vector<Fall> falls;
  const VectorXd y = borne(state, deformation);
  for (Index h = 0; h < size(); ++h) {
    const double s = state.memory(h, side);
    if (s == 0.0 || backbone(h) == nullptr || nothing_left(state, h)) continue;
    const double end = stage_end(state, h, s);
    if (!std::isfinite(end)) continue;
    if (s * state.memory(h, rotation) < end * (1.0 - at_end)) continue;
    if (end_stage(state, h, s, time)) falls.push_back(fall_of(state, h, true, y(h)));
  }
  // What is as good as where it was worn to is there.
  for (Index h = 0; h < size(); ++h) {
    if (stage_of(state, h) != softened) continue;
    const double turned = std::abs(state.memory(h, rotation));
    if (std::abs(turned - state.memory(h, worn)) <= at_end * turned) state.memory(h, worn) = turned;
  }
  if (falls.empty()) return false;
  redistribute(state, deformation, deformation, time, std::move(falls));
  rest_off_lines(state, deformation);
  return true;
}

}  // namespace bentur
