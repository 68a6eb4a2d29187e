// Neither sampling nor the energy account changes the solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/pounding/pounding.h"
#include "tests/support/example_laws.h"
#include "tests/support/free_masses.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// Two oscillators of 2e5 kg under a record, in contact often.
Problem problem_with(const LawExample& law) {
  const double m = 2e5;
  Problem problem =
      pair(oscillator(m, m * 150, 0.03), oscillator(m, m * 60, 0.03), {contact(0.005, law.make(m / 2))}, 3);
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 140; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  problem.motion = motion;
  problem.delays = {0, 0.013};
  return problem;
}

class Sampling : public testing::TestWithParam<LawExample> {};

TEST_P(Sampling, DoesNotChangeTheImpacts) {
  const Problem problem = problem_with(GetParam());
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-7}), Solver(RungeKuttaSolver{0.002})}) {
    const Response plain = solve(problem, solver);
    ASSERT_EQ(plain.status, Status::done) << plain.message;
    ASSERT_GT(plain.impacts.size(), 4u);
    for (const double step : {0.0, 0.001, 0.0037, 0.02}) {
      for (const bool audit : {false, true}) {
        SolveOptions options;
        options.output_step = step;
        options.energy_audit = audit;
        const Response other = solve(problem, solver, options);
        SCOPED_TRACE(std::string(name(solver)) + " " + std::to_string(step));
        expect_same(plain, other);
        const std::size_t samples = step > 0 ? static_cast<std::size_t>(std::floor(3 / step + 1e-9)) + 1 : 0;
        EXPECT_EQ(other.histories.time.size(), samples);
        EXPECT_EQ(other.energy.has_value(), audit);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Sampling, testing::ValuesIn(example_laws()),
                         [](const auto& one) { return one.param.label; });

class ExactCourse : public testing::TestWithParam<LawExample> {};

/// The polygon through the instants of the course: its area in each impact, its peaks, and its distance from samples.
TEST_P(ExactCourse, FollowsTheSolution) {
  const Problem problem = problem_with(GetParam());
  const Response plain = solve(problem);
  SolveOptions options;
  options.output_step = 0.0007;
  options.course = true;
  const Response response = solve(problem, ExactSolver{}, options);
  expect_same(plain, response);
  const Histories& course = response.course;
  ASSERT_TRUE(std::is_sorted(course.time.begin(), course.time.end()));
  EXPECT_EQ(course.time.front(), 0);
  EXPECT_NEAR(course.time.back(), problem.duration, 1e-12);
  const auto value = [&](const auto& row, double time) {  // left of a jump
    const auto next = std::lower_bound(course.time.begin(), course.time.end(), time);
    if (next == course.time.begin()) return row(0);
    if (next == course.time.end()) return row(row.size() - 1);
    const auto i = next - course.time.begin();
    const double part = (time - course.time[i - 1]) / (*next - course.time[i - 1]);
    return row(i - 1) + part * (row(i) - row(i - 1));
  };
  for (const Impact& impact : response.impacts) {
    if (!(impact.peak_force > 0) || impact.open_ended) continue;
    const double slack = 1e-9 * (impact.end - impact.start);
    double area = 0;
    double peak = 0;
    for (std::size_t i = 1; i < course.time.size(); ++i) {
      if (course.time[i - 1] < impact.start - slack || course.time[i] > impact.end + slack) continue;
      const double a = course.force(impact.point, i - 1), b = course.force(impact.point, i);
      area += (course.time[i] - course.time[i - 1]) * (a + b) / 2;
      peak = std::max({peak, a, b});
    }
    EXPECT_NEAR(area, impact.impulse, 1e-3 * impact.impulse) << impact.start;
    EXPECT_NEAR(peak, impact.peak_force, 1e-5 * impact.peak_force) << impact.start;
  }
  for (std::size_t b = 0; b < 2; ++b) {
    const double largest = response.buildings[b].displacement.maxCoeff();
    EXPECT_NEAR(course.displacement[b].cwiseAbs().maxCoeff(), largest, 1e-6 * largest);
    const Histories& samples = response.histories;
    for (std::size_t n = 0; n < samples.time.size(); ++n) {
      EXPECT_NEAR(value(course.displacement[b].row(0), samples.time[n]), samples.displacement[b](0, n),
                  2.1e-3 * largest);
    }
  }
  EXPECT_LT(course.time.size(), 20000U);
}

INSTANTIATE_TEST_SUITE_P(, ExactCourse, testing::ValuesIn(example_laws()),
                         [](const auto& one) { return one.param.label; });

/// The account is one sum: where samples cut its integrals cannot matter but for round-off.
TEST(EnergyAccount, SamplesOnlyReadItsCurves) {
  for (const LawExample& law : example_laws()) {
    const Problem problem = problem_with(law);
    SolveOptions options;
    options.energy_audit = true;
    const Response plain = solve(problem, ExactSolver{}, options);
    EXPECT_EQ(plain.energy->histories.input.size(), 0);
    options.output_step = 0.01;
    const Response sampled = solve(problem, ExactSolver{}, options);
    const EnergyAudit& account = *sampled.energy;
    ASSERT_EQ(account.histories.input.size(), 301);
    const double scale = account.peak_input;
    EXPECT_NEAR(account.peak_input / plain.energy->peak_input, 1, 1e-2) << law.label;  // of more moments
    // What a surface holds when it is left counts as lost; of these laws some comes back if the bodies return in time.
    const bool gives_back = law.law == "kelvin-voigt";
    double lost_before = 0;
    for (Eigen::Index i = 0; i < 301; ++i) {
      const EnergyHistories& e = account.histories;
      EXPECT_NEAR(e.input(i), e.kinetic(i) + e.strain(i) + e.damping(i) + e.contact_stored(i) + e.contact_lost(i),
                  account.residual + 1e-15 * scale);
      EXPECT_GE(e.kinetic(i), 0);
      EXPECT_GE(e.strain(i), 0);
      EXPECT_GE(e.contact_stored(i), 0);
      EXPECT_GE(e.damping(i), i > 0 ? e.damping(i - 1) : 0);
      EXPECT_GE(e.contact_lost(i), gives_back ? 0 : lost_before - 1e-9 * scale) << law.label << " " << i;
      lost_before = e.contact_lost(i);
    }
  }
}

}  // namespace
}  // namespace bentur
