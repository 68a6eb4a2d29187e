#include "bentur/solve/engine/motion/kernels/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/random_numbers.h"

namespace bentur::engine::kernels {
namespace {

using test::random_numbers;
using Numbers = std::vector<double>;

// Whichever version the processor has picked gives what plain loops in the same order give, to the bit.

TEST(Kernels, RowsAreMatrixProductsToTheBit) {
  constexpr Index rows = 12, columns = 8;
  constexpr int count = 7;
  const Numbers w = random_numbers(rows * columns, 8), x = random_numbers(count * columns, 9);
  Numbers rise = random_numbers(columns, 10);
  for (double& r : rise) r = std::abs(r);
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Numbers peak(rows, 5.0), reach(rows, unknown), ends_peak(rows, 5.0), ends_reach(rows, unknown);
  bool settled = true, ends_settled = true;
  const PackedRows packed(Eigen::Map<const Eigen::MatrixXd>(w.data(), rows, columns), columns);
  const bool found = reach_of_samples(packed, Numbers(rows, 0.0).data(), count, x.data(), rise.data(), peak.data(),
                                      reach.data(), reach.data());
  const bool ends_found = reach_of_rows(Peaks::of_abs, packed, Numbers(rows, 0.0).data(), x.data(), x.data() + columns,
                                        rise.data(), ends_peak.data(), ends_reach.data(), ends_reach.data());
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
  }
  EXPECT_EQ(found, settled);
  EXPECT_EQ(ends_found, ends_settled);
}

// Against the cubics themselves at many places, with turning points of every kind: none, one, two, and lines.
class Cubics : public testing::TestWithParam<Peaks> {};

TEST_P(Cubics, ReachAsFarAsTheirLargest) {
  const auto measured = [](double x) { return GetParam() == Peaks::of_abs ? std::abs(x) : x; };
  constexpr Index rows = 8, columns = 4;
  int settled = 0, between = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const Numbers w = random_numbers(rows * columns, seed), offset = random_numbers(rows, seed + 1000);
    Numbers of = random_numbers(4 * columns, seed + 2000), rise = random_numbers(columns, seed + 3000);
    for (double& r : rise) r = 0.01 * std::abs(r);
    for (Index j = 0; j < columns; ++j) {
      double* at = of.data() + j;
      if (seed % 5 == 0) at[2 * columns] = at[3 * columns] = at[columns] - at[0];
      if (seed % 5 == 1) at[2 * columns] = at[3 * columns] = 0.0;
      if (seed % 5 == 2) at[2 * columns] = 8 * at[2 * columns];
    }
    const PackedRows packed(Eigen::Map<const Eigen::MatrixXd>(w.data(), rows, columns), columns);
    const double before = GetParam() == Peaks::of_abs ? 9.0 : 6.0;
    Numbers peak(rows, before), reach(rows, std::numeric_limits<double>::infinity());
    const double* start = of.data();
    const double *end = start + columns, *slope = end + columns, *slope_end = slope + columns;
    const bool found = reach_of_cubics(GetParam(), packed, offset.data(), {start, end, slope, slope_end, rise.data()},
                                       peak.data(), reach.data(), reach.data());
    bool below = true;
    for (Index r = 0; r < rows; ++r) {
      const auto row = [&](const double* x) {
        double sum = 0.0;
        for (Index j = 0; j < columns; ++j) sum += packed(r, j) * x[j];
        return sum;
      };
      double beyond = 0.0;
      for (Index j = 0; j < columns; ++j) beyond += std::abs(packed(r, j)) * rise[static_cast<std::size_t>(j)];
      const auto at = static_cast<std::size_t>(r);
      const double a = offset[at] + row(start), b = offset[at] + row(end), da = row(slope), db = row(slope_end);
      const double ends = std::max(measured(a), measured(b));
      double largest = ends;
      constexpr int places = 4000;
      for (int i = 0; i <= places; ++i) {
        const double s = static_cast<double>(i) / places, rest = 1 - s;
        largest = std::max(largest, measured(a * rest * rest * (1 + 2 * s) + b * s * s * (3 - 2 * s) +
                                             da * s * rest * rest - db * s * s * rest));
      }
      // No less; and no more than a parabola has beyond the nearest of the places.
      const double size = std::abs(a) + std::abs(b) + std::abs(da) + std::abs(db);
      EXPECT_GE(reach[at], largest + beyond - 1e-14 * size);
      EXPECT_LE(reach[at], largest + beyond + 12 * size / (8.0 * places * places) + 1e-14 * size);
      EXPECT_NEAR(peak[at], std::max(before, ends), 1e-14 * size);
      below = below && reach[at] <= peak[at];
      between += largest > ends + 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(found, below);
    settled += found ? 1 : 0;
  }
  EXPECT_GT(settled, 20);
  EXPECT_GT(between, 400);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Cubics, testing::Values(Peaks::of_abs, Peaks::of_values));

TEST(Kernels, PackedRowsAreFilledUpWithZeros) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(6, 3);
  const PackedRows packed(matrix, 4);
  ASSERT_EQ(packed.rows(), 8);
  ASSERT_EQ(packed.columns(), 4);
  for (Index r = 0; r < 8; ++r) {
    for (Index j = 0; j < 4; ++j) EXPECT_EQ(packed(r, j), r < 6 && j < 3 ? matrix(r, j) : 0.0);
  }
}

