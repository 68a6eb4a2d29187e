#include "bentur/structure/plan/plan_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What the loads of storey `storey` and above take from its stiffness (P-22).
MatrixXd softening_of(const PlanModel& model, const std::vector<double>& loads, Index storey) {
  MatrixXd softening = MatrixXd::Zero(model.dofs(), model.dofs());
  VectorXd turn = VectorXd::Zero(model.dofs());
  turn(3 * storey + 2) = 1;
  if (storey > 0) turn(3 * storey - 1) = -1;
  if (storey == 0 && model.soil && model.soil->twist) turn(model.first_foundation_dof() + PlanModel::twist) = -1;
  for (Index f = storey; f < model.floors(); ++f) {
    const PlanPoint at = model.footprint.corner + model.centres[f];
    const VectorXd x = model.lean(storey, at, PlanPoint::UnitX()), y = model.lean(storey, at, PlanPoint::UnitY());
    const double radius2 = model.floor_inertias[f] / model.floor_masses[f];
    softening += loads[f] / model.storey_heights[storey] *
                 (x * x.transpose() + y * y.transpose() + radius2 * turn * turn.transpose());
  }
  return softening;
}

/// All floors above a storey as one rigid body that moves with the floor just above it: dofs × 3.
MatrixXd rigid_above(const PlanModel& model, Index storey) {
  MatrixXd moved = MatrixXd::Zero(model.dofs(), 3);
  for (Index f = storey; f < model.floors(); ++f) {
    const PlanPoint arm = model.centres[f] - model.centres[storey];
    moved.middleRows<3>(3 * f) << 1, 0, -arm.y(), 0, 1, arm.x(), 0, 0, 1;
  }
  return moved;
}

/// Names what is wrong with loads under which a building does not stand; `model` before they act.
[[noreturn]] void refuse_loads(const PlanModel& model, const std::vector<double>& loads, const MatrixXd& softening) {
  const auto share = [](const MatrixXd& part, const MatrixXd& whole) {
    return generalised_values(part, whole).maxCoeff();
  };
  Index weakest = 0;
  double most = 0;
  for (Index j = model.first_storey(); j < model.floors(); ++j) {
    const MatrixXd moved = rigid_above(model, j);
    const MatrixXd bears = model.storey_forces.middleRows<3>(3 * j) * moved;
    const double of_storey =
        share(moved.transpose() * softening_of(model, loads, j) * moved, 0.5 * (bears + bears.transpose()));
    if (of_storey > most) {
      most = of_storey;
      weakest = j;
    }
  }
  const double of_all = share(softening, model.stiffness);
  throw InvalidParameter("gravity_loads", fmt::format("{:.4g} times what the building bears", of_all),
                         fmt::format("must leave the building standing: storey {} has the least margin, and all loads "
                                     "times {:.3g} are critical",
                                     model.storey_number(weakest), 1 / of_all));
}

void take_softening(PlanModel& model) {
  MatrixXd softening = MatrixXd::Zero(model.dofs(), model.dofs());
  for (Index j = model.first_storey(); j < model.floors(); ++j)
    softening += softening_of(model, model.gravity_loads, j);
  const MatrixXd left = model.stiffness - softening;
  if (!is_positive_definite(left)) refuse_loads(model, model.gravity_loads, softening);
  model.stiffness = left;
  model.softening = std::move(softening);
}

void check(const char* name, const Impedance& under) {
  require_positive(std::string(name) + ".stiffness", under.stiffness);
  require_not_negative(std::string(name) + ".damping", under.damping);
}

void check(const PlanSoil& soil) {
  check("soil.sway", soil.sway_x);
  check("soil.sway_y", soil.sway_y);
  check("soil.rocking", soil.rocking_x);
  check("soil.rocking_y", soil.rocking_y);
  if (soil.twist) check("soil.twist", *soil.twist);
  require_positive("soil.foundation.mass", soil.mass);
  require_positive("soil.foundation.inertia", soil.inertia_x);
  require_positive("soil.foundation.inertia_y", soil.inertia_y);
  if (soil.twist) require_positive("soil.foundation.twist_inertia", soil.twist_inertia);
}

