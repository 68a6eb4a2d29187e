#include "bentur/solve/spectrum/response_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using std::numbers::pi;

/// Round-off: about 1e-16 a step of the record, a thousand steps, most of it damped away.
constexpr double round_off = 1e-12;

SampledMotion noise(double time_step, int count, unsigned seed, double memory = 0.9) {
  std::mt19937_64 generator(seed);
  SampledMotion motion{time_step, {}};
  double level = 0;
  for (int i = 0; i < count; ++i) {  // coloured, so that long periods are excited too
    level = memory * level + static_cast<double>(generator() >> 11U) * 0x1p-53 - 0.5;
    motion.acceleration.push_back(3 * level);
  }
  return motion;
}

/// Peaks of one oscillator by the solver, run on for a period after the record.
OscillatorPeaks by_solver(const SampledMotion& motion, double period, double damping_ratio) {
  const double omega = 2 * pi / period;
  Problem problem =
      test::pair(test::oscillator(1.0, omega * omega, damping_ratio), test::wall(), {test::contact(1e6, 1.0)}, 0.0);
  problem.motion = motion;
  problem.duration = motion.time_step * static_cast<double>(motion.acceleration.size() - 1) + period;
  const Response response = solve(problem);
  EXPECT_EQ(response.status, Status::done);
  return {.displacement = response.buildings[0].displacement(0),
          .absolute_acceleration = response.buildings[0].acceleration(0)};
}

TEST(ResponseSpectrum, IsThatOfTheSolverWithOneOscillator) {
  const SampledMotion motion = noise(0.01, 800, 1);
  for (const double ratio : {0.0, 0.02, 0.05, 0.4, 0.97}) {
    for (const double period : {0.011, 0.04, 0.1, 0.333, 1.0, 2.7, 9.0, 40.0}) {
      const OscillatorPeaks mine = oscillator_peaks(motion, period, ratio);
      const OscillatorPeaks solver = by_solver(motion, period, ratio);
      EXPECT_NEAR(mine.displacement / solver.displacement, 1, 1e-11) << period << " s, " << ratio;
      EXPECT_NEAR(mine.absolute_acceleration / solver.absolute_acceleration, 1, 1e-11) << period << " s, " << ratio;
      EXPECT_DOUBLE_EQ(mine.pseudo_velocity, 2 * pi / period * mine.displacement);
      EXPECT_DOUBLE_EQ(mine.pseudo_acceleration, 4 * pi * pi / (period * period) * mine.displacement);
    }
  }
}

// With much damping the largest acceleration need not be where displacements are large: of these four hundred, a dozen
// have it between samples, in a step over which displacements stay well below their peak.
TEST(ResponseSpectrum, FindsAccelerationsBetweenSamplesThatNoDisplacementPointsTo) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const SampledMotion motion = noise(0.02, 60, seed, 0.5);
    for (const auto& [period, ratio] : {std::pair{0.25, 0.6}, std::pair{0.6, 0.9}}) {
      const OscillatorPeaks mine = oscillator_peaks(motion, period, ratio), solver = by_solver(motion, period, ratio);
      EXPECT_NEAR(mine.absolute_acceleration / solver.absolute_acceleration, 1, 1e-11)
          << seed << ", " << period << " s";
      EXPECT_NEAR(mine.displacement / solver.displacement, 1, 1e-11) << seed << ", " << period << " s";
    }
  }
}

// a_g = a from t = 0 on: x = −(a/ω²)(1 − e^{−ζωt}(cos ω_d t + ζω/ω_d sin ω_d t)), the largest at t = π/ω_d.
TEST(ResponseSpectrum, StepOfTheGround) {
  const SampledMotion step{0.02, std::vector<double>(1001, 1.7)};
  for (const double ratio : {0.02, 0.05, 0.3, 0.9}) {
    for (const double period : {0.05, 0.3, 1.7, 6.0}) {
      const double omega = 2 * pi / period;
      const double overshoot = std::exp(-ratio * pi / std::sqrt(1 - ratio * ratio));
      EXPECT_NEAR(oscillator_peaks(step, period, ratio).displacement, 1.7 / (omega * omega) * (1 + overshoot),
                  round_off * 1.7 / (omega * omega))
          << period << " s, " << ratio;
    }
  }
}

