#include "bentur/excitation/motion_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bentur {
namespace {

TEST(MotionMeasures, OfATriangleInClosedForm) {
  // a rises from 0 to 2, falls through 0 to −2 and returns: v peaks where a is zero, at half the area of a triangle.
  const MotionMeasures m = motion_measures(SampledMotion{.time_step = 1, .acceleration = {0, 2, -2, 0}});
  EXPECT_DOUBLE_EQ(m.pga, 2);
  EXPECT_DOUBLE_EQ(m.pgv, 1.5);  // 1 in the first second, half a triangle of height 2 and base 1/2 more
}

TEST(MotionMeasures, SignificantDurationOfAConstantIsNineTenths) {
  const MotionMeasures m = motion_measures(SampledMotion{.time_step = 0.5, .acceleration = {3, 3, 3, 3, 3}});
  EXPECT_NEAR(m.significant_duration, 0.9 * 2, 1e-12);  // bisection to round-off
}

TEST(MotionMeasures, SignificantDurationOfARamp) {
  // ∫a² ~ t³, so t₉₅ − t₅ = T (0.95^⅓ − 0.05^⅓), within one step or over many.
  const double expected = 2 * (std::cbrt(0.95) - std::cbrt(0.05));
  EXPECT_NEAR(motion_measures(SampledMotion{.time_step = 2, .acceleration = {0, 2}}).significant_duration, expected,
              1e-12);
  EXPECT_NEAR(motion_measures(SampledMotion{.time_step = 0.5, .acceleration = {0, 1, 2, 3, 4}}).significant_duration,
              expected, 1e-12);
}

TEST(MotionMeasures, OfAHarmonicMotionAndOfNone) {
  const MotionMeasures m = motion_measures(HarmonicMotion{.period = 0.5, .displacement_amplitude = 2});
  const double omega = 4 * std::numbers::pi;
  EXPECT_NEAR(m.pgv, 2 * omega, 1e-12);
  EXPECT_NEAR(m.pga, 2 * omega * omega, 1e-10);
  EXPECT_EQ(m.significant_duration, 0);
  EXPECT_EQ(motion_measures(NoMotion{}).pga, 0);
  EXPECT_EQ(motion_measures(SampledMotion{.time_step = 1, .acceleration = {0, 0}}).significant_duration, 0);
}

}  // namespace
}  // namespace bentur
