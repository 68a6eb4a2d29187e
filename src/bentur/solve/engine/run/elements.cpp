#include "bentur/solve/engine/run/elements.h"

#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/run/link_stretch.h"

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double free_part = 0x1p-6;  // of the speeds of the free response, which count as that of an impact before one
constexpr double least_slack = 4.0;   // tolerances: a guard that starts this far below zero starts at zero
constexpr double least_speed = 1e-9;  // of the speeds at a point: slower starts are told to no law that needs them
constexpr double watched_widths = 64;  // of a meeting: how far its contacts are watched beyond where one closes
constexpr int most_branches = 1000;    // that loading in one direction goes through

/// A guard that says no more than δ ≥ 0 or −δ ≥ 0.
bool of_sign_alone(const Guard& guard) { return guard.constant == 0.0 && guard.speed == 0.0 && guard.decaying == 0.0; }

/// Of a spring that ends where it has no force, throughout; 0: of others.
double sign_of_force(const Branch& branch) {
  for (std::size_t g = 0; g < branch.guard_count && branch.damping == 0.0; ++g) {
    const Guard& guard = branch.guards[g];
    if (guard.deformation == 0.0 || guard.speed != 0.0 || guard.decaying != 0.0) continue;
    const double times = branch.stiffness / guard.deformation;
    if (times != 0.0 && branch.base == times * guard.constant) return times;
  }
  return 0.0;
}

double fading(const Guard& guard, const LawState& state, double time) {
  return guard.decaying == 0.0 ? 0.0 : guard.decaying * std::exp(-guard.rate * (time - state.since));
}

/// What the spring of a branch has taken in at δ, from zero.
double potential(const Branch& branch, double deformation) {
  return (branch.base + 0.5 * branch.stiffness * deformation) * deformation;
}

std::vector<GuardMonitor::Watched> watched(const ModalSystem& system, const Elements::Laws& laws) {
  std::vector<GuardMonitor::Watched> all;
  const std::vector<Branch> coupled = CoupledElements::first_branches(system, laws.coupled);
  for (Index i = 0; i < std::ssize(system.elements); ++i) {
    const Branch first = i < system.alone ? laws.laws[i]->branch({}) : coupled[i - system.alone];
    const bool switched = i < system.switched || i >= system.rubs;
    all.push_back({&system.elements[i].relation, laws.offsets[i], first, switched});
  }
  // Those of meetings are guarded on the other side, too, once they are passed.
  std::vector<double> widest;
  for (const bool finds : {true, false}) {
    for (Index point = 0; point < std::ssize(laws.places); ++point) {
      const Index meeting = laws.places[point].meeting, at = system.opening(point);
      if (meeting < 0) continue;
      if (meeting >= std::ssize(widest)) widest.resize(meeting + 1, 0.0);
      if (finds) widest[meeting] = std::max(widest[meeting], std::abs(laws.offsets[at]));
      if (!finds) all[at].span = watched_widths * widest[meeting];
    }
  }
  return all;
}

}  // namespace

Elements::Elements(const ModalSystem& system, const Laws& laws, Index idle, const Scales& scales, double accuracy,
                   State& state)
    : system_(&system),
      laws_(laws.laws),
      offsets_(laws.offsets),
      idle_(idle),
      tolerances_(offsets_.size(), 0.0),
      least_speeds_(offsets_.size(), 0.0),
      start_slack_(std::max(least_slack, accuracy / round_off_band)),
      states_(laws_.size()),
      branches_(laws_.size()),
      bodies_(offsets_.size(), 0),
      watched_(laws_.size(), 0),
      rubbing_(laws.rubbing),
      meetings_(laws.places),
      along_(rubbing_.size(), 0.0),
      coupled_(system, laws.coupled, offsets_, state, laws.sets),
      monitor_(watched(system, laws), system.size),
      touches_(laws_.size() + rubbing_.size()),
      leaves_band_(laws_.size(), 0),
      log_(laws_.size() + rubbing_.size()),
      accounts_(laws_.size()),
      worst_openings_(laws_.size(), 0.0) {
  forces_.linear.resize(offsets_.size());
  for (Index point = 0; point < std::ssize(scales.displacement); ++point) {
    const Index i = system_->opening(point);
    for (Index row = i; row <= (point < system_->switched ? i : i + 1); ++row) {
      tolerances_[row] = round_off_band * scales.displacement[point];
      least_speeds_[row] = least_speed * scales.speed[point];
    }
    fastest_ = std::max(fastest_, free_part * scales.speed[point]);
  }
  std::fill(bodies_.begin() + system_->rubs, bodies_.end(), 1);
  for (Index i = 0; i < count(); ++i) {
    enter(i, {});
    bodies_[i] = branches_[i].bodies != Bodies::none ? 1 : 0;
    if (i >= idle_ && !two_bodies(i)) load(i, state);
  }
  coupled_.watch(monitor_);
  initial_work_ += coupled_.stored_energy(state) + coupled_.lost_energy(state);
  gather(state);
}

