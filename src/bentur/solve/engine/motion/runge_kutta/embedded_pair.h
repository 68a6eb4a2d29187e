#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"

namespace bentur::engine {

/// Force of every element [force] at a state and ground input; what a Runge-Kutta stage asks for.
using ForceFunction = std::function<void(const State&, const std::vector<GroundInput>&, Eigen::VectorXd&)>;

/// Bodies [first, end) of the row.
struct BodyRange {
  Eigen::Index first = 0, end = 0;
};

/// The explicit Runge-Kutta pair of Dormand and Prince of order 8(5,3) with its interpolant of order 7
/// ([HairerNorsettWanner1993], II.5 and II.10) on (T-1), for a range of bodies that no element joins to others. As q̇
/// = v the positions of all stages follow from the accelerations, q_i = q + c_i h v + h² Σ_j (a²)_ij v̇_j.
///
/// Errors are measured in speeds, with positions as what they would make of them in one step: the local error is the
/// norm of (e_q/h, e_v) over that of the motion, √(v² + Ω²q²) at both ends, the change of v, and what the ground alone
/// would change of it: a body that is held still against its neighbour has no other. As coordinates are normalised
/// by mass this is an error of the square root of energy; ground coordinates, which are not, have no part in it.
class EmbeddedPair {
 public:
  EmbeddedPair(const ModalSystem& system, double tolerance);

  /// Tries to move the range from `from` to `to` over `h` [s], and returns local error/tolerance: more than 1 is a step
  /// not to be accepted, NaN one that has left the numbers. The other coordinates of `to` are not written.
  double step(const State& from, const std::vector<GroundInput>& inputs, double h, BodyRange range,
              const ForceFunction& forces, State& to);

  /// The step last tried as polynomials of degree 8 in q (7 in v); other coordinates are left as they were. Degree and
  /// range of the expansion are for its owner to set.
  void expand(const ForceFunction& forces, Expansion& motion);

  /// How far the interpolant of the step last tried is from (T-1) where it is worst, over what is allowed: 100 times
  /// the tolerance; more than 1 is a step not to be accepted. As the interpolant is one order lower than the step,
  /// where a force damps strongly it can be much worse. @param motion the expansion that expand() has filled
  double defect(const ForceFunction& forces, const Expansion& motion);

  static constexpr int degree = 8;

 private:
  void stage(int i, const ForceFunction& forces);

  const ModalSystem* system_;
  double tolerance_;
  // The step last tried.
  const std::vector<GroundInput>* inputs_ = nullptr;
  double h_ = 0;
  double size_ = 0;                     ///< of the motion
  Eigen::Index begin_ = 0, count_ = 0;  ///< coordinates of the range
  State start_;
  Eigen::MatrixXd rate_;  ///< v̇ of each stage, coordinates × stages
  State at_;              ///< of a stage
  std::vector<GroundInput> inputs_at_;
  Eigen::VectorXd forces_, acceleration_, slope_;
};

}  // namespace bentur::engine
