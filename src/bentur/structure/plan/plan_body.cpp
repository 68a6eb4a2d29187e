#include "bentur/structure/plan/plan_body.h"

#include <algorithm>
#include <array>
#include <utility>

#include "bentur/structure/frame/infill.h"
#include "bentur/structure/plan/plan_support.h"

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

/// What of planes and bearings yields, storeys and infill of planes first, and the rows by which both are told.
struct PlaneRows {
  std::vector<BuildingElement> elements = {};
  MatrixXd drifts = {}, shears = {};                     ///< planes · storeys × dofs
  MatrixXd shear_of_forces = {}, storey_of_forces = {};  ///< × forces of elements
  MatrixXd bearing_moves = {}, bearing_forces = {};      ///< 2 · bearings × dofs
  MatrixXd bearing_of_forces = {};                       ///< × forces of elements
  Outputs moments = {}, rotations = {}, breaking = {};   ///< of hinges, and of columns that break
  Outputs infill = {}, pushes = {};                      ///< of panels of infill, and of columns beside them
  Outputs columns = {};                                  ///< of columns that are struck
};

/// Storey shears of a frame by the forces of its hinges: what these push on all floors above with. A building has
/// `storeys`, with those below the frame, where there is none.
MatrixXd shears_of_hinges(const PlanModel::Plane& plane, Index storeys) {
  const MatrixXd of_frame = sums_above(plane.hinges.frame_rows.transpose(), plane.node_storeys);
  MatrixXd shears = MatrixXd::Zero(storeys, of_frame.cols());
  shears.bottomRows(of_frame.rows()) = of_frame;
  return shears;
}

/// Adds outputs below those that are there. @param at_rest one each
void append(const MatrixXd& rows, const MatrixXd& of_forces, const Eigen::VectorXd& at_rest, Outputs& to) {
  const auto add = [](auto& list, const auto& more) {
    const Index before = list.rows();
    list.conservativeResize(before + more.rows(), more.cols());
    list.bottomRows(more.rows()) = more;
  };
  add(to.rows, rows);
  add(to.forces, of_forces);
  add(to.at_rest, at_rest);
  to.count += rows.rows();
}

/// Rows `from` … of the moments of a frame's hinges, whose forces begin at `force` of so many.
void add_moments(const Hinges& hinges, Index from, Index count, Index force, Index forces, Outputs& to) {
  MatrixXd of_forces = MatrixXd::Zero(count, forces);
  of_forces.middleCols(force, hinges.size()) = hinges.stiffness.middleRows(from, count);
  append(hinges.rows.middleRows(from, count), of_forces, hinges.at_rest.segment(from, count), to);
}

/// What the infill of a plane bears, and the columns beside it. @param elements of the building, those of its panels
/// from `element` on, which is moved on past them @param hinge where the forces of its hinges begin
void add_infill(const PlanModel& model, const PlanModel::Plane& plane, const std::vector<BuildingElement>& elements,
                Index hinge, Index forces, Index& element, PlaneRows& to) {
  const Index panels = std::ssize(plane.infills);
  MatrixXd rows(panels, model.dofs()), of_forces = MatrixXd::Zero(panels, forces);
  for (Index n = 0; n < panels; ++n) {
    rows.row(n) = plane.infills[n].stiffness * plane.drifts.row(model.first_storey() + plane.infills[n].storey);
    if (element < std::ssize(elements) && elements[element].infill == to.infill.count + n) of_forces(n, element++) = 1;
  }
  const Hinges& hinges = plane.hinges;
  for (const auto& [panel, column] : struts_on_columns(plane.infills, hinges)) {
    const Index at = std::ssize(hinges.places) + column;
    MatrixXd pushed = of_forces.row(panel);
    pushed.middleCols(hinge, hinges.size()) += hinges.stiffness.row(at);
    append(rows.row(panel) + hinges.rows.row(at), pushed, hinges.at_rest.segment(at, 1), to.pushes);
  }
  append(rows, of_forces, Eigen::VectorXd::Zero(panels), to.infill);
}

