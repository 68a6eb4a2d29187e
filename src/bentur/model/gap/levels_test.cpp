#include "bentur/model/gap/levels.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

TEST(LevelFloors, PairsFloorsOfOneLevelAtTheLeftOnesElevation) {
  const auto pairs = level_floors({{3, 6, 9}, 0}, {{3, 6 + 1e-7, 9, 12}, 0});
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[1].left_floor, 1);
  EXPECT_EQ(pairs[1].right_floor, 1);
  EXPECT_EQ(pairs[1].elevation, 6);
}

TEST(LevelFloors, MeetAtTheMeanWithinATenthOfTheSmallestStoreyThere) {
  // Storeys of 3 m on the left, of 2.19 and 2.23 m on the right.
  const FloorLevels left{{3, 6, 9}, 0};
  EXPECT_EQ(level_floors(left, {{2, 4, 6.19}, 0}).size(), 1u);
  EXPECT_NEAR(level_floors(left, {{2, 4, 6.19}, 0}).front().elevation, 6.095, 1e-14);
  EXPECT_TRUE(level_floors(left, {{2, 4, 6.23}, 0}).empty());
  // A base of its own: the lowest storey is 1.5 m.
  EXPECT_EQ(level_floors(left, {{6.14, 9.5}, 4.64}).size(), 1u);
  EXPECT_TRUE(level_floors(left, {{6.16, 9.5}, 4.66}).empty());
}

TEST(LevelFloors, ByAGivenTolerance) {
  const FloorLevels left{{3, 6}, 0}, right{{3.4, 6.8}, 0};
  EXPECT_TRUE(level_floors(left, right).empty());
  EXPECT_EQ(level_floors(left, right, 0.5).size(), 1u);
  EXPECT_EQ(level_floors(left, right, 0.8000001).size(), 2u);
  EXPECT_TRUE(level_floors(left, {{3.001, 6.001}, 0}, 0.0).empty());
  EXPECT_EQ(level_floors(left, {{3 + 1e-7, 6}, 0}, 0.0).size(), 2u);  // round-off
}

// Floors as far apart as the tolerance, or as a tenth of a storey, and one half way between two others.
TEST(LevelFloors, AreTheSameInEveryUnit) {
  for (const double unit : {1.0, 100.0, 1e3, 1e-3, 1 / 0.0254, 1 / 0.3048}) {
    const auto in_units = [unit](FloorLevels levels) {
      for (double& elevation : levels.elevations) elevation *= unit;
      return levels;
    };
    const FloorLevels left = in_units({{3, 6}, 0}), right = in_units({{3.1, 6.1}, 0});
    EXPECT_EQ(level_floors(left, right, 0.1 * unit).size(), 2u) << unit;
    EXPECT_EQ(level_floors(in_units({{3, 6}, 0}), in_units({{3.3, 6.6}, 0})).size(), 1u) << unit;
    const auto between = level_floors(in_units({{3.1}, 0}), in_units({{2.9, 3.3}, 0}), 0.5 * unit);
    ASSERT_EQ(between.size(), 1u) << unit;
    EXPECT_EQ(between[0].right_floor, 0) << unit;
  }
}

TEST(LevelFloors, NoFloorMeetsTwo) {
  const auto pairs = level_floors({{3.0, 3.2, 6.0}, 0}, {{3.1, 6.0}, 0}, 1.0);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].right_floor, 0);
  EXPECT_EQ(pairs[1].left_floor, 2);
}

TEST(PairAt, IsNamedByEitherFloorOrWhatIsBetween) {
  const FloorLevels left{{3, 6}, 0}, right{{3, 6.2}, 0};
  const auto pairs = level_floors(left, right);
  for (const double elevation : {6.0, 6.1, 6.2}) {
    ASSERT_NE(pair_at(elevation, pairs, left, right), nullptr) << elevation;
    EXPECT_EQ(pair_at(elevation, pairs, left, right)->left_floor, 1);
  }
  EXPECT_EQ(pair_at(5.9, pairs, left, right), nullptr);
  EXPECT_EQ(pair_at(6.3, pairs, left, right), nullptr);
}

}  // namespace
}  // namespace bentur
