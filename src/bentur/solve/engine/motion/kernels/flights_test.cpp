#include "bentur/solve/engine/motion/kernels/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/random_numbers.h"

namespace bentur::engine::kernels {
namespace {

using test::random_numbers;
using Numbers = std::vector<double>;

// Whichever version the processor has picked gives what plain loops in the same order give, to the bit.

/// Two buildings of four and eight coordinates and a map of random numbers.
struct Two {
  static constexpr Index size = 12;
  const std::vector<CoordinateRange> ranges{{0, 4}, {4, 8}};
  FlightMap map{size};
  std::vector<FlightInput> inputs;
  Two() {
    map.table = random_numbers(map.table.size(), 1);
    for (Index j = 0; j < size; ++j) {
      for (auto column : {FlightMap::qq, FlightMap::qv, FlightMap::vq, FlightMap::vv}) map(j, column) *= 0.4;
    }
    const Numbers ground = random_numbers(100, 9);
    for (std::size_t n = 0; n < 20; ++n) {
      inputs.push_back(
          {ground[5 * n], ground[5 * n + 1], 2.0 + ground[5 * n + 2], 2.0 + ground[5 * n + 3], ground[5 * n + 4]});
    }
  }
};

TEST(Kernels, FlyingOnIsFlyingAgainAndAgain) {
  Two two;
  constexpr Index count = 10;
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(Two::size, count + 1), v = q, acceleration = q, rise = q,
                  acceleration_rise = q;
  const Numbers start = random_numbers(2 * Two::size, 10);
  std::copy_n(start.begin(), Two::size, q.data());
  std::copy_n(start.begin() + Two::size, Two::size, v.data());
  const FlightMap* maps[] = {&two.map};
  const FlightSequence sequence{
      two.ranges,          maps,        two.inputs.data(),        Two::size, q.data(), v.data(),
      acceleration.data(), rise.data(), acceleration_rise.data(), nullptr};
  fly_on(sequence, count);
  Eigen::VectorXd from = q.col(0), speed = v.col(0), to(Two::size), to_speed(Two::size), to_acceleration(Two::size),
                  rises(Two::size), acceleration_rises(Two::size);
  for (Index n = 0; n < count; ++n) {
    for (std::size_t b = 0; b < 2; ++b) {
      const FlightInput& input = two.inputs[2 * static_cast<std::size_t>(n) + b];
      fly(two.map, two.ranges[b], input,
          {from.data(), speed.data(), to.data(), to_speed.data(), to_acceleration.data(), rises.data(),
           acceleration_rises.data()});
      for (Index j = two.ranges[b].begin; j < two.ranges[b].begin + two.ranges[b].size; ++j) {
        EXPECT_EQ(to_acceleration(j), input.end * two.map(j, FlightMap::gamma) -
                                          two.map(j, FlightMap::omega_squared) * to(j) -
                                          two.map(j, FlightMap::two_sigma) * to_speed(j));
      }
    }
    EXPECT_EQ(q.col(n + 1), to);
    EXPECT_EQ(v.col(n + 1), to_speed);
    EXPECT_EQ(acceleration.col(n + 1), to_acceleration);
    EXPECT_EQ(rise.col(n), rises);
    EXPECT_EQ(acceleration_rise.col(n), acceleration_rises);
    from = to;
    speed = to_speed;
  }
}

}  // namespace
}  // namespace bentur::engine::kernels
