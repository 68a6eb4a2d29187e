// Problems that differ in gap widths and laws alone share the way to the first contact; where they leave it is none of
// the solution's business.
#include <gtest/gtest.h>

#include <cmath>

#include "bentur/solve/solver.h"
#include "tests/support/free_masses.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// Two oscillators under a record of 8 s that grows, so that wide gaps close late: more than three stretches of states
/// that are kept on the way. Delays that are no multiple of its step give two kinds of segments.
Problem problem_with(double width, double delay, Kinematics kinematics) {
  const double m = 2e5;
  Problem problem = pair(oscillator(m, m * 150, 0.03), oscillator(m, m * 60, 0.03), {contact(width, 1e8)}, 8);
  SampledMotion motion{0.01, {}};
  for (int i = 0; i < 800; ++i)
    motion.acceleration.push_back(0.005 * i * (std::sin(0.09 * i) + std::sin(0.013 * i * i)));
  problem.motion = motion;
  problem.delays = {0, delay};
  problem.kinematics = kinematics;
  return problem;
}

/// Recorded runs walk all the way, others begin where the gap may close.
TEST(FirstContact, RunsThatBeginLateAreThoseThatWalkTheWholeWay) {
  for (const Kinematics kinematics : {Kinematics::relative, Kinematics::absolute}) {
    for (const double delay : {0.0, 0.054}) {
      const FreeResponse free(problem_with(0, delay, kinematics));
      const double needed = free.solve(problem_with(1e3, delay, kinematics)).points[0].minimum_gap_no_contact;
      ASSERT_GT(needed, 0.0);
      double last_first = -1;
      for (const double part : {0.0, 0.02, 0.2, 0.5, 0.8, 0.97, 1 - 1e-9, 1 + 1e-9, 1.2, 10.0}) {
        const Problem problem = problem_with(part * needed, delay, kinematics);
        SolveOptions options;
        options.output_step = 0.005;
        const Response late = free.solve(problem), whole = free.solve(problem, options);
        ASSERT_EQ(late.status, Status::done);
        expect_same(late, whole);
        expect_same(late, solve(problem));
        EXPECT_EQ(late.impacts.empty(), part > 1) << part;
        if (late.impacts.empty()) {
          EXPECT_EQ(late.buildings[0].displacement, late.buildings[0].displacement_no_contact);
          continue;
        }
        EXPECT_GE(late.impacts.front().start, last_first);
        last_first = late.impacts.front().start;
      }
      EXPECT_GT(last_first,
                4 * 1.28);  // states are kept every 1.28 s (of segments twice as many where there are two kinds)
    }
  }
}

/// A solver with error control agrees, which shares nothing.
TEST(FirstContact, IsFoundByOthersToo) {
  const FreeResponse free(problem_with(0, 0.054, Kinematics::relative));
  const double needed = free.solve(problem_with(1e3, 0.054, Kinematics::relative)).points[0].minimum_gap_no_contact;
  for (const double part : {0.2, 0.5, 0.9}) {
    const Problem problem = problem_with(part * needed, 0.054, Kinematics::relative);
    const Response exact = free.solve(problem), other = solve(problem, AdaptiveSolver{1e-11});
    ASSERT_EQ(exact.impacts.size(), other.impacts.size());
    for (std::size_t i = 0; i < exact.impacts.size(); ++i) {
      EXPECT_NEAR(exact.impacts[i].start, other.impacts[i].start, 1e-8);
      EXPECT_NEAR(exact.impacts[i].peak_force / other.impacts[i].peak_force, 1, 1e-6);
    }
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_NEAR(exact.buildings[b].displacement(0) / other.buildings[b].displacement(0), 1, 1e-8);
      EXPECT_NEAR(exact.buildings[b].acceleration(0) / other.buildings[b].acceleration(0), 1, 1e-6);
      EXPECT_NEAR(exact.buildings[b].storey_shear(0) / other.buildings[b].storey_shear(0), 1, 1e-8);
    }
  }
}

/// Where a load is not that of the masses alone, accelerations jump with the ground's: at the first value of a record
/// that reaches a building late, and after the last one. Both are peaks here.
TEST(Course, EndsWhereTheGroundAccelerationJumps) {
  const auto building = [](double stiffness) {
    Building result = oscillator(2e5, stiffness, 0.03);
    result.model.load *= 0.4;
    return result;
  };
  for (const bool at_the_end : {false, true}) {
    Problem problem = pair(building(2e4), building(1.2e4), {contact(100, 1e8)}, 4);
    SampledMotion motion{0.02, std::vector<double>(50, 0.0)};
    for (std::size_t i = 0; i < 50; ++i) motion.acceleration[i] = std::sin(0.3 * static_cast<double>(i));
    motion.acceleration[at_the_end ? 49 : 0] = 5;
    problem.motion = motion;
    problem.delays = {0, 0.2};
    const Response exact = solve(problem), other = solve(problem, AdaptiveSolver{1e-11});
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_NEAR(exact.buildings[b].acceleration(0) / other.buildings[b].acceleration(0), 1, 1e-8) << b;
      EXPECT_GE(exact.buildings[b].acceleration(0), 0.6 * 4.9);
    }
  }
}

}  // namespace
}  // namespace bentur
