#include "bentur/structure/plan/plan_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Eigen::VectorXd;

/// One rigid storey (as good as) on springs: five frequencies by hand, of a symmetric block.
TEST(PlanSoils, ARigidBlockHasFiveFrequencies) {
  Plan plan{.footprint = {.corner = {3, -2}, .size = {8, 6}}, .storey_heights = {5}, .masses = {60}};
  plan.rigidity = PlanRigidity{.centres = {{4, 3}}, .x = {1e12}, .y = {1e12}, .torsion = {1e13}};
  const PlanSoil soil{.sway_x = {4e4, 0},
                      .sway_y = {5e4, 0},
                      .rocking_x = {9e5, 0},
                      .rocking_y = {8e5, 0},
                      .twist = Impedance{7e5, 0},
                      .mass = 20,
                      .inertia_x = 150,
                      .inertia_y = 170,
                      .twist_inertia = 300};
  const PlanBuilding on = make_plan_building("A", plan_model(plan), ModalDamping{{0}}, false, soil);
  ASSERT_EQ(on.modes.omega.size(), 8);
  std::vector<double> expected;
  const auto sway = [&](double k_h, double k_r, double i_f) {
    Eigen::Matrix2d m, k;
    m << 60 + 20, 60 * 5, 60 * 5, 60 * 25 + i_f;
    k << k_h, 0, 0, k_r;
    for (const double value : generalised_values(k, m)) expected.push_back(std::sqrt(value));
  };
  sway(4e4, 9e5, 150);
  sway(5e4, 8e5, 170);
  expected.push_back(std::sqrt(7e5 / (60 * (64 + 36) / 12.0 + 300)));
  std::sort(expected.begin(), expected.end());
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(on.modes.omega(i), expected[i], 1e-6 * expected[i]);
}

Plan eccentric() {
  Plan plan{.footprint = {.corner = {3, -2}, .size = {8, 6}}, .storey_heights = {3.5, 3}, .masses = {60, 45}};
  plan.centres_of_mass = {{4.5, 2.6}};
  plan.rigidity = PlanRigidity{.centres = {{3.7, 3.2}}, .x = {4e4, 3e4}, .y = {5e4, 4e4}, .torsion = {6e5, 5e5}};
  return plan;
}

/// Soil so many times as stiff as this one, without damping.
PlanSoil soil_times(double factor) {
  return {.sway_x = {4e4 * factor, 0},
          .sway_y = {5e4 * factor, 0},
          .rocking_x = {9e5 * factor, 0},
          .rocking_y = {8e5 * factor, 0},
          .twist = Impedance{7e5 * factor, 0},
          .mass = 20,
          .inertia_x = 150,
          .inertia_y = 170,
          .twist_inertia = 300};
}

/// What soil gives way goes as one over its stiffness; the tolerance at the end is that of ω² of one matrix, 1e-16 of
/// its largest.
TEST(PlanSoils, StiffSoilIsNone) {
  const PlanModel model = plan_model(eccentric());
  const VectorXd fixed = make_plan_building("A", model, ModalDamping{{0}}).modes.omega;
  const auto apart = [&](double factor) -> VectorXd {
    const PlanBuilding on = make_plan_building("A", model, ModalDamping{{0}}, false, soil_times(factor));
    return 1 - on.modes.omega.head(fixed.size()).cwiseQuotient(fixed).array();
  };
  const VectorXd soft = apart(1e4), stiff = apart(1e6);
  EXPECT_GT(soft.minCoeff(), 1e-7);
  EXPECT_LT(stiff.maxCoeff(), 1e-5);
  EXPECT_LE((soft / 100 - stiff).cwiseAbs().maxCoeff(), 2e-3 * stiff.maxCoeff());
  EXPECT_LE(apart(1e12).cwiseAbs().maxCoeff(), 1e-3);
}

