#include "bentur/report/scene/tones.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace bentur {
namespace {

Problem houses(std::size_t buildings) {
  Problem problem;
  problem.buildings.resize(buildings);
  for (std::size_t gap = 0; gap + 1 < buildings; ++gap) {
    ContactPoint point;
    point.left = static_cast<Eigen::Index>(gap);
    point.right = point.left + 1;
    problem.points.push_back(point);
  }
  return problem;
}

Impact blow(Eigen::Index point, double force) {
  Impact impact;
  impact.point = point;
  impact.peak_force = force;
  return impact;
}

RunOutcome outcome_of(std::vector<Impact> impacts) {
  RunOutcome outcome;
  outcome.impacts = std::move(impacts);
  return outcome;
}

TEST(Tones, UpToTenBuildingsHaveOneEach) {
  const std::vector<Tone> tones = tones_of(houses(10), outcome_of({blow(3, 1)}));
  for (std::size_t b = 0; b < tones.size(); ++b) EXPECT_EQ(tones[b], building_tones[b]);
}

/// No colour says of two of many buildings that they are one.
TEST(Tones, OfManyBuildingsTheTwoHitHardestAloneHaveColours) {
  for (const Eigen::Index hardest : {0, 3, 6, 10}) {
    const std::vector<Tone> tones = tones_of(houses(12), outcome_of({blow(1, 2), blow(hardest, 3), blow(5, 1)}));
    for (std::size_t b = 0; b < tones.size(); ++b) {
      const bool is_left = static_cast<Eigen::Index>(b) == hardest,
                 is_right = static_cast<Eigen::Index>(b) == hardest + 1;
      EXPECT_EQ(tones[b] == building_tones[0], is_left) << b;
      EXPECT_EQ(tones[b] == building_tones[1], is_right) << b;
      if (!is_left && !is_right) {
        EXPECT_TRUE(tones[b] == Tone::bark || tones[b] == Tone::stone) << b;
      }
      if (b > 0) {
        EXPECT_TRUE(are_distinct_in_grey(tones[b - 1], tones[b])) << b << " beside its neighbour";
      }
    }
  }
  for (const Tone tone : tones_of(houses(12), RunOutcome{})) EXPECT_TRUE(tone == Tone::bark || tone == Tone::stone);
}

/// And the two whose gap lacks most, of whom one may be among those.
TEST(Tones, OfManyBuildingsTheWorstGapHasColoursToo) {
  for (const Eigen::Index worst : {0, 1, 3, 4, 8}) {
    RunOutcome outcome = outcome_of({blow(3, 1)});
    outcome.points.resize(11);
    outcome.points[6].gap_needed = 1;
    outcome.points[worst].gap_needed_reversed = 2;
    const std::vector<Tone> tones = tones_of(houses(12), outcome);
    for (std::size_t b = 0; b < tones.size(); ++b) {
      const auto number = static_cast<Eigen::Index>(b);
      const bool is_struck = number == 3 || number == 4, is_worst = number == worst || number == worst + 1;
      const bool is_of_worst = tones[b] == building_tones[2] || tones[b] == building_tones[3];
      EXPECT_EQ(is_of_worst, is_worst && !is_struck) << worst << ": " << b;
      if (b > 0) {
        EXPECT_TRUE(are_distinct_in_grey(tones[b - 1], tones[b])) << worst << ": " << b << " beside its neighbour";
      }
    }
  }
}

}  // namespace
}  // namespace bentur
