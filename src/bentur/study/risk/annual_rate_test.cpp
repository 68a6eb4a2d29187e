#include "bentur/study/risk/annual_rate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

double phi(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

HazardCurve power_law(double scale, double slope, double first, double last, int numbers) {
  HazardCurve curve;
  for (int i = 0; i < numbers; ++i) {
    const double x = first * std::pow(last / first, static_cast<double>(i) / (numbers - 1));
    curve.intensity.push_back(x);
    curve.rate.push_back(scale * std::pow(x, -slope));
  }
  return curve;
}

/// ∫ P |dλ| over every segment by quadrature, and what is beyond the last number.
template <class Probability>
double by_quadrature(const HazardCurve& hazard, const Probability& p) {
  double sum = hazard.rate.back();
  for (std::size_t i = 0; i < hazard.segments(); ++i) {
    const double k = hazard.slope(i), a = std::log(hazard.intensity[i]), b = std::log(hazard.intensity[i + 1]);
    constexpr int pieces = 64;
    for (int j = 0; j < pieces; ++j) {
      const double from = a + (b - a) * j / pieces, to = a + (b - a) * (j + 1) / pieces;
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double s) { return p(std::exp(s)) * k * hazard.rate[i] * std::exp(-k * (s - a)); }, from, to, 5, 1e-13);
    }
  }
  return sum;
}

/// Cornell and others 2002: λ = λ(θ) exp(k²β²/2), of a hazard that is one power of x however it is cut up.
TEST(AnnualRate, OfOnePowerLawIsTheClosedForm) {
  for (const double k : {0.5, 1.0, 2.3, 4.0}) {
    for (const double beta : {0.05, 0.3, 0.6}) {
      // so wide that what is left out at both ends is below 1e-12 of it
      const HazardCurve hazard = power_law(1e-4, k, 0.3 * std::exp(-18.0), 0.3 * std::exp(18.0), 40);
      const AnnualRate found = annual_rate(hazard, 0.3, beta);
      const double expected = 1e-4 * std::pow(0.3, -k) * std::exp(0.5 * k * k * beta * beta);
      EXPECT_NEAR(found.rate / expected, 1, 1e-9) << k << " " << beta;  // numbers of λ over 36 e-folds
      EXPECT_NEAR(closed_form_rate(hazard, 0.3, beta) / expected, 1, 1e-12);
      EXPECT_LT(found.below, 1e-9 * expected);
    }
  }
}

TEST(AnnualRate, OfAnyCurveIsTheQuadrature) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  for (int trial = 0; trial < 60; ++trial) {
    HazardCurve hazard{.intensity = {0.01 + 0.1 * u(random)}, .rate = {std::pow(10.0, -2 * u(random))}};
    for (int i = 0; i < 8; ++i) {
      hazard.intensity.push_back(hazard.intensity.back() * (1.05 + u(random)));
      hazard.rate.push_back(hazard.rate.back() * (trial % 7 == 0 && i == 3 ? 1.0 : std::pow(10.0, -1.5 * u(random))));
    }
    const double median = 0.05 + u(random), beta = 0.02 + u(random);
    const AnnualRate found = annual_rate(hazard, median, beta);
    const double expected = by_quadrature(hazard, [&](double x) { return phi(std::log(x / median) / beta); });
    EXPECT_NEAR(found.rate / expected, 1, 1e-9) << trial;
    double sum = 0;
    for (const double part : found.parts) {
      EXPECT_GE(part, 0);
      sum += part;
    }
    EXPECT_NEAR(sum / found.rate, 1, 1e-12);
    // what is beyond: λ_n (1 − Φ(z_n))
    EXPECT_NEAR(found.beyond, hazard.rate.back() * phi(-std::log(hazard.intensity.back() / median) / beta),
                1e-12 * hazard.rate.back());

    std::vector<ObservedShare> shares;
    double x = 0.02 + 0.2 * u(random);
    for (int i = 0; i < 5; ++i, x *= 1.1 + u(random)) shares.push_back({x, u(random)});
    const auto share_at = [&](double at) {
      if (at >= shares.back().intensity) return 1.0;
      if (at <= shares.front().intensity) return shares.front().probability * at / shares.front().intensity;
      std::size_t i = 0;
      while (at > shares[i + 1].intensity) ++i;
      const double place = std::log(at / shares[i].intensity) / std::log(shares[i + 1].intensity / shares[i].intensity);
      return shares[i].probability + place * (shares[i + 1].probability - shares[i].probability);
    };
    // the quadrature has corners and a jump of P within its pieces
    EXPECT_NEAR(annual_rate(hazard, shares).rate / by_quadrature(hazard, share_at), 1, 2e-3) << trial;
  }
}