/// A rigid twist takes the place of a stiff one.
TEST(PlanSoils, ARigidTwistIsAStiffOne) {
  const PlanModel model = plan_model(eccentric());
  PlanSoil soil = soil_times(1);
  soil.twist->stiffness = 7e11;
  const VectorXd stiff = make_plan_building("A", model, ModalDamping{{0}}, false, soil).modes.omega;
  soil.twist.reset();
  const PlanBuilding rigid = make_plan_building("A", model, ModalDamping{{0}}, false, soil);
  ASSERT_EQ(rigid.modes.omega.size(), 10);
  ASSERT_EQ(stiff.size(), 11);
  EXPECT_LE((stiff.head(10).cwiseQuotient(rigid.modes.omega).array() - 1).abs().maxCoeff(), 1e-5);
}

TEST(PlanSoils, AHalfSpaceBelowADisc) {
  const HalfSpace ground{.shear_wave_velocity = 150, .density = 1.8, .poisson = 0.35, .radius = 6};
  PlanSoil foundation = soil_times(1);
  foundation.mass = 90;
  foundation.inertia_x = 700;
  foundation.inertia_y = 900;
  foundation.twist_inertia = 1500;
  const PlanSoil soil = soil_in_plan(ground, foundation);
  const double g = 1.8 * 150 * 150, r = 6;
  const auto near = [](const Impedance& found, double stiffness, double damping) {
    EXPECT_NEAR(found.stiffness, stiffness, 1e-13 * stiffness);
    EXPECT_NEAR(found.damping, damping, 1e-13 * damping);
  };
  const auto rocking = [&](double inertia) {
    const double ratio = 3 * 0.65 * inertia / (8 * 1.8 * std::pow(r, 5));
    return 0.8 * std::pow(r, 4) * std::sqrt(1.8 * g) / (0.65 * (1 + ratio));
  };
  near(soil.sway_x, 8 * g * r / 1.65, 4.6 * 1.8 * 150 * r * r / 1.65);
  near(soil.sway_y, 8 * g * r / 1.65, 4.6 * 1.8 * 150 * r * r / 1.65);
  near(soil.rocking_x, 8 * g * std::pow(r, 3) / (3 * 0.65), rocking(700));
  near(soil.rocking_y, 8 * g * std::pow(r, 3) / (3 * 0.65), rocking(900));
  ASSERT_TRUE(soil.twist);
  // Damping ratio 0.5/(1 + 2 B_t) of the disc alone.
  const double twist = 16 * g * std::pow(r, 3) / 3, ratio = 0.5 / (1 + 2 * 1500 / (1.8 * std::pow(r, 5)));
  near(*soil.twist, twist, 2 * ratio * std::sqrt(twist * 1500));
}

TEST(PlanSoils, WhatIsOutOfRangeIsRefused) {
  const auto refused = [](auto change) -> std::string {
    PlanSoil soil = soil_times(1);
    change(soil);
    try {
      (void)make_plan_building("A", plan_model(eccentric()), ModalDamping{{0}}, false, soil);
    } catch (const InvalidParameter& error) {
      return error.parameter();
    }
    return "nothing";
  };
  EXPECT_EQ(refused([](PlanSoil&) {}), "nothing");
  EXPECT_EQ(refused([](PlanSoil& soil) { soil.sway_y.stiffness = 0; }), "soil.sway_y.stiffness");
  EXPECT_EQ(refused([](PlanSoil& soil) { soil.rocking_x.damping = -1; }), "soil.rocking.damping");
  EXPECT_EQ(refused([](PlanSoil& soil) { soil.twist->stiffness = -1; }), "soil.twist.stiffness");
  EXPECT_EQ(refused([](PlanSoil& soil) { soil.inertia_y = 0; }), "soil.foundation.inertia_y");
  EXPECT_EQ(refused([](PlanSoil& soil) { soil.twist_inertia = 0; }), "soil.foundation.twist_inertia");
}

