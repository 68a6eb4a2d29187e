#pragma once

#include <Eigen/Core>
#include <optional>

namespace bentur::engine {

/// Impulses P ≥ 0 of points that collide at one instant: y = A P − b ≥ 0 with y_i P_i = 0, so that a point either is
/// pushed apart just as fast as its restitution says (b_i = (1 + e_i) δ̇_i⁻) or is not pushed and opens faster than
/// that. A [1/mass] symmetric positive definite, b [length/s]; P [force·s]. Murty's principal pivoting: finite, exact.
/// Nothing where the pivoting does not end, as A is not positive definite. (E-1)
[[nodiscard]] std::optional<Eigen::VectorXd> impulses(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace bentur::engine
