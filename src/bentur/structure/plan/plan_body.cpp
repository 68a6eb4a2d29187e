#include "bentur/structure/plan/plan_body.h"

#include <array>

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows of all floors for one degree of freedom of each, 0 … 2.
MatrixXd of_floors(const PlanModel& model, Index dof) {
  MatrixXd rows = MatrixXd::Zero(model.floors(), model.dofs());
  for (Index f = 0; f < model.floors(); ++f) rows(f, 3 * f + dof) = 1;
  return rows;
}

/// How far a point moves along a direction with each floor.
MatrixXd movements(const PlanModel& model, const PlanPoint& at, const PlanPoint& direction) {
  MatrixXd rows(model.floors(), model.dofs());
  for (Index f = 0; f < model.floors(); ++f) rows.row(f) = model.movement(f, at, direction).transpose();
  return rows;
}

MatrixXd stacked(std::initializer_list<MatrixXd> parts, Index columns) {
  Index rows = 0;
  for (const MatrixXd& part : parts) rows += part.rows();
  MatrixXd all(rows, columns);
  rows = 0;
  for (const MatrixXd& part : parts) {
    all.middleRows(rows, part.rows()) = part;
    rows += part.rows();
  }
  return all;
}

/// What the storeys of planes and the bearings do that yield, those of planes first, and the rows by which both are
/// told.
struct PlaneRows {
  std::vector<BuildingElement> elements = {};
  MatrixXd drifts = {}, shears = {};                     ///< planes · storeys × dofs
  MatrixXd shear_of_forces = {}, storey_of_forces = {};  ///< × elements
  MatrixXd bearing_moves = {}, bearing_forces = {};      ///< 2 · bearings × dofs
  MatrixXd bearing_of_forces = {};                       ///< × elements
};

PlaneRows rows_of_planes(const PlanModel& model) {
  const Index floors = model.floors(), count = std::ssize(model.planes) * floors;
  PlaneRows rows{.drifts = MatrixXd::Zero(count, model.dofs()), .shears = MatrixXd::Zero(count, model.dofs())};
  for (const PlanModel::Plane& plane : model.planes) {
    for (Index j = 0; j < floors; ++j) {
      if (plane.laws[j]) rows.elements.push_back({plane.drifts.row(j).transpose(), plane.laws[j], j});
    }
  }
  for (const PlanModel::Bearing& bearing : model.bearings) {
    for (Index i = 0; bearing.law && i < 2; ++i) {
      rows.elements.push_back({bearing.drifts.row(i).transpose(), bearing.law, *model.slab});
    }
  }
  rows.shear_of_forces = MatrixXd::Zero(count, std::ssize(rows.elements));
  rows.storey_of_forces = MatrixXd::Zero(3 * floors, std::ssize(rows.elements));
  Index at = 0, force = 0;
  for (const PlanModel::Plane& plane : model.planes) {
    for (Index j = 0; j < floors; ++j, ++at) {
      if (j < model.first_storey()) continue;  // a slab is in no plane
      rows.drifts.row(at) = plane.drifts.row(j) / model.storey_heights[j];
      rows.shears.row(at) = plane.shears.row(j);
      if (!plane.laws[j]) continue;
      rows.shear_of_forces(at, force) = 1;
      rows.storey_of_forces.block<3, 1>(3 * j, force++) = plane.pushes.col(j);
    }
  }
  const Index bearings = std::ssize(model.bearings);
  rows.bearing_moves = rows.bearing_forces = MatrixXd::Zero(2 * bearings, model.dofs());
  rows.bearing_of_forces = MatrixXd::Zero(2 * bearings, std::ssize(rows.elements));
  for (Index n = 0; n < bearings; ++n) {
    const PlanModel::Bearing& bearing = model.bearings[n];
    rows.bearing_moves.middleRows<2>(2 * n) = bearing.drifts;
    rows.bearing_forces.middleRows<2>(2 * n) = bearing.shears;
    for (Index i = 0; bearing.law && i < 2; ++i) {
      rows.bearing_of_forces(2 * n + i, force) = 1;
      rows.storey_of_forces.block<3, 1>(0, force++) = bearing.pushes.col(i);
    }
  }
  return rows;
}

