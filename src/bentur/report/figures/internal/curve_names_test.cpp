#include "bentur/report/figures/internal/curve_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

using Side = PlaceText::Side;

Panel panel_of(std::vector<Curve> curves) {
  return {.x = {.label = "x", .from = 0, .to = 10},
          .y = {.label = "y", .from = 0, .to = 10},
          .height = 5,
          .curves = std::move(curves),
          .names_at_ends = true};
}

std::vector<std::string> in_legend(const Layout& placed) {
  std::vector<std::string> names;
  for (const PlacedPanel& panel : placed.panels) {
    for (const LegendEntry& entry : panel.legend) names.push_back(entry.label);
  }
  return names;
}

TEST(CurveNames, StandBesideTheFrameWhereCurvesEndThereAndNotInTheLegend) {
  Figure figure{.panels = {panel_of(
                    {{.label = "upper", .x = {0, 10}, .y = {0, 8}}, {.label = "lower", .x = {0, 10}, .y = {0, 2}}})}};
  const Layout placed = layout(figure);
  EXPECT_TRUE(in_legend(placed).empty());
  const PlacedPanel& panel = placed.panels.front();
  ASSERT_EQ(panel.names.size(), 2U);
  for (const CurveName& name : panel.names) {
    EXPECT_EQ(name.side, Side::right);
    EXPECT_EQ(name.x, 10);
    EXPECT_EQ(name.up, 0);
    EXPECT_LE(panel.right + text_width(name.label), figure.width);
  }
  figure.panels.front().names_at_ends = false;
  EXPECT_EQ(in_legend(layout(figure)), (std::vector<std::string>{"upper", "lower"}));
}

/// Of curves that end close to one another the names are moved as little as can be, up and down alike.
TEST(CurveNames, CloseEndsHaveTheirNamesAroundThem) {
  const Layout placed = layout({.panels = {panel_of({{.label = "mean", .x = {0, 10}, .y = {0, 5.4}},
                                                     {.label = "target", .x = {0, 10}, .y = {0, 5.0}},
                                                     {.label = "0.9", .x = {0, 10}, .y = {0, 4.6}}})}});
  const std::vector<CurveName>& names = placed.panels.front().names;
  ASSERT_EQ(names.size(), 3U);
  EXPECT_NEAR(names[1].up, 0, 1e-12);
  EXPECT_GT(names[0].up, 0.05);
  EXPECT_NEAR(names[0].up + names[2].up, 0, 1e-12);
}

/// Of curves that end side by side within the frame the names stand above the ends, moved where they would meet.
TEST(CurveNames, AboveNeighbouringEndsGiveWayToOneAnother) {
  Figure figure{.panels = {panel_of({{.label = "first", .x = {0, 5}, .y = {0, 8}},
                                     {.label = "second", .x = {0, 5.9}, .y = {0, 8}},
                                     {.x = {6.3, 6.3}, .y = {0, 8}}})}};
  const Layout placed = layout(figure);
  EXPECT_TRUE(in_legend(placed).empty());
  const std::vector<CurveName>& names = placed.panels.front().names;
  ASSERT_EQ(names.size(), 2U);
  const auto across = [&](const CurveName& name) {
    return along(placed.panels.front().x, name.x) * (placed.panels.front().right - placed.panels.front().left);
  };
  EXPECT_EQ(names[0].side, Side::above);
  EXPECT_EQ(names[0].x, 5);
  EXPECT_EQ(names[1].side, Side::above);
  EXPECT_GT(names[1].x, 5.9);
  EXPECT_GT(across(names[1]) - text_width("second") / 2, across(names[0]) + text_width("first") / 2);
}

TEST(CurveNames, OfCurvesThatEndNearOneAnotherAreSpreadWithinTheFrame) {
  Panel panel = panel_of({});
  for (const double end : {0.01, 0.09, 0.17, 0.25}) {
    panel.curves.push_back({.label = number(end), .x = {0, 10}, .y = {5, end}});
  }
  Figure figure{.panels = {panel}};
  const Layout layout_ = layout(figure);
  const PlacedPanel& placed = layout_.panels.front();
  std::vector<double> heights;
  for (const CurveName& name : placed.names) {
    heights.push_back(along(placed.y, name.y) * (placed.top - placed.bottom) + name.up);
  }
  ASSERT_EQ(heights.size(), 4U);
  std::sort(heights.begin(), heights.end());
  EXPECT_GT(heights.front(), 0);
  EXPECT_LT(heights.back(), 5);
  for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GE(heights[i] - heights[i - 1], 0.3);
}

