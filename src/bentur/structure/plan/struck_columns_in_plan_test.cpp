#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "bentur/core/errors.h"
#include "bentur/structure/plan/plan.h"
#include "bentur/structure/plan/plan_body.h"
#include "bentur/structure/support.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// To round-off of the largest entry.
bool near(const MatrixXd& a, const MatrixXd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || (a - b).cwiseAbs().maxCoeff() <= 1e-11 * (1e-300 + b.cwiseAbs().maxCoeff()));
}

/// Three floors whose left columns are struck in the first and the third storey, a right one in the first.
PlaneFrame struck_frame(double capacity = 0) {
  PlaneFrame frame;
  frame.elastic_modulus = 2.5e7;
  frame.storey_heights = {3.5, 3.2, 3.0};
  frame.bay_widths = {5, 4};
  for (int j = 0; j < 3; ++j) {
    frame.columns.push_back({.area = 0.16, .inertia = 0.0021, .line_mass = 0.4});
    frame.beams.push_back({.area = 0.12, .inertia = 0.0016 * (1 + 0.2 * j)});
    if (capacity > 0) frame.columns.back().moment_capacity = frame.beams.back().moment_capacity = {capacity};
  }
  frame.columns[0].shear_capacity = {capacity > 0 ? capacity : 1e9};
  frame.floor_masses = {55, 44, 30};
  frame.mass_matrix = MassMatrix::lumped;
  frame.nodes = {{true, 1.4}, {false, 2.0}, {true, 7.5}};
  return frame;
}

/// Two of it side by side, whose line is turned by an angle [°], below floors of twice its mass.
Plan two_frames(const PlaneFrame& frame, double degrees) {
  PlaneFrame whole = frame;
  whole.nodes.clear();
  Plan plan{.footprint = {.corner = {4, 1}, .size = {9, 9}}, .storey_heights = frame.storey_heights, .masses = {}};
  for (const double mass : plane_frame_model(whole).floor_masses) plan.masses.push_back(2 * mass);
  const double angle = degrees * std::numbers::pi / 180;
  const PlanPoint along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x()), middle(4.5, 4.5);
  for (const double side : {-3.0, 3.0}) {
    PlanPlane plane{.name = side < 0 ? "a" : "b", .through = middle + side * across, .direction = along};
    stand_frame(frame, plane);
    plan.planes.push_back(plane);
  }
  plan.planes.push_back({.name = "wall", .through = middle, .direction = across, .storeys = {}});
  plan.planes.back().storeys.stiffnesses.assign(3, 3e4);
  return plan;
}

/// How a building in plan moves with the degrees of freedom of a row's, both frames alike: `moves` of them are floors
/// or a slab, then come nodes, then sway and rocking of a foundation.
MatrixXd as_in_row(const PlanModel& model, const PlanPoint& along, Index floors, Index nodes, Index foundation) {
  MatrixXd all = MatrixXd::Zero(model.dofs(), floors + nodes + foundation);
  for (Index f = 0; f < floors; ++f) all.block<2, 1>(3 * f, f) = along;
  for (Index n = 0; n < nodes; ++n) {
    all(model.first_node_dof() + n, floors + n) = all(model.first_node_dof() + nodes + n, floors + n) = 1;
  }
  for (Index i = 0; i < foundation; ++i) {
    all.block<2, 1>(model.first_foundation_dof() + 2 * i, floors + nodes + i) = along;
  }
  return all;
}

/// Of two of a frame in plan all that it is in a row.
void expect_as_in_row(const PlanBuilding& plan, const Building& row, double degrees, Index foundation) {
  const double angle = degrees * std::numbers::pi / 180;
  const PlanPoint along(std::cos(angle), std::sin(angle));
  const PlanModel& model = plan.model;
  const Index floors = model.floors(), nodes = row.model.nodes();
  ASSERT_EQ(std::ssize(model.nodes), 2 * nodes);
  const MatrixXd to = as_in_row(model, along, floors, nodes, foundation);
  EXPECT_TRUE(near(to.transpose() * model.stiffness * to, 2 * row.model.stiffness));
  EXPECT_TRUE(near(to.transpose() * model.mass * to, 2 * row.model.mass));
  EXPECT_TRUE(near(to.transpose() * model.load * along, 2 * row.model.load));
  const Body body = body_of(plan, Eigen::Matrix2d::Identity()), by_row = body_of(row);
  const auto output = [&](PlanOutput kind) -> const Outputs& { return body.outputs[static_cast<std::size_t>(kind)]; };
  const auto in_row = [&](OutputKind kind) -> const Outputs& { return by_row.outputs[static_cast<std::size_t>(kind)]; };
  const Index of_frame = in_row(OutputKind::column_force).count;
  EXPECT_EQ(of_frame, 6 * nodes);
  for (const Index frame : {Index{0}, Index{1}}) {
    const Outputs& columns = output(PlanOutput::column_force);
    EXPECT_TRUE(near(columns.rows.middleRows(frame * of_frame, of_frame) * to, in_row(OutputKind::column_force).rows));
    EXPECT_TRUE(near(output(PlanOutput::plane_shear).rows.middleRows(frame * floors, floors).bottomRows(3) * to,
                     in_row(OutputKind::storey_shear).rows.bottomRows(3)));
    if (row.model.hinges.size() == 0) continue;
    const Index forces = row.model.hinges.size();
    EXPECT_TRUE(near(columns.forces.middleRows(frame * of_frame, of_frame).middleCols(frame * forces, forces),
                     in_row(OutputKind::column_force).forces.rightCols(forces)));
    EXPECT_TRUE(near(output(PlanOutput::plane_shear)
                         .forces.middleRows(frame * floors, floors)
                         .bottomRows(3)
                         .middleCols(frame * forces, forces),
                     in_row(OutputKind::storey_shear).forces.bottomRows(3).rightCols(forces)));
    EXPECT_TRUE(near(plan.coupled.at(static_cast<std::size_t>(frame)).rows * to, row.coupled.front().rows));
  }
}

