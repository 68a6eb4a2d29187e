#include "bentur/pounding/plan/plan_pounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/restitution_relations.h"
#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Eigen::Vector3d;
using LawOf = std::function<std::shared_ptr<const ContactLaw>(double share)>;

TEST(Faces, FaceAlongOneStretchAtMost) {
  const Footprint a{.corner = {0, 0}, .size = {12, 18}};
  const Footprint b{.corner = {12.03, 4}, .size = {15, 20}};
  auto stretch = facing(a, b);
  ASSERT_TRUE(stretch);
  EXPECT_FALSE(stretch->swapped);
  EXPECT_EQ(stretch->across, 0);
  EXPECT_EQ(stretch->from, 4);
  EXPECT_EQ(stretch->to, 18);
  EXPECT_DOUBLE_EQ(stretch->width, 12.03 - 12);
  EXPECT_TRUE(stretch->middle(4).isApprox(PlanPoint(12.015, 4)));
  stretch = facing(b, a);
  ASSERT_TRUE(stretch);
  EXPECT_TRUE(stretch->swapped);
  EXPECT_DOUBLE_EQ(stretch->width, 12.03 - 12);
  // One above the other.
  stretch = facing(a, {.corner = {5, 18.2}, .size = {20, 1}});
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->across, 1);
  EXPECT_EQ(stretch->from, 5);
  EXPECT_EQ(stretch->to, 12);
  EXPECT_NEAR(stretch->width, 0.2, 1e-15);
  // Corner to corner, and by round-off more.
  EXPECT_FALSE(facing(a, {.corner = {12, 18}, .size = {5, 5}}));
  EXPECT_FALSE(facing(a, {.corner = {12, 18 - 1e-9}, .size = {5, 5}}));
  EXPECT_FALSE(facing(a, {.corner = {13, 19}, .size = {5, 5}}));
  // Edges that touch but for round-off have no width, on either side of it.
  for (const double by : {-1e-9, 0.0, 1e-9}) {
    stretch = facing(a, {.corner = {12 + by, 0}, .size = {5, 5}});
    ASSERT_TRUE(stretch) << by;
    EXPECT_EQ(stretch->width, 0) << by;
  }
  EXPECT_TRUE(overlap(a, {.corner = {11.9, 17.9}, .size = {5, 5}}));
  EXPECT_FALSE(facing(a, {.corner = {11.9, 17.9}, .size = {5, 5}}));
  EXPECT_TRUE(overlap(a, {.corner = {1, 1}, .size = {2, 2}}));
  EXPECT_FALSE(overlap(a, b));
}

