#include "bentur/solve/engine/motion/runge_kutta/fixed_step.h"

namespace bentur::engine {

FixedStep::FixedStep(const ModalSystem& system) : system_(&system), forces_(std::ssize(system.elements)) {}

/// q̈ at a state `after` [s] the start of the step.
void FixedStep::accelerate(const State& state, double after, const ForceFunction& forces, Eigen::VectorXd& result) {
  inputs_at_ = inputs_;
  system_->advance(inputs_at_, after);
  forces(state, inputs_at_, forces_);
  system_->acceleration(state, inputs_at_, forces_, result);
}

void FixedStep::step(const State& from, const std::vector<GroundInput>& inputs, double h, const ForceFunction& forces,
                     State& to) {
  from_ = from;
  inputs_ = inputs;
  h_ = h;
  accelerate(from_, 0.0, forces, k1_);
  at_.q = from_.q + h / 2 * from_.v;
  at_.v = from_.v + h / 2 * k1_;
  accelerate(at_, h / 2, forces, k2_);
  at_.q = from_.q + h / 2 * (from_.v + h / 2 * k1_);
  at_.v = from_.v + h / 2 * k2_;
  accelerate(at_, h / 2, forces, k3_);
  at_.q = from_.q + h * (from_.v + h / 2 * k2_);
  at_.v = from_.v + h * k3_;
  accelerate(at_, h, forces, k4_);
  bend_ = h * h / 6 * (k1_ + k2_ + k3_);
  gain_ = h * h / 6 * (k1_ + 2 * k2_ + 2 * k3_ + k4_);
  to_.q = from_.q + (h * from_.v + bend_);
  to_.v = from_.v + h / 6 * (k1_ + 2 * k2_ + 2 * k3_ + k4_);
  to = to_;
}

void FixedStep::expand(const ForceFunction& forces, Expansion& motion) {
  accelerate(to_, h_, forces, k4_);
  const auto a0 = h_ * h_ * k1_;
  const auto a1 = h_ * h_ * k4_;
  auto& c = motion.coefficients();
  c.rightCols(highest_degree - degree).setZero();
  c.col(0) = from_.q;
  c.col(1) = h_ * from_.v;
  c.col(2) = 0.5 * a0;
  // From what k's add up to, not from differences of q and v, of which nothing is left in a step that is very short.
  c.col(3) = 10.0 * bend_ - 4.0 * gain_ - 1.5 * a0 + 0.5 * a1;
  c.col(4) = -15.0 * bend_ + 7.0 * gain_ + 1.5 * a0 - a1;
  c.col(5) = 6.0 * bend_ - 3.0 * gain_ - 0.5 * a0 + 0.5 * a1;
}

}  // namespace bentur::engine
