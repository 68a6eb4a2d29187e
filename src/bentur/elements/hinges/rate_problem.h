#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace bentur {

/// Sides of hinges, those that move either way last.
struct HingeSides {
  std::vector<Eigen::Index> of;
  std::vector<double> side;
  Eigen::Index free = 0;

  /// Adds the hinge `h`, which pushes on side `s`.
  void add(Eigen::Index h, double s, bool of_free) {
    of.push_back(h);
    side.push_back(s);
    free += of_free ? 1 : 0;
  }

  /// λ ≥ 0 with w = S a S λ − b ≥ 0 complementary, w = 0 of those that move either way. (H-7), (H-8)
  /// `mixed`: rotations and slips, so that each is measured by its own stiffness.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, bool mixed,
                                                     std::vector<Eigen::Index> guess = {}) const;
};

/// λ of the same problem where a may not be positive definite, as some of what flows loses strength: a local least of
/// ½ λᵀ a λ − bᵀ λ over λ ≥ 0 whose flowing part of a is positive definite; or a way λ ≥ 0 along which that falls
/// without end. (H-19)
struct RateSolution {
  Eigen::VectorXd pace;
  bool unbounded = false;  ///< `pace` is such a way
};
/// `a`: of the entries alone, sides included; the last `free` of any sign; `sizes`: of each, what a(i, i) is measured
/// by, > 0.
[[nodiscard]] RateSolution least_rate(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::Index free,
                                      const Eigen::VectorXd& sizes);

}  // namespace bentur
