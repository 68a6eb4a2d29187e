#include "bentur/solve/engine/motion/time_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bentur/solve/engine/motion/step_buffer.h"
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
    for (std::size_t b = 0; b < inputs.size(); ++b) {
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

// What is worked out once is what each of them feels, in the grid and in the plan of its flights.
TEST(TimeGrid, BodiesThatTheGroundMovesTogetherShareTheirInputs) {
  Problem problem = delayed_record(0.01, 0.0123);
  for (const double delay : {0.0, 0.05, 0.0123}) {
    problem.buildings.push_back(test::oscillator(1, 5));
    problem.delays.push_back(delay);
    problem.initial_displacement.emplace_back(Eigen::VectorXd::Zero(1));
    problem.initial_velocity.emplace_back(Eigen::VectorXd::Zero(1));
  }
  expect_delayed(problem, 1e-11);
  const System given = system_of(problem);
  const TimeGrid grid(given);
  const std::vector<std::size_t> first{0, 1, 0, 3, 1};
  for (std::size_t b = 0; b < first.size(); ++b) EXPECT_EQ(grid.first_with(b), first[b]);
  const ModalSystem system(given);
  const FlightPlan plan(system, grid, 0.5, true);
  ASSERT_GT(plan.segments, 90);
  ASSERT_EQ(plan.inputs.size(), static_cast<std::size_t>(plan.segments) * first.size());
  std::vector<GroundInput> inputs;
  for (long m = 0; m < plan.segments; ++m) {
    grid.input(m, inputs);
    const Flight& flight = plan.flights[static_cast<std::size_t>(m) % grid.kinds()].front();
    for (std::size_t b = 0; b < first.size(); ++b) {
      const kernels::FlightInput own = flight.input(inputs[b], 0.0);
      const kernels::FlightInput& planned = plan.inputs[static_cast<std::size_t>(m) * first.size() + b];
      EXPECT_EQ(planned.value, own.value);
      EXPECT_EQ(planned.slope, own.slope);
      EXPECT_EQ(planned.end, own.end);
    }
  }
}

}  // namespace
}  // namespace bentur::engine
