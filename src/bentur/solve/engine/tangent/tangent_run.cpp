#include "bentur/solve/engine/tangent/tangent_run.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr double tangent_instant = 1e-12;  // of the duration
constexpr double same_input = 1e-9;        // of an acceleration: smaller jumps are round-off of straight lines

constexpr Index memory_size = 2 + std::tuple_size_v<decltype(LawState::memory)>;

/// A law's state some way along its derivative by a parameter.
LawState moved(LawState state, const MatrixXd& memory, Index parameter, double by) {
  if (memory.cols() == 0) return state;
  state.since += by * memory(0, parameter);
  state.closing_speed += by * memory(1, parameter);
  for (Index m = 2; m < memory_size; ++m) state.memory[m - 2] += by * memory(m, parameter);
  return state;
}

double value_of(const Guard& guard, double deformation, double speed, double since) {
  const double fading = guard.decaying != 0.0 ? guard.decaying * std::exp(-guard.rate * since) : 0.0;
  return guard.constant + guard.deformation * deformation + guard.speed * speed + fading;
}

}  // namespace

TangentRun::TangentRun(const Setup& setup, bool with_contact)
    : setup_(setup),
      step_(setup.modal, setup.by),
      law_states_(setup.laws.laws.size()),
      memories_(setup.laws.laws.size()),
      flights_(setup.grid.kinds()),
      event_by_(RowVectorXd::Zero(setup.by.count())),
      scratch_q_(setup.modal.size),
      scratch_v_(setup.modal.size),
      with_contact_(with_contact) {
  state_ = {setup.modal.initial_q, setup.modal.initial_v, setup.by.initial_q(), setup.by.initial_v()};
  before_ = state_;
  speeds_.assign(setup.modal.switched, 0.0);
  note_speeds();
  for (const GroundMotion& motion : setup.system.motions) peaks_.push_back(peak_acceleration(motion));
  enter_segment();
  set_pressing();
}

void TangentRun::enter_segment() {
  const Index ways = setup_.modal.components();
  const std::vector<GroundInput> arrived = inputs_.inputs;
  setup_.grid.input(segment_, inputs_.inputs);
  inputs_.moves = setup_.by.inputs(segment_, time_, inputs_.inputs, inputs_.values, inputs_.slopes);
  if (!setup_.by.moves_delays()) return;
  // A motion that begins or ends at once does so later where a delay grows.
  for (std::size_t i = 0; i < inputs_.inputs.size(); ++i) {
    const double jump = inputs_.inputs[i].value - (arrived.empty() ? 0.0 : arrived[i].value);
    const std::size_t b = i / ways;
    if (std::abs(jump) <= same_input * peaks_[i % ways]) continue;
    if (setup_.system.delay(b) <= 0.0 && segment_ == 0) continue;
    const Index begin = setup_.modal.blocks[b].begin, n = setup_.modal.blocks[b].modes + ways;
    state_.by_v.middleRows(begin, n).noalias() -=
        (jump * setup_.modal.gamma.col(i % ways).segment(begin, n)) * setup_.by.delays().row(static_cast<Index>(b));
  }
}

void TangentRun::set_pressing() {
  pressing_.clear();
  for (Index i = 0; i < std::ssize(law_states_); ++i) {
    if (!with_contact_ && i < setup_.modal.switched) continue;
    if (i >= setup_.modal.joint(setup_.modal.joints)) break;  // limits, which do nothing
    const Branch branch = setup_.laws.laws[i]->branch(law_states_[i]);
    if (branch.base == 0.0 && branch.stiffness == 0.0 && branch.damping == 0.0) continue;
    Pressing& one = pressing_.emplace_back();
    one.element = i;
    one.force = {branch.base, branch.stiffness, branch.damping};
    one.base = one.stiffness = one.damping = RowVectorXd::Zero(setup_.by.count());
    for (Index p = 0; p < setup_.by.count(); ++p) {
      const Dependence::Laws laws = setup_.by.laws(i, p);
      const Branch above = laws.above->branch(moved(law_states_[i], memories_[i], p, laws.step));
      const Branch below = laws.below->branch(moved(law_states_[i], memories_[i], p, -laws.step));
      const double rate = 1.0 / (2.0 * laws.step);
      one.base(p) = rate * (above.base - below.base);
      one.stiffness(p) = rate * (above.stiffness - below.stiffness);
      one.damping(p) = rate * (above.damping - below.damping);
    }
  }
  longest_ = step_.longest(pressing_);
}