// Undamped under a_g = r t until the end at t₁: x = −(r/ω³)(ωt − sin ωt), monotone; then a free vibration about zero.
TEST(ResponseSpectrum, RampOfTheGroundAndTheFreeVibrationAfterIt) {
  SampledMotion ramp{0.05, {}};
  for (int i = 0; i <= 13; ++i) ramp.acceleration.push_back(0.2 * i);
  const double rate = 4, end = 0.65;
  for (const double period : {0.4, 0.9, 3.0}) {
    const double omega = 2 * pi / period;
    const double x = rate / std::pow(omega, 3) * (omega * end - std::sin(omega * end));
    const double v = rate / (omega * omega) * (1 - std::cos(omega * end));
    const OscillatorPeaks peaks = oscillator_peaks(ramp, period, 0);
    EXPECT_NEAR(peaks.displacement / std::hypot(x, v / omega), 1, round_off) << period;
    EXPECT_NEAR(peaks.absolute_acceleration / peaks.pseudo_acceleration, 1, round_off) << period;
  }
}

// Resonance, undamped: a_g = sin ωt in N cycles swells to x = πN/ω² plus what piecewise-linear sampling takes away:
// a sine drawn through n points a cycle has the fundamental sinc²(π/n).
TEST(ResponseSpectrum, ResonanceOfASampledSine) {
  const int points = 64, cycles = 20;
  SampledMotion sine{1.0 / points, {}};
  for (int i = 0; i <= points * cycles; ++i) sine.acceleration.push_back(std::sin(2 * pi * i / points));
  const double fundamental = std::pow(std::sin(pi / points) / (pi / points), 2);
  const double amplitude = fundamental * pi * cycles / (4 * pi * pi);
  // The other harmonics, at 63 and 65 cycles a second, weigh 1/63² of it and push 1/63² as far: 1e-7 of one cycle.
  EXPECT_NEAR(oscillator_peaks(sine, 1.0, 0).displacement / amplitude, 1, 1e-7);
}

TEST(ResponseSpectrum, ShortPeriodsFollowTheGround) {
  const SampledMotion motion = noise(0.01, 500, 2);
  // A stiff oscillator rings where the record changes its slope, by that change over ω: 2 % of the peak at most here.
  const OscillatorPeaks stiff = oscillator_peaks(motion, 2e-4, 0.05);
  EXPECT_NEAR(stiff.absolute_acceleration / peak_acceleration(motion), 1, 0.02);
  EXPECT_NEAR(stiff.pseudo_acceleration / peak_acceleration(motion), 1, 0.02);
}

TEST(ResponseSpectrum, LongPeriodsStandStillWhileTheGroundMoves) {
  SampledMotion motion = noise(0.01, 500, 2);
  for (std::size_t i = 500; i > 0; --i) motion.acceleration.push_back(-motion.acceleration[i - 1]);  // comes to rest
  double velocity = 0, displacement = 0, farthest = 0;
  for (std::size_t i = 0; i + 1 < motion.acceleration.size(); ++i) {
    const double a = motion.acceleration[i], b = motion.acceleration[i + 1], h = motion.time_step;
    displacement += velocity * h + (2 * a + b) * h * h / 6;
    velocity += (a + b) * h / 2;
    farthest = std::max(farthest, std::abs(displacement));
  }
  // Between samples the ground strays by a h²/8 from its chord; the spring pulls by (ωt)²/2 = 2e-7.
  const double between = peak_acceleration(motion) * 0.01 * 0.01 / 8;
  EXPECT_NEAR(oscillator_peaks(motion, 1e5, 0).displacement, farthest, between + 1e-6 * farthest);
}

