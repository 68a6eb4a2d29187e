#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/condensation.h"
#include "bentur/structure/plan/plan.h"
#include "tests/support/storeys_in_plan.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

PlaneFrame frame_of(double depth, std::vector<double> bays) {
  PlaneFrame frame;
  frame.elastic_modulus = 2.5e7;
  frame.storey_heights = {3.5, 3.2, 3.0};
  frame.bay_widths = std::move(bays);
  for (int j = 0; j < 3; ++j) {
    frame.columns.push_back({.area = 0.16, .inertia = 0.4 * depth * depth * depth / 12});
    frame.beams.push_back({.area = 0.12, .inertia = 0.0016 * (1 + 0.2 * j)});
  }
  return frame;
}

PlanPlane plane_of(const PlaneFrame& frame, double degrees, PlanPoint through) {
  PlanPlane plane;
  const double angle = degrees * std::numbers::pi / 180;
  plane.through = std::move(through);
  plane.direction = {std::cos(angle), std::sin(angle)};
  stand_frame(frame, plane);
  return plane;
}

/// Four frames around three floors whose centres of mass are not above one another.
Plan four_frames() {
  Plan plan{.footprint = {.corner = {4, 1}, .size = {12, 9}},
            .storey_heights = {3.5, 3.2, 3.0},
            .masses = {120, 90, 60},
            .centres_of_mass = {{5.5, 4.0}, {6.5, 5.0}, {6.0, 4.5}}};
  plan.planes = {plane_of(frame_of(0.40, {5, 4}), 0, {0, 0.5}), plane_of(frame_of(0.55, {5, 4}), 0, {0, 8.5}),
                 plane_of(frame_of(0.45, {4, 4}), 90, {1, 0}), plane_of(frame_of(0.5, {3, 3, 3}), 75, {10, 2})};
  return plan;
}

TEST(PlanFrames, AreTheMatrixByHand) {
  const Plan plan = four_frames();
  const PlanModel model = plan_model(plan);
  const std::vector<PlaneFrame> frames = {frame_of(0.40, {5, 4}), frame_of(0.55, {5, 4}), frame_of(0.45, {4, 4}),
                                          frame_of(0.5, {3, 3, 3})};
  const std::vector<double> angles = {0, 0, 90, 75};
  const std::vector<PlanPoint> through = {{0, 0.5}, {0, 8.5}, {1, 0}, {10, 2}};
  MatrixXd by_hand = MatrixXd::Zero(9, 9);
  for (std::size_t p = 0; p < frames.size(); ++p) {
    // The frame's own stiffness, its joint rotations condensed: those of a model with members that have mass.
    PlaneFrame heavy = frames[p];
    for (Section& section : heavy.columns) section.line_mass = 0.4;
    for (Section& section : heavy.beams) section.line_mass = 0.3;
    const StructuralModel whole = assemble_plane_frame(heavy);
    const MatrixXd& k = whole.stiffness;
    const Index rest = k.rows() - 3;
    const MatrixXd condensed =
        k.topLeftCorner(3, 3) -
        k.topRightCorner(3, rest) * k.bottomRightCorner(rest, rest).ldlt().solve(k.bottomLeftCorner(rest, 3));
    const double c = std::cos(angles[p] * std::numbers::pi / 180), s = std::sin(angles[p] * std::numbers::pi / 180);
    for (Index f = 0; f < 3; ++f) {
      for (Index g = 0; g < 3; ++g) {
        const PlanPoint arm_f = through[p] - plan.centres_of_mass[f], arm_g = through[p] - plan.centres_of_mass[g];
        const Eigen::Vector3d row_f(c, s, arm_f.x() * s - arm_f.y() * c), row_g(c, s, arm_g.x() * s - arm_g.y() * c);
        by_hand.block<3, 3>(3 * f, 3 * g) += condensed(f, g) * row_f * row_g.transpose();
      }
    }
  }
  EXPECT_LE((model.stiffness - by_hand).cwiseAbs().maxCoeff(), 1e-12 * by_hand.cwiseAbs().maxCoeff());
  EXPECT_EQ(model.stiffness, MatrixXd(model.stiffness.transpose()));
}

/// What the storeys bear is what the frames push the floors above with, moments about the centre of mass above.
TEST(PlanFrames, StoreysBearWhatActsAbove) {
  const Plan plan = four_frames();
  const PlanModel model = plan_model(plan);
  VectorXd x(9);
  x << 0.01, -0.02, 0.001, 0.03, 0.01, -0.002, 0.05, 0.02, 0.003;
  const VectorXd storeys = test::expect_storeys_bear_what_acts_above(plan, model, x);
  // Of its own plane the shear is the sum of the forces along it.
  double along = 0;
  for (const PlanModel::Plane& plane : model.planes) along += (plane.pushes.col(0) * (plane.shears.row(0) * x))(0);
  EXPECT_NEAR(along, storeys(0), 1e-12 * storeys.cwiseAbs().maxCoeff());
}

TEST(PlanFrames, StandBesidePlanesAndUnderGravity) {
  Plan plan = four_frames();
  const MatrixXd frames = plan_model(plan).stiffness;
  PlanPlane wall{.name = "wall", .through = {0, 3}, .direction = PlanPoint::UnitX()};
  wall.storeys.stiffnesses = {4e4, 3e4, 2e4};
  plan.planes.push_back(wall);
  const MatrixXd both = plan_model(plan).stiffness;
  plan.planes = {wall};
  plan.rigidity = PlanRigidity{.centres = {{6, 4}}, .x = {}, .y = {1e3}, .torsion = {1e4}};
  const MatrixXd alone = plan_model(plan).stiffness;
  plan.planes.clear();
  plan.rigidity->x = {1e-3};
  const MatrixXd rest = plan_model(plan).stiffness;
  EXPECT_LE((both - frames - (alone - rest)).cwiseAbs().maxCoeff(), 1e-8 * both.cwiseAbs().maxCoeff());
  Plan loaded = four_frames();
  loaded.gravity_loads = {0, 0, 1e9};
  EXPECT_THROW(static_cast<void>(plan_model(loaded)), InvalidParameter);
  loaded.gravity_loads = {900, 800, 500};
  const PlanModel soft = plan_model(loaded);
  EXPECT_LE((soft.stiffness + soft.softening - frames).cwiseAbs().maxCoeff(), 1e-12 * frames.cwiseAbs().maxCoeff());
}

TEST(PlanFrames, HoldAsTheirStoreysDoAlone) {
  Plan plan = four_frames();
  for (const PlanPlane& plane : plan.planes) {
    ASSERT_EQ(plane.storeys.stiffnesses.size(), 3U);
    // All floors above move as one.
    VectorXd moved(3);
    for (Index j = 0; j < 3; ++j) {
      moved.setZero();
      moved.tail(3 - j).setOnes();
      EXPECT_NEAR(plane.storeys.stiffnesses[j], moved.dot(plane.sway_stiffness * moved),
                  1e-12 * plane.storeys.stiffnesses[j]);
    }
  }
  plan.planes.erase(plan.planes.begin() + 2, plan.planes.end());
  EXPECT_EQ(unheld_storeys(plan).size(), 3U);  // along y
  plan = four_frames();
  plan.storey_heights.pop_back();
  plan.masses.pop_back();
  plan.centres_of_mass.pop_back();
  EXPECT_THROW(static_cast<void>(plan_model(plan)), InvalidParameter);
}

}  // namespace
}  // namespace bentur