TEST(Faces, SharesResistRotationAsAnEvenBedDoesInTheEnd) {
  Stretch stretch{.from = -3, .to = 4};
  for (const int n : {2, 3, 5, 50}) {
    const std::vector<StretchPoint> points = points_of(stretch, n);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(points.front().along, -3);
    EXPECT_EQ(points.back().along, 4);
    double sum = 0, about_middle = 0;
    for (const StretchPoint& point : points) {
      sum += point.share;
      about_middle += point.share * (point.along - 0.5) * (point.along - 0.5);
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_NEAR(about_middle, 49.0 / 12 * (1 + 2.0 / ((n - 1) * (n - 1))), 1e-13) << n;  // (P-8)
  }
}

/// Space-targets 2: a rectangle that nothing holds beside a wall.
PlanProblem free_rectangle(const LawOf& law, const Vector3d& velocity, int points = 2) {
  Plan plan{.footprint = {.corner = {0, 0}, .size = {8, 12}}, .storey_heights = {3}, .masses = {50}};
  plan.rigidity = PlanRigidity{.centres = {{4, 6}}, .x = {1e-9}, .y = {1e-9}, .torsion = {1e-9}};
  PlanProblem problem;
  problem.buildings = {make_plan_building("A", plan_model(plan), ModalDamping{{0.0}}),
                       rigid_plan_building("W", {.corner = {8, -3}, .size = {1, 8}}, {3})};
  PlanGap gap{.left = 0,
              .right = 1,
              .stretch = *facing(problem.buildings[0].model.footprint, problem.buildings[1].model.footprint)};
  for (const StretchPoint& point : points_of(gap.stretch, points)) {
    gap.contacts.push_back({.elevation = 3, .along = point.along, .law = law(point.share)});
  }
  problem.gaps = {gap};
  problem.initial_velocity = {velocity, Vector3d::Zero()};
  problem.duration = 0.05;  // in which the springs of what is free do nothing, 1e-9 * 0.05 * 0.05 / 50
  return problem;
}

/// Impacts, and the velocities (v_x, v_y, ω) that are left.
struct After {
  Solution solution;
  Vector3d velocity;
};

After after(const PlanProblem& problem, const Solver& solver = ExactSolver{}) {
  System system = system_of(problem);
  system.bodies[0].outputs.push_back({.count = 3, .rates = Eigen::Matrix3d::Identity()});
  const FreeSolution free(system, solver);
  Solution solution = free.solve(system.contacts, {.output_step = problem.duration});
  EXPECT_EQ(solution.status, Status::done) << solution.message;
  const Vector3d velocity = solution.outputs[0].back().history.rightCols(1);
  return {std::move(solution), velocity};
}

constexpr double m_e = 50, stiffness = 4e5, m_p = 16.25;

TEST(PlanContact, CornerOnAWallKeepsTheRestitutionThatDoesNotDependOnTheMass) {
  // (P-17): P = (1 + e) m_p v_n, Δv = −P n/m, Δω = P y/J with the arm y = −6.
  const double j = 50 * (64 + 144) / 12.0, v_n = 0.8, d = exact_damping_factor(0.6);
  const auto kelvin = [](double e) -> LawOf {
    // ξ of the corner alone, on its stretch: c = 4 ξ √(k/2 m_p).
    const double xi = exact_separation_damping_ratio(e);
    return [xi](double share) {
      const double c_share = 4 * xi * std::sqrt(stiffness / 2 * m_p) * share;
      const double m = share * m_e, k = share * stiffness;
      return std::make_shared<KelvinVoigt>(k, c_share / (2 * std::sqrt(k * m)), m, KelvinVoigt::Release::separation);
    };
  };
  struct Case {
    double e;
    LawOf law;
    double tolerance;
  };
  const std::vector<Case> cases = {
      {1.0, [](double s) { return std::make_shared<Linear>(s * stiffness); }, 1e-12},
      {0.6, [](double) { return std::make_shared<Restitution>(0.6); }, 1e-12},
      {0.35, [](double) { return std::make_shared<Restitution>(0.35); }, 1e-12},
      {0.6, [&](double s) { return std::make_shared<HertzDamp>(s * 3e6, d); }, 1e-9},
      {0.6, [&](double s) { return std::make_shared<Darmawan>(s * stiffness, d / v_n); }, 1e-9},
      {0.55, kelvin(0.55), 1e-12},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const auto& [e, law, tolerance] = cases[i];
    const double p = (1 + e) * m_p * v_n;
    const After found = after(free_rectangle(law, {-1.6, 0.3, 0.4}));
    ASSERT_EQ(found.solution.impacts.size(), 1U);
    EXPECT_EQ(found.solution.impacts[0].point, 0);
    EXPECT_NEAR(found.solution.impacts[0].impulse, p, tolerance * p);
    EXPECT_NEAR(found.velocity(0), -1.6 - p / 50, 26 / 50.0 * tolerance);
    EXPECT_NEAR(found.velocity(1), 0.3, tolerance);
    EXPECT_NEAR(found.velocity(2), 0.4 + p * -6 / j, 26 * 6 / j * tolerance);
  }
}

TEST(PlanContact, BothPointsOfAWallAtOnce) {
  // (E-1) with the rows of (P-6): the one at y = 5 does all of it.
  const auto law = [](double) { return std::make_shared<Restitution>(0.6); };
  const After found = after(free_rectangle(law, {0.8, 0.3, 0}));
  ASSERT_EQ(found.solution.impacts.size(), 1U);  // of none at y = 0
  EXPECT_EQ(found.solution.impacts[0].point, 1);
  EXPECT_NEAR(found.solution.impacts[0].impulse, 60.509090909091, 1e-11);
}

TEST(PlanContact, WhatStrikesMoreThanCanTellItApartStrikesAllOfItAlike) {
  // Two walls in line: four points along one edge, whose impulses are those of two (E-1). Of least norm they are equal.
  for (const bool lower_first : {true, false}) {
    PlanProblem problem = free_rectangle([](double) { return std::make_shared<Restitution>(0.6); }, {0.8, 0.3, 0});
    problem.buildings.resize(1);
    problem.gaps.clear();
    for (const bool lower : {lower_first, !lower_first}) {
      const Eigen::Index wall = std::ssize(problem.buildings);
      problem.buildings.push_back(rigid_plan_building("W", {.corner = {8, lower ? -1.0 : 6.0}, .size = {1, 7}}, {3}));
      PlanGap gap{.left = 0,
                  .right = wall,
                  .stretch = *facing(problem.buildings[0].model.footprint, problem.buildings[wall].model.footprint)};
      for (const StretchPoint& point : points_of(gap.stretch, 2)) {
        gap.contacts.push_back({.elevation = 3, .along = point.along, .law = std::make_shared<Restitution>(0.6)});
      }
      problem.gaps.push_back(gap);
    }
    problem.initial_velocity.resize(3, Vector3d::Zero());
    const After found = after(problem);
    ASSERT_EQ(found.solution.impacts.size(), 4U);
    for (const Impact& impact : found.solution.impacts) EXPECT_NEAR(impact.impulse, 1.6 * 50 * 0.8 / 4, 1e-12);
    EXPECT_TRUE(found.velocity.isApprox(Vector3d(-0.6 * 0.8, 0.3, 0), 1e-12)) << found.velocity;
  }
}

TEST(PlanContact, RestitutionGivenByDampingRatioIsHigherAtACorner) {
  // (P-10): ξ_p = ξ √(σ m_e/m_p), e of that.
  const double xi = 0.2, v_n = 0.8, j = 50 * (64 + 144) / 12.0;
  const auto obtained = [&](const LawOf& law) {
    const Vector3d velocity = after(free_rectangle(law, {-1.6, 0.3, 0.4})).velocity;
    EXPECT_NEAR((velocity(2) - 0.4) / (velocity(0) + 1.6), 6 * 50 / j, 1e-12);  // one impulse at the corner
    return -(velocity(0) + 6 * velocity(2)) / v_n;
  };
  const double found = obtained([&](double s) {
    return std::make_shared<KelvinVoigt>(s * stiffness, xi, s * m_e, KelvinVoigt::Release::zero_force);
  });
  EXPECT_NEAR(found, 0.50860135752094, 1e-11);
  EXPECT_NEAR(found, zero_force_restitution(xi * std::sqrt(0.5 * m_e / m_p)), 1e-11);
  const double approach =
      obtained([&](double s) { return std::make_shared<KelvinVoigtApproach>(s * stiffness, xi, s * m_e); });
  EXPECT_NEAR(approach, 0.71316292494839, 1e-11);
}

/// Three storeys and two, not symmetric.
std::vector<Plan> eccentric_plans() {
  const auto plane = [](double at, bool along_x, std::vector<double> k) {
    return PlanPlane{.name = "",
                     .through = along_x ? PlanPoint(0, at) : PlanPoint(at, 0),
                     .direction = along_x ? PlanPoint::UnitX() : PlanPoint::UnitY(),
                     .storeys = {.storey_heights = {}, .masses = {}, .stiffnesses = std::move(k)}};
  };
  const Plan tall{.footprint = {.corner = {0, 0}, .size = {10, 14}},
                  .storey_heights = {3.2, 3.0, 3.0},
                  .masses = {60, 60, 50},
                  .centres_of_mass = {{5.2, 6.6}},
                  .planes = {plane(1, true, {30e3, 27e3, 22e3}), plane(13, true, {20e3, 18e3, 15e3}),
                             plane(0.5, false, {20e3, 20e3, 15e3}), plane(9.5, false, {25e3, 20e3, 15e3})}};
  const Plan low{.footprint = {.corner = {10.005, 3}, .size = {9, 15}},
                 .storey_heights = {3.2, 3.0},
                 .masses = {40, 35},
                 .planes = {plane(2, true, {35e3, 30e3}), plane(12, true, {50e3, 40e3}), plane(4, false, {5e4, 4e4})}};
  return {tall, low};
}

PlanProblem pair_of(const std::vector<Plan>& plans, int points, const LawOf& law) {
  PlanProblem problem;
  problem.buildings = {make_plan_building("Tall", plan_model(plans[0]), ModalDamping{{0.03}}),
                       make_plan_building("Low", plan_model(plans[1]), ModalDamping{{0.03}})};
  PlanGap gap{.left = 0, .right = 1, .stretch = *facing(plans[0].footprint, plans[1].footprint)};
  if (gap.stretch.swapped) std::swap(gap.left, gap.right);
  for (const Eigen::Index floor : {0, 1}) {
    for (const StretchPoint& point : points_of(gap.stretch, points)) {
      gap.contacts.push_back(
          {floor, floor, problem.buildings[0].model.elevations[floor], point.along, law(point.share)});
    }
  }
  problem.gaps = {gap};
  problem.motions[0] = HarmonicMotion{.period = 0.45, .displacement_amplitude = 0.01};
  problem.duration = 3;
  return problem;
}

PlanProblem eccentric_pair(int points, const LawOf& law) { return pair_of(eccentric_plans(), points, law); }

TEST(PlanContact, OfFivePointsNoInnerOneIsDeeperThanTheEnds) {
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  const PlanResponse five = solve(eccentric_pair(5, law));
  ASSERT_EQ(five.status, Status::done) << five.message;
  ASSERT_EQ(five.points.size(), 10U);
  int impacts = 0;
  for (const std::size_t level : {0U, 5U}) {
    const double ends = std::max(five.points[level].peak_penetration, five.points[level + 4].peak_penetration);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_LE(five.points[level + i].peak_penetration, ends * (1 + 1e-12));
      impacts += five.points[level + i].impacts;
    }
  }
  EXPECT_GT(impacts, 10);
}