/// From the motions of floors, nodes and foundation to those of floors and nodes relative to the foundation.
MatrixXd relative_motion(const PlanModel& model) {
  const Index floors = model.floors(), first = model.first_foundation_dof();
  const double base = model.elevations.front() - model.storey_heights.front();
  MatrixXd to = MatrixXd::Zero(first, model.dofs());
  to.leftCols(first).setIdentity();
  for (Index f = 0; f < floors; ++f) {
    const double height = model.elevations[f] - base;
    to(3 * f, first + PlanModel::sway_x) = to(3 * f + 1, first + PlanModel::sway_y) = -1;
    to(3 * f, first + PlanModel::rocking_x) = to(3 * f + 1, first + PlanModel::rocking_y) = -height;
    if (!model.soil->twist) continue;
    const PlanPoint arm = model.centres[f] - model.footprint.middle();
    to.block<3, 1>(3 * f, first + PlanModel::twist) << arm.y(), -arm.x(), -1;
  }
  for (Index n = 0; n < std::ssize(model.nodes); ++n) {
    const PlanModel::Node& node = model.nodes[n];
    to.row(model.first_node_dof() + n) -=
        model.base_movement(model.footprint.corner + node.through, node.along).transpose();
    to.block<1, 2>(model.first_node_dof() + n, first + PlanModel::rocking_x) -=
        (node.elevation - base) * node.along.transpose();
  }
  return to;
}

void check(const PlanIsolation& isolation) {
  require_positive("isolation.mass", isolation.mass);
  require_positive("isolation.inertia", isolation.inertia);
  require_finite("isolation.centre", isolation.centre.sum());
  if (isolation.bearings.empty()) throw InvalidParameter("isolation.bearing", "none", "must hold the slab");
  for (std::size_t i = 0; i < isolation.bearings.size(); ++i) {
    const std::string name = indexed("isolation.bearing", i);
    require_finite(name + ".at", isolation.bearings[i].at.sum());
    require_positive(name + ".stiffness", isolation.bearings[i].bearing.stiffness);
    require_not_negative(name + ".damping", isolation.bearings[i].damping);
  }
}

/// From the motions of slab, floors and nodes to those of floors and nodes relative to the slab.
MatrixXd relative_to_slab(const PlanModel& model, const PlanPoint& slab) {
  const Index first = model.first_foundation_dof();  // of what is above it
  MatrixXd to = MatrixXd::Zero(first, first + 3);
  to.rightCols(first).setIdentity();
  for (Index f = 0; f < model.floors(); ++f) {
    const PlanPoint arm = model.centres[f] - slab;
    to.block<3, 3>(3 * f, 0) << -1, 0, arm.y(), 0, -1, -arm.x(), 0, 0, -1;
  }
  for (Index n = 0; n < std::ssize(model.nodes); ++n) {
    const PlanModel::Node& node = model.nodes[n];
    const PlanPoint arm = node.through - slab;
    to.block<1, 3>(model.first_node_dof() + n, 0) << -node.along.x(), -node.along.y(),
        arm.y() * node.along.x() - arm.x() * node.along.y();
  }
  return to;
}

/// With rows of zeros above them.
MatrixXd below_slab(Index zeros, const MatrixXd& rows) {
  MatrixXd all = MatrixXd::Zero(zeros + rows.rows(), rows.cols());
  all.bottomRows(rows.rows()) = rows;
  return all;
}

PlanModel::Bearing bearing_over_dofs(const PlanBearing& bearing, const PlanPoint& slab, Index dofs) {
  const PlanPoint arm = bearing.at - slab;
  PlanModel::Bearing made{
      .at = bearing.at, .drifts = MatrixXd::Zero(2, dofs), .shears = {}, .pushes = {}, .law = bearing.bearing.law};
  if (made.law && bearing.sides > PolygonYield::least_sides) {
    made.polygon = polygon_yield(bearing.bearing.stiffness, bearing.bearing.strength, made.law->yield_deformation(),
                                 bearing.sides);
  }
  made.drifts.leftCols<3>() << 1, 0, -arm.y(), 0, 1, arm.x();
  made.shears = bearing.bearing.stiffness * made.drifts;
  made.pushes = made.drifts.leftCols<3>().transpose();
  return made;
}

