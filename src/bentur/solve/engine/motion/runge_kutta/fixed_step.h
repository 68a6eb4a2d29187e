#pragma once

#include "bentur/solve/engine/motion/runge_kutta/embedded_pair.h"

namespace bentur::engine {

/// One step of the monograph's fourth-order scheme (section 3.4) on (T-1). Written for q̈ = a(t, q, v) it is the
/// classical Runge-Kutta rule: k₁ … k₄ = h a at the start, twice in the middle and at the end,
///   q⁺ = q + h (v + (k₁ + k₂ + k₃)/6),   v⁺ = v + (k₁ + 2k₂ + 2k₃ + k₄)/6.                         
class FixedStep {
 public:
  explicit FixedStep(const ModalSystem& system);

  void step(const State& from, const std::vector<GroundInput>& inputs, double h, const ForceFunction& forces,
            State& to);

  /// The step last taken as the polynomial of degree 5 with the same q, v and q̈ at both ends.
  void expand(const ForceFunction& forces, Expansion& motion);

  static constexpr int degree = 5;

 private:
  void accelerate(const State& state, double after, const ForceFunction& forces, Eigen::VectorXd& result);

  const ModalSystem* system_;
  std::vector<GroundInput> inputs_, inputs_at_;
  double h_ = 0;
  State from_, at_, to_;
  Eigen::VectorXd forces_, k1_, k2_, k3_, k4_;
  Eigen::VectorXd bend_, gain_;  ///< q⁺ − q − h v and h (v⁺ − v)
};

}  // namespace bentur::engine