/// One storey on three elastic bearings, all centres elsewhere: six frequencies of the matrices by hand.
TEST(PlanBearings, EccentricOnesHaveTheFrequenciesOfTheirMatrices) {
  Plan plan{.footprint = {.corner = {3, -2}, .size = {8, 6}}, .storey_heights = {3.5}, .masses = {60}};
  plan.centres_of_mass = {{4.5, 2.6}};
  plan.rigidity = PlanRigidity{.centres = {{3.7, 3.2}}, .x = {4e4}, .y = {5e4}, .torsion = {6e5}};
  PlanIsolation isolation{.mass = 40, .centre = {4.1, 3.3}, .inertia = 350};
  isolation.bearings = {{.at = {1, 1}, .bearing = {.stiffness = 900}},
                        {.at = {7, 0.5}, .bearing = {.stiffness = 500}},
                        {.at = {2, 5.5}, .bearing = {.stiffness = 1400}}};
  const PlanBuilding made = make_plan_building("A", plan_model(plan), ModalDamping{{0}}, false, {}, isolation);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(6, 6);
  const auto add = [&](double stiffness, const Eigen::RowVector3d& slab, const Eigen::RowVector3d& floor) {
    Eigen::RowVectorXd row(6);
    row << slab, floor;
    k += stiffness * row.transpose() * row;
  };
  const Eigen::RowVector3d none(0, 0, 0);
  const auto bearing = [&](double x, double y, double stiffness) {
    add(stiffness, {1, 0, -(y - 3.3)}, none);
    add(stiffness, {0, 1, x - 4.1}, none);
  };
  bearing(1, 1, 900);
  bearing(7, 0.5, 500);
  bearing(2, 5.5, 1400);
  add(4e4, {-1, 0, 3.2 - 3.3}, {1, 0, -(3.2 - 2.6)});
  add(5e4, {0, -1, -(3.7 - 4.1)}, {0, 1, 3.7 - 4.5});
  add(6e5, {0, 0, -1}, {0, 0, 1});
  VectorXd mass(6);
  mass << 40, 40, 350, 60, 60, 60 * (64 + 36) / 12.0;
  const VectorXd values = generalised_values(k, mass.asDiagonal().toDenseMatrix());
  ASSERT_EQ(made.modes.omega.size(), 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double omega = std::sqrt(values(i));
    EXPECT_NEAR(made.modes.omega(i), omega, 1e-12 * made.modes.omega(5));
  }
  EXPECT_EQ(made.model.elevations, (std::vector<double>{0, 3.5}));
  EXPECT_EQ(made.model.first_storey(), 1);
}

TEST(PlanBearings, WhatCannotStandIsRefused) {
  const auto refused = [](auto change) -> std::string {
    PlanIsolation isolation{.mass = 40, .centre = {4, 3}, .inertia = 300};
    isolation.bearings = {{.at = {1, 1}, .bearing = {.stiffness = 900}}, {.at = {7, 5}, .bearing = {.stiffness = 900}}};
    std::optional<PlanSoil> soil;
    change(isolation, soil);
    try {
      (void)make_plan_building("A", plan_model(eccentric()), ModalDamping{{0}}, false, soil, isolation);
    } catch (const InvalidParameter& error) {
      return error.parameter();
    }
    return "nothing";
  };
  EXPECT_EQ(refused([](auto&, auto&) {}), "nothing");
  EXPECT_EQ(refused([](auto& one, auto&) { one.mass = 0; }), "isolation.mass");
  EXPECT_EQ(refused([](auto& one, auto&) { one.inertia = -1; }), "isolation.inertia");
  EXPECT_EQ(refused([](auto& one, auto&) { one.bearings.clear(); }), "isolation.bearing");
  EXPECT_EQ(refused([](auto& one, auto&) { one.bearings[1].at = one.bearings[0].at; }), "isolation.bearing");
  EXPECT_EQ(refused([](auto& one, auto&) { one.bearings[1].bearing.stiffness = 0; }), "isolation.bearing[1].stiffness");
  EXPECT_EQ(refused([](auto& one, auto&) { one.bearings[0].damping = -1; }), "isolation.bearing[0].damping");
  EXPECT_EQ(refused([](auto&, auto& soil) { soil = soil_times(1); }), "isolation");
}

}  // namespace
}  // namespace bentur
