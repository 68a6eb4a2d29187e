#include "bentur/structure/sway.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Two storeys, two bays, nothing regular about it [m, kN].
PlaneFrame lopsided_frame(Condensation condensation) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0, 3.0};
  frame.bay_widths = {5.0, 7.5};
  frame.columns = {{0.16, 2.1e-3, 1.6}, {0.12, 1.2e-3, 0.9}};
  frame.beams = {{0.15, 3.1e-3, 2.2}, {0.15, 2.9e-3, 2.1}};
  frame.floor_masses = {12.0, 11.0};
  frame.condensation = condensation;
  return frame;
}

TEST(SwayAt, IsTheFloorsOwnAtAFloorAndZeroAtTheBase) {
  const StructuralModel frame = plane_frame_model(lopsided_frame(Condensation::static_), 1.5);
  const StructuralModel stick =
      stick_model({.storey_heights = {4.0, 3.0}, .masses = {2.0, 1.0}, .stiffnesses = {3.0, 2.0}}, 1.5);
  for (const StructuralModel& model : {frame, stick}) {
    for (const Face face : {Face::left, Face::right}) {
      EXPECT_TRUE(sway_at(model, 1.5, face).isZero(0));
      EXPECT_TRUE(sway_at(model, 5.5, face).isApprox(VectorXd::Unit(2, 0), 1e-14));
      EXPECT_TRUE(sway_at(model, 8.5, face).isApprox(VectorXd::Unit(2, 1), 1e-14));
    }
    EXPECT_THROW((void)sway_at(model, 1.4, Face::left), InvalidParameter);
    EXPECT_THROW((void)sway_at(model, 8.6, Face::left), InvalidParameter);
  }
}

TEST(SwayAt, IsStraightBetweenTheFloorsOfAStick) {
  const StructuralModel stick =
      stick_model({.storey_heights = {4.0, 3.0}, .masses = {2.0, 1.0}, .stiffnesses = {3.0, 2.0}});
  EXPECT_TRUE(sway_at(stick, 1.0, Face::left).isApprox(Eigen::Vector2d(0.25, 0.0), 1e-14));
  EXPECT_TRUE(sway_at(stick, 4.75, Face::right).isApprox(Eigen::Vector2d(0.75, 0.25), 1e-14));
}

// A cantilever of two columns that a beam without stiffness joins: under a force F at the top y(z) = F z²(3h −
// z)/(6EI), a cubic, so that the interpolation is it to round-off.
TEST(SwayAt, IsTheCantileversCurve) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0};
  frame.bay_widths = {5.0};
  frame.columns = {{0.16, 2.1e-3, 1.0}};
  frame.beams = {{0.15, 1e-15, 2.0}};
  const StructuralModel model = plane_frame_model(frame);
  const double h = 4.0;
  for (const double z : {0.5, 1.0, 2.0, 3.1, 3.9}) {
    const double expected = z * z * (3 * h - z) / (2 * h * h * h);  // of the sway at the top
    EXPECT_NEAR(sway_at(model, z, Face::left)(0), expected, 1e-9) << z;
    EXPECT_NEAR(sway_at(model, z, Face::right)(0), expected, 1e-9) << z;
  }
}

// With rotations kept the row has entries on the joints of its own line; condensed it is that row times T.
TEST(SwayAt, RecoversTheRotationsOfTheLineThatFacesTheGap) {
  const StructuralModel kept = assemble_plane_frame(lopsided_frame(Condensation::none));
  const StructuralModel condensed = plane_frame_model(lopsided_frame(Condensation::static_));
  const Index floors = 2, rotations = 6;
  const Eigen::MatrixXd bottom = -kept.stiffness.bottomRightCorner(rotations, rotations)
                                      .ldlt()
                                      .solve(kept.stiffness.bottomLeftCorner(rotations, floors));
  for (const auto& [face, line] : {std::pair(Face::left, 0), std::pair(Face::right, 2)}) {
    for (const double z : {1.3, 4.0, 5.2, 6.9}) {
      const VectorXd row = sway_at(kept, z, face);
      for (Index joint = 0; joint < rotations; ++joint) {
        if (joint % 3 != line) {
          EXPECT_EQ(row(floors + joint), 0.0) << z << ' ' << joint;
        }
      }
      const VectorXd expected = row.head(floors) + bottom.transpose() * row.tail(rotations);
      EXPECT_TRUE(sway_at(condensed, z, face).isApprox(expected, 1e-12)) << z;
    }
  }
  EXPECT_FALSE(sway_at(condensed, 2.0, Face::left).isApprox(sway_at(condensed, 2.0, Face::right), 1e-3));
  const StructuralModel dynamic = plane_frame_model(lopsided_frame(Condensation::dynamic));
  EXPECT_TRUE(sway_at(dynamic, 2.0, Face::left).isApprox(sway_at(condensed, 2.0, Face::left), 1e-2));
}

}  // namespace
}  // namespace bentur
