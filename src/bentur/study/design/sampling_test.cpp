#include "bentur/study/design/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Method = Sampling::Method;

/// How many of the points lie in each of `slices` equal parts of an axis.
std::vector<int> counts(const UnitPoints& points, std::size_t count, std::size_t axis, std::size_t slices) {
  std::vector<int> result(slices, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = points.at(i, axis);
    EXPECT_GT(u, 0);
    EXPECT_LT(u, 1);
    ++result[static_cast<std::size_t>(u * static_cast<double>(slices))];
  }
  return result;
}

TEST(Sampling, LatinHypercubeHasOnePointInEachSliceOfEachAxis) {
  for (const std::size_t count : {1U, 2U, 3U, 10U, 64U, 1000U}) {
    const UnitPoints points({Method::latin_hypercube, count, 7}, 4);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      EXPECT_EQ(counts(points, count, axis, count), std::vector<int>(count, 1)) << count;
    }
  }
}

TEST(Sampling, SobolPointsAreEvenAlsoInPairsOfAxes) {
  // Of 2^m points of a sequence of base two, 2^m/64 lie in each of the 8 × 8 squares of the first two axes (t = 0).
  const std::size_t count = 256;
  const UnitPoints points({Method::sobol, count, 3}, 3);
  std::vector<int> squares(64, 0);
  for (std::size_t i = 0; i < count; ++i) {
    ++squares[static_cast<std::size_t>(points.at(i, 0) * 8) * 8 + static_cast<std::size_t>(points.at(i, 1) * 8)];
  }
  EXPECT_EQ(squares, std::vector<int>(64, 4));
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_EQ(counts(points, count, axis, count), std::vector<int>(count, 1));
}

TEST(Sampling, AxesAreNotAlike) {
  const std::size_t count = 4000;
  for (const Method method : {Method::latin_hypercube, Method::sobol, Method::random}) {
    const UnitPoints points({method, count, 1}, 3);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        double product = 0;
        for (std::size_t i = 0; i < count; ++i) product += (points.at(i, a) - 0.5) * (points.at(i, b) - 0.5);
        // Of independent numbers: 12 × mean product has standard deviation 1/√count = 0.016; four of them.
        EXPECT_LT(std::abs(12 * product / static_cast<double>(count)), 0.064) << a << b;
      }
    }
  }
}

TEST(Sampling, RandomIsUniform) {
  const std::size_t count = 10000;
  const UnitPoints points({Method::random, count, 5}, 1);
  for (const int n : counts(points, count, 0, 10)) EXPECT_NEAR(n, 1000, 120);  // four standard deviations of 30
}

TEST(Sampling, SeedsDifferAndOneSeedIsOnePointSet) {
  for (const Method method : {Method::latin_hypercube, Method::sobol, Method::random}) {
    const UnitPoints one({method, 100, 1}, 2);
    const UnitPoints again({method, 100, 1}, 2);
    const UnitPoints other({method, 100, 2}, 2);
    std::set<double> seen;
    for (std::size_t i = 0; i < 100; ++i) {
      EXPECT_EQ(one.at(i, 1), again.at(i, 1));
      EXPECT_NE(one.at(i, 1), other.at(i, 1));
      seen.insert(one.at(i, 1));
    }
    EXPECT_EQ(seen.size(), 100U);
  }
}

TEST(Sampling, OtherMachinesDrawTheSame) {
  // SplitMix64 by other means, so that a change shows: a journal begun before could not be gone on with.
  EXPECT_EQ(UnitPoints({Method::random, 10, 1}, 2).at(3, 1), 0.4583095686907637);
  const UnitPoints sobol({Method::sobol, 10, 1}, 2);
  const double shift = sobol.at(0, 0);
  EXPECT_NEAR(std::abs(sobol.at(1, 0) - shift), 0.5, 1e-15);  // the points of axis 0 begin 0, 1/2, 3/4, 1/4
}

TEST(Sampling, RefusesWhatItCannotDo) {
  EXPECT_THROW(UnitPoints({Method::random, 0, 1}, 1), InvalidParameter);
  EXPECT_THROW(UnitPoints({Method::sobol, 1, 1}, 3668), InvalidParameter);
}

}  // namespace
}  // namespace bentur
