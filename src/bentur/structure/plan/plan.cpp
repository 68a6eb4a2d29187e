#include "bentur/structure/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/frame/frame_hinges.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/plan/plan_checks.h"
#include "bentur/structure/plan/plan_masses.h"
#include "bentur/structure/plan/plan_support.h"
#include "bentur/structure/sway.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Row = Eigen::RowVector3d;  ///< over u_x, u_y, θ of one floor

constexpr double unheld = 1e-12;  // of the largest eigenvalue of a storey's stiffness

/// How far a point moves along a direction, both from one corner, with a floor whose centre of mass is `centre` (P-1).
Row movement_row(const PlanPoint& at, const PlanPoint& direction, const PlanPoint& centre) {
  const PlanPoint arm = at - centre;
  return {direction.x(), direction.y(), arm.x() * direction.y() - arm.y() * direction.x()};
}

/// One for all, or one each.
template <class Value>
const Value& of_list(const std::vector<Value>& list, Index i) {
  return list[list.size() == 1 ? 0 : i];
}

/// A spring of a storey: of the floor above it and, times −1, of the floor below.
struct Spring {
  double stiffness = 0;
  Row above, below;
};

/// On the line through a point.
Spring spring_at(const Plan& plan, Index storey, const PlanPoint& at, const PlanPoint& direction, double k) {
  return {k, movement_row(at, direction, centre_of_mass(plan, storey)),
          storey > 0 ? movement_row(at, direction, centre_of_mass(plan, storey - 1)) : Row(Row::Zero())};
}

std::vector<Spring> springs_of_rigidity(const Plan& plan, Index storey) {
  if (!plan.rigidity) return {};
  const PlanRigidity& rigidity = *plan.rigidity;
  const auto of = [&](const std::vector<double>& list) { return list.empty() ? 0.0 : of_list(list, storey); };
  const PlanPoint& at = of_list(rigidity.centres, storey);
  return {spring_at(plan, storey, at, PlanPoint::UnitX(), of(rigidity.x)),
          spring_at(plan, storey, at, PlanPoint::UnitY(), of(rigidity.y)),
          {of(rigidity.torsion), Row(0, 0, 1), storey > 0 ? Row(0, 0, 1) : Row(0, 0, 0)}};
}

/// What a storey of n floors' stiffness is when all floors from it up move as one.
double storey_part(const MatrixXd& stiffness, Index storey) {
  const Index above = stiffness.rows() - storey;
  return stiffness.bottomRightCorner(above, above).sum();
}

/// Of a storey, along x, along y and against rotation.
std::array<Spring, 3> springs_of_cantilever(const Plan& plan, Index storey) {
  const PlanCantilever& all = *plan.cantilever;
  return {spring_at(plan, storey, all.at, PlanPoint::UnitX(), storey_part(all.x, storey)),
          spring_at(plan, storey, all.at, PlanPoint::UnitY(), storey_part(all.y, storey)),
          {storey_part(all.torsion, storey), Row(0, 0, 1), storey > 0 ? Row(0, 0, 1) : Row(0, 0, 0)}};
}

Spring plane_spring(const Plan& plan, const PlanPlane& plane, Index storey) {
  return spring_at(plan, storey, plane.through, plane.direction, plane.storeys.stiffnesses[storey]);
}

/// All that hold a storey; what holds all floors at once by what the storey has alone, unless that is left out.
std::vector<Spring> springs_of(const Plan& plan, Index storey, bool with_frames = true) {
  std::vector<Spring> springs = springs_of_rigidity(plan, storey);
  for (const PlanPlane& plane : plan.planes) {
    if (with_frames || !plane.is_frame()) springs.push_back(plane_spring(plan, plane, storey));
  }
  if (with_frames && plan.cantilever) {
    for (const Spring& spring : springs_of_cantilever(plan, storey)) springs.push_back(spring);
  }
  return springs;
}

