#include "bentur/core/key.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace bentur {
namespace {

static_assert(!std::is_default_constructible_v<PhysicalDimension>, "a key without a dimension must not compile");

TEST(Key, BoundsAreThoseThatARuleKeeps) {
  for (int i = 0; i <= static_cast<int>(Range::memory_limit); ++i) {
    const auto range = static_cast<Range>(i);
    const Bounds bounds = bounds_of(range);
    EXPECT_EQ(broken_rule(range, bounds.least_excluded ? *bounds.least + 1e-12 : bounds.least.value_or(-1e300)), "")
        << i;
    EXPECT_EQ(broken_rule(range, bounds.most_excluded ? *bounds.most - 1e-12 : bounds.most.value_or(1e300)), "") << i;
    if (bounds.least_excluded) {
      EXPECT_NE(broken_rule(range, *bounds.least), "") << i;
    }
    if (bounds.most_excluded) {
      EXPECT_NE(broken_rule(range, *bounds.most), "") << i;
    }
    if (bounds.least) {
      EXPECT_NE(broken_rule(range, *bounds.least - std::abs(*bounds.least) - 1), "") << i;
    }
    if (bounds.most) {
      EXPECT_NE(broken_rule(range, 2 * *bounds.most), "") << i;
    }
    EXPECT_NE(broken_rule(range, std::numeric_limits<double>::quiet_NaN()), "") << i;
    EXPECT_EQ(broken_rule(range, std::numeric_limits<double>::infinity()).empty(),
              range == Range::positive_or_infinite);
  }
  EXPECT_NE(broken_rule(Range::not_zero, 0), "");
}

TEST(Key, IsFoundByItsNameAndTellsWhoOwnsIt) {
  const KeyTable table = {"t",
                          "",
                          {Key::choice("kind", {"a", "b", "c"}, {"Kind", "Jenis"}),
                           Key::number("x", dimension::length, Range::positive, {"X", "X"}).when("kind", {"a"}),
                           Key::number("x", dimension::force, Range::finite, {"X", "X"}).when("kind", {"b"}),
                           Key::of("y", Key::Kind::flag, {"Y", "Y"}).by_default(1).one_of("g", Need::optional)}};
  EXPECT_EQ(table.names(), (std::vector<std::string>{"kind", "x", "y"}));
  EXPECT_EQ(table.names_of("g"), std::vector<std::string>{"y"});
  EXPECT_EQ(table.owners("x", "kind"), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_TRUE(table.owners("y", "kind").empty());
  EXPECT_EQ(table.at("x").dimension, dimension::length);
  EXPECT_TRUE(table.at("x").is_for("kind", "a"));
  EXPECT_FALSE(table.at("x").is_for("kind", "c"));
  EXPECT_EQ(table.find("z"), nullptr);
  EXPECT_THROW((void)table.at("z"), std::out_of_range);
}

TEST(PhysicalDimension, IsSaidInWordsAndAsAForm) {
  const auto told = [](const PhysicalDimension& of) { return of.form() + " | " + of.text(); };
  EXPECT_EQ(told(dimension::none), "1 | ");
  EXPECT_EQ(told(dimension::mass), "F s2 L-1 | mass");
  EXPECT_EQ(told(dimension::density), "F s2 L-4 | mass/length³");
  EXPECT_EQ(told(dimension::mass_inertia), "F s2 L | mass·length²");
  EXPECT_EQ(told(dimension::acceleration), "L s-2 | length/s²");
  EXPECT_EQ(told(dimension::slowness), "s L-1 | s/length");
  EXPECT_EQ(told(dimension::dashpot), "F s L-1 | force·s/length");
  EXPECT_EQ(told(dimension::hertz_stiffness), " | force/length^1.5");
}

TEST(PhysicalDimension, TurnsNumbersIntoOtherUnits) {
  EXPECT_DOUBLE_EQ(dimension::pressure.factor(100, 1e-3), 1e-7);
  EXPECT_DOUBLE_EQ(dimension::hertz_stiffness.factor(100, 1), 1e-3);
  EXPECT_EQ(dimension::time.factor(100, 1e-3), 1);
}

}  // namespace
}  // namespace bentur
