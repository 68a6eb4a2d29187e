#include "bentur/solve/motion/kernels/flights.h"

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
  const std::vector<Room> rooms{{0, 4}, {4, 8}};
  FlightMap map{size};
  Lumped lumped;
  std::vector<FlightInput> inputs;
  Two() {
    map.table = random_numbers(map.table.size(), 1);
    for (Index j = 0; j < size; ++j) {
      for (auto column : {FlightMap::qq, FlightMap::qv, FlightMap::vq, FlightMap::vv}) map(j, column) *= 0.4;
    }
    unsigned seed = 2;
    for (auto* list : {&lumped.positions, &lumped.accelerations, &lumped.as_left, &lumped.as_right}) {
      const Numbers numbers = random_numbers(size, seed++);
      *list = Eigen::Map<const Eigen::VectorXd>(numbers.data(), size).cwiseAbs();
    }
    const Numbers ground = random_numbers(100, 9);
    for (std::size_t n = 0; n < 20; ++n) {
      inputs.push_back({ground[5 * n], ground[5 * n + 1], 2.0 + ground[5 * n + 2], 2.0 + ground[5 * n + 3], 0.0});
    }
  }
};

TEST(Kernels, FlyingOnIsFlyingAgainAndAgain) {
  Two two;
  constexpr Index count = 10;
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(Two::size, count + 1), v = q, rise = q, acceleration_rise = q;
  const Numbers start = random_numbers(2 * Two::size, 10);
  std::copy_n(start.begin(), Two::size, q.data());
  std::copy_n(start.begin() + Two::size, Two::size, v.data());
  two.lumped.as_left *= 1e-3;  // so that a few legs stay below 1
  two.lumped.as_right *= 1e-3;
  const FlightMap* maps[] = {&two.map};
  const Legs legs{two.rooms, maps,     two.inputs.data(), Two::size,
                  q.data(),  v.data(), rise.data(),       acceleration_rise.data()};
  const Index flown = fly_on(legs, count, two.lumped);
  Rises rises{Eigen::VectorXd(Two::size), Eigen::VectorXd(Two::size)};
  Eigen::VectorXd from = q.col(0), speed = v.col(0), to(Two::size), to_speed(Two::size);
  Index expected = 0;
  for (; expected < count; ++expected) {
    Sums sums[2];
    for (std::size_t b = 0; b < 2; ++b) {
      sums[b] = fly(two.map, two.rooms[b], two.inputs[2 * static_cast<std::size_t>(expected) + b], from.data(),
                    speed.data(), to.data(), to_speed.data(), two.lumped, rises);
    }
    EXPECT_EQ(q.col(expected + 1), to);
    EXPECT_EQ(v.col(expected + 1), to_speed);
    EXPECT_EQ(rise.col(expected), rises.position);
    EXPECT_EQ(acceleration_rise.col(expected), rises.acceleration);
    from = to;
    speed = to_speed;
    if (!(sums[0].as_left + sums[1].as_right < 1.0)) break;
  }
  EXPECT_EQ(flown, expected);
  two.lumped.as_right *= 1e6;
  EXPECT_EQ(fly_on(legs, count, two.lumped), 0);
  two.lumped.as_left.setZero();
  two.lumped.as_right.setZero();
  EXPECT_EQ(fly_on(legs, count, two.lumped), count);
}

TEST(Kernels, SumsOfAStretchAreOfTheSmallerBounds) {
  const Two two;
  const Numbers q = random_numbers(Two::size, 1), q_end = random_numbers(Two::size, 2),
                curved = random_numbers(Two::size, 3), curved_end = random_numbers(Two::size, 4);
  Numbers second = random_numbers(Two::size, 5), fourth = random_numbers(Two::size, 6);
  for (double& x : second) x = std::abs(x);
  for (double& x : fourth) x = std::abs(x);
  const double end = 0.7, h = 0.3;
  const Stretch stretch{q.data(), q_end.data(), curved.data(), curved_end.data(), second.data(), fourth.data(), end, h};
  for (const Room& room : two.rooms) {
    const Sums sums = sum_up(room, stretch, two.lumped);
    Sums expected;
    for (Index j = room.begin; j < room.begin + room.size; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const double chord = end * end / 8.0;
      const double position = std::max(std::abs(q[at]), std::abs(q_end[at])) + chord * second[at];
      const double acceleration =
          std::min(second[at], std::max(std::abs(curved[at]), std::abs(curved_end[at])) + chord * fourth[at]) / (h * h);
      expected.positions += two.lumped.positions(j) * position;
      expected.accelerations += two.lumped.accelerations(j) * acceleration;
      expected.as_left += two.lumped.as_left(j) * position;
      expected.as_right += two.lumped.as_right(j) * position;
    }
    EXPECT_NEAR(sums.positions, expected.positions, 1e-14 * expected.positions);
    EXPECT_NEAR(sums.accelerations, expected.accelerations, 1e-14 * expected.accelerations);
    EXPECT_NEAR(sums.as_left, expected.as_left, 1e-14 * expected.as_left);
    EXPECT_NEAR(sums.as_right, expected.as_right, 1e-14 * expected.as_right);
  }
}

}  // namespace
}  // namespace bentur::engine::kernels
