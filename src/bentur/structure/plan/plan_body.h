#pragma once

#include "bentur/structure/body.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {

/// The outputs of the body of a building in plan, in this order; n floors. From `storey_force` on they are none of a
/// wall.
enum class PlanOutput {
  movement,              ///< [length], n each: u_x, u_y; u_x of the south and north edge, u_y of the west and east edge
  rotation,              ///< [rad]
  acceleration,          ///< absolute, n each: x, y [length/s²]
  angular_acceleration,  ///< [rad/s²]
  storey_force,          ///< three a storey: shear along x and y [force], torque [force·length]
  plane_drift,           ///< drift ratios of planes, n each [-]
  plane_shear,           ///< [force]
  foundation,        ///< sway along x and y [length], rocking that moves along x and y, twist [rad]; none without soil
  foundation_force,  ///< of springs and dashpots below it, likewise [force], [force·length]
  bearing_movement,  ///< along x and y, two a bearing [length]
  bearing_force,     ///< [force]
  // Of all frames that have any, one after the other.
  hinge_moment,    ///< M + M₀ [force·length]
  hinge_rotation,  ///< [rad]
  breaking_shear,  ///< Q + Q₀ of columns that break [force]
  /// Of a building without planes drift ratios along themselves of the south and north edge (x), the west and east edge
  /// (y), n each [-]; of others none.
  edge_drift,
  infill_force,  ///< of panels of infill, one plane after the other, across [force]
  infill_push,   ///< Q + Q₀ + F of struts_on_columns(), likewise [force]
  column_force,  ///< of the pieces of struck columns, six a node as StructuralModel::column_forces
};

/// Drift ratios of edges as PlanOutput::edge_drift has them, over the dofs [1/length]; 0 of a slab on bearings.
[[nodiscard]] Eigen::MatrixXd edge_drift_rows(const PlanModel& model);

/// @param axes along which the components of the ground's motion act, a column each
[[nodiscard]] Body body_of(const PlanBuilding& building, const Eigen::Matrix2Xd& axes);

}  // namespace bentur