/// How a point of a floor moves, and turns, with a point of it that is `arm` away: over u_x, u_y, θ of that one.
Eigen::Matrix3d carried(const PlanPoint& arm) {
  Eigen::Matrix3d all;
  all << 1, 0, -arm.y(), 0, 1, arm.x(), 0, 0, 1;
  return all;
}

/// What is known of all floors at once, over the movements of their centres of mass.
MatrixXd known_over_dofs(const Plan& plan) {
  const PlanStiffness& known = *plan.known;
  const Index floors = std::ssize(known.at);
  MatrixXd moved = MatrixXd::Zero(3 * floors, 3 * floors);
  for (Index f = 0; f < floors; ++f) moved.block<3, 3>(3 * f, 3 * f) = carried(known.at[f] - centre_of_mass(plan, f));
  const MatrixXd all = moved.transpose() * known.matrix * moved;
  return 0.5 * (all + all.transpose());
}

/// Forces and torques of the floors from a storey up on them, moved to the centre of mass of the floor above the
/// storey: 3 × dofs, of the floors' own.
MatrixXd borne_from(const Plan& plan, Index storey) {
  const Index floors = std::ssize(plan.storey_heights);
  MatrixXd all = MatrixXd::Zero(3, 3 * floors);
  for (Index f = storey; f < floors; ++f) {
    all.middleCols<3>(3 * f) = carried(centre_of_mass(plan, f) - centre_of_mass(plan, storey)).transpose();
  }
  return all;
}

/// Of a storey against u_x, u_y and θ of the centre of mass of the floor above it; what holds all floors at once by
/// what the storey has where all floors from it up move as one.
Eigen::Matrix3d storey_stiffness(const Plan& plan, Index storey) {
  Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
  for (const Spring& spring : springs_of(plan, storey)) {
    all += spring.stiffness * spring.above.transpose() * spring.above;
  }
  if (plan.known) {
    const MatrixXd borne = borne_from(plan, storey);
    all += borne * known_over_dofs(plan) * borne.transpose();
  }
  return all;
}

/// The deformation of a spring as a row over all degrees of freedom.
Eigen::RowVectorXd over_dofs(const Spring& spring, Index storey, Index dofs) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(dofs);
  const Index at = 3 * storey;
  row.segment<3>(at) = spring.above;
  if (storey > 0) row.segment<3>(at - 3) = -spring.below;
  return row;
}

/// How its floors sway along its line, and after them its nodes, whose degrees of freedom begin at `node`, sways ×
/// dofs: of floors the drifts of all storeys below.
MatrixXd sways_of(const PlanModel::Plane& plane, Index node) {
  const Index floors = plane.drifts.rows(), nodes = std::ssize(plane.node_storeys);
  MatrixXd sways = MatrixXd::Zero(floors + nodes, plane.drifts.cols());
  sways.topRows(floors) = plane.drifts;
  for (Index j = 1; j < floors; ++j) sways.row(j) += sways.row(j - 1);
  sways.block(floors, node, nodes, nodes).setIdentity();
  return sways;
}

/// Springs of the storeys over the degrees of freedom of a model that has its floors.
PlanModel::Plane over_dofs(const std::string& name, const std::vector<Spring>& springs, Index dofs) {
  const Index storeys = std::ssize(springs);
  PlanModel::Plane made{.name = name,
                        .drifts = MatrixXd::Zero(storeys, dofs),
                        .pushes = MatrixXd::Zero(3, storeys),
                        .shears = MatrixXd::Zero(storeys, dofs),
                        .laws = std::vector<std::shared_ptr<const HystereticLaw>>(springs.size())};
  for (Index j = 0; j < storeys; ++j) {
    made.drifts.row(j) = over_dofs(springs[j], j, dofs);
    made.pushes.col(j) = springs[j].above.transpose();
    made.shears.row(j) = springs[j].stiffness * made.drifts.row(j);
  }
  return made;
}

/// Makes its shears those of what holds all floors at once, by the sways along it.
void hold_at_once(const MatrixXd& stiffness, const MatrixXd& sways, PlanModel::Plane& made) {
  made.shears = sums_above(stiffness * sways, made.node_storeys);
}

