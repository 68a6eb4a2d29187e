#include "bentur/structure/plan/plan_generic.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"
#include "tests/support/storeys_in_plan.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GenericPlan little_known(double ratio_of_stiffness) {
  GenericPlan generic;
  generic.along_x = {.storey_heights = {3.5, 3.2, 3.0},
                     .floor_masses = {120, 90, 60},
                     .period = 0.5,
                     .stiffness_ratio = ratio_of_stiffness};
  return generic;
}

Plan floors_of(const GenericPlan& generic) {
  Plan plan{.footprint = {.corner = {3, -2}, .size = {12, 9}}, .storey_heights = {}, .masses = {}};
  stand_generic(generic, plan);
  return plan;
}

/// The frequencies that a building in a row of these masses has with this first period.
VectorXd frequencies(GenericBuilding building, std::vector<double> masses, double period) {
  building.floor_masses = std::move(masses);
  building.period = period;
  const StructuralModel model = generic_model(building);
  return modes(model.mass, model.stiffness).omega;
}

TEST(PlanGeneric, SwaysAlongBothAxesAndTurnsByItself) {
  for (const double alpha : {0.0, 4.0, 30.0}) {
    GenericPlan generic = little_known(alpha);
    generic.period_y = 0.65;
    generic.torsion_ratio = 1.4;
    Plan plan = floors_of(generic);
    plan.inertias = {2000, 1600, 700};
    stand_generic(generic, plan);
    std::vector<double> expected;
    const GenericBuilding& known = generic.along_x;
    for (const VectorXd& omega :
         {frequencies(known, known.floor_masses, 0.5), frequencies(known, known.floor_masses, 0.65),
          frequencies(known, plan.inertias, 0.65 / 1.4)}) {
      expected.insert(expected.end(), omega.begin(), omega.end());
    }
    std::sort(expected.begin(), expected.end());
    const PlanModel model = plan_model(plan);
    const VectorXd found = modes(model.mass, model.stiffness).omega;
    ASSERT_EQ(found.size(), 9);
    for (Index i = 0; i < 9; ++i) EXPECT_NEAR(found(i), expected[i], 1e-11 * expected[i]) << alpha;
    for (Index j = 0; j < 3; ++j) EXPECT_LE((centre_of_rigidity(plan, j) - PlanPoint(6, 4.5)).norm(), 1e-12);
  }
}

TEST(PlanGeneric, StiffnessIsEvenOverTheFloorByDefault) {
  const Plan plan = floors_of(little_known(4));
  const double radius2 = (144.0 + 81.0) / 12;
  const MatrixXd& torsion = plan.cantilever->torsion;
  EXPECT_LE((torsion - radius2 * plan.cantilever->x).norm(), 1e-12 * torsion.norm());
  EXPECT_EQ(plan.cantilever->x, plan.cantilever->y);
}

/// One storey whose centre of rigidity is off its centre of mass by (1.5, −0.8): the 3 × 3 problem by hand.
TEST(PlanGeneric, AnEccentricOneIsTheThreeModesByHand) {
  GenericPlan generic;
  generic.along_x = {.storey_heights = {4}, .floor_masses = {80}, .period = 0.4, .stiffness_ratio = 12};
  generic.period_y = 0.3;
  generic.torsion_ratio = 1.25;
  generic.eccentricity = {1.5, -0.8};
  const PlanModel model = plan_model(floors_of(generic));
  const double m = 80, inertia = 80 * (144.0 + 81.0) / 12;
  const auto squared = [](double period) { return std::pow(2 * std::numbers::pi / period, 2); };
  const double k_x = m * squared(0.4), k_y = m * squared(0.3), k_r = inertia * squared(0.4 / 1.25);
  Eigen::Matrix3d by_hand;       // forces through (1.5, −0.8): u_x + 0.8 θ, u_y + 1.5 θ
  by_hand << k_x, 0, 0.8 * k_x,  //
      0, k_y, 1.5 * k_y,         //
      0.8 * k_x, 1.5 * k_y, k_r + 0.64 * k_x + 2.25 * k_y;
  EXPECT_LE((model.stiffness - by_hand).norm(), 1e-12 * by_hand.norm());
  EXPECT_LE((model.storey_forces - by_hand).norm(), 1e-12 * by_hand.norm());
  EXPECT_LE((centre_of_rigidity(floors_of(generic), 0) - PlanPoint(7.5, 3.7)).norm(), 1e-12);
}

/// Floors whose centres of mass differ: rigidity is on one line, off the centre of all mass.
TEST(PlanGeneric, StandsOnOneLineAndBearsWhatActsAbove) {
  GenericPlan generic = little_known(4);
  generic.eccentricity = {0.6, 0.2};
  Plan plan = floors_of(generic);
  plan.centres_of_mass = {{5.5, 4.0}, {6.5, 5.0}, {6.0, 4.5}};
  stand_generic(generic, plan);
  const PlanPoint line((120 * 5.5 + 90 * 6.5 + 60 * 6.0) / 270 + 0.6, (120 * 4.0 + 90 * 5.0 + 60 * 4.5) / 270 + 0.2);
  for (Index j = 0; j < 3; ++j) EXPECT_LE((centre_of_rigidity(plan, j) - line).norm(), 1e-12);
  VectorXd x(9);
  x << 0.01, -0.02, 0.001, 0.03, 0.01, -0.002, 0.05, 0.02, 0.003;
  test::expect_storeys_bear_what_acts_above(plan, plan_model(plan), x);
}

TEST(PlanGeneric, ImpossibleOnesAreRefused) {
  GenericPlan generic = little_known(4);
  generic.torsion_ratio = 0;
  EXPECT_THROW((void)floors_of(generic), InvalidParameter);
  generic = little_known(4);
  generic.period_y = -0.1;
  EXPECT_THROW((void)floors_of(generic), InvalidParameter);
  Plan plan = floors_of(little_known(4));
  plan.cantilever->y.conservativeResize(2, 2);
  EXPECT_THROW((void)plan_model(plan), InvalidParameter);
}

}  // namespace
}  // namespace bentur
