#include "bentur/solve/engine/motion/kernels/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bentur/solve/engine/motion/kernels/power_factors.h"
#include "bentur/solve/engine/motion/kernels/rows.h"
#include "tests/support/random_numbers.h"

namespace bentur::engine::kernels {
namespace {

using test::random_numbers;
using Numbers = std::vector<double>;

// Whichever version the processor has picked gives what plain loops in the same order give, to the bit.

TEST(Kernels, ExpandIsThePowerSeriesToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 27;
  const Numbers stiff = random_numbers(n, 1), damp = random_numbers(n, 2), gamma = random_numbers(n, 3);
  Numbers row = random_numbers(n, 4), push = random_numbers(n, 5);
  Numbers c = random_numbers(n * (degree + 1), 6), deformation(degree + 1);
  Numbers expected = c;
  std::vector<GroundSeries> grounds = {{0, 4, 0.3, -0.2, 0.09}, {4, 4, -0.5, 0.7, 0.09}};
  std::vector<GroundSeries> again = grounds;
  const Pressing pressing{0,   4,   4,   4,   row.data(),        row.data() + 4, push.data(), push.data() + 4,
                          0.2, 0.1, 1.3, 0.4, deformation.data()};
  expand({stiff.data(), damp.data(), gamma.data(), nullptr}, grounds, {&pressing, 1}, {}, degree, n, c.data());

  const auto deformation_at = [&](int k) {
    const double* x = expected.data() + k * n;
    return dot(4, row.data() + 4, x + 4) + dot(4, row.data(), x) + (k == 0 ? 0.2 : 0.0);
  };
  for (int k = 0; k + 2 <= degree; ++k) {
    const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
    const double force = 1.3 * deformation_at(k) + 0.4 * (k + 1.0) * deformation_at(k + 1);
    const double input[] = {again[0].next(k), again[1].next(k)};
    for (Index j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      double& to = expected[static_cast<std::size_t>((k + 2) * n + j)];
      const double own = stiff[at] * expected[static_cast<std::size_t>(k * n + j)] +
                         (k + 1.0) * damp[at] * expected[static_cast<std::size_t>((k + 1) * n + j)];
      to = gamma[at] * input[j / 4] - own;
      if (k == 0) to += 0.1 * push[at];
      to = (to + force * push[at]) * scale;
    }
  }
  EXPECT_EQ(c, expected);
  for (int k = 0; k <= degree; ++k) EXPECT_EQ(deformation[static_cast<std::size_t>(k)], deformation_at(k)) << k;
}

TEST(Kernels, ExpandTakesTiedElementsAsAMatrixOrByTheirRows) {
  constexpr Index n = 4, count = 3;
  constexpr int degree = 27;
  const Numbers stiff = random_numbers(n, 1), damp = random_numbers(n, 2), gamma = random_numbers(n, 3);
  const Numbers pull = random_numbers(n * count, 4), push = random_numbers(n * count, 5), base = random_numbers(n, 6);
  Numbers matrix(n * n, 0.0);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      for (Index k = 0; k < count; ++k) matrix[j * n + i] += push[k * n + i] * pull[k * n + j];
    }
  }
  const auto expanded = [&](const double* as_matrix) {
    Numbers c = random_numbers(n * (degree + 1), 7);
    std::vector<GroundSeries> grounds = {{0, n, 0.3, -0.2, 0.0}};
    const Tied tied{0, n, count, as_matrix, pull.data(), push.data(), base.data(), 0.7};
    expand({stiff.data(), damp.data(), gamma.data(), nullptr}, grounds, {}, {&tied, 1}, degree, n, c.data());
    return c;
  };
  const Numbers one = expanded(matrix.data()), other = expanded(nullptr), start = random_numbers(n * (degree + 1), 7);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-14 * (1 + std::abs(one[i]))) << i;
  for (Index i = 0; i < n; ++i) {  // the first term by hand
    double force = gamma[i] * 0.3 - stiff[i] * start[i] - damp[i] * start[n + i] + 0.7 * base[i];
    for (Index j = 0; j < n; ++j) force += 0.7 * matrix[j * n + i] * start[j];
    EXPECT_NEAR(one[2 * n + i], force / 2, 1e-14);
  }
}

