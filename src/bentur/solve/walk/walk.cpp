#include "bentur/solve/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bentur::engine {
namespace {

constexpr double end_slack = 1e-9;              // of a segment: a remainder shorter than this is not run
constexpr long events_per_walk_limit = 100000;  // more than this in one record step cannot be a pounding problem
constexpr long segments_between_reports = 256;
constexpr const char* not_finite = "the response is no longer a finite number";

Eigen::VectorXd zeros(const ModalSystem& system) { return Eigen::VectorXd::Zero(system.size); }

}  // namespace

Walk::Walk(const Ground& ground)
    : system_(ground.system),
      problem_(ground.problem),
      stepper_(ground.system, ground.problem, ground.solver),
      motion_(ground.system, gap_widths(ground.problem)),
      state_{system_.initial_q, system_.initial_v},
      next_(state_),
      inputs_(system_.blocks.size()),
      lumped_{zeros(system_), zeros(system_), zeros(system_), zeros(system_)},
      grid_(ground.grid),
      plan_(ground.plan),
      course_(system_, plan_),
      search_(system_, lumped_),
      rises_{zeros(system_), zeros(system_)},
      sums_(system_.blocks.size()),
      largest_ground_(system_.blocks.size(), 0.0) {
  search_.start(state_);
}

void Walk::resume(const Checkpoint& checkpoint) {
  segment_ = checkpoint.segment;
  steps_ = checkpoint.steps;
  state_ = checkpoint.state;
  search_.watch().resume(checkpoint.peaks);
}

Status Walk::run(const std::function<bool(double)>& progress) {
  for (long reported = segment_ - segments_between_reports;;) {
    const double start = grid_.start(segment_);
    const std::size_t kind = static_cast<std::size_t>(segment_) % grid_.kinds();
    const double left = problem_.duration - start;
    const double length = grid_.length(kind);
    if (left <= end_slack * length) break;
    if (segment_ >= plan_.segments) {
      grid_.input(segment_, inputs_);
      walk(start, left >= length * (1.0 - end_slack) ? length : left);
      ++segment_;
    } else if (!may_fly() || !cruise()) {
      grid_.input(segment_, inputs_);
      halve(kind, 0, start, length);
      ++segment_;
    }
    if (trouble_.empty() && !(state_.q.allFinite() && state_.v.allFinite())) fail(not_finite, start);
    if (!trouble_.empty()) return Status::failed;
    if (search_.much_is_open()) search_.settle(stepper_.series(), motion_);
    if (progress && segment_ - reported >= segments_between_reports) {
      reported = segment_;
      if (!progress(start / problem_.duration)) return Status::stopped;
    }
  }
  search_.settle(stepper_.series(), motion_);
  settle();
  return Status::done;
}

/// Flies over whole segments as long as nothing can happen; returns whether it came any further.
bool Walk::cruise() {
  const long first = segment_;
  long last = std::min<long>(plan_.segments, first + Course::most);
  const auto jump = std::upper_bound(plan_.jumps.begin(), plan_.jumps.end(), first);
  if (jump != plan_.jumps.end()) last = std::min(last, *jump);
  course_.begin(state_, first);
  for (;;) {
    segment_ += course_.fly_on(last - segment_, lumped_);
    if (segment_ == last) break;
    const Eigen::Index n = course_.legs();
    for (std::size_t b = 0; b < inputs_.size(); ++b)
      inputs_[b] = {course_.input(n, b).value, course_.input(n, b).slope};
    if (!quiet({course_.flights(n).front(), course_.q(n), course_.v(n), course_.q(n + 1), course_.rise(n)})) break;
    course_.accept();
    ++segment_;
    if (segment_ == last) break;
  }
  const Eigen::Index legs = course_.legs();
  if (legs == 0) return false;
  const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_.size); };
  if (!all(course_.q(legs)).allFinite() || !all(course_.v(legs)).allFinite()) {
    Eigen::Index n = 0;
    while (all(course_.q(n + 1)).allFinite() && all(course_.v(n + 1)).allFinite()) ++n;
    fail(not_finite, grid_.start(course_.segment(n)));
    return true;
  }
  search_.take_course(course_);
  if (notes_flights()) pass_course();
  for (Eigen::Index n = 1; n <= legs; ++n) note_ground(course_.q(n));
  state_.q = all(course_.q(legs));
  state_.v = all(course_.v(legs));
  steps_ += legs;
  if (legs == Course::most && settle_before(segment_)) {
    search_.settle(stepper_.series(), motion_);
    settled_before(segment_);
  }
  return true;
}

/// Tells of all legs.
void Walk::pass_course() {
  for (Eigen::Index n = 0; n < course_.legs(); ++n) {
    std::copy_n(course_.q(n), system_.size, state_.q.data());
    std::copy_n(course_.v(n), system_.size, state_.v.data());
    grid_.input(course_.segment(n), inputs_);
    pass(grid_.start(course_.segment(n)), course_.flights(n).front().length());
  }
}

