#include "bentur/solve/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bentur::engine {
namespace {

constexpr double end_slack = 1e-9;              // of a segment: a remainder shorter than this is not run
constexpr long events_per_walk_limit = 100000;  // more than this in one record step cannot be a pounding problem
constexpr long segments_between_reports = 256;
constexpr int halvings_beyond_one_series = 2;  // by measurement: fewer leave more to series, more cost flights

}  // namespace

FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid) {
  FlightTable table(grid.kinds());
  if (!system.classical) return table;
  const double rate = system.rate({});
  for (std::size_t kind = 0; kind < table.size(); ++kind) {
    double length = grid.length(kind);
    const double to_one_series = std::ceil(std::log2(std::max(1.0, length * rate / series_reach)));
    for (int n = 0; n <= static_cast<int>(to_one_series) + halvings_beyond_one_series; ++n) {
      table[kind].emplace_back(system, length);
      length *= 0.5;
    }
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
      watch_(system_, scope),
      start_acceleration_(Eigen::VectorXd::Zero(system_.size)),
      end_acceleration_(Eigen::VectorXd::Zero(system_.size)),
      largest_ground_(system_.blocks.size(), 0.0) {
  watch_.start(state_);
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
    if (!trouble_.empty()) return Status::failed;
    if (unsettled_.size() >= unsettled_limit) scan_unsettled();
    if (progress && segment % segments_between_reports == 0 && !progress(start / problem_.duration))
      return Status::stopped;
  }
  scan_unsettled();
  settle();
  return Status::done;
}

/// A segment, or one of its parts after so many halvings.
void Walk::advance(std::size_t kind, std::size_t halvings, double start, double length) {
  if (!trouble_.empty()) return;
  auto& flights = flights_[kind];
  if (!flights.empty() && may_fly() && fly(flights[halvings], start, length)) return;
  if (halvings + 1 >= flights.size()) {
    walk(start, length);
    return;
  }
  const double half = 0.5 * length;
  advance(kind, halvings + 1, start, half);
  advance(kind, halvings + 1, start + half, half);
}

/// False, and nothing has changed, when something may happen.
bool Walk::fly(Flight& flight, double start, double length) {
  flight.advance(state_, inputs_, next_);
  if (!quiet(flight)) return false;
  watch_interval(length, true, flight.rise(), flight.acceleration_rise());
  pass(start, length);
  inputs_ = end_inputs_;
  state_.q.swap(next_.q);
  state_.v.swap(next_.v);
  after_step(start + length);
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
    const double part = cut * cut / 8.0;
    rise_ = part * motion_.curvature();
    acceleration_rise_ = part / (h * h) * motion_.fourth_derivative();
    watch_interval(cut * h, false, rise_, acceleration_rise_);
    const bool at_end = whole == left && h == whole && cut == 1.0;
    elapsed = at_end ? length : elapsed + cut * h;
    inputs_ = end_inputs_;
    state_.q.swap(next_.q);
    state_.v.swap(next_.v);
    arrived(start + elapsed);
    after_step(start + elapsed);
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
  motion_.bound();
  if (!motion_.curvature().allFinite()) {
    fail("the response is no longer a finite number", time);
    return false;
  }
  return true;
}

/// Takes the interval from state_ to next_ into the peaks and leaves the inputs at its end in end_inputs_. What its
/// ends and bounds do not settle is kept and looked into when the run is over: peaks only rise, so most of it is
/// settled by then.
void Walk::watch_interval(double length, bool flying, const Eigen::VectorXd& rise,
                          const Eigen::VectorXd& acceleration_rise) {
  end_inputs_ = inputs_;
  system_.advance(end_inputs_, length);
  if (watch_.scope() == PeakWatch::Scope::everything) {
    force_at()(state_, inputs_, forces_);
    system_.acceleration(state_, inputs_, forces_, start_acceleration_);
    force_at()(next_, end_inputs_, forces_);
    system_.acceleration(next_, end_inputs_, forces_, end_acceleration_);
  }
  const PeakWatch::Interval interval{state_, next_, start_acceleration_, end_acceleration_, rise, acceleration_rise};
  for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
    if (watch_.settled_by_bound(b, interval, reach_)) continue;
    if (flying || stepper_.is_series()) {
      unsettled_.push_back({b, length, state_, inputs_, flying ? ContactForces{} : forces(), reach_});
    } else {
      watch_.scan(b, motion_, reach_);
    }
  }
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

void Walk::scan_unsettled() {
  // Those that may have gone furthest first: what they raise settles others.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t n = 0; n < unsettled_.size(); ++n) {
    const double excess = watch_.excess(unsettled_[n].block, unsettled_[n].reach);
    if (excess > 1.0) order.emplace_back(-excess, n);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [minus_excess, n] : order) {
    Unsettled& interval = unsettled_[n];
    if (watch_.excess(interval.block, interval.reach) <= 1.0) continue;
    State& from = interval.start;
    const bool coupled = !interval.forces.none();
    const double growth =
        coupled ? system_.rate(interval.forces) : std::max(system_.blocks[interval.block].rate(), system_.nu);
    const auto count = std::max(1.0, std::ceil(interval.length * growth * (1.0 - end_slack) / series_reach));
    const double h = interval.length / count;
    for (double step = 1.0; step <= count; step += 1.0) {
      if (coupled) {
        stepper_.series().expand(from, interval.inputs, h, interval.forces, motion_);
      } else {
        stepper_.series().expand_block(interval.block, from, interval.inputs[interval.block], h, motion_);
      }
      watch_.scan(interval.block, motion_, interval.reach);
      if (step == count) break;
      motion_.evaluate(1.0, next_);
      system_.advance(interval.inputs, h);
      from.q.swap(next_.q);
      from.v.swap(next_.v);
    }
  }
  unsettled_.clear();
}

void Walk::after_step(double time) {
  ++steps_;
  if (!state_.q.allFinite() || !state_.v.allFinite()) fail("the response is no longer a finite number", time);
  if (problem_.kinematics == Kinematics::absolute) {
    for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
      const Eigen::Index ground = system_.blocks[b].begin + system_.blocks[b].size - 1;
      largest_ground_[b] = std::max(largest_ground_[b], std::abs(state_.q(ground)));
    }
  }
}

void Walk::fail(const std::string& reason, double time) { trouble_ = fmt::format("{} at t = {:.6g} s", reason, time); }

}  // namespace bentur::engine
