#include "bentur/study/design/distribution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bentur {
namespace {

using DistributionKind = Distribution::Kind;

constexpr double phi_of_one = 0.84134474606854293;  // Φ(1)

TEST(Distribution, QuantilesOfEachKind) {
  const Distribution uniform{.kind = DistributionKind::uniform, .low = 2, .high = 6};
  EXPECT_DOUBLE_EQ(uniform.quantile(0.25), 3);
  const Distribution log_uniform{.kind = DistributionKind::log_uniform, .low = 0.01, .high = 100};
  EXPECT_NEAR(log_uniform.quantile(0.5), 1, 1e-15);
  const Distribution normal{.kind = DistributionKind::normal, .centre = 10, .spread = 2};
  EXPECT_NEAR(normal.quantile(phi_of_one), 12, 1e-13);
  EXPECT_DOUBLE_EQ(normal.quantile(0.5), 10);
  const Distribution lognormal{.kind = DistributionKind::lognormal, .centre = 5, .spread = lognormal_spread(0.3)};
  EXPECT_DOUBLE_EQ(lognormal.quantile(0.5), 5);
  EXPECT_NEAR(std::log(lognormal.quantile(phi_of_one) / 5), std::sqrt(std::log(1.09)), 1e-13);
}

TEST(Distribution, WhatIsCutOffIsNeverDrawnAndTheRestIsScaled) {
  // The half normal above the mean: P(x ≤ μ + σ) = (Φ(1) − 1/2) / (1/2).
  const Distribution half{.kind = DistributionKind::normal, .centre = 1, .spread = 0.5, .low = 1};
  EXPECT_NEAR(half.quantile(2 * phi_of_one - 1), 1.5, 1e-12);
  EXPECT_GE(half.quantile(0x1p-54), 1);
  // Far in a tail the digits remain: between 9 and 10 standard deviations above the mean.
  const Distribution tail{.kind = DistributionKind::normal, .centre = 0, .spread = 1, .low = 9, .high = 10};
  double before = 9;
  for (const double u : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    EXPECT_GT(tail.quantile(u), before);
    before = tail.quantile(u);
  }
  EXPECT_LT(before, 9.4);  // P(x > z) falls like exp(−9 (z − 9)): nine tenths lie below 9.26
  const Distribution lognormal{.kind = DistributionKind::lognormal, .centre = 5, .spread = 1, .low = 4, .high = 6};
  EXPECT_GE(lognormal.quantile(0x1p-54), 4);
  EXPECT_LE(lognormal.quantile(1 - 0x1p-53), 6);
}

/// As far out as is allowed the quantiles are still numbers within the bounds.
TEST(Distribution, SaysHowFarItsBoundsAreFromItsCentre) {
  Distribution normal{.kind = Distribution::Kind::normal, .centre = 2, .spread = 0.5, .low = 3, .high = 4};
  EXPECT_DOUBLE_EQ(normal.deviations_off(), 2);
  normal.low = 2 - 0.5;
  EXPECT_EQ(normal.deviations_off(), 0);
  Distribution lognormal{.kind = Distribution::Kind::lognormal, .centre = std::exp(1.0), .spread = 0.25, .high = 1};
  EXPECT_DOUBLE_EQ(lognormal.deviations_off(), 4);
  for (const double side : {-1.0, 1.0}) {
    normal.low = side > 0 ? 2 + 0.5 * Distribution::farthest : -100;
    normal.high = side > 0 ? 100 : 2 - 0.5 * Distribution::farthest;
    EXPECT_DOUBLE_EQ(normal.deviations_off(), Distribution::farthest);
    for (const double u : {0x1p-54, 0.5, 1 - 0x1p-53}) {
      EXPECT_GE(normal.quantile(u), normal.low);
      EXPECT_LE(normal.quantile(u), normal.high);
    }
    EXPECT_NEAR(normal.quantile(0.5), 2 + side * 0.5 * (Distribution::farthest + 0.02), 0.01);
  }
}

TEST(Distribution, ExtremesTellWhatTheSupportForbids) {
  // A normal distribution however narrow reaches below zero and above one.
  const Distribution narrow{.kind = DistributionKind::normal, .centre = 0.5, .spread = 1e-3};
  EXPECT_LT(extremes(narrow).low, 0);
  EXPECT_GT(extremes(narrow).high, 1);
  const Distribution lognormal{.kind = DistributionKind::lognormal, .centre = 0.5, .spread = 0.1};
  EXPECT_GT(extremes(lognormal).low, 0);
  EXPECT_GT(extremes(lognormal).high, 1);
  const Distribution cut{.kind = DistributionKind::normal, .centre = 0.5, .spread = 1, .low = 0.1, .high = 0.9};
  EXPECT_DOUBLE_EQ(extremes(cut).low, 0.1);
  EXPECT_DOUBLE_EQ(extremes(cut).high, 0.9);
  const Distribution uniform{.kind = DistributionKind::uniform, .low = -1, .high = 1};
  EXPECT_DOUBLE_EQ(extremes(uniform).low, -1);
}

}  // namespace
}  // namespace bentur
