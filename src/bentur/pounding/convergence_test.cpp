// How fast runge-kutta and adaptive come to what exact says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bentur/pounding/pounding.h"
#include "tests/support/example_laws.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

using Eigen::MatrixXd;
using namespace bentur::test;

SampledMotion record() {
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  return motion;
}

/// Two sticks of two floors that cannot reach each other.
Problem apart(GroundMotion motion) {
  MatrixXd stiffness(2, 2);
  stiffness << 800, -400, -400, 400;
  const MatrixXd mass = MatrixXd::Identity(2, 2);
  Problem problem = pair(matrix_building(mass, stiffness, 0.002 * stiffness),
                         matrix_building(1.7 * mass, 0.8 * stiffness, 0.003 * stiffness), {contact(50, 1e4, 1)}, 2.0);
  problem.motion = std::move(motion);
  problem.delays = {0, 0.04};
  problem.initial_velocity[0] << 0.1, 0.2;
  return problem;
}

Response sampled(const Problem& problem, const Solver& solver) {
  SolveOptions options;
  options.output_step = problem.duration / 500;
  return solve(problem, solver, options);
}

/// Largest difference of displacement and of velocity over all samples, each relative to the largest.
double difference(const Response& one, const Response& other) {
  double worst = 0;
  for (std::size_t b = 0; b < one.histories.displacement.size(); ++b) {
    const auto compare = [&](const MatrixXd& x, const MatrixXd& y) {
      worst = std::max(worst, (x - y).cwiseAbs().maxCoeff() / y.cwiseAbs().maxCoeff());
    };
    compare(one.histories.displacement[b], other.histories.displacement[b]);
    compare(one.histories.velocity[b], other.histories.velocity[b]);
  }
  return worst;
}

/// Slope of log(error) over log(step), steps halved each time.
double observed_order(const std::vector<double>& errors) {
  const auto n = static_cast<double>(errors.size());
  double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) sum += (static_cast<double>(i) - (n - 1) / 2) * std::log2(errors[i]);
  return -12 * sum / (n * (n * n - 1));
}

/// Errors of runge-kutta, from a first step on.
std::vector<double> errors_of_steps(const Problem& problem, const Response& exact, double step, int halvings) {
  std::vector<double> errors;
  for (int n = 0; n <= halvings; ++n, step /= 2) {
    errors.push_back(difference(sampled(problem, RungeKuttaSolver{step}), exact));
    // Round-off of the finest steps is below 2e-12: a regime of truncation alone.
    EXPECT_GT(errors.back(), 1e-11) << step;
  }
  return errors;
}

TEST(Convergence, RungeKuttaInFreeFlightIsOfOrderFour) {
  for (const GroundMotion& motion :
       {GroundMotion(HarmonicMotion{0.3, 0.01, HarmonicMotion::Phase::sine}), GroundMotion(record())}) {
    const Problem problem = apart(motion);
    const auto errors =
        errors_of_steps(problem, sampled(problem, ExactSolver{}), 0.01, 4);  // all divide the record's 0.02 s
    EXPECT_GE(observed_order(errors), 3.8);
    EXPECT_LE(observed_order(errors), 4.2);
  }
}

/// A free mass runs into an oscillator, and in most cases is hit once more.
class ConvergenceInContact : public testing::TestWithParam<LawExample> {
 protected:
  ConvergenceInContact() {
    const double m = 2e5;
    problem_ = free_masses(m, m, 0.0137, 0.5, GetParam().make(m / 2), 1);
    problem_.buildings[1] = oscillator(m, m * 25);
  }
  /// The best known: exact, which while a nonlinear contact lasts is a pair at 1e-10 itself; there adaptive at 1e-13.
  [[nodiscard]] Response best() const {
    return GetParam().straight ? sampled(problem_, ExactSolver{}) : sampled(problem_, AdaptiveSolver{1e-13});
  }
  Problem problem_;
};

TEST_P(ConvergenceInContact, ExactIsAsGoodAsItsOwnPair) {
  // For straight laws another solver judges, one that errs by some tens of its tolerance itself.
  const double error = difference(sampled(problem_, ExactSolver{}), sampled(problem_, AdaptiveSolver{1e-13}));
  EXPECT_LE(error, GetParam().straight ? 5e-12 : 20 * 1e-10);
}

TEST_P(ConvergenceInContact, RungeKuttaKeepsTheOrderThatTheForceAllows) {
  const double order = GetParam().order;
  const double measured = observed_order(order == 4 ? errors_of_steps(problem_, best(), 8e-3, 3)
                                                    : errors_of_steps(problem_, best(), 2e-3, 6));
  // Where contact ends between two steps is by chance, and with it the error made there.
  EXPECT_GE(measured, order - 0.2);
  EXPECT_LE(measured, order + 0.5);
}

TEST_P(ConvergenceInContact, AdaptiveErrsInProportionToItsTolerance) {
  const Response exact = best();
  std::vector<double> errors;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    errors.push_back(difference(sampled(problem_, AdaptiveSolver{tolerance}), exact));
    EXPECT_LE(errors.back(), 20 * tolerance) << tolerance;  // some tens of steps, each held to the tolerance
  }
  EXPECT_LE(errors[3], 1e-4 * errors[0]);
}

INSTANTIATE_TEST_SUITE_P(, ConvergenceInContact, testing::ValuesIn(example_laws()),
                         [](const auto& one) { return one.param.label; });

}  // namespace
}  // namespace bentur
