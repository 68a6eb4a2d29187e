#include "bentur/structure/plan/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

using Eigen::VectorXd;

PlanPlane plane_at(double at, bool along_x, std::vector<double> stiffnesses) {
  return {.name = "",
          .through = along_x ? PlanPoint(0, at) : PlanPoint(at, 0),
          .direction = along_x ? PlanPoint::UnitX() : PlanPoint::UnitY(),
          .storeys = {.storey_heights = {}, .masses = {}, .stiffnesses = std::move(stiffnesses)}};
}

PlanPlane oblique_plane(double degrees, PlanPoint through, std::vector<double> stiffnesses) {
  const double angle = degrees * std::numbers::pi / 180;
  PlanPlane made = plane_at(0, true, std::move(stiffnesses));
  made.through = std::move(through);
  made.direction = {std::cos(angle), std::sin(angle)};
  return made;
}

/// One storey of space-targets 1.
Plan eccentric_storey() {
  return {.footprint = {.size = {12, 18}},
          .storey_heights = {3.0},
          .masses = {200},
          .planes = {plane_at(1, true, {9e4}), plane_at(17, true, {5e4}), plane_at(2, false, {6e4}),
                     plane_at(10, false, {6e4})}};
}

/// Two storeys whose centres of mass are not above one another.
Plan shifted_storeys() {
  Plan plan{.footprint = {.corner = {3, -2}, .size = {12, 9}},
            .storey_heights = {3.5, 3.0},
            .masses = {120, 90},
            .centres_of_mass = {{5.5, 4.0}, {6.5, 5.0}},
            .inertias = {2000, 1500},
            .planes = {plane_at(0.5, true, {9e4, 7e4}), plane_at(8, true, {4e4, 0}),
                       oblique_plane(75, {2, 3}, {5e4, 6e4}), plane_at(11, false, {3e4, 2e4})}};
  plan.rigidity = PlanRigidity{.centres = {{6, 4}, {5, 5}}, .x = {2e4}, .y = {}, .torsion = {3e5, 2e5}};
  return plan;
}

/// Free vibration from rest at `start`, undamped.
VectorXd free_vibration(const PlanModel& model, const VectorXd& start, double t) {
  const Modes found = modes(model.mass, model.stiffness);
  const VectorXd q = found.shapes.transpose() * model.mass * start;
  return found.shapes * ((found.omega * t).array().cos() * q.array()).matrix();
}

TEST(Plan, OneStoreyTurnsAndSwaysInClosedForm) {
  // (P-16): K_xθ = k e, Ω² = k_θ/(J ω_x²); the second and third mode, the first is in y.
  const PlanModel model = plan_model(eccentric_storey());
  const double k = 14e4, m = 200, j = 7800, e = 2.2857142857143, r2 = 39;
  EXPECT_DOUBLE_EQ(model.mass(2, 2), j);  // (P-2)
  EXPECT_NEAR(model.stiffness(0, 2), k * e, 1e-9 * k);
  EXPECT_NEAR(model.stiffness(1, 2), 0, 1e-9);
  const double omega2 = model.stiffness(2, 2) / (j * k / m);
  EXPECT_NEAR(omega2, 1.992673992674, 1e-12);
  const Modes found = modes(model.mass, model.stiffness);
  const double root = std::sqrt((1 - omega2) * (1 - omega2) + 4 * e * e / r2);
  EXPECT_NEAR(found.omega(1) * found.omega(1) / (k / m), 0.5 * (1 + omega2 - root), 1e-12);
  EXPECT_NEAR(found.omega(2) * found.omega(2) / (k / m), 0.5 * (1 + omega2 + root), 1e-12);
  const VectorXd periods = 2 * std::numbers::pi * found.omega.cwiseInverse();
  // As the independent program has them.
  EXPECT_NEAR(periods(0), 0.25650996603237, 1e-13);
  EXPECT_NEAR(periods(1), 0.25320814055804, 1e-13);
  EXPECT_NEAR(periods(2), 0.16337210230915, 1e-13);
  const double w2 = found.omega(2) * found.omega(2);
  EXPECT_NEAR(found.shapes(2, 2) / found.shapes(0, 2), (w2 * m - k) / (k * e), 1e-12);

  const VectorXd at = free_vibration(model, Eigen::Vector3d(0.01, 0.02, 0), 3.7);
  EXPECT_NEAR(at(0), -0.0074476063430948, 1e-13);
  EXPECT_NEAR(at(1), -0.017785246397137, 1e-13);
  EXPECT_NEAR(at(2), 7.6495383161634e-05, 1e-15);
}

