#include "bentur/solve/engine/walk/free_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bentur::engine {
namespace {

constexpr std::size_t most_unsettled = 4096;  // legs kept at a time
constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

FreeWalk::FreeWalk(const Ground& ground)
    : Walk(ground),
      no_force_([](const State&, const std::vector<GroundInput>&, Eigen::VectorXd& forces) { forces.resize(0); }),
      gaps_(gaps_between(system_.points)) {
  for (Gaps& gaps : gaps_) {
    for (std::size_t n = 0; n < gaps.count; ++n) needed_.push_back(gaps.closing.peak.data() + n);
  }
  run_.reaches.resize(needed_.size());
  run_.speeds.resize(needed_.size(), 0.0);
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    *needed_[i] = std::max(0.0, -system_.points[i].sense(state_.q));
    run_.reaches[i].push_back({0, *needed_[i]});
  }
}

std::vector<double> FreeWalk::needed() const {
  std::vector<double> widths;
  for (const double* needed : needed_) widths.push_back(*needed);
  return widths;
}

/// How far a point reaches in a segment.
void FreeWalk::note(std::size_t i, long segment, double reach) {
  auto& reaches = run_.reaches[i];
  if (reach <= reaches.back().reach) return;
  if (reaches.back().segment == segment) reaches.pop_back();
  reaches.push_back({segment, reach});
}

bool FreeWalk::below(const std::vector<double>& reach) const {
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    if (!(reach[i] <= *needed_[i])) return false;
  }
  return true;
}

/// At the ends of steps only: what it is for needs no more.
void FreeWalk::note_speeds(const double* v) {
  for (std::size_t i = 0; i < run_.speeds.size(); ++i) {
    const auto& point = system_.points[i];
    const double left = kernels::dot(point.left_size, point.sense_left.data(), v + point.left_begin);
    const double right = kernels::dot(point.right_size, point.sense_right.data(), v + point.right_begin);
    run_.speeds[i] = std::max(run_.speeds[i], std::abs(left) + std::abs(right));
  }
}

/// Notes how far the points reach in all legs of a trail that has been taken in.
void FreeWalk::note_reaches(const Gaps& gaps, const Trail& trail) {
  for (std::size_t n = 0; n < gaps.count; ++n) {
    const auto row = static_cast<Eigen::Index>(n);
    const double needed = gaps.closing.peak(row);
    const auto& reaches = run_.reaches[gaps.first + n];
    for (Eigen::Index leg = 0; leg < trail.legs(); ++leg) {
      // What rises in between as a part of the gap needed, which may be none.
      const double beyond = needed > 0.0 ? gaps.closing.between(leg) * needed : unbounded;
      const double reach = gaps.closing.larger_value(row, leg) + beyond;
      if (reach > reaches.back().reach) note(gaps.first + n, trail.leg(leg).segment, reach);
    }
  }
}

/// Nothing has to be cut here, so what bounds leave open is kept, and looked into when the run is over.
void FreeWalk::take_trail(const Trail& trail) {
  Walk::take_trail(trail);
  if (trail.legs() == 0) return;
  for (Eigen::Index n = 0; n <= trail.legs(); ++n) note_speeds(trail.v(n));
  for (Gaps& gaps : gaps_) {
    gaps.closing.raise(trail.legs(), trail.q(0) + gaps.begin, trail.rise(0) + gaps.begin, system_.size);
    note_reaches(gaps, trail);
  }
  for (Eigen::Index leg = 0; leg < trail.legs(); ++leg) {
    bool all_settled = true;
    for (Gaps& gaps : gaps_) all_settled = settled(gaps, trail, leg) && all_settled;
    if (all_settled) continue;
    const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_.size); };
    unsettled_.push_back({trail.leg(leg).flights,
                          trail.leg(leg).halvings,
                          trail.leg(leg).length,
                          {all(trail.q(leg)), all(trail.v(leg))},
                          {trail.inputs(leg), trail.inputs(leg) + system_.blocks.size()},
                          {}});
    for (const Gaps& gaps : gaps_) {
      const double* reach = gaps.reach.data();
      unsettled_.back().reach.insert(unsettled_.back().reach.end(), reach, reach + gaps.count);
    }
  }
  if (unsettled_.size() >= most_unsettled) settle();
}

/// Whether the points reach no further in a leg than they do anyway.
bool FreeWalk::settled(Gaps& gaps, const Trail& trail, Eigen::Index leg) {
  if (gaps.closing.open(leg)) return gaps.look(trail.q(leg), trail.q(leg + 1), trail.rise(leg));
  gaps.reach.setZero();
  return true;
}

/// Power series are looked at together, with the rest of the trail.
double FreeWalk::look(double /*time*/) {
  if (stepper_.is_series()) return 1.0;
  note_speeds(state_.v.data());
  note_speeds(next_.v.data());
  raise(state_, next_);
  for (std::size_t i = 0; i < needed_.size(); ++i) note(i, segment(), *needed_[i]);
  return 1.0;
}

/// Takes the expanded step, from one state to the other, into the gaps needed. Points have no width here.
void FreeWalk::raise(const State& from, const State& to) {
  for (Gaps& gaps : gaps_) {
    if (gaps.look(from.q.data(), to.q.data(), motion_.rise().data())) continue;
    for (std::size_t n = 0; n < gaps.count; ++n) {
      const std::size_t i = gaps.first + n;
      double where = 0.0;
      if (gaps.reach(static_cast<Eigen::Index>(n)) > *needed_[i]) {
        raise_to_maximum(-motion_.opening(i), 1.0, *needed_[i], where);
      }
    }
  }
}

void FreeWalk::settle() {
  for (const Unsettled& interval : unsettled_) {
    if (below(interval.reach)) continue;
    replay(
        {interval.flights, interval.halvings, 0.0, interval.length, interval.start, interval.inputs},
        [this](const Part& part) {
          bool open = false;
          for (Gaps& gaps : gaps_) {
            open = !gaps.look(part.from.q.data(), part.to.q.data(), part.rise.data()) || open;
          }
          return open;
        },
        [this](double, const State& from, const auto&, const State& to) {
          (void)motion_.find_rises();
          raise(from, to);
        });
  }
  unsettled_.clear();
}

FreeRun FreeWalk::take_run() {
  run_.needed = needed();
  return std::move(run_);
}

long first_contact(const FreeRun& run, const std::vector<double>& widths) {
  long first = std::numeric_limits<long>::max();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (widths[i] > run.needed[i]) continue;
    const auto& reaches = run.reaches[i];
    const auto found = std::lower_bound(reaches.begin(), reaches.end(), widths[i],
                                        [](const FreeRun::Reach& at, double width) { return at.reach < width; });
    if (found != reaches.end()) first = std::min(first, found->segment);
  }
  return first;
}

}  // namespace bentur::engine
