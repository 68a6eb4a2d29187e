#pragma once

#include <Eigen/Core>

namespace bentur {

/// Stiffness (2-48) of a member of rigidity E I over the displacements (y₁, θ₁, y₂, θ₂) of its ends, θ = dy/dx
/// [force, length]. A column is run from bottom to top with y to the right, a beam from left to right with y
/// downwards: then every θ is clockwise, as 4.1.2 has it.
[[nodiscard]] inline Eigen::Matrix4d element_stiffness(double rigidity, double length) {
  const double l = length;
  Eigen::Matrix4d k;
  k << 6, 3 * l, -6, 3 * l,             //
      3 * l, 2 * l * l, -3 * l, l * l,  //
      -6, -3 * l, 6, -3 * l,            //
      3 * l, l * l, -3 * l, 2 * l * l;
  return 2 * rigidity / (l * l * l) * k;
}

}  // namespace bentur