/// From rest to the initial state in one direction, slowly: what guards end on the way.
void Elements::load(Index i, const State& state) {
  const double end = deformation(i, state);
  const double sense = end < 0.0 ? -1.0 : 1.0;
  double at = 0.0;
  for (int n = 0; n < most_branches; ++n) {
    std::optional<std::size_t> failed;
    double where = end;
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      if (guard.deformation * sense >= 0.0 || guard.speed != 0.0) continue;
      const double zero = -guard.constant / guard.deformation;
      if ((where - zero) * sense > 0.0) {
        where = (at - zero) * sense > 0.0 ? at : zero;
        failed = g;
      }
    }
    if (!failed) break;
    take_work(i, where);
    enter(i, law(i).next(states_[i], *failed, 0.0, where, sense));
    at = where;
  }
  take_work(i, end);
  initial_work_ += accounts_[i].work - 0.5 * system_->elements[i].stiffness * end * end;
}

/// Goes on to a deformation in the branch it is in.
void Elements::take_work(Index i, double deformation) {
  Account& account = accounts_[i];
  account.work += potential(branches_[i], deformation) - potential(branches_[i], account.entered);
  account.entered = deformation;
}

double Elements::tolerance(Index i, const Guard& guard, const State& state) const {
  if (branches_[i].touching() && of_sign_alone(guard)) return 0.0;
  double result = std::abs(guard.deformation) * tolerances_[i] + std::abs(guard.constant) * round_off_band;
  if (guard.decaying != 0.0) result += tolerances_[i];
  if (guard.speed != 0.0) result += std::abs(guard.speed) * round_off_band * relation(i).along_abs(state.v);
  return result;
}

/// The guard's function over the expanded step.
Polynomial Elements::guarded(Index i, const Guard& guard, const Polynomial& deformation, double h, double time) const {
  Polynomial p;
  p.degree = deformation.degree;
  for (int k = 0; k <= p.degree; ++k) p[k] = guard.deformation * deformation[k];
  if (guard.speed != 0.0) {
    for (int k = 0; k < p.degree; ++k) p[k] += guard.speed * (k + 1.0) * deformation[k + 1] / h;
  }
  double term = fading(guard, states_[i], time);
  for (int k = 0; term != 0.0 && k <= p.degree; ++k) {
    p[k] += term;
    term *= -guard.rate * h / (k + 1.0);
  }
  p[0] += guard.constant;
  return p;
}

void Elements::gauge(Index i, const State& to) {
  tolerances_[i] = std::max(tolerances_[i], round_off_band * (std::abs(offsets_[i]) + relation(i).along_abs(to.q)));
}

// What goes over all elements has their parts within it: as calls they cost a small case a per cent.
[[gnu::flatten]] void Elements::gauge(const State& to) {
  for (Index i = idle_; i < count(); ++i) {
    if (!monitor_.stays(i) || resting(i)) gauge(i, to);
  }
  coupled_.gauge(to, round_off_band, tolerances_);
}

/// The first change of an element of one deformation that does not rest.
std::optional<Elements::Event> Elements::next_event(Index i, const Course& course, const State& from) {
  std::optional<Event> first;
  for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
    const Guard& guard = branches_[i].guards[g];
    const double slack = tolerance(i, guard, from);
    const double known = start_slack_ * std::max(slack, std::abs(guard.deformation) * tolerances_[i]);
    const auto search = [&](const Polynomial& p, double factor, double offset) {
      const double start = factor * p[0];
      const bool at_zero = start + offset < 0.0 && start + offset >= -known;
      return first_negative(p, factor, at_zero ? -start : offset);
    };
    const bool of_deformation = guard.speed == 0.0 && guard.decaying == 0.0;
    const auto s = of_deformation ? search(course.deformation, guard.deformation, guard.constant + slack)
                                  : search(guarded(i, guard, course.deformation, course.h, course.time), 1.0, slack);
    if (awaits(i)) leaves_band_[i] = s ? 1 : 0;
    if (s && (!first || *s < first->s)) first = Event{i, g, *s};
  }
  return first;
}