/// A lognormal of the runs that stand, and collapse apart: by quadrature of the whole, of hazards as above.
TEST(AnnualRate, OfACloudWithCollapsesIsTheQuadrature) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(0, 1);
  for (int trial = 0; trial < 30; ++trial) {
    HazardCurve hazard{.intensity = {0.01 + 0.1 * u(random)}, .rate = {std::pow(10.0, -2 * u(random))}};
    for (int i = 0; i < 8; ++i) {
      hazard.intensity.push_back(hazard.intensity.back() * (1.05 + u(random)));
      hazard.rate.push_back(hazard.rate.back() * std::pow(10.0, -1.5 * u(random)));
    }
    const double median = 0.05 + u(random), beta = 0.05 + u(random), half = 0.1 + u(random), slope = 1 + 12 * u(random);
    const CollapseFit collapse{
        .kind = CollapseFit::Kind::fitted, .intercept = -slope * std::log(half), .slope = slope, .runs = 9};
    const AnnualRate found = annual_rate(hazard, median, beta, collapse);
    const auto p = [&](double x) {
      const double gone = 1 / (1 + std::pow(x / half, -slope));
      return gone + (1 - gone) * phi(std::log(x / median) / beta);
    };
    EXPECT_NEAR(found.rate / by_quadrature(hazard, p), 1, 1e-9) << trial;
    double sum = 0;
    for (const double part : found.parts) sum += part;
    EXPECT_NEAR(sum / found.rate, 1, 1e-12);
    const double last = hazard.intensity.back();
    EXPECT_NEAR(found.beyond, hazard.rate.back() * (1 - p(last)), 1e-12 * hazard.rate.back());
    // What is below: the first segment goes on, to where nothing is left of it.
    const double k = hazard.slope(0);
    if (slope <= k) {
      EXPECT_EQ(found.below, std::numeric_limits<double>::infinity());
      continue;
    }
    if (slope - k < 1) continue;  // so far down that the numbers of the hazard are none of the machine's
    HazardCurve longer = hazard;
    const double down = std::exp(-40 / (slope - k)),
                 low = hazard.intensity.front() * std::min(down, std::exp(-20 * beta));
    longer.intensity.insert(longer.intensity.begin(), low);
    longer.rate.insert(longer.rate.begin(), hazard.rate.front() * std::pow(low / hazard.intensity.front(), -k));
    const double more = by_quadrature(longer, p) - found.rate;
    EXPECT_NEAR(found.below, more, 1e-6 * (more + found.rate)) << trial;
  }
}

TEST(AnnualRate, OfCollapseFarAboveTheHazardIsThatOfTheRunsThatStand) {
  const HazardCurve hazard = power_law(1e-4, 2, 0.01, 2, 12);
  const CollapseFit far{.kind = CollapseFit::Kind::fitted, .intercept = -20 * std::log(50.0), .slope = 20, .runs = 9};
  EXPECT_NEAR(annual_rate(hazard, 0.3, 0.4, far).rate / annual_rate(hazard, 0.3, 0.4).rate, 1, 1e-12);
  // And a step of collapse at ½ is the hazard there, where the runs that stand do not have the event.
  const CollapseFit step{
      .kind = CollapseFit::Kind::fitted, .intercept = 3000 * std::log(2.0), .slope = 3000, .runs = 9};
  EXPECT_NEAR(annual_rate(hazard, 1e3, 0.1, step).rate / 4e-4, 1, 1e-4);
  EXPECT_THROW((void)annual_rate(hazard, 0.3, 0.4, CollapseFit{.kind = CollapseFit::Kind::separated}),
               InvalidParameter);
}

