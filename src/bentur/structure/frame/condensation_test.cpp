#include "bentur/structure/frame/condensation.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/modes.h"
#include "tests/support/exact/monograph_frames.h"

namespace bentur {
namespace {

StructuralModel full_frame(int model = 1) { return assemble_plane_frame(exact::monograph_frame(model)); }

// Six storeys, two bays [m, kN].
StructuralModel tall_frame() {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights.assign(6, 3.2);
  frame.bay_widths = {5.0, 6.0};
  frame.columns.assign(6, {0.16, 2.1e-3, 1.3});
  frame.beams.assign(6, {0.15, 3.1e-3, 2.2});
  frame.floor_masses.assign(6, 20.0);
  return assemble_plane_frame(frame);
}

TEST(StaticCondensation, StaticResponseIsExact) {
  for (const StructuralModel& full : {full_frame(), tall_frame()}) {
    const Eigen::Index n = full.floors();
    const StructuralModel reduced = condense_statically(full, n);
    for (Eigen::Index floor = 0; floor < n; ++floor) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(full.dofs());
      force(floor) = 7.0;
      const Eigen::VectorXd expected = full.stiffness.partialPivLu().solve(force);
      const Eigen::VectorXd actual = reduced.stiffness.partialPivLu().solve(force.head(n));
      // The condition number of these matrices is some 1e4.
      EXPECT_LE((actual - expected.head(n)).norm(), 1e-12 * expected.head(n).norm());
    }
  }
}

TEST(StaticCondensation, MassAndLoadAreTheEnergyAndWorkOfTheRigidShapes) {
  const StructuralModel full = full_frame();
  const StructuralModel reduced = condense_statically(full, 3);
  Eigen::MatrixXd t(9, 3);
  t << Eigen::Matrix3d::Identity(),
      -full.stiffness.bottomRightCorner(6, 6).inverse() * full.stiffness.bottomLeftCorner(6, 3);
  EXPECT_TRUE(reduced.mass.isApprox(t.transpose() * full.mass * t, 1e-13));
  EXPECT_TRUE(reduced.stiffness.isApprox(t.transpose() * full.stiffness * t, 1e-12));
  EXPECT_TRUE(reduced.load.isApprox(t.transpose() * full.load, 1e-13));
  EXPECT_EQ(reduced.mass, reduced.mass.transpose());
  EXPECT_EQ(reduced.stiffness, reduced.stiffness.transpose());
  EXPECT_EQ(reduced.elevations, full.elevations);
  EXPECT_EQ(reduced.storey_heights, full.storey_heights);
  EXPECT_EQ(reduced.floor_masses, full.floor_masses);
  EXPECT_EQ(condense_dynamically(full, 3).floor_masses, full.floor_masses);
}

TEST(StaticCondensation, FrequenciesAreUpperBounds) {
  // A Ritz method: every reduced frequency is at or above its own in the full model, and here within a few per cent.
  for (const StructuralModel& full : {full_frame(), tall_frame()}) {
    const Eigen::Index n = full.floors();
    const StructuralModel reduced = condense_statically(full, n);
    const Eigen::VectorXd expected = modes(full.mass, full.stiffness).omega;
    const Eigen::VectorXd actual = modes(reduced.mass, reduced.stiffness).omega;
    for (Eigen::Index j = 0; j < n; ++j) {
      EXPECT_GT(actual(j), expected(j));
      EXPECT_LT(actual(j), 1.05 * expected(j));
    }
  }
}

TEST(DynamicCondensation, TheLowestModeIsExact) {
  for (const StructuralModel& full : {full_frame(1), full_frame(2), full_frame(4), tall_frame()}) {
    const Eigen::Index n = full.floors();
    const Modes expected = modes(full.mass, full.stiffness);
    const StructuralModel reduced = condense_dynamically(full, n);
    const Modes actual = modes(reduced.mass, reduced.stiffness);
    EXPECT_NEAR(actual.omega(0) / expected.omega(0), 1, 1e-10);
    // The shape too, and as TᵀMT carries the rotations' inertia, its normalisation and its participation.
    const double scale = expected.shapes.col(0).head(n).cwiseAbs().maxCoeff();
    EXPECT_LE((actual.shapes.col(0) - expected.shapes.col(0).head(n)).cwiseAbs().maxCoeff(), 1e-9 * scale);
    EXPECT_NEAR(actual.shapes.col(0).dot(reduced.load), expected.shapes.col(0).dot(full.load),
                1e-9 * std::sqrt(full.load.head(n).sum()));
  }
}

TEST(DynamicCondensation, SettlesAtTheFrequencyOfAnyModelOfTwo) {
  // Masses 1 and m on springs 3 and 2 in a row, the upper one condensed: with the lower root of
  // m ω⁴ − (5m + 2) ω² + 6 = 0 it moves t = 2/(2 − ω²m) times as much as the lower one, so that M̄ = 1 + m t² and
  // K̄ = 3 + 2 (t − 1)². The heavier it is the less the static reduction, where the passes begin, knows of it.
  for (double m = 0.01; m < 2; m *= 1.2) {
    StructuralModel full;
    full.elevations = full.storey_heights = full.floor_masses = {1};
    full.mass = Eigen::Vector2d(1, m).asDiagonal();
    full.stiffness = Eigen::Matrix2d{{5, -2}, {-2, 2}};
    full.load = Eigen::Vector2d(1, m);
    const double omega_squared = 12 / (5 * m + 2 + std::sqrt((5 * m + 2) * (5 * m + 2) - 24 * m));
    const double t = 2 / (2 - omega_squared * m);
    const StructuralModel reduced = condense_dynamically(full, 1);
    EXPECT_NEAR(reduced.mass(0, 0) / (1 + m * t * t), 1, 1e-12) << m;
    EXPECT_NEAR(reduced.stiffness(0, 0) / (3 + 2 * (t - 1) * (t - 1)), 1, 1e-12) << m;
    EXPECT_NEAR(reduced.load(0) / (1 + m * t), 1, 1e-12) << m;
  }
}

TEST(DynamicCondensation, StaticIsNotExact) {
  // So the tests above can fail: the static reduction misses the lowest mode by more than ten times their tolerance.
  const StructuralModel full = full_frame();
  const StructuralModel reduced = condense_statically(full, 3);
  const double ratio = modes(reduced.mass, reduced.stiffness).omega(0) / modes(full.mass, full.stiffness).omega(0);
  EXPECT_GT(ratio, 1 + 1e-9);
}

TEST(DynamicCondensation, MasslessSecondaryIsStatic) {
  PlaneFrame frame = exact::monograph_frame(1);
  frame.mass_matrix = MassMatrix::lumped;
  const StructuralModel full = assemble_plane_frame(frame);
  const StructuralModel expected = condense_statically(full, 3);
  const StructuralModel actual = condense_dynamically(full, 3);
  EXPECT_TRUE(actual.stiffness.isApprox(expected.stiffness, 1e-12));
  EXPECT_TRUE(actual.mass.isApprox(expected.mass, 1e-13));
}

TEST(Condensation, NothingToCondense) {
  const StructuralModel full = full_frame();
  EXPECT_EQ(condense_statically(full, 9).stiffness, full.stiffness);
  EXPECT_EQ(condense_dynamically(full, 9).mass, full.mass);
}

TEST(Condensation, BadParametersAreRefused) {
  const StructuralModel full = full_frame();
  for (const Eigen::Index primary : {-1, 0, 2, 10}) {
    EXPECT_THROW(static_cast<void>(condense_statically(full, primary)), InvalidParameter) << primary;
    EXPECT_THROW(static_cast<void>(condense_dynamically(full, primary)), InvalidParameter) << primary;
  }
  StructuralModel loose = full;
  loose.stiffness.bottomRightCorner(6, 6).setZero();
  EXPECT_THROW(static_cast<void>(condense_statically(loose, 3)), std::runtime_error);
}

}  // namespace
}  // namespace bentur
