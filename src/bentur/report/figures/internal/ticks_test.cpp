#include "bentur/report/figures/internal/ticks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bentur {
namespace {

std::string joined(const Ticks& ticks) {
  std::string text;
  for (const auto& [at, label] : ticks.labels) text += label + " ";
  return text;
}

TEST(TicksTest, RoundNumbersWithinAnAxisThatLeavesAir) {
  const Ticks ticks = make_ticks({.low = -0.45, .high = 0.46, .most = 6});
  EXPECT_EQ(joined(ticks), "−0.4 −0.2 0 0.2 0.4 ");
  EXPECT_LT(ticks.from, -0.45);
  EXPECT_GT(ticks.to, 0.46);
  EXPECT_LT(ticks.to, 0.55);
}

TEST(TicksTest, ZeroIsAnEndWhereDataEndThere) {
  EXPECT_EQ(make_ticks({.low = 0, .high = 3818}).from, 0);
  EXPECT_EQ(make_ticks({.low = -3, .high = 0}).to, 0);
}

TEST(TicksTest, GivenEndsAreKept) {
  const Ticks ticks = make_ticks({.low = 0.3, .high = 9.7, .from = 0, .to = 10, .most = 5});
  EXPECT_EQ(ticks.from, 0);
  EXPECT_EQ(ticks.to, 10);
  EXPECT_EQ(joined(ticks), "0 2 4 6 8 10 ");
}

TEST(TicksTest, AConstantHasAnAxisToo) {
  for (const double value : {0.0, 7.0, -1e-9}) {
    const Ticks ticks = make_ticks({.low = value, .high = value});
    EXPECT_LE(ticks.from, value);
    EXPECT_GE(ticks.to, value);
    EXPECT_LT(ticks.from, ticks.to);
    EXPECT_GE(ticks.labels.size(), 2U);
  }
}

TEST(TicksTest, ManyDigitsGoIntoTheUnit) {
  const Ticks newton = make_ticks({.low = 0, .high = 8.2e6});
  EXPECT_EQ(newton.exponent, 6);
  EXPECT_EQ(joined(newton), "0 2 4 6 8 ");
  EXPECT_EQ(scaled("Force F [N]", newton), "Force F [10⁶ N]");
  EXPECT_EQ(scaled("Ratio [–]", newton), "Ratio [10⁶]");
  const Ticks small = make_ticks({.low = 0, .high = 3e-5});
  EXPECT_EQ(small.exponent, -6);
  EXPECT_EQ(scaled("δ [m]", small), "δ [10⁻⁶ m]");
  EXPECT_EQ(scaled("F [N]", make_ticks({.low = 0, .high = 9e4})), "F [N]");
  EXPECT_EQ(make_ticks({.low = 0, .high = 1e-12}).exponent, -12);
}

TEST(TicksTest, NeverMoreThanAsked) {
  for (int most = 2; most < 12; ++most) {
    for (double high = 0.013; high < 1e7; high *= 1.37) {
      const Ticks ticks = make_ticks({.low = 0, .high = high, .most = most});
      EXPECT_LE(static_cast<int>(ticks.labels.size()), most + 1) << high << " " << most;
      EXPECT_GE(ticks.labels.size(), 2U);
    }
  }
}

TEST(TicksTest, OneNumberAloneTellsNoScale) {
  for (const double most : {0.9, 0.95, 1.0, 1.7, 4.6}) {
    const Ticks ticks = make_ticks({.low = -most, .high = 0.8 * most, .most = 2});
    EXPECT_GE(ticks.labels.size(), 2U) << most;
    EXPECT_LE(ticks.labels.size(), 5U) << most;
  }
}

TEST(TicksTest, Logarithmic) {
  EXPECT_EQ(joined(make_ticks({.low = 0.02, .high = 5, .logarithmic = true, .most = 8})),
            "0.02 0.05 0.1 0.2 0.5 1 2 5 ");
  const Ticks decades = make_ticks({.low = 0.3, .high = 4000, .logarithmic = true, .most = 6});
  EXPECT_EQ(joined(decades), "0.1 1 10 100 1000 10⁴ ");
  EXPECT_FALSE(decades.minor.empty());
}

TEST(TicksTest, RoundOffIsNoFinding) {
  for (const double ratio : {1 - 1e-16, 1 + 4e-16, 1 + 1e-9, 1 - 1e-4}) {
    const Ticks ticks = make_ticks({.low = ratio, .high = 1, .most = 6});
    for (const auto& [at, label] : ticks.labels) EXPECT_LE(label.size(), 6U) << label << " at " << ratio;
  }
  const Ticks wide = make_ticks({.low = 1, .high = 1 + 1e-12, .most = 6, .least = {{0.95, 1.05}}});
  EXPECT_LE(wide.from, 0.95);
  EXPECT_GE(wide.to, 1.05);
  EXPECT_EQ(make_ticks({.low = -1e-17, .high = 0, .most = 6, .least = {{-1, 1}}}).from, -1.08);
}

TEST(TicksTest, NumbersStandAtFloorsWhereThereIsRoom) {
  Ticks ticks = make_ticks({.low = 0, .high = 13.1, .from = 0, .to = 13.5});
  const Ticks round = ticks;
  put_at(ticks, {-3, 0, 3.5, 6.7, 13.1}, 0.1);
  ASSERT_EQ(ticks.labels.size(), 4U);
  EXPECT_EQ(ticks.labels[1], std::pair(3.5, std::string("3.5")));
  EXPECT_EQ(ticks.labels[3].second, "13.1");
  ticks = round;
  put_at(ticks, {0, 3.5, 4.5, 13.1}, 0.1);
  EXPECT_EQ(ticks.labels, round.labels);
}

TEST(TicksTest, NamesOrNumbers) {
  const std::vector<std::string> names = {"a", "b", "c", "d", "e"};
  EXPECT_EQ(joined(named_ticks(names, false, 3)), "a b c d e ");
  EXPECT_EQ(joined(named_ticks(names, true, 3)), "2 4 ");
  EXPECT_EQ(scaled("", named_ticks(names, true, 3)), "") << "what a neighbour's label tells";
  EXPECT_EQ(scaled("Record", named_ticks(names, true, 3)), "Record (number)");
}

}  // namespace
}  // namespace bentur
