#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace bentur {

/// The p ≥ 0 with y = A p − b ≥ 0 and y_i p_i = 0 for every i: of what pushes, how hard it does, and that the rest need
/// not. A symmetric positive semidefinite; b no part of A's null vectors points to larger p, as where A p = b can be
/// met. Where A is singular any p serves that has no more entries above zero than A can tell apart; A p is unique.
/// Minimises ½ pᵀA p − bᵀp by active sets [LawsonHanson1974], which ends as each set is better than the one before; of
/// y less than 2⁻⁴⁸ of b's largest entry is round-off. Nothing where that does not end, as A is not positive
/// semidefinite. `guess`: those that may push, ascending, to begin with. (E-1), (H-7)
[[nodiscard]] std::optional<Eigen::VectorXd> complementary(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                                           std::vector<Eigen::Index> guess = {});

/// The same with the last `free` of p of either sign, for which a p = b.
[[nodiscard]] std::optional<Eigen::VectorXd> complementary(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                                           Eigen::Index free);

/// Where A does not tell the entries of a solution p apart, the one of least norm with the same A p; p itself where it
/// does. What stands alike then pushes alike, in whatever order it is given.
[[nodiscard]] Eigen::VectorXd least_norm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::VectorXd p);

}  // namespace bentur
