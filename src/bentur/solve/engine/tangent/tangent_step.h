#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/engine/tangent/dependence.h"

namespace bentur::engine {

/// Where the coordinates are, and their derivatives by every parameter, a column each.
struct TangentState {
  Eigen::VectorXd q, v;
  Eigen::MatrixXd by_q, by_v;
};

/// The ground's motion from some instant on, per body and component, and its derivatives.
struct TangentInputs {
  std::vector<GroundInput> inputs;
  Eigen::MatrixXd values, slopes;
  bool moves = false;  ///< some of these are not zero

  /// So much [s] later.
  void advance(const ModalSystem& modal, const Dependence& by, double dt);
};

/// An element with a force that is not constant: F = base + stiffness δ + damping δ̇, and how that depends.
struct Pressing {
  Eigen::Index element = 0;
  ElementForces::Linear force;
  Eigen::RowVectorXd base, stiffness, damping;
};

/// Takes a state and its derivatives along (S-1) by one power series of both: the recursion (T-2) and its derivative.
class TangentStep {
 public:
  TangentStep(const ModalSystem& modal, const Dependence& by);

  /// From `state` over `h` [s], no longer than longest().
  void advance(TangentState& state, const TangentInputs& at, const std::vector<Pressing>& pressing,
               const std::vector<double>& offsets, double h);
  /// The longest step that a few dozen terms follow to round-off [s].
  [[nodiscard]] double longest(const std::vector<Pressing>& pressing) const;
  /// Coefficients of q over the last step, whose end is 1: a column each.
  [[nodiscard]] Eigen::Ref<const Eigen::MatrixXd> coefficients() const { return kept_.leftCols(terms_); }

  /// q̈ at a state.
  void accelerations(const TangentState& state, const TangentInputs& at, const std::vector<Pressing>& pressing,
                     const std::vector<double>& offsets, Eigen::VectorXd& a);

 private:
  struct Terms {
    Eigen::VectorXd q, v;        ///< v in lengths a step
    Eigen::MatrixXd by_q, by_v;  ///< likewise
  };
  void accelerate(double rate, bool first, const std::vector<Pressing>& pressing, const std::vector<double>& offsets);
  void go_on_with_inputs(Eigen::Index k, double h);

  const ModalSystem* modal_;
  const Dependence* by_;
  Eigen::VectorXd a_, column_, product_;
  Eigen::MatrixXd by_a_, kept_;
  Terms term_, sums_;
  std::vector<double> u_, u_next_;  ///< of the inputs, the term under way and the next
  Eigen::MatrixXd by_u_, by_u_next_;
  bool moves_ = false;
  Eigen::Index terms_ = 0;
};

/// The derivatives of a row at a state, or of any such coordinates.
[[nodiscard]] Eigen::RowVectorXd along(const ModalSystem::Relation& relation, const Eigen::MatrixXd& x);

}  // namespace bentur::engine
