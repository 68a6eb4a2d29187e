// Footprints that are polygons: corners before edges, a closed form, and random pairs of them, with friction: `exact`
// against `adaptive`, the energy, and the whole turned by any angle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur::polygon_plans {
namespace {

using Eigen::Index;

Eigen::Matrix2d turn_by(double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return turn;
}

std::vector<PlanPoint> rectangle(double a, double b) { return {{0, 0}, {a, 0}, {a, b}, {0, b}}; }

TEST(PolygonFaces, WhatOverlapsIsCutBackToTheOther) {
  const Footprint kept = polygon_footprint({0, 0}, {{0, 0}, {10, 0}, {10.06, 4}, {10, 8}, {0, 8}});
  // Its own edge is the way out: it goes to where the corner of the other ends.
  const auto cut = cut_back(polygon_footprint({10, 1}, {{0, 0}, {8, 0}, {8, 6}, {0, 6}}), kept);
  ASSERT_TRUE(cut);
  const std::vector<PlanPoint> expected = {{0.06, 6}, {0.06, 0}, {8, 0}, {8, 6}};
  ASSERT_EQ(cut->polygon.size(), 4U);
  for (const PlanPoint& at : expected) {
    EXPECT_TRUE(std::any_of(cut->polygon.begin(), cut->polygon.end(),
                            [&](const PlanPoint& one) { return (one - at).norm() < 1e-12; }));
  }
  EXPECT_FALSE(overlap(*cut, kept));
  EXPECT_NEAR(facing(kept, *cut)->width, 0, 1e-12);
  // A corner that is in the other's edge goes; what is apart stays, and of what is in the other nothing is left.
  const auto blunt =
      cut_back(polygon_footprint({0, 0}, {{9.9, -1}, {12, -4}, {14, 1}}), {.corner = {0, -9}, .size = {10, 9}});
  ASSERT_TRUE(blunt);
  EXPECT_EQ(blunt->polygon.size(), 4U);
  EXPECT_NEAR(blunt->lower().x(), 10, 1e-12);
  EXPECT_EQ(cut_back(*cut, kept)->polygon, cut->polygon);
  EXPECT_FALSE(cut_back({.corner = {2, 2}, .size = {1, 1}}, kept));
}

TEST(PolygonFaces, ACornerStandsBeforeTheEdgeOfAWall) {
  // A square on its corner, 0.05 from a wall on its right.
  const double half = 5 * std::sqrt(2.0);
  const Footprint square = polygon_footprint({0, 0}, {{-half, 0}, {0, -half}, {half, 0}, {0, half}});
  const Footprint wall{.corner = {half + 0.05, -20}, .size = {1, 40}};
  const auto stretch = facing(square, wall);
  ASSERT_TRUE(stretch);
  EXPECT_FALSE(stretch->swapped);
  EXPECT_FALSE(stretch->is_parallel());
  EXPECT_NEAR(stretch->width, 0.05, 1e-14);
  ASSERT_EQ(stretch->corners.size(), 3U);
  for (const StretchCorner& corner : stretch->corners) EXPECT_EQ(corner.normal, PlanPoint(1, 0));
  EXPECT_TRUE(stretch->corners[1].left.isApprox(PlanPoint(half, 0)));
  EXPECT_NEAR(stretch->width_at(stretch->to), 0.05 + half, 1e-13);
  EXPECT_NEAR(stretch->corners[1].room, 20, 1e-13);
  const std::vector<StretchPoint> points = points_of(*stretch, 3);
  ASSERT_EQ(points.size(), 5U);  // a point in the middle of each piece
  double sum = 0;
  for (const StretchPoint& point : points) sum += point.share;
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_NEAR(points[2].share, 0.5, 1e-15);  // (P-7): the corner, and as much of all others
  EXPECT_NEAR(stretch->width_at(points[1].along), 0.05 + half / 2, 1e-13);
}

TEST(PolygonFaces, EachCornerTakesTheNormalOfTheEdgeBeforeIt) {
  // B leans by 0.2 against the right edge of A: one corner of each stands before an edge of the other.
  const Footprint a{.corner = {0, 0}, .size = {10, 12}};
  std::vector<PlanPoint> corners = rectangle(8, 20);
  for (PlanPoint& at : corners) at = turn_by(0.2) * at;
  const Footprint b = polygon_footprint({14.1, -3}, corners);
  const auto stretch = facing(a, b);
  ASSERT_TRUE(stretch);
  ASSERT_GE(stretch->corners.size(), 2U);
  const PlanPoint edge = turn_by(0.2) * PlanPoint(1, 0);
  bool leans = false;
  for (const StretchCorner& corner : stretch->corners) {
    EXPECT_NEAR((corner.right - corner.left).norm(), corner.normal.dot(corner.right - corner.left), 1e-12);
    EXPECT_NEAR((corner.right - corner.left).norm(), stretch->width + corner.beyond, 1e-12);
    leans = leans || corner.normal.isApprox(edge);
  }
  EXPECT_TRUE(leans);
  EXPECT_TRUE(stretch->n.isApprox(edge));
}

TEST(PolygonFaces, OverlapHasADepthAndAnArea) {
  const Footprint a{.corner = {0, 0}, .size = {10, 10}};
  const Footprint b = polygon_footprint({9, 5}, {{0, 0}, {5, -5}, {5, 5}});  // its tip is 1 inside
  EXPECT_TRUE(overlap(a, b));
  EXPECT_NEAR(overlap_depth(a, b), 1, 1e-14);
  EXPECT_NEAR(common_area(a, b), 1, 1e-14);
  EXPECT_FALSE(facing(a, b));
  const Footprint apart = polygon_footprint({10, 5}, {{0, 0}, {5, -5}, {5, 5}});
  EXPECT_FALSE(overlap(a, apart));
  ASSERT_TRUE(facing(a, apart));
  EXPECT_EQ(facing(a, apart)->width, 0);
  EXPECT_FALSE(facing(a, polygon_footprint({10.1, 10.1}, rectangle(3, 3))));  // corner to corner
}

/// A free body before a wall, contacts of a linear law.
PlanProblem free_before_wall(const Footprint& body, const Footprint& wall, const Eigen::Vector3d& velocity) {
  Plan plan{.footprint = body, .storey_heights = {3}, .masses = {50}};
  plan.rigidity = PlanRigidity{.centres = {body.middle()}, .x = {1e-9}, .y = {1e-9}, .torsion = {1e-9}};
  PlanProblem problem;
  problem.buildings = {make_plan_building("A", plan_model(plan), ModalDamping{{0.0}}),
                       rigid_plan_building("W", wall, {3})};
  const auto stretch = facing(body, wall);
  PlanGap gap{.left = stretch->swapped ? 1 : 0, .right = stretch->swapped ? 0 : 1, .stretch = *stretch};
  for (const StretchPoint& point : points_of(gap.stretch, 2)) {
    gap.contacts.push_back({.elevation = 3, .along = point.along, .law = std::make_shared<Linear>(point.share * 4e5)});
  }
  problem.gaps = {gap};
  problem.initial_velocity = {velocity, Eigen::Vector3d::Zero()};
  problem.duration = 0.1;
  return problem;
}

/// (P-17) of a corner before an oblique wall: P = 2 m_p v_n, 1/m_p = 1/m + (r × n)²/J.
TEST(PolygonContact, ACornerOnAnObliqueWall) {
  std::vector<PlanPoint> corners = {{0, 0}, {6, -2}, {9, 3}, {2, 5}};
  const Footprint body = polygon_footprint({0, 0}, corners);
  const double slope = 0.4, v = 0.8;
  const PlanPoint n = turn_by(slope) * PlanPoint(1, 0);
  const PlanPoint corner(9, 3);  // the furthest along n
  for (const PlanPoint& at : corners) ASSERT_LE(n.dot(at), n.dot(corner));
  std::vector<PlanPoint> wall = rectangle(1, 40);
  for (PlanPoint& at : wall) at = turn_by(slope) * (at - PlanPoint(0, 20));
  const PlanPoint stands = corner + 0.01 * n;
  const PlanProblem problem =
      free_before_wall(body, polygon_footprint(stands, wall), Eigen::Vector3d(v, 0.3 * v, 0.02));
  const PlanResponse response = solve(problem, ExactSolver{}, {.energy_audit = true});
  ASSERT_EQ(response.status, Status::done) << response.message;
  ASSERT_EQ(response.impacts.size(), 1U);
  EXPECT_LE(response.energy->relative_residual(), 1e-12);
  const double m = 50, j = m * body.radius2();
  const PlanPoint r = corner - body.middle();
  const double arm = r.x() * n.y() - r.y() * n.x(), m_p = 1 / (1 / m + arm * arm / j);
  const double v_n = n.dot(PlanPoint(v, 0.3 * v)) + 0.02 * arm;
  const double impulse = 2 * m_p * v_n;
  EXPECT_NEAR(response.impacts[0].impulse / impulse, 1, 1e-11);
  EXPECT_NEAR(response.impacts[0].start, 0.01 / v_n, 1e-12);
}

struct Draw {
  std::vector<Plan> plans;
  double stiffness = 0, friction = 0, clearance = 0.021;
  std::array<GroundMotion, 2> motions;
  double angle = 0;
  int points = 2;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}

