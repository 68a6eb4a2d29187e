#pragma once

#include <Eigen/Core>
#include <memory>

#include "bentur/elements/coupled_law.h"

namespace bentur {

/// What of a bearing in plan yields by both directions at once (P-31): beside its stiffness after yielding a force q
/// that stays within a regular polygon, whose sides are Q from its middle, and follows Δ with Q/Δ_y inside it. Its
/// deformations are directions · Δ, its forces F along them add up to what q is less than (Q/Δ_y) Δ.
struct PolygonYield {
  /// A multiple of 4, so that axes stand on sides. Of 4 it is what two laws are, one along each axis; of n it holds up
  /// to 1/cos(π/n) times what a circle does.
  static constexpr int least_sides = 4, most_sides = 64;

  Eigen::MatrixXd directions;  ///< those of half its sides times Q/Δ_y, sides/2 × 2 [force/length]
  std::shared_ptr<const CoupledLaw> law;
  double stiffness = 0;  ///< of the bearing before it yields, all of it [force/length]
};

/// @param stiffness of the bearing before it yields, all of it [force/length] > Q/Δ_y
/// @param strength Q [force] > 0 @param yield_displacement Δ_y [length] > 0
/// @throws InvalidParameter when a value is outside its range or `sides` is no such number.
[[nodiscard]] PolygonYield polygon_yield(double stiffness, double strength, double yield_displacement, int sides);

/// What it has done up to a state of its law.
struct Yielded {
  Eigen::Vector2d residual;  ///< what would be left of Δ if the bearing were unloaded slowly [length]
  double energy = 0;         ///< dissipated [force·length]
};
[[nodiscard]] Yielded yielded_of(const PolygonYield& yield, const CoupledState& state);

}  // namespace bentur
