#include "bentur/solve/engine/run/free_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bentur::engine {
namespace {

constexpr std::size_t most_unsettled = 4096;  // steps kept at a time
constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

FreeRun::FreeRun(const Setup& setup)
    : Run(setup),
      no_force_([](const State&, const std::vector<GroundInput>&, Eigen::VectorXd& forces) { forces.resize(0); }),
      gaps_(gaps_between(system_.points)) {
  for (Gaps& gaps : gaps_) {
    for (Eigen::Index n = 0; n < gaps.count; ++n) needed_.push_back(gaps.closing.peak.data() + n);
  }
  result_.reaches.resize(needed_.size());
  result_.speeds.resize(needed_.size(), 0.0);
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    *needed_[i] = std::max(0.0, -system_.points[i].sense(state_.q));
    result_.reaches[i].push_back({0, *needed_[i]});
  }
}

std::vector<double> FreeRun::needed() const {
  std::vector<double> widths;
  for (const double* needed : needed_) widths.push_back(*needed);
  return widths;
}

/// How far a point reaches in a segment.
void FreeRun::note(Eigen::Index i, long segment, double reach) {
  auto& reaches = result_.reaches[i];
  if (reach <= reaches.back().reach) return;
  if (reaches.back().segment == segment) reaches.pop_back();
  reaches.push_back({segment, reach});
}

bool FreeRun::below(const std::vector<double>& reach) const {
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    if (!(reach[i] <= *needed_[i])) return false;
  }
  return true;
}

/// At the ends of steps only: what it is for needs no more.
void FreeRun::note_speeds(const double* v) {
  for (std::size_t i = 0; i < result_.speeds.size(); ++i) {
    const auto& point = system_.points[i];
    const double left = kernels::dot(point.left_size, point.sense_left.data(), v + point.left_begin);
    const double right = kernels::dot(point.right_size, point.sense_right.data(), v + point.right_begin);
    result_.speeds[i] = std::max(result_.speeds[i], std::abs(left) + std::abs(right));
  }
}

/// Notes how far the points reach in all steps of a buffer that has been taken in.
void FreeRun::note_reaches(const Gaps& gaps, const StepBuffer& buffer) {
  for (Eigen::Index n = 0; n < gaps.count; ++n) {
    const double needed = gaps.closing.peak(n);
    const auto& reaches = result_.reaches[gaps.first + n];
    for (Eigen::Index step = 0; step < buffer.size(); ++step) {
      // What rises in between as a part of the gap needed, which may be none.
      const double beyond = needed > 0.0 ? gaps.closing.between(step) * needed : unbounded;
      const double reach = gaps.closing.larger_value(n, step) + beyond;
      if (reach > reaches.back().reach) note(gaps.first + n, buffer.step(step).segment, reach);
    }
  }
}

/// Nothing has to be cut here, so what bounds leave unsettled is kept, and looked into when the run is over.
void FreeRun::take_buffer(const StepBuffer& buffer) {
  Run::take_buffer(buffer);
  if (buffer.size() == 0) return;
  for (Eigen::Index n = 0; n <= buffer.size(); ++n) note_speeds(buffer.v(n));
  for (Gaps& gaps : gaps_) {
    gaps.closing.raise(buffer.size(), buffer.q(0) + gaps.begin, buffer.rise(0) + gaps.begin, system_.size);
    note_reaches(gaps, buffer);
  }
  for (Eigen::Index step = 0; step < buffer.size(); ++step) {
    bool all_settled = true;
    for (Gaps& gaps : gaps_) all_settled = settled(gaps, buffer, step) && all_settled;
    if (all_settled) continue;
    const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_.size); };
    unsettled_.push_back({buffer.step(step).flights,
                          buffer.step(step).halvings,
                          buffer.step(step).length,
                          {all(buffer.q(step)), all(buffer.v(step))},
                          {buffer.inputs(step), buffer.inputs(step) + system_.blocks.size()},
                          {}});
    for (const Gaps& gaps : gaps_) {
      const double* reach = gaps.reach.data();
      unsettled_.back().reach.insert(unsettled_.back().reach.end(), reach, reach + gaps.count);
    }
  }
  if (unsettled_.size() >= most_unsettled) settle();
}

/// Whether the points reach no further in a step than they do anyway.
bool FreeRun::settled(Gaps& gaps, const StepBuffer& buffer, Eigen::Index step) {
  if (gaps.closing.unsettled(step)) return gaps.look(buffer.q(step), buffer.q(step + 1), buffer.rise(step));
  gaps.reach.setZero();
  return true;
}

/// Power series are looked at together, with the rest of the buffer.
double FreeRun::look(double /*time*/) {
  if (stepper_.is_series()) return 1.0;
  note_speeds(state_.v.data());
  note_speeds(next_.v.data());
  raise(state_, next_);
  for (Eigen::Index i = 0; i < std::ssize(needed_); ++i) note(i, segment(), *needed_[i]);
  return 1.0;
}

/// Takes the expanded step, from one state to the other, into the gaps needed. Points have no width here.
void FreeRun::raise(const State& from, const State& to) {
  for (Gaps& gaps : gaps_) {
    if (gaps.look(from.q.data(), to.q.data(), motion_.rise().data())) continue;
    for (Eigen::Index n = 0; n < gaps.count; ++n) {
      const Eigen::Index i = gaps.first + n;
      double where = 0.0;
      if (gaps.reach(n) > *needed_[i]) {
        raise_to_maximum(-motion_.opening(i), 1.0, *needed_[i], where);
      }
    }
  }
}

void FreeRun::settle() {
  for (const Unsettled& interval : unsettled_) {
    if (below(interval.reach)) continue;
    replay(
        {interval.flights, interval.halvings, 0.0, interval.length, interval.start, interval.inputs},
        [this](const Part& part) {
          bool unsettled = false;
          for (Gaps& gaps : gaps_) {
            unsettled = !gaps.look(part.from.q.data(), part.to.q.data(), part.rise.data()) || unsettled;
          }
          return unsettled;
        },
        [this](double, const State& from, const auto&, const State& to) {
          (void)motion_.find_rises();
          raise(from, to);
        });
  }
  unsettled_.clear();
}

FreeResult FreeRun::take_result() {
  result_.needed = needed();
  return std::move(result_);
}

long first_contact(const FreeResult& free, const std::vector<double>& widths) {
  long first = std::numeric_limits<long>::max();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (widths[i] > free.needed[i]) continue;
    const auto& reaches = free.reaches[i];
    const auto found = std::lower_bound(reaches.begin(), reaches.end(), widths[i],
                                        [](const FreeResult::Reach& at, double width) { return at.reach < width; });
    if (found != reaches.end()) first = std::min(first, found->segment);
  }
  return first;
}

}  // namespace bentur::engine
