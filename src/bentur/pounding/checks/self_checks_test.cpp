// Responses damaged on purpose, each in one number: the check that is for it finds it, and no other number is needed.
#include "bentur/pounding/checks/self_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/invariance/drawn_plan.h"
#include "tests/support/random_yielding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using namespace bentur::test;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two oscillators that meet, or, further apart, do not.
Problem problem_with(double width) {
  Problem problem = pair(oscillator(1e5, 3e7, 0.03), oscillator(2e5, 1e7, 0.03), {contact(width, 1e8)}, 2);
  problem.motion = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.02};
  return problem;
}

Response solved(const Problem& problem) {
  SolveOptions options;
  options.energy_audit = true;
  options.output_step = 0.01;
  Response response = solve(problem, ExactSolver{}, options);
  EXPECT_EQ(response.status, Status::done) << response.message;
  EXPECT_TRUE(response.discrepancies.empty());
  return response;
}

struct Damage {
  std::string what;  ///< in the message
  double width;
  std::function<void(Response&)> to;
};

TEST(SelfChecks, FindEachDamage) {
  const double near = 0.002, far = 0.5;
  const Damage damages[] = {
      {"displacement 1 of", near, [](Response& r) { r.buildings[1].displacement(0) = none; }},
      {"acceleration without contact 1", near, [](Response& r) { r.buildings[0].acceleration_no_contact(0) = none; }},
      {"storey shear 1", near, [](Response& r) { r.buildings[0].storey_shear(0) = HUGE_VAL; }},
      {"drift ratio 1", near, [](Response& r) { r.buildings[0].drift_ratio(0) = none; }},
      {"a number of level", near, [](Response& r) { r.points[0].energy_lost = none; }},
      {"a number of the impact", near, [](Response& r) { r.impacts[0].peak_penetration = none; }},
      {"histories", near, [](Response& r) { r.histories.force(0, 3) = none; }},
      {"the list", near, [](Response& r) { r.impacts.pop_back(); }},
      {"the list", near, [](Response& r) { r.points[0].peak_force *= 1.001; }},
      {"the list", near, [](Response& r) { r.points[0].impulse *= 1.001; }},
      {"lasts from", near, [](Response& r) { r.impacts[1].start = r.impacts[0].start; }},
      {"lasts from", near, [](Response& r) { r.impacts.back().end = 3; }},
      {"impacts, but without contact", near, [](Response& r) { r.points[0].gap_needed = 0.0019; }},
      {"0 impacts, but without contact", near,
       [](Response& r) {
         r.impacts.clear();
         r.points[0].impacts = 0;
         r.points[0].peak_force = r.points[0].impulse = 0;
       }},
      {"differ from those without contact", far, [](Response& r) { r.buildings[0].displacement(0) *= 1.001; }},
      {"the energy that went in", near, [](Response& r) { r.energy->residual = 1e-3 * r.energy->peak_input; }},
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.what);
    const Problem problem = problem_with(damage.width);
    Response response = solved(problem);
    ASSERT_EQ(response.impacts.empty(), damage.width == far);
    check_itself(problem, ExactSolver{}, {}, response);
    EXPECT_EQ(response.status, Status::done);
    damage.to(response);
    check_itself(problem, ExactSolver{}, {}, response);
    EXPECT_EQ(response.status, Status::failed);
    EXPECT_NE(response.message.find("the run contradicts itself: "), std::string::npos) << response.message;
    EXPECT_NE(response.message.find(damage.what), std::string::npos) << response.message;
  }
}

TEST(SelfChecks, FindEachDamageInPlan) {
  struct DamageInPlan {
    std::string what;  ///< in the message
    double wider;
    std::function<void(PlanResponse&)> to;
  };
  const double near = 0, far = 5;
  const DamageInPlan damages[] = {
      {"displacement 1 of", near, [](PlanResponse& r) { r.buildings[1].west(0) = none; }},
      {"rotation 1 of", near, [](PlanResponse& r) { r.buildings_no_contact[0].rotation(0) = none; }},
      {"shear of a plane 1", near, [](PlanResponse& r) { r.buildings[0].planes[2].shear(0) = HUGE_VAL; }},
      {"a number of level", near, [](PlanResponse& r) { r.points[0].energy_lost = none; }},
      {"a number of the impact", near, [](PlanResponse& r) { r.impacts[0].tangential_impulse = none; }},
      {"friction", near, [](PlanResponse& r) { r.friction[0].sliding = none; }},
      {"the list", near, [](PlanResponse& r) { r.impacts.pop_back(); }},
      {"the list", near, [](PlanResponse& r) { r.points[r.impacts[0].point].impulse *= 1.001; }},
      {"lasts from", near, [](PlanResponse& r) { r.impacts.back().end = 5; }},
      {"impacts, but without contact", near,
       [](PlanResponse& r) {
         for (PointSummary& one : r.points) one.gap_needed = 0.001;
       }},
      {"0 impacts, but without contact", near,
       [](PlanResponse& r) {
         r.impacts.clear();
         for (PointSummary& one : r.points) one = {.gap_needed = one.gap_needed};
       }},
      {"differ from those without contact", far, [](PlanResponse& r) { r.buildings[0].north(0) *= 1.001; }},
      {"the energy that went in", near, [](PlanResponse& r) { r.energy->residual = 1e-3 * r.energy->peak_input; }},
  };
  for (const DamageInPlan& damage : damages) {
    SCOPED_TRACE(damage.what);
    DrawnPlan drawn(3);
    drawn.wider = damage.wider;
    const PlanProblem problem = drawn.problem();
    PlanResponse response = solve(problem, ExactSolver{}, {.energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    ASSERT_EQ(response.impacts.empty(), damage.wider == far);
    EXPECT_TRUE(response.discrepancies.empty());
    damage.to(response);
    check_itself(problem, ExactSolver{}, {}, response);
    EXPECT_EQ(response.status, Status::failed);
    EXPECT_NE(response.message.find("the run contradicts itself: "), std::string::npos) << response.message;
    EXPECT_NE(response.message.find(damage.what), std::string::npos) << response.message;
  }
}

TEST(SelfChecks, FindWhatTheRunMeasured) {
  const Problem problem = problem_with(0.002);
  const Response found = solved(problem);
  const SelfMeasures bad[] = {{.momentum = 1e-3}, {.opening = 1e-3}, {.forces = 1e-3}, {.momentum = none}};
  const SelfMeasures poor[] = {{.momentum = 1e-8}, {.opening = 1e-8}, {.forces = 1e-8}};
  for (const SelfMeasures& measures : bad) {
    Response response = found;
    check_itself(problem, ExactSolver{}, measures, response);
    EXPECT_EQ(response.status, Status::failed);
    response = found;
    check_itself(problem, RungeKuttaSolver{}, measures, response);
    EXPECT_EQ(response.status, Status::done) << "knows no bound";
  }
  for (const SelfMeasures& measures : poor) {
    Response response = found;
    check_itself(problem, ExactSolver{}, measures, response);
    EXPECT_EQ(response.status, Status::done) << response.message;
    ASSERT_EQ(response.discrepancies.size(), 1U);
    EXPECT_EQ(response.discrepancies[0].size, 1e-8);
  }
}

TEST(SelfChecks, PassRandomCases) {
  for (unsigned seed = 500; seed < 560; ++seed) {
    const Problem problem = YieldingGenerator(seed).make().problem;
    for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-7})}) {
      const Response response = solve(problem, solver);
      EXPECT_EQ(response.status, Status::done) << seed << ": " << response.message;
    }
  }
}

}  // namespace
}  // namespace bentur