  /// @param rectangles parallel to the axes, in place of polygons
  Draw make(bool rectangles) {
    Draw draw;
    draw.plans = {building({0, 0}, rectangles), building({25, any(-3, 3)}, rectangles)};
    Footprint &one = draw.plans[0].footprint, &other = draw.plans[1].footprint;
    const double gap = any(0.002, 0.02);
    for (int i = 0; i < 60; ++i) other.corner.x() += gap + overlap_depth(one, other);  // comes near along x
    draw.stiffness = std::pow(10, any(4.8, 6));
    draw.friction = any(0.1, 0.7);
    draw.points = rectangles ? 3 : 2;
    for (GroundMotion& motion : draw.motions) {
      motion = HarmonicMotion{.period = any(0.25, 0.8), .displacement_amplitude = any(0.01, 0.03)};
    }
    draw.angle = any(0, 6);
    return draw;
  }

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

  Plan building(const PlanPoint& corner, bool is_rectangle) {
    std::vector<PlanPoint> corners;
    const double a = any(10, 16), b = any(10, 16);
    if (is_rectangle) {
      corners = rectangle(a, b);
    } else {
      const int count = 3 + static_cast<int>(any(0, 3.99));
      const double first = any(0, 6);
      for (int i = 0; i < count; ++i) {
        const double at = first + 2 * std::numbers::pi * (i + any(-0.3, 0.3)) / count;
        corners.emplace_back(0.5 * a * std::cos(at), 0.5 * b * std::sin(at));
      }
    }
    Plan plan{.footprint = polygon_footprint(corner, corners),
              .storey_heights = {3.2, 3.0},
              .masses = {any(80, 300), any(80, 300)}};
    const auto plane = [&](const PlanPoint& through, double angle) -> PlanPlane {
      return {.name = "",
              .through = through,
              .direction = {std::cos(angle), std::sin(angle)},
              .storeys = {.storey_heights = {}, .masses = {}, .stiffnesses = {any(2e4, 8e4), any(2e4, 8e4)}}};
    };
    const PlanPoint middle = plan.footprint.middle();
    plan.planes = {plane(middle + PlanPoint(0, any(-6, -2)), any(-0.2, 0.2)),
                   plane(middle + PlanPoint(0, any(2, 6)), 0), plane(middle + PlanPoint(any(-3, 3), 0), any(1.2, 1.9))};
    return plan;
  }