/// Bearings that hold a slab against rotation too; nothing is said of their stiffnesses.
void check_held(const PlanIsolation& isolation, const PlanModel& model) {
  double furthest = 0;
  for (const PlanBearing& one : isolation.bearings) {
    furthest = std::max(furthest, (one.at - isolation.bearings.front().at).norm());
  }
  if (!(furthest > 1e-6 * model.footprint.size.maxCoeff())) {
    throw InvalidParameter("isolation.bearing", "all at one place",
                           "must stand at two places or more: nothing else holds the slab against rotation");
  }
}

/// The whole of a building, with the stiffness that gravity loads have taken, and its damping over the dofs.
struct FixedBase {
  MatrixXd stiffness, damping;
};

FixedBase fixed_base(const PlanBuilding& building) {
  const MatrixXd of_modes = building.model.mass * building.modes.shapes;
  FixedBase found{building.model.stiffness, of_modes * building.modal_damping * of_modes.transpose()};
  if (building.has_gravity_loads()) found.stiffness += building.model.softening;
  return found;
}

void carry_planes(const MatrixXd& to, Index slabs, PlanModel& model) {
  model.storey_forces = below_slab(3 * slabs, model.storey_forces * to);
  for (PlanModel::Plane& plane : model.planes) {
    plane.drifts = below_slab(slabs, plane.drifts * to);
    plane.shears = below_slab(slabs, plane.shears * to);
    plane.pushes = below_slab(slabs, plane.pushes.transpose()).transpose().eval();
    plane.laws.insert(plane.laws.begin(), static_cast<std::size_t>(slabs), nullptr);
    if (plane.hinges.size() > 0) plane.hinges.rows = (plane.hinges.rows * to).eval();
    if (plane.column_forces.size() > 0) plane.column_forces = (plane.column_forces * to).eval();
  }
}

}  // namespace

MatrixXd sums_above(MatrixXd rows, const std::vector<Index>& node_storeys) {
  const Index floors = rows.rows() - std::ssize(node_storeys);
  for (Index j = floors - 1; j-- > 0;) rows.row(j) += rows.row(j + 1);
  for (std::size_t n = 0; n < node_storeys.size(); ++n) {
    for (Index j = 0; j <= node_storeys[n]; ++j) rows.row(j) += rows.row(floors + static_cast<Index>(n));
  }
  return rows.topRows(floors);
}

void soften(const std::vector<double>& loads, PlanModel& model) {
  require_size("gravity_loads", loads.size(), model.floors());
  for (std::size_t f = 0; f < loads.size(); ++f) require_not_negative(indexed("gravity_loads", f), loads[f]);
  model.gravity_loads = loads;
  take_softening(model);
}

void put_on_soil(const PlanSoil& soil, PlanBuilding& building) {
  check(soil);
  PlanModel& model = building.model;
  const FixedBase fixed = fixed_base(building);
  model.soil = soil;
  const Index above = model.first_foundation_dof(), under = model.foundation_dofs();
  const MatrixXd to = relative_motion(model);
  VectorXd springs(5), dashpots(5), mass(5);
  const Impedance twist = soil.twist.value_or(Impedance{});
  springs << soil.sway_x.stiffness, soil.sway_y.stiffness, soil.rocking_x.stiffness, soil.rocking_y.stiffness,
      twist.stiffness;
  dashpots << soil.sway_x.damping, soil.sway_y.damping, soil.rocking_x.damping, soil.rocking_y.damping, twist.damping;
  mass << soil.mass, soil.mass, soil.inertia_x, soil.inertia_y, soil.twist_inertia;
  const auto carried = [&](const MatrixXd& of_floors, const VectorXd& of_foundation) -> MatrixXd {
    MatrixXd whole = to.transpose() * of_floors * to;
    whole.diagonal().tail(under) += of_foundation.head(under);
    return 0.5 * (whole + whole.transpose());
  };
  model.stiffness = carried(fixed.stiffness, springs);
  MatrixXd whole_mass = MatrixXd::Zero(model.dofs(), model.dofs()), load = MatrixXd::Zero(model.dofs(), 2);
  whole_mass.topLeftCorner(above, above) = model.mass;
  whole_mass.diagonal().tail(under) = mass.head(under);
  load.topRows(above) = model.load;
  load.block<2, 2>(above, 0) = soil.mass * Eigen::Matrix2d::Identity();
  model.mass = std::move(whole_mass);
  model.load = std::move(load);
  carry_planes(to, 0, model);
  if (building.has_gravity_loads()) take_softening(model);
  building.modes = modes(model.mass, model.stiffness);
  building.modal_damping = modal_damping(MatrixDamping{carried(fixed.damping, dashpots)}, building.modes);
}

