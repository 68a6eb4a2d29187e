#include "bentur/study/fragility/demand_fits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "bentur/core/errors.h"
#include "bentur/study/design/distribution.h"
#include "bentur/study/fragility/ida_fragility.h"

namespace bentur {
namespace {

TEST(Cloud, ByHand) {  // ln x = 0, 1, 2; ln d = 0, 1.5, 2: b = 1, a = 1/6, residuals −1/6, 1/3, −1/6
  const double e = std::exp(1.0);
  const std::vector<RunDemand> demands = {{1, 1, false}, {e, std::exp(1.5), false}, {e * e, std::exp(2.0), false}};
  const auto cloud = fit_cloud(demands);
  ASSERT_TRUE(cloud);
  EXPECT_NEAR(cloud->b, 1, 1e-14);
  EXPECT_NEAR(cloud->a, 1.0 / 6, 1e-14);
  EXPECT_NEAR(cloud->sigma, std::sqrt(1.0 / 6), 1e-14);  // Σ ε² = 1/6 over one degree of freedom
  EXPECT_NEAR(cloud->determination, 1 - (1.0 / 6) / (13.0 / 6), 1e-14);
  EXPECT_EQ(cloud->runs, 3);
  const Fragility fit = cloud_fragility(*cloud, 10);
  EXPECT_EQ(fit.kind, Fragility::Kind::fitted);
  EXPECT_NEAR(fit.median, 10 * std::exp(-1.0 / 6), 1e-12);
  EXPECT_NEAR(fit.dispersion, std::sqrt(1.0 / 6), 1e-14);
  EXPECT_NEAR(fit.probability(fit.median), 0.5, 1e-15);
}

TEST(Cloud, CollapsesAndDemandsOfNothingAreNoPartOfIt) {
  std::vector<RunDemand> demands = {{1, 2, false}, {2, 5, false}, {3, 7, false}, {4, 11, false}};
  const auto plain = fit_cloud(demands);
  demands.push_back({4, 500, true});
  demands.push_back({1, 0, false});
  const auto more = fit_cloud(demands);
  EXPECT_EQ(plain->a, more->a);
  EXPECT_EQ(plain->sigma, more->sigma);
  EXPECT_EQ(more->runs, 4);
}

TEST(Cloud, WhatCannotBeFittedIsNot) {
  EXPECT_FALSE(fit_cloud({}));
  EXPECT_FALSE(fit_cloud({{1, 2, false}, {2, 3, false}}));
  EXPECT_FALSE(fit_cloud({{1, 2, false}, {1, 3, false}, {1, 4, false}}));
  EXPECT_THROW((void)fit_cloud({{0, 2, false}}), InvalidParameter);
  const auto falling = fit_cloud({{1, 4, false}, {2, 3, false}, {3, 2, false}});
  EXPECT_EQ(cloud_fragility(*falling, 1).kind, Fragility::Kind::falling);
  EXPECT_THROW((void)cloud_fragility(*falling, 0), InvalidParameter);
}

TEST(Cloud, UnitsDoNotMatter) {
  const std::vector<RunDemand> metres = {{1, 0.02, false}, {2, 0.05, false}, {3, 0.04, false}, {4, 0.11, false}};
  std::vector<RunDemand> millimetres = metres;
  for (RunDemand& one : millimetres) {
    one.value *= 1000;
    one.intensity *= 9.80665;
  }
  const Fragility a = cloud_fragility(*fit_cloud(metres), 0.06), b = cloud_fragility(*fit_cloud(millimetres), 60);
  EXPECT_NEAR(b.median / a.median, 9.80665, 1e-11);
  EXPECT_NEAR(b.dispersion, a.dispersion, 1e-13);
}

TEST(Stripes, ByHand) {
  const double e = std::exp(1.0);
  // At 1: ln d = −1, 1: η = 1, β_d = √2; at 2 one of four collapses, the others have d = e: η = e, β_d = 0.
  const auto stripes =
      stripes_of({{2, e, false}, {1, 1 / e, false}, {2, e, false}, {1, e, false}, {2, 99, true}, {2, e, false}});
  ASSERT_EQ(stripes.size(), 2U);
  EXPECT_EQ(stripes[0].intensity, 1);
  EXPECT_NEAR(stripes[0].median, 1, 1e-15);
  EXPECT_NEAR(stripes[0].dispersion, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(stripes[0].probability(1), 0.5, 1e-15);
  EXPECT_NEAR(stripes[0].probability(e), normal_probability(-1 / std::sqrt(2.0)), 1e-15);
  EXPECT_EQ(stripes[1].collapsed, 1);
  EXPECT_NEAR(stripes[1].probability(2), 1, 1e-15);
  EXPECT_NEAR(stripes[1].probability(3), 0.25, 1e-15);
}

TEST(Stripes, AllGoneOrNothingAsked) {
  const auto stripes = stripes_of({{1, 0, false}, {1, 0, false}, {2, 0, true}, {3, 0, false}, {3, 4, false}});
  EXPECT_EQ(stripes[0].probability(1), 0);
  EXPECT_EQ(stripes[1].probability(1), 1);
  EXPECT_EQ(stripes[2].probability(1), 0.5) << "half of the runs have no demand at all";
}

TEST(Stripes, LognormalProbabilitiesGiveTheirThetaAndBetaBack) {
  const double theta = 0.4, beta = 0.3, threshold = 2;
  std::vector<Stripe> stripes;
  for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0}) {  // η/d = (x/θ)^(β_d/β)
    Stripe stripe{.intensity = x, .runs = 20, .dispersion = 0.5};
    stripe.median = threshold * std::pow(x / theta, stripe.dispersion / beta);
    stripes.push_back(stripe);
  }
  const Fragility fit = stripe_fragility(stripes, threshold);
  EXPECT_EQ(fit.kind, Fragility::Kind::fitted);
  EXPECT_NEAR(fit.median / theta, 1, 1e-6);  // probabilities are rounded to parts of 20 million
  EXPECT_NEAR(fit.dispersion / beta, 1, 1e-5);
}

/// Two cases alike of 12 records at four levels, ln d = 0.9 ln x + a number of the record + one of the run.
OutcomeTable by_chance(std::size_t together) {
  OutcomeTable table{.levels = {0.1, 0.2, 0.4, 0.8}, .cases = 1, .records = 12, .outcomes = {}, .together = together};
  table.threshold = 0.3;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (std::size_t record = 0; record < table.records; ++record) {
    const double own = 0.3 * normal(random);
    for (const double level : table.levels) {
      table.demands.push_back(std::exp(0.9 * std::log(level) + own + 0.1 * normal(random)));
      table.collapsed.push_back(0);
      table.outcomes.push_back(table.demands.back() > 0.3 ? Outcome::event : Outcome::no_event);
    }
  }
  return table;
}

TEST(Bounds, OfCloudsAndStripesComeFromWholeRecords) {
  for (const FragilityMethod method : {FragilityMethod::cloud, FragilityMethod::stripes}) {
    const CaseFragility found = fit_case(by_chance(1), 0, {.resamples = 400}, method);
    ASSERT_TRUE(found.bounds);
    EXPECT_EQ(found.bounds->usable, 400);
    EXPECT_LT(found.bounds->median.lower, found.fit.median);
    EXPECT_GT(found.bounds->median.upper, found.fit.median);
    // The record's own part dominates: with √(0.3²/12) = 0.087 the bounds of ln θ are about ±1.96 · 0.087/0.9.
    const double width = std::log(found.bounds->median.upper / found.bounds->median.lower);
    EXPECT_NEAR(width, 2 * 1.96 * 0.087 / 0.9, 0.15);
    const CaseFragility pairs = fit_case(by_chance(2), 0, {.resamples = 400}, method);
    EXPECT_EQ(pairs.fit.median, found.fit.median);
    EXPECT_NE(pairs.bounds->median.lower, found.bounds->median.lower);  // six records are drawn, each both ways round
    const CaseFragility again = fit_case(by_chance(1), 0, {.resamples = 400}, method);
    EXPECT_EQ(again.bounds->median.lower, found.bounds->median.lower);
  }
  EXPECT_FALSE(fit_case(by_chance(12), 0, {}, FragilityMethod::cloud).bounds);
}

/// The same, and the more probably collapsed the larger the level is.
OutcomeTable by_chance_with_collapses() {
  OutcomeTable table = by_chance(1);
  for (std::size_t run = 0; run < table.outcomes.size(); ++run) {
    const std::size_t record = run / 4, level = run % 4;
    if ((5 * record + level) % 12 >= 3 * level) continue;  // 0, 3, 6, 9 of 12 records
    table.collapsed[run] = 1;
    table.outcomes[run] = Outcome::event;
  }
  return table;
}

TEST(FitCase, OfACloudSaysWhatIsOfAllRuns) {
  const OutcomeTable table = by_chance_with_collapses();
  const CaseFragility found = fit_case(table, 0, {.resamples = 300}, FragilityMethod::cloud);
  ASSERT_TRUE(found.fit.collapse);
  EXPECT_EQ(found.fit.collapse->kind, CollapseFit::Kind::fitted);
  EXPECT_EQ(found.fit.collapse->collapsed, 18);
  const auto all = found.of_all();
  ASSERT_TRUE(all);
  EXPECT_NEAR(*found.probability(all->median), 0.5, 1e-12);
  EXPECT_LT(all->median, found.fit.median);
  ASSERT_TRUE(all->median_bounds);
  EXPECT_LT(all->median_bounds->lower, all->median);
  EXPECT_GT(all->median_bounds->upper, all->median);
  EXPECT_GT(all->usable, 290);
  // The distance is of all runs from the curve of all.
  double largest = 0;
  for (const IntensityCount& one : found.counts) {
    const double share = static_cast<double>(one.events) / static_cast<double>(one.runs);
    largest = std::max(largest, std::abs(share - *found.probability(one.intensity)));
  }
  EXPECT_NEAR(found.distance().value(), largest, 1e-15);
  EXPECT_FALSE(fit_case(by_chance(1), 0, {.resamples = 2}, FragilityMethod::cloud).of_all());
}

TEST(FitCase, OfACloudOfWhichAllCollapseHasTheEventAlways) {
  OutcomeTable table = by_chance(1);
  table.collapsed.assign(table.collapsed.size(), 1);
  table.outcomes.assign(table.outcomes.size(), Outcome::event);
  const CaseFragility found = fit_case(table, 0, {.resamples = 2}, FragilityMethod::cloud);
  EXPECT_EQ(found.fit.kind, Fragility::Kind::all_events);
  EXPECT_EQ(found.probability(0.2), 1);
  EXPECT_FALSE(found.cloud);
}

TEST(Distance, IsTheLargestOfTheLevels) {
  Fragility fit;
  fit.kind = Fragility::Kind::fitted;
  fit.median = 1;
  fit.dispersion = 1;
  // Φ(0) = 0.5 against 0.75; Φ(1) = 0.8413 against 1
  const std::vector<IntensityCount> counts = {{1, 4, 3}, {std::exp(1.0), 5, 5}, {9, 0, 0}};
  EXPECT_NEAR(fit_distance(counts, fit).value(), 0.25, 1e-15);
  EXPECT_FALSE(is_extrapolated(counts, fit));
  fit.median = 3;  // the largest level with runs is e
  EXPECT_TRUE(is_extrapolated(counts, fit));
  fit.median = 0.9;
  EXPECT_TRUE(is_extrapolated(counts, fit));
  fit.kind = Fragility::Kind::no_event;
  EXPECT_FALSE(fit_distance(counts, fit));
  EXPECT_FALSE(is_extrapolated(counts, fit));
}

/// Of records with these capacities, the intensities from which on they have the event, at 20 levels.
std::vector<IntensityCount> counts_of(const std::vector<double>& capacities) {
  std::vector<IntensityCount> counts;
  for (int level = 0; level < 20; ++level) {
    IntensityCount one{0.1 * std::pow(10.0, level / 9.5), static_cast<long>(capacities.size()), 0};
    one.events = std::count_if(capacities.begin(), capacities.end(), [&](double c) { return c <= one.intensity; });
    counts.push_back(one);
  }
  return counts;
}

TEST(Distance, OfALognormalIsSeldomTooLargeAndOfTwoGroupsOften) {
  EXPECT_NEAR(fit_distance_limit(20), 0.19238, 5e-6);  // by hand: 0.895/(4.47214 − 0.01 + 0.19007)
  long misfits = 0, found = 0, fitted = 0;
  constexpr unsigned samples = 400;
  for (unsigned seed = 1; seed <= samples; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> one(20), two(20);
    for (double& capacity : one) capacity = std::exp(0.5 * normal(random));
    for (std::size_t i = 0; i < two.size(); ++i) two[i] = (i % 2 == 0 ? 0.2 : 3.0) * std::exp(0.1 * normal(random));
    const auto of_one = counts_of(one), of_two = counts_of(two);
    const Fragility fit = fit_fragility(of_one), unfit = fit_fragility(of_two);
    fitted += fit.kind == Fragility::Kind::fitted ? 1 : 0;
    misfits += is_misfit(of_one, fit) ? 1 : 0;
    found += is_misfit(of_two, unfit) ? 1 : 0;
  }
  EXPECT_EQ(fitted, samples);
  EXPECT_LT(misfits, samples / 20);
  EXPECT_GT(found, samples * 9 / 10);
}

/// One case of four records at two levels.
OutcomeTable table() {
  OutcomeTable made{.levels = {1, 2}, .cases = 1, .records = 4, .outcomes = {}};
  const auto run = [&](double demand, bool collapsed) {
    made.outcomes.push_back(demand > 3 || collapsed ? Outcome::event : Outcome::no_event);
    made.demands.push_back(demand);
    made.collapsed.push_back(collapsed ? 1 : 0);
  };
  const std::vector<std::tuple<double, double, bool>> records = {
      {1.0, 4.0, false}, {2.0, 5.0, true}, {3.5, 6.0, false}, {1.5, 2.0, false}};
  for (const auto& [low, high, gone] : records) {
    run(low, false);
    run(high, gone);
  }
  made.threshold = 3;
  return made;
}

TEST(CollapseSplitOff, CountsEachByItself) {
  const CaseFragility found = fit_case(table(), 0, {.resamples = 2});
  EXPECT_EQ(found.counts[0].events, 1);
  EXPECT_EQ(found.counts[1].events, 3);
  ASSERT_TRUE(found.split);
  EXPECT_EQ(found.split->collapse_counts[0].events, 0);
  EXPECT_EQ(found.split->collapse_counts[1].events, 1);
  EXPECT_EQ(found.split->collapse_counts[1].runs, 4);
  EXPECT_EQ(found.split->standing_counts[1].runs, 3);
  EXPECT_EQ(found.split->standing_counts[1].events, 2);
  EXPECT_EQ(found.split->standing.median, fit_fragility(found.split->standing_counts).median);
  OutcomeTable none = table();
  none.collapsed.assign(none.collapsed.size(), 0);
  EXPECT_FALSE(fit_case(none, 0, {.resamples = 2}).split);
}

TEST(FitCase, ByCloudAndByStripesIsThatOfItsDemands) {
  std::vector<RunDemand> demands;
  const OutcomeTable given = table();
  for (std::size_t i = 0; i < given.demands.size(); ++i) {
    demands.push_back({given.levels[i % 2], given.demands[i], given.collapsed[i] != 0});
  }
  const CaseFragility cloud = fit_case(given, 0, {}, FragilityMethod::cloud);
  EXPECT_EQ(cloud.fit.median, cloud_fragility(*fit_cloud(demands), 3).median);
  // The one that collapses does so at the higher of two levels: no logistic curve, and all is of those that stand.
  ASSERT_TRUE(cloud.fit.collapse);
  EXPECT_EQ(cloud.fit.collapse->kind, CollapseFit::Kind::separated);
  EXPECT_FALSE(cloud.probability(1.5));
  EXPECT_FALSE(fit_distance(cloud.counts, cloud.fit));
  const Fragility standing = cloud_fragility(*fit_cloud(demands), 3);
  EXPECT_NEAR(cloud.distance().value(), fit_distance(cloud.split->standing_counts, standing).value(), 1e-15);
  const CaseFragility stripes = fit_case(given, 0, {}, FragilityMethod::stripes);
  EXPECT_EQ(stripes.fit.median, stripe_fragility(stripes_of(demands), 3).median);
  EXPECT_EQ(stripes.stripes[1].collapsed, 1);
  OutcomeTable blind = given;
  blind.threshold.reset();
  EXPECT_THROW((void)fit_case(blind, 0, {}, FragilityMethod::cloud), InvalidParameter);
}

}  // namespace
}  // namespace bentur
