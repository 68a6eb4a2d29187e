// Marks and numbers of pictures of buildings in plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "bentur/model/plan/plan_places.h"
#include "bentur/report/kinds/kinds.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

std::size_t marks(const Panel& panel, const std::string& label) {
  std::size_t count = 0;
  for (const Curve& curve : panel.curves) count += curve.label == label ? curve.x.size() : 0;
  return count;
}

/// Places that touch at another level than the one drawn alone have an open mark at either edge.
TEST(PlanMarks, PlacesThatTouchAtAnotherLevelAreMarked) {
  PlanRun run = test::plan_run(test::twisting_pair(), 0.002);
  const auto scene = [&] { return make_figure(run, "scene").panels.front(); };
  const PlanGap& gap = run.problem.gaps.front();
  std::size_t below = 0;
  for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
    const double elevation = gap.contacts[i].elevation, along = gap.contacts[i].along;
    if (elevation == 6.7) continue;
    ++below;
    PointSummary& point = run.response.points[i];
    point.impacts = 0;
    EXPECT_EQ(marks(scene(), "touched at another level"), 0U);
    point.impacts = 1;
    const bool strikes_above = along == gap.stretch.to;  // at y = 18 m
    EXPECT_EQ(marks(scene(), "touched at another level"), strikes_above ? 0U : 2U) << along;
    EXPECT_EQ(marks(scene(), "contact point"), strikes_above ? 2U : 0U) << along;
    for (const Curve& curve : scene().curves) {
      if (curve.label == "touched at another level") {
        EXPECT_EQ(curve.mark, Mark::circle);
      }
    }
    point.impacts = 0;
  }
  EXPECT_EQ(below, 2U);
}

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
