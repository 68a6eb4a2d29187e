// Many buildings in a row: what is solved island by island is what is solved with all of them stepped together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/core/in_a_thread.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/same_response.h"
#include "tests/support/small_buildings.h"

namespace bentur::many_rows {
namespace {

using Eigen::Index;

/// A row of eight to fourteen buildings of one floor each, some millimetres to centimetres apart.
Problem row(unsigned seed) {
  std::mt19937 engine(seed);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine); };
  Problem problem;
  const int count = std::uniform_int_distribution<int>(8, 14)(engine);
  for (int b = 0; b < count; ++b) {
    const double mass = any(50, 200), omega = 2 * std::numbers::pi / any(0.15, 0.6);
    problem.buildings.push_back(test::oscillator(mass, mass * omega * omega, 0.03));
    problem.initial_displacement.emplace_back(Eigen::VectorXd::Zero(1));
    problem.initial_velocity.emplace_back(Eigen::VectorXd::Zero(1));
    problem.delays.push_back(any(0, 0.05));
  }
  for (int left = 0; left + 1 < count; ++left) {
    const double stiffness = std::pow(10, any(4.8, 5.8));
    problem.points.push_back(test::contact(any(0.002, 0.04), stiffness, 0, left));
    if (seed % 2 == 0) continue;
    problem.points.back().law = std::make_shared<KelvinVoigt>(stiffness, 0.14, 60, KelvinVoigt::Release::zero_force);
  }
  std::vector<double> acceleration;
  const double period = any(0.3, 0.9);
  for (int n = 0; n <= 300; ++n) {
    const double t = 0.02 * n;
    acceleration.push_back(3 * std::sin(0.2 * std::numbers::pi * t) * std::sin(2 * std::numbers::pi * t / period));
  }
  problem.motion = SampledMotion{0.02, acceleration};
  problem.duration = 6;
  return problem;
}

void expect_near(const std::vector<double>& one, const std::vector<double>& other, const char* what) {
  constexpr double part = 1e-8;  // of the largest
  ASSERT_EQ(one.size(), other.size()) << what;
  double largest = 0;
  for (const double value : other) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], part * largest) << what << ' ' << i;
}

TEST(ManyRows, IslandsAreWhatAllBuildingsAreTogether) {
  std::size_t impacts = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = row(seed);
    const Response one = solve(problem, ExactSolver{}, {.output_step = 0.01});
    // What an account of all energy asks for is stepped together.
    const Response other = solve(problem, ExactSolver{}, {.output_step = 0.01, .energy_audit = true});
    ASSERT_EQ(one.status, Status::done) << one.message;
    ASSERT_EQ(other.status, Status::done) << other.message;
    EXPECT_NE(one.steps, other.steps);
    EXPECT_EQ(one.events, other.events);
    ASSERT_EQ(one.impacts.size(), other.impacts.size());
    impacts += one.impacts.size();
    const auto compare = [&](const char* what, const auto& of) {
      std::vector<double> ours, theirs;
      for (const Impact& impact : one.impacts) ours.push_back(of(impact));
      for (const Impact& impact : other.impacts) theirs.push_back(of(impact));
      expect_near(ours, theirs, what);
    };
    compare("point", [](const Impact& impact) { return static_cast<double>(impact.point); });
    compare("start", [](const Impact& impact) { return impact.start; });
    compare("end", [](const Impact& impact) { return impact.end; });
    compare("closing speed", [](const Impact& impact) { return impact.closing_speed; });
    compare("force", [](const Impact& impact) { return impact.peak_force; });
    compare("impulse", [](const Impact& impact) { return impact.impulse; });
    compare("energy", [](const Impact& impact) { return impact.energy_lost; });
    for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
      const BuildingPeaks &peaks = one.buildings[b], &others = other.buildings[b];
      expect_near({peaks.displacement(0), peaks.displacement_no_contact(0)},
                  {others.displacement(0), others.displacement_no_contact(0)}, "displacement");
      expect_near({peaks.acceleration(0)}, {others.acceleration(0)}, "acceleration");
    }
  }
  EXPECT_GT(impacts, 500U);
}

// The reversed motion by a thread of its own; from rest, so that it is a mirror image, it is not solved without
// contact.
TEST(ManyRows, TwoThreadsFindWhatOneDoes) {
  long reversed_closes = 0;
  for (unsigned seed = 21; seed <= 32; ++seed) {
    SCOPED_TRACE(seed);
    Problem problem = row(seed);
    if (seed % 3 != 0) problem.initial_velocity[0](0) = 0.1;
    if (seed % 4 == 0) {  // nothing closes
      for (ContactPoint& point : problem.points) point.width += 5;
    }
    SolveOptions options{.output_step = 0.01, .both_ways = true};
    const Response alone = solve(problem, ExactSolver{}, options);
    options.beside = in_a_thread;
    const Response beside = solve(problem, ExactSolver{}, options);
    test::expect_same_outcome(alone, beside);
    test::expect_same(alone, beside);
    reversed_closes += alone.reversed->has_contact ? 1 : 0;
  }
  EXPECT_GT(reversed_closes, 4);
  EXPECT_LT(reversed_closes, 12);
}

TEST(ManyRows, TwoThreadsStopWhereOneDoes) {
  const Problem problem = row(5);
  for (const int threads : {1, 2}) {
    for (const double at : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      if (at == 1 && threads == 2) continue;  // the reversed motion may be over by then
      SolveOptions options{.both_ways = true};
      if (threads == 2) options.beside = in_a_thread;
      options.progress = [&, caller = std::this_thread::get_id()](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return fraction < at;
      };
      EXPECT_EQ(solve(problem, ExactSolver{}, options).status, Status::stopped) << threads << " threads, " << at;
    }
  }
}

}  // namespace
}  // namespace bentur::many_rows
