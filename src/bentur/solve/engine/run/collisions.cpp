// Impacts that take no time, and contacts that rest.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/elements/complementarity.h"
#include "bentur/solve/engine/run/elements.h"

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double resting_threshold = 0x1p-20;  // of the speeds at a point: slower impacts do not bounce
// Likewise: the height of a slower bounce is some 2⁻²⁶ of the first one's, 10⁶ times the round-off of displacements, so
// that how many are slower hangs on round-off, and how many are faster does not.
constexpr double settling_threshold = 0x1p-13;

}  // namespace

/// At an instant at which an opening is zero. What overlaps at the start never was.
void Elements::note_opening(Index i, double time, const State& state) {
  if (time > 0.0) worst_openings_[i] = std::max(worst_openings_[i], std::abs(deformation(i, state)));
}

/// A contact rests within its tolerance of zero, or as far from it as the errors of steps that are approximations add
/// up to. It lets go at zero, or what is left would decide whether it closes again at once.
void Elements::let_go(Index element, State& state) {
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(std::ssize(forces_.resting));
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    if (forces_.resting[n] == element) missing(n) = deformation(element, state);
  }
  const Eigen::VectorXd moves = system_->forces_for(forces_.resting, missing);
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    system_->push(forces_.resting[n], moves(n), state.q);
  }
  set(element, {}, state);
}

/// Impacts without duration: every point that is closed and has such a law takes part; or a resting point lets go.
void Elements::collide(Index element, double time, State& state) {
  if (resting(element)) {
    let_go(element, state);
    log_.end(element, time, 0.0);
    part(element, time, state);
    return;
  }
  note_opening(element, time, state);
  // Where errors of steps have brought it farther than they were thought to, it still parts from zero; else the next
  // step would end at once, and so on.
  tolerances_[element] = std::max(tolerances_[element], std::abs(deformation(element, state)) / start_slack_);
  std::vector<Index> at;
  for (Index i = idle_; i < count(); ++i) {
    if (!two_bodies(i)) continue;
    const bool touches = i == element || resting(i);
    const bool closes = !touches && law(i).restitution() && deformation(i, state) >= -tolerances_[i];
    if (touches || (closes && (!meetings_.has(i) || (!meetings_.passed(i) && may_touch(i, state))))) at.push_back(i);
    fastest_ = std::max(fastest_, relation(i).along_abs(state.v));
  }
  const Index count = std::ssize(at);
  const Eigen::MatrixXd a = system_->coupling.among(at);
  Eigen::VectorXd before(count), b(count);
  std::vector<char> slow(at.size(), 0);
  for (Index n = 0; n < count; ++n) {
    const Index i = at[n];
    before(n) = speed(i, state);
    slow[n] = std::abs(before(n)) <= resting_threshold * fastest_ ? 1 : 0;
    b(n) = before(n) * (1.0 + (slow[n] != 0 ? 0.0 : *law(i).restitution()));
  }
  std::optional<Eigen::VectorXd> found = complementary(a, b);
  failed_ = !found;
  if (failed_) return;
  const Eigen::VectorXd p = least_norm(a, b, *std::move(found));
  for (Index n = 0; n < count; ++n) system_->push(at[n], p(n), state.v);
  for (Index n = 0; n < count; ++n) {
    const Index i = at[n];
    const double after = speed(i, state);
    const double lost = 0.5 * p(n) * (before(n) + after);
    if (p(n) > 0.0) jumps_.push_back({i, p(n), lost});
    const bool was_resting = resting(i);
    const bool pressed = p(n) > 0.0 || (was_resting && after >= -round_off_band * fastest_);
    const bool rests = pressed && slow[n] != 0;
    if (!was_resting && p(n) > 0.0) {
      const bool touched_before = touches_[i].time >= 0.0;
      log_.begin(i, touched_before ? std::min(touches_[i].time, time) : time, before(n));
      log_.under_way(i).settling = std::abs(before(n)) <= settling_threshold * fastest_;
    }
    log_.under_way(i).impulse += p(n);
    log_.under_way(i).energy_lost += lost;
    if (was_resting && !rests && deformation(i, state) > start_slack_ * tolerances_[i]) let_go(i, state);
    if (rests != was_resting) set(i, rests ? LawState{1, time, before(n)} : LawState{}, state);
    if (!rests && (was_resting || p(n) > 0.0)) log_.end(i, was_resting ? time : log_.under_way(i).start, -after);
    touches_[i] = {};
  }
  for (const Index i : at) {
    if (meetings_.has(i) && !branches_[i].touching()) part(i, time, state);
  }
}

}  // namespace bentur::engine
