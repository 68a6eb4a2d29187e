#include "bentur/study/fragility/fragility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Kind = Fragility::Kind;
using Counts = std::vector<IntensityCount>;

double normal(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// `runs` runs at each intensity with the probability of (1).
Counts synthetic(double median, double dispersion, const std::vector<double>& intensities, int runs, unsigned seed) {
  std::mt19937_64 generator(seed);
  Counts counts;
  for (const double x : intensities) {
    const double p = normal(std::log(x / median) / dispersion);
    long events = 0;
    for (int i = 0; i < runs; ++i) events += static_cast<double>(generator() >> 11U) * 0x1p-53 < p ? 1 : 0;
    counts.push_back({x, runs, events});
  }
  return counts;
}

const std::vector<double> levels = {0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.2, 1.6};

/// Standard errors of ln θ and ln β by the theory of maximum likelihood: the inverse of the expected information, from
/// the slopes of P by differences.
void standard_errors(double median, double dispersion, int runs, double& of_median, double& of_dispersion) {
  double mm = 0, md = 0, dd = 0;
  for (const double x : levels) {
    const auto p = [&](double m, double d) { return normal(std::log(x / m) / d); };
    const double h = 1e-5;
    const double pm = (p(median * std::exp(h), dispersion) - p(median * std::exp(-h), dispersion)) / (2 * h);
    const double pd = (p(median, dispersion * std::exp(h)) - p(median, dispersion * std::exp(-h))) / (2 * h);
    const double z = std::log(x / median) / dispersion;
    const double q = normal(z) * normal(-z);
    mm += runs * pm * pm / q;
    md += runs * pm * pd / q;
    dd += runs * pd * pd / q;
  }
  of_median = std::sqrt(dd / (mm * dd - md * md));
  of_dispersion = std::sqrt(mm / (mm * dd - md * md));
}

TEST(Fragility, FindsTheParametersOfSyntheticDataWithinSamplingError) {
  for (const double median : {0.25, 0.45, 0.8}) {
    for (const double dispersion : {0.2, 0.4, 0.7}) {
      const int runs = 200, repetitions = 200;
      double sum_median = 0, sum_dispersion = 0, square_median = 0, square_dispersion = 0;
      double error_median = 0, error_dispersion = 0;
      standard_errors(median, dispersion, runs, error_median, error_dispersion);
      for (unsigned seed = 0; seed < repetitions; ++seed) {
        const Fragility fit = fit_fragility(synthetic(median, dispersion, levels, runs, 1000 + seed));
        ASSERT_EQ(fit.kind, Kind::fitted);
        const double m = std::log(fit.median / median), d = std::log(fit.dispersion / dispersion);
        sum_median += m;
        sum_dispersion += d;
        square_median += m * m;
        square_dispersion += d * d;
      }
      // Means: four standard errors of a mean, and for the bias of order 1/runs, which is smaller than the spread of a
      // single fit squared. Spreads: a standard deviation from 200 fits is itself uncertain by 1/√400 = 5 %.
      const double root = std::sqrt(1.0 * repetitions);
      EXPECT_NEAR(sum_median / repetitions, 0, 4 * error_median / root + error_median * error_median);
      EXPECT_NEAR(sum_dispersion / repetitions, 0, 4 * error_dispersion / root + error_dispersion * error_dispersion);
      EXPECT_NEAR(std::sqrt(square_median / repetitions) / error_median, 1, 0.2) << median << ' ' << dispersion;
      EXPECT_NEAR(std::sqrt(square_dispersion / repetitions) / error_dispersion, 1, 0.2) << median << ' ' << dispersion;
    }
  }
}

TEST(Fragility, IsTheMaximumOfTheLikelihood) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Counts counts = synthetic(0.4, 0.5, levels, 6, seed);
    const Fragility fit = fit_fragility(counts);
    ASSERT_EQ(fit.kind, Kind::fitted);
    EXPECT_NEAR(log_likelihood(counts, fit.median, fit.dispersion), fit.log_likelihood,
                1e-12 * std::abs(fit.log_likelihood));
    double best = -std::numeric_limits<double>::infinity(), best_m = 0, best_d = 0;
    for (int i = -60; i <= 60; ++i) {
      for (int j = -60; j <= 60; ++j) {
        const double m = fit.median * std::exp(0.02 * i), d = fit.dispersion * std::exp(0.03 * j);
        const double value = log_likelihood(counts, m, d);
        if (value > best) {
          best = value;
          best_m = m;
          best_d = d;
        }
      }
    }
    EXPECT_NEAR(best_m / fit.median, 1, 1e-12) << "the grid has the fit itself in its middle";
    EXPECT_NEAR(best_d / fit.dispersion, 1, 1e-12);
    EXPECT_LE(best, fit.log_likelihood + 1e-12 * std::abs(best));
  }
}

