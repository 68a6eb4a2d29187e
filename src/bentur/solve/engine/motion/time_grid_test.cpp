#include "bentur/solve/engine/motion/time_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

/// Two buildings under a record that is nowhere level, the right one feeling it `delay` later.
Problem delayed_record(double time_step, double delay) {
  Problem problem = test::pair(test::oscillator(1, 9), test::oscillator(1, 4), {test::contact(1, 1)}, 4);
  SampledMotion motion{time_step, {}};
  for (int i = 0; i < 40; ++i) motion.acceleration.push_back(1 + i + std::sin(1.7 * i));
  problem.motion = motion;
  problem.delays = {0, delay};
  return problem;
}

/// At both ends of every segment each building feels a_g(t − τ). It jumps at the record's ends, so not there.
void expect_delayed(const Problem& problem, double slack) {
  const System system = system_of(problem);
  const TimeGrid grid(system);
  const double step = std::get<SampledMotion>(problem.motion).time_step;
  std::vector<GroundInput> inputs;
  for (long m = 0; grid.start(m) < 60 * step; ++m) {
    grid.input(m, inputs);
    const double start = grid.start(m), length = grid.length(static_cast<std::size_t>(m) % grid.kinds());
    ASSERT_NEAR(grid.start(m + 1), start + length, 1e-13);
    for (std::size_t b = 0; b < 2; ++b) {
      for (const double part : {0.25, 0.75}) {
        const double t = start + part * length;
        ASSERT_NEAR(inputs[b].value + inputs[b].slope * part * length,
                    acceleration_at(problem.motion, t - problem.delays[b]), slack)
            << "building " << b << ", t = " << t << ", delay " << problem.delays[b];
      }
    }
  }
}

TEST(TimeGrid, DelaysOfWholeStepsThatRoundOffMakesAFractionLess) {
  int less = 0;
  for (const double step : {0.005, 0.01, 0.02}) {
    for (int steps = 0; steps < 20; ++steps) {
      const double nearest = steps * step;
      for (const double delay : {std::nextafter(nearest, 0.0), nearest, std::nextafter(nearest, 1.0)}) {
        less += std::floor(delay / step) < steps ? 1 : 0;
        const Problem problem = delayed_record(step, delay);
        EXPECT_EQ(TimeGrid(system_of(problem)).kinds(), 1U) << delay;
        expect_delayed(problem, 1e-11);  // 1e-16 s of a slope of 2/0.005 a second, and values of 40
      }
    }
  }
  EXPECT_GT(less, 20);
}

TEST(TimeGrid, OtherDelaysMakeTwoSegmentsOfAStep) {
  for (const double delay : {0.003, 0.0123, 0.1 / 3, 0.0999}) {
    const Problem problem = delayed_record(0.01, delay);
    EXPECT_EQ(TimeGrid(system_of(problem)).kinds(), 2U);
    expect_delayed(problem, 1e-11);
  }
}

}  // namespace
}  // namespace bentur::engine