TEST(Plan, RigidityIsThePlanesThatHaveIt) {
  // (P-5), at a centre of mass off the middle.
  Plan by_planes = eccentric_storey();
  by_planes.centres_of_mass = {{5, 8}};
  Plan by_rigidity = by_planes;
  by_rigidity.planes.clear();
  const double y_c = (9e4 * 1 + 5e4 * 17) / 14e4, x_c = 6;
  const double torsion = 9e4 * (1 - y_c) * (1 - y_c) + 5e4 * (17 - y_c) * (17 - y_c) + 2 * 6e4 * 16;
  by_rigidity.rigidity = PlanRigidity{.centres = {{x_c, y_c}}, .x = {14e4}, .y = {12e4}, .torsion = {torsion}};
  const PlanModel one = plan_model(by_planes), other = plan_model(by_rigidity);
  EXPECT_TRUE(one.stiffness.isApprox(other.stiffness, 1e-14));
  EXPECT_TRUE(one.storey_forces.isApprox(other.storey_forces, 1e-14));
  // Both together add.
  Plan both = by_planes;
  both.rigidity = by_rigidity.rigidity;
  EXPECT_TRUE(plan_model(both).stiffness.isApprox(2 * one.stiffness, 1e-14));
}

TEST(Plan, AShearBuildingAlongEachAxis) {
  // Symmetric floors: what a stick is, and nothing couples.
  Plan plan{
      .footprint = {.size = {10, 14}},
      .storey_heights = {3.2, 3.0},
      .masses = {60, 50},
      .planes = {plane_at(1, true, {30e3, 20e3}), plane_at(13, true, {30e3, 20e3}), plane_at(5, false, {7e3, 8e3})}};
  const PlanModel model = plan_model(plan, 1.0);
  const StructuralModel stick = stick_model({{3.2, 3.0}, {60, 50}, {60e3, 40e3}}, 1.0);
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      EXPECT_DOUBLE_EQ(model.stiffness(3 * a, 3 * b), stick.stiffness(a, b));
      EXPECT_DOUBLE_EQ(model.mass(3 * a, 3 * b), stick.mass(a, b));
      EXPECT_EQ(model.stiffness(3 * a, 3 * b + 1), 0);
      EXPECT_NEAR(model.stiffness(3 * a, 3 * b + 2), 0, 1e-9);
    }
    EXPECT_EQ(model.load.row(3 * a), Eigen::RowVector2d(stick.load(a), 0));
    EXPECT_EQ(model.load.row(3 * a + 1), Eigen::RowVector2d(0, stick.load(a)));
    EXPECT_EQ(model.load.row(3 * a + 2), Eigen::RowVector2d(0, 0));
  }
  EXPECT_EQ(model.elevations, stick.elevations);
}

/// Gravity takes P/h from both translations of a storey and Σ P r²/h from its rotation (P-22).
TEST(Plan, GravityLoadsSoftenTranslationsAndRotation) {
  Plan plan = eccentric_storey();  // about its centre of mass r² = 39
  plan.planes = {plane_at(1, true, {7e4}), plane_at(17, true, {7e4}), plane_at(2, false, {6e4}),
                 plane_at(10, false, {6e4})};
  plan.gravity_loads = {60e3};
  const PlanModel model = plan_model(plan);
  const double k_x = 14e4, k_y = 12e4, k_theta = 14e4 * 64 + 12e4 * 16, p_h = 60e3 / 3.0, r2 = 39, m = 200;
  const Modes found = modes(model.mass, model.stiffness);
  VectorXd omega2 = Eigen::Vector3d((k_x - p_h) / m, (k_y - p_h) / m, (k_theta - p_h * r2) / (m * r2));
  std::sort(omega2.begin(), omega2.end());
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(found.omega(i) * found.omega(i) / omega2(i), 1, 1e-12);
  // What storeys bear is that of their planes alone.
  Plan without = plan;
  without.gravity_loads.clear();
  EXPECT_EQ(model.storey_forces, plan_model(without).storey_forces);
  EXPECT_TRUE((model.stiffness + model.softening).isApprox(plan_model(without).stiffness, 1e-14));
}