// The likelihood has zero slope at the fit: Σ (k − nP) φ/(P(1−P)) = 0 and the same weighted with ln x.
TEST(Fragility, TheSlopesOfTheLikelihoodVanish) {
  const Counts counts = synthetic(0.4, 0.5, levels, 40, 7);
  const Fragility fit = fit_fragility(counts);
  double slope = 0, weighted = 0, size = 0;
  for (const IntensityCount& one : counts) {
    const double z = std::log(one.intensity / fit.median) / fit.dispersion, p = normal(z);
    const double term =
        (static_cast<double>(one.events) - static_cast<double>(one.runs) * p) * std::exp(-z * z / 2) / (p * (1 - p));
    slope += term;
    weighted += term * std::log(one.intensity);
    size += std::abs(term);
  }
  EXPECT_NEAR(slope, 0, 1e-11 * size);  // the step Newton's method stops at is 1e-13
  EXPECT_NEAR(weighted, 0, 1e-11 * size);
}

TEST(Fragility, TwoIntensitiesAreMetExactly) {
  const Fragility fit = fit_fragility({{1.0, 10, 2}, {3.0, 20, 14}});
  ASSERT_EQ(fit.kind, Kind::fitted);
  EXPECT_NEAR(fit.probability(1.0), 0.2, 1e-12);
  EXPECT_NEAR(fit.probability(3.0), 0.7, 1e-12);
  EXPECT_NEAR(fit.intensity_of(0.2), 1.0, 1e-12);
  EXPECT_NEAR(fit.intensity_of(0.7), 3.0, 3e-12);
  EXPECT_NEAR(fit.intensity_of(0.5), fit.median, 1e-15);
}

TEST(Fragility, UnitOrderAndDivisionOfTheDataDoNotMatter) {
  const Counts counts = synthetic(0.4, 0.5, levels, 12, 3);
  const Fragility fit = fit_fragility(counts);
  Counts scaled = counts, repeated = counts, single;
  for (IntensityCount& one : scaled) one.intensity *= 981;
  for (IntensityCount& one : repeated) {
    one.runs *= 1000;
    one.events *= 1000;
  }
  for (auto one = counts.rbegin(); one != counts.rend(); ++one) {
    for (long i = 0; i < one->runs; ++i) single.push_back({one->intensity, 1, i < one->events ? 1 : 0});
  }
  EXPECT_NEAR(fit_fragility(scaled).median / (981 * fit.median), 1, 1e-11);
  EXPECT_NEAR(fit_fragility(scaled).dispersion / fit.dispersion, 1, 1e-11);
  EXPECT_NEAR(fit_fragility(repeated).median / fit.median, 1, 1e-11);
  EXPECT_NEAR(fit_fragility(repeated).log_likelihood / (1000 * fit.log_likelihood), 1, 1e-11);
  EXPECT_EQ(fit_fragility(single).median, fit.median);
  EXPECT_EQ(fit_fragility(single).dispersion, fit.dispersion);
}

TEST(Fragility, EventsAndTheirAbsenceAreMirrorImages) {
  const Counts counts = synthetic(0.4, 0.5, levels, 12, 4);
  Counts mirrored = counts;  // x → 1/x, events ↔ none
  for (IntensityCount& one : mirrored) one = {1 / one.intensity, one.runs, one.runs - one.events};
  const Fragility fit = fit_fragility(counts), other = fit_fragility(mirrored);
  EXPECT_NEAR(other.median * fit.median, 1, 1e-11);
  EXPECT_NEAR(other.dispersion / fit.dispersion, 1, 1e-11);
}

