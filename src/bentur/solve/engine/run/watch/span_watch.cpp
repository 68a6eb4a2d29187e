#include "bentur/solve/engine/run/watch/span_watch.h"

#include <algorithm>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr std::size_t most_numbers_kept = 1U << 18U;  // of flights that are unsettled, at a time

/// Whether two bodies move alike from equal states under equal inputs, and δ of all relations is zero while they do.
bool are_twins(const ModalSystem& system, const RelationGroup& group, const ModalSystem::Relation* relations) {
  const ModalSystem::Block &left = system.blocks[relations->left], &right = system.blocks[relations->right];
  const auto same = [&](const auto& of) {
    return of.segment(left.begin, left.size) == of.segment(right.begin, left.size);
  };
  if (&left == &right || left.size != right.size || left.modes != right.modes) return false;
  if (left.size > left.modes + system.components()) return false;  // what yields has laws of its own
  if (left.damping != right.damping || !same(system.omega_squared) || !same(system.two_sigma)) return false;
  for (Index c = 0; c < system.components(); ++c) {
    if (!same(system.gamma.col(c))) return false;
  }
  return std::all_of(relations, relations + group.count,
                     [](const ModalSystem::Relation& relation) { return relation.left_row == -relation.right_row; });
}

Eigen::VectorXd at_zero(Index size) { return Eigen::VectorXd::Zero(size); }

}  // namespace

SpanWatch::SpanWatch(const ModalSystem& system, const std::vector<ModalSystem::Relation>& relations,
                     const TimeGrid& grid)
    : system_(&system),
      grid_(&grid),
      relations_(relations),
      groups_(relation_groups(relations_)),
      nearest_(relations.size()),
      rate_(system.rate({})),
      start_{{at_zero(system.size), at_zero(system.size)}, at_zero(system.size)},
      end_(start_),
      rise_(at_zero(system.size)),
      acceleration_rise_(rise_),
      slopes_(Eigen::MatrixXd::Zero(system.size, 4)) {
  moved_alike_.assign(groups_.size(), 0);
  for (RelationGroup& group : groups_) {
    const auto& [left, right] = std::pair{relations_[group.first].left, relations_[group.first].right};
    bodies_.push_back(left == right ? std::vector{left} : std::vector{left, right});
    twins_.push_back(are_twins(system, group, relations_.data() + group.first) ? 1 : 0);
    together_.push_back(grid.first_with(left) == grid.first_with(right) ? 1 : 0);
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
    moved_alike_[g] = move_alike(buffer, g) ? 1 : 0;
    if (moved_alike(g)) continue;
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
      const bool alike = twins_[g] != 0 && are_alike(buffer, step, g) && are_driven_alike(buffer, step, g);
      if (!alike) keep(buffer, step, g, start(step));
    }
  }
}

/// Whether the bodies of a group have the same coordinates and speeds.
bool SpanWatch::are_alike(const StepBuffer& buffer, Index instant, std::size_t g) const {
  const ModalSystem::Block &left = system_->blocks[bodies_[g][0]], &right = system_->blocks[bodies_[g][1]];
  const auto same = [&](const double* x) {
    return std::equal(x + left.begin, x + left.begin + left.size, x + right.begin);
  };
  return same(buffer.q(instant)) && same(buffer.v(instant));
}

bool SpanWatch::are_driven_alike(const StepBuffer& buffer, Index step, std::size_t g) const {
  if (together_[g] != 0) return true;
  const GroundInput* inputs = buffer.inputs(step);
  const Index ways = system_->components();
  return std::equal(inputs + bodies_[g][0] * ways, inputs + (bodies_[g][0] + 1) * ways, inputs + bodies_[g][1] * ways);
}

/// Whether two like bodies fly alike all the way: from one state by one sequence of sums, to one state.
bool SpanWatch::move_alike(const StepBuffer& buffer, std::size_t g) const {
  if (twins_[g] == 0 || !are_alike(buffer, 0, g) || !are_alike(buffer, buffer.size(), g)) return false;
  for (Index step = 0; step < buffer.size(); ++step) {
    if (buffer.step(step).flights == nullptr || !are_driven_alike(buffer, step, g)) return false;
  }
  return true;
}

/// A flight, which has just been looked at for a group.
void SpanWatch::keep(const StepBuffer& buffer, Index step, std::size_t g, double time) {
  const StepBuffer::Step& at = buffer.step(step);
  Unsettled flight{{g, at.flights, at.halvings, time, {}}, kept_.size()};
  const Eigen::VectorXd& reach = groups_[g].reach;
  kept_.insert(kept_.end(), reach.begin(), reach.end());
  for (std::size_t n = 0; n < bodies_[g].size(); ++n) {
    const ModalSystem::Block& block = system_->blocks[bodies_[g][n]];
    std::copy_n(buffer.inputs(step) + bodies_[g][n] * system_->components(), system_->components(),
                flight.stretch.inputs[n].begin());
    for (const double* x : {buffer.q(step), buffer.v(step), buffer.acceleration(step)}) {
      kept_.insert(kept_.end(), x + block.begin, x + block.begin + block.padded_size);
    }
  }
  unsettled_.push_back(flight);
}

void SpanWatch::take(const Expansion& motion, double end, const State& from, const State& to, double time) {
  for (RelationGroup& group : groups_) take(group, motion, end, from, to, time);
}