/// @param node where the degrees of freedom of its nodes begin
PlanModel::Plane plane_over_dofs(const Plan& plan, const PlanPlane& plane, Index node, Index dofs) {
  std::vector<Spring> springs;
  for (Index j = 0; j < std::ssize(plan.storey_heights); ++j) springs.push_back(plane_spring(plan, plane, j));
  PlanModel::Plane made = over_dofs(plane.name, springs, dofs);
  if (plane.is_frame()) {
    made.node_storeys = plane.nodes.storeys;
    const MatrixXd sways = sways_of(made, node);
    hold_at_once(plane.sway_stiffness, sways, made);
    if (plane.nodes.count() > 0) made.column_forces = plane.nodes.column_forces * sways;
    made.hinges = plane.hinges;
    if (made.hinges.size() > 0) made.hinges.rows = plane.hinges.rows * sways;
    made.infills = plane.infills;
    made.bays = plane.bays;
    return made;
  }
  for (std::size_t j = 0; j < springs.size(); ++j) {
    const double stiffness = springs[j].stiffness;
    if (stiffness > 0) made.laws[j] = storey_law(plane.storeys, j, stiffness);
  }
  return made;
}

/// Adds what holds all floors at once to the stiffness of a model and to what its storeys bear (P-23). @param node
/// where the degrees of freedom of its nodes begin
void add_at_once(const PlanModel::Plane& made, const MatrixXd& stiffness, Index node, PlanModel& model) {
  const MatrixXd sways = sways_of(made, node), part = sways.transpose() * stiffness * sways;
  model.stiffness += 0.5 * (part + part.transpose());
  for (Index j = 0; j < model.floors(); ++j) {
    model.storey_forces.middleRows<3>(3 * j) += made.pushes.col(j) * made.shears.row(j);
  }
}

void add_cantilever(const Plan& plan, PlanModel& model) {
  const std::array<const MatrixXd*, 3> stiffnesses = {&plan.cantilever->x, &plan.cantilever->y,
                                                      &plan.cantilever->torsion};
  for (std::size_t k = 0; k < stiffnesses.size(); ++k) {
    std::vector<Spring> springs;
    for (Index j = 0; j < model.floors(); ++j) springs.push_back(springs_of_cantilever(plan, j)[k]);
    PlanModel::Plane made = over_dofs("", springs, model.dofs());
    hold_at_once(*stiffnesses[k], sways_of(made, 0), made);
    add_at_once(made, *stiffnesses[k], 0, model);
  }
}

/// Adds a stiffness against the movements of all centres of mass, and what storeys carry of it (P-32).
void add_known(const Plan& plan, const MatrixXd& stiffness, PlanModel& model) {
  model.stiffness += stiffness;
  for (Index j = 0; j < model.floors(); ++j) {
    model.storey_forces.middleRows<3>(3 * j) += borne_from(plan, j) * stiffness;
  }
}

std::vector<CoupledElement> coupled_of(const PlanModel& model) {
  std::vector<CoupledElement> coupled;
  for (const PlanModel::Plane& plane : model.planes) {
    if (plane.hinges.size() > 0) coupled.push_back(element_of(plane.hinges));
  }
  for (const PlanModel::Bearing& bearing : model.bearings) {
    if (bearing.polygon) coupled.push_back({bearing.polygon->directions * bearing.drifts, bearing.polygon->law});
  }
  return coupled;
}

}  // namespace

PlaneFrame as_plane(PlaneFrame frame) {
  for (std::vector<Section>* const members : {&frame.columns, &frame.beams}) {
    if (members == &frame.columns && !frame.nodes.empty()) continue;
    for (Section& section : *members) section.mass = section.line_mass = 0;
  }
  frame.floor_masses.assign(frame.storey_heights.size(), 1);  // of which the stiffness knows nothing
  frame.mass_matrix = MassMatrix::lumped;
  frame.condensation = Condensation::static_;
  return frame;
}