TEST(PlanContact, TheExactSolverAndTheAdaptiveOneAgree) {
  for (const LawOf& law : std::vector<LawOf>{
           [](double s) { return std::make_shared<Linear>(s * 2e5); },
           [](double s) { return std::make_shared<Bilinear>(s * 2e5, s * 1e5, 1e-3); },
           [](double s) {
             return std::make_shared<KelvinVoigt>(s * 2e5, 0.2, s * 24, KelvinVoigt::Release::zero_force);
           }}) {
    const PlanProblem problem = eccentric_pair(2, law);
    const PlanResponse exact = solve(problem, ExactSolver{}, {.energy_audit = true});
    const PlanResponse other = solve(problem, AdaptiveSolver{.tolerance = 1e-12});
    ASSERT_EQ(exact.status, Status::done) << exact.message;
    ASSERT_EQ(other.status, Status::done) << other.message;
    EXPECT_TRUE(exact.discrepancies.empty());
    EXPECT_LE(exact.energy->relative_residual(), 1e-12);
    for (std::size_t i = 0; i < exact.points.size(); ++i) {
      EXPECT_EQ(exact.points[i].impacts, other.points[i].impacts) << i;
      EXPECT_NEAR(exact.points[i].impulse, other.points[i].impulse, 1e-8 * (1 + exact.points[i].impulse));
      EXPECT_NEAR(exact.points[i].peak_force, other.points[i].peak_force, 1e-8 * (1 + exact.points[i].peak_force));
    }
    EXPECT_GT(exact.impacts.size(), 6U);
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_TRUE(exact.buildings[b].rotation.isApprox(other.buildings[b].rotation, 1e-8));
      EXPECT_TRUE(exact.buildings[b].torque.isApprox(other.buildings[b].torque, 1e-8));
      EXPECT_TRUE(exact.buildings[b].north.isApprox(other.buildings[b].north, 1e-8));
    }
  }
}

