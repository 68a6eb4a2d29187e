// Pairs found by boxes are those that looking at all finds.
#include "bentur/pounding/plan/outline/near.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bentur/pounding/plan/faces.h"

namespace bentur {
namespace {

class Blocks {
 public:
  explicit Blocks(unsigned seed) : engine_(seed) {}

  std::vector<Footprint> make() {
    std::vector<Footprint> all;
    const int count = std::uniform_int_distribution(2, 40)(engine_);
    const double side = 4 * std::sqrt(count);
    for (int i = 0; i < count; ++i) {
      const PlanPoint at(any(0, side), any(0, side));
      if (any(0, 1) < 0.4) {
        all.push_back({.corner = at, .size = {any(1, 8), any(1, 8)}});
      } else {
        all.push_back(polygon(at));
      }
    }
    return all;
  }
  double any(double from, double to) { return std::uniform_real_distribution(from, to)(engine_); }

 private:
  /// Also splinters with sharp ends.
  Footprint polygon(const PlanPoint& at) {
    const double turn = any(0, 7), flat = any(0, 1) < 0.3 ? 0.02 : any(0.2, 1);
    const int corners = std::uniform_int_distribution(3, 7)(engine_);
    std::vector<PlanPoint> all;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283 * (i + any(0, 0.6)) / corners;
      const PlanPoint flat_at(4 * std::cos(angle), 4 * flat * std::sin(angle));
      all.push_back(at + PlanPoint(flat_at.x() * std::cos(turn) - flat_at.y() * std::sin(turn),
                                   flat_at.x() * std::sin(turn) + flat_at.y() * std::cos(turn)));
    }
    return fault_of_polygon(all) ? polygon(at) : polygon_footprint({0, 0}, all);
  }

  std::mt19937 engine_;
};

TEST(PairsNear, FindWhatLookingAtAllPairsFinds) {
  std::size_t near = 0, candidates = 0, all = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Blocks blocks(seed);
    const std::vector<Footprint> block = blocks.make();
    const double reach = seed % 4 == 0 ? 0 : blocks.any(0, 1);
    const auto found = pairs_near(block, reach);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    candidates += found.size();
    for (std::size_t a = 0; a < block.size(); ++a) {
      for (std::size_t b = a + 1; b < block.size(); ++b) {
        ++all;
        const auto joint = joint_between(block[a], block[b]);
        if (joint ? joint->width > reach : !overlap(block[a], block[b])) continue;
        ++near;
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), std::pair(a, b))) << seed << ": " << a << ", " << b;
      }
    }
  }
  EXPECT_GT(near, 2000U);
  EXPECT_LT(candidates, all / 2);  // it is worth it
}

TEST(PairsNear, TouchingHousesAreNear) {
  const std::vector<Footprint> row = {{.corner = {0, 0}, .size = {3, 4}},
                                      {.corner = {3, 0}, .size = {3, 4}},
                                      {.corner = {6, 4}, .size = {3, 4}},
                                      {.corner = {20, 0}, .size = {3, 4}}};
  const std::vector<std::pair<std::size_t, std::size_t>> expected = {{0, 1}, {1, 2}};
  EXPECT_EQ(pairs_near(row, 0), expected);
  EXPECT_TRUE(pairs_near({}, 1).empty());
}

}  // namespace
}  // namespace bentur
