#include "bentur/core/units.h"

#include <gtest/gtest.h>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

TEST(Units, LengthsAreTheInternationalOnes) {
  EXPECT_EQ(metres("m"), 1.0);
  EXPECT_EQ(metres("cm"), 0.01);
  EXPECT_EQ(metres("mm"), 0.001);
  EXPECT_EQ(metres("in"), 0.0254);
  EXPECT_EQ(metres("ft"), 0.3048);
  for (const std::string& unit : length_units()) EXPECT_GT(metres(unit), 0) << unit;
}

TEST(Units, StandardGravity) {
  // One rounding of a division: a few units in the last place.
  EXPECT_DOUBLE_EQ(standard_gravity("m"), 9.80665);
  EXPECT_DOUBLE_EQ(standard_gravity("cm"), 980.665);
  EXPECT_DOUBLE_EQ(standard_gravity("mm"), 9806.65);
  EXPECT_NEAR(standard_gravity("in"), 386.0886, 1e-4);
  EXPECT_NEAR(standard_gravity("ft"), 32.17405, 1e-5);
}

TEST(Units, ListsHoldWhatTheCaseFormatNames) {
  EXPECT_EQ(length_units(), (std::vector<std::string>{"m", "cm", "mm", "in", "ft"}));
  EXPECT_EQ(force_units(), (std::vector<std::string>{"N", "kN", "MN", "kgf", "tf", "lbf", "kip"}));
  EXPECT_EQ(acceleration_units(), (std::vector<std::string>{"g", "m/s2", "cm/s2", "mm/s2", "in/s2", "ft/s2"}));
}

TEST(Units, AccelerationFactor) {
  const Units cm{"cm", "kgf", 980.0};
  EXPECT_EQ(acceleration_factor("g", cm), 980.0);  // the case's own gravity, not the standard one
  EXPECT_EQ(acceleration_factor("cm/s2", cm), 1.0);
  EXPECT_DOUBLE_EQ(acceleration_factor("m/s2", cm), 100.0);
  EXPECT_DOUBLE_EQ(acceleration_factor("mm/s2", cm), 0.1);
  EXPECT_DOUBLE_EQ(acceleration_factor("ft/s2", {"in", "kip", 386.0}), 12.0);
  EXPECT_DOUBLE_EQ(acceleration_factor("in/s2", {"m", "N", 9.81}), 0.0254);
  for (const std::string& unit : acceleration_units()) EXPECT_GT(acceleration_factor(unit, cm), 0) << unit;
}

TEST(Units, UnknownUnitsAreNamed) {
  try {
    static_cast<void>(metres("furlong"));
    FAIL() << "furlong was taken";
  } catch (const InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "length unit = furlong, must be one of m cm mm in ft");
  }
  EXPECT_THROW(static_cast<void>(standard_gravity("")), InvalidParameter);
  EXPECT_THROW(static_cast<void>(acceleration_factor("G", {})), InvalidParameter);
  EXPECT_THROW(static_cast<void>(acceleration_factor("m/s2", {"yd", "N", 10})), InvalidParameter);
}

}  // namespace
}  // namespace bentur