void TangentRun::go_to(double time, const Take& take) {
  const double slack = tangent_instant * setup_.system.duration;
  while (time_ < time - slack) {
    const double start = setup_.grid.start(segment_), end = setup_.grid.start(segment_ + 1);
    const bool whole = std::abs(time_ - start) <= slack && end <= time + slack;
    const double to = std::min(end, time);
    if (whole && pressing_.empty() && setup_.modal.classical && !setup_.by.moves_nu()) {
      Flight& flight = flights_[segment_ % setup_.grid.kinds()];
      if (!flight.is_made) make_flight(flight, setup_.grid.length(segment_ % setup_.grid.kinds()));
      if (take) before_ = state_;
      fly(flight);
      if (take) take({time_, to - time_, before_, inputs_, pressing_}, state_);
      inputs_.advance(setup_.modal, setup_.by, to - time_);
    } else {
      const auto parts = std::max(1L, std::lround(std::ceil((to - time_) / longest_)));
      const double h = (to - time_) / static_cast<double>(parts);
      for (long n = 0; n < parts; ++n) {
        if (take) before_ = state_;
        step_.advance(state_, inputs_, pressing_, setup_.laws.offsets, h);
        if (take) take({time_ + static_cast<double>(n) * h, h, before_, inputs_, pressing_}, state_);
        inputs_.advance(setup_.modal, setup_.by, h);
      }
    }
    time_ = to;
    if (take) note_speeds();
    if (to >= end - slack) {
      ++segment_;
      enter_segment();
    }
  }
}

/// Its columns are what a coordinate, a speed or an input of 1 becomes, of all bodies at once: none moves another.
void TangentRun::make_flight(Flight& flight, double h) {
  const ModalSystem& modal = setup_.modal;
  const Index ways = modal.components(), count = setup_.by.count();
  flight.is_made = true;
  for (VectorXd* of : {&flight.qq, &flight.qv, &flight.vq, &flight.vv}) of->setZero(modal.size);
  flight.q_of_u.setZero(modal.size, 2 * ways);
  flight.v_of_u.setZero(modal.size, 2 * ways);
  Index most = 0;
  for (std::size_t b = 0; b < modal.blocks.size(); ++b) {
    const Index n = modal.blocks[b].modes;
    most = std::max(most, n + ways);
    flight.by.emplace_back(2 * n * std::ssize(setup_.by.body(b).parameters), 2 * (n + ways) + 2 * ways);
  }
  const auto parts = std::max(1L, std::lround(std::ceil(h / step_.longest({}))));
  const double part = h / static_cast<double>(parts);
  TangentInputs none;
  none.inputs.resize(inputs_.inputs.size());
  none.values.setZero(inputs_.values.rows(), count);
  none.slopes = none.values;
  const auto follow = [&](TangentState& state, TangentInputs inputs) {
    for (long n = 0; n < parts; ++n) {
      step_.advance(state, inputs, {}, setup_.laws.offsets, part);
      inputs.advance(modal, setup_.by, part);
    }
  };
  const auto take_by = [&](const TangentState& end, const std::function<Index(Index coordinates)>& column) {
    for (std::size_t b = 0; b < modal.blocks.size(); ++b) {
      const Index n = modal.blocks[b].modes, at = column(n + ways);
      if (at < 0) continue;
      const std::vector<Index>& parameters = setup_.by.body(b).parameters;
      for (Index m = 0; m < std::ssize(parameters); ++m) {
        flight.by[b].col(at).segment(2 * n * m, n) = end.by_q.col(parameters[m]).segment(modal.blocks[b].begin, n);
        flight.by[b].col(at).segment(2 * n * m + n, n) = end.by_v.col(parameters[m]).segment(modal.blocks[b].begin, n);
      }
    }
  };
  const TangentState zero{VectorXd::Zero(modal.size), VectorXd::Zero(modal.size), MatrixXd::Zero(modal.size, count),
                          MatrixXd::Zero(modal.size, count)};
  for (const bool of_speed : {false, true}) {
    for (Index j = 0; j < most; ++j) {
      TangentState state = zero;
      for (const ModalSystem::Block& block : modal.blocks) {
        if (j < block.modes + ways) (of_speed ? state.v : state.q)(block.begin + j) = 1.0;
      }
      follow(state, none);
      for (const ModalSystem::Block& block : modal.blocks) {
        if (j >= block.modes + ways) continue;
        const Index at = block.begin + j;
        (of_speed ? flight.qv : flight.qq)(at) = state.q(at);
        (of_speed ? flight.vv : flight.vq)(at) = state.v(at);
      }
      take_by(state, [&](Index n) { return j < n ? (of_speed ? n : 0) + j : -1; });
    }
  }
  for (const bool of_slope : {false, true}) {
    for (Index c = 0; c < ways; ++c) {
      TangentState state = zero;
      TangentInputs inputs = none;
      for (Index i = c; i < std::ssize(inputs.inputs); i += ways) {
        (of_slope ? inputs.inputs[i].slope : inputs.inputs[i].value) = 1.0;
      }
      follow(state, inputs);
      const Index at = (of_slope ? ways : 0) + c;
      flight.q_of_u.col(at) = state.q;
      flight.v_of_u.col(at) = state.v;
      take_by(state, [&](Index n) { return 2 * n + at; });
    }
  }
}

