// Two three-storey buildings after [Jankowski2008] under El Centro: storeys that yield, with and without pounding.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "bentur/contact/laws.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::yielding_pair {
namespace {

using namespace bentur::test;

/// The record of data/, given in g = 9.81 m/s².
SampledMotion el_centro() {
  SampledMotion motion{0.02, {}};
  std::ifstream file(BENTUR_SOURCE_DIR "/data/el-centro-1940-ns.csv");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) motion.acceleration.push_back(9.81 * std::stod(line.substr(line.find(',') + 1)));
  EXPECT_GT(motion.acceleration.size(), 1000u);
  return motion;
}

/// Three storeys of one kind [kg, N/m, N s/m, N].
Building three_storeys(double mass, double stiffness, double dashpot, double yield_force) {
  const StickStorey storey{mass, stiffness, dashpot, yield_force > 0 ? bilinear_law(stiffness, yield_force) : nullptr};
  return yielding_stick({storey, storey, storey});
}

Problem jankowski_pair(bool yields, const std::string& law, const LawInput& input) {
  Problem problem = pair(three_storeys(25e3, 3.46e6, 6.609e4, yields ? 1.369e5 : 0),
                         three_storeys(1e6, 2.215e9, 1.058e7, yields ? 1.442e7 : 0), {}, 20);
  for (int floor = 0; floor < 3; ++floor) {
    problem.points.push_back(contact(0.02, 1, floor));
    problem.points.back().law = find_law(law)->make(input);
  }
  problem.motion = el_centro();
  return problem;
}

Problem nonlinear_pair(bool yields) {
  return jankowski_pair(yields, "jankowski",
                        {{{"stiffness", 2.75e9}, {"damping_ratio", 0.35}}, {}, 25e3 * 1e6 / (25e3 + 1e6)});
}
Problem linear_pair(bool yields) { return jankowski_pair(yields, "linear", {{{"stiffness", 1e8}}, {}, 1}); }

// Digits as computed by a program of another kind (fixed small steps, events by bisection), and by OpenSees to 5e-6.
struct Printed {
  double left[3], right[3];          ///< peak displacements [m]
  double left_offset, right_offset;  ///< of the lowest storey [m]
};

void expect_buildings(const Response& response, const Printed& printed, bool free) {
  for (Eigen::Index floor = 0; floor < 3; ++floor) {
    const auto peak = [&](std::size_t b) {
      return (free ? response.buildings[b].displacement_no_contact : response.buildings[b].displacement)(floor);
    };
    EXPECT_NEAR(peak(0), printed.left[floor], 1e-7) << floor;
    EXPECT_NEAR(peak(1), printed.right[floor], 1e-7) << floor;
  }
  const auto offset = [&](std::size_t b) {
    const BuildingPeaks& peaks = response.buildings[b];
    return (free ? peaks.yielding_no_contact : peaks.yielding).residual_drift_ratio(0);  // storeys of 1 m
  };
  EXPECT_NEAR(offset(0), printed.left_offset, 1e-7);
  EXPECT_NEAR(offset(1), printed.right_offset, 1e-7);
}

void expect_contacts(const Response& response, const std::vector<int>& impacts, const std::vector<double>& forces,
                     double accuracy) {
  ASSERT_EQ(response.points.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(response.points[i].impacts, impacts[i]) << i;
    EXPECT_NEAR(response.points[i].peak_force, forces[i], accuracy * forces[i]) << i;
  }
}

const std::vector<Solver> both = {ExactSolver{}, AdaptiveSolver{1e-11}};

TEST(YieldingPair, MeetsLinearContactAsOtherProgramsDo) {
  for (const Solver& solver : both) {
    const Response response = solved(linear_pair(true), solver);
    expect_buildings(
        response, {{0.0527612, 0.0886744, 0.1127396}, {0.0095011, 0.0151384, 0.0185040}, 0.0131948, 0.0011677}, true);
    expect_buildings(
        response, {{0.1366662, 0.1636007, 0.1777551}, {0.0093994, 0.0150160, 0.0183675}, -0.0830137, 0.0010269}, false);
    expect_contacts(response, {3, 4, 6}, {243037, 775343, 968227}, 2e-6);
    EXPECT_NEAR(response.buildings[0].yielding.residual_drift_ratio(1), 0.0004598, 1e-7);
    EXPECT_NEAR(response.buildings[0].yielding.ductility(0), 3.454, 1e-3);
    EXPECT_NEAR(response.buildings[1].yielding.ductility(0), 1.444, 1e-3);
    EXPECT_GE(response.buildings[0].yielding.hysteretic_energy.minCoeff(), 0);
  }
}