TEST(Plan, GravityLoadsAreTheWorkOfWeightsThatComeDown) {
  // Each floor's load, spread as its mass, comes down by Σ |Δ|²/(2 h) over the storeys below, Δ where it stands: here
  // of a ring of points with the floor's radius of gyration about its centre of mass.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  Plan plan = shifted_storeys();
  plan.gravity_loads = {900, 1500};
  const PlanModel model = plan_model(plan);
  constexpr int ring = 12;
  for (int n = 0; n < 20; ++n) {
    const VectorXd x = VectorXd::NullaryExpr(model.dofs(), [&] { return u(random); });
    double work = 0;
    for (Eigen::Index f = 0; f < 2; ++f) {
      const double radius = std::sqrt(plan.inertias[f] / plan.masses[f]);
      for (int i = 0; i < ring; ++i) {
        const double angle = 2 * std::numbers::pi * i / ring;
        const PlanPoint at =
            plan.footprint.corner + plan.centres_of_mass[f] + radius * PlanPoint(std::cos(angle), std::sin(angle));
        for (Eigen::Index j = 0; j <= f; ++j) {
          const double dx = model.drift(j, at, PlanPoint::UnitX()).dot(x);
          const double dy = model.drift(j, at, PlanPoint::UnitY()).dot(x);
          work += plan.gravity_loads[f] / ring / plan.storey_heights[j] * (dx * dx + dy * dy);
        }
      }
    }
    EXPECT_NEAR(x.dot(model.softening * x) / work, 1, 1e-12);
  }
}

TEST(Plan, LoadsUnderWhichItDoesNotStandAreRefusedWithTheirNumbers) {
  const auto refusal = [](Plan plan) -> std::string {
    try {
      static_cast<void>(plan_model(plan));
    } catch (const InvalidParameter& error) {
      return error.what();
    }
    return "nothing";
  };
  Plan plan = eccentric_storey();
  plan.planes = {plane_at(1, true, {7e4}), plane_at(17, true, {7e4}), plane_at(2, false, {6e4}),
                 plane_at(10, false, {6e4})};
  plan.gravity_loads = {2 * 12e4 * 3.0};  // twice what it bears along y
  EXPECT_NE(refusal(plan).find("2 times what the building bears"), std::string::npos) << refusal(plan);
  EXPECT_NE(refusal(plan).find("storey 1 has the least margin, and all loads times 0.5 are critical"),
            std::string::npos)
      << refusal(plan);
  plan.gravity_loads = {0.999 * 12e4 * 3.0};
  EXPECT_EQ(refusal(plan), "nothing");
  // Both axes hold and rotation does not: planes close to the middle.
  plan.planes = {plane_at(8, true, {14e4}), plane_at(10, true, {14e4}), plane_at(6, false, {28e4})};
  const double k_theta = 28e4;
  plan.gravity_loads = {1.25 * k_theta / 39 * 3.0};
  EXPECT_NE(refusal(plan).find("1.25 times what the building bears"), std::string::npos) << refusal(plan);
  plan.gravity_loads = {-1};
  EXPECT_NE(refusal(plan).find("gravity_loads[0]"), std::string::npos);
  plan.gravity_loads = {1, 1};
  EXPECT_NE(refusal(plan).find("gravity_loads"), std::string::npos);
  // Of two storeys the upper one.
  Plan two = shifted_storeys();
  two.gravity_loads = {0, 0};
  EXPECT_EQ(refusal(two), "nothing");
  two.gravity_loads = {0, 1e6};
  EXPECT_NE(refusal(two).find("storey 2 has the least margin"), std::string::npos) << refusal(two);
}