void TangentRun::fly(const Flight& flight) {
  const ModalSystem& modal = setup_.modal;
  const Index ways = modal.components(), count = setup_.by.count();
  scratch_q_ = flight.qq.cwiseProduct(state_.q) + flight.qv.cwiseProduct(state_.v);
  scratch_v_ = flight.vq.cwiseProduct(state_.q) + flight.vv.cwiseProduct(state_.v);
  for (Index p = 0; p < count; ++p) {
    for (Index i = 0; i < modal.size; ++i) {
      const double q = state_.by_q(i, p), v = state_.by_v(i, p);
      state_.by_q(i, p) = flight.qq(i) * q + flight.qv(i) * v;
      state_.by_v(i, p) = flight.vq(i) * q + flight.vv(i) * v;
    }
  }
  for (std::size_t b = 0; b < modal.blocks.size(); ++b) {
    const Index begin = modal.blocks[b].begin, n = modal.blocks[b].modes + ways;
    column_.resize(2 * n + 2 * ways);
    column_.head(n) = state_.q.segment(begin, n);
    column_.segment(n, n) = state_.v.segment(begin, n);
    const Index first = static_cast<Index>(b) * ways;
    for (Index c = 0; c < ways; ++c) {
      column_(2 * n + c) = inputs_.inputs[first + c].value;
      column_(2 * n + ways + c) = inputs_.inputs[first + c].slope;
    }
    scratch_q_.segment(begin, n).noalias() += flight.q_of_u.middleRows(begin, n) * column_.tail(2 * ways);
    scratch_v_.segment(begin, n).noalias() += flight.v_of_u.middleRows(begin, n) * column_.tail(2 * ways);
    if (count == 0) continue;
    const std::vector<Index>& parameters = setup_.by.body(b).parameters;
    const Index modes = modal.blocks[b].modes;
    product_.noalias() = flight.by[b] * column_;
    for (Index m = 0; m < std::ssize(parameters); ++m) {
      state_.by_q.col(parameters[m]).segment(begin, modes) += product_.segment(2 * modes * m, modes);
      state_.by_v.col(parameters[m]).segment(begin, modes) += product_.segment(2 * modes * m + modes, modes);
    }
    for (Index c = 0; c < (inputs_.moves ? ways : 0); ++c) {
      state_.by_q.middleRows(begin, n).noalias() +=
          flight.q_of_u.col(c).segment(begin, n) * inputs_.values.row(first + c) +
          flight.q_of_u.col(ways + c).segment(begin, n) * inputs_.slopes.row(first + c);
      state_.by_v.middleRows(begin, n).noalias() +=
          flight.v_of_u.col(c).segment(begin, n) * inputs_.values.row(first + c) +
          flight.v_of_u.col(ways + c).segment(begin, n) * inputs_.slopes.row(first + c);
    }
  }
  state_.q.swap(scratch_q_);
  state_.v.swap(scratch_v_);
}

RowVectorXd TangentRun::deformations_by(Index element) const {
  RowVectorXd by = along(setup_.modal.elements[element].relation, state_.by_q) + setup_.by.offsets().row(element);
  for (const Dependence::OfRow& moved : setup_.by.rows(element)) by(moved.parameter) += moved.row.dot(state_.q);
  return by;
}

RowVectorXd TangentRun::speeds_by(Index element) const {
  RowVectorXd by = along(setup_.modal.elements[element].relation, state_.by_v);
  for (const Dependence::OfRow& moved : setup_.by.rows(element)) by(moved.parameter) += moved.row.dot(state_.v);
  return by;
}

void TangentRun::note_speeds() {
  for (Index i = 0; i < setup_.modal.switched; ++i) {
    speeds_[i] = std::max(speeds_[i], std::abs(setup_.modal.elements[i].relation.along(state_.v)));
  }
}

