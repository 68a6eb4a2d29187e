#include "bentur/solve/engine/run/contacts.h"

#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/run/impulses.h"

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double round_off_band = 0x1p-46;  // of displacements and speeds at a point, and of resting forces
constexpr double resting_threshold =
    0x1p-20;                          // of the speeds at a point: slower impacts without duration do not bounce
constexpr double free_part = 0x1p-6;  // of the speeds of the free response, which count as that of an impact before one
constexpr double least_slack = 4.0;   // tolerances: a guard that starts this far below zero starts at zero
constexpr double least_speed = 1e-9;  // of the speeds at a point: slower starts are told to no law that needs them

/// The last place in [0, end] where the opening, which is not positive at `end`, was zero; nothing where it is never
/// zero or more but at the start.
std::optional<double> last_zero(const Polynomial& opening, double end) {
  if (value(opening, end) >= 0.0) return end;
  double largest = 0.0;
  double where = 0.0;
  if (!raise_to_maximum(opening, end, largest, where)) return std::nullopt;
  return root(opening, where, end);
}

/// A guard that says no more than δ ≥ 0 or −δ ≥ 0.
bool of_opening_alone(const Guard& guard) {
  return guard.constant == 0.0 && guard.speed == 0.0 && guard.decaying == 0.0;
}

double fading(const Guard& guard, const LawState& state, double time) {
  return guard.decaying == 0.0 ? 0.0 : guard.decaying * std::exp(-guard.rate * (time - state.since));
}

}  // namespace

Contacts::Contacts(const ModalSystem& system, const Problem& problem, const Scales& scales, double accuracy)
    : system_(&system),
      problem_(&problem),
      start_slack_(std::max(least_slack, accuracy / round_off_band)),
      states_(system.points.size()),
      branches_(system.points.size()),
      touches_(system.points.size()),
      leaves_band_(system.points.size(), 0),
      log_(system.points.size()) {
  forces_.linear.resize(system.points.size());
  for (Index i = 0; i < std::ssize(states_); ++i) {
    branches_[i] = law(i).branch(states_[i]);
    tolerances_.push_back(round_off_band * scales.displacement[i]);
    least_speeds_.push_back(least_speed * scales.speed[i]);
    fastest_ = std::max(fastest_, free_part * scales.speed[i]);
  }
}

double Contacts::penetration(Index i, const State& state) const {
  return -(problem_->points[i].width + system_->points[i].sense(state.q));
}

double Contacts::closing_speed(Index i, const State& state) const { return -system_->points[i].sense(state.v); }

bool Contacts::resting(Index i) const { return branches_[i].touching() && law(i).restitution().has_value(); }

double Contacts::tolerance(Index i, const Guard& guard, const State& state) const {
  if (branches_[i].touching() && of_opening_alone(guard)) return 0.0;
  double result = std::abs(guard.deformation) * tolerances_[i] + std::abs(guard.constant) * round_off_band;
  if (guard.decaying != 0.0) result += tolerances_[i];
  if (guard.speed != 0.0) {
    result += std::abs(guard.speed) * round_off_band * system_->points[i].sense_abs(state.v);
  }
  return result;
}

/// The guard's function over the expanded step.
Polynomial Contacts::guarded(Index i, const Guard& guard, const Polynomial& opening, double h, double time) const {
  Polynomial p;
  p.degree = opening.degree;
  for (int k = 0; k <= p.degree; ++k) p[k] = -guard.deformation * opening[k];
  if (guard.speed != 0.0) {
    for (int k = 0; k < p.degree; ++k) p[k] -= guard.speed * (k + 1.0) * opening[k + 1] / h;
  }
  double term = fading(guard, states_[i], time);
  for (int k = 0; term != 0.0 && k <= p.degree; ++k) {
    p[k] += term;
    term *= -guard.rate * h / (k + 1.0);
  }
  p[0] += guard.constant;
  return p;
}

void Contacts::gauge(const State& from, const State& to, const GapMonitor& monitor) {
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (states_[i].branch == 0 && monitor.stays_open(i)) continue;
    const auto& point = system_->points[i];
    const double size = problem_->points[i].width + std::max(point.sense_abs(from.q), point.sense_abs(to.q));
    tolerances_[i] = std::max(tolerances_[i], round_off_band * size);
  }
}

std::optional<Contacts::Event> Contacts::next_event(const Expansion& motion, const State& from,
                                                    const GapMonitor& monitor, double time) {
  std::optional<Event> first;
  const auto take = [&first](Index point, std::size_t guard, const std::optional<double>& s) {
    if (s && (!first || *s < first->s)) first = Event{point, guard, *s};
  };
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (resting(i)) {
      Polynomial force = motion.resting_force(i);
      double size = 0.0;
      for (int k = 0; k <= force.degree; ++k) size += std::abs(force[k]);
      force[0] += size * round_off_band;
      take(i, 0, first_negative(force));
      continue;
    }
    if (states_[i].branch == 0 && monitor.stays_open(i)) continue;
    const Polynomial& opening = motion.opening(i);
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      Polynomial p = guarded(i, guard, opening, motion.h(), time);
      const double slack = tolerance(i, guard, from);
      p[0] += slack;
      const double known = start_slack_ * std::max(slack, std::abs(guard.deformation) * tolerances_[i]);
      if (p[0] < 0.0 && p[0] >= -known) p[0] = 0.0;
      const auto s = first_negative(p);
      if (states_[i].branch == 0) leaves_band_[i] = s ? 1 : 0;
      take(i, g, s);
    }
  }
  return first;
}