TEST(Plan, EnergyOfThePlanesIsThatOfTheStiffness) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const Plan plan = shifted_storeys();
  const PlanModel model = plan_model(plan);
  for (int n = 0; n < 20; ++n) {
    const VectorXd x = VectorXd::NullaryExpr(model.dofs(), [&] { return u(random); });
    double energy = 0;
    for (std::size_t p = 0; p < plan.planes.size(); ++p) {
      const VectorXd drifts = model.planes[p].drifts * x;
      for (Eigen::Index j = 0; j < 2; ++j) {
        energy += plan.planes[p].storeys.stiffnesses[j] * drifts(j) * drifts(j);
      }
    }
    // Rigidity moves with the point that is its centre.
    for (Eigen::Index j = 0; j < 2; ++j) {
      const PlanPoint at = plan.footprint.corner + plan.rigidity->centres[j];
      const double x_above = model.movement(j, at, PlanPoint::UnitX()).dot(x);
      const double x_below = j > 0 ? model.movement(0, at, PlanPoint::UnitX()).dot(x) : 0.0;
      const double turn = x(3 * j + 2) - (j > 0 ? x(2) : 0.0);
      energy += 2e4 * (x_above - x_below) * (x_above - x_below) + plan.rigidity->torsion[j] * turn * turn;
    }
    EXPECT_NEAR(x.dot(model.stiffness * x) / energy, 1, 1e-13);
    // What the storeys bear is what pushes the floors above, moments about the centre of mass of the storey's floor.
    const VectorXd forces = model.stiffness * x, storeys = model.storey_forces * x;
    const double scale = forces.cwiseAbs().maxCoeff();
    EXPECT_NEAR(storeys(3), forces(3), 1e-13 * scale);
    EXPECT_NEAR(storeys(4), forces(4), 1e-13 * scale);
    EXPECT_NEAR(storeys(5), forces(5), 1e-13 * scale);
    EXPECT_NEAR(storeys(0), forces(0) + forces(3), 1e-13 * scale);
    EXPECT_NEAR(storeys(1), forces(1) + forces(4), 1e-13 * scale);
    const PlanPoint arm = plan.centres_of_mass[1] - plan.centres_of_mass[0];
    EXPECT_NEAR(storeys(2), forces(2) + forces(5) + arm.x() * forces(4) - arm.y() * forces(3), 1e-12 * scale);
  }
}

TEST(Plan, MovesNothingByItsPlaceInTheCommonPlan) {
  Plan plan = shifted_storeys();
  const PlanModel here = plan_model(plan);
  plan.footprint.corner = {1e4, -3e4};
  const PlanModel there = plan_model(plan);
  EXPECT_EQ(here.stiffness, there.stiffness);
  const PlanPoint at(7, 1), shift = PlanPoint(1e4, -3e4) - PlanPoint(3, -2);
  EXPECT_TRUE(
      here.movement(1, at, PlanPoint::UnitX()).isApprox(there.movement(1, at + shift, PlanPoint::UnitX()), 1e-11));
}

TEST(Plan, WhatNothingHolds) {
  Plan plan = eccentric_storey();
  plan.planes = {plane_at(1, true, {9e4}), plane_at(17, true, {5e4})};
  std::vector<UnheldStorey> found = unheld_storeys(plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].direction, "y");
  plan.planes = {plane_at(1, true, {9e4}), plane_at(2, false, {9e4})};
  found = unheld_storeys(plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].direction, "rotation");
  plan.planes = {};
  EXPECT_EQ(unheld_storeys(plan).size(), 3U);
  EXPECT_THROW(static_cast<void>(plan_model(plan)), InvalidParameter);
  // The upper storey alone: its plane along y stops below it.
  Plan two = shifted_storeys();
  two.rigidity.reset();
  two.planes = {plane_at(0.5, true, {9e4, 7e4}), plane_at(8, true, {4e4, 4e4}), plane_at(11, false, {3e4, 0})};
  found = unheld_storeys(two);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].storey, 1);
  EXPECT_EQ(found[0].direction, "y");
  // A free body, as it is entered, is held by very little everywhere.
  Plan free = eccentric_storey();
  free.planes.clear();
  free.rigidity = PlanRigidity{.centres = {{6, 9}}, .x = {1e-9}, .y = {1e-9}, .torsion = {1e-9}};
  EXPECT_TRUE(unheld_storeys(free).empty());
}