/// How fast a guard falls beside what is usual: so much, and its factor of δ times the largest δ̇.
void TangentRun::note_grazing(Index element, double rate, double usual, double slope) {
  if (element >= std::ssize(usual_speeds_)) return;
  usual += std::abs(slope) * usual_speeds_[element];
  if (usual > 0.0) grazing_ = std::min(grazing_, std::abs(rate) / usual);
}

/// (S-2), and what the law remembers after it, unless the contact passes.
void TangentRun::take_memory(const Change& change, const VectorXd& a) {
  const Index i = change.element;
  const ModalSystem::Relation& at = setup_.modal.elements[i].relation;
  const Law& law = *setup_.laws.laws[i];
  const double delta = at.along(state_.q) + setup_.laws.offsets[i];
  const double speed = at.along(state_.v), grows = at.along(a);
  const Guard guard = law.branch(change.before).guards[change.guard];
  const double since = change.time - change.before.since;
  const double fading = guard.decaying != 0.0 ? guard.rate * guard.decaying * std::exp(-guard.rate * since) : 0.0;
  const double rate = guard.deformation * speed + guard.speed * grows - fading;
  note_grazing(i, rate, std::abs(guard.speed) * at.along_abs(a) + std::abs(fading), guard.deformation);

  const Index count = setup_.by.count();
  if (law_states_[i].branch != change.before.branch) memories_[i].resize(0, 0);  // a dent that has faded
  const bool passes = change.passes;
  event_by_.setZero(count);
  if (count == 0) return;
  const RowVectorXd delta_by = deformations_by(i), speed_by = speeds_by(i);
  MatrixXd memory = MatrixXd::Zero(memory_size, count);
  for (Index p = 0; p < count; ++p) {
    const Dependence::Laws laws = setup_.by.laws(i, p);
    const auto guarded = [&](const Law& of, double by) {
      const LawState state = moved(change.before, memories_[i], p, by);
      return value_of(of.branch(state).guards[change.guard], delta + by * delta_by(p), speed + by * speed_by(p),
                      change.time - state.since);
    };
    const double half = 1.0 / (2.0 * laws.step);
    event_by_(p) = -half * (guarded(*laws.above, laws.step) - guarded(*laws.below, -laws.step)) / rate;
    if (passes) continue;
    const auto next = [&](const Law& of, double by) {
      const double tau = event_by_(p);
      return of.next(moved(change.before, memories_[i], p, by), change.guard, change.time + by * tau,
                     delta + by * (delta_by(p) + speed * tau), speed + by * (speed_by(p) + grows * tau));
    };
    const LawState above = next(*laws.above, laws.step), below = next(*laws.below, -laws.step);
    memory(0, p) = half * (above.since - below.since);
    memory(1, p) = half * (above.closing_speed - below.closing_speed);
    for (Index m = 2; m < memory_size; ++m) memory(m, p) = half * (above.memory[m - 2] - below.memory[m - 2]);
  }
  if (!passes) memories_[i] = memory;
}

void TangentRun::change(const Change& change) {
  if (change.element >= std::ssize(law_states_)) return;
  const ModalSystem& modal = setup_.modal;
  before_ = state_;
  VectorXd a, after;
  const double previous = last_jump_;
  const auto jumps = [&] {
    simultaneous_ =
        simultaneous_ || (previous >= 0.0 && change.time - previous <= tangent_instant * setup_.system.duration);
    last_jump_ = change.time;
  };
  if (change.shares) {
    throw InvalidParameter("contacts", "of several edges", "have no derivatives where they close at one instant");
  }
  if (change.passes && change.slipped.empty()) {  // no force changes, whenever that is
    event_by_.setZero(setup_.by.count());
    if (change.after.branch != change.before.branch) memories_[change.element].resize(0, 0);
    law_states_[change.element] = change.after;
  } else if (setup_.laws.laws[change.element]->restitution() && !change.passes) {
    jumps();
    collide(change);
  } else {
    step_.accelerations(state_, inputs_, pressing_, setup_.laws.offsets, a);
    take_memory(change, a);
    law_states_[change.element] = change.after;
    for (const auto& [slipped, after_it] : change.slipped) {
      law_states_[slipped] = after_it;
      memories_[slipped].resize(0, 0);
    }
    set_pressing();
    step_.accelerations(state_, inputs_, pressing_, setup_.laws.offsets, after);
    const double least = 1e-9 * std::max(a.cwiseAbs().maxCoeff(), after.cwiseAbs().maxCoeff());
    if ((a - after).cwiseAbs().maxCoeff() > least) jumps();
    if (setup_.by.count() > 0) state_.by_v.noalias() += (a - after) * event_by_;
  }
  if (change.q.size() == modal.size) {
    state_.q = change.q;
    state_.v = change.v;
  }
}

