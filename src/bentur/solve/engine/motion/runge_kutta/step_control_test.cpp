#include "bentur/solve/engine/motion/runge_kutta/step_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bentur::engine {
namespace {

TEST(StepControl, AimsALittleBelowTheTolerance) {
  StepControl control;
  EXPECT_DOUBLE_EQ(control.next(2, 1), 2 * 0.9);
  control.reset();
  // Errors grow with the eighth power of the length.
  const double next = control.next(1, std::pow(0.5, 8));
  EXPECT_DOUBLE_EQ(next, 0.9 * 2);
  EXPECT_DOUBLE_EQ(StepControl().next(1, std::pow(2, 8)), 0.9 / 2);
}

TEST(StepControl, ChangesWithinBounds) {
  for (const double error : {0.0, 1e-300, 1e-7, 1e-3, 1.0, 10.0, 1e6, 1e300}) {
    const double next = StepControl().next(1, error);
    EXPECT_GE(next, 0.2);
    EXPECT_LE(next, 6);
    EXPECT_EQ(next > 0.95, error < 0.5) << error;
  }
  for (const double error : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(StepControl().next(3, error), 3 * 0.2);
  }
}

TEST(StepControl, SettlesWhereTheErrorIsThatOfASmoothMotion) {
  StepControl control;
  double h = 1e-4;
  const auto error = [](double length) { return std::pow(length / 0.05, 8); };
  int rejected = 0;
  for (int n = 0; n < 30; ++n) {
    rejected += error(h) > 1 ? 1 : 0;
    h = control.next(h, error(h));
  }
  EXPECT_NEAR(h / 0.05, 0.9, 1e-12);
  EXPECT_LE(rejected, 1);
}

TEST(StepControl, GoesAlongWithASteadyChange) {
  // Errors that double at one length from step to step call for lengths that shrink by 2^(−1/8) each: without the
  // trend each step would be too long by that, and with 0.9 at the start the second would be refused.
  StepControl control;
  double h = 1, strength = 1;
  for (int n = 0; n < 40; ++n) {
    const double error = strength * std::pow(h, 8);
    if (n > 2) {
      EXPECT_NEAR(error, std::pow(0.9, 8), 1e-9) << n;
    }
    h = control.next(h, error);
    strength *= 2;
  }
}

TEST(StepControl, ARefusedStepLeavesNoTrend) {
  StepControl control;
  (void)control.next(1, 0.5);
  StepControl same = control;
  (void)control.next(1, 50);
  EXPECT_EQ(control.next(0.5, 0.4), same.next(0.5, 0.4));
}

TEST(StepControl, ForgetsWhenReset) {
  StepControl control;
  (void)control.next(1, 0.01);
  control.reset();
  EXPECT_EQ(control.next(2, 0.3), StepControl().next(2, 0.3));
}

}  // namespace
}  // namespace bentur::engine