void put_on_bearings(const PlanIsolation& isolation, PlanBuilding& building) {
  check(isolation);
  PlanModel& model = building.model;
  check_held(isolation, model);
  const FixedBase fixed = fixed_base(building);
  const Index above = model.dofs(), dofs = above + 3;
  const MatrixXd to = relative_to_slab(model, isolation.centre);
  MatrixXd stiffness = to.transpose() * fixed.stiffness * to, damping = to.transpose() * fixed.damping * to;
  MatrixXd mass = MatrixXd::Zero(dofs, dofs), load = MatrixXd::Zero(dofs, 2);
  mass.diagonal().head<3>() << isolation.mass, isolation.mass, isolation.inertia;
  mass.bottomRightCorner(above, above) = model.mass;
  load.topRows<2>() = isolation.mass * Eigen::Matrix2d::Identity();
  load.bottomRows(above) = model.load;
  carry_planes(to, 1, model);
  for (const PlanBearing& one : isolation.bearings) {
    const PlanModel::Bearing& made = model.bearings.emplace_back(bearing_over_dofs(one, isolation.centre, dofs));
    stiffness += made.drifts.transpose() * made.shears;
    damping += one.damping * made.drifts.transpose() * made.drifts;
    model.storey_forces.topRows<3>() += made.pushes * made.shears;
  }
  model.stiffness = 0.5 * (stiffness + stiffness.transpose());
  model.mass = std::move(mass);
  model.load = std::move(load);
  const double base = model.elevations.front() - model.storey_heights.front();
  model.elevations.insert(model.elevations.begin(), base);
  model.storey_heights.insert(model.storey_heights.begin(), 0.0);
  model.floor_masses.insert(model.floor_masses.begin(), isolation.mass);
  model.floor_inertias.insert(model.floor_inertias.begin(), isolation.inertia);
  model.centres.insert(model.centres.begin(), isolation.centre);
  model.slab = 0;
  if (building.has_gravity_loads()) {
    model.gravity_loads.insert(model.gravity_loads.begin(), 0.0);
    take_softening(model);
  }
  building.modes = modes(model.mass, model.stiffness);
  building.modal_damping = modal_damping(MatrixDamping{0.5 * (damping + damping.transpose())}, building.modes);
}

PlanSoil soil_in_plan(const HalfSpace& half_space, PlanSoil foundation) {
  const Soil along_x = soil_of(half_space, foundation.mass, foundation.inertia_x);
  const Soil along_y = soil_of(half_space, foundation.mass, foundation.inertia_y);
  foundation.sway_x = foundation.sway_y = along_x.sway;
  foundation.rocking_x = along_x.rocking;
  foundation.rocking_y = along_y.rocking;
  const double v = half_space.shear_wave_velocity, r = half_space.radius;
  const double stiffness = 16 * half_space.density * v * v * r * r * r / 3;
  const double inertia_ratio = foundation.twist_inertia / (half_space.density * std::pow(r, 5));  // B_t
  foundation.twist = Impedance{stiffness, std::sqrt(stiffness * foundation.twist_inertia) / (1 + 2 * inertia_ratio)};
  return foundation;
}

}  // namespace bentur