TEST(StruckColumnsInPlan, AreThoseOfARow) {
  for (const double degrees : {0.0, 90.0, 37.0}) {
    for (const double capacity : {0.0, 150.0}) {
      const PlaneFrame frame = struck_frame(capacity);
      const StructuralModel in_row = plane_frame_model(frame, 1.5);
      const Damping damping = ModalDamping{{0.05}};
      const Plan plan = two_frames(frame, degrees);
      expect_as_in_row(make_plan_building("A", plan_model(plan, 1.5), damping), make_building("A", in_row, damping, {}),
                       degrees, 0);
      const Soil soil{{4e5, 2e3}, {6e6, 3e4}, 60, 700};
      // The feet of columns, which a plan knows nothing of, are with the foundation in a row.
      PlanSoil below;
      below.mass = 2 * (soil.mass + in_row.rigid_body.foot_mass);
      below.inertia_x = below.inertia_y = 1400;
      below.sway_x = below.sway_y = {8e5, 4e3};
      below.rocking_x = below.rocking_y = {12e6, 6e4};
      expect_as_in_row(make_plan_building("A", plan_model(plan, 1.5), damping, false, below),
                       make_building("A", in_row, damping, {.soil = soil}), degrees, 2);
      Isolation bearings{.mass = 50, .bearings = {}, .damping = 20};
      bearings.bearings.stiffness = 2e3;
      PlanIsolation slab{
          .mass = 2 * (bearings.mass + in_row.rigid_body.foot_mass), .centre = {4.5, 4.5}, .inertia = 900};
      for (const double x : {1.0, 8.0}) {
        slab.bearings.push_back({.at = {x, 4.5}, .bearing = {}, .damping = 20});
        slab.bearings.back().bearing.stiffness = 2e3;
      }
      expect_as_in_row(make_plan_building("A", plan_model(plan, 1.5), damping, false, {}, slab),
                       make_building("A", in_row, damping, {.isolation = bearings}), degrees, 0);
    }
  }
}

// A node moves along its frame by itself and across it with the edge; both together as a rigid body where nothing
// bends.
TEST(StruckColumnsInPlan, MoveAcrossTheirFrameWithTheEdge) {
  const PlanModel model = plan_model(two_frames(struck_frame(), 37), 1.5);
  const PlanPoint at(5, 3), direction(0.6, 0.8);
  Eigen::VectorXd rigid = Eigen::VectorXd::Zero(model.dofs());  // of the second storey and above, moved and turned
  const Eigen::Vector3d moved(0.03, -0.02, 1e-3);
  const PlanPoint about = model.footprint.corner + model.centres[0];
  for (Index f = 0; f < model.floors(); ++f) {
    const PlanPoint arm = model.footprint.corner + model.centres[f] - about;
    rigid.segment<3>(3 * f) << moved.x() - moved.z() * arm.y(), moved.y() + moved.z() * arm.x(), moved.z();
  }
  const auto of_rigid = [&](const PlanPoint& point, const PlanPoint& along) {
    const PlanPoint arm = point - about;
    return along.dot(PlanPoint(moved.x() - moved.z() * arm.y(), moved.y() + moved.z() * arm.x()));
  };
  const Index node = 2;  // in the third storey
  const PlanModel::Node& one = model.nodes[node];
  const PlanPoint on_line = model.footprint.corner + one.through + 3.0 * one.along;
  rigid(model.first_node_dof() + node) = of_rigid(on_line, one.along);
  EXPECT_NEAR(model.movement(model.floors() + node, on_line, direction).dot(rigid), of_rigid(on_line, direction),
              1e-15);
  EXPECT_EQ(model.floor_at_or_above(model.floors() + node), 2);
  EXPECT_EQ(model.floor_at_or_above(model.floors()), 0);
  EXPECT_EQ(model.floor_at_or_above(1), 1);
  EXPECT_NEAR(model.movement(model.floors() + node, at, one.along)(model.first_node_dof() + node), 1, 1e-15);
}

// All mass moves with all floors and nodes, but for the lower halves of the lowest columns, as of any frame.
TEST(StruckColumnsInPlan, KeepTheMassOfTheBuilding) {
  const PlaneFrame frame = struck_frame();
  const Plan plan = two_frames(frame, 37);
  const PlanModel model = plan_model(plan);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(model.dofs());
  const PlanPoint along = plan.planes.front().direction;
  for (Index f = 0; f < model.floors(); ++f) moved.segment<2>(3 * f) = along;
  moved.segment(model.first_node_dof(), std::ssize(model.nodes)).setOnes();
  // Of the pieces of the lowest storey the lower halves of the lowest are on the ground.
  const double line = 0.4, more = line / 2 * ((3.5 - 1.4) + (3.5 - 2.0));
  const double all = std::accumulate(plan.masses.begin(), plan.masses.end(), 0.0) + 2 * more;
  EXPECT_NEAR(moved.dot(model.mass * moved), all, 1e-9 * all);
  EXPECT_NEAR(moved.dot(model.load * along), all, 1e-9 * all);
  Plan light = plan;
  light.masses = {0.1, 0.1, 0.1};
  EXPECT_THROW((void)plan_model(light), InvalidParameter);
}

TEST(StruckColumnsInPlan, NeedMass) {
  PlaneFrame frame = struck_frame();
  for (Section& column : frame.columns) column.line_mass = 0;
  PlanPlane plane;
  EXPECT_THROW(stand_frame(frame, plane), InvalidParameter);
}

}  // namespace
}  // namespace bentur
