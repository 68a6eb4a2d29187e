#pragma once

#include <Eigen/Core>
#include <memory>

namespace bentur {

// Dense factorisations by Eigen, instantiated in one source: each costs a compiler seconds wherever it is spelt.
// Matrices have any consistent dimension; expressions are evaluated when they are passed. Nothing throws: what cannot
// be factorised is known by is_positive_definite() and pivots(), and solutions of it are not finite or meaningless.

/// A = LLᵀ of a symmetric positive definite n × n matrix, of which the lower triangle is read.
class Cholesky {
 public:
  explicit Cholesky(const Eigen::MatrixXd& a);
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;
  ~Cholesky();

  /// Whether A was, to round-off.
  [[nodiscard]] bool is_positive_definite() const;

  /// L, n × n, zeros above the diagonal.
  [[nodiscard]] Eigen::MatrixXd lower() const;

  /// A⁻¹ b of a vector of n entries, or of a matrix of n rows.
  template <class Right>
  [[nodiscard]] auto solve(const Eigen::MatrixBase<Right>& b) const {
    if constexpr (Right::ColsAtCompileTime == 1) {
      return solve_vector(b.derived());
    } else {
      return solve_matrix(b.derived());
    }
  }

 private:
  struct Factors;
  [[nodiscard]] Eigen::VectorXd solve_vector(const Eigen::VectorXd& b) const;
  [[nodiscard]] Eigen::MatrixXd solve_matrix(const Eigen::MatrixXd& b) const;

  std::unique_ptr<const Factors> factors_;
};

/// A = PᵀLDLᵀP of a symmetric n × n matrix, pivots chosen by size, of which the lower triangle is read.
class Ldlt {
 public:
  explicit Ldlt(const Eigen::MatrixXd& a);
  Ldlt(const Ldlt&) = delete;
  Ldlt& operator=(const Ldlt&) = delete;
  ~Ldlt();

  /// D, n entries, the largest first: all of A's sign where A is definite.
  [[nodiscard]] Eigen::VectorXd pivots() const;

  /// Whether the least pivot is more than `part` [-] of the largest one.
  [[nodiscard]] bool is_definite(double part) const;

  /// A⁻¹ b of a vector of n entries, or of a matrix of n rows; zero along pivots that are zero.
  template <class Right>
  [[nodiscard]] auto solve(const Eigen::MatrixBase<Right>& b) const {
    if constexpr (Right::ColsAtCompileTime == 1) {
      return solve_vector(b.derived());
    } else {
      return solve_matrix(b.derived());
    }
  }

 private:
  struct Factors;
  [[nodiscard]] Eigen::VectorXd solve_vector(const Eigen::VectorXd& b) const;
  [[nodiscard]] Eigen::MatrixXd solve_matrix(const Eigen::MatrixXd& b) const;

  std::unique_ptr<const Factors> factors_;
};

/// Whether a symmetric matrix is positive definite to round-off, by its Cholesky factors.
[[nodiscard]] bool is_positive_definite(const Eigen::MatrixXd& a);

/// A⁻¹ B of any regular n × n matrix, by LU with row pivots; B is n × m.
[[nodiscard]] Eigen::MatrixXd solve_general(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x of least norm among those that make |A x − b| least, by a complete orthogonal decomposition of A (m × n); b has m
/// entries. Singular values below `apart` [-] of the largest pivot are none; without it, below round-off.
[[nodiscard]] Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
[[nodiscard]] Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double apart);

/// x for which xᵀ `rows` is nearest to `row`, by QR with column pivots: an entry for each of the rows.
[[nodiscard]] Eigen::VectorXd combination_of(const Eigen::MatrixXd& rows, const Eigen::RowVectorXd& row);

}  // namespace bentur