TEST(AnnualRate, OfAStepIsTheHazardThere) {
  const HazardCurve hazard = power_law(1e-4, 2, 0.01, 2, 12);
  for (const double median : {0.0123, 0.5, 1.999}) {
    EXPECT_NEAR(annual_rate(hazard, median, 0).rate / (1e-4 / (median * median)), 1, 1e-12);
    EXPECT_NEAR(annual_rate(hazard, median, 1e-5).rate / annual_rate(hazard, median, 0).rate, 1, 1e-4);
  }
  const AnnualRate low = annual_rate(hazard, 0.005, 0), high = annual_rate(hazard, 3, 0);
  EXPECT_NEAR(low.rate / hazard.rate.front(), 1, 1e-12);
  EXPECT_NEAR((low.rate + low.below) / (1e-4 / 2.5e-5), 1, 1e-12);
  EXPECT_DOUBLE_EQ(high.rate, hazard.rate.back());  // beyond the last number all counts
  EXPECT_DOUBLE_EQ(high.beyond, hazard.rate.back());
}

TEST(AnnualRate, OfSharesByHand) {
  // λ = 0.01/x: k = 1. Shares 0 at 1, 1 at e: ∫ of ln x · 0.01/x² from 1 to e, and 0.01/e beyond
  const HazardCurve hazard = power_law(0.01, 1, 0.1, 100, 10);
  const AnnualRate found = annual_rate(hazard, {{1.0, 0.0}, {std::exp(1.0), 1.0}});
  EXPECT_NEAR(found.rate, 0.01 * (1 - std::exp(-1.0)), 1e-15);
  EXPECT_EQ(found.below, 0);
  EXPECT_NEAR(found.beyond, 0, 1e-18);
  // half of the runs at one level alone: below it straight to 0, above it all
  const AnnualRate half = annual_rate(hazard, {{1.0, 0.5}});
  EXPECT_NEAR(half.rate, 0.01 * (1 + 0.5 * std::log(10.0)), 1e-14);
  EXPECT_NEAR(half.beyond, 0.005, 1e-15);
  EXPECT_EQ(half.below, std::numeric_limits<double>::infinity());
}

TEST(AnnualRate, InYears) {
  EXPECT_NEAR(probability_in(50, 0.002107), 0.1, 1e-4);  // 10 % in 50 years: once in 475 years
  EXPECT_NEAR(rate_of_probability(50, 0.1), 1 / 474.56, 1e-7);
  EXPECT_NEAR(rate_of_probability(1, probability_in(1, 1e-9)), 1e-9, 1e-24);
}

TEST(AnnualRate, RefusesWhatIsNoFragility) {
  const HazardCurve hazard = power_law(1e-4, 2, 0.01, 2, 12);
  EXPECT_THROW((void)annual_rate(hazard, 0, 0.3), InvalidParameter);
  EXPECT_THROW((void)annual_rate(hazard, 0.3, -1), InvalidParameter);
  EXPECT_THROW((void)annual_rate(hazard, std::vector<ObservedShare>{}), InvalidParameter);
  EXPECT_THROW((void)annual_rate(hazard, {{1, 0.5}, {1, 0.6}}), InvalidParameter);
}

/// Of pooled shares there is a closed form: the largest over what begins no later of the smallest over what ends no
/// earlier of the share of the runs between.
TEST(RisingShares, AreThoseOfLargestLikelihood) {
  std::mt19937_64 generator(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<IntensityCount> counts;
    for (int i = 0; i < 12; ++i) {
      const long runs = static_cast<long>(generator() % 4);
      counts.push_back({0.1 * (i + 1), runs, runs == 0 ? 0 : static_cast<long>(generator() % (runs + 1))});
    }
    std::erase_if(counts, [](const IntensityCount& one) { return one.runs == 0; });
    const std::vector<ObservedShare> shares = rising_shares(counts);
    ASSERT_EQ(shares.size(), counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) {
      double largest = 0;
      for (std::size_t i = 0; i <= k; ++i) {
        double smallest = 1;
        for (std::size_t j = k; j < counts.size(); ++j) {
          double events = 0, runs = 0;
          for (std::size_t m = i; m <= j; ++m) {
            events += static_cast<double>(counts[m].events);
            runs += static_cast<double>(counts[m].runs);
          }
          smallest = std::min(smallest, events / runs);
        }
        largest = std::max(largest, smallest);
      }
      EXPECT_EQ(shares[k].intensity, counts[k].intensity);
      EXPECT_NEAR(shares[k].probability, largest, 1e-15);
    }
  }
  EXPECT_TRUE(rising_shares({}).empty());
}

}  // namespace
}  // namespace bentur