void stand_frame(const PlaneFrame& frame, PlanPlane& plane) {
  plane.frame = std::make_shared<const PlaneFrame>(frame);
  PlaneFrame whole = as_plane(frame);
  StructuralModel model = plane_frame_model(whole);
  plane.bays = frame.bay_widths;
  whole.nodes.clear();
  const StructuralModel without = frame.nodes.empty() ? model : plane_frame_model(whole);
  plane.storeys.stiffnesses.clear();
  for (Index j = 0; j < model.floors(); ++j) plane.storeys.stiffnesses.push_back(storey_part(without.stiffness, j));
  plane.nodes = {};
  if (!frame.nodes.empty()) {
    plane.nodes.masses = std::move(model.node_masses);
    plane.nodes.column_forces = std::move(model.column_forces);
    for (Index n = 0; n < model.nodes(); ++n) {
      plane.nodes.elevations.push_back(model.node_elevations[n]);
      plane.nodes.storeys.push_back(model.floor_at_or_above(model.floors() + n));
    }
    for (Index f = 0; f < model.floors(); ++f) {
      plane.nodes.from_floors.push_back(without.floor_masses[f] - model.floor_masses[f]);
    }
  }
  plane.sway_stiffness = std::move(model.stiffness);
  plane.hinges = std::move(model.hinges);
  plane.infills = std::move(model.infills);
}

std::vector<UnheldStorey> unheld_storeys(const Plan& plan) {
  constexpr std::array<std::string_view, 3> directions = {"x", "y", "rotation"};
  std::vector<UnheldStorey> found;
  const Eigen::Vector3d scale(1, 1, 1 / plan.footprint.size.maxCoeff());
  for (Index j = 0; j < std::ssize(plan.storey_heights); ++j) {
    const SymmetricModes solved =
        symmetric_modes_of_3(scale.asDiagonal() * storey_stiffness(plan, j) * scale.asDiagonal());
    std::array<bool, 3> free = {};
    for (Index k = 0; k < 3; ++k) {
      if (solved.values(k) > unheld * solved.values(2)) continue;
      Index largest = 0;
      solved.vectors.col(k).cwiseAbs().maxCoeff(&largest);
      free[static_cast<std::size_t>(largest)] = true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (free[k]) found.push_back({j, directions[k]});
    }
  }
  return found;
}

Index PlanModel::floor_at_or_above(Index floor_or_node) const {
  if (floor_or_node < floors()) return floor_or_node;
  const double elevation = nodes[floor_or_node - floors()].elevation;
  return std::min<Index>(std::lower_bound(elevations.begin(), elevations.end(), elevation) - elevations.begin(),
                         floors() - 1);
}

VectorXd PlanModel::movement(Index floor, const PlanPoint& at, const PlanPoint& direction) const {
  if (floor >= floors()) {
    const Node& node = nodes[floor - floors()];
    const double part = node.along.dot(direction);
    VectorXd row = movement_at(node.elevation, at, direction - part * node.along);
    row(first_node_dof() + floor - floors()) += part;
    return row;
  }
  VectorXd row = VectorXd::Zero(dofs());
  row.segment<3>(3 * floor) = movement_row(at - footprint.corner, direction, centres[floor]).transpose();
  return row;
}

VectorXd PlanModel::movement_at(double elevation, const PlanPoint& at, const PlanPoint& direction) const {
  const auto [upper, s] = storey_place(elevations, storey_heights, elevation);
  VectorXd row = s * movement(upper, at, direction);
  return row + (1 - s) * (upper > 0 ? movement(upper - 1, at, direction) : base_movement(at, direction));
}

VectorXd PlanModel::base_movement(const PlanPoint& at, const PlanPoint& direction) const {
  VectorXd row = VectorXd::Zero(dofs());
  if (!soil) return row;
  const Row moved = movement_row(at - footprint.corner, direction, footprint.middle());
  const Index first = first_foundation_dof();
  row.segment<2>(first + sway_x) = moved.head<2>().transpose();
  if (soil->twist) row(first + twist) = moved.z();
  return row;
}