  std::mt19937 engine_;
};

PlanProblem problem_of(const Draw& draw, const Eigen::Matrix2d& turn = Eigen::Matrix2d::Identity(),
                       double stiffer = 1) {
  PlanProblem problem;
  std::vector<Plan> plans = draw.plans;
  for (Plan& plan : plans) {
    plan.footprint.corner = turn * plan.footprint.corner;
    for (PlanPoint& at : plan.footprint.polygon) at = turn * at;
    for (PlanPlane& plane : plan.planes) {
      plane.through = turn * plane.through;
      plane.direction = (turn * plane.direction).normalized();
    }
    if (!plan.footprint.polygon.empty()) {
      plan.footprint = polygon_footprint(plan.footprint.corner, plan.footprint.polygon);
    }
    problem.buildings.push_back(make_plan_building("B", plan_model(plan), ModalDamping{{0.05}}));
  }
  const auto stretch = facing(plans[0].footprint, plans[1].footprint);
  PlanGap gap{.left = stretch->swapped ? 1 : 0, .right = stretch->swapped ? 0 : 1, .stretch = *stretch};
  for (Index floor = 0; floor < 2; ++floor) {
    for (const StretchPoint& point : points_of(*stretch, draw.points)) {
      const auto law = std::make_shared<Linear>(stiffer * point.share * draw.stiffness);
      gap.contacts.push_back(
          {floor, floor, problem.buildings[0].model.elevations[floor], point.along, law,
           std::make_shared<Rubbing>(law, draw.friction, 0.8 * law->branch(law->next({}, 0, 0, 0, 1)).stiffness)});
    }
  }
  problem.gaps = {gap};
  problem.motions = draw.motions;
  problem.axes = turn * turn_by(draw.angle);
  problem.duration = 2;
  return problem;
}