TEST(Plan, RefusesWhatIsOutOfRange) {
  const auto refused = [](const auto& spoil) {
    Plan plan = shifted_storeys();
    spoil(plan);
    try {
      static_cast<void>(plan_model(plan));
    } catch (const InvalidParameter& error) {
      return error.parameter();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused([](Plan&) {}), "nothing");
  EXPECT_EQ(refused([](Plan& p) { p.footprint.size.x() = 0; }), "size");
  EXPECT_EQ(refused([](Plan& p) { p.footprint.corner.y() = std::nan(""); }), "corner");
  EXPECT_EQ(refused([](Plan& p) { p.storey_heights.clear(); }), "storey_heights");
  EXPECT_EQ(refused([](Plan& p) { p.masses.pop_back(); }), "masses");
  EXPECT_EQ(refused([](Plan& p) { p.inertias[1] = 0; }), "inertias[1]");
  EXPECT_EQ(refused([](Plan& p) { p.centres_of_mass[0] = {5, 9.01}; }), "centres_of_mass[0]");
  EXPECT_EQ(refused([](Plan& p) { p.centres_of_mass[0] = {12, 9}; }), "nothing");  // a corner belongs to it
  EXPECT_EQ(refused([](Plan& p) { p.planes[1].storeys.stiffnesses[0] = -1; }), "stiffnesses[0]");
  EXPECT_EQ(refused([](Plan& p) { p.planes[1].storeys.stiffnesses.pop_back(); }), "stiffnesses");
  EXPECT_EQ(refused([](Plan& p) { p.rigidity->torsion = {1, 1, 1}; }), "torsion");
  EXPECT_EQ(refused([](Plan& p) { p.rigidity->centres.clear(); }), "centre");
}

TEST(Plan, PlanesThatYieldHaveTheLawsOfStoreys) {
  Plan plan = shifted_storeys();
  plan.planes[0].storeys.yield_forces = {180, std::numeric_limits<double>::infinity()};
  plan.planes[0].storeys.hardening = {0.05};
  plan.planes[1].storeys.yield_forces = {100};  // the storey without stiffness has no law
  plan.planes[1].storeys.hysteresis = "peak-oriented";
  const PlanModel model = plan_model(plan);
  ASSERT_NE(model.planes[0].laws[0], nullptr);
  EXPECT_EQ(model.planes[0].laws[1], nullptr);
  EXPECT_DOUBLE_EQ(model.planes[0].laws[0]->initial_stiffness(), 9e4);
  EXPECT_DOUBLE_EQ(model.planes[0].laws[0]->yield_deformation(), 180 / 9e4);
  EXPECT_EQ(model.planes[1].laws[0]->name(), "peak-oriented");
  EXPECT_EQ(model.planes[1].laws[1], nullptr);
  EXPECT_EQ(model.stiffness, plan_model(shifted_storeys()).stiffness);
}

TEST(Plan, ModalDampingIsOneRatioPerModeOfThreeAFloor) {
  const PlanModel model = plan_model(shifted_storeys());
  const std::vector<double> ratios = {0.01, 0.02, 0.03, 0.04, 0.05, 0.06};
  const PlanBuilding building = make_plan_building("A", model, ModalDamping{ratios});
  for (Eigen::Index n = 0; n < 6; ++n) {
    EXPECT_DOUBLE_EQ(building.modal_damping(n, n), 2 * ratios[n] * building.modes.omega(n));
  }
  EXPECT_THROW(static_cast<void>(make_plan_building("A", model, ModalDamping{{0.05, 0.05}})), InvalidParameter);
  EXPECT_THROW(static_cast<void>(make_plan_building("A", model, ModalDamping{{0.05}}, true)), InvalidParameter);
  const PlanBuilding tangent = make_plan_building("A", model, StiffnessProportionalDamping{0.05}, true);
  EXPECT_DOUBLE_EQ(tangent.tangent_damping, 0.1 / tangent.modes.omega(0));
}

TEST(Plan, AWallHasNoModes) {
  const PlanBuilding wall = rigid_plan_building("W", {.corner = {1, 2}, .size = {0.5, 8}}, {3, 6});
  EXPECT_TRUE(wall.is_rigid());
  EXPECT_EQ(wall.model.dofs(), 6);
  EXPECT_TRUE(std::isinf(wall.model.floor_masses[1]));
  EXPECT_THROW(static_cast<void>(rigid_plan_building("W", {.size = {1, 1}}, {3, 3})), InvalidParameter);
  EXPECT_THROW(static_cast<void>(rigid_plan_building("W", {.size = {0, 1}}, {3})), InvalidParameter);
}

/// (P-5) of planes along the axes; of two that are oblique it is where their lines cross, whatever else turns the
/// floor back.
TEST(Plan, CentreOfRigidity) {
  const PlanPoint even = centre_of_rigidity(eccentric_storey(), 0);
  EXPECT_NEAR(even.x(), (2.0 + 10.0) / 2, 1e-13);
  EXPECT_NEAR(even.y(), (9e4 * 1 + 5e4 * 17) / 14e4, 1e-13);
  Plan oblique{.footprint = {.corner = {5, -3}, .size = {12, 9}},
               .storey_heights = {3, 3},
               .masses = {100, 90},
               .centres_of_mass = {{5, 4}, {6, 5}},
               .planes = {oblique_plane(30, {3, 2}, {7e4, 1e4}), oblique_plane(110, {3, 2}, {2e4, 5e4})}};
  oblique.rigidity = PlanRigidity{.centres = {{0, 0}}, .torsion = {4e6}};
  for (const Eigen::Index storey : {0, 1}) {
    const PlanPoint crossing = centre_of_rigidity(oblique, storey);
    EXPECT_NEAR(crossing.x(), 3, 1e-12) << storey;
    EXPECT_NEAR(crossing.y(), 2, 1e-12) << storey;
  }
}

/// What holds the storeys of a plan as a matrix (P-32).
Plan told_by_matrix(Plan plan) {
  const PlanModel model = plan_model(plan);
  plan.known = PlanStiffness{.at = model.centres, .matrix = model.stiffness};
  plan.planes.clear();
  plan.rigidity.reset();
  return plan;
}

TEST(PlanStiffness, IsThatOfThePlanesItWasMadeOf) {
  Plan given = shifted_storeys();
  Plan known = told_by_matrix(given);
  for (const bool loaded : {false, true}) {
    if (loaded) given.gravity_loads = known.gravity_loads = {1177, 883};
    for (const PlanPoint& parts : {PlanPoint(0, 0), PlanPoint(0.05, 0), PlanPoint(-0.03, 0.04)}) {
      const Plan one = with_masses_moved(given, parts), other = with_masses_moved(known, parts);
      const PlanModel by_planes = plan_model(one), by_matrix = plan_model(other);
      EXPECT_LE((by_matrix.stiffness - by_planes.stiffness).norm(), 1e-12 * by_planes.stiffness.norm());
      EXPECT_LE((by_matrix.storey_forces - by_planes.storey_forces).norm(), 1e-12 * by_planes.storey_forces.norm());
      for (Eigen::Index j = 0; j < 2; ++j) {
        EXPECT_LE((centre_of_rigidity(other, j) - centre_of_rigidity(one, j)).norm(), 1e-11) << j;
      }
    }
  }
  calibrate_period(given, 0.5);
  calibrate_period(known, 0.5);
  EXPECT_NEAR(*known.stiffness_factor, *given.stiffness_factor, 1e-12 * *given.stiffness_factor);
  EXPECT_LE((plan_model(known).stiffness - plan_model(given).stiffness).norm(), 1e-11 * known.known->matrix.norm());
}

TEST(PlanStiffness, HoldsEveryStoreyInEveryDirection) {
  Plan known = told_by_matrix(shifted_storeys());
  EXPECT_TRUE(unheld_storeys(known).empty());
  known.known->matrix.row(5).setZero();  // of the upper floor's rotation
  known.known->matrix.col(5).setZero();
  const std::vector<UnheldStorey> found = unheld_storeys(known);
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found[0].storey, 1);
  EXPECT_THROW((void)plan_model(known), InvalidParameter);
  known.known->matrix.conservativeResize(3, 3);
  EXPECT_THROW((void)plan_model(known), InvalidParameter);
}