/// Of curves that end as one a name there tells nothing: they have theirs where they are furthest apart.
TEST(CurveNames, OfCurvesThatMeetStandWhereTheyPart) {
  const Panel panel = panel_of({{.label = "upper", .x = {0, 2, 4, 6, 8, 10}, .y = {0, 4, 8, 4, 0, 0}},
                                {.label = "lower", .x = {0, 2, 4, 6, 8, 10}, .y = {0, 1, 2, 1, 0, 0}},
                                {.label = "apart", .x = {0, 10}, .y = {9, 9}}});
  const Layout placed = layout({.panels = {panel}});
  EXPECT_TRUE(in_legend(placed).empty());
  const std::vector<CurveName>& names = placed.panels.front().names;
  ASSERT_EQ(names.size(), 3U);
  for (const CurveName& name : names) {
    EXPECT_EQ(name.x, name.label == "apart" ? 10 : name.label == "upper" ? 4 : name.x);
    EXPECT_LT(name.x, name.label == "lower" ? 8 : 11);
  }
}

TEST(CurveNames, TooManyForTheFrameStandInTheLegend) {
  Panel panel = panel_of({});
  for (int i = 0; i < 30; ++i) {
    panel.curves.push_back({.label = "curve " + std::to_string(i), .x = {0, 10}, .y = {0, i / 3.0}});
  }
  const Layout placed = layout({.panels = {panel}});
  EXPECT_TRUE(placed.panels.front().names.empty());
  EXPECT_EQ(in_legend(placed).size(), 30U);
}

TEST(CurveNames, OfSeveralCurvesAndOfAreasStandInTheLegend) {
  const Layout placed = layout(
      {.panels = {panel_of({{.label = "each record", .x = {0, 5}, .y = {0, 8}, .of_several = true},
                            {.label = "bounds", .x = {0, 5}, .y = {0, 2}, .top = {1, 3}},
                            {.label = "observed", .x = {3}, .y = {2}, .line = Line::none, .mark = Mark::disc}})}});
  EXPECT_TRUE(placed.panels.front().names.empty());
  EXPECT_EQ(in_legend(placed), (std::vector<std::string>{"each record", "bounds", "observed"}));
}

/// A name within a frame [cm]: left, right, bottom, top.
struct Rectangle {
  double left, right, bottom, top;
};
Rectangle rectangle_of(const CurveName& name, const PlacedPanel& placed) {
  const double x = along(placed.x, name.x) * (placed.right - placed.left);
  const double y = along(placed.y, name.y) * placed.panel->height;
  const double width = text_width(name.label);
  constexpr double high = 0.2, beside = 0.13, above = 0.29;  // of letters; of their middle
  const double middle = name.side == Side::above ? y + above : name.side == Side::below ? y - above : y;
  const double left = name.side == Side::right  ? x + beside
                      : name.side == Side::left ? x - beside - width
                                                : x - width / 2;
  return {left, left + width, middle - high / 2, middle + high / 2};
}

TEST(CurveNames, WithinTheFrameLieOnNothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0.5, 9);
  std::size_t found = 0, left_over = 0;
  for (int run = 0; run < 200; ++run) {
    Panel panel = panel_of({});
    for (int c = 0; c < 5; ++c) {
      Curve curve{.label = "House " + std::to_string(c)};
      for (int i = 0; i < 6; ++i) {
        curve.x.push_back(at(random));
        curve.y.push_back(1.2 * i);
      }
      panel.curves.push_back(std::move(curve));
    }
    const Layout layout_ = layout({.panels = {panel}});
    const PlacedPanel& placed = layout_.panels.front();
    const std::vector<CurveName> names =
        names_at_ends(panel, placed.x, placed.y, placed.right - placed.left, panel.height);
    std::vector<Rectangle> boxes;
    for (const CurveName& name : names) {
      const Rectangle box = rectangle_of(name, placed);
      EXPECT_GE(box.left, 0);
      EXPECT_LE(box.right, placed.right - placed.left);
      for (const Rectangle& other : boxes) {
        constexpr double between = 0.19;  // on one line they do not read as one name
        EXPECT_FALSE(box.left < other.right + between && other.left < box.right + between && box.bottom < other.top &&
                     other.bottom < box.top);
      }
      boxes.push_back(box);
      for (const Curve& curve : panel.curves) {
        for (std::size_t i = 1; i < curve.x.size(); ++i) {
          for (int part = 0; part <= 100; ++part) {  // points of the line
            const double t = part / 100.0;
            const double x = along(placed.x, curve.x[i - 1] + t * (curve.x[i] - curve.x[i - 1]));
            const double y = along(placed.y, curve.y[i - 1] + t * (curve.y[i] - curve.y[i - 1]));
            const double px = x * (placed.right - placed.left), py = y * placed.panel->height;
            EXPECT_FALSE(px > box.left && px < box.right && py > box.bottom && py < box.top) << name.label;
          }
        }
      }
    }
    found += names.size();
    left_over += panel.curves.size() - names.size();
    // One way of naming in a figure: all at ends, or all in the legend.
    EXPECT_EQ(lacks_names(panel, names), names.size() < panel.curves.size());
    EXPECT_EQ(placed.names.size(), lacks_names(panel, names) ? 0U : panel.curves.size());
    EXPECT_EQ(placed.names.size() + in_legend(layout_).size(), panel.curves.size());
  }
  EXPECT_GT(found, 400U);
  EXPECT_GT(left_over, 10U);
}

}  // namespace
}  // namespace bentur