TEST(PlanContact, APlanesYieldForcesOutOfReachChangeNothing) {
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  PlanProblem problem = eccentric_pair(2, law);
  const PlanResponse elastic = solve(problem);
  PlanModel& model = problem.buildings[0].model;
  Stick storeys;
  for (Eigen::Index j = 0; j < 3; ++j) {
    storeys.stiffnesses.push_back(model.planes[0].shears.row(j).norm() / model.planes[0].drifts.row(j).norm());
  }
  storeys.yield_forces = {1e9};
  for (std::size_t j = 0; j < 3; ++j) model.planes[0].laws[j] = storey_law(storeys, j, storeys.stiffnesses[j]);
  const PlanResponse far = solve(problem);
  ASSERT_EQ(far.status, Status::done) << far.message;
  EXPECT_TRUE(far.buildings[0].rotation.isApprox(elastic.buildings[0].rotation, 1e-10));
  EXPECT_TRUE(far.buildings[0].planes[0].shear.isApprox(elastic.buildings[0].planes[0].shear, 1e-10));
  EXPECT_TRUE(far.buildings[0].shear_x.isApprox(elastic.buildings[0].shear_x, 1e-10));
  EXPECT_EQ(far.buildings[0].planes[0].yielding.hysteretic_energy.maxCoeff(), 0);
  // Within reach they do, and what is lost is told.
  storeys.yield_forces = {100};
  for (std::size_t j = 0; j < 3; ++j) model.planes[0].laws[j] = storey_law(storeys, j, storeys.stiffnesses[j]);
  const PlanResponse yields = solve(problem, ExactSolver{}, {.energy_audit = true});
  ASSERT_EQ(yields.status, Status::done) << yields.message;
  EXPECT_LE(yields.energy->relative_residual(), 1e-12);
  const BuildingPeaks::Yielding& found = yields.buildings[0].planes[0].yielding;
  EXPECT_GT(found.ductility.maxCoeff(), 1.5);
  EXPECT_GT(found.hysteretic_energy.maxCoeff(), 1);
  EXPECT_LE(yields.buildings[0].planes[0].shear.maxCoeff(), 100 * (1 + 1e-12));
  EXPECT_EQ(yields.buildings[0].planes[1].yielding.ductility.size(), 0);
}

