#include "bentur/contact/linear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

TEST(Linear, ForceIsThatOfASpringUnderPressure) {
  const Linear law(2.5e5);
  EXPECT_EQ(law.name(), "linear");
  EXPECT_EQ(law.stiffness(), 2.5e5);
  EXPECT_EQ(law.force(0.02, 0), 5000);
  EXPECT_EQ(law.force(0, 10), 0);
  EXPECT_EQ(law.force(-1e-9, 10), 0);
  for (const double speed : {-3.0, 0.0, 7.0}) EXPECT_EQ(law.force(0.02, speed), law.force(0.02, -speed));
}

TEST(Linear, NanPassesThrough) {
  EXPECT_TRUE(std::isnan(Linear(1).force(std::numeric_limits<double>::quiet_NaN(), 0)));
}

TEST(Linear, FreeImpact) {
  // Two free masses: duration π√(m_e/k), peak v₀√(k m_e), e = 1. The velocity Verlet rule with 10 000 steps per contact
  // has a relative error of (ωh)²/24 = 4e-9 in the duration and less in peak and speed; the time of release is
  // interpolated linearly, which adds (ωh)²/8; 1e-6 leaves room.
  const double k = 1e8, m1 = 2e5, m2 = 6e4, v0 = 0.4937;
  const double me = m1 * m2 / (m1 + m2);
  const double duration = std::numbers::pi * std::sqrt(me / k);
  const Linear law(k);
  const double h = duration / 10000;
  double penetration = 0, speed = v0, time = 0, peak = 0, before = 0;
  for (int step = 0; step < 20000 && penetration >= 0; ++step) {
    before = penetration;
    const double half = speed - h / 2 * law.force(penetration, speed) / me;
    penetration += h * half;
    speed = half - h / 2 * law.force(penetration, half) / me;
    peak = std::max(peak, law.force(penetration, speed));
    time += h;
  }
  time -= h * penetration / (penetration - before);
  EXPECT_NEAR(time / duration, 1, 1e-6);
  EXPECT_NEAR(peak / (v0 * std::sqrt(k * me)), 1, 1e-6);
  EXPECT_NEAR(-speed / v0, 1, 1e-6);
}

TEST(Linear, RefusesAStiffnessThatIsNone) {
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Linear{bad}, InvalidParameter) << bad;
  }
  try {
    Linear{-2};
    FAIL() << "-2 was taken";
  } catch (const InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "stiffness = -2, must be > 0");
  }
}

}  // namespace
}  // namespace bentur