PlaneRows rows_of_planes(const PlanModel& model) {
  const Index floors = model.floors(), count = std::ssize(model.planes) * floors;
  PlaneRows rows{.drifts = MatrixXd::Zero(count, model.dofs()), .shears = MatrixXd::Zero(count, model.dofs())};
  Index forces = 0, panels = 0;
  for (const PlanModel::Plane& plane : model.planes) {
    for (Index j = 0; j < floors; ++j) {
      if (plane.laws[j]) rows.elements.push_back({plane.drifts.row(j).transpose(), plane.laws[j], j});
    }
    for (const InfillPanel& panel : plane.infills) {
      const Index j = model.first_storey() + panel.storey;
      auto element = infill_element(panel, plane.drifts.row(j).transpose(), j, panels++);
      if (element) rows.elements.push_back(*std::move(element));
    }
    forces += plane.hinges.size();
  }
  for (const PlanModel::Bearing& bearing : model.bearings) {
    for (Index i = 0; i < bearing.elements(); ++i) {
      rows.elements.push_back(
          {.row = bearing.drifts.row(i).transpose(), .law = bearing.law, .storey = *model.slab, .damped = false});
    }
    if (bearing.polygon) forces += bearing.polygon->directions.rows();
  }
  Index force = 0, of_hinges = std::ssize(rows.elements);
  forces += of_hinges;
  for (Outputs* const one :
       {&rows.moments, &rows.rotations, &rows.breaking, &rows.infill, &rows.pushes, &rows.columns}) {
    one->rows = MatrixXd(0, model.dofs());
    one->forces = MatrixXd(0, forces);
  }
  rows.shear_of_forces = MatrixXd::Zero(count, forces);
  rows.storey_of_forces = MatrixXd::Zero(3 * floors, forces);
  Index at = 0;
  for (const PlanModel::Plane& plane : model.planes) {
    const Hinges& hinges = plane.hinges;
    const MatrixXd of_frame = hinges.size() > 0 ? shears_of_hinges(plane, floors) : MatrixXd();
    for (Index j = 0; j < floors; ++j, ++at) {
      if (j < model.first_storey()) continue;  // a slab is in no plane
      rows.drifts.row(at) = plane.drifts.row(j) / model.storey_heights[j];
      rows.shears.row(at) = plane.shears.row(j);
      if (hinges.size() > 0) {
        rows.shear_of_forces.row(at).segment(of_hinges, hinges.size()) = of_frame.row(j);
        rows.storey_of_forces.block(3 * j, of_hinges, 3, hinges.size()) = plane.pushes.col(j) * of_frame.row(j);
      }
      if (!plane.laws[j]) continue;
      rows.shear_of_forces(at, force) = 1;
      rows.storey_of_forces.block<3, 1>(3 * j, force++) = plane.pushes.col(j);
    }
    const Index first_panel = force;
    if (!plane.infills.empty()) add_infill(model, plane, rows.elements, of_hinges, forces, force, rows);
    for (Index e = first_panel; e < force; ++e) {
      const Index j = rows.elements[e].storey;
      rows.shear_of_forces(at - floors + j, e) = 1;
      rows.storey_of_forces.block<3, 1>(3 * j, e) = plane.pushes.col(j);
    }
    if (const Index ends = plane.column_forces.rows(); ends > 0) {
      MatrixXd of_forces = MatrixXd::Zero(ends, forces);
      if (hinges.size() > 0) of_forces.middleCols(of_hinges, hinges.size()) = -hinges.column_forces;
      append(plane.column_forces, of_forces, Eigen::VectorXd::Zero(ends), rows.columns);
    }
    if (hinges.size() == 0) continue;
    const Index turning = std::ssize(hinges.places), breaking = std::ssize(hinges.columns);
    add_moments(hinges, 0, turning, of_hinges, forces, rows.moments);
    add_moments(hinges, turning, breaking, of_hinges, forces, rows.breaking);
    MatrixXd turned = MatrixXd::Zero(rows.rotations.count + turning, forces);
    turned.topRows(rows.rotations.count) = rows.rotations.forces;
    turned.block(rows.rotations.count, of_hinges, turning, turning) = -MatrixXd::Identity(turning, turning);
    rows.rotations.forces = std::move(turned);
    rows.rotations.count += turning;
    of_hinges += hinges.size();
  }
  const Index bearings = std::ssize(model.bearings);
  rows.bearing_moves = rows.bearing_forces = MatrixXd::Zero(2 * bearings, model.dofs());
  rows.bearing_of_forces = MatrixXd::Zero(2 * bearings, forces);
  for (Index n = 0; n < bearings; ++n) {
    const PlanModel::Bearing& bearing = model.bearings[n];
    rows.bearing_moves.middleRows<2>(2 * n) = bearing.drifts;
    rows.bearing_forces.middleRows<2>(2 * n) = bearing.shears;
    for (Index i = 0; i < bearing.elements(); ++i) {
      rows.bearing_of_forces(2 * n + i, force) = 1;
      rows.storey_of_forces.block<3, 1>(0, force++) = bearing.pushes.col(i);
    }
    if (!bearing.polygon) continue;
    const MatrixXd along = bearing.polygon->directions.transpose();
    rows.bearing_of_forces.block(2 * n, of_hinges, 2, along.cols()) = along;
    rows.storey_of_forces.block(0, of_hinges, 3, along.cols()) = bearing.pushes * along;
    of_hinges += along.cols();
  }
  rows.rotations.rows.resize(0, 0);
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
    const Index dof = model.first_foundation_dof() + i;
    rows.moves(i, dof) = 1;
    rows.springs(i, dof) = below[i].stiffness;
    rows.dashpots(i, dof) = below[i].damping;
  }
  return rows;
}

}  // namespace