TEST(Kernels, EvaluateAndSampleAreHornersRuleToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 20, parts = 5;
  const Numbers c = random_numbers(n * (degree + 1), 7);
  Numbers q(n), first(n), second(n), samples(n * (parts + 1)), seconds(n * (parts + 1));
  sample(n, c.data(), n, degree, {parts, 0.75, 3.0}, samples.data(), seconds.data());
  for (int i = 0; i <= parts; ++i) {
    const double s = i == parts ? 0.75 : 0.75 * i / parts;
    evaluate(n, c.data(), n, degree, s, 1.0, {q.data(), first.data(), second.data()});
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

TEST(Kernels, TheEndOfAStepIsWhereItIsEvaluated) {
  constexpr Index n = 12;
  constexpr int degree = 15;
  const Numbers c = random_numbers(n * (degree + 1), 8);
  Numbers q(n), v(n), a(n), again_q(n), again_v(n), again_a(n), rise(n), second_rise(n);
  end_of_step(n, c.data(), n, degree, 0.3, {q.data(), v.data(), a.data()}, rise.data(), second_rise.data());
  evaluate(n, c.data(), n, degree, 1.0, 0.3, {again_q.data(), again_v.data(), again_a.data()});
  EXPECT_EQ(q, again_q);
  EXPECT_EQ(v, again_v);
  EXPECT_EQ(a, again_a);
}

TEST(Kernels, PolynomialsStayWithinTheirRiseOfTheChord) {
  constexpr Index n = 4;
  constexpr double h = 0.6;
  constexpr double rate = 1.0 / (h * h);
  Numbers q(n), v(n), a(n), rise(n), second_rise(n);
  const auto leave = [&](const Numbers& c, int degree) {
    return end_of_step(n, c.data(), n, degree, h, {q.data(), v.data(), a.data()}, rise.data(), second_rise.data());
  };
  // A single power: the largest distance is reached, or the bound would be too wide.
  for (int power = 2; power <= 27; ++power) {
    Numbers c(n * 28, 0.0);
    c[static_cast<std::size_t>(power * n)] = -2.0;
    EXPECT_TRUE(std::isfinite(leave(c, 27)));
    double farthest = 0.0, second_farthest = 0.0;
    for (int i = 0; i <= 10000; ++i) {
      const double s = i / 10000.0;
      const auto from_chord = [&](double factor, int k) {
        return std::abs(factor * (std::pow(s, k) - (k == 0 ? 1.0 : s)));
      };
      farthest = std::max(farthest, from_chord(2.0, power));
      second_farthest = std::max(second_farthest, from_chord(2.0 * rate * power * (power - 1.0), power - 2));
    }
    EXPECT_LE(farthest, rise[0] * (1.0 + 1e-12));
    EXPECT_NEAR(farthest, rise[0], 1e-6 * rise[0]);
    EXPECT_LE(second_farthest, second_rise[0] * (1.0 + 1e-12) + (power < 4 ? 1e-9 : 0.0));
    EXPECT_NEAR(second_farthest, second_rise[0], 1e-6 * second_rise[0] + (power < 4 ? 1e-9 : 0.0));
  }
  // Many: none is farther; and up to some s none is farther than by s² of that.
  constexpr int degree = 9;
  Numbers c = random_numbers(n * (degree + 1), 11);
  EXPECT_TRUE(std::isfinite(leave(c, degree)));
  for (const double end : {1.0, 0.8, 0.1}) {
    for (std::size_t j = 0; j < n; ++j) {
      const auto at = [&](double s, int derivative) {
        double sum = 0.0;
        for (int k = derivative; k <= degree; ++k) {
          const double factor = derivative == 0 ? 1.0 : rate * k * (k - 1.0);
          sum += factor * c[static_cast<std::size_t>(k) * n + j] * std::pow(s, k - derivative);
        }
        return sum;
      };
      for (int i = 0; i <= 100; ++i) {
        const auto from_chord = [&](int derivative) {
          const double start = at(0, derivative);
          return std::abs(at(end * i / 100.0, derivative) - start - (at(end, derivative) - start) * i / 100.0);
        };
        EXPECT_LE(from_chord(0), end * end * rise[j] + 1e-14);
        EXPECT_LE(from_chord(2), end * end * second_rise[j] + 1e-13 * second_rise[j]);
      }
    }
  }
  c.back() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(leave(c, degree)));
}

TEST(Kernels, RowsAreSummedAsTwoProducts) {
  constexpr Index stride = 16;
  const Numbers right = random_numbers(4, 1), left = random_numbers(8, 2), c = random_numbers(stride * 28, 3);
  for (const int degree : {7, 11, 27}) {
    Numbers polynomial(28, 0.0);
    row_series({4, right.data(), c.data() + 8}, {8, left.data(), c.data()}, stride, degree, polynomial.data());
    for (int k = 0; k < 28; ++k) {
      const double* x = c.data() + k * stride;
      EXPECT_EQ(polynomial[static_cast<std::size_t>(k)],
                k <= degree ? dot(4, right.data(), x + 8) + dot(8, left.data(), x) : 0.0);
    }
  }
}

TEST(Kernels, SplitsAndSurveysAreSumsOfTerms) {
  for (const int degree : {6, 9, 12, 27}) {
    Numbers p = random_numbers(28, static_cast<unsigned>(degree));
    std::fill(p.begin() + degree + 1, p.end(), 0.0);
    for (const double s : {1.0, 0.3, 1e-7, 0.0}) {
      Splits expected;
      Survey most;
      for (int k = 0; k <= degree; ++k) {
        const double c = p[static_cast<std::size_t>(k)];
        expected.value += c * std::pow(s, k);
        if (k >= 1) (c > 0 ? expected.slope.above : expected.slope.below) += k * std::abs(c) * std::pow(s, k - 1);
        if (k < 2) continue;
        const double second = k * (k - 1.0) * std::abs(c) * std::pow(s, k - 2);
        (c > 0 ? expected.curvature.above : expected.curvature.below) += second;
        most.second += second;
        most.rise += std::abs(c) * std::pow(s, k) * power_factors.rise[static_cast<std::size_t>(k)];
        if (k > 2) most.third += k * (k - 1.0) * (k - 2.0) * std::abs(c) * std::pow(s, k - 3);
      }
      const auto expect_same = [](double x, double y) { EXPECT_NEAR(x, y, 1e-13 * std::abs(y)); };
      const Splits at = splits(p.data(), degree, s);
      EXPECT_NEAR(at.value, expected.value, 1e-13);
      expect_same(at.slope.above, expected.slope.above);
      expect_same(at.slope.below, expected.slope.below);
      expect_same(at.curvature.above, expected.curvature.above);
      expect_same(at.curvature.below, expected.curvature.below);
      if (s == 0.0) continue;
      const Survey all = survey(p.data(), degree, s);
      EXPECT_NEAR(all.end, expected.value, 1e-13);
      expect_same(all.rise, most.rise);
      expect_same(all.second, most.second);
      expect_same(all.third, most.third);
    }
  }
}

}  // namespace
}  // namespace bentur::engine::kernels
