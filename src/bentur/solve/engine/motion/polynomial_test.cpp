#include "bentur/solve/engine/motion/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bentur::engine {
namespace {

/// (s − r)² + depth, scaled.
Polynomial parabola(double r, double depth) { return {r * r + depth, -2.0 * r, 1.0}; }

TEST(Polynomial, ValuesAndDerivativesOfAQuartic) {
  const Polynomial p{1.0, -2.0, 3.0, -4.0, 5.0};
  EXPECT_DOUBLE_EQ(value(p, 0.5), 1.0 - 1.0 + 0.75 - 0.5 + 0.3125);
  EXPECT_DOUBLE_EQ(first_derivative(p, 0.5), -2.0 + 3.0 - 3.0 + 2.5);
  EXPECT_DOUBLE_EQ(integral(p, 1.0), 1.0 - 1.0 + 1.0 - 1.0 + 1.0);
}

TEST(FirstNegative, FindsASimpleCrossing) {
  const auto s = first_negative({0.25, -1.0});
  ASSERT_TRUE(s);
  EXPECT_NEAR(*s, 0.25, 1e-15);
}

TEST(FirstNegative, TakesTheFirstOfSeveral) {
  // (s − 0.2)(s − 0.5)(s − 0.9) is negative at 0; its opposite is positive until 0.2.
  const Polynomial p{0.09, -0.73, 1.6, -1.0};
  const auto s = first_negative(p);
  ASSERT_TRUE(s);
  EXPECT_NEAR(*s, 0.2, 1e-14);
}

TEST(FirstNegative, IsZeroWhenNegativeAtOnce) { EXPECT_EQ(first_negative({-1.0, 5.0}), 0.0); }

TEST(FirstNegative, ATouchIsNoCrossing) {
  // r = 0.5 makes r², 2r exact: the minimum is exactly zero.
  EXPECT_FALSE(first_negative(parabola(0.5, 0.0)));
  EXPECT_FALSE(first_negative(Polynomial{}));
}

TEST(FirstNegative, FindsAGrazeJustAboveRoundOff) {
  // Depth 1e-12 against coefficients of order one: round-off of the evaluation is about 1e-16.
  for (const double r : {0.1, 0.3141592653589793, 0.5, 0.77, 0.999}) {
    const auto s = first_negative(parabola(r, -1e-12));
    ASSERT_TRUE(s) << r;
    EXPECT_NEAR(*s, r - 1e-6, 1e-9);
    EXPECT_FALSE(first_negative(parabola(r, 1e-12))) << r;
  }
}

Polynomial random_polynomial(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Polynomial p;
  double factorial = 1.0;
  const double reach = std::uniform_real_distribution<double>(0.1, 6.0)(random);
  for (int k = 0; k <= highest_degree; ++k) {
    if (k > 0) factorial *= k / reach;  // a solution's coefficients fall like reach^k / k!
    p[k] = normal(random) / factorial;
  }
  return p;
}

TEST(FirstNegative, AgreesWithADenseSearch) {
  std::mt19937_64 random(1);
  constexpr int cases = 10000;
  constexpr int samples = 400;
  int crossings = 0;
  for (int n = 0; n < cases; ++n) {
    Polynomial p = random_polynomial(random);
    double lowest = p[0];
    for (int i = 0; i <= samples; ++i) lowest = std::min(lowest, value(p, static_cast<double>(i) / samples));
    p[0] -= lowest * std::uniform_real_distribution<double>(0.9, 1.1)(random);  // make it graze
    const auto found = first_negative(p);
    for (int i = 0; i <= samples; ++i) {
      const double s = static_cast<double>(i) / samples;
      if (found && s >= *found) break;
      ASSERT_GE(value(p, s), -1e-13) << "missed before " << s << " in case " << n;
    }
    if (found && *found > 0.0) {
      ++crossings;
      ASSERT_NEAR(value(p, *found), 0.0, 1e-12) << "invented in case " << n;
    }
  }
  EXPECT_GT(crossings, cases / 10);  // the cases are not all trivial
}

TEST(RaiseToMaximum, FindsTheContinuousMaximum) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 10000; ++n) {
    const Polynomial p = random_polynomial(random);
    const double end = std::uniform_real_distribution<double>(0.01, 1.0)(random);
    double round_off = 0.0;  // of one evaluation (polynomial.h)
    for (const double coefficient : p.coefficients) round_off += highest_degree * 1e-16 * std::abs(coefficient);
    double best = -1e300;
    double where = -1.0;
    ASSERT_TRUE(raise_to_maximum(p, end, best, where));
    ASSERT_GE(where, 0.0);
    ASSERT_LE(where, end);
    ASSERT_NEAR(value(p, where), best, round_off);
    for (int i = 0; i <= 200; ++i) ASSERT_LE(value(p, end * i / 200.0), best + round_off) << "case " << n;
    ASSERT_FALSE(raise_to_maximum(p, end, best, where));  // a second search finds nothing higher
  }
}

