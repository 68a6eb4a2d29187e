#include "bentur/solve/engine/run/floors/floor_watch.h"

#include <algorithm>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr std::size_t most_unsettled_flights = 4096;  // flights kept at a time

}  // namespace

FloorWatch::FloorWatch(const ModalSystem& system, const TimeGrid& grid)
    : system_(&system), grid_(&grid), gaps_(gaps_between(system.watched)), nearest_(system.watched.size()) {
  for (Gaps& gaps : gaps_) {
    for (Index n = 0; n < gaps.count; ++n) {
      nearest_[gaps.first + n].reach = std::max(0.0, -system.watched[gaps.first + n].sense(system.initial_q));
      gaps.closing.peak(n) = nearest_[gaps.first + n].reach;
    }
  }
}

void FloorWatch::resume(const std::vector<Nearest>& nearest) {
  nearest_ = nearest;
  for (Gaps& gaps : gaps_) {
    for (Index n = 0; n < gaps.count; ++n) {
      gaps.closing.peak(n) = nearest_[gaps.first + n].reach;
    }
  }
}

/// The peak of floor `n` of a gap has been raised, at `time`.
void FloorWatch::note(const Gaps& gaps, Index n, double time) {
  nearest_[gaps.first + n] = {gaps.closing.peak(n), time};
}

/// Peaks may have been raised by the coordinates at two instants.
void FloorWatch::note_ends(const Gaps& gaps, const double* start, const double* end, double start_time,
                           double end_time) {
  for (Index n = 0; n < gaps.count; ++n) {
    if (!(gaps.closing.peak(n) > nearest_[gaps.first + n].reach)) continue;
    const ModalSystem::Point& floor = system_->watched[gaps.first + n];
    note(gaps, n, floor.sense(start) < floor.sense(end) ? start_time : end_time);
  }
}

void FloorWatch::take(const StepBuffer& buffer) {
  const Index steps = buffer.size();
  if (steps == 0) return;
  const auto start = [&](Index step) { return grid_->start(buffer.step(step).segment) + buffer.step(step).offset; };
  for (std::size_t g = 0; g < gaps_.size(); ++g) {
    Gaps& gaps = gaps_[g];
    gaps.closing.raise(steps, buffer.q(0) + gaps.begin, buffer.rise(0) + gaps.begin, system_->size);
    for (Index n = 0; n < gaps.count; ++n) {
      const double peak = gaps.closing.peak(n);
      if (!(peak > nearest_[gaps.first + n].reach)) continue;
      Index step = 0;
      while (step + 1 < steps && gaps.closing.larger_value(n, step) < peak) ++step;
      const ModalSystem::Point& floor = system_->watched[gaps.first + n];
      const bool at_start = floor.sense(buffer.q(step)) < floor.sense(buffer.q(step + 1));
      note(gaps, n, start(step) + (at_start ? 0.0 : buffer.step(step).length));
    }
    for (Index step = 0; step < steps; ++step) {
      if (!gaps.closing.unsettled(step) || gaps.look(buffer.q(step), buffer.q(step + 1), buffer.rise(step))) continue;
      const StepBuffer::Step& at = buffer.step(step);
      if (at.flights == nullptr) {
        const auto& first = system_->watched[gaps.first];
        const auto block = [&](Index begin) -> const ModalSystem::Block& {
          return *std::find_if(system_->blocks.begin(), system_->blocks.end(),
                               [&](const ModalSystem::Block& one) { return one.begin == begin; });
        };
        search(gaps, buffer.curves(block(first.left_begin), step), buffer.curves(block(first.right_begin), step),
               start(step));
        continue;
      }
      const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_->size); };
      unsettled_.push_back({at.flights,
                            at.halvings,
                            start(step),
                            at.length,
                            {all(buffer.q(step)), all(buffer.v(step))},
                            {buffer.inputs(step), buffer.inputs(step) + system_->blocks.size()},
                            g,
                            gaps.reach});
    }
  }
}

void FloorWatch::take(const Expansion& motion, double end, const State& from, const State& to, double time) {
  for (Gaps& gaps : gaps_) {
    const bool settled = gaps.look(from.q.data(), to.q.data(), motion.rise().data());
    note_ends(gaps, from.q.data(), to.q.data(), time, time + end * motion.h());
    if (settled) continue;
    const auto& first = system_->watched[gaps.first];
    const auto curves = [&](Index begin) {
      return Curves{motion.coefficients().data() + begin, motion.coefficients().rows(), motion.degree(), motion.h(),
                    end};
    };
    search(gaps, curves(first.left_begin), curves(first.right_begin), time);
  }
}

/// The interval last looked at, which began at `time`, for the floors whose reach it leaves unsettled.
void FloorWatch::search(Gaps& gaps, const Curves& left, const Curves& right, double time) {
  for (Index n = 0; n < gaps.count; ++n) {
    if (!(gaps.reach(n) > gaps.closing.peak(n))) continue;
    const ModalSystem::Point& floor = system_->watched[gaps.first + n];
    Polynomial opening;
    opening.degree = left.degree;
    kernels::opening_series({floor.right_size, floor.sense_right.data(), right.c},
                            {floor.left_size, floor.sense_left.data(), left.c}, left.stride, left.degree,
                            opening.coefficients.data());
    double where = 0.0;
    if (raise_to_maximum(-opening, left.end, gaps.closing.peak(n), where)) note(gaps, n, time + where * left.h);
  }
}

bool FloorWatch::much_is_unsettled() const { return unsettled_.size() >= most_unsettled_flights; }

std::vector<FloorWatch::Unsettled> FloorWatch::take_unsettled() { return std::exchange(unsettled_, {}); }

bool FloorWatch::may_come_nearer(const State& from, const State& to, const Eigen::VectorXd& rise) {
  bool unsettled = false;
  for (Gaps& gaps : gaps_) unsettled = !gaps.look(from.q.data(), to.q.data(), rise.data()) || unsettled;
  return unsettled;
}

bool FloorWatch::settled(const Unsettled& flight) const {
  const Gaps& gaps = gaps_[flight.gaps];
  for (Index n = 0; n < gaps.count; ++n) {
    if (flight.reach(n) > gaps.closing.peak(n)) return false;
  }
  return true;
}

}  // namespace bentur::engine