TEST(PlanContact, TheOrderOfTheBuildingsChangesNothing) {
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  const PlanProblem problem = eccentric_pair(2, law);
  PlanProblem other = problem;
  std::swap(other.buildings[0], other.buildings[1]);
  std::swap(other.gaps[0].left, other.gaps[0].right);  // L is the second now
  const PlanResponse one = solve(problem), same = solve(other);
  ASSERT_EQ(same.status, Status::done) << same.message;
  ASSERT_EQ(one.impacts.size(), same.impacts.size());
  EXPECT_GT(one.impacts.size(), 6U);
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_NEAR(one.points[i].impulse, same.points[i].impulse, 1e-10 * one.points[i].impulse);
    EXPECT_NEAR(one.points[i].gap_needed, same.points[i].gap_needed, 1e-12);
  }
  EXPECT_TRUE(one.buildings[0].rotation.isApprox(same.buildings[1].rotation, 1e-10));
}

/// A plan under a map of the common plan that takes rectangles to rectangles.
Plan under(const Eigen::Matrix2d& map, const Plan& plan) {
  Plan made = plan;
  const Footprint& from = plan.footprint;
  made.footprint.size = map.cwiseAbs() * from.size;
  made.footprint.corner = (map * from.corner).cwiseMin(map * from.far_corner());
  const auto local = [&](const PlanPoint& at) -> PlanPoint { return map * (from.corner + at) - made.footprint.corner; };
  for (PlanPoint& centre : made.centres_of_mass) centre = local(centre);
  for (PlanPlane& plane : made.planes) {
    plane.through = local(plane.through);
    plane.direction = map * plane.direction;
  }
  return made;
}

