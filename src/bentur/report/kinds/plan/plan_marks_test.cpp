// Marks and numbers of pictures of buildings in plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "bentur/report/kinds/kinds.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// Of both buildings, of each component.
TEST(PlanMarks, PeaksOfBothBuildingsAreWritten) {
  const PlanRun run = test::plan_run(test::twisting_pair(), 0.002);
  std::size_t texts = 0, negative = 0;
  for (const Panel& panel : make_figure(run, "displacement").panels) {
    for (const PlaceText& one : panel.texts) {
      ++texts;
      negative += one.text.starts_with("−") ? 1 : 0;
      EXPECT_EQ(one.text.starts_with("−"), one.y < 0);
      for (const PlaceText& other : panel.texts) {  // not on one another
        const double apart = std::abs(one.x - other.x) / (*panel.x.to - *panel.x.from);
        EXPECT_TRUE(&one == &other || apart > 0.2 || one.y * other.y < 0);
      }
    }
  }
  EXPECT_EQ(texts, 6U);
  EXPECT_GE(negative, 1U);
}

}  // namespace
}  // namespace bentur
