// Frames whose hinges lose strength, by turning far and by repetition, beside a wall: by Runge-Kutta steps as by the
// series, and the gap that they need.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bentur/pounding/pounding.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/support.h"
#include "tests/support/small_buildings.h"

namespace bentur::weakening_frames {
namespace {

using namespace bentur::test;

/// Two bays and two storeys shaken for a while beside a wall.
Problem weakening(const HingeBackbone& backbone, double gap) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {3.5, 3};
  frame.bay_widths = {5, 4};
  frame.columns = {{.area = 0.1, .inertia = 2e-3}, {.area = 0.1, .inertia = 1.5e-3}};
  frame.beams = {{.area = 0.1, .inertia = 3e-3}, {.area = 0.1, .inertia = 2e-3}};
  frame.columns[0].moment_capacity = {130, 170, 120};
  frame.columns[1].moment_capacity = {80, 110, 85};
  frame.beams[0].moment_capacity = {97, 121};
  frame.beams[1].moment_capacity = {71};
  for (auto* list : {&frame.columns, &frame.beams}) {
    for (Section& section : *list) {
      section.hardening = 0.01;
      section.backbone = backbone;
    }
  }
  frame.floor_masses = {60, 50};
  frame.mass_matrix = MassMatrix::lumped;
  const Building building =
      make_building("frame", plane_frame_model(frame), RayleighDamping{{0.05, 0.05}, {0.4, 0.15}});
  Problem problem = pair(building, rigid_building("wall", {3.5, 6.5}), {contact(gap, 4e5, 0), contact(gap, 4e5, 1)}, 4);
  std::vector<double> record(200);
  for (std::size_t n = 0; n < record.size(); ++n) {
    const double t = 0.02 * static_cast<double>(n);
    record[n] = -6 * std::exp(-0.3 * t) * std::sin(13 * t) - 3 * std::sin(5.1 * t) * std::exp(-0.2 * t);
  }
  problem.motion = SampledMotion{0.02, record};
  return problem;
}

HingeBackbone falling(double wear) { return {.plastic = 0.006, .softening = 0.06, .residual = 0.2, .wear = wear}; }

constexpr double never = std::numeric_limits<double>::infinity();

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

/// Of the hinges the number that came to their cap, and what is left of the weakest.
std::pair<long, double> weakened(const Response& response) {
  const auto& hinges = response.buildings[0].hinges;
  double least = 1;
  for (const BuildingPeaks::Hinge& hinge : hinges) least = std::min(least, hinge.strength_left.value());
  return {std::count_if(hinges.begin(), hinges.end(), [](const auto& of) { return of.cap_time.has_value(); }), least};
}

TEST(WeakeningFrames, AreTheSameByRungeKuttaSteps) {
  const Problem problem = weakening(falling(8), 0.01);
  const Response exact = solve(problem, ExactSolver{});
  ASSERT_EQ(exact.status, Status::done) << exact.message;
  EXPECT_GE(weakened(exact).first, 3);
  EXPECT_GT(exact.impacts.size(), 3U);
  const Response steps = solve(problem, RungeKuttaSolver{2e-4});
  ASSERT_EQ(steps.impacts.size(), exact.impacts.size());
  for (std::size_t n = 0; n < exact.impacts.size(); ++n) {
    EXPECT_NEAR(steps.impacts[n].start, exact.impacts[n].start, 1e-6) << n;
    EXPECT_NEAR(steps.impacts[n].peak_force, exact.impacts[n].peak_force, 1e-5 * exact.points[1].peak_force) << n;
  }
  EXPECT_LT(difference(exact.buildings[0].displacement, steps.buildings[0].displacement), 1e-6);
  EXPECT_LT(difference(exact.buildings[0].storey_shear, steps.buildings[0].storey_shear), 1e-5);
  for (std::size_t h = 0; h < exact.buildings[0].hinges.size(); ++h) {
    const BuildingPeaks::Hinge &one = exact.buildings[0].hinges[h], &other = steps.buildings[0].hinges[h];
    EXPECT_NEAR(one.strength_left.value(), other.strength_left.value(), 1e-5) << h;
    EXPECT_NEAR(one.peak_moment, other.peak_moment, 1e-5 * one.peak_moment) << h;
  }
}

TEST(WeakeningFrames, NeedTheGapBelowWhichTheyStrike) {
  std::vector<double> needed;
  for (const HingeBackbone& backbone : {HingeBackbone{}, falling(never), falling(8)}) {
    const Response free = solve(weakening(backbone, 10), ExactSolver{});
    EXPECT_TRUE(free.impacts.empty());
    const double gap = std::max(free.points[0].gap_needed, free.points[1].gap_needed);
    for (const double share : {1 - 1e-9, 1 + 1e-9}) {
      const Response response = solve(weakening(backbone, share * gap), ExactSolver{});
      EXPECT_EQ(response.impacts.empty(), share > 1) << share;
      EXPECT_EQ(std::max(response.points[0].gap_needed, response.points[1].gap_needed), gap);
    }
    needed.push_back(gap);
  }
  EXPECT_GT(std::abs(needed[1] / needed[0] - 1), 0.02) << needed[0] << " " << needed[1];
  EXPECT_GT(std::abs(needed[2] / needed[1] - 1), 0.02) << needed[1] << " " << needed[2];
}

}  // namespace
}  // namespace bentur::weakening_frames