VectorXd PlanModel::lean(Index storey, const PlanPoint& at, const PlanPoint& direction) const {
  return movement(storey, at, direction) -
         (storey > 0 ? movement(storey - 1, at, direction) : base_movement(at, direction));
}

VectorXd PlanModel::drift(Index storey, const PlanPoint& at, const PlanPoint& direction) const {
  VectorXd row = lean(storey, at, direction);
  if (soil) row.segment<2>(first_foundation_dof() + rocking_x) -= storey_heights[storey] * direction;
  return row;
}

namespace {

void add_nodes(const Plan& plan, double base_elevation, PlanModel& model) {
  for (std::size_t p = 0; p < plan.planes.size(); ++p) {
    const PlanPlane& plane = plan.planes[p];
    for (Index n = 0; n < plane.nodes.count(); ++n) {
      model.nodes.push_back({.plane = static_cast<Index>(p),
                             .elevation = base_elevation + plane.nodes.elevations[n],
                             .mass = plane.nodes.masses[n],
                             .through = plane.through,
                             .along = plane.direction});
    }
  }
}

/// Of each plane the degree of freedom of its first node, or where that of the next one's is.
std::vector<Index> first_node_dofs(const Plan& plan) {
  std::vector<Index> first = {3 * std::ssize(plan.storey_heights)};
  for (const PlanPlane& plane : plan.planes) first.push_back(first.back() + plane.nodes.count());
  return first;
}

/// Gives nodes their masses, of which floors have what acts along the frames no more (P-34).
void add_node_masses(const Plan& plan, PlanModel& model) {
  Index dof = model.first_node_dof();
  for (const PlanPlane& plane : plan.planes) {
    if (plane.nodes.count() == 0) continue;
    for (Index f = 0; f < model.floors(); ++f) {
      const Row moved = movement_row(plane.through, plane.direction, model.centres[f]);
      const double taken = plane.nodes.from_floors[f];
      model.mass.block<3, 3>(3 * f, 3 * f) -= taken * moved.transpose() * moved;
      model.load.middleRows<3>(3 * f) -= taken * moved.transpose() * plane.direction.transpose();
    }
    for (const double mass : plane.nodes.masses) {
      model.mass(dof, dof) = mass;
      model.load.row(dof++) = mass * plane.direction.transpose();
    }
  }
  if (!model.nodes.empty() && !is_positive_definite(model.mass)) {
    throw InvalidParameter("masses", "of floors", "must be more than what columns that are struck have of them");
  }
}

}  // namespace

PlanPoint centre_of_rigidity(const Plan& plan, Index storey) {
  const Eigen::Matrix3d k = storey_stiffness(plan, storey);
  // A translation u makes the torque r × (K_t u) about the centre of mass, r from there.
  const PlanPoint turned = Ldlt(k.topLeftCorner<2, 2>()).solve(k.block<2, 1>(0, 2));
  return centre_of_mass(plan, storey) + PlanPoint(turned.y(), -turned.x());
}