TEST(RaiseToLargest, IsTheLargerOfBothMaxima) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 10000; ++n) {
    const Polynomial p = random_polynomial(random);
    double highest = 0.0, lowest = 0.0, where = 0.0, largest = 0.0;
    raise_to_maximum(p, 1.0, highest, where);
    raise_to_maximum(p, 1.0, lowest, where, -1.0);
    raise_to_largest(p, 1.0, largest);
    ASSERT_NEAR(largest, std::max(highest, lowest), 1e-15 * largest) << "case " << n;
  }
}

TEST(FirstNegative, TouchesInTheMiddleOrAtTheEndAreNoCrossings) {
  EXPECT_FALSE(first_negative({0.25, -1.0, 1.0}));        // (s − 1/2)²
  EXPECT_FALSE(first_negative({0.25, -0.75, 0.0, 1.0}));  // (s − 1/2)² (s + 1)
  EXPECT_FALSE(first_negative({1.0, -2.0, 1.0}));         // (s − 1)²
  EXPECT_FALSE(first_negative({}));
}

TEST(FirstNegative, StartsAtRestOnZero) {
  EXPECT_FALSE(first_negative({0.0, 0.0, 1.0}));
  EXPECT_NEAR(first_negative({0.0, 0.0, -1.0}).value(), 0.0, 1e-100);
  EXPECT_EQ(first_negative({0.0, -1.0, 2.0}), 0.0);
  EXPECT_NEAR(first_negative({0.0, 0.0, 0.5, -1.0}).value(), 0.5, 1e-15);
  EXPECT_NEAR(first_negative({0.0, 1e-9, -1.0}).value(), 1e-9, 1e-24);
  EXPECT_NEAR(first_negative({0.0, 1.0, -4.0}).value(), 0.25, 1e-16);
  EXPECT_NEAR(first_negative({0.5, -1.0}).value(), 0.5, 1e-16);
}

TEST(SecondDerivative, IsThatOfEveryPower) {
  const Polynomial p{5.0, 4.0, 3.0, 2.0, 1.0};
  const Polynomial second = second_derivative(p, 0.5);
  EXPECT_EQ(second[0], 3.0);
  EXPECT_EQ(second[1], 6.0);
  EXPECT_EQ(second[2], 6.0);
  EXPECT_EQ(value(second_derivative({1.0, 2.0}, 1.0), 0.3), 0.0);
}

TEST(RaiseToLargest, LeavesOutWhatIsBeyondTheEnd) {
  double best = 0.1;
  raise_to_largest({0.0, 1.0, -1.0}, 0.25, best);  // 1/4 at 1/2
  EXPECT_EQ(best, 0.1875);
}

TEST(FirstNegative, OverflowEndsTheSearch) {
  // Bounds of infinity can prove nothing; the search must end all the same (the solver reports the overflow).
  const double huge = 1e307;
  EXPECT_FALSE(first_negative({huge, -huge, huge, -huge, huge, -huge, huge, huge, huge}));
  double best = 0.0;
  raise_to_largest({huge, -huge, huge, -huge, huge, -huge, huge, huge, huge}, 1.0, best);
  EXPECT_GE(best, huge);  // the ends are still taken
}

TEST(RaiseToMaximum, LeavesAHigherPeakAlone) {
  double best = 2.0;
  double where = 0.25;
  EXPECT_FALSE(raise_to_maximum({0.0, 1.0}, 1.0, best, where));
  EXPECT_EQ(best, 2.0);
  EXPECT_EQ(where, 0.25);
}

}  // namespace
}  // namespace bentur::engine