/// Part of a segment, after so many halvings.
void Walk::advance(std::size_t kind, std::size_t halvings, double start, double length) {
  if (!trouble_.empty()) return;
  if (may_fly() && fly(plan_.flights[kind], halvings, start, length)) return;
  halve(kind, halvings, start, length);
}

void Walk::halve(std::size_t kind, std::size_t halvings, double start, double length) {
  if (halvings + 1 >= plan_.flights[kind].size()) {
    walk(start, length);
    return;
  }
  const double half = 0.5 * length;
  advance(kind, halvings + 1, start, half);
  advance(kind, halvings + 1, start + half, half);
}

/// False, and nothing has changed, when something may happen.
bool Walk::fly(const Flights& flights, std::size_t halvings, double start, double length) {
  flights[halvings].advance(state_, inputs_, lumped_, next_, rises_, sums_);
  double left_sum = 0.0;
  bool apart = true;
  for (const kernels::Sums& sums : sums_) {
    apart = apart && left_sum + sums.as_right < 1.0;
    left_sum = sums.as_left;
  }
  if (!apart && !quiet({flights[halvings], state_.q.data(), state_.v.data(), next_.q.data(), rises_.position.data()})) {
    return false;
  }
  end_inputs_ = inputs_;
  system_.advance(end_inputs_, length);
  search_.take_flight(flights, halvings, {state_, next_, inputs_, end_inputs_}, rises_, sums_);
  pass(start, length);
  arrive();
  return true;
}

/// By steps, cut at events.
void Walk::walk(double start, double length) {
  double elapsed = 0.0;
  long cuts = 0;
  while (elapsed < length && trouble_.empty()) {
    const double left = length - elapsed;
    const double time = start + elapsed;
    if (!step(time, left)) return;
    const double whole = motion_.h();
    const double cut = look(time);
    const double h = motion_.h();
    if (cut < 1.0 || (stepper_.is_series() && motion_.place() != cut)) motion_.evaluate(cut, next_);
    end_inputs_ = inputs_;
    system_.advance(end_inputs_, cut * h);
    watch_step(cut);
    const bool at_end = whole == left && h == whole && cut == 1.0;
    elapsed = at_end ? length : elapsed + cut * h;
    arrive();
    arrived(start + elapsed);
    if ((cut < 1.0 || h != whole) && ++cuts > events_per_walk_limit) {
      fail(fmt::format("more than {} contacts closed or opened within one step of the ground motion",
                       events_per_walk_limit),
           time);
    }
  }
}

bool Walk::step(double time, double longest) {
  if (!stepper_.advance(here(), longest, !may_fly(), motion_, next_)) {
    fail("no step is short enough to follow the contact force", time);
    return false;
  }
  if (!motion_.bound()) {
    fail(not_finite, time);
    return false;
  }
  return true;
}

/// Takes [0, cut] of the expanded step into the peaks.
void Walk::watch_step(double cut) {
  if (stepper_.is_series()) {
    search_.take_step(motion_, cut, {state_, next_, inputs_, end_inputs_}, forces(), changes());
    return;
  }
  force_at()(state_, inputs_, forces_);
  system_.acceleration(state_, inputs_, forces_, start_acceleration_);
  force_at()(next_, end_inputs_, forces_);
  system_.acceleration(next_, end_inputs_, forces_, end_acceleration_);
  search_.take_approximate_step(motion_, cut, {state_, next_, inputs_, end_inputs_}, start_acceleration_,
                                end_acceleration_);
}

void Walk::replay(State from, std::vector<GroundInput> inputs, double length, const EachStep& each) {
  const ContactForces none;
  State to = from;
  const auto count = std::max(1.0, std::ceil(length * system_.rate(none) / series_reach));
  const double h = length / count;
  for (double n = 0.0; n < count; n += 1.0) {
    stepper_.series().expand(from, inputs, h, none, motion_);
    motion_.evaluate(1.0, to);
    each(n * h, from, inputs, to);
    system_.advance(inputs, h);
    from.q.swap(to.q);
    from.v.swap(to.v);
  }
}

/// next_ becomes state_.
void Walk::arrive() {
  ++steps_;
  inputs_.swap(end_inputs_);
  state_.q.swap(next_.q);
  state_.v.swap(next_.v);
  note_ground(state_.q.data());
}

void Walk::note_ground(const double* q) {
  if (problem_.kinematics != Kinematics::absolute) return;
  for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
    const Eigen::Index ground = system_.blocks[b].begin + system_.blocks[b].size - 1;
    largest_ground_[b] = std::max(largest_ground_[b], std::abs(q[ground]));
  }
}

void Walk::fail(const std::string& reason, double time) { trouble_ = fmt::format("{} at t = {:.6g} s", reason, time); }

}  // namespace bentur::engine
