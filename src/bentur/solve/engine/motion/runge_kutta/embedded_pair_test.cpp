#include "bentur/solve/engine/motion/runge_kutta/embedded_pair.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <limits>

#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

using Eigen::VectorXd;

/// Duffing's oscillator ẍ = −ω²x − βx³ from x = A at rest, in closed form: x = A cn(Ωt, k), Ω² = ω² + βA²,
/// k² = βA²/(2Ω²). A mass of 1 on a spring; the cubic part comes from its contact point. The other building stays at
/// rest.
class Duffing {
 public:
  [[nodiscard]] State at(double t) const {
    double cn = 0, dn = 0;
    const double sn =
        boost::math::jacobi_elliptic(std::sqrt(beta / 2) * amplitude / big_omega, big_omega * t, &cn, &dn);
    State state{VectorXd::Zero(system.size), VectorXd::Zero(system.size)};
    state.q(0) = amplitude * cn;
    state.v(0) = -amplitude * big_omega * sn * dn;
    return state;
  }
  static double acceleration(const State& state) {
    return -omega * omega * state.q(0) - beta * std::pow(state.q(0), 3);
  }

  static constexpr double omega = 2, beta = 30, amplitude = 0.8;
  const double big_omega = std::sqrt(omega * omega + beta * amplitude * amplitude);
  const Problem problem =
      test::pair(test::oscillator(1, omega* omega), test::oscillator(1, 9), {test::contact(5, 1)}, 9);
  const ModalSystem system{system_of(problem)};
  const ForceFunction force = [](const State& state, const std::vector<GroundInput>&, VectorXd& forces) {
    forces = VectorXd::Constant(1, beta * std::pow(state.q(0), 3));
  };
  const std::vector<GroundInput> no_input = std::vector<GroundInput>(2);
};

