#include "bentur/model/closer/floor_spectra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

constexpr double of_stiffness = 2e-3;  // C = 0.002 s K: every storey has a dashpot of its own

/// A storey that strikes a wall, and on it, where `period` is given, an oscillator so light that the storey does not
/// feel it.
Problem beside_a_wall(std::shared_ptr<const ContactLaw> law, double period = 0) {
  const double omega = period > 0 ? 2 * std::numbers::pi / period : 0, light = 1e-7;
  const Eigen::Index floors = period > 0 ? 2 : 1;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Constant(floors, floors, 0), stiffness = mass;
  mass(0, 0) = 100;
  stiffness(0, 0) = 9e3;
  if (period > 0) {
    const double k = light * omega * omega;
    mass(1, 1) = light;
    stiffness += k * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  }
  const Eigen::MatrixXd dashpots = of_stiffness * stiffness;
  Problem problem = test::pair(test::wall(), test::matrix_building(mass, stiffness, dashpots),
                               {test::contact(0.02, std::move(law))}, 6);
  problem.motion = HarmonicMotion{.period = 0.7, .displacement_amplitude = 0.04};
  return problem;
}

/// What stands on a floor is solved with the building, as a storey more: its largest drift is the spectrum's. Of
/// impacts of 30 ms and of those that take no time, whose acceleration no sample shows.
TEST(FloorSpectra, AreThoseOfAnOscillatorThatStandsOnTheFloor) {
  for (const std::shared_ptr<const ContactLaw>& law :
       {std::shared_ptr<const ContactLaw>(std::make_shared<Linear>(2e5)),
        std::shared_ptr<const ContactLaw>(std::make_shared<Restitution>(0.6))}) {
    const Problem alone = beside_a_wall(law);
    const Response run = solve(alone, ExactSolver{}, {.output_step = 5e-4});
    ASSERT_GT(run.impacts.size(), 3U);
    for (const double period : {0.031, 0.05, 0.11, 0.3, 0.9}) {
      const double omega = 2 * std::numbers::pi / period, damping = of_stiffness * omega / 2;
      const double found = floor_spectrum(5e-4, floor_speed(run.histories, alone, 1, 0), {period}, damping).front();
      const Response both = solve(beside_a_wall(law, period));
      const double expected = omega * omega * both.buildings[1].drift_ratio(1);
      EXPECT_NEAR(found, expected, 3e-3 * expected)
          << law->name() << ", " << period;  // the means, what lies between samples
    }
  }
}

/// Hard against the wall the floor's own acceleration is left to what is stiff.
TEST(FloorSpectra, OfShortPeriodsAreTheFloorsAcceleration) {
  Problem calm = beside_a_wall(std::make_shared<Linear>(2e5));
  calm.points.clear();
  const Response run = solve(calm, ExactSolver{}, {.output_step = 5e-4});
  const double found = floor_spectrum(5e-4, floor_speed(run.histories, calm, 1, 0), {0.03}, 0.05).front();
  EXPECT_NEAR(found, run.buildings[1].acceleration(0), 0.01 * found);  // (0.03 s/0.66 s)² of it and the ground's start
}

/// A step of the periods is so small a part of the bandwidth 2ζ that an oscillator's own peak,
///   |H(T)| / |H(T_n)| = 1 / √(1 + ((T_n/T)² − 1)² / (2ζ)²) about,
/// is met within 1 %, and the periods of the buildings themselves stand among them.
TEST(FloorSpectra, PeriodsAreNearEnoughToMeetPeaks) {
  const Problem problem = beside_a_wall(std::make_shared<Linear>(2e5), 0.3);
  const std::vector<double> periods = spectrum_periods({problem.buildings[1].modes.omega}, 0.02, 4);
  EXPECT_EQ(periods.front(), 0.02);
  EXPECT_NEAR(periods.back(), 4, 1e-12);
  for (std::size_t i = 0; i + 1 < periods.size(); ++i) {
    ASSERT_LT(periods[i], periods[i + 1]);
    const double apart = std::sqrt(periods[i + 1] / periods[i]);  // from the middle between the two
    const double off = (apart * apart - 1) / (2 * 0.05);
    EXPECT_LT(1 - 1 / std::sqrt(1 + off * off), 0.01) << periods[i];
  }
  for (const double omega : problem.buildings[1].modes.omega) {
    const double period = 2 * std::numbers::pi / omega;
    const auto next = std::lower_bound(periods.begin(), periods.end(), period * (1 - 2e-6));
    ASSERT_NE(next, periods.end());
    EXPECT_NEAR(*next, period, 2e-6 * period);  // of two so near to one another the first stays
  }
}

TEST(FloorSpectra, FloorsAreThoseThatAreHitAndTheRoofs) {
  const Problem problem = beside_a_wall(std::make_shared<Linear>(2e5), 0.3);
  const std::vector<FloorSpectra::Floor> floors = spectrum_floors(problem, solve(problem));
  ASSERT_EQ(floors.size(), 3U);  // of the wall its only floor
  EXPECT_EQ(floors[1].floor, 1);
  EXPECT_EQ(floors[2].floor, 0);
  Problem calm = problem;
  calm.points.clear();
  EXPECT_EQ(spectrum_floors(calm, solve(calm)).size(), 2U);
}

}  // namespace
}  // namespace bentur
