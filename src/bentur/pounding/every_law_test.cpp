// Every contact law through every solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bentur/pounding/pounding.h"
#include "tests/support/example_laws.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

using Eigen::MatrixXd;
using namespace bentur::test;

/// Two sticks of two floors of 2e5 kg and 1.3e5 kg with a record, and a contact of the law at each floor.
Problem sticks(const LawExample& law) {
  MatrixXd pattern(2, 2);
  pattern << 2, -1, -1, 1;
  const double left = 2e5, right = 1.3e5;
  const auto stick = [&](double mass, double stiffness) {
    return matrix_building(mass * MatrixXd::Identity(2, 2), stiffness * pattern, 0.002 * stiffness * pattern);
  };
  const auto shared = law.make(left * right / (left + right));
  ContactPoint upper = contact(0.01, shared);
  upper.left_floor = upper.right_floor = 1;
  Problem problem = pair(stick(left, 1.2e8), stick(right, 4e7), {contact(0.01, shared), upper}, 2.0);
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  problem.motion = motion;
  problem.delays = {0, 0.03};
  return problem;
}

class EveryLawThroughEverySolver : public testing::TestWithParam<LawExample> {
 protected:
  [[nodiscard]] Response run(const Solver& solver) const {
    SolveOptions options;
    options.energy_audit = true;
    return solve(problem_, solver, options);
  }
  /// Same impacts, and the largest relative difference of the points' totals.
  static double difference(const Response& one, const Response& other) {
    EXPECT_EQ(one.impacts.size(), other.impacts.size());
    double worst = 0;
    const auto compare = [&](double a, double b) { worst = std::max(worst, std::abs(a - b) / b); };
    for (std::size_t p = 0; p < one.points.size(); ++p) {
      const PointSummary &a = one.points[p], &b = other.points[p];
      EXPECT_EQ(a.impacts, b.impacts);
      EXPECT_GT(a.impacts, 3);
      compare(a.impulse, b.impulse);
      compare(a.peak_closing_speed, b.peak_closing_speed);
      if (b.peak_force > 0) compare(a.peak_force, b.peak_force);  // an impact without duration has none
      if (b.contact_duration > 0) compare(a.contact_duration, b.contact_duration);
    }
    return worst;
  }
  const Problem problem_ = sticks(GetParam());
};

TEST_P(EveryLawThroughEverySolver, SameImpactsSamePeaksAllEnergy) {
  const LawExample& law = GetParam();
  const Response exact = run(ExactSolver{});
  ASSERT_EQ(exact.status, Status::done) << exact.message;
  // Known between events but for round-off; or by steps with a local error of 1e-10.
  EXPECT_LE(exact.energy->relative_residual(), law.straight ? 1e-13 : 1e-9);

  // Some hundred steps with a local error of 1e-9.
  const Response adaptive = run(AdaptiveSolver{1e-9});
  EXPECT_LE(difference(adaptive, exact), 1e-8);
  EXPECT_LE(adaptive.energy->relative_residual(), 1e-8);

  // (ω h)^order of a contact of some 50 rad/s and a step of 0.25/3 ms there, each with a constant below one.
  const Response fixed = run(RungeKuttaSolver{2.5e-4});
  const double expected = std::pow(50.0 * 2.5e-4 / 3, law.order);
  EXPECT_LE(difference(fixed, exact), expected);
  EXPECT_LE(fixed.energy->relative_residual(), expected);
}

TEST(ExampleLaws, AreOfEveryLaw) {
  std::set<std::string_view> tried;
  const auto examples = example_laws();
  for (const LawExample& law : examples) tried.insert(law.law);
  for (const LawEntry& entry : contact_laws()) EXPECT_EQ(tried.count(entry.name), 1u) << entry.name;
}

INSTANTIATE_TEST_SUITE_P(, EveryLawThroughEverySolver, testing::ValuesIn(example_laws()),
                         [](const auto& one) { return one.param.label; });

}  // namespace
}  // namespace bentur
