#include "bentur/solve/engine/run/sampler.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {
constexpr double slack = 1e-9;  // of a step: a sample this near the end of an interval belongs to it
}

Sampler::Sampler(const ModalSystem& system, const Problem& problem, double output_step)
    : system_(&system), problem_(&problem), step_(output_step) {
  if (step_ <= 0.0) return;
  count_ = static_cast<Index>(std::floor(problem.duration / step_ + slack)) + 1;
  state_.q.setZero(system.size);
  state_.v.setZero(system.size);
  for (const auto& block : system.blocks) {
    histories_.displacement.emplace_back(MatrixXd::Zero(block.floors, count_));
    histories_.velocity.emplace_back(MatrixXd::Zero(block.floors, count_));
    histories_.acceleration.emplace_back(MatrixXd::Zero(block.floors, count_));
    histories_.drift_ratio.emplace_back(MatrixXd::Zero(block.floors, count_));
    histories_.storey_shear.emplace_back(MatrixXd::Zero(block.floors, count_));
  }
  const auto points = static_cast<Index>(system.points.size());
  histories_.opening = MatrixXd::Zero(points, count_);
  histories_.force = MatrixXd::Zero(points, count_);
}

bool Sampler::due(double time) const { return taken_ < count_ && next_time() <= time + slack * step_; }

void Sampler::take(const Expansion& motion, double time, double until, const std::vector<GroundInput>& inputs,
                   const Contacts& contacts) {
  for (; due(until); ++taken_) {
    const double s = std::clamp((next_time() - time) / motion.h(), 0.0, 1.0);
    motion.evaluate(s, state_);
    std::vector<GroundInput> now = inputs;
    system_->advance(now, s * motion.h());
    contacts.forces_at(state_, now, forces_);
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
      histories_.velocity[b].col(taken_) = rows * state_.v.segment(block.begin, block.size);
      histories_.acceleration[b].col(taken_) = block.acceleration * acceleration_.segment(block.begin, block.size);
    }
    for (std::size_t i = 0; i < system_->points.size(); ++i) {
      const double opening = problem_->points[i].width + system_->points[i].sense(state_.q);
      const auto row = static_cast<Index>(i);
      histories_.opening(row, taken_) = opening;
      histories_.force(row, taken_) = forces_(row);
    }
  }
}

void Sampler::finish() {
  if (taken_ == count_) return;
  for (auto* list : {&histories_.displacement, &histories_.velocity, &histories_.acceleration, &histories_.drift_ratio,
                     &histories_.storey_shear}) {
    for (MatrixXd& matrix : *list) matrix.conservativeResize(Eigen::NoChange, taken_);
  }
  histories_.opening.conservativeResize(Eigen::NoChange, taken_);
  histories_.force.conservativeResize(Eigen::NoChange, taken_);
}

}  // namespace bentur::engine
