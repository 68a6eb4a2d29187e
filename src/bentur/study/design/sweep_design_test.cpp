#include "bentur/study/design/sweep_design.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Method = Sampling::Method;

TEST(SweepDesign, GridCountsWithTheLastAxisFastest) {
  const SweepDesign design({{.levels = 2}, {.levels = 3}}, {});
  EXPECT_TRUE(design.is_grid());
  ASSERT_EQ(design.runs(), 6U);
  std::vector<std::vector<std::size_t>> seen;
  for (std::size_t run = 0; run < 6; ++run) seen.push_back({design.level(run, 0), design.level(run, 1)});
  EXPECT_EQ(seen, (std::vector<std::vector<std::size_t>>{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}}));
}

/// Every run once; the group changes as often as there are groups.
void expect_groups(const SweepDesign& design, std::size_t groups) {
  std::set<std::size_t> runs;
  std::set<std::uint64_t> seen;
  std::uint64_t last = 0;
  std::size_t changes = 0;
  for (std::size_t position = 0; position < design.runs(); ++position) {
    const std::size_t run = design.run_at(position);
    EXPECT_LT(run, design.runs());
    runs.insert(run);
    const std::uint64_t group = design.group(run);
    seen.insert(group);
    if (position == 0 || group != last) ++changes;
    last = group;
  }
  EXPECT_EQ(runs.size(), design.runs());
  EXPECT_EQ(seen.size(), groups);
  EXPECT_EQ(changes, groups);
}

TEST(SweepDesign, RunsThatShareWorkAreDoneOneAfterTheOther) {
  expect_groups(SweepDesign({{3, true}, {4, false}, {5, true}, {2, false}}, {}), 8);
  expect_groups(SweepDesign({{3, false}, {4, false}}, {}), 12);
  expect_groups(SweepDesign({{7, true}}, {}), 1);
  EXPECT_FALSE(SweepDesign({{3, false}}, {}).has_groups());
  EXPECT_TRUE(SweepDesign({{3, false}, {2, true}}, {}).has_groups());
  const SweepDesign samples({{3, false}, {0, true}}, {Method::latin_hypercube, 90, 1});
  EXPECT_TRUE(samples.has_groups());
  expect_groups(samples, 3);
  const SweepDesign all_differ({{0, false}, {0, true}}, {Method::random, 20, 1});
  EXPECT_FALSE(all_differ.has_groups());
  expect_groups(all_differ, 20);
}

TEST(SweepDesign, SamplesChooseEachValueEquallyOften) {
  const SweepDesign design({{.levels = 5}, {.levels = 0}}, {Method::latin_hypercube, 100, 1});
  std::vector<int> counts(5, 0);
  for (std::size_t run = 0; run < 100; ++run) ++counts[design.level(run, 0)];
  EXPECT_EQ(counts, std::vector<int>(5, 20));
}

TEST(SweepDesign, RefusesWhatIsNoDesign) {
  EXPECT_THROW(SweepDesign({}, {}), InvalidParameter);
  EXPECT_THROW(SweepDesign({{.levels = 0}}, {}), InvalidParameter);
  EXPECT_THROW(SweepDesign({{.levels = 2}}, {Method::random, 0, 1}), InvalidParameter);
  EXPECT_THROW(SweepDesign({{.levels = 100000}, {.levels = 100000}}, {}), InvalidParameter);
}

}  // namespace
}  // namespace bentur