/// What another program would say of a building in plan: shapes of any scale.
Plan told_by_modes(Plan plan, Eigen::Index count) {
  const PlanModel model = plan_model(plan);
  const Modes solved = modes(model.mass, model.stiffness);
  plan.modes.emplace();
  for (Eigen::Index mode = 0; mode < count; ++mode) {
    plan.modes->periods.push_back(2 * std::numbers::pi / solved.omega(mode));
    const Eigen::VectorXd shape = -3.7 * solved.shapes.col(mode);
    plan.modes->shapes.emplace_back(shape.begin(), shape.end());
  }
  plan.planes.clear();
  plan.rigidity.reset();
  return plan;
}

TEST(PlanModes, AllOfThemAreThePlanesTheyWereMadeOf) {
  const Plan given = shifted_storeys();
  const Plan known = told_by_modes(given, 6);
  const PlanModel by_planes = plan_model(given), by_modes = plan_model(known);
  EXPECT_LE((by_modes.stiffness - by_planes.stiffness).norm(), 1e-12 * by_planes.stiffness.norm());
  EXPECT_LE((by_modes.storey_forces - by_planes.storey_forces).norm(), 1e-12 * by_planes.storey_forces.norm());
  for (const double share : by_modes.known->mass_shares) EXPECT_NEAR(share, 1, 1e-12);
  const ModalDamping damping{{0.01, 0.02, 0.03, 0.04, 0.05, 0.06}};
  const PlanBuilding one = make_plan_building("A", by_planes, damping);
  const PlanBuilding other = make_plan_building("A", by_modes, damping);
  EXPECT_LE((other.modes.omega - one.modes.omega).norm(), 1e-12 * one.modes.omega.norm());
  EXPECT_LE((other.modes.shapes - one.modes.shapes).norm(), 1e-12 * one.modes.shapes.norm());
  EXPECT_LE((other.modal_damping - one.modal_damping).norm(), 1e-12 * one.modal_damping.norm());
}