/// How a foundation moves and what springs and dashpots below it bear, 5 × dofs; a twist that is not is zero. Without
/// one: 0 × dofs.
struct FoundationRows {
  MatrixXd moves, springs, dashpots;
};

FoundationRows rows_of_foundation(const PlanModel& model) {
  FoundationRows rows;
  rows.moves = rows.springs = rows.dashpots = MatrixXd::Zero(model.soil ? 5 : 0, model.dofs());
  if (!model.soil) return rows;
  const PlanSoil& soil = *model.soil;
  const std::array<Impedance, 5> below = {soil.sway_x, soil.sway_y, soil.rocking_x, soil.rocking_y,
                                          soil.twist.value_or(Impedance{})};
  for (Index i = 0; i < model.foundation_dofs(); ++i) {
    const Index dof = 3 * model.floors() + i;
    rows.moves(i, dof) = 1;
    rows.springs(i, dof) = below[i].stiffness;
    rows.dashpots(i, dof) = below[i].damping;
  }
  return rows;
}

}  // namespace

Body body_of(const PlanBuilding& building, const Eigen::Matrix2Xd& axes) {
  const PlanModel& model = building.model;
  const Index floors = model.floors(), dofs = model.dofs();
  const PlanPoint x = PlanPoint::UnitX(), y = PlanPoint::UnitY();
  const PlanPoint low = model.footprint.lower(), high = model.footprint.far_corner();
  const MatrixXd u_x = of_floors(model, 0), u_y = of_floors(model, 1), theta = of_floors(model, 2);
  const PlaneRows planes = rows_of_planes(model);
  Body body{.name = building.name,
            .modes = building.modes,
            .modal_damping = building.modal_damping,
            .mass = model.mass,
            .stiffness = model.stiffness,
            .load = model.load * axes,
            .elements = planes.elements,
            .tangent_damping = building.tangent_damping};
  const auto add = [&](Outputs outputs) {
    outputs.kind = OutputKind::displacement;
    outputs.has_peak = true;
    body.outputs.push_back(std::move(outputs));
  };
  add({.count = 6 * floors,
       .rows = stacked({u_x, u_y, movements(model, low, x), movements(model, high, x), movements(model, low, y),
                        movements(model, high, y)},
                       dofs)});
  add({.count = floors, .rows = theta});
  const auto of_ground = [&](Index coordinate) -> MatrixXd { return axes.row(coordinate).replicate(floors, 1); };
  add({.count = 2 * floors,
       .absolute = stacked({u_x, u_y}, dofs),
       .ground = stacked({of_ground(0), of_ground(1)}, axes.cols())});
  add({.count = floors, .absolute = theta, .ground = MatrixXd::Zero(floors, axes.cols())});
  if (building.is_rigid()) return body;
  add({.count = 3 * floors, .rows = model.storey_forces, .forces = planes.storey_of_forces});
  add({.count = planes.drifts.rows(), .rows = planes.drifts});
  add({.count = planes.shears.rows(), .rows = planes.shears, .forces = planes.shear_of_forces});
  const FoundationRows foundation = rows_of_foundation(model);
  add({.count = foundation.moves.rows(), .rows = foundation.moves});
  body.outputs.push_back({.kind = OutputKind::foundation_force,
                          .count = foundation.moves.rows(),
                          .rows = foundation.springs,
                          .rates = foundation.dashpots});
  add({.count = planes.bearing_moves.rows(), .rows = planes.bearing_moves});
  add({.count = planes.bearing_forces.rows(), .rows = planes.bearing_forces, .forces = planes.bearing_of_forces});
  return body;
}

}  // namespace bentur
