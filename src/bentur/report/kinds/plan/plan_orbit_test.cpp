#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bentur/report/kinds/kinds.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

const PlanRun& orbiting() {
  static const PlanRun run = test::plan_run(test::twisting_pair(), 0.002);
  return run;
}

/// A corner is nowhere beyond its neighbour at rest by more than that has moved and been pressed in, and both panels
/// have one scale both ways.
TEST(PlanOrbit, IsToScale) {
  const Figure figure = make_figure(orbiting(), "orbit");
  ASSERT_EQ(figure.panels.size(), 2U);
  const PlacedFigure placed = placed_figure(figure, "");
  for (const PanelPlace& frame : placed.panels) {
    const double across = (frame.x.second - frame.x.first) / frame.width;
    EXPECT_NEAR((frame.y.second - frame.y.first) / frame.height, across, 0.01 * across);
  }
  const std::vector<Curve>& curves = figure.panels[0].curves;
  const auto hardest =
      std::find_if(curves.begin(), curves.end(), [](const Curve& one) { return one.label == "hardest impact"; });
  ASSERT_NE(hardest, curves.end());
  EXPECT_EQ(hardest->x.size(), 1U);
  EXPECT_NEAR(figure.panels[0].rules.front().at, 0.04, 1e-12);
  EXPECT_NEAR(figure.panels[1].rules.front().at, -0.04, 1e-12);
}

/// Of a run that is longer than a few vibrations those around the hardest impact are dark, and the figure says which.
TEST(PlanOrbit, SaysItsTime) {
  const Figure figure = make_figure(orbiting(), "orbit");
  EXPECT_TRUE(figure.part.starts_with("Dark from ")) << figure.part;
  EXPECT_NE(figure.part.find(", around the hardest impact; pale the rest"), std::string::npos) << figure.part;
  for (const Panel& panel : figure.panels) {
    const Curve &rest = panel.curves.front(), &near = panel.curves[2];
    EXPECT_EQ(rest.label, "rest of the run");
    EXPECT_EQ(rest.tone, Tone::pale);
    const auto width = [](const Curve& curve) {
      const auto [least, most] = std::minmax_element(curve.x.begin(), curve.x.end());
      return *most - *least;
    };
    EXPECT_GE(width(rest), width(near) * (1 - 0.01));
    EXPECT_LE(*std::max_element(rest.x.begin(), rest.x.end()), *panel.x.to) << "all of it is within the frame";
  }
  FigureOptions asked;
  asked.from = 1;
  asked.to = 2;
  const Figure part = make_figure(orbiting(), "orbit", asked);
  EXPECT_TRUE(part.part.starts_with("From 1 s to 2 s")) << part.part;
  EXPECT_NE(part.panels.front().curves.front().label, "rest of the run");
}

}  // namespace
}  // namespace bentur