// As if they had been multiplied, to the bit: bodies that stand between two, forces that few rows depend on.
TEST(Kernels, ColumnsOfZerosArePassedOver) {
  constexpr Index rows = 12, columns = 24, count = 7;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, columns);
  matrix.middleCols(4, 9).setZero();
  matrix.topRightCorner(8, 8).setZero();
  const PackedRows packed(matrix, columns);
  ASSERT_EQ(packed.runs(0).size(), 2U);
  EXPECT_EQ(packed.runs(4).back().end, 16);
  EXPECT_EQ(packed.runs(8).back().end, 24);
  ASSERT_EQ(packed.runs().size(), 2U);
  EXPECT_EQ(packed.runs().back().begin, 12);
  const Numbers x = random_numbers(count * columns, 21);
  Numbers rise = random_numbers(columns, 22);
  for (double& r : rise) r = std::abs(r);
  const Numbers none(rows, 0.0);
  Numbers peak(rows, 0.0), values(rows * count), low(rows), high(rows), sampled(rows, 0.0);
  Numbers reach(rows, std::numeric_limits<double>::infinity()), limits(rows, 2.0), lumped(columns, 0.0), sum(1);
  raise_peaks(Peaks::of_values, packed, none.data(), count, x.data(), columns, peak.data(), values.data());
  const double any = std::numeric_limits<double>::infinity();
  std::vector<Index> fours(rows, -1);
  const Numbers below(rows, -any), above(rows, any);
  EXPECT_EQ(fours_beyond(packed, x.data(), x.data() + columns, rise.data(), below.data(), above.data(), low.data(),
                         high.data(), fours.data()),
            0);
  ASSERT_EQ(fours_beyond(packed, x.data(), x.data() + columns, rise.data(), above.data(), above.data(), low.data(),
                         high.data(), fours.data()),
            static_cast<Index>(rows) / 4);
  EXPECT_EQ(fours[1], 4);
  Numbers one_above = above;
  one_above[6] = std::nextafter(high[6], -any);
  ASSERT_EQ(fours_beyond(packed, x.data(), x.data() + columns, rise.data(), low.data(), one_above.data(), low.data(),
                         high.data(), fours.data()),
            1);
  EXPECT_EQ(fours[0], 4);
  reach_of_samples(packed, none.data(), count, x.data(), rise.data(), sampled.data(), reach.data(), reach.data());
  lump(packed, limits.data(), lumped.data());
  sums(1, rise.data(), columns, packed.runs(), lumped.data(), sum.data());
  EXPECT_EQ(sum[0], dot(columns, lumped.data(), rise.data()));
  for (Index j = 0; j < columns; ++j) {
    EXPECT_EQ(lumped[static_cast<std::size_t>(j)], matrix.col(j).cwiseAbs().maxCoeff() / 2.0);
  }
  for (Index r = 0; r < rows; ++r) {
    const auto at = static_cast<std::size_t>(r);
    double further = 0.0, largest = 0.0;
    for (Index j = 0; j < columns; ++j) further += std::abs(matrix(r, j)) * rise[static_cast<std::size_t>(j)];
    Numbers plain;
    for (Index i = 0; i < count; ++i) {
      double value = 0.0;
      for (Index j = 0; j < columns; ++j) value += matrix(r, j) * x[static_cast<std::size_t>(i * columns + j)];
      plain.push_back(value);
      largest = std::max(largest, std::abs(value));
      EXPECT_EQ(values[static_cast<std::size_t>(r / 4 * 4 * count + 4 * i + r % 4)], value);
    }
    EXPECT_EQ(peak[at], std::max(0.0, *std::max_element(plain.begin(), plain.end())));
    EXPECT_EQ(low[at], std::min(plain[0], plain[1]) - further);
    EXPECT_EQ(high[at], std::max(plain[0], plain[1]) + further);
    EXPECT_EQ(reach[at], largest + further);
  }
}