std::optional<Elements::Event> Elements::next_event(const Expansion& motion, const State& from, const State& to,
                                                    double time, bool by_series) {
  std::optional<Event> first;
  const auto take = [&first](const std::optional<Event>& found) {
    if (found && (!first || found->s < first->s)) first = found;
  };
  for (Index i = idle_; i < count(); ++i) {
    if (resting(i)) {
      const Polynomial& force = motion.resting_force(i);
      double size = 0.0;
      for (int k = 0; k <= force.degree; ++k) size += std::abs(force[k]);
      if (const auto s = first_negative(force, 1.0, size * round_off_band)) take(Event{i, 0, *s});
    } else if (!monitor_.stays(i) && branches_[i].guard_count > 0) {
      take(next_event(i, {motion.deformation(i), motion.h(), time}, from));
    }
  }
  if (coupled_.none()) return first;
  const bool apart = by_series && forces_.pressing.empty() && forces_.resting.empty();
  if (const auto found = coupled_.next_event(motion, from, to, bands(), time, apart)) {
    take(Event{count() + static_cast<Index>(found->element), found->guard, found->s});
  }
  return first;
}

std::optional<Elements::Event> Elements::due(const State& state, const std::vector<GroundInput>& inputs,
                                             double time) const {
  Eigen::VectorXd forces;
  if (!forces_.resting.empty()) forces_at(state, inputs, forces);
  for (Index i = idle_; i < count(); ++i) {
    if (resting(i)) {
      if (forces(i) < 0.0) return Event{i, 0, 1.0};
      continue;
    }
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      const double value = guard.constant + guard.deformation * deformation(i, state) + guard.speed * speed(i, state) +
                           fading(guard, states_[i], time);
      if (value < -tolerance(i, guard, state)) return Event{i, g, 1.0};
    }
  }
  if (coupled_.none()) return std::nullopt;
  const auto found = coupled_.due(state, acceleration(state, inputs), bands());
  return found ? std::optional(Event{count() + static_cast<Index>(found->element), found->guard, 1.0}) : std::nullopt;
}

CoupledElements::Bands Elements::bands() const { return {tolerances_, round_off_band, start_slack_}; }

Eigen::VectorXd Elements::acceleration(const State& state, const std::vector<GroundInput>& inputs) const {
  Eigen::VectorXd forces, result;
  if (!forces_.resting.empty() || !forces_.nonlinear.empty()) {
    forces_at(state, inputs, forces);
    system_->acceleration(state, inputs, forces, result);
    return result;
  }
  system_->acceleration(state, inputs, forces, result);
  if (forces_.loaded) result += forces_.load;
  for (const Index i : forces_.pressing) {
    const ElementForces::Linear& linear = forces_.linear[i];
    const double pressed = linear.stiffness * deformation(i, state) + linear.damping * speed(i, state);
    system_->push(i, linear.base + pressed, result);
  }
  for (const ElementForces::Coupled& of : forces_.coupled) system_->push(of, state, result);
  return result;
}

void Elements::forces_at(const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& result) const {
  result.setZero(std::ssize(offsets_));
  for (const Index i : forces_.constant) result(i) = forces_.linear[i].base;
  for (const Index i : forces_.pressing) {
    const ElementForces::Linear& linear = forces_.linear[i];
    result(i) = linear.base + linear.stiffness * deformation(i, state) + linear.damping * speed(i, state);
  }
  for (const Index i : forces_.nonlinear) {
    result(i) = law(i).force(states_[i], deformation(i, state), speed(i, state));
  }
  coupled_.add_forces(state, result);
  if (forces_.resting.empty()) return;
  Eigen::VectorXd acceleration;
  system_->acceleration(state, inputs, result, acceleration);
  Eigen::VectorXd missing(std::ssize(forces_.resting));
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    missing(n) = relation(forces_.resting[n]).along(acceleration);
  }
  const Eigen::VectorXd held = system_->forces_for(forces_.resting, missing);
  for (Index n = 0; n < std::ssize(forces_.resting); ++n) {
    result(forces_.resting[n]) = held(n);
  }
}

double Elements::energy_lost(Index i, const State& state) const {
  const Account& account = accounts_[i];
  if (account.work == 0.0 && account.entered == 0.0) return account.damped;  // always on the line it began on
  const double delta = deformation(i, state);
  const double work = account.work + potential(branches_[i], delta) - potential(branches_[i], account.entered);
  return work + account.damped - law(i).stored_energy(states_[i], delta);
}

/// A contact that presses, where the speeds whose difference δ̇ is are so large [length/s].
void Elements::accumulate(Index i, const Course& course, double end, double speeds) {
  const double band = 2.0 * (branches_[i].stiffness * tolerances_[i] + branches_[i].damping * round_off_band * speeds);
  log_.accumulate(i, {law(i), states_[i], course.deformation, course.h, course.time, end, band});
}

