#include "bentur/excitation/ground_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bentur {
namespace {

using std::numbers::pi;

TEST(GroundMotion, OfARecordIsLinearFromTheFirstSampleToTheLast) {
  // Steps and values that are powers of two: no round-off.
  const SampledMotion record{0.25, {3, -1, 4, 0.5, -2}};
  for (std::size_t i = 0; i < 5; ++i) {
    const double t = 0.25 * static_cast<double>(i);
    EXPECT_EQ(acceleration_at(record, t), record.acceleration[i]) << "sample " << i;  // the last one too
    if (i == 4) continue;
    EXPECT_EQ(acceleration_at(record, t + 0.125), 0.5 * (record.acceleration[i] + record.acceleration[i + 1]));
    EXPECT_EQ(acceleration_at(record, t + 0.0625), 0.75 * record.acceleration[i] + 0.25 * record.acceleration[i + 1]);
  }
}

TEST(GroundMotion, IsZeroBeforeTheFirstSampleAndAfterTheLast) {
  const SampledMotion record{0.25, {3, -1, 4, 0.5, -2}}, one{0.25, {5}}, empty{0.25, {}};
  EXPECT_EQ(acceleration_at(record, std::nextafter(0.0, -1.0)), 0);
  EXPECT_EQ(acceleration_at(record, std::nextafter(1.0, 2.0)), 0);
  EXPECT_NEAR(acceleration_at(record, std::nextafter(1.0, 0.0)), -2, 1e-14);
  EXPECT_EQ(acceleration_at(record, std::nan("")), 0);
  EXPECT_EQ(acceleration_at(one, 0), 5);
  EXPECT_EQ(acceleration_at(one, 1e-300), 0);
  EXPECT_EQ(acceleration_at(empty, 0), 0);
  EXPECT_EQ(acceleration_at(NoMotion{}, 1), 0);
}

// The acceleration that goes with the displacement A sin ωt or A cos ωt.
TEST(GroundMotion, OfAHarmonicDisplacementIsItsSecondDerivative) {
  HarmonicMotion motion{.period = 0.4, .displacement_amplitude = 0.03};
  const double omega = 2 * pi / motion.period;
  EXPECT_EQ(angular_frequency(motion), omega);
  EXPECT_NEAR(peak_acceleration(motion), 0.03 * omega * omega, 1e-14);
  for (const auto phase : {HarmonicMotion::Phase::sine, HarmonicMotion::Phase::cosine}) {
    motion.phase = phase;
    const auto displacement = [&](double t) {
      return 0.03 * (phase == HarmonicMotion::Phase::sine ? std::sin(omega * t) : std::cos(omega * t));
    };
    for (const double t : {0.05, 0.13, 0.3, 1.7}) {
      const double h = 1e-4;  // errs by (ωh)²/12 = 2e-7, and round-off of 1e-17/h² = 1e-9
      EXPECT_NEAR(acceleration_at(motion, t),
                  (displacement(t - h) - 2 * displacement(t) + displacement(t + h)) / (h * h),
                  1e-6 * peak_acceleration(motion));
    }
    EXPECT_EQ(acceleration_at(motion, -1e-9), 0);
  }
}

TEST(GroundMotion, PeakOfARecordIsItsLargestSizeWhereverItStands) {
  EXPECT_EQ(peak_acceleration(SampledMotion{0.1, {1, -7, 3}}), 7);
  EXPECT_EQ(peak_acceleration(SampledMotion{0.1, {1, 2, 3}}), 3);
  EXPECT_EQ(peak_acceleration(SampledMotion{0.1, {-8, 2, 3}}), 8);
  EXPECT_EQ(peak_acceleration(NoMotion{}), 0);
}

TEST(GroundMotion, PeakOfTwoThatActAtOnce) {
  using Both = std::array<GroundMotion, 2>;
  const SampledMotion a{0.1, {1, -7, 3}};
  const auto peak = [](const Both& motions, double first, double second) {
    return peak_acceleration(motions, {first, second});
  };
  // One alone, where the other does not move or has no part in it.
  EXPECT_EQ(peak({a, NoMotion{}}, 0.5, 1), 3.5);
  EXPECT_EQ(peak({NoMotion{}, a}, 0.5, -1), 7);
  EXPECT_EQ(peak({a, SampledMotion{0.1, {50, 50, 50}}}, 1, 0), 7);
  EXPECT_EQ(peak({NoMotion{}, NoMotion{}}, 1, 1), 0);
  // Sample by sample: 1 + 2, -7 + 12, 3 - 6.
  EXPECT_EQ(peak({a, SampledMotion{0.1, {1, 6, -3}}}, 1, 2), 5);
  EXPECT_EQ(peak({SampledMotion{0.1, {1, 6, -3}}, a}, 2, 1), 5);
  // At a sample of either, on the straight line of the other: at 0.15 s -2 - 4.
  EXPECT_DOUBLE_EQ(*peak({SampledMotion{0.1, {0, 0, -4}}, SampledMotion{0.05, {0, 0, 0, -4, 0}}}, 1, 1), 6);
  EXPECT_DOUBLE_EQ(*peak({SampledMotion{0.05, {0, 0, 0, -4, 0}}, SampledMotion{0.1, {0, 0, -4}}}, 1, 1), 6);
  // Where one ends first, the other goes on without it; where both end at once, neither is left.
  EXPECT_EQ(peak({SampledMotion{0.1, {0, 5}}, SampledMotion{0.1, {0, -5, 1}}}, 1, 1), 5);
  EXPECT_EQ(peak({SampledMotion{0.1, {0, 5}}, SampledMotion{0.1, {0, -5}}}, 1, 1), 0);
  EXPECT_DOUBLE_EQ(*peak({SampledMotion{0.3, {0, 5}}, SampledMotion{0.1, {0, 0, 0, -5}}}, 1, 1), 10.0 / 3);
}

TEST(GroundMotion, PeakOfTwoHarmonicOnes) {
  const HarmonicMotion sine{.period = 0.4, .displacement_amplitude = 0.03};
  HarmonicMotion other{.period = 0.4, .displacement_amplitude = 0.04};
  const double omega = 2 * pi / 0.4;
  const auto peak = [&] { return peak_acceleration({sine, other}, {1, -1}); };
  EXPECT_NEAR(peak().value(), 0.01 * omega * omega, 1e-14);  // in step
  other.phase = HarmonicMotion::Phase::cosine;
  EXPECT_NEAR(peak().value(), 0.05 * omega * omega, 1e-13);  // a quarter of a period apart
  other.period = 0.5;
  EXPECT_EQ(peak(), std::nullopt);
  EXPECT_EQ(peak_acceleration({sine, SampledMotion{0.1, {1, 2}}}, {1, 1}), std::nullopt);
}

}  // namespace
}  // namespace bentur