TEST(Kernels, ReachOfValuesIsOneSided) {
  const PackedRows packed(Eigen::MatrixXd::Identity(4, 4), 4);
  const Numbers start{-3, 1, 0, 2}, end{-1, -5, 0, 4}, rise{1, 1, 0, 1};
  Numbers peak{0, 2, 0, 9}, reach(4, std::numeric_limits<double>::infinity());
  const Numbers none(4, 0.0);
  EXPECT_TRUE(reach_of_rows(Peaks::of_values, packed, none.data(), start.data(), end.data(), rise.data(), peak.data(),
                            reach.data(), reach.data()));
  EXPECT_EQ(reach, (Numbers{0, 2, 0, 5}));
  EXPECT_EQ(peak, (Numbers{0, 2, 0, 9}));
  // An offset moves values, not how far they rise in between.
  const Numbers offset{0, 0, -1, 8};
  reach.assign(4, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(reach_of_rows(Peaks::of_values, packed, offset.data(), start.data(), end.data(), rise.data(),
                             peak.data(), reach.data(), reach.data()));
  EXPECT_EQ(reach, (Numbers{0, 2, -1, 13}));
  EXPECT_EQ(peak, (Numbers{0, 2, 0, 12}));
}

class PeaksOf : public testing::TestWithParam<Peaks> {};

TEST_P(PeaksOf, AllVectorsAndTheirShares) {
  constexpr Index rows = 6, columns = 8, stride = 11;
  constexpr int count = 9;
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, columns);
  const PackedRows packed(matrix, columns);
  const Numbers x = random_numbers(count * stride, 1);
  Numbers peak(8, 0.0), inverse(8), share(count), at_vectors(8 * count), expected(rows, 0.0);
  peak[2] = expected[2] = 100.0;  // higher than any
  raise_peaks(GetParam(), packed, Numbers(8, 0.0).data(), count, x.data(), stride, peak.data(), at_vectors.data());
  for (std::size_t r = 0; r < 8; ++r) inverse[r] = 1.0 / peak[r];
  largest_shares(8, count, at_vectors.data(), inverse.data(), share.data());
  Eigen::MatrixXd values(rows, count);
  for (int i = 0; i < count; ++i) {
    for (Index r = 0; r < rows; ++r) {
      double sum = 0.0;
      for (Index j = 0; j < columns; ++j) sum += matrix(r, j) * x[static_cast<std::size_t>(i * stride + j)];
      values(r, i) = GetParam() == Peaks::of_abs ? std::abs(sum) : sum;
      double& most = expected[static_cast<std::size_t>(r)];
      most = std::max(most, values(r, i));
    }
  }
  for (std::size_t r = 0; r < 8; ++r) EXPECT_EQ(peak[r], r < rows ? expected[r] : 0.0);
  for (int i = 0; i < count; ++i) {
    double most = 0.0;
    for (Index r = 0; r < rows; ++r)
      most = std::max(most, values(r, i) * (1.0 / expected[static_cast<std::size_t>(r)]));
    EXPECT_EQ(share[static_cast<std::size_t>(i)], most);
    for (Index r = 0; r < rows; ++r)
      EXPECT_EQ(at_vectors[static_cast<std::size_t>(r / 4 * 4 * count + 4 * i + r % 4)], values(r, i));
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, PeaksOf, testing::Values(Peaks::of_abs, Peaks::of_values));

TEST(Kernels, SumsAreDotProducts) {
  constexpr Index n = 8, stride = 12, count = 7;
  const Numbers x = random_numbers(count * stride, 1), w = random_numbers(n, 2);
  Numbers result(count);
  const PackedRows::Run all_columns{0, n};
  sums(count, x.data(), stride, {&all_columns, 1}, w.data(), result.data());
  for (Index i = 0; i < count; ++i) {
    EXPECT_EQ(result[static_cast<std::size_t>(i)], dot(n, w.data(), x.data() + i * stride));
  }
}

TEST(Kernels, SumsOfTwoSidesRaiseTheirLargest) {
  constexpr std::size_t count = 7;
  const Numbers left = random_numbers(4 * count, 31), right = random_numbers(4 * count, 32);
  Numbers largest{-9, 0.5, 100, -9}, expected = largest;
  raise_sums(count, left.data(), right.data(), largest.data());
  for (std::size_t n = 0; n < left.size(); ++n) expected[n % 4] = std::max(expected[n % 4], left[n] + right[n]);
  EXPECT_EQ(largest, expected);
}

TEST(Kernels, TheFirstStepBeyondIsThatOfAnyOfFour) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Index count = 40;
  Numbers values = random_numbers(4 * (count + 1), 33), between = random_numbers(count, 34);
  for (double& b : between) b = std::abs(b) < 0.1 ? infinity : 0.1 * std::abs(b);
  values[4 * 23 + 1] = std::numeric_limits<double>::quiet_NaN();
  const Numbers of{1, 3, 0, 2};  // 0 · ∞ is no number
  Index found = 0;
  for (const double most : {0.0, 1.8, 2.2, 2.5, 9.0}) {
    const Numbers known{most, 1.2 * most, 0.9 * most, most};
    for (Index from = 0; from <= count; ++from) {
      Index step = from;
      const auto beyond = [&](Index n) {
        for (std::size_t r = 0; r < 4; ++r) {
          const auto at = 4 * static_cast<std::size_t>(n) + r;
          const double rise = between[static_cast<std::size_t>(n)] * of[r];
          if (!(values[at] + rise <= known[r] && values[at + 4] + rise <= known[r])) return true;
        }
        return false;
      };
      while (step < count && !beyond(step)) ++step;
      EXPECT_EQ(first_beyond(from, count, values.data(), between.data(), of.data(), known.data()), step);
      found += step > from && step < count ? 1 : 0;
    }
  }
  EXPECT_GT(found, 30);
}