MatrixXd edge_drift_rows(const PlanModel& model) {
  const PlanPoint x = PlanPoint::UnitX(), y = PlanPoint::UnitY();
  const PlanPoint low = model.footprint.lower(), high = model.footprint.far_corner();
  const std::array<std::pair<PlanPoint, PlanPoint>, 4> edges = {
      {{low, x}, {high, x}, {low, y}, {high, y}}};  // places and directions
  const Index floors = model.floors();
  MatrixXd drifts = MatrixXd::Zero(4 * floors, model.dofs());
  for (Index j = model.first_storey(); j < floors; ++j) {
    for (Index edge = 0; edge < 4; ++edge) {
      const auto& [at, along] = edges[static_cast<std::size_t>(edge)];
      drifts.row(edge * floors + j) = model.drift(j, at, along).transpose() / model.storey_heights[j];
    }
  }
  return drifts;
}

Body body_of(const PlanBuilding& building, const Eigen::Matrix2Xd& axes) {
  PlanModel model = building.model;
  model.footprint.corner.setZero();  // the same rows to the bit wherever it stands
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
            .coupled = building.coupled,
            .tangent_damping = building.tangent_damping};
  const auto add = [&](Outputs outputs) {
    outputs.kind = OutputKind::displacement;
    outputs.has_peak = true;
    body.outputs.push_back(std::move(outputs));
  };
  add({.count = 6 * floors,
       .rows = stacked({u_x, u_y, movements(model, low, x), movements(model, high, x), movements(model, low, y),
                        movements(model, high, y)},
                       dofs),
       .course = Outputs::Course::followed});
  add({.count = floors, .rows = theta, .course = Outputs::Course::followed});
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
  add(planes.moments);
  add(planes.rotations);
  body.outputs.back().has_peak = std::any_of(model.planes.begin(), model.planes.end(), [](const auto& plane) {
    return !plane.hinges.backbones.empty();  // of others their law knows it
  });
  add(planes.breaking);
  const MatrixXd drifts = model.planes.empty() ? edge_drift_rows(model) : MatrixXd(0, dofs);
  add({.count = drifts.rows(), .rows = drifts});
  add(planes.infill);
  add(planes.pushes);
  add(planes.columns);
  return body;
}

}  // namespace bentur
