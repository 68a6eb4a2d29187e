#include "bentur/solve/engine/run/sampler.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {
constexpr Index together = 64;  // instants whose outputs are one product of matrices
}

Index sample_count(double duration, double step) {
  return static_cast<Index>(std::floor(duration / step + sample_slack)) + 1;
}

Sampler::Sampler(const ModalSystem& system, const System& given, const std::vector<double>& offsets, double output_step)
    : system_(&system), given_(&given), offsets_(offsets), step_(output_step) {
  if (step_ <= 0.0) return;
  count_ = sample_count(given.duration, step_);
  state_.q.setZero(system.size);
  state_.v.setZero(system.size);
  for (const auto& block : system.blocks) {
    std::vector<MatrixXd>& lists = outputs_.emplace_back();
    for (const auto& group : block.outputs) lists.emplace_back(MatrixXd::Zero(group.count(), count_));
  }
  q_.resize(system.size, together);
  v_ = a_ = q_;
  largest_q_.resize(system.blocks.size(), 0.0);
  largest_acceleration_ = largest_q_;
  samples_.ground_acceleration = MatrixXd::Zero(system.components(), count_);
  samples_.opening = samples_.force = MatrixXd::Zero(system.points(), count_);
  samples_.slip = samples_.force_along = MatrixXd::Zero(system.rubbing, count_);
  samples_.joint_deformation = samples_.joint_force = MatrixXd::Zero(system.joints, count_);
}

bool Sampler::due(double time) const { return taken_ < count_ && next_time() <= time + sample_slack * step_; }

void Sampler::take(const Expansion& motion, double time, double until, const std::vector<GroundInput>& inputs,
                   const Elements& elements) {
  while (due(until)) {
    const double s = std::clamp((next_time() - time) / motion.h(), 0.0, 1.0);
    motion.evaluate(s, state_);
    std::vector<GroundInput> now = inputs;
    system_->advance(now, s * motion.h());
    take(state_, now, elements);
  }
}

void Sampler::take(const State& state, const std::vector<GroundInput>& inputs, const Elements& elements) {
  elements.forces_at(state, inputs, forces_);
  system_->acceleration(state, inputs, forces_, acceleration_);
  samples_.time.push_back(next_time());
  for (Index c = 0; c < system_->components(); ++c) {
    samples_.ground_acceleration(c, taken_) = acceleration_at(given_->motions[c], next_time());
  }
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto& block = system_->blocks[b];
    const auto squared = [&](const Eigen::VectorXd& x) { return x.segment(block.begin, block.modes).squaredNorm(); };
    largest_q_[b] = std::max(largest_q_[b], squared(state.q));
    largest_acceleration_[b] = std::max(largest_acceleration_[b], squared(acceleration_));
  }
  const Index waiting = taken_ - multiplied_;
  q_.col(waiting) = state.q.head(q_.rows());
  v_.col(waiting) = state.v.head(q_.rows());
  a_.col(waiting) = acceleration_.head(q_.rows());
  for (Index point = 0; point < system_->points(); ++point) {
    const Index i = system_->opening(point);
    samples_.opening(point, taken_) = -offsets_[i] - system_->elements[i].relation.along(state.q);
    samples_.force(point, taken_) = forces_(i);
    if (point < system_->switched) continue;
    samples_.slip(point - system_->switched, taken_) = system_->elements[i + 1].relation.along(state.q);
    samples_.force_along(point - system_->switched, taken_) = forces_(i + 1);
  }
  for (Index i = 0; i < system_->joints; ++i) {
    samples_.joint_deformation(i, taken_) = system_->elements[system_->joint(i)].relation.along(state.q);
    samples_.joint_force(i, taken_) = forces_(system_->joint(i));
  }
  ++taken_;
  if (taken_ - multiplied_ == together) multiply();
}

void Sampler::multiply() {
  const Index count = taken_ - multiplied_;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto& block = system_->blocks[b];
    for (std::size_t k = 0; k < block.outputs.size(); ++k) {
      auto result = outputs_[b][k].middleCols(multiplied_, count);
      block.outputs[k].evaluate(q_.block(block.begin, 0, block.size, count),
                                v_.block(block.begin, 0, block.size, count),
                                a_.block(block.begin, 0, block.size, count), result);
    }
  }
  multiplied_ = taken_;
}

void Sampler::finish(Solution& solution) {
  if (taken_ > multiplied_) multiply();
  const auto cut = [this](MatrixXd& matrix) {
    if (taken_ < count_) matrix.conservativeResize(Eigen::NoChange, taken_);
  };
  for (std::size_t b = 0; b < outputs_.size(); ++b) {
    for (std::size_t k = 0; k < outputs_[b].size(); ++k) {
      cut(outputs_[b][k]);
      const ModalSystem::Block& block = system_->blocks[b];
      Eigen::VectorXd& size = solution.outputs[b][k].size;
      size.setZero(block.outputs[k].count());
      const auto add = [&](const MatrixXd& rows, double squared) {
        if (rows.size() > 0) size += rows.leftCols(block.modes).rowwise().norm() * std::sqrt(squared);
      };
      add(block.outputs[k].of_position, largest_q_[b]);
      add(block.outputs[k].of_acceleration, largest_acceleration_[b]);
      solution.outputs[b][k].history = std::move(outputs_[b][k]);
    }
  }
  for (MatrixXd* matrix : {&samples_.ground_acceleration, &samples_.opening, &samples_.force, &samples_.slip,
                           &samples_.force_along, &samples_.joint_deformation, &samples_.joint_force}) {
    cut(*matrix);
  }
  solution.samples = std::move(samples_);
}

}  // namespace bentur::engine
