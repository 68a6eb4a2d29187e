#include "bentur/study/plan/sweep_plan.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Method = Sampling::Method;

TEST(SweepPlan, GridCountsWithTheLastAxisFastest) {
  const SweepPlan plan({{.levels = 2}, {.levels = 3}}, {});
  EXPECT_TRUE(plan.is_grid());
  ASSERT_EQ(plan.runs(), 6U);
  std::vector<std::vector<std::size_t>> seen;
  for (std::size_t run = 0; run < 6; ++run) seen.push_back({plan.level(run, 0), plan.level(run, 1)});
  EXPECT_EQ(seen, (std::vector<std::vector<std::size_t>>{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}}));
}

/// Every run once; the group changes as often as there are groups.
void expect_groups(const SweepPlan& plan, std::size_t groups) {
  std::set<std::size_t> runs;
  std::set<std::uint64_t> seen;
  std::uint64_t last = 0;
  std::size_t changes = 0;
  for (std::size_t position = 0; position < plan.runs(); ++position) {
    const std::size_t run = plan.run_at(position);
    EXPECT_LT(run, plan.runs());
    runs.insert(run);
    const std::uint64_t group = plan.group(run);
    seen.insert(group);
    if (position == 0 || group != last) ++changes;
    last = group;
  }
  EXPECT_EQ(runs.size(), plan.runs());
  EXPECT_EQ(seen.size(), groups);
  EXPECT_EQ(changes, groups);
}

TEST(SweepPlan, RunsThatShareWorkAreDoneOneAfterTheOther) {
  expect_groups(SweepPlan({{3, true}, {4, false}, {5, true}, {2, false}}, {}), 8);
  expect_groups(SweepPlan({{3, false}, {4, false}}, {}), 12);
  expect_groups(SweepPlan({{7, true}}, {}), 1);
  EXPECT_FALSE(SweepPlan({{3, false}}, {}).has_groups());
  EXPECT_TRUE(SweepPlan({{3, false}, {2, true}}, {}).has_groups());
  const SweepPlan samples({{3, false}, {0, true}}, {Method::latin_hypercube, 90, 1});
  EXPECT_TRUE(samples.has_groups());
  expect_groups(samples, 3);
  const SweepPlan all_differ({{0, false}, {0, true}}, {Method::random, 20, 1});
  EXPECT_FALSE(all_differ.has_groups());
  expect_groups(all_differ, 20);
}

TEST(SweepPlan, SamplesChooseEachValueEquallyOften) {
  const SweepPlan plan({{.levels = 5}, {.levels = 0}}, {Method::latin_hypercube, 100, 1});
  std::vector<int> counts(5, 0);
  for (std::size_t run = 0; run < 100; ++run) ++counts[plan.level(run, 0)];
  EXPECT_EQ(counts, std::vector<int>(5, 20));
}

TEST(SweepPlan, RefusesWhatIsNoPlan) {
  EXPECT_THROW(SweepPlan({}, {}), InvalidParameter);
  EXPECT_THROW(SweepPlan({{.levels = 0}}, {}), InvalidParameter);
  EXPECT_THROW(SweepPlan({{.levels = 2}}, {Method::random, 0, 1}), InvalidParameter);
  EXPECT_THROW(SweepPlan({{.levels = 100000}, {.levels = 100000}}, {}), InvalidParameter);
}

}  // namespace
}  // namespace bentur
