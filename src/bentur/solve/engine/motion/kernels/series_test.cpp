#include "bentur/solve/engine/motion/kernels/series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bentur/solve/engine/motion/kernels/rows.h"
#include "tests/support/random_numbers.h"

namespace bentur::engine::kernels {
namespace {

using test::random_numbers;
using Numbers = std::vector<double>;

// Whichever version the processor has picked gives what plain loops in the same order give, to the bit.

TEST(Kernels, ExpandIsThePowerSeriesToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 26;
  const Numbers stiff = random_numbers(n, 1), damp = random_numbers(n, 2), gamma = random_numbers(n, 3);
  Numbers row = random_numbers(n, 4), push = random_numbers(n, 5);
  Numbers c = random_numbers(n * (degree + 1), 6), deformation(degree + 1);
  Numbers expected = c;
  std::vector<GroundSeries> grounds = {{0, 4, 0.3, -0.2, 0.09}, {4, 4, -0.5, 0.7, 0.09}};
  std::vector<GroundSeries> again = grounds;
  const Pressing pressing{0,   4,   4,   4,   row.data(),        row.data() + 4, push.data(), push.data() + 4,
                          0.2, 0.1, 1.3, 0.4, deformation.data()};
  expand({stiff.data(), damp.data(), gamma.data(), nullptr}, grounds, {&pressing, 1}, degree, n, c.data());

  const auto deformation_at = [&](int k) {
    const double* x = expected.data() + k * n;
    return dot(4, row.data() + 4, x + 4) + dot(4, row.data(), x) + (k == 0 ? 0.2 : 0.0);
  };
  for (int k = 0; k + 2 <= degree; ++k) {
    const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
    double force = 1.3 * deformation_at(k) + 0.4 * (k + 1.0) * deformation_at(k + 1);
    if (k == 0) force += 0.1;
    const double input[] = {again[0].next(k), again[1].next(k)};
    for (Index j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      double& to = expected[static_cast<std::size_t>((k + 2) * n + j)];
      const double own = stiff[at] * expected[static_cast<std::size_t>(k * n + j)] +
                         (k + 1.0) * damp[at] * expected[static_cast<std::size_t>((k + 1) * n + j)];
      to = ((gamma[at] * input[j / 4] - own) + force * push[at]) * scale;
    }
  }
  EXPECT_EQ(c, expected);
  for (int k = 0; k <= degree; ++k) EXPECT_EQ(deformation[static_cast<std::size_t>(k)], deformation_at(k)) << k;
}

TEST(Kernels, EvaluateAndSampleAreHornersRuleToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 20, parts = 5;
  const Numbers c = random_numbers(n * (degree + 1), 7);
  Numbers q(n), first(n), second(n), samples(n * (parts + 1)), seconds(n * (parts + 1));
  sample(n, c.data(), n, degree, {parts, 0.75, 3.0}, samples.data(), seconds.data());
  for (int i = 0; i <= parts; ++i) {
    const double s = i == parts ? 0.75 : 0.75 * i / parts;
    evaluate(n, c.data(), n, degree, s, q.data(), first.data(), second.data());
    for (Index j = 0; j < n; ++j) {
      double x = 0.0, y = 0.0, z = 0.0;
      for (int k = degree; k >= 0; --k) {
        const double term = c[static_cast<std::size_t>(k * n + j)];
        x = x * s + term;
        if (k >= 1) y = y * s + k * term;
        if (k >= 2) z = z * s + k * (k - 1.0) * term;
      }
      const auto at = static_cast<std::size_t>(i * n + j);
      EXPECT_EQ(q[static_cast<std::size_t>(j)], x);
      EXPECT_EQ(first[static_cast<std::size_t>(j)], y);
      EXPECT_EQ(second[static_cast<std::size_t>(j)], z);
      EXPECT_EQ(samples[at], x);
      EXPECT_DOUBLE_EQ(seconds[at], 3.0 * z);
    }
  }
}

TEST(Kernels, BoundsSumAllTerms) {
  constexpr double end = 0.7;
  constexpr Index n = 4;
  constexpr int degree = 6;
  Numbers c = random_numbers(n * (degree + 1), 11), second(n), fourth(n);
  bound(n, c.data(), n, degree, end, 3.0, 5.0, second.data(), fourth.data());
  for (Index j = 0; j < n; ++j) {
    double two = 0.0, four = 0.0;
    for (int k = 2; k <= degree; ++k) {
      const double term = k * (k - 1.0) * std::abs(c[static_cast<std::size_t>(k * n + j)]);
      two += term * std::pow(end, k - 2);
      four += (k - 2.0) * (k - 3.0) * term * std::pow(end, k - 4);
    }
    EXPECT_NEAR(second[static_cast<std::size_t>(j)], 3.0 * two, 1e-14 * two);
    EXPECT_NEAR(fourth[static_cast<std::size_t>(j)], 5.0 * four, 1e-14 * four);
  }
}

TEST(Kernels, PolynomialsStayWithinTheirRiseOfTheChord) {
  constexpr Index n = 4;
  constexpr double end = 0.8, rate = 3.0;
  const auto leave = [&](const Numbers& c, int degree, Numbers& rise, Numbers& second_rise) {
    return leave_chords(n, c.data(), n, degree, end, rate, rise.data(), second_rise.data());
  };
  Numbers rise(n), second_rise(n);
  // A single power: the largest distance is reached, or the bound would be too wide.
  for (int power = 2; power <= 26; ++power) {
    Numbers c(n * 27, 0.0);
    c[static_cast<std::size_t>(power * n)] = -2.0;
    EXPECT_TRUE(std::isfinite(leave(c, 26, rise, second_rise)));
    double farthest = 0.0, second_farthest = 0.0;
    for (int i = 0; i <= 10000; ++i) {
      const double s = end * i / 10000.0;
      const auto from_chord = [&](double factor, int k) {
        return std::abs(factor * (std::pow(s, k) - (k == 0 ? 1.0 : std::pow(end, k - 1) * s)));
      };
      farthest = std::max(farthest, from_chord(2.0, power));
      second_farthest = std::max(second_farthest, from_chord(2.0 * rate * power * (power - 1.0), power - 2));
    }
    EXPECT_LE(farthest, rise[0] * (1.0 + 1e-12));
    EXPECT_NEAR(farthest, rise[0], 1e-6 * rise[0]);
    EXPECT_LE(second_farthest, second_rise[0] * (1.0 + 1e-12) + (power < 4 ? 1e-9 : 0.0));
    EXPECT_NEAR(second_farthest, second_rise[0], 1e-6 * second_rise[0] + (power < 4 ? 1e-9 : 0.0));
  }
  // Many: none is farther.
  constexpr int degree = 9;
  Numbers c = random_numbers(n * (degree + 1), 11);
  EXPECT_TRUE(std::isfinite(leave(c, degree, rise, second_rise)));
  for (std::size_t j = 0; j < n; ++j) {
    const auto at = [&](double s) {
      double sum = 0.0;
      for (std::size_t k = 0; k <= degree; ++k) sum += c[k * n + j] * std::pow(s, k);
      return sum;
    };
    for (int i = 0; i <= 100; ++i) {
      const double s = end * i / 100.0;
      EXPECT_LE(std::abs(at(s) - at(0) - (at(end) - at(0)) * i / 100.0), rise[j]);
    }
  }
  c.back() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(leave(c, degree, rise, second_rise)));
}

TEST(Kernels, RowsAreSummedAsTwoProducts) {
  constexpr Index stride = 16;
  const Numbers right = random_numbers(4, 1), left = random_numbers(8, 2), c = random_numbers(stride * 27, 3);
  for (const int degree : {6, 7, 8, 9, 26}) {
    Numbers polynomial(27, 0.0);
    row_series({4, right.data(), c.data() + 8}, {8, left.data(), c.data()}, stride, degree, polynomial.data());
    for (int k = 0; k < 27; ++k) {
      const double* x = c.data() + k * stride;
      EXPECT_EQ(polynomial[static_cast<std::size_t>(k)],
                k <= degree ? dot(4, right.data(), x + 8) + dot(8, left.data(), x) : 0.0);
    }
  }
}

TEST(Kernels, InspectionIsOfDerivativesInTheMiddleAndBoundsToTheEnd) {
  for (const int degree : {6, 9, 12, 26}) {
    const Numbers p = random_numbers(27, static_cast<unsigned>(degree));
    for (const auto& [mid, b] : {std::pair(0.5, 1.0), std::pair(0.3, 0.4), std::pair(1e-7, 2e-7)}) {
      const Inspection at = inspect(p.data(), degree, mid, b);
      Inspection expected;
      for (int k = 0; k <= degree; ++k) {
        const double c = p[static_cast<std::size_t>(k)];
        expected.end += c * std::pow(b, k);
        if (k >= 1) expected.slope += k * c * std::pow(mid, k - 1);
        if (k >= 2) expected.curvature += k * (k - 1.0) * c * std::pow(mid, k - 2);
        if (k >= 2) expected.second += k * (k - 1.0) * std::abs(c) * std::pow(b, k - 2);
        if (k >= 3) expected.third += k * (k - 1.0) * (k - 2.0) * std::abs(c) * std::pow(b, k - 3);
      }
      EXPECT_NEAR(at.end, expected.end, 1e-13);
      EXPECT_NEAR(at.slope, expected.slope, 1e-12);
      EXPECT_NEAR(at.curvature, expected.curvature, 1e-11);
      EXPECT_NEAR(at.second, expected.second, 1e-13 * expected.second);
      EXPECT_NEAR(at.third, expected.third, 1e-13 * expected.third);
    }
  }
}

}  // namespace
}  // namespace bentur::engine::kernels
