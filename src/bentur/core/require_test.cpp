#include "bentur/core/require.h"

#include <gtest/gtest.h>

#include <limits>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Require, Ranges) {
  EXPECT_NO_THROW(require_positive("a", 1e-300));
  EXPECT_NO_THROW(require_not_negative("a", 0.0));
  EXPECT_NO_THROW(require_finite("a", -1e300));
  EXPECT_NO_THROW(require_size("a", 3, 3));
  for (const double bad : {0.0, -1.0, infinity, nan}) EXPECT_THROW(require_positive("a", bad), InvalidParameter) << bad;
  for (const double bad : {-1e-300, infinity, nan})
    EXPECT_THROW(require_not_negative("a", bad), InvalidParameter) << bad;
  for (const double bad : {-infinity, infinity, nan}) EXPECT_THROW(require_finite("a", bad), InvalidParameter) << bad;
  EXPECT_THROW(require_size("a", 2, 3), InvalidParameter);
}

TEST(Require, MessageNamesParameterValueAndRange) {
  try {
    require_positive(indexed("masses", 2), -1.5);
    FAIL() << "-1.5 was taken";
  } catch (const InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "masses[2] = -1.5, must be > 0");
  }
  try {
    require_size("beams", 1, 3);
    FAIL() << "1 was taken for 3";
  } catch (const InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "beams = a list of 1, must have 3 entries");
  }
}

}  // namespace
}  // namespace bentur