TEST(Fragility, FindsSteepAndRareData) {
  const Fragility rare = fit_fragility({{1, 1000000, 0}, {2, 1000000, 1}, {4, 1000000, 30}, {8, 1000000, 2}});
  EXPECT_EQ(rare.kind, Kind::fitted);
  EXPECT_GT(rare.median, 100);
  const Fragility steep = fit_fragility({{1, 1000, 0}, {1.001, 1000, 1}, {1.002, 1000, 999}, {1.003, 1000, 1000}});
  ASSERT_EQ(steep.kind, Kind::fitted);
  EXPECT_NEAR(steep.median, 1.0015, 1e-6);
  EXPECT_NEAR(steep.dispersion, 0.0005 / 1.0015 / 3.0902, 2e-6);  // Φ(3.0902) = 0.999
  // One stray event a million dispersions away: Φ of it is no number of the machine.
  const Fragility stray = fit_fragility({{1e-3, 1000, 1}, {1.0, 1000, 500}, {1.001, 1000, 500}, {1e3, 1000, 1000}});
  EXPECT_EQ(stray.kind, Kind::fitted);
  EXPECT_TRUE(std::isfinite(log_likelihood({{1e-3, 10, 1}, {1e3, 10, 9}}, 1.0, 1e-3)));
}

TEST(Fragility, SeparatedDataHaveNoDispersion) {
  const Fragility fit = fit_fragility({{0.2, 5, 0}, {0.8, 5, 5}, {0.4, 5, 0}, {1.6, 1, 1}});
  EXPECT_EQ(fit.kind, Kind::separated);
  EXPECT_EQ(fit.dispersion, 0);
  EXPECT_EQ(fit.lower, 0.4);
  EXPECT_EQ(fit.upper, 0.8);
  EXPECT_NEAR(fit.median, std::sqrt(0.32), 1e-15);
  EXPECT_EQ(fit.log_likelihood, 0);
  EXPECT_EQ(fit.probability(0.3), 0);
  EXPECT_EQ(fit.probability(0.9), 1);
  EXPECT_EQ(fit.intensity_of(0.01), fit.median);

  const Fragility touching = fit_fragility({{0.2, 5, 0}, {0.4, 4, 1}, {0.8, 5, 5}});
  EXPECT_EQ(touching.kind, Kind::separated);
  EXPECT_EQ(touching.lower, 0.4);
  EXPECT_EQ(touching.upper, 0.4);
  EXPECT_NEAR(touching.log_likelihood, std::log(0.25) + 3 * std::log(0.75), 1e-15);
}

TEST(Fragility, DataThatSayTooLittleAreReportedAsSuch) {
  const Fragility none = fit_fragility({{0.2, 5, 0}, {0.4, 5, 0}});
  EXPECT_EQ(none.kind, Kind::no_event);
  EXPECT_EQ(none.lower, 0.4);
  EXPECT_TRUE(std::isinf(none.median));
  EXPECT_EQ(none.probability(100), 0);
  const Fragility all = fit_fragility({{0.2, 5, 5}, {0.4, 5, 5}});
  EXPECT_EQ(all.kind, Kind::all_events);
  EXPECT_EQ(all.upper, 0.2);
  EXPECT_EQ(all.median, 0);
  EXPECT_EQ(all.probability(0.01), 1);
  const Fragility one = fit_fragility({{0.2, 5, 2}, {0.2, 3, 0}});
  EXPECT_EQ(one.kind, Kind::one_intensity);
  EXPECT_TRUE(std::isnan(one.median));
  EXPECT_TRUE(std::isnan(one.probability(0.2)));
  EXPECT_EQ(fit_fragility({{0.2, 5, 5}, {0.4, 5, 0}}).kind, Kind::falling);
  EXPECT_EQ(fit_fragility({{0.2, 5, 4}, {0.4, 5, 3}, {0.8, 5, 1}}).kind, Kind::falling);
  EXPECT_EQ(fit_fragility({{0.2, 5, 3}, {0.4, 5, 3}}).kind, Kind::falling);
  EXPECT_EQ(fit_fragility({}).kind, Kind::no_data);
  EXPECT_EQ(fit_fragility({{0.2, 0, 0}}).kind, Kind::no_data);
}

TEST(Fragility, RefusesCountsThatCannotBe) {
  EXPECT_THROW((void)fit_fragility({{0, 5, 1}}), InvalidParameter);
  EXPECT_THROW((void)fit_fragility({{1, 5, 6}}), InvalidParameter);
  EXPECT_THROW((void)fit_fragility({{1, 5, -1}}), InvalidParameter);
  EXPECT_THROW((void)fit_fragility({{1, 5, 1}, {2, 5, 3}}).intensity_of(1), InvalidParameter);
  EXPECT_THROW((void)log_likelihood({{1, 5, 1}}, 1, 0), InvalidParameter);
}

