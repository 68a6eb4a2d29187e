// Gaps of exactly zero: an opening of zero is open, and round-off is no impact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

using namespace bentur::test;

Problem touching_row(std::vector<Building> buildings, std::vector<ContactPoint> points, double duration) {
  Problem problem;
  problem.buildings = std::move(buildings);
  problem.points = std::move(points);
  problem.delays.assign(problem.buildings.size(), 0.0);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    problem.initial_displacement.emplace_back(Eigen::VectorXd::Zero(1));
    problem.initial_velocity.emplace_back(Eigen::VectorXd::Zero(1));
  }
  problem.duration = duration;
  return problem;
}

/// A and B touch and rest; C, which stands 10 mm away, runs into B.
Problem cradle(double speed, double width) {
  Problem problem =
      touching_row({oscillator(30e3, 40e6, 0.05), oscillator(20e3, 30e6, 0.05), oscillator(25e3, 20e6, 0.05)},
                   {contact(width, 7e7, 0, 0), contact(0.01, 8e7, 0, 1)}, 3.0);
  problem.initial_velocity[2](0) = -speed;
  return problem;
}

int count(const Response& response, int point) {
  const auto at_point = [&](const Impact& impact) { return impact.point == point; };
  return static_cast<int>(std::count_if(response.impacts.begin(), response.impacts.end(), at_point));
}

/// The first impact of a point, or the end.
std::vector<Impact>::const_iterator first_of(const Response& response, int point) {
  const auto at_point = [&](const Impact& impact) { return impact.point == point; };
  return std::find_if(response.impacts.begin(), response.impacts.end(), at_point);
}

TEST(ZeroGap, BuildingsThatTouchAndRestAreHitByAThird) {
  // The free response does not move A and B at all; what the run makes of them is the scale of round-off. A gap of a
  // nanometre, well above round-off, gives the same impacts.
  for (int n = 0; n < 60; ++n) {
    const double speed = 0.307 + 0.004 * n;
    const Response touching = solve(cradle(speed, 0.0));
    const Response apart = solve(cradle(speed, 1e-9));
    ASSERT_EQ(touching.status, Status::done) << speed << touching.message;
    EXPECT_GE(count(touching, 0), 1) << speed;
    EXPECT_NEAR(count(touching, 0), count(apart, 0), 1) << speed;  // one of the last may fade out
    for (const Impact& impact : touching.impacts) EXPECT_GT(impact.end - impact.start, 1e-6) << speed;
    EXPECT_NEAR(touching.points[0].peak_force / apart.points[0].peak_force, 1, 1e-4) << speed;
    const auto first = first_of(touching, 0);
    const auto struck = first_of(touching, 1);
    EXPECT_GE(first->start, struck->start) << speed;
    EXPECT_LT(first->start, struck->start + 1e-12) << speed;  // B pushes A as soon as it is pushed itself
  }
}

/// Of 3 [length/s²] at its peak.
HarmonicMotion harmonic(double period, HarmonicMotion::Phase phase) {
  const double omega = 2 * std::numbers::pi / period;
  return {.period = period, .displacement_amplitude = 3.0 / (omega * omega), .phase = phase};
}

Problem shaken_pair(std::vector<double> delays) {
  Problem problem =
      pair(oscillator(30e3, 40e6, 0.05), oscillator(20e3, 60e6, 0.05), {contact(0.0, 3e8)}, 2.0 + delays[0]);
  problem.motion = harmonic(0.4, HarmonicMotion::Phase::cosine);
  problem.delays = std::move(delays);
  return problem;
}

TEST(ZeroGap, AnImpactBeginsWhenTheOpeningBecomesNegativeHoweverLongItWasZero) {
  const Response at_once = solve(shaken_pair({0.0, 0.0}));
  ASSERT_GE(at_once.impacts.size(), 10u);
  EXPECT_EQ(at_once.impacts[0].start, 0.0);
  for (const double delay : {0.5, 0.123}) {
    for (const Solver& solver : {Solver{ExactSolver{}}, Solver{AdaptiveSolver{1e-11}}}) {
      const Response later = solve(shaken_pair({delay, delay}), solver);
      ASSERT_EQ(later.impacts.size(), at_once.impacts.size()) << delay << name(solver);
      // The grid of steps is another one, so round-off is; it grows with every impact.
      const double accuracy = std::holds_alternative<ExactSolver>(solver) ? 1e-9 : 1e-6;
      for (std::size_t i = 0; i < later.impacts.size(); ++i) {
        EXPECT_NEAR(later.impacts[i].start - delay, at_once.impacts[i].start, accuracy) << delay << name(solver);
        EXPECT_NEAR(later.impacts[i].end - delay, at_once.impacts[i].end, accuracy) << delay << name(solver);
      }
    }
  }
}

