#pragma once

#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/elements.h"

namespace bentur::engine {

/// Compares what the states of some contacts say with the impulses that are reported of them: over the steps from the
/// last instant without any contact to the next one, by (T-1),
///   q̇ − q̇₀ = −Ω² ∫q dt − D (q − q₀) + γ (v_g − v_g0) + Σ push_i ∫F_i dt
/// of the modes of every body. Of the 1st, 4th, 16th, 64th, … of these, so that it costs next to nothing.
class MomentumBalance {
 public:
  explicit MomentumBalance(const ModalSystem& system);

  /// [0, end] of the expanded step from `from`; `meets`: two bodies meet at its end.
  void take(const Expansion& motion, double end, const State& from, Elements& elements, bool meets);
  /// Elements have changed, and this is the state then.
  void changed(const State& state, Elements& elements);

  /// The largest difference so far, as a part of the largest term [-].
  [[nodiscard]] double worst() const { return worst_; }

 private:
  void push_others(const Expansion& motion, double length, const Elements& elements);
  void close(const State& state, Elements& elements);

  const ModalSystem* system_;
  bool under_way_ = false;
  long seen_ = 0, next_ = 1, steps_ = 0;
  std::size_t impacts_before_ = 0;
  State start_;
  Eigen::VectorXd shift_, pushed_;  ///< ∫q dt, and what elements other than contacts have pushed
  Eigen::VectorXd of_step_, end_;   ///< scratch: ∫q dt of a step, and q at its end
  Eigen::VectorXd weights_;         ///< scratch: per coefficient
  double worst_ = 0;
};

/// How far the forces on each body are out of balance by its own matrices and the laws, with the accelerations of
/// (T-1), as a part of the largest of them [-]: M ẍ + C ẋ + K x + load a_g = all elements. Of what its modes can see.
[[nodiscard]] double force_imbalance(const System& given, const ModalSystem& system, const State& state,
                                     const std::vector<GroundInput>& inputs, const Elements& elements);

}  // namespace bentur::engine
