#include "bentur/contact/axial_stiffness.h"

#include <gtest/gtest.h>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

// The monograph's beams [cm, kgf]: E = 2.1e5, bay 100.
double contact_stiffness(double left_area, double right_area) {
  return series_stiffness(half_beam_stiffness(2.1e5, left_area, 100), half_beam_stiffness(2.1e5, right_area, 100));
}

TEST(AxialStiffness, MonographTables) {
  // Tables 2 and C.2 print eight to ten figures; the first entry of Table 2 is that of equal beams (theory 7.1).
  EXPECT_DOUBLE_EQ(contact_stiffness(9 * 12, 9 * 12), 226800);
  EXPECT_NEAR(contact_stiffness(9 * 12, 9 * 10), 206181.82, 5e-3);
  EXPECT_NEAR(contact_stiffness(8 * 12, 8 * 10), 183272.727, 5e-4);
  EXPECT_NEAR(contact_stiffness(9 * 12, 8 * 10), 193021.2766, 5e-5);
}

TEST(AxialStiffness, HalfABeamIsTwiceAsStiff) {
  EXPECT_DOUBLE_EQ(half_beam_stiffness(200e9, 0.06, 5), 2 * 200e9 * 0.06 / 5);
}

TEST(AxialStiffness, SeriesIsSymmetricAndSofterThanEither) {
  EXPECT_EQ(series_stiffness(3e5, 7e4), series_stiffness(7e4, 3e5));
  EXPECT_LT(series_stiffness(3e5, 7e4), 7e4);
  EXPECT_DOUBLE_EQ(series_stiffness(4e5, 4e5), 2e5);
  EXPECT_NEAR(series_stiffness(7e4, 1e30) / 7e4, 1, 1e-15);  // against a rigid body
}

TEST(AxialStiffness, RefusesWhatIsNotPositive) {
  EXPECT_THROW(static_cast<void>(half_beam_stiffness(0, 1, 1)), InvalidParameter);
  EXPECT_THROW(static_cast<void>(half_beam_stiffness(1, -1, 1)), InvalidParameter);
  EXPECT_THROW(static_cast<void>(half_beam_stiffness(1, 1, 0)), InvalidParameter);
  EXPECT_THROW(static_cast<void>(series_stiffness(0, 1)), InvalidParameter);
  EXPECT_THROW(static_cast<void>(series_stiffness(1, -1)), InvalidParameter);
}

}  // namespace
}  // namespace bentur
