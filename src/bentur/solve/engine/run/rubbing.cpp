// Impacts of contacts that rub, and when any began.
#include "bentur/contact/laws/rubbing.h"

#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/run/elements.h"

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double same_forces = 1e-13;  // of the largest: forces that differ by less do by round-off

}  // namespace

Elements::Rub Elements::rub(std::size_t number) const {
  const std::size_t coupled = system_->coupled.size() - rubbing_.size() + number;
  return {number, coupled, system_->coupled[coupled].first, count() + static_cast<Index>(number),
          rubbing_[number].get()};
}

bool Elements::touches(const Rub& of) const {
  return of.law->normal().branch(of.law->normal_state(coupled_.states()[of.coupled])).touching();
}

void Elements::accumulate_rubbing(const Expansion& motion, double time, double end) {
  for (std::size_t n = 0; n < rubbing_.size(); ++n) {
    const Rub of = rub(n);
    const CoupledState& state = coupled_.states()[of.coupled];
    const LawState normal = of.law->normal_state(state);
    const Branch branch = of.law->normal().branch(normal);
    if (!branch.touching()) continue;
    double band = 2.0 * branch.stiffness * tolerances_[of.at];
    if (branch.damping != 0.0) {
      const double speeds = relation(of.at).along_abs(motion.coefficients().col(1).data());
      band += 2.0 * branch.damping * round_off_band * speeds / motion.h();
    }
    const ImpactLog::Stretch stretch{of.law->normal(), normal, motion.deformation(of.at), motion.h(), time, end, band};
    log_.accumulate(of.log, stretch);
    along_[n] = log_.rub(of.log, stretch,
                         {coupled_.branch(of.coupled), of.law->slides(state), motion.deformation(of.at + 1),
                          of.law->tangential_stiffness()});
  }
}

/// Of the opening of bodies that are apart, over a step up to a state.
void Elements::note_touch(const Opening& of, const Expansion& motion, double time, double end, const State& state) {
  if (monitor_.stays(of.at) || deformation(of.at, state) < of.surface) {
    touches_[of.log] = {};
  } else {
    note_touch(of, {motion.deformation(of.at), motion.h(), time}, end);
  }
}

/// Where its surface has been reached at `end`.
void Elements::note_touch(const Opening& of, const Course& course, double end) {
  Touch& touch = touches_[of.log];
  Polynomial beyond = course.deformation;
  beyond[0] -= of.surface;
  const auto zero = last_zero(beyond, end);
  // One that stays in the band for the whole step is zero to within round-off, however long it does; one that leaves
  // it has been negative since the start of the step, or before.
  const bool leaves = of.leaves_band || value(beyond, end) > of.band;
  if (!zero && leaves && touch.time >= 0.0) return;
  const double s = zero.value_or(leaves ? 0.0 : end);
  touch = {course.time + s * course.h, first_derivative(beyond, s) / course.h};
}

void Elements::begin_impact(Index i, Index of_log, double start, double closing, double stored) {
  log_.begin(of_log, start, std::abs(closing) < least_speeds_[i] ? 0.0 : closing, stored);
  log_.under_way(of_log).from_rest = from_rest(i, closing);
}

/// What follows from a guard of an element of several deformations.
void Elements::change_coupled(const Event& event, double time, const std::vector<GroundInput>& inputs, State& state) {
  const auto element = static_cast<std::size_t>(event.element - count());
  const std::size_t own = system_->coupled.size() - rubbing_.size();
  if (element < own) {
    const auto [first, size] = system_->coupled[element];
    const Index force = system_->elements[first].force;
    const Eigen::VectorXd before = state.q.segment(force, size);
    coupled_.change({element, event.guard}, time, state, acceleration(state, inputs));
    gather(state);
    const Eigen::VectorXd differ = state.q.segment(force, size) - before;
    goes_on_ = differ.cwiseAbs().maxCoeff() <= same_forces * before.cwiseAbs().maxCoeff();
    return;
  }
  ++events_;
  const Rub of = rub(element - own);
  const ContactLaw& law = of.law->normal();
  const Index point = system_->switched + static_cast<Index>(of.number);
  if (meetings_.has(point) && is_settled(point, time, state)) return;
  const auto normal = [&] { return of.law->normal_state(coupled_.states()[element]); };
  const LawState before = normal();
  const bool touched = law.branch(before).touching();
  coupled_.change({element, event.guard}, time, state, acceleration(state, inputs));
  gather(state);
  const LawState after = normal();
  const bool touches = law.branch(after).touching();
  const double depth = deformation(of.at, state);
  double start = time, closing = speed(of.at, state);
  if (touched) log_.under_way(of.log).energy_lost += law.stored_energy(before, depth);
  if (touched && !touches) log_.end(of.log, time, -closing);
  if (touched && !touches) part(point, time, state);
  began_ = !touched && touches;
  if (began_) {
    if (touches_[of.log].time >= 0.0) {
      start = std::min(touches_[of.log].time, time);  // both are sums, to their round-off
      closing = touches_[of.log].closing_speed;
      touches_[of.log] = {};
    }
    begin_impact(of.at, of.log, start, closing, law.stored_energy(after, depth));
    log_.under_way(of.log).point = point;
  } else if (touches) {
    log_.under_way(of.log).energy_lost -= law.stored_energy(after, depth);
  }
}

void Elements::finish(double time) {
  for (std::size_t n = 0; n < rubbing_.size(); ++n) {
    const Rub of = rub(n);
    if (!touches(of)) continue;
    log_.under_way(of.log).open_ended = true;
    log_.under_way(of.log).friction_loss -= of.law->stored_along(along_[n]);
    log_.end(of.log, time, 0.0);
  }
  log_.finish(branches_, time);
}

}  // namespace bentur::engine
