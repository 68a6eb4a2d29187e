#include "bentur/solve/engine/run/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// Those of columns that are struck, of foundations, and of hinges.
std::array<std::vector<MatrixXd>*, 5> of_some(Histories& h) {
  return {&h.node_displacement, &h.column_forces, &h.foundation, &h.hinge_moment, &h.hinge_rotation};
}

/// Those of every floor or storey.
std::array<std::vector<MatrixXd>*, 5> of_floors(Histories& h) {
  return {&h.displacement, &h.velocity, &h.acceleration, &h.drift_ratio, &h.storey_shear};
}

}  // namespace

Index sample_count(double duration, double step) {
  return static_cast<Index>(std::floor(duration / step + sample_slack)) + 1;
}

Sampler::Sampler(const ModalSystem& system, const Problem& problem, double output_step)
    : system_(&system), problem_(&problem), step_(output_step) {
  if (step_ <= 0.0) return;
  count_ = sample_count(problem.duration, step_);
  state_.q.setZero(system.size);
  state_.v.setZero(system.size);
  for (const auto& block : system.blocks) {
    for (auto* list : of_floors(histories_)) list->emplace_back(MatrixXd::Zero(block.floors, count_));
    histories_.node_displacement.emplace_back(MatrixXd::Zero(block.nodes.rows(), count_));
    histories_.column_forces.emplace_back(MatrixXd::Zero(block.column_forces, count_));
    for (auto* list : {&histories_.hinge_moment, &histories_.hinge_rotation}) {
      list->emplace_back(MatrixXd::Zero(block.hinges, count_));
    }
    histories_.foundation.emplace_back(MatrixXd::Zero(block.has_foundation ? 4 : 0, count_));
  }
  const Index points = system.switched;
  histories_.opening = MatrixXd::Zero(points, count_);
  histories_.force = MatrixXd::Zero(points, count_);
  const Index links = std::ssize(problem.links);
  histories_.link_deformation = MatrixXd::Zero(links, count_);
  histories_.link_force = MatrixXd::Zero(links, count_);
}

bool Sampler::due(double time) const { return taken_ < count_ && next_time() <= time + sample_slack * step_; }

void Sampler::take(const Expansion& motion, double time, double until, const std::vector<GroundInput>& inputs,
                   const Elements& elements) {
  for (; due(until); ++taken_) {
    const double s = std::clamp((next_time() - time) / motion.h(), 0.0, 1.0);
    motion.evaluate(s, state_);
    std::vector<GroundInput> now = inputs;
    system_->advance(now, s * motion.h());
    elements.forces_at(state_, now, forces_);
    system_->acceleration(state_, now, forces_, acceleration_);
    histories_.time.push_back(next_time());
    histories_.ground_acceleration.push_back(acceleration_at(problem_->motion, next_time()));
    for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
      const auto& block = system_->blocks[b];
      const auto rows = block.outputs.topRows(block.floors);
      const auto q = state_.q.segment(block.begin, block.size);
      histories_.displacement[b].col(taken_) = rows * q;
      histories_.drift_ratio[b].col(taken_) = block.outputs.middleRows(block.floors, block.floors) * q;
      histories_.storey_shear[b].col(taken_) = block.outputs.middleRows(2 * block.floors, block.floors) * q;
      histories_.node_displacement[b].col(taken_) = block.nodes * q.head(block.modes);
      histories_.column_forces[b].col(taken_) = block.outputs.middleRows(3 * block.floors, block.column_forces) * q;
      const Index moments = 3 * block.floors + block.column_forces;
      histories_.hinge_moment[b].col(taken_) =
          block.outputs.middleRows(moments, block.hinges) * q + block.offsets.segment(moments, block.hinges);
      histories_.hinge_rotation[b].col(taken_) = -q.segment(block.rotations, block.hinges);
      histories_.foundation[b].col(taken_) = block.foundation(state_);
      histories_.velocity[b].col(taken_) = rows * state_.v.segment(block.begin, block.size);
      histories_.acceleration[b].col(taken_) = block.acceleration * acceleration_.segment(block.begin, block.size);
    }
    for (Index i = 0; i < system_->switched; ++i) {
      histories_.opening(i, taken_) = problem_->points[i].width - system_->elements[i].relation.along(state_.q);
      histories_.force(i, taken_) = forces_(i);
    }
    for (Index i = 0; i < histories_.link_force.rows(); ++i) {
      histories_.link_deformation(i, taken_) = system_->elements[system_->link(i)].relation.along(state_.q);
      histories_.link_force(i, taken_) = forces_(system_->link(i));
    }
  }
}

void Sampler::finish() {
  if (taken_ == count_) return;
  const auto cut = [&](std::vector<MatrixXd>& list) {
    for (MatrixXd& matrix : list) matrix.conservativeResize(Eigen::NoChange, taken_);
  };
  for (auto* list : of_floors(histories_)) cut(*list);
  for (auto* list : of_some(histories_)) cut(*list);
  for (MatrixXd* matrix :
       {&histories_.opening, &histories_.force, &histories_.link_deformation, &histories_.link_force}) {
    matrix->conservativeResize(Eigen::NoChange, taken_);
  }
}

}  // namespace bentur::engine
