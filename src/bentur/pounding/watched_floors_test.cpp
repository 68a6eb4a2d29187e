// Floors that are watched against what they face, where no contact is modelled.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;
using namespace bentur::test;

WatchedFloor watched_at(VectorXd left_row, VectorXd right_row, double width) {
  WatchedFloor floor;
  floor.left_row = std::move(left_row);
  floor.right_row = std::move(right_row);
  floor.width = width;
  return floor;
}

struct Way {
  Solver solver;
  double accuracy = 0;  ///< relative, of extrema
};

/// As solvers_test.cpp has them; times of extrema are known to the root of that.
std::vector<Way> all_ways() {
  return {{ExactSolver{}, 1e-12}, {AdaptiveSolver{1e-9}, 1e-8}, {RungeKuttaSolver{1e-3}, 1e-6}};
}

// x₁ = A sin θ, x₂ = A sin 2θ, θ = 2πt/T: ½x₁ − ¼x₂ is largest at θ = 2π/3, (3√3/8) A.
TEST(WatchedFloors, NeedAndLeastOpeningOfAClosedForm) {
  const double omega = 2 * pi, a = 0.03;
  for (const Way& way : all_ways()) {
    Problem problem = pair(oscillator(2.0, 2.0 * omega * omega), oscillator(3.0, 12.0 * omega * omega), {}, 0.9);
    problem.initial_velocity[0](0) = a * omega;
    problem.initial_velocity[1](0) = 2 * a * omega;
    problem.watched = {watched_at(VectorXd::Constant(1, 0.5), VectorXd::Constant(1, 0.25), 0.05)};
    const double need = 3 * std::sqrt(3.0) / 8 * a;
    const Response response = solve(problem, way.solver);
    ASSERT_EQ(response.status, Status::done);
    ASSERT_EQ(response.watched.size(), 1u);
    EXPECT_NEAR(response.watched[0].gap_needed, need, way.accuracy * need);
    EXPECT_NEAR(response.watched[0].least_opening, 0.05 - need, way.accuracy * 0.05);
    EXPECT_NEAR(response.watched[0].least_time, 1.0 / 3, 3 * std::sqrt(way.accuracy));
    EXPECT_FALSE(response.watched[0].closes);
    problem.watched[0].width = need * (1 - 1e-5);
    EXPECT_TRUE(solve(problem, way.solver).watched[0].closes);
  }
}

/// Two sticks of two floors under a jagged motion with delays, contacts at both floors that are often closed, and the
/// same two pairs of floors watched as well.
Problem doubled_pair(Kinematics kinematics) {
  Eigen::Matrix2d stiffness;
  stiffness << 5000, -2000, -2000, 2000;
  const Eigen::Matrix2d mass = Eigen::Vector2d(2.0, 1.5).asDiagonal();
  Problem problem = pair(matrix_building(mass, stiffness, 0.01 * stiffness),
                         matrix_building(1.3 * mass, 3.0 * stiffness, 0.01 * stiffness),
                         {contact(0.01, 3e5, 0), contact(0.012, 2e5, 1)}, 8.0);
  SampledMotion motion;
  motion.time_step = 0.02;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 300; ++n) motion.acceleration.push_back(8.0 * normal(random));
  problem.motion = motion;
  problem.delays = {0.0, 0.013};
  problem.kinematics = kinematics;
  for (int floor = 0; floor < 2; ++floor) {
    const VectorXd row = VectorXd::Unit(2, floor);
    problem.watched.push_back(watched_at(row, row, problem.points[static_cast<std::size_t>(floor)].width));
  }
  return problem;
}

TEST(WatchedFloors, AreWhatContactPointsAtTheSameFloorsSay) {
  for (const Kinematics kinematics : {Kinematics::relative, Kinematics::absolute}) {
    const Problem problem = doubled_pair(kinematics);
    for (const Way& way : all_ways()) {
      const Response response = solve(problem, way.solver);
      ASSERT_EQ(response.status, Status::done);
      for (std::size_t i = 0; i < 2; ++i) {
        const PointSummary& point = response.points[i];
        const WatchedSummary& watched = response.watched[i];
        ASSERT_GT(point.impacts, 3);
        EXPECT_NEAR(watched.gap_needed, point.gap_needed, 1e-12 * point.gap_needed);
        EXPECT_NEAR(watched.least_opening, -point.peak_penetration, 1e-9 * point.peak_penetration);
        EXPECT_TRUE(watched.closes);
        // A linear contact's force is largest where it is deepest.
        EXPECT_NEAR(watched.least_time, *point.peak_force_time, 1e-6);
      }
    }
  }
}