/// An impact that takes no time: M (v⁺ − v⁻) = push (1 + e) δ̇ / A, A = −row · M⁻¹ push.
void TangentRun::collide(const Change& change) {
  const auto unlike = [](const std::string& what) {
    throw InvalidParameter("contacts.law", "restitution", "has no derivatives here: " + what);
  };
  const Index i = change.element;
  if (change.impulses.size() != 1) unlike("several contacts part at one instant, or one comes to rest");
  if (change.impulses.front().first != i || change.after.branch != 0) unlike("a contact comes to rest");
  const ModalSystem& modal = setup_.modal;
  const ModalSystem::Relation& at = modal.elements[i].relation;
  const Index count = setup_.by.count();
  VectorXd a, after;
  step_.accelerations(state_, inputs_, pressing_, setup_.laws.offsets, a);
  const double speed = at.along(state_.v);
  note_grazing(i, speed, 0.0, 1.0);
  VectorXd push = VectorXd::Zero(modal.size);
  modal.push(i, 1.0, push);
  const double compliance = -at.along(push), bounce = 1.0 + *setup_.laws.laws[i]->restitution();
  const double impulse = bounce * speed / compliance;
  event_by_ = count > 0 ? RowVectorXd(-deformations_by(i) / speed) : RowVectorXd();
  const RowVectorXd speed_by = count > 0 ? speeds_by(i) : RowVectorXd();
  for (Index p = 0; p < count; ++p) {
    const Dependence::Laws laws = setup_.by.laws(i, p);
    const double e = (*laws.above->restitution() - *laws.below->restitution()) / (2.0 * laws.step);
    VectorXd pushed = VectorXd::Zero(modal.size);  // push_p − M_p push
    for (std::size_t b = 0; b < modal.blocks.size(); ++b) {
      const Dependence::OfBody& body = setup_.by.body(b);
      const auto found = std::find(body.parameters.begin(), body.parameters.end(), p);
      if (found == body.parameters.end()) continue;
      const Index n = modal.blocks[b].modes, begin = modal.blocks[b].begin;
      pushed.segment(begin, n) =
          body.matrices.block(n * (found - body.parameters.begin()), 0, n, n) * push.segment(begin, n);
    }
    double less_held = at.along(pushed);  // −A_p
    for (const Dependence::OfRow& moved : setup_.by.rows(i)) {
      if (moved.parameter != p) continue;
      less_held += at.along(moved.push) + moved.row.dot(push);
      pushed += moved.push;
    }
    const double total = speed_by(p) + at.along(a) * event_by_(p);  // of δ̇ when it strikes
    state_.by_q.col(p) += state_.v * event_by_(p);
    state_.by_v.col(p) +=
        a * event_by_(p) + pushed * impulse +
        push * (e * speed / compliance + bounce * total / compliance + impulse * less_held / compliance);
  }
  state_.v += push * impulse;
  step_.accelerations(state_, inputs_, pressing_, setup_.laws.offsets, after);
  for (Index p = 0; p < count; ++p) {
    state_.by_q.col(p) -= state_.v * event_by_(p);
    state_.by_v.col(p) -= after * event_by_(p);
  }
}

bool TangentRun::presses(Index element) const {
  return std::any_of(pressing_.begin(), pressing_.end(), [&](const Pressing& one) { return one.element == element; });
}

double TangentRun::force(Index element, RowVectorXd& by) {
  by.setZero(setup_.by.count());
  for (const Pressing& one : pressing_) {
    if (one.element != element) continue;
    const ModalSystem::Relation& at = setup_.modal.elements[element].relation;
    const double delta = at.along(state_.q) + setup_.laws.offsets[element], speed = at.along(state_.v);
    by = one.base + one.stiffness * delta + one.damping * speed + one.force.stiffness * deformations_by(element) +
         one.force.damping * speeds_by(element);
    return one.force.base + one.force.stiffness * delta + one.force.damping * speed;
  }
  return 0.0;
}

double TangentRun::force_rate(Index element) {
  VectorXd a;
  step_.accelerations(state_, inputs_, pressing_, setup_.laws.offsets, a);
  for (const Pressing& one : pressing_) {
    if (one.element != element) continue;
    const ModalSystem::Relation& at = setup_.modal.elements[element].relation;
    return one.force.stiffness * at.along(state_.v) + one.force.damping * at.along(a);
  }
  return 0.0;
}

}  // namespace bentur::engine