TEST(ResponseSpectrum, ScalesWithTheRecordAndWithTime) {
  const SampledMotion motion = noise(0.02, 300, 3);
  SampledMotion other{0.04, motion.acceleration};
  for (double& a : other.acceleration) a *= -2.5;
  for (const double period : {0.1, 0.7, 4.0}) {
    const OscillatorPeaks one = oscillator_peaks(motion, period, 0.05);
    const OscillatorPeaks two = oscillator_peaks(other, 2 * period, 0.05);
    EXPECT_NEAR(two.displacement / (2.5 * 4 * one.displacement), 1, round_off);
    EXPECT_NEAR(two.absolute_acceleration / (2.5 * one.absolute_acceleration), 1, round_off);
  }
}

// Samples put in on the straight lines between others change nothing.
TEST(ResponseSpectrum, DoesNotDependOnHowFinelyALineIsSampled) {
  const SampledMotion motion = noise(0.02, 300, 4);
  SampledMotion fine{0.005, {}};
  for (std::size_t i = 0; i + 1 < motion.acceleration.size(); ++i) {
    for (int part = 0; part < 4; ++part) {
      fine.acceleration.push_back(motion.acceleration[i] +
                                  part * (motion.acceleration[i + 1] - motion.acceleration[i]) / 4);
    }
  }
  fine.acceleration.push_back(motion.acceleration.back());
  for (const double period : {0.02, 0.3, 5.0}) {
    const OscillatorPeaks one = oscillator_peaks(motion, period, 0.05);
    const OscillatorPeaks two = oscillator_peaks(fine, period, 0.05);
    EXPECT_NEAR(two.displacement / one.displacement, 1, round_off);
    EXPECT_NEAR(two.absolute_acceleration / one.absolute_acceleration, 1, round_off);
  }
}

TEST(ResponseSpectrum, DampingLowersTheDisplacementOfAStep) {
  const SampledMotion step{0.02, std::vector<double>(501, 1.0)};
  double before = std::numeric_limits<double>::infinity();
  for (const double ratio : {0.0, 0.01, 0.05, 0.2, 0.6}) {
    const double now = oscillator_peaks(step, 0.5, ratio).displacement;
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(ResponseSpectrum, PeriodsAreEvenlySpacedOnALogarithmicScale) {
  const std::vector<double> periods = logarithmic_periods(0.05, 5, 41);
  ASSERT_EQ(periods.size(), 41U);
  EXPECT_EQ(periods.front(), 0.05);
  EXPECT_EQ(periods.back(), 5);
  EXPECT_NEAR(periods[20], 0.5, 1e-15);
  EXPECT_EQ(logarithmic_periods(0.7, 0.7, 1), std::vector<double>{0.7});
  EXPECT_THROW((void)logarithmic_periods(1, 0.5, 10), InvalidParameter);
  EXPECT_THROW((void)logarithmic_periods(0, 1, 10), InvalidParameter);
  EXPECT_THROW((void)logarithmic_periods(0.5, 1, 1), InvalidParameter);
  const SampledMotion motion = noise(0.02, 50, 5);
  EXPECT_EQ(response_spectrum(motion, periods, 0.05).size(), periods.size());
}

/// Four are followed side by side, and those of one are cut into more parts than those of another.
TEST(ResponseSpectrum, OfManyPeriodsIsThatOfEachToTheBit) {
  const SampledMotion motion = noise(0.02, 300, 8);
  for (const double ratio : {0.0, 0.05, 0.7}) {
    const std::vector<double> periods = logarithmic_periods(0.005, 6, 43);
    const std::vector<OscillatorPeaks> all = response_spectrum(motion, periods, ratio);
    ASSERT_EQ(all.size(), periods.size());
    for (std::size_t i = 0; i < periods.size(); ++i) {
      const OscillatorPeaks one = oscillator_peaks(motion, periods[i], ratio);
      EXPECT_EQ(all[i].displacement, one.displacement) << periods[i];
      EXPECT_EQ(all[i].pseudo_velocity, one.pseudo_velocity) << periods[i];
      EXPECT_EQ(all[i].pseudo_acceleration, one.pseudo_acceleration) << periods[i];
      EXPECT_EQ(all[i].absolute_acceleration, one.absolute_acceleration) << periods[i];
    }
  }
  EXPECT_TRUE(response_spectrum(motion, {}, 0.05).empty());
}

/// Between samples x strays from its chord by h²/8 of the largest |ẍ|, which is A and the ground's together at most.
TEST(ResponseSpectrum, AtSamplesFallsShortByWhatAStepBends) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const SampledMotion motion = noise(0.005, 800, seed);
    const std::vector<double> periods = logarithmic_periods(60 * 0.005, 5, 25);
    const std::vector<double> at_samples = pseudo_accelerations_at_samples(motion, periods, 0.05);
    ASSERT_EQ(at_samples.size(), periods.size());
    for (std::size_t i = 0; i < periods.size(); ++i) {
      const OscillatorPeaks whole = oscillator_peaks(motion, periods[i], 0.05);
      const double turn = 2 * pi / periods[i] * 0.005;
      const double bend = turn * turn / 8 * (whole.absolute_acceleration + peak_acceleration(motion));
      EXPECT_LE(at_samples[i], whole.pseudo_acceleration * (1 + round_off)) << seed << ", " << periods[i];
      EXPECT_GE(at_samples[i], whole.pseudo_acceleration - bend) << seed << ", " << periods[i];
    }
  }
}