TEST(WatchedFloors, ChangeNothingElse) {
  const Problem problem = doubled_pair(Kinematics::absolute);
  Problem without = problem;
  without.watched.clear();
  const Response watched = solve(problem), free = solve(without);
  ASSERT_EQ(watched.impacts.size(), free.impacts.size());
  for (std::size_t i = 0; i < free.impacts.size(); ++i) {
    EXPECT_EQ(watched.impacts[i].start, free.impacts[i].start);
    EXPECT_EQ(watched.impacts[i].peak_force, free.impacts[i].peak_force);
  }
  EXPECT_EQ(watched.buildings[0].displacement, free.buildings[0].displacement);
}

// Gaps of all widths from one free response: those that never close, that close late, and that are watched with samples
// kept, as each is alone.
TEST(WatchedFloors, OfASharedFreeResponseAreThoseOfRunsOfTheirOwn) {
  Problem problem = doubled_pair(Kinematics::relative);
  const FreeResponse shared(problem);
  SolveOptions samples;
  samples.output_step = 0.1;
  const Response free = solve(problem);
  const double most = std::max(free.points[0].gap_needed, free.points[1].gap_needed);
  for (const double part : {0.1, 0.9, 0.99, 1.01}) {
    for (ContactPoint& point : problem.points) point.width = part * most;
    for (WatchedFloor& floor : problem.watched) floor.width = 0.5 * part * most;
    const Response alone = solve(problem), one = shared.solve(problem), sampled = shared.solve(problem, samples);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(one.watched[i].least_opening, alone.watched[i].least_opening) << part;
      EXPECT_EQ(one.watched[i].least_time, alone.watched[i].least_time) << part;
      EXPECT_EQ(one.watched[i].gap_needed, alone.watched[i].gap_needed) << part;
      EXPECT_NEAR(sampled.watched[i].least_opening, alone.watched[i].least_opening, 1e-13) << part;
    }
  }
}

// Two twins that move alike, touching: round-off is no contact.
TEST(WatchedFloors, OfTwinsDoNotClose) {
  const Eigen::Matrix2d mass = Eigen::Vector2d(2.0, 1.5).asDiagonal();
  Eigen::Matrix2d stiffness;
  stiffness << 5000, -2000, -2000, 2000;
  Problem problem = pair(matrix_building(mass, stiffness, 0.01 * stiffness),
                         matrix_building(mass, stiffness, 0.01 * stiffness), {}, 5.0);
  problem.motion = HarmonicMotion{.period = 0.3, .displacement_amplitude = 0.02};
  const VectorXd row = Eigen::Vector2d(0.37, 0.61);
  problem.watched = {watched_at(row, row * (1 + 1e-15), 0.0)};
  for (const Way& way : all_ways()) EXPECT_FALSE(solve(problem, way.solver).watched[0].closes);
}

TEST(WatchedFloors, MustBelongToTheProblem) {
  const auto with = [](auto change) {
    Problem problem = doubled_pair(Kinematics::relative);
    change(problem.watched[1]);
    return problem;
  };
  EXPECT_THROW((void)solve(with([](WatchedFloor& floor) { floor.left = 1; })), InvalidParameter);
  EXPECT_THROW((void)solve(with([](WatchedFloor& floor) { floor.floor_of = 2; })), InvalidParameter);
  EXPECT_THROW((void)solve(with([](WatchedFloor& floor) { floor.width = -1; })), InvalidParameter);
  EXPECT_THROW((void)solve(with([](WatchedFloor& floor) { floor.left_row = VectorXd::Zero(3); })), InvalidParameter);
}

TEST(ContactPoints, MeetEachFloorOnce) {
  Problem problem = doubled_pair(Kinematics::relative);
  problem.points[1].left_floor = 0;
  EXPECT_THROW((void)solve(problem), InvalidParameter);
  problem = doubled_pair(Kinematics::relative);
  problem.points[1].right_floor = 0;
  EXPECT_THROW((void)solve(problem), InvalidParameter);
}

}  // namespace
}  // namespace bentur
