#include "bentur/solve/motion/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bentur::engine::kernels {
namespace {

using Numbers = std::vector<double>;

Numbers random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  Numbers list(count);
  for (double& x : list) x = number(engine);
  return list;
}

// Whichever version the processor has picked gives what plain loops in the same order give, to the bit.

TEST(Kernels, ExpandIsThePowerSeriesToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 26;
  const Numbers stiff = random_numbers(n, 1), damp = random_numbers(n, 2), gamma = random_numbers(n, 3);
  Numbers sense = random_numbers(n, 4), push = random_numbers(n, 5);
  Numbers c = random_numbers(n * (degree + 1), 6), room(n), opening(degree + 1);
  Numbers expected = c;
  std::vector<Ground> grounds = {{0, 4, 0.3, -0.2, 0.09}, {4, 4, -0.5, 0.7, 0.09}};
  std::vector<Ground> again = grounds;
  const Pressing pressing{0,   4,   4,   4,   sense.data(),  sense.data() + 4, push.data(), push.data() + 4,
                          0.2, 0.1, 1.3, 0.4, opening.data()};
  expand(stiff.data(), damp.data(), gamma.data(), grounds, {&pressing, 1}, degree, n, c.data(), room.data());

  const auto open = [&](int k) {
    const double* x = expected.data() + k * n;
    return dot(4, sense.data() + 4, x + 4) + dot(4, sense.data(), x) + (k == 0 ? 0.2 : 0.0);
  };
  for (int k = 0; k + 2 <= degree; ++k) {
    const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
    double force = -1.3 * open(k) - 0.4 * (k + 1.0) * open(k + 1);
    if (k == 0) force += 0.1;
    const double input[] = {again[0].next(k), again[1].next(k)};
    for (Index j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      double& to = expected[static_cast<std::size_t>((k + 2) * n + j)];
      const double driven = gamma[at] * input[j / 4] + force * push[at];
      to = (driven - stiff[at] * expected[static_cast<std::size_t>(k * n + j)] -
            (k + 1.0) * damp[at] * expected[static_cast<std::size_t>((k + 1) * n + j)]) *
           scale;
    }
  }
  EXPECT_EQ(c, expected);
  for (int k = 0; k <= degree; ++k) EXPECT_EQ(opening[static_cast<std::size_t>(k)], open(k)) << k;
}

TEST(Kernels, EvaluateAndSampleAreHornersRuleToTheBit) {
  constexpr Index n = 8;
  constexpr int degree = 20, parts = 5;
  const Numbers c = random_numbers(n * (degree + 1), 7);
  Numbers q(n), first(n), second(n), samples(n * (parts + 1)), seconds(n * (parts + 1));
  sample(n, c.data(), n, degree, parts, 0.75, samples.data(), seconds.data());
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
      EXPECT_EQ(seconds[at], z);
    }
  }
}

TEST(Kernels, RowsAreMatrixProductsToTheBit) {
  constexpr Index rows = 12, columns = 8;
  constexpr int count = 7;
  const Numbers w = random_numbers(rows * columns, 8), x = random_numbers(count * columns, 9);
  Numbers rise = random_numbers(columns, 10);
  for (double& r : rise) r = std::abs(r);
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Numbers peak(rows, 5.0), reach(rows, unknown), ends_peak(rows, 5.0), ends_reach(rows, unknown), lowest(rows),
      beyond(rows);
  bool settled = true, ends_settled = true;
  const PackedRows packed(Eigen::Map<const Eigen::MatrixXd>(w.data(), rows, columns), columns);
  const bool found = reach_of_samples(packed, count, x.data(), rise.data(), peak.data(), reach.data(), reach.data());
  const bool ends_found = reach_of_rows(packed, x.data(), x.data() + columns, rise.data(), ends_peak.data(),
                                        ends_reach.data(), ends_reach.data());
  lowest_of_rows(packed, x.data(), x.data() + columns, rise.data(), lowest.data(), beyond.data());
  for (Index r = 0; r < rows; ++r) {
    const auto at = static_cast<std::size_t>(r);
    double largest = 0.0, further = 0.0;
    Numbers values;
    for (Index j = 0; j < columns; ++j) {
      further += std::abs(w[static_cast<std::size_t>(j * rows + r)]) * rise[static_cast<std::size_t>(j)];
    }
    for (int i = 0; i < count; ++i) {
      double sum = 0.0;
      for (Index j = 0; j < columns; ++j) {
        sum += w[static_cast<std::size_t>(j * rows + r)] * x[static_cast<std::size_t>(i * columns + j)];
      }
      values.push_back(sum);
      largest = std::max(largest, std::abs(sum));
    }
    EXPECT_EQ(reach[at], largest + further);
    EXPECT_EQ(peak[at], std::max(5.0, largest));
    settled = settled && largest + further <= std::max(5.0, largest);
    const double ends = std::max(std::abs(values[0]), std::abs(values[1]));
    EXPECT_EQ(ends_reach[at], ends + further);
    EXPECT_EQ(ends_peak[at], std::max(5.0, ends));
    ends_settled = ends_settled && ends + further <= std::max(5.0, ends);
    EXPECT_EQ(lowest[at], std::min(values[0], values[1]));
    EXPECT_EQ(beyond[at], further);
  }
  EXPECT_EQ(found, settled);
  EXPECT_EQ(ends_found, ends_settled);
}

TEST(Kernels, PackedRowsAreFilledUpWithZeros) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(6, 3);
  const PackedRows packed(matrix, 4);
  ASSERT_EQ(packed.rows(), 8);
  ASSERT_EQ(packed.columns(), 4);
  for (Index r = 0; r < 8; ++r) {
    for (Index j = 0; j < 4; ++j) EXPECT_EQ(packed(r, j), r < 6 && j < 3 ? matrix(r, j) : 0.0);
  }
}

TEST(Kernels, BoundsSumAllTerms) {
  constexpr Index n = 4;
  constexpr int degree = 6;
  Numbers c = random_numbers(n * (degree + 1), 11), second(n), fourth(n);
  EXPECT_TRUE(std::isfinite(bound(n, c.data(), n, degree, second.data(), fourth.data())));
  for (Index j = 0; j < n; ++j) {
    double two = 0.0, four = 0.0;
    for (int k = 2; k <= degree; ++k) {
      const double term = k * (k - 1.0) * std::abs(c[static_cast<std::size_t>(k * n + j)]);
      two += term;
      four += (k - 2.0) * (k - 3.0) * term;
    }
    EXPECT_EQ(second[static_cast<std::size_t>(j)], two);
    EXPECT_EQ(fourth[static_cast<std::size_t>(j)], four);
  }
  c.back() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(bound(n, c.data(), n, degree, second.data(), fourth.data())));
}

}  // namespace
}  // namespace bentur::engine::kernels