/// Of errors at lengths that are halved each time.
double order(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

double largest(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

TEST(EmbeddedPair, IsOfOrderEight) {
  const Duffing duffing;
  EmbeddedPair pair(duffing.system, 1e-9);
  const double duration = 2;  // 1.4 periods
  std::vector<double> errors;
  for (const int steps : {16, 32, 64, 128}) {  // down to 4e-14, still above round-off
    State state = duffing.at(0), next = state;
    for (int n = 0; n < steps; ++n) {
      (void)pair.step(state, duffing.no_input, duration / steps, {0, 1}, duffing.force, next);
      state = next;
    }
    const State exact = duffing.at(duration);
    errors.push_back(largest(state.q(0) - exact.q(0), (state.v(0) - exact.v(0)) / duffing.big_omega));
  }
  EXPECT_GE(order(errors), 7.8);
  EXPECT_LE(order(errors), 8.8);
}

// The same oscillator in units of mass that are 10¹⁰ times larger and smaller, on ground that moves: its coordinates
// change with the root of that, the ground's do not.
TEST(EmbeddedPair, JudgesAStepAlikeInAllUnits) {
  std::vector<double> errors;
  for (const double mass : {1.0, 1e-10, 1e10}) {
    Problem problem =
        test::pair(test::oscillator(mass, 4 * mass), test::oscillator(mass, 9 * mass), {test::contact(5, 1)}, 9);
    problem.kinematics = Kinematics::absolute;
    const ModalSystem system(system_of(problem));
    const ForceFunction force = [mass](const State& state, const std::vector<GroundInput>&, VectorXd& forces) {
      forces = VectorXd::Constant(1, 30 * mass * std::pow(state.q(0) / std::sqrt(mass), 3));
    };
    State state{VectorXd::Zero(system.size), VectorXd::Zero(system.size)};
    state.q(0) = 0.8 * std::sqrt(mass);
    for (const auto& block : system.blocks) state.v(block.begin + 1) = 2;  // of the ground
    State next = state;
    EmbeddedPair pair(system, 1e-9);
    errors.push_back(pair.step(state, {{1.5, 0}, {1.5, 0}}, 0.3, {0, 2}, force, next));
  }
  EXPECT_GT(errors[0], 1);
  EXPECT_NEAR(errors[1] / errors[0], 1, 1e-6);
  EXPECT_NEAR(errors[2] / errors[0], 1, 1e-6);
}

TEST(EmbeddedPair, InterpolatesSpeedsWithOrderSeven) {
  const Duffing duffing;
  EmbeddedPair pair(duffing.system, 1e-9);
  Expansion motion(duffing.system, {0.0});
  // Of one step: an interpolant of order 7 errs by h⁸ in v, and its integral, q, by h⁹.
  std::vector<double> errors, errors_q;
  for (const double h : {0.16, 0.08, 0.04}) {
    const double start = 0.3;
    State next = duffing.at(start);
    (void)pair.step(duffing.at(start), duffing.no_input, h, {0, 1}, duffing.force, next);
    motion.begin(0, 2, h, EmbeddedPair::degree);
    pair.expand(duffing.force, motion);
    double error = 0, error_q = 0;
    for (int i = 1; i < 20; ++i) {
      State there = next;
      motion.evaluate(i / 20.0, there);
      const State exact = duffing.at(start + h * i / 20.0);
      error = largest(error, (there.v(0) - exact.v(0)) / duffing.big_omega);
      error_q = largest(error_q, there.q(0) - exact.q(0));
    }
    errors.push_back(error);
    errors_q.push_back(error_q);
  }
  EXPECT_GE(order(errors), 7.7);
  EXPECT_LE(order(errors), 8.5);
  EXPECT_GE(order(errors_q), 8.7);
  EXPECT_LE(order(errors_q), 9.5);
}

TEST(EmbeddedPair, ExpansionMeetsTheStepAtBothEnds) {
  const Duffing duffing;
  EmbeddedPair pair(duffing.system, 1e-9);
  Expansion motion(duffing.system, {0.0});
  const double h = 0.2;
  const State from = duffing.at(0.3);
  State to = from, there = from;
  (void)pair.step(from, duffing.no_input, h, {0, 1}, duffing.force, to);
  motion.begin(0, 2, h, EmbeddedPair::degree);
  pair.expand(duffing.force, motion);
  const double scale = Duffing::amplitude;
  for (const double s : {0.0, 1.0}) {
    const State& end = s == 0 ? from : to;
    motion.evaluate(s, there);
    EXPECT_NEAR(there.v(0), end.v(0), 1e-13 * scale * duffing.big_omega) << s;
    EXPECT_NEAR(there.q(0), end.q(0), 1e-14 * scale) << s;
    Polynomial q;
    q.degree = EmbeddedPair::degree;
    for (int k = 0; k <= q.degree; ++k) q[k] = motion.coefficients()(0, k);
    Polynomial v = q;
    v.degree = q.degree - 1;
    for (int k = 0; k <= v.degree; ++k) v[k] = (k + 1) * q[k + 1] / h;
    EXPECT_NEAR(first_derivative(v, s) / h, Duffing::acceleration(end), 1e-11) << s;
  }
}

TEST(EmbeddedPair, ItsEstimateIsOnTheSafeSide) {
  const Duffing duffing;
  const double tolerance = 1e-9;
  EmbeddedPair pair(duffing.system, tolerance);
  for (const double h : {0.3, 0.2, 0.1, 0.05}) {
    for (const double start : {0.0, 0.13, 0.4, 0.7}) {
      State to = duffing.at(start);
      const double estimate = pair.step(duffing.at(start), duffing.no_input, h, {0, 1}, duffing.force, to);
      const State exact = duffing.at(start + h);
      const double error = std::hypot((to.q(0) - exact.q(0)) / h, to.v(0) - exact.v(0));
      const double size = std::hypot(to.v(0), Duffing::omega * to.q(0));
      EXPECT_GE(estimate * tolerance, error / size - 1e-15) << h << " " << start;
    }
  }
}

TEST(EmbeddedPair, NoNumberIsNoStep) {
  const Duffing duffing;
  EmbeddedPair pair(duffing.system, 1e-9);
  const ForceFunction nan = [](const State&, const std::vector<GroundInput>&, VectorXd& forces) {
    forces = VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  };
  State to = duffing.at(0);
  EXPECT_FALSE(pair.step(duffing.at(0), duffing.no_input, 0.1, {0, 1}, nan, to) <= 1);
}

TEST(EmbeddedPair, MovesOnlyTheBuildingsThatItIsGiven) {
  const Duffing duffing;
  EmbeddedPair pair(duffing.system, 1e-9);
  State from = duffing.at(0), to = from;
  const Eigen::Index second = duffing.system.blocks[1].begin;
  from.q(second) = 0.1;
  to.q(second) = 77;
  to.v(second) = 78;
  (void)pair.step(from, duffing.no_input, 0.1, {0, 1}, duffing.force, to);
  EXPECT_EQ(to.q(second), 77);
  EXPECT_EQ(to.v(second), 78);
  EXPECT_NE(to.q(0), from.q(0));
  State both = from;
  (void)pair.step(from, duffing.no_input, 0.1, {0, 2}, duffing.force, both);
  EXPECT_EQ(both.q(0), to.q(0));
  EXPECT_NE(both.q(second), from.q(second));
}

TEST(EmbeddedPair, TakesTheGroundAlong) {
  // At rest under a_g = c t the ground goes to c t³/6, a free mass to −c t³/6: polynomials that it has exactly.
  Problem problem = test::pair(test::oscillator(1, 0), test::wall(), {}, 1);
  problem.kinematics = Kinematics::absolute;
  const ModalSystem system(system_of(problem));
  EmbeddedPair pair(system, 1e-9);
  const State from{VectorXd::Zero(system.size), VectorXd::Zero(system.size)};
  State to = from;
  const ForceFunction none = [](const State&, const std::vector<GroundInput>&, VectorXd& forces) { forces.setZero(0); };
  EXPECT_LT(pair.step(from, {{0, 6}, {0, 0}}, 0.5, {0, 1}, none, to), 1e-3);
  EXPECT_NEAR(to.q(1), 0.125, 1e-15);
  EXPECT_NEAR(to.v(1), 0.75, 1e-15);
  EXPECT_NEAR(to.q(0), -0.125, 1e-15);
}

}  // namespace
}  // namespace bentur::engine