TEST(PlanContact, MirroredAndTurnedPlansDoTheSame) {
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  PlanProblem straight = eccentric_pair(2, law);
  straight.motions[1] = HarmonicMotion{.period = 0.37, .displacement_amplitude = 0.007};
  const PlanResponse wanted = solve(straight);
  ASSERT_EQ(wanted.status, Status::done) << wanted.message;
  EXPECT_GT(wanted.impacts.size(), 6U);
  Eigen::Matrix2d quarter, mirror_x, mirror_y;
  quarter << 0, -1, 1, 0;
  mirror_x << -1, 0, 0, 1;
  mirror_y << 1, 0, 0, -1;
  for (const Eigen::Matrix2d& map : std::vector<Eigen::Matrix2d>{quarter, quarter * quarter, quarter.transpose(),
                                                                 mirror_x, mirror_y, quarter * mirror_x}) {
    std::vector<Plan> plans;
    for (const Plan& plan : eccentric_plans()) plans.push_back(under(map, plan));
    PlanProblem turned = pair_of(plans, 2, law);
    turned.motions = straight.motions;
    turned.axes = map;  // what acted along x acts along the map of x
    const PlanResponse found = solve(turned);
    ASSERT_EQ(found.status, Status::done) << found.message;
    ASSERT_EQ(found.impacts.size(), wanted.impacts.size()) << map;
    const bool swaps = map(0, 0) == 0;
    for (std::size_t b = 0; b < 2; ++b) {
      const PlanPeaks &one = found.buildings[b], &other = wanted.buildings[b];
      EXPECT_TRUE((swaps ? one.y : one.x).isApprox(other.x, 1e-10)) << map;
      EXPECT_TRUE((swaps ? one.x : one.y).isApprox(other.y, 1e-10)) << map;
      EXPECT_TRUE(one.rotation.isApprox(other.rotation, 1e-10)) << map;
      EXPECT_TRUE(one.torque.isApprox(other.torque, 1e-10)) << map;
      EXPECT_TRUE(one.angular_acceleration.isApprox(other.angular_acceleration, 1e-10)) << map;
      EXPECT_TRUE((swaps ? one.acceleration_y : one.acceleration_x).isApprox(other.acceleration_x, 1e-10)) << map;
      EXPECT_TRUE(one.planes[1].shear.isApprox(other.planes[1].shear, 1e-10)) << map;
    }
    double impulse = 0, same = 0;
    for (const Impact& impact : found.impacts) impulse += impact.impulse;
    for (const Impact& impact : wanted.impacts) same += impact.impulse;
    EXPECT_NEAR(impulse, same, 1e-10 * same);
  }
}

