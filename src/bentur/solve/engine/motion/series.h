#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {

/// Longest step of a power series as rate · h: with `degree` terms the remainder is below round-off (polynomial.h).
inline constexpr double series_reach = 2.6;

/// Degree that a step needs: the least n with (rate · h)^{n+1}/(n+1)! below that of the longest step, n + 1 a multiple
/// of four.
[[nodiscard]] int needed_degree(double rate_times_h);

/// The solution of (T-1) over one step as a power series:
///   c_{k+2} = [h²(−Ω² c_k + γ a_k + Σ push_i F_{i,k}) − h (k+1) D c_{k+1}] / ((k+2)(k+1)).      (T-2)
/// Nothing is diagonalised, so critical damping, repeated or zero frequencies and full damping matrices are all the
/// same. Nonlinear forces are left out.
class Series {
 public:
  /// `offsets`: of each element's δ [length].
  Series(const ModalSystem& system, std::vector<double> offsets);

  /// Expands every body from `state` over a step of `h` [s] under the linear and resting forces.
  /// rate · h must not exceed series_reach.
  void expand(const State& state, const std::vector<GroundInput>& inputs, double h, const ElementForces& forces,
              Expansion& motion);

  /// Expands some bodies alone under linear forces of elements between them: no damping of
  /// theirs is full, none has force coordinates. @param rate growth bound of all of it [1/s]
  void expand_some(const std::vector<Eigen::Index>& bodies, const State& state, const std::vector<GroundInput>& inputs,
                   double h, double rate, const std::vector<Eigen::Index>& pressing,
                   const std::vector<ElementForces::Linear>& linear, Expansion& motion);

  /// Expands one body alone, under its constant forces, to the degree that a growth bound `rate` [1/s] of its own or a
  /// larger one needs; the coefficients of the others are left as they were.
  void expand_block(std::size_t block, const State& state, const GroundInput* input, double h, double rate,
                    Expansion& motion);

 private:
  void note_grounds(std::size_t first, std::size_t end, const GroundInput* input, double h);
  void note_ground(std::size_t body, const GroundInput* input, double h);
  void note_pressing(const std::vector<Eigen::Index>& pressing, const std::vector<ElementForces::Linear>& linear,
                     double h, Expansion& motion);
  void begin(Eigen::Index first, Eigen::Index count, const State& state, double h, double rate, Expansion& motion);
  [[nodiscard]] const double* scaled(const double* load, Eigen::Index first, Eigen::Index count);
  void expand_term_by_term(Eigen::Index first, Eigen::Index count, const double* load, const ElementForces& forces,
                           Expansion& motion);
  void add_full_damping(const ModalSystem::Block& block, int k);
  void add_pressing(Eigen::Index element, const ElementForces::Linear& force, int k);
  void add_coupled(const ElementForces::Coupled& of, int k);
  void hold(const std::vector<Eigen::Index>& resting, int k);

  const ModalSystem* system_;
  std::vector<double> offsets_;
  double h_ = 0;
  Eigen::MatrixXd* c_ = nullptr;                ///< coefficients of the motion being expanded
  Eigen::VectorXd stiff_, damp_;                ///< h²Ω², h · diagonal of D
  Eigen::VectorXd force_;                       ///< γ a_k h² and elements, for one k
  Eigen::VectorXd load_;                        ///< scratch: constant load, then h² times that
  Eigen::VectorXd along_, pushes_;              ///< scratch: of coupled elements, for one k
  std::vector<kernels::GroundSeries> grounds_;  ///< scratch: of the first component …
  std::vector<kernels::GroundSeries> further_;  ///< … and the others
  std::vector<kernels::Pressing> pressing_;
  std::vector<kernels::Tied> tied_;
  std::vector<Polynomial> resting_force_;  ///< of the elements held, in their order
};

}  // namespace bentur::engine