/// One run per unit.
std::vector<Counts> single_runs(const Counts& counts) {
  std::vector<Counts> units;
  for (const IntensityCount& one : counts) {
    for (long i = 0; i < one.runs; ++i) units.push_back({{one.intensity, 1, i < one.events ? 1 : 0}});
  }
  return units;
}

TEST(FragilityBounds, AreAsWideAsTheSamplingError) {
  const Counts counts = synthetic(0.45, 0.4, levels, 100, 5);
  const Fragility fit = fit_fragility(counts);
  const FragilityBounds bounds = bootstrap_fragility(single_runs(counts), {.resamples = 1000, .confidence = 0.95});
  EXPECT_EQ(bounds.usable, 1000);
  double of_median = 0, of_dispersion = 0;
  standard_errors(fit.median, fit.dispersion, 100, of_median, of_dispersion);
  // Ends of an interval from 1000 resamples are uncertain by about a tenth of its half width.
  EXPECT_NEAR(std::log(bounds.median.upper / bounds.median.lower) / (2 * 1.96 * of_median), 1, 0.15);
  EXPECT_NEAR(std::log(bounds.dispersion.upper / bounds.dispersion.lower) / (2 * 1.96 * of_dispersion), 1, 0.15);
  EXPECT_LT(bounds.median.lower, fit.median);
  EXPECT_GT(bounds.median.upper, fit.median);
}

TEST(FragilityBounds, CoverTheTruthAsOftenAsTheySay) {
  int covered = 0;
  const int repetitions = 150;
  for (unsigned seed = 0; seed < repetitions; ++seed) {
    const auto units = single_runs(synthetic(0.45, 0.4, levels, 30, 100 + seed));
    const Interval bounds = bootstrap_fragility(units, {.resamples = 200, .confidence = 0.9}).median;
    covered += bounds.lower <= 0.45 && 0.45 <= bounds.upper ? 1 : 0;
  }
  // 135 expected, standard deviation √(150·0.9·0.1) = 3.7; four of them, and some for the bootstrap's own deficit.
  EXPECT_GT(covered, 117);
  EXPECT_LT(covered, 150);
}

TEST(FragilityBounds, RecordsAreDrawnWhole) {
  // Records that agree with themselves at all intensities: as many as there are, not as many as there are runs.
  std::vector<Counts> records;
  for (int r = 0; r < 20; ++r) {
    Counts record;
    for (const double x : levels) record.push_back({x, 1, x > 0.25 + 0.02 * r ? 1 : 0});
    records.push_back(record);
  }
  std::vector<Counts> runs;
  for (const Counts& record : records) {
    for (const IntensityCount& one : record) runs.push_back({one});
  }
  const Interval whole = bootstrap_fragility(records).median, apart = bootstrap_fragility(runs).median;
  EXPECT_NE(whole.upper, apart.upper);
  // All runs of one record: nothing to resample.
  const FragilityBounds one = bootstrap_fragility({records[3]}, {.resamples = 50});
  EXPECT_EQ(one.median.lower, one.median.upper);
  EXPECT_EQ(one.fits.front().kind, Kind::separated);
}

TEST(FragilityBounds, AreTheSameForTheSameSeed) {
  const auto units = single_runs(synthetic(0.45, 0.4, levels, 20, 6));
  const FragilityBounds one = bootstrap_fragility(units, {.resamples = 100, .seed = 42});
  const FragilityBounds two = bootstrap_fragility(units, {.resamples = 100, .seed = 42});
  const FragilityBounds other = bootstrap_fragility(units, {.resamples = 100, .seed = 43});
  EXPECT_EQ(one.median.lower, two.median.lower);
  EXPECT_EQ(one.dispersion.upper, two.dispersion.upper);
  EXPECT_NE(one.median.lower, other.median.lower);
  const FragilityBounds narrow = bootstrap_fragility(units, {.resamples = 100, .confidence = 0.5, .seed = 42});
  EXPECT_GT(narrow.median.lower, one.median.lower);
  EXPECT_LT(narrow.median.upper, one.median.upper);
}

