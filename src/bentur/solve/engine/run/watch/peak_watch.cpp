#include "bentur/solve/engine/run/watch/peak_watch.h"

#include <algorithm>
#include <limits>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
using Eigen::Index;
using Eigen::VectorXd;

namespace {

using Group = ModalSystem::Block::Group;

/// Those outputs that have peaks, one group above the other.
BoundedOutputs stacked(const ModalSystem::Block& block, Eigen::MatrixXd Group::*of) {
  Index count = 0;
  for (const Group& group : block.outputs) {
    if (group.has_peak && (group.*of).size() > 0) count += group.count();
  }
  Eigen::MatrixXd rows(count, block.size);
  VectorXd at_rest(count);
  Index at = 0;
  for (const Group& group : block.outputs) {
    if (!group.has_peak || (group.*of).size() == 0) continue;
    rows.middleRows(at, group.count()) = group.*of;
    at_rest.segment(at, group.count()) = group.at_rest;
    at += group.count();
  }
  BoundedOutputs outputs(rows, block.padded_size, kernels::Peaks::of_abs);
  outputs.offset.head(count) = at_rest;
  return outputs;
}

}  // namespace

PeakWatch::PeakWatch(const ModalSystem& system) : system_(&system) {
  Index most = 0;
  Index most_quantities = 0;
  for (const auto& block : system.blocks) {
    positions_.push_back(stacked(block, &Group::of_position));
    accelerations_.push_back(stacked(block, &Group::of_acceleration));
    most = std::max(most, block.padded_size);
    most_quantities = std::max(most_quantities, quantities(positions_.size() - 1));
  }
  samples_.resize(most * (most_parts + 1));
  seconds_.resize(most * (most_parts + 1));
  rise_.setZero(most);
  second_rise_.setZero(most);
  unknown_.assign(most_quantities, std::numeric_limits<double>::infinity());
}

Index PeakWatch::quantities(std::size_t b) const { return positions_[b].size() + accelerations_[b].size(); }

VectorXd PeakWatch::peaks() const {
  Index size = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) size += quantities(b);
  VectorXd all(size);
  Index at = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    for (const BoundedOutputs* rows : {&positions_[b], &accelerations_[b]}) {
      all.segment(at, rows->size()) = rows->peak;
      at += rows->size();
    }
  }
  return all;
}

void PeakWatch::resume(const VectorXd& peaks) {
  Index at = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    for (BoundedOutputs* rows : {&positions_[b], &accelerations_[b]}) {
      rows->peak = peaks.segment(at, rows->size());
      at += rows->size();
    }
  }
}

void PeakWatch::raise(std::size_t b, const StepBuffer& buffer) {
  const Index begin = system_->blocks[b].begin;
  const Index steps = buffer.size();
  positions_[b].raise(steps, buffer.q(0) + begin, buffer.rise(0) + begin, system_->size);
  accelerations_[b].raise(steps, buffer.acceleration(0) + begin, buffer.acceleration_rise(0) + begin, system_->size);
}

Index PeakWatch::next_unsettled(std::size_t b, Index step, double* before) const {
  const BoundedOutputs& positions = positions_[b];
  const BoundedOutputs& accelerations = accelerations_[b];
  while (step < positions.steps() && !positions.unsettled(step) && !accelerations.unsettled(step)) ++step;
  if (step == positions.steps()) return step;
  positions.mark_unsettled(step, before);
  accelerations.mark_unsettled(step, before + positions.size());
  return step;
}

bool PeakWatch::settled_by_bound(std::size_t b, const Interval& at, const double* before, double* reach) {
  const Index first = positions_[b].size();
  const bool positions = positions_[b].settled(at.start, at.end, at.rise, before, reach);
  const bool accelerations = accelerations_[b].settled(at.start_acceleration, at.end_acceleration, at.acceleration_rise,
                                                       before + first, reach + first);
  return positions && accelerations;
}

bool PeakWatch::settled_by_cubics(std::size_t b, const kernels::CubicCurves& positions,
                                  const kernels::CubicCurves& accelerations, const double* before, double* reach) {
  const Index first = positions_[b].size();
  const bool of_positions = positions_[b].settled(positions, before, reach);
  const bool of_accelerations = accelerations_[b].settled(accelerations, before + first, reach + first);
  return of_positions && of_accelerations;
}

bool PeakWatch::settled_by_samples(std::size_t b, const Curves& step, int parts, const double* before, double* reach) {
  const Index n = system_->blocks[b].padded_size;
  const double rate = 1.0 / (step.h * step.h);
  const double chord = step.end * step.end / (8.0 * parts * parts);
  kernels::sample(n, step.c, step.stride, step.degree, {parts, step.end, rate}, samples_.data(), seconds_.data());
  kernels::bound(n, step.c, step.stride, step.degree, step.end, chord, chord * rate, rise_.data(), second_rise_.data());
  const auto look = [&](BoundedOutputs& rows, const VectorXd& samples, const VectorXd& rise, const double* rows_before,
                        double* rows_reach) {
    return kernels::reach_of_samples(rows.weights(), rows.offset.data(), parts + 1, samples.data(), rise.data(),
                                     rows.peak.data(), rows_before, rows_reach);
  };
  const Index first = positions_[b].size();
  const bool positions = look(positions_[b], samples_, rise_, before, reach);
  const bool accelerations = look(accelerations_[b], seconds_, second_rise_, before + first, reach + first);
  return positions && accelerations;
}

Index PeakWatch::count_unsettled(std::size_t b, const double* reach) const {
  const VectorXd& peak = positions_[b].peak;
  const VectorXd& acceleration_peak = accelerations_[b].peak;
  return kernels::count_above(peak.size(), reach, peak.data()) +
         kernels::count_above(acceleration_peak.size(), reach + peak.size(), acceleration_peak.data());
}

void PeakWatch::scan(std::size_t b, const Curves& step, const double* reach) {
  Polynomial row;
  const auto combine = [&](const BoundedOutputs& rows, Index r) {
    row.degree = step.degree;
    kernels::combine(rows.weights(), r, step.c, step.stride, row.degree, rise_.data(), row.coefficients.data());
  };
  BoundedOutputs& positions = positions_[b];
  for (Index r = 0; r < positions.size(); ++r) {
    if (reach[r] <= positions.peak(r)) continue;
    combine(positions, r);
    row[0] += positions.offset(r);
    raise_to_largest(row, step.end, positions.peak(r));
  }
  BoundedOutputs& accelerations = accelerations_[b];
  const double rate = 1.0 / (step.h * step.h);
  for (Index f = 0; f < accelerations.size(); ++f) {
    if (reach[positions.size() + f] <= accelerations.peak(f)) continue;
    combine(accelerations, f);
    raise_to_largest(second_derivative(row, rate), step.end, accelerations.peak(f));
  }
}

void PeakWatch::report(std::size_t b, std::vector<OutputsFound>& outputs) const {
  Index position = 0, acceleration = 0;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Group& group = system_->blocks[b].outputs[k];
    if (!group.has_peak) continue;
    const bool accelerates = group.of_acceleration.size() > 0;
    Index& at = accelerates ? acceleration : position;
    outputs[k].peak = (accelerates ? accelerations_ : positions_)[b].peak.segment(at, group.count());
    at += group.count();
  }
}

}  // namespace bentur::engine
