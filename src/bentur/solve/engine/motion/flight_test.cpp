// What cubics are said to leave of a flight, held against the flight itself at places in between.
#include "bentur/solve/engine/motion/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "bentur/pounding/assemble.h"
#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int halvings = 5;
constexpr int places = 1 << halvings;

/// A cubic on [0, 1] by values and slopes at both ends.
double cubic(double s, double start, double end, double slope, double slope_end) {
  const double r = 1 - s;
  return start * r * r * (1 + 2 * s) + end * s * s * (3 - 2 * s) + slope * s * r * r - slope_end * s * s * r;
}

/// The first building of a system through flights, and what cubics say of it.
struct Flown {
  const ModalSystem& system;
  VectorXd q, v, acceleration;

  Flown(const ModalSystem& of, const GroundInput& ground, VectorXd q_start, VectorXd v_start)
      : system(of), q(std::move(q_start)), v(std::move(v_start)), acceleration(of.size) {
    acceleration = of.gamma.col(0) * ground.value - of.omega_squared.cwiseProduct(q) - of.two_sigma.cwiseProduct(v);
  }
  /// `rise` and `acceleration_rise` are those of chords.
  void fly(const Flight& flight, const GroundInput& ground, VectorXd& rise, VectorXd& acceleration_rise) {
    VectorXd q_end = q, v_end = v;
    flight.advance(
        0, &ground,
        {q.data(), v.data(), q_end.data(), v_end.data(), acceleration.data(), rise.data(), acceleration_rise.data()});
    q = q_end;
    v = v_end;
  }
};

TEST(Flight, StaysAsNearToItsCubicsAsIsSaid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  int nearer = 0, looked = 0;
  double nearest_to_bound = 0;
  for (int n = 0; n < 600; ++n) {
    const double frequency = std::pow(10.0, 1.5 * number(random));  // of a flight of 1 s [rad/s]: 0.03 to 30
    const double damping = n % 4 == 0 ? 0.0 : 0.3 * std::abs(number(random)) * (n % 7 == 0 ? 5.0 : 1.0);
    const Problem problem =
        test::pair(test::oscillator(1, frequency * frequency, damping), test::oscillator(1, 1), {}, 1);
    const System given = system_of(problem);
    const ModalSystem system(given);
    const std::vector<Flight> flights = Flight::make(system, 1.0, halvings);
    const GroundInput ground{number(random), 3 * number(random)};
    VectorXd q = VectorXd::Zero(system.size), v = q;
    for (const Index j : {Index{0}, Index{1}}) {  // its mode and its ground
      q(j) = number(random) / (frequency * frequency);
      v(j) = number(random) / frequency;
    }
    const Flown start(system, ground, q, v);
    Flown end = start;
    VectorXd rise = VectorXd::Zero(system.size), acceleration_rise = rise, scratch = rise, acceleration_scratch = rise;
    end.fly(flights.front(), ground, rise, acceleration_rise);
    const VectorXd of_chord = rise, acceleration_of_chord = acceleration_rise;
    VectorXd slopes[4] = {rise, rise, rise, rise};
    flights.front().fit_cubics(0, &ground,
                               {start.q.data(), start.v.data(), start.acceleration.data(), end.q.data(), end.v.data(),
                                end.acceleration.data(), rise.data(), acceleration_rise.data(), slopes[0].data(),
                                slopes[1].data(), slopes[2].data(), slopes[3].data()});
    Flown at = start;
    GroundInput input = ground;
    for (int place = 1; place < places; ++place) {
      at.fly(flights.back(), input, scratch, acceleration_scratch);
      input = input.later(1.0 / places, 0.0);
      const double s = static_cast<double>(place) / places;
      for (Index j = 0; j < system.blocks[0].padded_size; ++j) {
        const double size = start.q.cwiseAbs().maxCoeff() + start.v.cwiseAbs().maxCoeff() + 4;
        const double off = std::abs(at.q(j) - cubic(s, start.q(j), end.q(j), slopes[0](j), slopes[1](j)));
        EXPECT_LE(off, rise(j) + 1e-14 * size) << n << " " << s;
        // q̈ is what is left of terms as large as Ω²q.
        const double acceleration_off = std::abs(
            at.acceleration(j) - cubic(s, start.acceleration(j), end.acceleration(j), slopes[2](j), slopes[3](j)));
        EXPECT_LE(acceleration_off, acceleration_rise(j) + 1e-13 * size * (1 + frequency * frequency)) << n << " " << s;
        if (j == 0 && acceleration_rise(j) < acceleration_of_chord(j)) {
          nearest_to_bound = std::max(nearest_to_bound, acceleration_off / acceleration_rise(j));
        }
      }
    }
    ASSERT_LE(rise(0), of_chord(0));
    looked += frequency < 1 ? 1 : 0;
    nearer += frequency < 1 && rise(0) < 0.1 * of_chord(0) && acceleration_rise(0) < 0.1 * acceleration_of_chord(0);
  }
  EXPECT_GT(looked, 200);
  EXPECT_EQ(nearer, looked);         // of slow ones they are worth it
  EXPECT_GT(nearest_to_bound, 0.9);  // and the bound is no more than it must be
}

}  // namespace
}  // namespace bentur::engine
