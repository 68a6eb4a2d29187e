// The monograph's scheme on buildings in plan, against the exact solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/invariance/drawn_plan.h"

namespace bentur {
namespace {

/// How far the largest displacements are apart, as a part of the largest of all.
double how_far_apart(const PlanResponse& one, const PlanResponse& other) {
  double largest = 0, by = 0;
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    for (const auto list : {&PlanPeaks::south, &PlanPeaks::east, &PlanPeaks::north, &PlanPeaks::west}) {
      const Eigen::VectorXd &a = one.buildings[b].*list, &e = other.buildings[b].*list;
      largest = std::max(largest, e.maxCoeff());
      by = std::max(by, (a - e).cwiseAbs().maxCoeff());
    }
  }
  return by / largest;
}

/// Without contact the error falls with the fourth power of the step; with it, as its instants are found by halving a
/// step, the answers stay near: a part in a thousand at half a millisecond.
TEST(PlanSolvers, RungeKuttaComesNearTheExactSolution) {
  std::size_t impacts = 0;
  double coarse = 0, fine = 0;
  for (unsigned seed = 101; seed <= 110; ++seed) {
    SCOPED_TRACE(seed);
    test::DrawnPlan draw(seed);
    draw.friction = 0;
    draw.stiffness = 5e4;
    draw.wider = 1;
    const PlanProblem apart_by_far = draw.problem();
    const PlanResponse free = solve(apart_by_far);
    coarse = std::max(coarse, how_far_apart(solve(apart_by_far, RungeKuttaSolver{0.004}), free));
    fine = std::max(fine, how_far_apart(solve(apart_by_far, RungeKuttaSolver{0.002}), free));
    draw.wider = 0;
    const PlanProblem problem = draw.problem();
    const PlanResponse exact = solve(problem), fixed = solve(problem, RungeKuttaSolver{0.0005});
    ASSERT_EQ(fixed.status, Status::done) << fixed.message;
    EXPECT_LE(how_far_apart(fixed, exact), 1e-3);
    impacts += exact.impacts.size();
  }
  EXPECT_LE(fine, 1e-4);
  EXPECT_LE(fine, coarse / 10);
  EXPECT_GT(impacts, 50U);
}

/// Between one stick or slip and the next forces are straight, and their instants are found by halving a step: the
/// order is four, of what friction takes too. The paths slid are sums of many, and errors of blows grow.
TEST(PlanSolvers, RungeKuttaFollowsFriction) {
  const auto sum = [](const PlanResponse& response, double PlanFriction::*of) {
    double all = 0;
    for (const PlanFriction& one : response.friction) all += one.*of;
    return all;
  };
  std::size_t impacts = 0;
  double slid = 0, coarse = 0, fine = 0;
  for (unsigned seed = 101; seed <= 112; ++seed) {
    SCOPED_TRACE(seed);
    test::DrawnPlan draw(seed);
    draw.friction = 0.3;
    draw.stiffness = 5e4;
    draw.law = static_cast<int>(seed % 3);
    const PlanProblem problem = draw.problem();
    const PlanResponse exact = solve(problem), fixed = solve(problem, RungeKuttaSolver{0.001}),
                       finer = solve(problem, RungeKuttaSolver{0.0005});
    ASSERT_EQ(fixed.status, Status::done) << fixed.message;
    ASSERT_EQ(finer.status, Status::done) << finer.message;
    EXPECT_EQ(fixed.impacts.size(), exact.impacts.size());
    EXPECT_EQ(finer.impacts.size(), exact.impacts.size());
    coarse = std::max(coarse, how_far_apart(fixed, exact));
    fine = std::max(fine, how_far_apart(finer, exact));
    for (double PlanFriction::*const of : {&PlanFriction::sliding, &PlanFriction::friction_loss}) {
      EXPECT_NEAR(sum(finer, of), sum(exact, of), 1e-7 * sum(exact, of));
    }
    impacts += exact.impacts.size();
    slid += sum(exact, &PlanFriction::sliding);
  }
  EXPECT_GT(impacts, 200U);
  EXPECT_GT(slid, 1.0);
  EXPECT_LE(coarse, 2e-8);
  EXPECT_LE(fine, coarse / 12);
}

}  // namespace
}  // namespace bentur