TEST(ResponseSpectrum, RefusesWhatCannotBe) {
  const SampledMotion motion = noise(0.02, 50, 6);
  EXPECT_THROW((void)oscillator_peaks(motion, 0, 0.05), InvalidParameter);
  EXPECT_THROW((void)oscillator_peaks(motion, 1e-5, 0.05), InvalidParameter);
  EXPECT_THROW((void)oscillator_peaks(motion, 1, 1.0), InvalidParameter);
  EXPECT_THROW((void)oscillator_peaks(motion, 1, -0.1), InvalidParameter);
  EXPECT_THROW((void)oscillator_peaks({0.02, {}}, 1, 0.05), InvalidParameter);
  EXPECT_THROW((void)oscillator_peaks({0, {1, 2}}, 1, 0.05), InvalidParameter);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)oscillator_peaks({0.02, {1, nan, 2}}, 1, 0.05), InvalidParameter);
}

// Against the exact spectrum of every direction, a degree apart.
TEST(MaximumDirection, IsTheLargestOfAllDirections) {
  std::mt19937 random(7);
  std::normal_distribution<double> white;
  SampledMotion x{0.02, {}}, y{0.02, {}};
  for (int i = 0; i < 300; ++i) {
    x.acceleration.push_back(white(random));
    if (i < 220) y.acceleration.push_back(i < 219 ? 0.7 * white(random) : 0);
  }
  for (const double period : {0.03, 0.1, 0.5, 2.0, 9.0}) {
    double largest = 0;
    for (int degree = 0; degree < 180; ++degree) {
      const double angle = degree * pi / 180;
      SampledMotion along = x;
      for (std::size_t i = 0; i < along.acceleration.size(); ++i) {
        const double other = i < y.acceleration.size() ? y.acceleration[i] : 0;
        along.acceleration[i] = std::cos(angle) * x.acceleration[i] + std::sin(angle) * other;
      }
      largest = std::max(largest, oscillator_peaks(along, period, 0.05).pseudo_acceleration);
    }
    const double found = maximum_direction(x, y, period, 0.05);
    EXPECT_LT(found, largest / std::cos(pi / 360) * (1 + round_off)) << period;
    EXPECT_GT(found, largest * (1 - 3.2e-4)) << period;
  }
  SampledMotion still{0.02, std::vector<double>(5, 0.0)};
  EXPECT_NEAR(maximum_direction(x, still, 0.5, 0.05) / oscillator_peaks(x, 0.5, 0.05).pseudo_acceleration, 1, 3.2e-4);
  still.time_step = 0.01;
  EXPECT_THROW((void)maximum_direction(x, still, 0.5, 0.05), InvalidParameter);
}

}  // namespace
}  // namespace bentur
