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
constexpr int halvings_beyond_one_series = 2;  // by measurement: fewer leave more to series, more cost flights

}  // namespace

FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid) {
  FlightTable table(grid.kinds());
  if (!system.classical) return table;
  const double rate = system.rate({});
  for (std::size_t kind = 0; kind < table.size(); ++kind) {
    const double length = grid.length(kind);
    const double to_one_series = std::ceil(std::log2(std::max(1.0, length * rate / series_reach)));
    const int halvings = static_cast<int>(to_one_series) + halvings_beyond_one_series;
    table[kind] = Flight::make(system, length, halvings);
  }
  return table;
}

Walk::Walk(const Ground& ground, PeakWatch::Scope scope)
    : system_(ground.system),
      problem_(ground.problem),
      stepper_(ground.system, ground.problem, ground.solver),
      motion_(ground.system),
      state_{system_.initial_q, system_.initial_v},
      next_(state_),
      grid_(ground.grid),
      flights_(ground.flights),
      search_(system_, scope),
      bounds_(Flight::make_bounds(system_.size)),
      largest_ground_(system_.blocks.size(), 0.0) {
  search_.start(state_);
}

Status Walk::run(const std::function<bool(double)>& progress) {
  for (long segment = 0;; ++segment) {
    const double start = grid_.start(segment);
    const std::size_t kind = static_cast<std::size_t>(segment) % grid_.kinds();
    const double left = problem_.duration - start;
    const double length = grid_.length(kind);
    if (left <= end_slack * length) break;
    grid_.input(segment, inputs_);
    if (left >= length * (1.0 - end_slack)) {
      advance(kind, 0, start, length);
    } else {
      walk(start, left);
    }
    if (!state_.q.allFinite() || !state_.v.allFinite()) fail(not_finite, start);
    if (!trouble_.empty()) return Status::failed;
    if (search_.much_is_open()) search_.settle(stepper_.series(), motion_);
    if (progress && segment % segments_between_reports == 0 && !progress(start / problem_.duration))
      return Status::stopped;
  }
  search_.settle(stepper_.series(), motion_);
  settle();
  return Status::done;
}

/// A segment, or one of its parts after so many halvings.
void Walk::advance(std::size_t kind, std::size_t halvings, double start, double length) {
  if (!trouble_.empty()) return;
  const auto& flights = flights_[kind];
  if (!flights.empty() && may_fly() && fly(flights, halvings, start, length)) return;
  if (halvings + 1 >= flights.size()) {
    walk(start, length);
    return;
  }
  const double half = 0.5 * length;
  advance(kind, halvings + 1, start, half);
  advance(kind, halvings + 1, start + half, half);
}

/// False, and nothing has changed, when something may happen.
bool Walk::fly(const Flights& flights, std::size_t halvings, double start, double length) {
  flights[halvings].advance(state_, inputs_, next_, bounds_);
  if (!quiet(flights, halvings, bounds_)) return false;
  end_inputs_ = inputs_;
  system_.advance(end_inputs_, length);
  search_.take_flight(flights, halvings, state_, inputs_, next_, end_inputs_, bounds_);
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
    if (cut < 1.0) motion_.evaluate(cut, next_);
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
    search_.take_step(motion_, cut, state_, inputs_, forces(), changes());
    return;
  }
  force_at()(state_, inputs_, forces_);
  system_.acceleration(state_, inputs_, forces_, start_acceleration_);
  force_at()(next_, end_inputs_, forces_);
  system_.acceleration(next_, end_inputs_, forces_, end_acceleration_);
  search_.take_approximate_step(motion_, cut, state_, next_, start_acceleration_, end_acceleration_);
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
  if (problem_.kinematics == Kinematics::absolute) {
    for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
      const Eigen::Index ground = system_.blocks[b].begin + system_.blocks[b].size - 1;
      largest_ground_[b] = std::max(largest_ground_[b], std::abs(state_.q(ground)));
    }
  }
}

void Walk::fail(const std::string& reason, double time) { trouble_ = fmt::format("{} at t = {:.6g} s", reason, time); }

}  // namespace bentur::engine
