#pragma once

#include "bentur/structure/body.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {

/// The outputs of the body of a building in plan, in this order; n floors. The last four are none of a wall.
enum class PlanOutput {
  movement,              ///< [length], n each: u_x, u_y; u_x of the south and north edge, u_y of the west and east edge
  rotation,              ///< [rad]
  acceleration,          ///< absolute, n each: x, y [length/s²]
  angular_acceleration,  ///< [rad/s²]
  storey_force,          ///< three a storey: shear along x and y [force], torque [force·length]
  plane_drift,           ///< drift ratios of planes, n each [-]
  plane_shear,           ///< [force]
};

/// @param axes along which the components of the ground's motion act, a column each
[[nodiscard]] Body body_of(const PlanBuilding& building, const Eigen::Matrix2Xd& axes);

}  // namespace bentur