void SpanWatch::take(RelationGroup& group, const Expansion& motion, double end, const State& from, const State& to,
                     double time) {
  const bool settled = group.look(from.q.data(), to.q.data(), motion.rise().data());
  note_ends(group, from.q.data(), to.q.data(), time, time + end * motion.h());
  if (settled) return;
  const ModalSystem::Relation& first = relations_[group.first];
  const auto curves = [&](Index begin) {
    return Curves{motion.coefficients().data() + begin, motion.coefficients().rows(), motion.degree(), motion.h(), end};
  };
  search(group, curves(first.left_begin), curves(first.right_begin), time);
}

void SpanWatch::take(Index relation, const Polynomial& delta, double h, double time) {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), relation,
                                      [](Index n, const RelationGroup& group) { return n < group.first; });
  RelationGroup& group = *std::prev(after);
  const Index n = relation - group.first;
  double where = 0.0;
  if (raise_to_maximum(delta, 1.0, group.rows.peak(n), where)) note(group, n, time + where * h);
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

bool SpanWatch::much_is_unsettled() const { return kept_.size() >= most_numbers_kept; }

/// Whether by now it is known that no δ has gone further.
bool SpanWatch::settled(const Unsettled& flight) const {
  const RelationGroup& group = groups_[flight.stretch.group];
  for (Index n = 0; n < group.count; ++n) {
    if (!(kept_[flight.at + n] <= group.rows.peak(n))) return false;
  }
  return true;
}

void SpanWatch::settle(Series& series, Expansion& motion, const GoOn& go_on) {
  for (const Unsettled& flight : unsettled_) {
    if (settled(flight)) continue;
    if (!go_on(1)) return;
    Tools tools{series, motion, go_on, {}};
    const RelationGroup& group = groups_[flight.stretch.group];
    const double* before = kept_.data() + flight.at;
    const double* kept = before + group.reach.size();
    for (std::size_t n = 0; n < bodies_[flight.stretch.group].size(); ++n) {
      const Index b = bodies_[flight.stretch.group][n];
      const ModalSystem::Block& block = system_->blocks[b];
      for (Eigen::VectorXd* x : {&start_.state.q, &start_.state.v, &start_.acceleration}) {
        std::copy_n(kept, block.padded_size, x->data() + block.begin);
        kept += block.padded_size;
      }
      tools.loads[n] = system_->load_of(b, start_.state.q.data(), loads_[n]);
    }
    if (settled_by_cubics(flight.stretch, start_, before, end_, reach_, tools)) continue;
    replay(flight.stretch, start_, reach_.data(), tools);
  }
  unsettled_.clear();
  kept_.clear();
}

/// Goes over a flight, and returns whether cubics (T-8) show that no δ goes further.
bool SpanWatch::settled_by_cubics(const Stretch& stretch, const Place& from, const double* before, Place& to,
                                  Eigen::VectorXd& reach, Tools& tools) {
  const Flight& by = (*stretch.flights)[stretch.halvings];
  RelationGroup& group = groups_[stretch.group];
  const auto slope = [this](Index n) { return slopes_.col(n).data(); };
  for (std::size_t n = 0; n < bodies_[stretch.group].size(); ++n) {
    const Index b = bodies_[stretch.group][n];
    const GroundInput* inputs = stretch.inputs[n].data();
    by.advance(b, inputs,
               {from.state.q.data(), from.state.v.data(), to.state.q.data(), to.state.v.data(), to.acceleration.data(),
                rise_.data(), acceleration_rise_.data(), tools.loads[n]});
    by.fit_cubics(
        b, inputs,
        {from.state.q.data(), from.state.v.data(), from.acceleration.data(), to.state.q.data(), to.state.v.data(),
         to.acceleration.data(), rise_.data(), acceleration_rise_.data(), slope(0), slope(1), slope(2), slope(3)});
  }
  reach.resize(group.rows.size());
  const auto at = [begin = group.begin](const double* x) { return x + begin; };
  const bool settled =
      group.rows.settled({at(from.state.q.data()), at(to.state.q.data()), at(slope(0)), at(slope(1)), at(rise_.data())},
                         before, reach.data());
  note_ends(group, from.state.q.data(), to.state.q.data(), stretch.time, stretch.time + by.length());
  return settled;
}

/// Goes over a stretch again: it is halved until one power series spans a part, and what lets no δ go further is left
/// out on the way, so that a fast mode costs no more than the logarithm of its frequency.
void SpanWatch::replay(const Stretch& stretch, const Place& from, const double* before, Tools& tools) {
  while (halvings_.size() < stretch.flights->size()) halvings_.push_back({start_, start_, {}});
  const std::vector<Index>& bodies = bodies_[stretch.group];
  Halving& at = halvings_[stretch.halvings];
  if (stretch.halvings + 1 >= stretch.flights->size()) {
    const double length = (*stretch.flights)[stretch.halvings].length();
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      tools.series.expand_block(bodies[n], from.state, stretch.inputs[n].data(), length, rate_, tools.motion);
      (void)tools.motion.find_end(at.end.state, at.end.acceleration);
    }
    take(groups_[stretch.group], tools.motion, 1.0, from.state, at.end.state, stretch.time);
    return;
  }
  const double half = (*stretch.flights)[stretch.halvings + 1].length();
  Stretch part{stretch.group, stretch.flights, stretch.halvings + 1, stretch.time, stretch.inputs};
  const Place* start = &from;
  for (Place* end : {&at.middle, &at.end}) {
    if (!tools.go_on(1)) return;
    if (!settled_by_cubics(part, *start, before, *end, at.reach, tools)) replay(part, *start, at.reach.data(), tools);
    start = end;
    part.time += half;
    for (std::size_t n = 0; n < bodies.size(); ++n) system_->advance(part.inputs[n].data(), half);
  }
}

}  // namespace bentur::engine