TEST(Kernels, GroupsAreOpenWhereOneOfFourComesNear) {
  const Numbers x{1, 1, 1, 1, /**/ 0, 0, 0, 0}, y{0.5, 0.5, 0.5, 0.5, /**/ 0, 0, 0, 3};
  const Numbers peak{2, 2, 2, 2, /**/ 3, 3, 3, 3};
  Numbers open(8, -1.0);
  mark_unsettled(8, x.data(), y.data(), 1, peak.data(), 0.9, open.data());
  for (std::size_t r = 0; r < 4; ++r) EXPECT_EQ(open[r], 0.0);
  for (std::size_t r = 4; r < 8; ++r) EXPECT_EQ(open[r], std::numeric_limits<double>::infinity());
}

TEST(Kernels, GroupsThatCannotBeComparedAreOpen) {
  const Numbers x(4, 0.0), peak(4, 0.0);  // nothing has moved at the ends, and the sum over what rises is infinite
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double rest : {-infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Numbers open(4, -1.0);
    mark_unsettled(4, x.data(), x.data(), 1, peak.data(), rest, open.data());
    EXPECT_EQ(open, Numbers(4, infinity));
  }
}

TEST(Kernels, WhatIsNoNumberIsBelowNothing) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const PackedRows packed(Eigen::MatrixXd::Identity(4, 4), 4);
  const Numbers none(4, 0.0), rise(4, infinity), unknown(4, infinity);  // a rise of 0 times infinity
  Numbers peak(4, 1.0), reach(4, 0.0);
  EXPECT_FALSE(reach_of_rows(Peaks::of_values, packed, none.data(), none.data(), none.data(), rise.data(), peak.data(),
                             unknown.data(), reach.data()));
  EXPECT_EQ(count_above(4, reach.data(), peak.data()), 4);
  // What was unknown before is looked at again.
  EXPECT_TRUE(reach_of_rows(Peaks::of_values, packed, none.data(), none.data(), none.data(), none.data(), peak.data(),
                            reach.data(), reach.data()));
  EXPECT_EQ(reach, none);
  reach.assign(4, 0.0);
  EXPECT_FALSE(
      reach_of_samples(packed, none.data(), 1, none.data(), rise.data(), peak.data(), unknown.data(), reach.data()));
}

TEST(Kernels, LumpIsTheLargestPartOfALimit) {
  Eigen::MatrixXd matrix(5, 3);
  matrix << 1, -2, 0, 0.5, 4, 0, -3, 1, 0, 0, 0, 0, 2, 2, 0;
  const PackedRows packed(matrix, 3), last_two(matrix.rightCols(2), 2);
  const Numbers limits{1, 8, 2, 0, 4, 0, 0, 0};  // a row of zeros may have the limit zero
  Numbers largest(3, -1.0);
  lump(packed, limits.data(), largest.data());
  EXPECT_EQ(largest, (Numbers{1.5, 2.0, 0.0}));
  lump(last_two, limits.data(), largest.data());
  EXPECT_EQ(largest, (Numbers{2.0, 0.0, 0.0}));
}

TEST(Kernels, CombineIsTheRowOfEveryPower) {
  constexpr Index columns = 8, stride = 12;
  constexpr int degree = 5;
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(6, columns);
  const PackedRows packed(matrix, columns);
  const Numbers c = random_numbers(stride * (degree + 1), 2);
  Numbers scratch(columns), polynomial(degree + 1);
  for (Index r = 0; r < 6; ++r) {
    combine(packed, r, c.data(), stride, degree, scratch.data(), polynomial.data());
    const Eigen::VectorXd row = matrix.row(r).transpose();
    for (int k = 0; k <= degree; ++k)
      EXPECT_EQ(polynomial[static_cast<std::size_t>(k)], dot(columns, row.data(), c.data() + k * stride));
  }
}

}  // namespace
}  // namespace bentur::engine::kernels