void Elements::accumulate(const Expansion& motion, double time, double end) {
  for (Index i = idle_; i < system_->members; ++i) {
    if (branches_[i].touching()) {
      if (resting(i)) {
        log_.rest(i, motion.resting_force(i), motion.h(), time, end);
        continue;
      }
      double speeds = 0.0;
      if (branches_[i].damping != 0.0) speeds = relation(i).along_abs(motion.coefficients().col(1).data()) / motion.h();
      accumulate(i, {motion.deformation(i), motion.h(), time}, end, speeds);
    } else if (!two_bodies(i)) {
      const LinkStretch link = link_stretch(forces_.linear[i], motion.deformation(i), motion.h(), end);
      Account& account = accounts_[i];
      account.damped += link.damped;
      // What a cable seems to push with where it goes slack is how well that instant is known.
      const double sign = sign_of_force(branches_[i]);
      if (sign >= 0.0) account.peak_force = std::max(account.peak_force, link.peak_force);
      if (sign <= 0.0) account.peak_tension = std::max(account.peak_tension, link.peak_tension);
    }
  }
  accumulate_rubbing(motion, time, end);
}

void Elements::note_touches(const Expansion& motion, double time, double end, const State& state) {
  for (Index i = idle_; i < count(); ++i) {
    if (!awaits(i)) continue;
    const Opening opening{i, i, surface(branches_[i]), tolerances_[i], leaves_band_[i] != 0};
    note_touch(opening, motion, time, end, state);
  }
  for (std::size_t n = 0; n < rubbing_.size(); ++n) {
    const Rub of = rub(n);
    const Branch normal = of.law->normal().branch(of.law->normal_state(coupled_.states()[of.coupled]));
    if (normal.bodies != Bodies::apart || meetings_.passed(system_->switched + static_cast<Index>(n))) continue;
    const double at = surface(normal), band = tolerances_[of.at];
    const bool leaves = value(motion.deformation(of.at), 1.0) - at > band;  // were the step not cut
    note_touch({of.at, of.log, at, 0.5 * band, leaves}, motion, time, end, state);
  }
  if (end * motion.h() > 0.0) coupled_.go_on();
}

void Elements::forget_faded(double time, State& state) {
  if (forces_.fading == 0.0) return;
  for (Index i = idle_; i < count(); ++i) {
    for (std::size_t g = 0; g < branches_[i].guard_count; ++g) {
      const Guard& guard = branches_[i].guards[g];
      if (guard.decaying == 0.0 || std::abs(fading(guard, states_[i], time)) > tolerances_[i]) continue;
      set(i, {}, state);
      break;
    }
  }
}

void Elements::enter(Index i, const LawState& law_state) {
  states_[i] = law_state;
  branches_[i] = law(i).branch(law_state);
  if (i < system_->switched && meetings_.passed(i)) branches_[i] = passed_branch(branches_[i]);
  watched_[i] = monitor_.enter(i, branches_[i]) ? 1 : 0;
}

void Elements::set(Index i, const LawState& law_state, State& state) {
  enter(i, law_state);
  if (by_islands_) {
    (void)take_force(i);
  } else {
    gather(state);
  }
}

/// What an element does now, as a part of forces_.
Elements::Force Elements::take_force(Index i) {
  const Branch& branch = branches_[i];
  const ModalSystem::Element& element = system_->elements[i];
  ElementForces::Linear& linear = forces_.linear[i];
  linear = {};
  if (resting(i)) return Force::resting;
  if (!branch.linear) return Force::nonlinear;
  // A dashpot that follows the stiffness is none where that is negative.
  const double of_dashpot = std::max(branch.stiffness, 0.0) - element.stiffness;
  linear = {branch.base, branch.stiffness - element.stiffness, branch.damping + element.tangent_damping * of_dashpot};
  const bool changes = linear.stiffness != 0.0 || linear.damping != 0.0 || (branch.base != 0.0 && element.force < 0);
  return changes ? Force::pressing : Force::constant;
}

