#pragma once

#include <Eigen/Core>

namespace bentur {

// Eigenvalues and eigenvectors of symmetric matrices, instantiated here once (see factors.h). Of a matrix the lower
// triangle is read. Expressions are evaluated when they are passed.

/// A v = λ v, or A v = λ B v.
struct SymmetricModes {
  Eigen::VectorXd values;   ///< λ, n entries, ascending
  Eigen::MatrixXd vectors;  ///< v, n × n, a column each: vᵀ v = 1, or vᵀ B v = 1
  bool converged = true;    ///< whether the iteration did
};

/// Of a symmetric n × n matrix.
[[nodiscard]] SymmetricModes symmetric_modes(const Eigen::MatrixXd& a);
[[nodiscard]] SymmetricModes symmetric_modes_of_3(const Eigen::Matrix3d& a);

/// λ alone, ascending.
[[nodiscard]] Eigen::VectorXd symmetric_values(const Eigen::MatrixXd& a);

/// A^(−1/2) of a symmetric positive definite n × n matrix: symmetric itself.
[[nodiscard]] Eigen::MatrixXd inverse_square_root(const Eigen::MatrixXd& a);

/// Of A v = λ B v, A symmetric and B symmetric positive definite, both n × n; what B is, is not looked at.
[[nodiscard]] SymmetricModes generalised_modes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// λ alone, ascending.
[[nodiscard]] Eigen::VectorXd generalised_values(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace bentur
