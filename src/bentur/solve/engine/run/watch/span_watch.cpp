#include "bentur/solve/engine/run/watch/span_watch.h"

#include <algorithm>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr std::size_t most_unsettled_flights = 4096;  // flights kept at a time

}  // namespace

SpanWatch::SpanWatch(const ModalSystem& system, const std::vector<ModalSystem::Relation>& relations,
                     const TimeGrid& grid)
    : system_(&system),
      grid_(&grid),
      relations_(relations),
      groups_(relation_groups(relations_)),
      nearest_(relations.size()) {
  for (RelationGroup& group : groups_) {
    for (Index n = 0; n < group.count; ++n) {
      nearest_[group.first + n].reach = std::max(0.0, relations_[group.first + n].along(system.initial_q));
      group.rows.peak(n) = nearest_[group.first + n].reach;
    }
  }
}

void SpanWatch::resume(const std::vector<Reach>& nearest) {
  nearest_ = nearest;
  for (RelationGroup& group : groups_) {
    for (Index n = 0; n < group.count; ++n) {
      group.rows.peak(n) = nearest_[group.first + n].reach;
    }
  }
}

/// The peak of relation `n` of a group has been raised, at `time`.
void SpanWatch::note(const RelationGroup& group, Index n, double time) {
  nearest_[group.first + n] = {group.rows.peak(n), time};
}

/// Peaks may have been raised by the coordinates at two instants.
void SpanWatch::note_ends(const RelationGroup& group, const double* start, const double* end, double start_time,
                          double end_time) {
  for (Index n = 0; n < group.count; ++n) {
    if (!(group.rows.peak(n) > nearest_[group.first + n].reach)) continue;
    const ModalSystem::Relation& relation = relations_[group.first + n];
    note(group, n, relation.along(start) > relation.along(end) ? start_time : end_time);
  }
}

void SpanWatch::take(const StepBuffer& buffer) {
  const Index steps = buffer.size();
  if (steps == 0) return;
  const auto start = [&](Index step) { return grid_->start(buffer.step(step).segment) + buffer.step(step).offset; };
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    RelationGroup& group = groups_[g];
    group.rows.raise(steps, buffer.q(0) + group.begin, buffer.rise(0) + group.begin, system_->size);
    for (Index n = 0; n < group.count; ++n) {
      const double peak = group.rows.peak(n);
      if (!(peak > nearest_[group.first + n].reach)) continue;
      Index step = 0;
      while (step + 1 < steps && group.rows.larger_value(n, step) < peak) ++step;
      const ModalSystem::Relation& relation = relations_[group.first + n];
      const bool at_start = relation.along(buffer.q(step)) > relation.along(buffer.q(step + 1));
      note(group, n, start(step) + (at_start ? 0.0 : buffer.step(step).length));
    }
    for (Index step = 0; step < steps; ++step) {
      if (!group.rows.unsettled(step) || group.look(buffer.q(step), buffer.q(step + 1), buffer.rise(step))) continue;
      const StepBuffer::Step& at = buffer.step(step);
      if (at.flights == nullptr) {
        const ModalSystem::Relation& first = relations_[group.first];
        const std::vector<ModalSystem::Block>& blocks = system_->blocks;
        search(group, buffer.curves(blocks[first.left], step), buffer.curves(blocks[first.right], step), start(step));
        continue;
      }
      const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_->size); };
      unsettled_.push_back({at.flights,
                            at.halvings,
                            start(step),
                            at.length,
                            {all(buffer.q(step)), all(buffer.v(step))},
                            buffer.all_inputs(step),
                            g,
                            group.reach});
    }
  }
}

void SpanWatch::take(const Expansion& motion, double end, const State& from, const State& to, double time) {
  for (RelationGroup& group : groups_) {
    const bool settled = group.look(from.q.data(), to.q.data(), motion.rise().data());
    note_ends(group, from.q.data(), to.q.data(), time, time + end * motion.h());
    if (settled) continue;
    const ModalSystem::Relation& first = relations_[group.first];
    const auto curves = [&](Index begin) {
      return Curves{motion.coefficients().data() + begin, motion.coefficients().rows(), motion.degree(), motion.h(),
                    end};
    };
    search(group, curves(first.left_begin), curves(first.right_begin), time);
  }
}

/// The interval last looked at, which began at `time`, for the relations whose reach it leaves unsettled.
void SpanWatch::search(RelationGroup& group, const Curves& left, const Curves& right, double time) {
  for (Index n = 0; n < group.count; ++n) {
    if (group.reach(n) <= group.rows.peak(n)) continue;
    const ModalSystem::Relation& relation = relations_[group.first + n];
    Polynomial delta;
    delta.degree = left.degree;
    kernels::row_series({relation.right_size, relation.right_row.data(), right.c},
                        {relation.left_size, relation.left_row.data(), left.c}, left.stride, left.degree,
                        delta.coefficients.data());
    double where = 0.0;
    if (raise_to_maximum(delta, left.end, group.rows.peak(n), where)) note(group, n, time + where * left.h);
  }
}

bool SpanWatch::much_is_unsettled() const { return unsettled_.size() >= most_unsettled_flights; }

std::vector<SpanWatch::Unsettled> SpanWatch::take_unsettled() { return std::exchange(unsettled_, {}); }

bool SpanWatch::may_go_further(const State& from, const State& to, const Eigen::VectorXd& rise) {
  bool unsettled = false;
  for (RelationGroup& group : groups_) unsettled = !group.look(from.q.data(), to.q.data(), rise.data()) || unsettled;
  return unsettled;
}

bool SpanWatch::settled(const Unsettled& flight) const {
  const RelationGroup& group = groups_[flight.group];
  for (Index n = 0; n < group.count; ++n) {
    if (!(flight.reach(n) <= group.rows.peak(n))) return false;
  }
  return true;
}

}  // namespace bentur::engine
