#include "bentur/solve/engine/motion/runge_kutta/fixed_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

using Eigen::VectorXd;

const ForceFunction no_force = [](const State&, const std::vector<GroundInput>&, VectorXd& forces) {
  forces = VectorXd::Zero(1);
};

TEST(FixedStep, OfAnOscillatorIsTheTaylorSeriesToTheFourthPower) {
  // ẍ = −ω²x: with θ = ωh, x⁺ = (1 − θ²/2 + θ⁴/24) x + h (1 − θ²/6) v and v⁺ = (1 − θ²/2 + θ⁴/24) v − ωθ(1 − θ²/6) x.
  const double omega = 3;
  const Problem problem =
      test::pair(test::oscillator(1, omega * omega), test::oscillator(1, 1), {test::contact(9, 1)}, 1);
  const ModalSystem system(system_of(problem));
  FixedStep scheme(system);
  State from{VectorXd::Zero(system.size), VectorXd::Zero(system.size)};
  from.q(0) = 0.7;
  from.v(0) = -1.3;
  for (const double h : {0.01, 0.1, 0.5}) {
    State to = from;
    scheme.step(from, std::vector<GroundInput>(2), h, no_force, to);
    const double theta = omega * h, theta2 = theta * theta;
    const double cosine = 1 - theta2 / 2 + theta2 * theta2 / 24, sine = 1 - theta2 / 6;
    EXPECT_NEAR(to.q(0), cosine * 0.7 + h * sine * -1.3, 1e-15);
    EXPECT_NEAR(to.v(0), cosine * -1.3 - omega * theta * sine * 0.7, 1e-14);
  }
}

TEST(FixedStep, ExpansionHasPositionSpeedAndAccelerationAtBothEnds) {
  // Everything that (T-1) has: damping, ground motion, a force that depends on both δ and δ̇.
  Problem problem = test::pair(test::oscillator(2, 50, 0.1), test::oscillator(3, 40, 0.05), {test::contact(0.1, 1)}, 1);
  const ModalSystem system(system_of(problem));
  const ForceFunction force = [&](const State& state, const std::vector<GroundInput>&, VectorXd& forces) {
    const ModalSystem::Relation& of = system.elements[0].relation;
    const double depth = of.along(state.q) - 0.1, speed = of.along(state.v);
    forces = VectorXd::Constant(1, 30 * std::sin(depth) + 4 * speed);
  };
  FixedStep scheme(system);
  State from{VectorXd::Zero(system.size), VectorXd::Zero(system.size)};
  const Eigen::Index second = system.blocks[1].begin;  // of each building a mode and its ground
  from.q(0) = 0.3;
  from.q(second) = -0.2;
  from.v.segment<2>(0) << -1, 0.1;
  from.v.segment<2>(second) << 0.5, 0.2;
  const std::vector<GroundInput> inputs = {{2, -5}, {-1, 4}};
  const double h = 0.13;
  State to = from;
  scheme.step(from, inputs, h, force, to);
  Expansion motion(system, {});
  motion.begin(0, system.size, h, FixedStep::degree);
  scheme.expand(force, motion);
  for (const double s : {0.0, 1.0}) {
    const State& end = s == 0 ? from : to;
    State there = end;
    motion.evaluate(s, there);
    EXPECT_LE((there.q - end.q).norm(), 1e-15) << s;
    EXPECT_LE((there.v - end.v).norm(), 1e-13) << s;
    std::vector<GroundInput> now = inputs;
    system.advance(now, s * h);
    VectorXd forces, wanted, found = VectorXd::Zero(system.size);
    force(end, now, forces);
    system.acceleration(end, now, forces, wanted);
    for (int k = 2; k <= FixedStep::degree; ++k) {
      found += (k * (k - 1.0) * std::pow(s, k - 2) / (h * h)) * motion.coefficients().col(k);
    }
    EXPECT_LE((found - wanted).norm(), 1e-12 * wanted.norm()) << s;
  }
}

}  // namespace
}  // namespace bentur::engine
