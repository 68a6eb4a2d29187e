#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/exact/modal_system.h"
#include "bentur/solve/exact/polynomial.h"

namespace bentur::exact {

/// Longest step of a power series as rate · h: with `degree` terms the remainder is below round-off (polynomial.h).
inline constexpr double series_reach = 2.4;

/// Degree that a step needs: the least n with (rate · h)^{n+1}/(n+1)! below that of the longest step.
[[nodiscard]] int needed_degree(double rate_times_h);

/// The solution of (T-1) over one step as a power series in s = (time − start)/h ∈ [0, 1]:
///   c_{k+2} = [h²(−Ω² c_k + γ a_k + Σ_closed push_i F_{i,k}) − h (k+1) D c_{k+1}] / ((k+2)(k+1)).      (T-2)
/// Nothing is diagonalised, so critical damping, repeated or zero frequencies and full damping matrices are all the
/// same.
class Series {
 public:
  explicit Series(const ModalSystem& system);

  /// Expands every building from `state` over a step of `h` [s], with the points marked in `closed` in contact.
  /// rate · h must not exceed series_reach.
  void expand(const State& state, const std::vector<GroundInput>& inputs, double h, const std::vector<char>& closed);

  /// Expands one building alone; the coefficients of the others are left as they were.
  void expand_block(std::size_t block, const State& state, const GroundInput& input, double h);

  /// Position and speed at s; only the coordinates of the last expansion are written.
  void evaluate(double s, State& state) const;

  [[nodiscard]] Polynomial opening(std::size_t point) const;                   ///< g(s) of (T-1) [length]
  [[nodiscard]] Polynomial output(std::size_t block, Eigen::Index row) const;  ///< row of Block::outputs
  [[nodiscard]] Polynomial acceleration(std::size_t block, Eigen::Index floor) const;

  /// Works the bounds below out, of the coordinates of the last expansion.
  void bound();
  /// Bound of |q_j''| with respect to s on [0, 1], one entry per coordinate.
  [[nodiscard]] const Eigen::VectorXd& curvature() const { return curvature_; }
  /// Bound of |d⁴q_j/ds⁴| on [0, 1].
  [[nodiscard]] const Eigen::VectorXd& fourth_derivative() const { return fourth_; }
  [[nodiscard]] double h() const { return h_; }

 private:
  void begin(Eigen::Index first, Eigen::Index count, const State& state, double h, double rate);
  void recur(Eigen::Index first, Eigen::Index count, int k);
  void add_full_damping(const ModalSystem::Block& block, int k);
  void add_contact(const ModalSystem::Point& point, int k);

  const ModalSystem* system_;
  double h_ = 0;
  int degree_ = highest_degree;
  Eigen::Index first_ = 0, count_ = 0;  ///< coordinates of the last expansion
  Eigen::MatrixXd c_;                   ///< coordinates × (highest_degree + 1)
  Eigen::VectorXd stiff_, damp_;        ///< h²Ω², h · diagonal of D
  Eigen::VectorXd force_;               ///< γ a_k h² and contact, for one k
  Eigen::VectorXd curvature_, fourth_;
};

}  // namespace bentur::exact