/// Works out what all elements do, and the force coordinates of `state`.
[[gnu::flatten]] void Elements::gather(State& state) {
  forces_.pressing.clear();
  forces_.constant.clear();
  forces_.resting.clear();
  forces_.nonlinear.clear();
  forces_.loaded = false;
  forces_.fading = 0.0;
  may_fly_ = true;
  any_touching_ = false;
  for (Index i = idle_; i < count(); ++i) {
    const Branch& branch = branches_[i];
    const ModalSystem::Element& element = system_->elements[i];
    any_touching_ = any_touching_ || branch.touching();
    for (std::size_t g = 0; g < branch.guard_count; ++g) {
      forces_.fading = std::max(forces_.fading, branch.guards[g].decaying != 0.0 ? branch.guards[g].rate : 0.0);
    }
    const Force force = take_force(i);
    const ElementForces::Linear& linear = forces_.linear[i];
    const bool constant = force == Force::constant;
    if (force == Force::resting) forces_.resting.push_back(i);
    if (force == Force::nonlinear) forces_.nonlinear.push_back(i);
    if (force == Force::pressing) forces_.pressing.push_back(i);
    if (constant && branch.base != 0.0) forces_.constant.push_back(i);
    may_fly_ = may_fly_ && constant && watched_[i] != 0;
    if (element.force < 0) continue;
    state.q(element.force) = linear.base + (constant ? 0.0 : linear.stiffness * deformation(i, state));
    state.v(element.force) = constant ? 0.0 : linear.stiffness * speed(i, state);
  }
  may_fly_ = coupled_.gather(forces_, state) && may_fly_;
  for (std::size_t n = 0; n < rubbing_.size(); ++n) any_touching_ = any_touching_ || touches(rub(n));
  forces_.rate = system_->rate(forces_);
  forces_.loaded = !forces_.constant.empty();
  if (!forces_.loaded) return;
  forces_.load.setZero(system_->size);
  for (const Index i : forces_.constant) {
    if (i < count()) system_->push(i, forces_.linear[i].base, forces_.load);
  }
  coupled_.add_loads(forces_.load);
}

void Elements::change(const Event& event, double time, const std::vector<GroundInput>& inputs, State& state) {
  const Index i = event.element;
  jumps_.clear();
  meetings_.begin_change();
  began_ = goes_on_ = false;
  if (i >= count()) {
    change_coupled(event, time, inputs, state);
    return;
  }
  if (two_bodies(i)) ++events_;
  if (two_bodies(i) && meetings_.has(i) && is_settled(i, time, state)) return;
  if (law(i).restitution()) {
    collide(i, time, state);
    if (coupled_.none() || failed_) return;
    coupled_.settle(time, state, acceleration(state, inputs));
    gather(state);
    return;
  }
  const LawState before = states_[i];
  const Branch ended = branches_[i];
  const bool at_zero = of_sign_alone(ended.guards[event.guard]);
  if (at_zero && two_bodies(i)) note_opening(i, time, state);
  const double delta = at_zero ? 0.0 : deformation(i, state);
  if (!two_bodies(i)) {
    take_work(i, delta);
    set(i, law(i).next(before, event.guard, time, delta, speed(i, state)), state);
    if (law(i).is_limit()) limit_passed_ = i;
    return;
  }
  double start = time;
  double closing = speed(i, state);
  const bool awaited = awaits(i);
  if (awaited && touches_[i].time >= 0.0) {
    start = std::min(touches_[i].time, time);  // both are sums, to their round-off
    closing = touches_[i].closing_speed;
    touches_[i] = {};
  }
  const bool slow = awaited && from_rest(i, closing) && law(i).needs_closing_speed();
  set(i, law(i).next(before, event.guard, start, delta, slow ? std::max(closing, least_speeds_[i]) : closing), state);
  const bool touched = ended.touching();
  const bool touches = branches_[i].touching();
  if (touched) log_.under_way(i).energy_lost += law(i).stored_energy(before, delta);
  if (touched && touches) log_.under_way(i).energy_lost -= law(i).stored_energy(states_[i], delta);
  if (touched && !touches) log_.end(i, time, -closing);
  if (touched && !touches && meetings_.has(i)) {
    take(i, 1);
    part(i, time, state);
  }
  began_ = !touched && touches;
  if (began_) {
    begin_impact(i, i, start, closing, law(i).stored_energy(states_[i], delta));
    log_.under_way(i).slow_start = slow;
  }
}

Elements::Memory Elements::memory() const {
  return {states_, accounts_, tolerances_, coupled_.states(), coupled_.largest()};
}

void Elements::resume(const Memory& memory, State& state) {
  for (Index i = idle_; i < count(); ++i) {
    if (two_bodies(i)) continue;
    enter(i, memory.states[i]);
    accounts_[i] = memory.accounts[i];
    tolerances_[i] = memory.tolerances[i];
  }
  for (Index i = count(); i < system_->rubs; ++i) tolerances_[i] = memory.tolerances[i];
  coupled_.resume(memory.coupled, memory.largest);
  gather(state);
}

}  // namespace bentur::engine