PlanModel plan_model(const Plan& plan, double base_elevation) {
  check_plan(plan);
  require_finite("base_elevation", base_elevation);
  PlanModel model;
  model.footprint = plan.footprint;
  model.storey_heights = plan.storey_heights;
  model.floor_masses = plan.masses;
  model.stiffness_factor = plan.stiffness_factor;
  model.elevations = floor_elevations(plan.storey_heights, base_elevation);
  add_nodes(plan, base_elevation, model);
  const Index dofs = model.dofs();
  VectorXd mass = VectorXd::Zero(dofs);
  model.load = MatrixXd::Zero(dofs, 2);
  for (Index f = 0; f < model.floors(); ++f) {
    const double m = plan.masses[f];
    const Index at = 3 * f;
    model.floor_inertias.push_back(inertia_of(plan, f));
    mass.segment<3>(at) << m, m, model.floor_inertias.back();
    model.load.block<2, 2>(at, 0) = m * Eigen::Matrix2d::Identity();
    model.centres.push_back(centre_of_mass(plan, f));
  }
  model.mass = mass.asDiagonal();
  add_node_masses(plan, model);
  const std::vector<Index> nodes = first_node_dofs(plan);
  for (std::size_t p = 0; p < plan.planes.size(); ++p) {
    model.planes.push_back(plane_over_dofs(plan, plan.planes[p], nodes[p], dofs));
  }
  model.stiffness = MatrixXd::Zero(dofs, dofs);
  model.storey_forces = MatrixXd::Zero(3 * model.floors(), dofs);
  for (Index j = 0; j < model.floors(); ++j) {
    for (const Spring& spring : springs_of(plan, j, false)) {
      const Eigen::RowVectorXd row = over_dofs(spring, j, dofs);
      model.stiffness += spring.stiffness * row.transpose() * row;
      model.storey_forces.middleRows<3>(3 * j) += spring.stiffness * spring.above.transpose() * row;
    }
  }
  for (std::size_t p = 0; p < plan.planes.size(); ++p) {
    if (plan.planes[p].is_frame()) add_at_once(model.planes[p], plan.planes[p].sway_stiffness, nodes[p], model);
  }
  if (plan.cantilever) add_cantilever(plan, model);
  if (plan.known) add_known(plan, known_over_dofs(plan), model);
  if (plan.modes) {
    model.known = known_modes(*plan.modes, mass);
    add_known(plan, model.known->stiffness, model);
  }
  if (!plan.gravity_loads.empty()) soften(plan.gravity_loads, model);
  return model;
}

PlanBuilding make_plan_building(std::string name, PlanModel model, const Damping& damping, bool tangent,
                                const std::optional<PlanSoil>& soil, const std::optional<PlanIsolation>& isolation) {
  PlanBuilding building{.name = std::move(name), .model = std::move(model), .modes = {}, .modal_damping = {}};
  const auto& known = building.model.known;
  building.modes = known ? known->modes : modes(building.model.mass, building.model.stiffness);
  building.modal_damping = modal_damping(damping, building.modes);
  if (tangent) {
    const MatrixXd& softening = building.model.softening;
    const double omega = building.has_gravity_loads()
                             ? modes(building.model.mass, building.model.stiffness + softening).omega(0)
                             : building.modes.omega(0);
    const auto beta = stiffness_part(damping, omega);
    if (!beta || *beta < 0) {
      throw InvalidParameter("damping_stiffness", "tangent",
                             "needs damping with a stiffness part that is not negative");
    }
    building.tangent_damping = *beta;
  }
  if (soil && isolation) {
    throw InvalidParameter("isolation", "together with soil", "must stand on a base that does not move by itself");
  }
  if (soil) put_on_soil(*soil, building);
  if (isolation) put_on_bearings(*isolation, building);
  building.coupled = coupled_of(building.model);
  return building;
}

PlanBuilding rigid_plan_building(std::string name, const Footprint& footprint, const std::vector<double>& elevations) {
  check_footprint(footprint);
  if (elevations.empty()) throw InvalidParameter("elevations", "an empty list", "must have at least one entry");
  PlanBuilding building{.name = std::move(name), .model = {}, .modes = {}, .modal_damping = MatrixXd::Zero(0, 0)};
  PlanModel& model = building.model;
  model.footprint = footprint;
  model.elevations = elevations;
  for (std::size_t i = 0; i < elevations.size(); ++i) {
    require_finite(indexed("elevations", i), elevations[i]);
    if (i > 0 && !(elevations[i] > elevations[i - 1])) {
      throw InvalidParameter(indexed("elevations", i), std::to_string(elevations[i]), "must ascend");
    }
    model.storey_heights.push_back(i > 0 ? elevations[i] - elevations[i - 1] : 0.0);
  }
  model.floor_masses.assign(elevations.size(), std::numeric_limits<double>::infinity());
  model.centres.assign(elevations.size(), footprint.middle());
  model.mass = model.stiffness = model.storey_forces = MatrixXd::Zero(model.dofs(), model.dofs());
  model.load = MatrixXd::Zero(model.dofs(), 2);
  building.modes.shapes = MatrixXd::Zero(model.dofs(), 0);
  return building;
}

}  // namespace bentur