/// How far apart two responses are in what no turn changes, relative to the largest of a kind.
double apart(const PlanProblem& problem, const PlanResponse& wanted, const PlanProblem& other,
             const PlanResponse& found, const Eigen::Matrix2d& turn = Eigen::Matrix2d::Identity()) {
  if (wanted.impacts.size() != found.impacts.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  const auto note = [&](const Eigen::VectorXd& one, const Eigen::VectorXd& same) {
    most = std::max(most, (one - same).cwiseAbs().maxCoeff() / one.cwiseAbs().maxCoeff());
  };
  for (std::size_t b = 0; b < 2; ++b) {
    note(wanted.buildings[b].rotation, found.buildings[b].rotation);
    note(wanted.buildings[b].torque, found.buildings[b].torque);
    note(wanted.buildings[b].angular_acceleration, found.buildings[b].angular_acceleration);
  }
  const std::vector<PlanContact>&contacts = problem.gaps[0].contacts, &others = other.gaps[0].contacts;
  const Index count = std::ssize(contacts);
  if (count != std::ssize(others)) return std::numeric_limits<double>::infinity();
  Eigen::MatrixXd all(count, 7), same(count, 7);
  for (Index i = 0; i < count; ++i) {
    const PlanPoint at = turn * problem.gaps[0].stretch.middle(contacts[i].along);
    Index there = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < count; ++k) {
      const double distance = (other.gaps[0].stretch.middle(others[k].along) - at).norm();
      if (others[k].elevation != contacts[i].elevation || distance >= least) continue;
      least = distance;
      there = k;
    }
    const auto numbers = [](const PlanResponse& of, Index k) {
      const PointSummary& point = of.points[k];
      const PlanFriction& rubs = of.friction[k];
      Eigen::RowVectorXd row(7);
      row << point.impulse, point.peak_force, point.gap_needed, point.peak_penetration, rubs.tangential_impulse,
          rubs.friction_loss, rubs.sliding;
      return row;
    };
    all.row(i) = numbers(wanted, i);
    same.row(i) = numbers(found, there);
  }
  for (Index k = 0; k < all.cols(); ++k) {
    if (all.col(k).cwiseAbs().maxCoeff() > 0) note(all.col(k), same.col(k));
  }
  return most;
}

TEST(PolygonPlans, BothSolversEnergyAndTheWholeTurned) {
  std::size_t impacts = 0, rubbed = 0;
  double worst_solver = 0, worst_turned = 0, worst_energy = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Draw draw = Generator(seed).make(false);
    const PlanProblem problem = problem_of(draw);
    const PlanResponse exact = solve(problem, ExactSolver{}, {.energy_audit = true});
    ASSERT_EQ(exact.status, Status::done) << exact.message;
    EXPECT_TRUE(exact.discrepancies.empty());
    EXPECT_LE(exact.energy->relative_residual(), 1e-12);
    worst_energy = std::max(worst_energy, exact.energy->relative_residual());
    impacts += exact.impacts.size();
    for (const PlanFriction& friction : exact.friction) rubbed += friction.sliding > 0 ? 1 : 0;
    constexpr double moved_by = 1e-12;
    const PlanProblem moved = problem_of(draw, Eigen::Matrix2d::Identity(), 1 + moved_by);
    const double amplifies = apart(problem, exact, moved, solve(moved, ExactSolver{})) / moved_by;

    const PlanResponse adaptive = solve(problem, AdaptiveSolver{.tolerance = 1e-12});
    const double by = apart(problem, exact, problem, adaptive);
    EXPECT_LE(by, std::max(1e-8, 1e-12 * amplifies)) << amplifies;
    worst_solver = std::max(worst_solver, by);
    for (const double angle : {0.3, 1.1, 2.5, 4.0}) {
      const Eigen::Matrix2d turn = turn_by(angle);
      const PlanProblem other = problem_of(draw, turn);
      const double turned = apart(problem, exact, other, solve(other, ExactSolver{}), turn);
      EXPECT_LE(turned, std::max(1e-9, 1e-13 * amplifies)) << angle << ", " << amplifies;
      worst_turned = std::max(worst_turned, turned);
    }
  }
  std::printf("%zu impacts, %zu points slid; solvers %.2g, turned %.2g, energy %.2g\n", impacts, rubbed, worst_solver,
              worst_turned, worst_energy);
  EXPECT_GT(impacts, 50U);
  EXPECT_GT(rubbed, 10U);
}

TEST(PolygonPlans, OfRectanglesAreTheRectangles) {
  double worst = 0;
  std::size_t impacts = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const Draw polygons = Generator(seed).make(true);
    Draw rectangles = polygons;
    for (Plan& plan : rectangles.plans) plan.footprint.polygon.clear();
    const PlanProblem problem = problem_of(rectangles), other = problem_of(polygons);
    const PlanResponse wanted = solve(problem, ExactSolver{}), found = solve(other, ExactSolver{});
    impacts += wanted.impacts.size();
    const double by = apart(problem, wanted, other, found);
    EXPECT_LE(by, 1e-12);
    worst = std::max(worst, by);
    EXPECT_TRUE(wanted.buildings[0].x.isApprox(found.buildings[0].x, 1e-12));
    EXPECT_TRUE(wanted.buildings[1].north.isApprox(found.buildings[1].north, 1e-12));
  }
  std::printf("%zu impacts, apart by %.2g\n", impacts, worst);
  EXPECT_GT(impacts, 30U);
}

}  // namespace
}  // namespace bentur::polygon_plans