std::optional<Contacts::Event> Contacts::due(const State& state, const std::vector<GroundInput>& inputs,
                                             double time) const {
  Eigen::VectorXd forces;
  if (!forces_.resting.empty()) forces_at(state, inputs, forces);
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (resting(i)) {
      if (forces(i) < 0.0) return Event{i, 0, 1.0};
      continue;
    }
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      const double value = guard.constant + guard.deformation * penetration(i, state) +
                           guard.speed * closing_speed(i, state) + fading(guard, states_[i], time);
      if (value < -tolerance(i, guard, state)) return Event{i, g, 1.0};
    }
  }
  return std::nullopt;
}

void Contacts::forces_at(const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& result) const {
  result.setZero(std::ssize(states_));
  const auto press = [&](Index i) {
    result(i) = law(i).force(states_[i], penetration(i, state), closing_speed(i, state));
  };
  for (const Index i : forces_.pressing) press(i);
  for (const Index i : forces_.nonlinear) press(i);
  if (forces_.resting.empty()) return;
  Eigen::VectorXd acceleration;
  system_->acceleration(state, inputs, result, acceleration);
  Eigen::VectorXd missing(std::ssize(forces_.resting));
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    missing(n) = -system_->points[forces_.resting[n]].sense(acceleration);
  }
  const Eigen::VectorXd held = system_->forces_for(forces_.resting, missing);
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    result(forces_.resting[n]) = held(n);
  }
}

double Contacts::stored_energy(const State& state) const {
  double sum = 0.0;
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (branches_[i].touching()) sum += law(i).stored_energy(states_[i], penetration(i, state));
  }
  return sum;
}

void Contacts::accumulate(const Expansion& motion, double time, double end) {
  if (forces_.none() && all_apart_) return;
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (!branches_[i].touching()) continue;
    if (resting(i)) {
      log_.rest(i, motion.resting_force(i), motion.h(), time, end);
      continue;
    }
    double band = 2.0 * branches_[i].stiffness * tolerances_[i];
    if (branches_[i].damping != 0.0) {
      const double speeds = system_->points[i].sense_abs(motion.coefficients().col(1).data());
      band += 2.0 * branches_[i].damping * round_off_band * speeds / motion.h();
    }
    log_.accumulate(i, {law(i), states_[i], motion.opening(i), motion.h(), time, end, band});
  }
}

void Contacts::note_touches(const Expansion& motion, const GapMonitor& monitor, double time, double end,
                            const State& state) {
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (states_[i].branch != 0) continue;
    if (monitor.stays_open(i) || penetration(i, state) < 0.0) {
      touches_[i] = {};
      continue;
    }
    const Polynomial& opening = motion.opening(i);
    const auto zero = last_zero(opening, end);
    // One that stays in the band for the whole step is zero to within round-off, however long it does; one that leaves
    // it has been negative since the start of the step, or before.
    const bool leaves = leaves_band_[i] != 0 || value(opening, end) < -tolerances_[i];
    if (!zero && leaves && touches_[i].time >= 0.0) continue;
    const double s = zero.value_or(leaves ? 0.0 : end);
    touches_[i] = {time + s * motion.h(), -first_derivative(opening, s) / motion.h()};
  }
  if (forces_.fading > 0.0) forget_faded(time + end * motion.h());
}

/// A surface that has come back to within round-off of its place is a fresh one.
void Contacts::forget_faded(double time) {
  for (Index i = 0; i < std::ssize(states_); ++i) {
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      if (guard.decaying == 0.0 || std::abs(fading(guard, states_[i], time)) > tolerances_[i]) continue;
      set(i, {});
      break;
    }
  }
}

void Contacts::set(Index point, const LawState& state) {
  states_[point] = state;
  branches_[point] = law(point).branch(state);
  forces_.pressing.clear();
  forces_.resting.clear();
  forces_.nonlinear.clear();
  forces_.fading = 0.0;
  all_apart_ = true;
  for (Index i = 0; i < std::ssize(branches_); ++i) {
    const Branch& branch = branches_[i];
    all_apart_ = all_apart_ && states_[i].branch == 0;
    forces_.linear[i] = {};
    for (std::size_t g = 0; g < branch.guard_count; ++g) {
      forces_.fading = std::max(forces_.fading, branch.guards[g].decaying != 0.0 ? branch.guards[g].rate : 0.0);
    }
    if (resting(i)) {
      forces_.resting.push_back(i);
    } else if (!branch.linear) {
      forces_.nonlinear.push_back(i);
    } else if (branch.base != 0.0 || branch.stiffness != 0.0 || branch.damping != 0.0) {
      forces_.linear[i] = {branch.base, branch.stiffness, branch.damping};
      forces_.pressing.push_back(i);
    }
  }
}