TEST(FragilityBounds, CountWhatCouldNotBeFitted) {
  const FragilityBounds bounds = bootstrap_fragility({{{0.1, 1, 0}}, {{0.2, 1, 1}}, {{0.3, 1, 0}}}, {.resamples = 300});
  EXPECT_LT(bounds.usable, 300);
  EXPECT_EQ(bounds.fits.size(), 300U);
  EXPECT_TRUE(std::isinf(bounds.median.upper)) << "8 of 27 resamples hold no event";
  EXPECT_THROW((void)bootstrap_fragility({}), InvalidParameter);
  EXPECT_THROW((void)bootstrap_fragility({{{0.1, 1, 0}}}, {.resamples = 0}), InvalidParameter);
  EXPECT_THROW((void)bootstrap_fragility({{{0.1, 1, 0}}}, {.confidence = 1}), InvalidParameter);
}

TEST(GapForProbability, InterpolatesTheNormalQuantile) {
  // P falls as Φ((0.4 − w)/0.1): linear in its quantile, so that any two widths give the exact gap.
  const std::vector<double> widths = {0.1, 0.35, 0.6, 0.7};
  std::vector<double> probabilities;
  for (const double w : widths) probabilities.push_back(normal((0.4 - w) / 0.1));
  const GapForProbability tenth = gap_for_probability(widths, probabilities, 0.1);
  EXPECT_EQ(tenth.kind, GapForProbability::Kind::between);
  EXPECT_NEAR(tenth.width, 0.4 + 0.1 * 1.2815515655446004, 1e-12);
  EXPECT_NEAR(gap_for_probability(widths, probabilities, 0.01).width, 0.4 + 0.1 * 2.3263478740408408, 1e-12);
  EXPECT_NEAR(gap_for_probability(widths, probabilities, 0.5).width, 0.4, 1e-12);
}

TEST(GapForProbability, AProbabilityThatIsExactlyTheOneAskedForIsGood) {
  using GapKind = GapForProbability::Kind;
  const GapForProbability last = gap_for_probability({1, 2}, {0.5, 0.1}, 0.1);
  EXPECT_EQ(last.kind, GapKind::between) << "no more than the widest gap is needed";
  EXPECT_EQ(last.width, 2);
  const GapForProbability first = gap_for_probability({1, 2}, {0.1, 0.05}, 0.1);
  EXPECT_EQ(first.kind, GapKind::smallest);
  EXPECT_EQ(first.width, 1);
  EXPECT_EQ(gap_for_probability({1, 2, 3}, {0.5, 0.1, 0.0}, 0.1).width, 2);
}

TEST(GapForProbability, TakesTheSafeSide) {
  using GapKind = GapForProbability::Kind;
  EXPECT_EQ(gap_for_probability({1, 2, 3}, {1, 0.4, 0}, 0.1).width, 3);  // nothing to interpolate towards 0
  EXPECT_EQ(gap_for_probability({1, 2, 3}, {1, 0, 0}, 0.1).width, 2);
  EXPECT_EQ(gap_for_probability({1, 2, 3}, {0.5, 0.05, 0.3}, 0.1).kind, GapKind::beyond);
  EXPECT_EQ(gap_for_probability({1, 2, 3, 4}, {0.5, 0.05, 0.3, 0.0}, 0.1).width, 4) << "from here on all are good";
  EXPECT_EQ(gap_for_probability({1, 2}, {0.05, 0.01}, 0.1).kind, GapKind::smallest);
  EXPECT_EQ(gap_for_probability({1, 2}, {0.05, 0.01}, 0.1).width, 1);
  EXPECT_EQ(gap_for_probability({1, 2}, {0.5, 0.1}, 0.1).width, 2);
  EXPECT_THROW((void)gap_for_probability({1, 1}, {0.5, 0.1}, 0.1), InvalidParameter);
  EXPECT_THROW((void)gap_for_probability({1, 2}, {0.5, 1.1}, 0.1), InvalidParameter);
  EXPECT_THROW((void)gap_for_probability({1, 2}, {0.5}, 0.1), InvalidParameter);
  EXPECT_THROW((void)gap_for_probability({}, {}, 0.1), InvalidParameter);
  EXPECT_THROW((void)gap_for_probability({1, 2}, {0.5, 0.1}, 0), InvalidParameter);
}

}  // namespace
}  // namespace bentur