/// In two of six modes floors take a blow as if they weighed more, and nothing else moves.
TEST(PlanModes, FewOfThemAreAllThatMoves) {
  const Plan given = shifted_storeys();
  const PlanModel model = plan_model(told_by_modes(given, 2));
  const PlanBuilding few = make_plan_building("A", model, ModalDamping{{0.05}});
  const PlanBuilding all = make_plan_building("A", plan_model(given), ModalDamping{{0.05}});
  ASSERT_EQ(few.modes.omega.size(), 2);
  EXPECT_LE((few.modes.shapes - all.modes.shapes.leftCols(2)).norm(), 1e-12 * all.modes.shapes.norm());
  const Eigen::VectorXd shares = model.mass.diagonal().cwiseProduct(few.modes.shapes.rowwise().squaredNorm());
  for (Eigen::Index i = 0; i < shares.size(); ++i) EXPECT_NEAR(model.known->mass_shares[i], shares(i), 1e-14);
  EXPECT_LT(shares.sum(), 2 + 1e-12);
}

TEST(PlanModes, StandAsTheyAreGiven) {
  const Plan known = told_by_modes(shifted_storeys(), 3);
  const auto refused = [](const Plan& plan) { EXPECT_THROW((void)plan_model(plan), InvalidParameter); };
  Plan loaded = known;
  loaded.gravity_loads = {1177, 883};
  refused(loaded);
  refused(with_masses_moved(known, {0.05, 0}));
  Plan held = known;
  held.rigidity = shifted_storeys().rigidity;
  held.planes = shifted_storeys().planes;
  refused(held);
  Plan short_one = known;
  short_one.modes->shapes[1].pop_back();
  refused(short_one);
  Plan oblique = known;
  oblique.modes->shapes[1] = oblique.modes->shapes[0];
  refused(oblique);
}

}  // namespace
}  // namespace bentur