TEST(PlanContact, MotionsActAlongTheirAxes) {
  // a_x = a₁ cos α − a₂ sin α, a_y = a₁ sin α + a₂ cos α (P-3); α = 90°.
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  const HarmonicMotion one{.period = 0.45, .displacement_amplitude = 0.01};
  HarmonicMotion other{.period = 0.45, .displacement_amplitude = 0.006, .phase = HarmonicMotion::Phase::cosine};
  PlanProblem turned = eccentric_pair(2, law);
  turned.buildings.push_back(rigid_plan_building("W", {.corner = {40, 0}, .size = {1, 1}}, {3}));
  for (const Kinematics kinematics : {Kinematics::relative, Kinematics::absolute}) {
    turned.kinematics = kinematics;
    turned.delays = {0, 0.02, 0};
    turned.motions = {one, other};
    turned.axes << 0, -1, 1, 0;
    const PlanResponse found = solve(turned, ExactSolver{}, {.energy_audit = true});
    ASSERT_EQ(found.status, Status::done) << found.message;
    EXPECT_LE(found.energy->relative_residual(), 1e-12);
    PlanProblem straight = turned;
    straight.axes = Eigen::Matrix2d::Identity();
    other.displacement_amplitude *= -1;
    straight.motions = {other, one};
    other.displacement_amplitude *= -1;
    const PlanResponse same = solve(straight);
    EXPECT_GT(found.impacts.size(), 4U);
    ASSERT_EQ(found.impacts.size(), same.impacts.size());
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_TRUE(found.buildings[b].rotation.isApprox(same.buildings[b].rotation, 1e-10));
      EXPECT_TRUE(found.buildings[b].acceleration_y.isApprox(same.buildings[b].acceleration_y, 1e-10));
      EXPECT_TRUE(found.buildings[b].angular_acceleration.isApprox(same.buildings[b].angular_acceleration, 1e-10));
    }
    // A wall has the ground's acceleration, and turns with nothing.
    const PlanPeaks& wall = found.buildings[2];
    EXPECT_NEAR(wall.acceleration_x(0), peak_acceleration(other), 1e-9 * peak_acceleration(other));
    EXPECT_NEAR(wall.acceleration_y(0), peak_acceleration(one), 1e-9 * peak_acceleration(one));
    EXPECT_EQ(wall.angular_acceleration(0), 0);
    EXPECT_EQ(wall.shear_x.size(), 0);
  }
}

TEST(PlanProblem, RefusesWhatDoesNotGoTogether) {
  const auto law = [](double s) { return std::make_shared<Linear>(s * 2e5); };
  const auto refused = [&](const auto& spoil) {
    PlanProblem problem = eccentric_pair(2, law);
    spoil(problem);
    try {
      validate(problem);
    } catch (const InvalidParameter& error) {
      return error.parameter();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused([](PlanProblem&) {}), "nothing");
  EXPECT_EQ(refused([](PlanProblem& p) { p.duration = 0; }), "duration");
  EXPECT_EQ(refused([](PlanProblem& p) { p.delays = {1}; }), "delays");
  EXPECT_EQ(refused([](PlanProblem& p) { p.gaps[0].right = 0; }), "gaps");
  EXPECT_EQ(refused([](PlanProblem& p) { p.gaps[0].contacts[0].left_floor = 3; }), "gaps");
  EXPECT_EQ(refused([](PlanProblem& p) { p.gaps[0].contacts[0].law = nullptr; }), "gaps");
  EXPECT_EQ(refused([](PlanProblem& p) { p.initial_velocity = {Vector3d::Zero()}; }), "initial_velocity");
  EXPECT_EQ(refused([](PlanProblem& p) { p.motions[1] = SampledMotion{.time_step = 0, .acceleration = {1}}; }),
            "motions");
  // Inside one another at the start there is no force to part them.
  const auto hard = [](double) { return std::make_shared<Restitution>(0.5); };
  PlanProblem start = free_rectangle(hard, {0, 0, 0});
  start.initial_displacement = {Vector3d(0.001, 0, 0), Vector3d::Zero()};
  EXPECT_THROW(validate(start), InvalidParameter);
  start.initial_displacement = {Vector3d(-0.001, 0, 0), Vector3d::Zero()};
  EXPECT_NO_THROW(validate(start));
}

}  // namespace
}  // namespace bentur
