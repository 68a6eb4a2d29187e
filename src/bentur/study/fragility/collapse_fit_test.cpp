#include "bentur/study/fragility/collapse_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bentur/core/errors.h"
#include "bentur/study/design/distribution.h"
#include "bentur/study/fragility/demand_fits.h"
#include "bentur/study/fragility/fragility.h"

namespace bentur {
namespace {

using CollapseKind = CollapseFit::Kind;

TEST(CollapseFit, OfTwoIntensitiesMeetsTheirShares) {
  // Two numbers for two shares: logit 1/4 = −ln 3 at x = 1, logit 3/4 = ln 3 at x = e.
  const CollapseFit fit = fit_collapse({{1, 4, 1}, {std::exp(1.0), 4, 3}});
  ASSERT_EQ(fit.kind, CollapseKind::fitted);
  EXPECT_NEAR(fit.intercept, -std::log(3.0), 1e-12);
  EXPECT_NEAR(fit.slope, 2 * std::log(3.0), 1e-12);
  EXPECT_NEAR(fit.probability(1), 0.25, 1e-13);
  EXPECT_NEAR(fit.intensity_of(0.5), std::exp(0.5), 1e-12);
  EXPECT_NEAR(fit.probability(fit.intensity_of(0.07)), 0.07, 1e-13);
  EXPECT_EQ(fit.runs, 8);
  EXPECT_EQ(fit.collapsed, 4);
}

/// At the maximum Σ (c − P_C) = 0 and Σ (c − P_C) ln x = 0, whatever the data.
TEST(CollapseFit, IsWhereTheLikelihoodIsLevel) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(0, 1);
  int fitted = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<IntensityCount> counts;
    for (int run = 0; run < 40; ++run) {
      const double x = std::exp(3 * u(random) - 2);
      counts.push_back({x, 1, u(random) < 1 / (1 + std::exp(-(-0.5 + 2.5 * std::log(x)))) ? 1 : 0});
    }
    const CollapseFit fit = fit_collapse(counts);
    if (fit.kind != CollapseKind::fitted) continue;
    ++fitted;
    double sum = 0, moment = 0;
    for (const IntensityCount& one : counts) {
      const double rest = static_cast<double>(one.events) - fit.probability(one.intensity);
      sum += rest;
      moment += rest * std::log(one.intensity);
    }
    EXPECT_NEAR(sum, 0, 1e-8);  // 40 runs, and steps that end at round-off of the likelihood
    EXPECT_NEAR(moment, 0, 1e-8);
  }
  EXPECT_GT(fitted, 90);
}

TEST(CollapseFit, UnitsAndRepeatsDoNotMatter) {
  const std::vector<IntensityCount> counts = {{0.1, 5, 0}, {0.2, 5, 2}, {0.4, 5, 1}, {0.8, 5, 4}};
  std::vector<IntensityCount> others;
  for (const IntensityCount& one : counts) others.push_back({9.80665 * one.intensity, 7 * one.runs, 7 * one.events});
  const CollapseFit a = fit_collapse(counts), b = fit_collapse(others);
  EXPECT_NEAR(b.slope, a.slope, 1e-10);
  EXPECT_NEAR(b.intercept, a.intercept - a.slope * std::log(9.80665), 1e-10);
}

TEST(CollapseFit, WhatHasNoMaximumIsNotFitted) {
  EXPECT_EQ(fit_collapse({{1, 3, 0}, {2, 3, 0}}).kind, CollapseKind::none);
  EXPECT_EQ(fit_collapse({{1, 3, 0}, {2, 3, 0}}).probability(5), 0);
  EXPECT_EQ(fit_collapse({{1, 3, 3}, {2, 3, 3}}).kind, CollapseKind::all);
  EXPECT_EQ(fit_collapse({{1, 3, 3}, {2, 3, 3}}).probability(0.1), 1);
  for (const std::vector<IntensityCount>& counts :
       std::vector<std::vector<IntensityCount>>{
           {{1, 3, 0}, {2, 3, 3}},              // none below, all above
           {{1, 3, 0}, {2, 3, 1}},              // both at the largest intensity with a run that stands
           {{1, 3, 0}, {2, 3, 2}, {3, 3, 3}}})  // both at one intensity alone
  {
    const CollapseFit fit = fit_collapse(counts);
    EXPECT_EQ(fit.kind, CollapseKind::separated);
    EXPECT_FALSE(fit.is_known());
    EXPECT_TRUE(std::isnan(fit.probability(1.5)));
  }
  EXPECT_EQ(fit_collapse({{1, 3, 0}, {2, 3, 3}}).lower, 1);
  EXPECT_EQ(fit_collapse({{1, 3, 0}, {2, 3, 3}}).upper, 2);
  EXPECT_EQ(fit_collapse({{1, 3, 1}}).kind, CollapseKind::falling);                        // one intensity
  EXPECT_EQ(fit_collapse({{1, 4, 3}, {2, 4, 1}}).kind, CollapseKind::falling);             // less with intensity
  EXPECT_EQ(fit_collapse({{1, 4, 2}, {2, 4, 3}, {3, 4, 1}}).kind, CollapseKind::falling);  // overlap, and less
  EXPECT_THROW((void)fit_collapse({{0, 3, 1}}), InvalidParameter);
  EXPECT_THROW((void)fit_collapse({{1, 3, 4}}), InvalidParameter);
}

TEST(CollapseFit, AddsToALognormal) {
  Fragility fit{.kind = Fragility::Kind::fitted, .median = 0.5, .dispersion = 0.4};
  EXPECT_EQ(fit.probability(0.5), 0.5);
  fit.collapse = fit_collapse({{0.3, 4, 1}, {1.2, 4, 3}});
  for (const double x : {0.1, 0.5, 2.0}) {
    const double gone = fit.collapse->probability(x), beyond = normal_probability(std::log(x / 0.5) / 0.4);
    EXPECT_NEAR(fit.probability(x), gone + (1 - gone) * beyond, 1e-15);
  }
  for (const double p : {1e-4, 0.16, 0.5, 0.84, 0.999}) EXPECT_NEAR(fit.probability(fit.intensity_of(p)), p, 1e-12);
  EXPECT_LT(fit.intensity_of(0.5), 0.5);
  fit.collapse = fit_collapse({{0.3, 4, 0}, {1.2, 4, 4}});
  EXPECT_TRUE(std::isnan(fit.probability(0.5)));
  EXPECT_TRUE(std::isnan(fit.intensity_of(0.5)));
}

}  // namespace
}  // namespace bentur