TEST(ZeroGap, LeadingZerosOfARecordAreRest) {
  const auto run = [](std::size_t zeros, const Solver& solver) {
    Problem problem = pair(oscillator(30e3, 40e6, 0.05), oscillator(20e3, 60e6, 0.05), {contact(0.0, 3e8)}, 1.2);
    SampledMotion motion{0.01, std::vector<double>(zeros, 0.0)};
    for (int i = 0; i < 60; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
    problem.motion = motion;
    return solve(problem, solver);
  };
  for (const Solver& solver : {Solver{ExactSolver{}}, Solver{AdaptiveSolver{1e-11}}}) {
    const Response none = run(0, solver);
    const Response padded = run(50, solver);
    ASSERT_GE(none.impacts.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(padded.impacts[i].start - 0.5, none.impacts[i].start, 1e-9) << i << name(solver);
      EXPECT_NEAR(padded.impacts[i].end - padded.impacts[i].start, none.impacts[i].end - none.impacts[i].start, 1e-9);
    }
  }
}

TEST(ZeroGap, TwinsThatMoveAlikeTouchOnlyWhenAThirdHitsThem) {
  // Twins exactly alike, and twins of which one is three times as heavy and stiff: they move alike but for round-off.
  for (const double heavier : {1.0, 3.0}) {
    Problem problem = touching_row(
        {oscillator(30e3 * heavier, 40e6 * heavier, 0.05), oscillator(30e3, 40e6, 0.05), oscillator(30e3, 20e6, 0.05)},
        {contact(0.0, 3e8, 0, 0), contact(0.01, 3e8, 0, 1)}, 2.0);
    problem.motion = harmonic(0.3, HarmonicMotion::Phase::sine);
    const Response response = solve(problem);
    const auto twins = first_of(response, 0);
    const auto third = first_of(response, 1);
    ASSERT_NE(third, response.impacts.end()) << heavier;
    ASSERT_NE(twins, response.impacts.end()) << heavier;
    EXPECT_GT(third->start, 0.2) << heavier;
    EXPECT_NEAR(twins->start, third->start, 1e-6) << heavier;
  }
}

TEST(ZeroGap, HertzDampFromRestIsToldOfALeastClosingSpeed) {
  const auto law = std::make_shared<HertzDamp>(2e10, 1.2);
  Problem problem = pair(oscillator(30e3, 40e6, 0.05), oscillator(20e3, 60e6, 0.05), {contact(0.0, law)}, 2.0);
  problem.motion = harmonic(0.246, HarmonicMotion::Phase::cosine);
  const Response exact = solve(problem);
  ASSERT_EQ(exact.status, Status::done) << exact.message;
  EXPECT_EQ(exact.points[0].slow_starts, 1);
  EXPECT_TRUE(exact.impacts[0].slow_start);
  EXPECT_EQ(exact.impacts[0].start, 0.0);
  const Response adaptive = solve(problem, AdaptiveSolver{1e-11});
  ASSERT_EQ(adaptive.status, Status::done) << adaptive.message;
  ASSERT_EQ(adaptive.impacts.size(), exact.impacts.size());
  EXPECT_NEAR(adaptive.impacts[0].end, exact.impacts[0].end, 1e-6);
  // One that starts with a speed of its own is not slow.
  problem.points[0].width = 0.001;
  EXPECT_EQ(solve(problem).points[0].slow_starts, 0);
}

TEST(ZeroGap, RestitutionOfOneInATouchingRow) {
  const auto hard = std::make_shared<Restitution>(1.0);
  for (const Solver& solver : {Solver{ExactSolver{}}, Solver{AdaptiveSolver{}}}) {
    Problem problem =
        touching_row({oscillator(30e3, 1.5e6, 0.05), oscillator(20e3, 3e6, 0.05), oscillator(25e3, 2e6, 0.1)},
                     {contact(0.0, hard, 0), contact(0.001, 8e7, 0, 1)}, 2.4);
    problem.initial_velocity[2](0) = -0.6;
    const Response response = solve(problem, solver);
    EXPECT_EQ(response.status, Status::done) << response.message << name(solver);
    EXPECT_GE(count(response, 0), 1) << name(solver);
    problem.motion = harmonic(0.3, HarmonicMotion::Phase::sine);
    const Response shaken = solve(problem, solver);
    EXPECT_EQ(shaken.status, Status::done) << shaken.message << name(solver);
  }
}

TEST(ZeroGap, OneThatIsPressedFromBothSidesAtOnceFeelsNoneOfTheForcesAlone) {
  const auto law = std::make_shared<KelvinVoigt>(8e7, 0.3, 12e3, KelvinVoigt::Release::zero_force);
  for (const Solver& solver : {Solver{ExactSolver{}}, Solver{AdaptiveSolver{}}}) {
    Problem problem =
        touching_row({oscillator(30e3, 2e6, 0.05), oscillator(20e3, 3e6, 0.05), oscillator(30e3, 2e6, 0.05)},
                     {contact(0.0, law, 0), contact(0.0, law, 1)}, 0.5);
    problem.initial_velocity[0](0) = 0.4;
    problem.initial_velocity[2](0) = -0.4;
    const Response response = solve(problem, solver);
    ASSERT_EQ(response.status, Status::done) << response.message << name(solver);
    EXPECT_GT(response.points[0].peak_force, 1e5) << name(solver);
    EXPECT_LT(response.buildings[1].acceleration(0), 1e-6 * response.buildings[0].acceleration(0)) << name(solver);
  }
}

TEST(ZeroGap, FacesThatOnlyCollideCannotStartInsideOneAnother) {
  Problem problem = free_masses(1.0, 1.0, 0.01, 1.0, std::make_shared<Restitution>(0.5), 1.0);
  problem.initial_displacement[0](0) = 0.01;  // touching
  EXPECT_EQ(solve(problem).status, Status::done);
  problem.initial_displacement[0](0) = 0.02;
  EXPECT_THROW((void)solve(problem), InvalidParameter);
}

}  // namespace
}  // namespace bentur
