#include "bentur/study/quantiles.h"

#include <gtest/gtest.h>

#include <limits>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

TEST(Quantiles, AreLinearBetweenTheNumbersInOrder) {
  const std::vector<double> numbers = {40, 10, 30, 20, 50};
  EXPECT_EQ(quantile_of(numbers, 0), 10);
  EXPECT_EQ(quantile_of(numbers, 1), 50);
  EXPECT_EQ(quantile_of(numbers, 0.5), 30);
  EXPECT_DOUBLE_EQ(quantile_of(numbers, 0.84), 43.6);  // at place 4 · 0.84 = 3.36
  EXPECT_DOUBLE_EQ(quantile_of(numbers, 0.16), 16.4);
  EXPECT_EQ(median_of({3, 1}), 2);
  EXPECT_EQ(quantile_of({7}, 0.95), 7);
}

TEST(Quantiles, RefuseWhatHasNone) {
  EXPECT_THROW((void)quantile_of({}, 0.5), InvalidParameter);
  EXPECT_THROW((void)quantile_of({1}, 1.01), InvalidParameter);
  EXPECT_THROW((void)quantile_of({1}, std::numeric_limits<double>::quiet_NaN()), InvalidParameter);
}

}  // namespace
}  // namespace bentur
