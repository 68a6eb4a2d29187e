#include "bentur/model/gap/separation_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

SeparationInput side(double displacement, double period, double damping_ratio) {
  return {.displacement = displacement, .period = period, .damping_ratio = damping_ratio};
}

/// Correlation of the displacements of two oscillators under one white noise, by adding up the cross spectrum
/// Re ∫ H_A conj(H_B) dω; a way to ρ that shares nothing with the closed form.
double white_noise_correlation(const SeparationInput& a, const SeparationInput& b) {
  const auto spectrum = [](const SeparationInput& s, double w, double& re, double& im) {
    const double w0 = 2 * std::numbers::pi / s.period;
    const double x = w0 * w0 - w * w;
    const double y = 2 * s.damping_ratio * w0 * w;
    re = x / (x * x + y * y);
    im = -y / (x * x + y * y);
  };
  double aa = 0, bb = 0, ab = 0;
  for (int i = 0; i < 400000; ++i) {  // up to 400 rad/s, where H has fallen by (ω₀/ω)² < 1e-3
    double ra = 0, ia = 0, rb = 0, ib = 0;
    spectrum(a, (i + 0.5) * 1e-3, ra, ia);
    spectrum(b, (i + 0.5) * 1e-3, rb, ib);
    aa += ra * ra + ia * ia;
    bb += rb * rb + ib * ib;
    ab += ra * rb + ia * ib;
  }
  return ab / std::sqrt(aa * bb);
}

TEST(SeparationRules, AbsoluteSumAndSrssOfAPythagoreanTriple) {
  EXPECT_DOUBLE_EQ(separation_abs(side(3, 1, 0.05), side(4, 0.7, 0.05)), 7);
  EXPECT_DOUBLE_EQ(separation_srss(side(3, 1, 0.05), side(4, 0.7, 0.05)), 5);
}

// Values of the white-noise correlation, published with five digits: half a unit of the fifth is the tolerance.
TEST(SeparationRules, CorrelationMatchesTabulatedValues) {
  EXPECT_NEAR(ddc_correlation(side(1, 1, 0.05), side(1, 0.8, 0.05)), 0.16563, 0.5e-5);
  EXPECT_NEAR(ddc_correlation(side(1, 1, 0.05), side(1, 0.5, 0.02)), 0.00709, 0.5e-5);
  EXPECT_NEAR(ddc_correlation(side(1, 1, 0.02), side(1, 0.7, 0.10)), 0.08270, 0.5e-5);
}

// Step 1e-3 rad/s against a half-power width of 0.5 rad/s, and a tail beyond 400 rad/s of (ω₀/400)³: both below 1e-5.
TEST(SeparationRules, CorrelationIsThatOfWhiteNoise) {
  const SeparationInput a = side(1, 1.1, 0.04);
  const SeparationInput b = side(1, 0.9, 0.08);
  EXPECT_NEAR(ddc_correlation(a, b), white_noise_correlation(a, b), 1e-5);
}

TEST(SeparationRules, CorrelationDoesNotDependOnTheOrderOfTheBuildings) {
  const SeparationInput a = side(1, 1.3, 0.02);
  const SeparationInput b = side(1, 0.4, 0.07);
  EXPECT_NEAR(ddc_correlation(a, b), ddc_correlation(b, a), 1e-15);
}

TEST(SeparationRules, EqualPeriodsAndDampingMoveAlike) {
  for (const double ratio : {0.0, 1e-9, 0.05, 0.3}) {
    // With one damping ratio and one period ρ = 16ζ²/16ζ²: round-off only.
    EXPECT_NEAR(ddc_correlation(side(2, 0.6, ratio), side(2, 0.6, ratio)), 1, 1e-14) << ratio;
    EXPECT_NEAR(separation_ddc(side(2, 0.6, ratio), side(2, 0.6, ratio)), 0, 1e-6) << ratio;
    EXPECT_NEAR(separation_ddc(side(3, 0.6, ratio), side(2, 0.6, ratio)), 1, 1e-6) << ratio;
  }
  EXPECT_EQ(separation_ddc(side(2, 0.6, 0), side(2, 0.6, 0)), 0);
}

TEST(SeparationRules, UndampedBuildingsOfDifferentPeriodAreUncorrelated) {
  EXPECT_EQ(ddc_correlation(side(1, 1, 0), side(1, 0.9, 0)), 0);
  EXPECT_EQ(ddc_correlation(side(1, 1, 0), side(1, 1, 0.05)), 0);
  EXPECT_NEAR(separation_ddc(side(3, 1, 0), side(4, 0.9, 0)), 5, 1e-14);
}

TEST(SeparationRules, DdcLiesBetweenDifferenceAndSrss) {
  for (const double period : {0.2, 0.5, 0.9, 1.0, 1.1, 3.0}) {
    const SeparationInput a = side(2.0, 1.0, 0.05);
    const SeparationInput b = side(1.5, period, 0.03);
    EXPECT_GT(separation_ddc(a, b), 0.5) << period;
    EXPECT_LT(separation_ddc(a, b), separation_srss(a, b)) << period;
    EXPECT_LT(separation_srss(a, b), separation_abs(a, b)) << period;
  }
}

TEST(SeparationRules, RefusesPeriodsAndRatiosThatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)ddc_correlation(side(1, 0, 0.05), side(1, 1, 0.05)), InvalidParameter);
  EXPECT_THROW((void)ddc_correlation(side(1, 1, 0.05), side(1, nan, 0.05)), InvalidParameter);
  EXPECT_THROW((void)ddc_correlation(side(1, 1, -0.01), side(1, 1, 0.05)), InvalidParameter);
}

}  // namespace
}  // namespace bentur
