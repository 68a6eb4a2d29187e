// What a harmonic motion that goes on after the end of a run can still need.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using Eigen::Matrix2d;
using namespace bentur::test;

/// Two sticks of two floors 1 m apart at both. @param couples dashpots couple modes
Problem shaken_pair(std::mt19937& random, bool couples) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Matrix2d stiffness;
  stiffness << 5000, -2000, -2000, 2000;
  const Matrix2d mass = Eigen::Vector2d(2.0, 1.5).asDiagonal();
  const auto stick = [&] {
    Matrix2d damping = between(0.001, 0.01) * stiffness;
    if (couples) damping(1, 1) += between(1, 20);
    return matrix_building(between(0.5, 2) * mass, between(0.5, 2) * stiffness, damping);
  };
  Problem problem = pair(stick(), stick(), {contact(1, 3e5, 0), contact(1, 2e5, 1)}, between(0.3, 3));
  problem.motion =
      HarmonicMotion{.period = between(0.1, 1.5),
                     .displacement_amplitude = 0.01,
                     .phase = between(0, 1) < 0.5 ? HarmonicMotion::Phase::sine : HarmonicMotion::Phase::cosine};
  problem.delays = {0.0, between(0, 1) < 0.5 ? 0.0 : between(0, 0.2)};
  return problem;
}

double most_to_come(const Response& response, bool reversed) {
  double most = 0;
  for (const PointSummary& point : response.points) {
    most = std::max(most, (reversed ? point.to_come_reversed : point.to_come).value_or(INFINITY));
  }
  return most;
}

double most_needed(const Response& response, bool reversed) {
  double most = 0;
  for (const PointSummary& point : response.points) {
    most = std::max(most, reversed ? point.gap_needed_reversed.value_or(INFINITY) : point.gap_needed);
  }
  return most;
}

TEST(HarmonicMotionLeft, NeedsNoMoreThanIsSaidAndWhenSteadyWhatItHasNeeded) {
  constexpr double round_off = 1e-9;
  std::mt19937 random(11);
  SolveOptions options;
  options.both_ways = true;
  int longer_needs_more = 0;
  for (int n = 0; n < 30; ++n) {
    Problem problem = shaken_pair(random, n % 2 == 1);
    const Response begun = solve(problem, ExactSolver{}, options);
    problem.duration *= 10;
    const Response gone_on = solve(problem, ExactSolver{}, options);
    problem.duration = 200;
    const Response steady = solve(problem, ExactSolver{}, options);
    for (const bool reversed : {false, true}) {
      const double needed = most_needed(begun, reversed), later = most_needed(gone_on, reversed);
      ASSERT_TRUE(std::isfinite(most_to_come(begun, reversed))) << n;
      EXPECT_LE(later, (1 + round_off) * std::max(needed, most_to_come(begun, reversed))) << n;
      EXPECT_LE(most_to_come(steady, reversed), (1 + round_off) * most_needed(steady, reversed)) << n;
      longer_needs_more += later > 1.01 * needed ? 1 : 0;
    }
  }
  EXPECT_GT(longer_needs_more, 5);
}

TEST(HarmonicMotionLeft, IsNotKnownWhereNothingBoundsIt) {
  std::mt19937 random(12);
  Problem late = shaken_pair(random, false);
  late.duration = 0.1;
  late.delays = {0.0, 0.15};
  Problem absolute = shaken_pair(random, false);
  absolute.kinematics = Kinematics::absolute;
  absolute.delays = {0.0, 0.01};
  // Undamped at resonance.
  Problem resonant = pair(oscillator(1, 100), oscillator(1, 400), {contact(1, 3e5, 0)}, 1);
  resonant.motion = HarmonicMotion{.period = 2 * std::acos(-1.0) / 10, .displacement_amplitude = 0.01};
  for (const Problem& problem : {late, absolute, resonant}) {
    EXPECT_TRUE(std::isinf(most_to_come(solve(problem, ExactSolver{}), false)));
  }
}

}  // namespace
}  // namespace bentur
