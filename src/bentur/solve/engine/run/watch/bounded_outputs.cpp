#include "bentur/solve/engine/run/watch/bounded_outputs.h"

#include <cmath>

#include "bentur/solve/engine/motion/step_buffer.h"

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

BoundedOutputs::BoundedOutputs(const Eigen::MatrixXd& weights, Index columns, kernels::Peaks of)
    : of_(of),
      weights_(weights, columns),
      lumped_(VectorXd::Zero(columns)),
      shares_(StepBuffer::most + 1),
      betweens_(StepBuffer::most) {
  peak.setZero(weights_.rows());
  offset.setZero(weights_.rows());
  inverse_.setZero(weights_.rows());
}

void BoundedOutputs::limit(const VectorXd& limits) {
  inverse_ = limits.cwiseInverse();
  kernels::lump(weights_, limits.data(), lumped_.data());
}

void BoundedOutputs::raise(Index steps, const double* x, const double* rise, Index stride) {
  take_ends(steps, x, stride);
  limit(peak);
  measure(steps, rise, stride);
}

void BoundedOutputs::compare(Index steps, const double* x, const double* rise, Index stride) {
  take_ends(steps, x, stride);
  measure(steps, rise, stride);
}

void BoundedOutputs::take_ends(Index steps, const double* x, Index stride) {
  ends_ = steps + 1;
  if (const Index needed = weights_.rows() * ends_; values_.size() < needed) values_.resize(needed);
  if (!part_columns(x, stride)) {
    kernels::raise_peaks(of_, weights_, offset.data(), ends_, x, stride, peak.data(), values_.data());
    return;
  }
  const kernels::PackedRows::Columns still = weights_.chosen(stays_), moving = weights_.chosen(moves_);
  base_.resize(weights_.rows());
  none_.setZero(weights_.rows());
  kernels::raise_peaks(kernels::Peaks::of_values, weights_, offset.data(), 1, x, stride, none_.data(), base_.data(),
                       &still);
  kernels::raise_peaks(of_, weights_, base_.data(), ends_, x, stride, peak.data(), values_.data(), &moving);
}

/// Tells columns that stay what they are at all ends from those that do not: of many hinges few turn at a time. False
/// where that is not worth while.
bool BoundedOutputs::part_columns(const double* x, Index stride) {
  constexpr Index many = 32, few_ends = 16;
  const std::span<const kernels::PackedRows::Run> runs = weights_.runs();
  if (weights_.columns() < many || ends_ < few_ends) return false;
  moves_.assign(weights_.columns(), 0);
  stays_.assign(weights_.columns(), 0);
  Index still = 0;
  for (const kernels::PackedRows::Run& run : runs) {
    for (Index j = run.begin; j < run.end; ++j) {
      Index n = 1;
      while (n < ends_ && x[n * stride + j] == x[j]) ++n;
      (n == ends_ ? stays_ : moves_)[j] = 1;
      still += n == ends_ ? 1 : 0;
    }
  }
  return still >= many / 2;
}

void BoundedOutputs::measure(Index steps, const double* rise, Index stride) {
  kernels::largest_shares(size(), ends_, values_.data(), inverse_.data(), shares_.data());
  kernels::sums(steps, rise, stride, weights_.runs(), lumped_.data(), betweens_.data());
}

double BoundedOutputs::rise(Index quantity, const double* rise) const {
  double sum = 0.0;
  for (const kernels::PackedRows::Run& run : weights_.runs()) {
    const double* weights = weights_.from(quantity / 4 * 4, run) + quantity % 4;
    for (Index j = run.begin; j < run.end; ++j) sum += std::abs(weights[4 * j]) * rise[j];
  }
  return sum;
}

void BoundedOutputs::mark_unsettled(Index step, double* before) const {
  const double* at = values_.data() + 4 * step;
  kernels::mark_unsettled(size(), at, at + 4, ends_, peak.data(), 1.0 - betweens_(step), before);
}

}  // namespace bentur::engine
