#include "bentur/study/fragility/ida_fragility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Kind = Fragility::Kind;

double phi(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// Each record has a capacity per case, lognormal about the case's θ, the same standard normal in all cases.
OutcomeTable synthetic(const std::vector<double>& medians, double dispersion, std::size_t records) {
  OutcomeTable table;
  for (int i = 1; i <= 20; ++i) table.levels.push_back(0.05 * i);
  table.cases = medians.size();
  table.records = records;
  for (const double median : medians) {
    std::mt19937_64 generator(7);
    for (std::size_t record = 0; record < records; ++record) {
      double sum = 0;  // of twelve uniforms: close to normal
      for (int i = 0; i < 12; ++i) sum += static_cast<double>(generator() >> 11U) * 0x1p-53;
      const double capacity = median * std::exp(dispersion * (sum - 6));
      for (const double level : table.levels) {
        table.outcomes.push_back(level > capacity ? Outcome::event : Outcome::no_event);
      }
    }
  }
  return table;
}

TEST(IdaFragility, FindsWhatTheDataWereMadeWith) {
  const OutcomeTable table = synthetic({0.2, 0.4}, 0.3, 400);
  for (const std::size_t c : {0U, 1U}) {
    const CaseFragility found = fit_case(table, c, {.resamples = 200});
    EXPECT_EQ(found.runs, 400 * 20);
    ASSERT_EQ(found.fit.kind, Kind::fitted);
    // Four standard errors of 400 capacities: β/√n of ln θ, β/√(2n) of β.
    EXPECT_NEAR(std::log(found.fit.median / (c == 0 ? 0.2 : 0.4)), 0, 4 * 0.3 / 20);
    EXPECT_NEAR(found.fit.dispersion, 0.3, 4 * 0.3 / std::sqrt(800) + 0.01);
    ASSERT_TRUE(found.bounds.has_value());
    EXPECT_LT(found.bounds->median.lower, found.fit.median);
    EXPECT_GT(found.bounds->median.upper, found.fit.median);
  }
}

TEST(IdaFragility, RecordsTogetherAreResampledTogether) {
  // Every record twice, as one that comes out the same both ways round: the bounds are those of the records once.
  const OutcomeTable once = synthetic({0.3}, 0.3, 40);
  OutcomeTable twice = once;
  twice.records = 80;
  twice.outcomes.clear();
  for (std::size_t record = 0; record < 40; ++record) {
    for (int i = 0; i < 2; ++i) {
      for (std::size_t level = 0; level < 20; ++level) twice.outcomes.push_back(once.at(0, record, level));
    }
  }
  const FragilityBounds alone = fit_case(once, 0, {.resamples = 200}).bounds.value();
  const FragilityBounds apart = fit_case(twice, 0, {.resamples = 200}).bounds.value();
  twice.together = 2;
  const FragilityBounds together = fit_case(twice, 0, {.resamples = 200}).bounds.value();
  EXPECT_NEAR(together.median.lower, alone.median.lower, 1e-9);
  EXPECT_NEAR(together.median.upper, alone.median.upper, 1e-9);
  EXPECT_LT(apart.median.upper - apart.median.lower, 0.9 * (alone.median.upper - alone.median.lower));
  twice.together = 3;
  EXPECT_THROW((void)fit_case(twice, 0, {}), InvalidParameter);
}

TEST(IdaFragility, CountsAreThoseOfTheTableWithoutFailedRuns) {
  OutcomeTable table = synthetic({0.3}, 0.3, 10);
  table.outcomes[3] = Outcome::failed;
  const CaseFragility found = fit_case(table, 0, {.resamples = 20});
  EXPECT_EQ(found.failed, 1);
  EXPECT_EQ(found.runs, 199);
  EXPECT_EQ(found.counts[3].runs, 9);
  long events = 0;
  for (std::size_t record = 0; record < 10; ++record) events += table.at(0, record, 7) == Outcome::event ? 1 : 0;
  EXPECT_EQ(found.counts[7].events, events);
  std::vector<IntensityCount> counts = found.counts;
  EXPECT_EQ(fit_fragility(counts).median, found.fit.median);
  table.records = 9;
  EXPECT_THROW((void)fit_case(table, 0, {}), InvalidParameter);
}

OutcomeTable of_levels(const std::vector<double>& levels, std::vector<Outcome> outcomes) {
  return {levels, 1, outcomes.size() / levels.size(), std::move(outcomes)};
}

TEST(IdaFragility, ProbabilitiesWhereNothingCanBeFitted) {
  const Outcome yes = Outcome::event, no = Outcome::no_event;
  const auto fit = [](const OutcomeTable& table) { return fit_case(table, 0, {.resamples = 10}); };
  const CaseFragility never = fit(of_levels({0.1, 0.2}, {no, no, no, no}));
  EXPECT_EQ(never.fit.kind, Kind::no_event);
  EXPECT_EQ(never.probability(0.2), 0);
  const CaseFragility always = fit(of_levels({0.1, 0.2}, {yes, yes, yes, yes}));
  EXPECT_EQ(always.probability(0.1), 1);
  const CaseFragility step = fit(of_levels({0.1, 0.2, 0.3}, {no, yes, yes, no, yes, yes}));
  EXPECT_EQ(step.fit.kind, Kind::separated);
  EXPECT_EQ(step.probability(0.1), 0);
  EXPECT_EQ(step.probability(0.11), 1);  // not known: the safe side
  EXPECT_EQ(step.probability(0.3), 1);
  const CaseFragility tie = fit(of_levels({0.1, 0.2, 0.3}, {no, yes, yes, no, no, yes}));
  EXPECT_EQ(tie.fit.kind, Kind::separated);
  EXPECT_EQ(tie.probability(0.15), 0);
  EXPECT_EQ(tie.probability(0.2), 1);
  const CaseFragility stripe = fit(of_levels({0.4}, {no, yes, no, no}));
  EXPECT_EQ(stripe.fit.kind, Kind::one_intensity);
  EXPECT_EQ(stripe.probability(0.4), 0.25);
  const CaseFragility falling = fit(of_levels({0.1, 0.2}, {yes, no, yes, no}));
  EXPECT_FALSE(falling.probability(0.1).has_value());
  const CaseFragility nothing = fit(of_levels({0.1}, {Outcome::failed, Outcome::failed}));
  EXPECT_EQ(nothing.fit.kind, Kind::no_data);
  EXPECT_FALSE(nothing.probability(0.1).has_value());
}

TEST(IdaFragility, OneRecordHasNoBounds) {
  const Outcome yes = Outcome::event, no = Outcome::no_event;
  const CaseFragility one = fit_case(of_levels({0.1, 0.2, 0.3, 0.4}, {no, yes, no, yes}), 0, {});
  EXPECT_EQ(one.fit.kind, Kind::fitted);
  EXPECT_FALSE(one.bounds.has_value());
}

/// Demands lognormal about a power of intensities that are all different.
OutcomeTable unscaled(std::size_t records, double threshold) {
  OutcomeTable table{.levels = {std::nan("")}, .cases = 1, .records = records, .outcomes = {}};
  table.threshold = threshold;
  std::mt19937_64 generator(11);
  const auto normal = [&] {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(generator() >> 11U) * 0x1p-53;
    return sum - 6;
  };
  for (std::size_t record = 0; record < records; ++record) {
    const double x = std::exp(0.5 * normal());
    const double demand = 0.3 * std::pow(x, 1.2) * std::exp(0.4 * normal());
    table.own.push_back(x);
    table.demands.push_back(demand);
    table.collapsed.push_back(0);
    table.outcomes.push_back(demand > threshold ? Outcome::event : Outcome::no_event);
  }
  return table;
}

TEST(IdaFragility, ACloudOfUnscaledRecordsFindsWhatItWasMadeWith) {
  const OutcomeTable table = unscaled(2000, 0.3);  // θ = 1, β = 0.4/1.2
  const CaseFragility likely = fit_case(table, 0, {.resamples = 50});
  const CaseFragility cloud = fit_case(table, 0, {.resamples = 50}, FragilityMethod::cloud);
  for (const CaseFragility* const one : {&likely, &cloud}) {
    ASSERT_EQ(one->fit.kind, Kind::fitted);
    EXPECT_EQ(one->runs, 2000);
    EXPECT_EQ(one->counts.size(), 2000U);
    // Four standard errors, of the likelihood some 1.6 times those of the line.
    EXPECT_NEAR(std::log(one->fit.median), 0, 4 * 1.6 * 0.33 / std::sqrt(2000));
    EXPECT_NEAR(one->fit.dispersion, 0.4 / 1.2, 4 * 1.6 * 0.33 / std::sqrt(2000));
    EXPECT_TRUE(one->bounds.has_value());
  }
  EXPECT_TRUE(std::is_sorted(likely.counts.begin(), likely.counts.end(),
                             [](const auto& a, const auto& b) { return a.intensity < b.intensity; }));
  // One run is no share of runs: no distance of the likelihood, and of the cloud that of its residuals.
  EXPECT_FALSE(likely.distance().has_value());
  EXPECT_FALSE(likely.is_misfit());
  EXPECT_LT(cloud.distance().value(), fit_distance_limit(2000));
  EXPECT_FALSE(cloud.is_misfit());
}

TEST(IdaFragility, ACloudWhoseResidualsAreTwoHeapsIsAMisfit) {
  OutcomeTable table = unscaled(200, 0.3);
  for (std::size_t i = 0; i < table.demands.size(); ++i) {
    table.own[i] = table.own[i / 2 * 2];  // two records of each intensity, so that the line lies between the heaps
    table.demands[i] = 0.3 * table.own[i] * (i % 2 == 0 ? 2 : 0.5);
  }
  const CaseFragility cloud = fit_case(table, 0, {.resamples = 2}, FragilityMethod::cloud);
  // Half of them at +1 σ, the others at −1 σ, but for n in place of n − 2: 0.5 − Φ(−1) from the normal distribution.
  EXPECT_NEAR(cloud.distance().value(), phi(std::sqrt(198.0 / 200)) - 0.5, 1e-12);
  EXPECT_TRUE(cloud.is_misfit());
}

TEST(IdaFragility, BothDirectionsOfAnUnscaledRecordAreOneIntensity) {
  OutcomeTable table{.levels = {std::nan("")}, .cases = 1, .records = 6, .outcomes = {}, .together = 2};
  const Outcome yes = Outcome::event, no = Outcome::no_event;
  table.own = {2, 2, 1, 1, 3, 3};
  table.outcomes = {yes, no, no, no, yes, yes};
  const CaseFragility found = fit_case(table, 0, {.resamples = 5});
  ASSERT_EQ(found.counts.size(), 3U);
  EXPECT_EQ(found.counts[0].intensity, 1);
  EXPECT_EQ(found.counts[1].runs, 2);
  EXPECT_EQ(found.counts[1].events, 1);
  table.own.pop_back();
  EXPECT_THROW((void)fit_case(table, 0, {}), InvalidParameter);
}

TEST(GapEstimate, IsThatOfTheFitsWithBoundsAroundIt) {
  const OutcomeTable table = synthetic({0.2, 0.4, 0.8}, 0.4, 60);
  std::vector<CaseFragility> cases;
  std::vector<const CaseFragility*> all;
  for (std::size_t c = 0; c < 3; ++c) cases.push_back(fit_case(table, c, {.resamples = 300}));
  for (const CaseFragility& one : cases) all.push_back(&one);
  const std::vector<double> widths = {0.1, 0.2, 0.4};
  const double at = 0.4, p = 0.1;
  const GapEstimate found = gap_estimate(widths, all, at, p, 0.9);
  std::vector<double> probabilities;
  for (const CaseFragility& one : cases) {
    probabilities.push_back(phi(std::log(at / one.fit.median) / one.fit.dispersion));
  }
  ASSERT_TRUE(found.gap.has_value());
  EXPECT_EQ(found.gap->kind, GapForProbability::Kind::between);
  EXPECT_NEAR(found.gap->width, gap_for_probability(widths, probabilities, p).width, 1e-12);
  ASSERT_TRUE(found.bounds.has_value());
  EXPECT_LT(found.bounds->lower, found.gap->width);
  EXPECT_GT(found.bounds->upper, found.gap->width);
  EXPECT_LT(found.bounds->upper - found.bounds->lower, 0.2);
  // A rare enough event asks for more than the widest.
  const GapEstimate more = gap_estimate(widths, all, 1.0, 0.01, 0.9);
  EXPECT_EQ(more.gap->kind, GapForProbability::Kind::beyond);
  EXPECT_EQ(more.bounds->upper, std::numeric_limits<double>::infinity());
}

TEST(GapEstimate, IsNothingWhereAProbabilityIsNotKnown) {
  const Outcome yes = Outcome::event, no = Outcome::no_event;
  const CaseFragility falling = fit_case(of_levels({0.1, 0.2}, {yes, no, yes, no}), 0, {.resamples = 10});
  const CaseFragility never = fit_case(of_levels({0.1, 0.2}, {no, no, no, no}), 0, {.resamples = 10});
  EXPECT_FALSE(gap_estimate({0.1, 0.2}, {&falling, &never}, 0.1, 0.1, 0.95).gap.has_value());
  const CaseFragility always = fit_case(of_levels({0.1, 0.2}, {yes, yes, yes, yes}), 0, {.resamples = 10});
  const GapEstimate step = gap_estimate({0.1, 0.2}, {&always, &never}, 0.1, 0.1, 0.95);
  EXPECT_EQ(step.gap->kind, GapForProbability::Kind::between);
  EXPECT_EQ(step.gap->width, 0.2);  // nothing to interpolate: the safe side
  EXPECT_FALSE(step.bounds.has_value());
}

}  // namespace
}  // namespace bentur