TEST(YieldingPair, MeetsNonlinearContactAsAnotherProgramDoes) {
  for (const Solver& solver : both) {
    const Response response = solved(nonlinear_pair(true), solver);
    expect_buildings(
        response, {{0.0698642, 0.1003943, 0.1208509}, {0.0093761, 0.0149801, 0.0183034}, -0.0302977, 0.0010184}, false);
    expect_contacts(response, {1, 6, 12}, {125390, 768369, 1239461}, 1e-4);  // the peak of steps
    EXPECT_NEAR(response.buildings[0].yielding.ductility(0), 1.766, 1e-3);
    EXPECT_NEAR(response.buildings[1].yielding.ductility(0), 1.440, 1e-3);
  }
}

TEST(YieldingPair, IsTheElasticOneWithYieldForcesOutOfReach) {
  const Problem elastic = linear_pair(false);
  Problem strong = linear_pair(true);
  for (std::size_t b = 0; b < 2; ++b) {
    for (auto& one : strong.buildings[b].elements) one.law = bilinear_law(one.law->initial_stiffness(), 1e10, 0.03);
  }
  for (const Solver& solver : both) {
    const double tolerance = std::holds_alternative<ExactSolver>(solver) ? 1e-12 : 1e-8;
    const Response one = solved(elastic, solver), other = solved(strong, solver);
    ASSERT_EQ(one.impacts.size(), other.impacts.size());
    for (std::size_t i = 0; i < one.impacts.size(); ++i) {
      EXPECT_NEAR(one.impacts[i].start, other.impacts[i].start, 20 * tolerance);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(one.points[i].peak_force, other.points[i].peak_force, 100 * tolerance * one.points[i].peak_force);
    }
    for (std::size_t b = 0; b < 2; ++b) {
      const BuildingPeaks &a = one.buildings[b], &z = other.buildings[b];
      for (Eigen::Index floor = 0; floor < 3; ++floor) {
        EXPECT_NEAR(a.displacement(floor), z.displacement(floor), tolerance * a.displacement(floor));
        EXPECT_NEAR(a.displacement_no_contact(floor), z.displacement_no_contact(floor),
                    tolerance * a.displacement_no_contact(floor));
        EXPECT_NEAR(a.drift_ratio(floor), z.drift_ratio(floor), tolerance * a.drift_ratio(floor));
        EXPECT_NEAR(a.storey_shear(floor), z.storey_shear(floor), tolerance * a.storey_shear(floor));
        EXPECT_NEAR(a.acceleration(floor), z.acceleration(floor), 100 * tolerance * a.acceleration(floor));
        EXPECT_LT(z.yielding.ductility(floor), 1);
        EXPECT_EQ(z.yielding.residual_drift_ratio(floor), 0);
        EXPECT_EQ(z.yielding.hysteretic_energy(floor), 0);
      }
      EXPECT_EQ(a.yielding.ductility.size(), 0);
    }
  }
}

TEST(YieldingPair, IsTheSameInAMirror) {
  for (const Problem& problem : {linear_pair(true), nonlinear_pair(true)}) {
    Problem mirrored = problem;
    std::swap(mirrored.buildings[0], mirrored.buildings[1]);
    auto& motion = std::get<SampledMotion>(mirrored.motion);
    for (double& a : motion.acceleration) a = -a;
    for (const Solver& solver : both) {
      const Response one = solved(problem, solver), other = solved(mirrored, solver);
      ASSERT_EQ(one.impacts.size(), other.impacts.size());
      for (std::size_t i = 0; i < one.impacts.size(); ++i) {
        EXPECT_NEAR(one.impacts[i].start, other.impacts[i].start, 1e-9);
        EXPECT_NEAR(one.impacts[i].peak_force, other.impacts[i].peak_force, 1e-6 * one.impacts[i].peak_force);
      }
      for (std::size_t b = 0; b < 2; ++b) {
        const BuildingPeaks &a = one.buildings[b], &z = other.buildings[1 - b];
        for (Eigen::Index floor = 0; floor < 3; ++floor) {
          EXPECT_NEAR(a.displacement(floor), z.displacement(floor), 1e-8 * a.displacement(floor));
          EXPECT_NEAR(a.yielding.residual_drift_ratio(floor), -z.yielding.residual_drift_ratio(floor),
                      1e-8 * a.displacement(2));
          EXPECT_NEAR(a.yielding.ductility(floor), z.yielding.ductility(floor), 1e-8 * a.yielding.ductility(floor));
        }
      }
    }
  }
}

}  // namespace
}  // namespace bentur::yielding_pair
