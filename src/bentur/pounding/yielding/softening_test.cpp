// Storeys that lose strength, against closed forms and one solver against another.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "bentur/elements/softening/backbone_law.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::softening_storey {
namespace {

using namespace bentur::test;

class SofteningStorey : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem) const { return solved(problem, GetParam().solver); }
  [[nodiscard]] double within(double scale) const { return 10 * GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, SofteningStorey, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

constexpr double mass = 3, stiffness = 1200, omega = 20;
constexpr double yield_force = 60, at_yield = yield_force / stiffness;

Building oscillator_with(const Backbone& backbone, double zeta = 0, Reloading reloading = Reloading::bilinear) {
  BackboneLaw::Parameters of = {.stiffness = stiffness, .positive = backbone, .negative = backbone};
  of.reloading = reloading;
  return yielding_stick({{mass, stiffness, 2 * zeta * std::sqrt(stiffness * mass), std::make_shared<BackboneLaw>(of)}});
}

TEST_P(SofteningStorey, IsElasticAndPerfectlyPlasticWithoutACap) {
  // ../shared/design/targets.md 1.2 C: triangular pulse, T = 1, η = V_y/peak; 40 digits. T = 2π/ω of the numbers here.
  struct Pulse {
    double duration, eta, ductility;
  };
  const double period = 2 * std::numbers::pi / omega;
  for (const Pulse& pulse : {Pulse{0.3, 0.4, 2.9020939481575},
                             {0.6, 0.6, 3.5945282126787},
                             {1.2, 0.6, 8.0315276518569},
                             {2.0, 0.4, 56.133442220223}}) {
    for (const Reloading reloading : {Reloading::bilinear, Reloading::peak_oriented, Reloading::pinching}) {
      Problem problem = alone(oscillator_with({.yield = yield_force}, 0, reloading), 20 * pulse.duration * period);
      const double peak = yield_force / pulse.eta / mass;
      std::vector<double> samples(41, 0.0);
      samples[1] = -peak;
      problem.motion = SampledMotion{0.5 * pulse.duration * period, samples};
      const BuildingPeaks peaks = run(problem).buildings[0];
      EXPECT_NEAR(peaks.yielding.ductility(0), pulse.ductility, within(pulse.ductility)) << pulse.duration;
      EXPECT_EQ(peaks.yielding.strength_left(0), 1);
      EXPECT_TRUE(std::isnan(peaks.yielding.capped_time(0)));
    }
  }
}

TEST_P(SofteningStorey, StopsWhereItsSpeedHasBeenUsedUpOnTheWayDown) {
  // ½ m v² = the area below the backbone up to the largest drift, on the line that falls from the cap.
  const Backbone falls = {.yield = yield_force, .plastic = 3 * at_yield, .softening = 10 * at_yield, .residual = 0.3};
  const double capped = 4 * at_yield, cap = yield_force, slope = cap / falls.softening;
  const double to_cap = 0.5 * yield_force * at_yield + 0.5 * (yield_force + cap) * falls.plastic;
  for (const double beyond : {0.5, 2.0, 5.0}) {  // of Δ_y
    const double way = beyond * at_yield;
    const double work = to_cap + cap * way - 0.5 * slope * way * way;
    Problem problem = alone(oscillator_with(falls), 3);
    problem.initial_velocity[0](0) = std::sqrt(2 * work / mass);
    const Response response = run(problem);
    const BuildingPeaks& peaks = response.buildings[0];
    EXPECT_NEAR(peaks.yielding.ductility(0), (capped + way) / at_yield, within(50)) << beyond;
    EXPECT_NEAR(peaks.storey_shear(0), cap, within(cap));
    EXPECT_NEAR(peaks.yielding.strength_left(0), 1 - way / falls.softening, within(10));
    EXPECT_FALSE(std::isnan(peaks.yielding.capped_time(0)));
    EXPECT_TRUE(std::isnan(peaks.yielding.residual_time(0)));
    const double back = cap - slope * way;  // unloaded with k, what is left is lost
    EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), work - 0.5 * back * back / stiffness, within(10 * work));
  }
}

TEST_P(SofteningStorey, FallsToNothingWhereItsUltimateDriftIsPassed) {
  // It drops its force at δ_u with the speed that is left of v, and drifts on: x = δ_u + v_u (t − t_u), no force.
  const Backbone fails = {.yield = yield_force, .ultimate = 3 * at_yield};
  Problem problem = alone(oscillator_with(fails), 0.5);
  const double v = 4 * omega * at_yield;
  problem.initial_velocity[0](0) = v;
  const Response response = run(problem);
  const BuildingPeaks& peaks = response.buildings[0];
  const double elastic = std::asin(1.0 / 4) / omega, at_yield_speed = v * std::sqrt(1 - 1.0 / 16);
  const double slowing = yield_force / mass;
  const double speed = std::sqrt(at_yield_speed * at_yield_speed - 2 * slowing * 2 * at_yield);
  const double failed = elastic + (at_yield_speed - speed) / slowing;
  EXPECT_NEAR(peaks.yielding.failed_time(0), failed, within(1));
  EXPECT_NEAR(peaks.displacement(0), 3 * at_yield + speed * (0.5 - failed), within(10));
  EXPECT_EQ(peaks.yielding.strength_left(0), 0);
  // All that was put in is lost, the energy that was stored when it failed with it.
  const double lost = 0.5 * yield_force * at_yield + 2 * at_yield * yield_force;
  EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), lost, within(10 * lost));
}

TEST_P(SofteningStorey, IsElasticWhereItsStrengthIsOutOfReach) {
  Problem elastic = alone(yielding_stick({{mass, stiffness, 0.3, nullptr}}), 4);
  elastic.motion = SampledMotion{0.1, {0.0, 3.0, -4.0, 2.0, 1.0, -3.0, 0.0}};
  Problem problem = elastic;
  problem.buildings[0] =
      oscillator_with({.yield = 1e9, .cap = 1.1, .plastic = 1, .softening = 1}, 0.15 / std::sqrt(3600));
  problem.buildings[0].modal_damping = elastic.buildings[0].modal_damping;
  const double peak = run(elastic).buildings[0].displacement(0);
  EXPECT_NEAR(run(problem).buildings[0].displacement(0), peak, within(peak));
}

}  // namespace
}  // namespace bentur::softening_storey
