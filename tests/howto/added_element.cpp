// A law of docs/howto/add_element.md as a storey and as a link: added by itself, without a line of the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "bentur/core/errors.h"
#include "docs/howto/origin_oriented.h"
#include "tests/support/free_masses.h"
#include "tests/support/led_element.h"
#include "tests/support/yielding_buildings.h"

namespace bentur {
namespace {

using namespace bentur::test;

constexpr double mass = 3, stiffness = 1200, omega = 20, yield_force = 60, yield = yield_force / stiffness;

TEST(AddedElement, FollowsItsRulesAlongRandomPaths) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-6 * yield, 6 * yield);
    const double r = seed % 4 * 0.1;
    const OriginOriented law(stiffness, yield_force, r);
    LedElement element(law, yield);
    double most[2] = {yield, yield}, dissipated = 0;  // extremes below and above
    for (int i = 0; i < 50; ++i) {
      const double x = number(random);
      element.lead_to(x);
      double& extreme = most[x > 0];
      extreme = std::max(extreme, std::abs(x));
      const double v = (yield_force + r * stiffness * (extreme - yield)) / extreme * x;
      ASSERT_NEAR(element.force(), v, 1e-11 * yield_force);
      ASSERT_GE(element.hysteretic(), dissipated - 1e-11 * yield_force * yield);
      dissipated = element.hysteretic();
    }
    for (const LedElement::Change& change : element.changes()) {
      ASSERT_NEAR(change.force_before, change.force_after, 1e-11 * yield_force);
      ASSERT_NEAR(change.stored_before, change.stored_after, 1e-11 * yield_force * yield);
      ASSERT_GE(change.least_guard, -1e-12 * yield);
    }
  }
}

TEST(AddedElement, RefusesParametersOutsideTheirRanges) {
  EXPECT_THROW(OriginOriented(0, 1, 0), InvalidParameter);
  EXPECT_THROW(OriginOriented(1, 0, 0), InvalidParameter);
  EXPECT_THROW(OriginOriented(1, 1, 1), InvalidParameter);
}

class AddedElementIn : public testing::TestWithParam<SolverWay> {};

INSTANTIATE_TEST_SUITE_P(, AddedElementIn, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

constexpr double hardening = 0.1;

/// Δ where the work ½ V_y Δ_y + V_y s + ½ r k s² has been done.
double reached(double work) {
  const double rk = hardening * stiffness, rest = work - 0.5 * yield_force * yield;
  return yield + (-yield_force + std::sqrt(yield_force * yield_force + 2 * rk * rest)) / rk;
}

/// ½ V Δ at an extreme point.
double kept(double extreme) { return 0.5 * (yield_force + hardening * stiffness * (extreme - yield)) * extreme; }

TEST_P(AddedElementIn, AStoreySwingsAsItsEnergyTells) {
  // It yields to Δ₁, gives back ½ V₁Δ₁, yields below to Δ₂ < Δ₁, and then swings along both lines, touching (Δ₂, V₂).
  const double v = 3 * omega * yield, start = 0.5 * mass * v * v;
  const double first = reached(start), second = reached(kept(first));
  Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force), 6);
  problem.buildings[0].elements[0].law = std::make_shared<OriginOriented>(stiffness, yield_force, hardening);
  problem.initial_velocity[0](0) = v;
  const Response response = solved(problem, GetParam().solver, 0.1);
  const BuildingPeaks& peaks = response.buildings[0];
  const double near = 10 * GetParam().accuracy;
  EXPECT_NEAR(peaks.yielding.ductility(0), first / yield, near * first / yield);
  EXPECT_EQ(peaks.yielding.residual_drift_ratio(0), 0);
  EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), start - kept(second), near * start);
  const Eigen::VectorXd& hysteretic = response.energy->histories.hysteretic;
  EXPECT_NEAR(hysteretic(hysteretic.size() - 1), start - kept(second), near * start);
}

TEST_P(AddedElementIn, ALinkStopsTwoMassesAsItsEnergyTells) {
  const double left = 2, right = 5, reduced = left * right / (left + right), speed = 4;
  Problem problem = free_masses(left, right, 1e3, speed, std::make_shared<Linear>(1.0), 5);
  Link link;
  link.elevation = 1;
  link.law = std::make_shared<OriginOriented>(stiffness, yield_force, hardening);
  problem.links = {link};
  const double start = 0.5 * reduced * speed * speed, first = reached(start), second = reached(kept(first));
  const LinkSummary is = solved(problem, GetParam().solver).links[0];
  const double near = 10 * GetParam().accuracy;
  EXPECT_NEAR(is.peak_closing, first, near * first);
  EXPECT_NEAR(is.peak_opening, second, near * first);
  EXPECT_NEAR(is.energy_dissipated, start - kept(second), near * start);
}

}  // namespace
}  // namespace bentur