void Contacts::change(const Event& event, double time, State& state) {
  const Index i = event.point;
  ++events_;
  jumps_.clear();
  began_ = false;
  if (law(i).restitution()) {
    collide(i, time, state);
    return;
  }
  const Guard& guard = branches_[i].guards[event.guard];
  const LawState before = states_[i];
  const bool touched = branches_[i].touching();
  double depth = of_opening_alone(guard) ? 0.0 : penetration(i, state);
  double start = time;
  double speed = closing_speed(i, state);
  if (before.branch == 0 && touches_[i].time >= 0.0) {
    start = touches_[i].time;
    speed = touches_[i].closing_speed;
    touches_[i] = {};
  }
  const bool slow = before.branch == 0 && from_rest(i, speed) && law(i).needs_closing_speed();
  set(i, law(i).next(before, event.guard, start, depth, slow ? least_speeds_[i] : speed));
  if (touched) log_.under_way(i).energy_lost += law(i).stored_energy(before, depth);
  if (touched && branches_[i].touching()) log_.under_way(i).energy_lost -= law(i).stored_energy(states_[i], depth);
  if (touched && !branches_[i].touching()) log_.end(i, time, -speed);
  began_ = !touched && branches_[i].touching();
  if (began_) {
    log_.begin(i, start, from_rest(i, speed) ? 0.0 : speed);
    log_.under_way(i).slow_start = slow;
    log_.under_way(i).energy_lost -= law(i).stored_energy(states_[i], depth);
  }
}

/// A contact rests within its tolerance of zero, or as far from it as the errors of steps that are approximations add
/// up to. It lets go at zero, or what is left would decide whether it closes again at once.
void Contacts::let_go(Index point, State& state) {
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(std::ssize(forces_.resting));
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    if (forces_.resting[n] == point) missing(n) = penetration(point, state);
  }
  const Eigen::VectorXd moves = system_->forces_for(forces_.resting, missing);
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    system_->push(forces_.resting[n], moves(n), state.q);
  }
  set(point, {});
}

/// Impacts without duration: every point that is closed and has such a law takes part; or a resting point lets go.
void Contacts::collide(Index point, double time, State& state) {
  if (resting(point)) {
    let_go(point, state);
    log_.end(point, time, 0.0);
    return;
  }
  std::vector<Index> at;
  for (Index i = 0; i < std::ssize(states_); ++i) {
    if (law(i).restitution() && (i == point || resting(i) || penetration(i, state) >= -tolerances_[i])) at.push_back(i);
    fastest_ = std::max(fastest_, system_->points[i].sense_abs(state.v));
  }
  const Index count = std::ssize(at);
  Eigen::MatrixXd a(count, count);
  Eigen::VectorXd before(count), b(count);
  std::vector<char> slow(at.size(), 0);
  for (Index n = 0; n < count; ++n) {
    const Index i = at[n];
    before(n) = closing_speed(i, state);
    slow[n] = std::abs(before(n)) <= resting_threshold * fastest_ ? 1 : 0;
    b(n) = before(n) * (1.0 + (slow[n] != 0 ? 0.0 : *law(i).restitution()));
    for (Index m = 0; m < count; ++m) {
      a(n, m) = system_->coupling(i, at[m]);
    }
  }
  const std::optional<Eigen::VectorXd> found = impulses(a, b);
  failed_ = !found;
  if (failed_) return;
  const Eigen::VectorXd& p = *found;
  for (Index n = 0; n < count; ++n) system_->push(at[n], p(n), state.v);
  for (Index n = 0; n < count; ++n) {
    const Index i = at[n];
    const double after = closing_speed(i, state);
    const double lost = 0.5 * p(n) * (before(n) + after);
    if (p(n) > 0.0) jumps_.push_back({i, p(n), lost});
    const bool was_resting = resting(i);
    const bool pressed = p(n) > 0.0 || (was_resting && after >= -round_off_band * fastest_);
    const bool rests = pressed && slow[n] != 0;
    if (!was_resting && p(n) > 0.0) {
      const bool touched_before = touches_[i].time >= 0.0;
      log_.begin(i, touched_before ? touches_[i].time : time, before(n));
    }
    log_.under_way(i).impulse += p(n);
    log_.under_way(i).energy_lost += lost;
    if (was_resting && !rests && penetration(i, state) > start_slack_ * tolerances_[i]) let_go(i, state);
    if (rests != was_resting) set(i, rests ? LawState{1, time, before(n)} : LawState{});
    if (!rests && (was_resting || p(n) > 0.0)) log_.end(i, was_resting ? time : log_.under_way(i).start, -after);
    touches_[i] = {};
  }
}

}  // namespace bentur::engine
