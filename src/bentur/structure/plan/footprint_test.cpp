#include "bentur/structure/plan/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bentur/structure/plan/footprint_parts.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {
namespace {

TEST(Footprint, APolygonHasTheCentreAndRadiusOfItsArea) {
  // A right triangle with legs 6 and 9: centre at a third, polar inertia about it area (a² + b²)/18.
  const Footprint triangle = polygon_footprint({10, 20}, {{0, 0}, {0, 9}, {6, 0}});  // clockwise
  EXPECT_TRUE(triangle.middle().isApprox(PlanPoint(2, 3), 1e-15));
  EXPECT_NEAR(triangle.radius2(), (36 + 81) / 18.0, 1e-14);
  EXPECT_EQ(triangle.corners()[0], PlanPoint(16, 20));  // the other way round
  EXPECT_EQ(triangle.size, PlanPoint(6, 9));
  EXPECT_TRUE(triangle.contains({3, 4.5}));
  EXPECT_FALSE(triangle.contains({3.01, 4.5}));
  // A rectangle far from the origin with a corner on a straight edge.
  const Footprint polygon = polygon_footprint({0, 0}, {{100, 50}, {106, 50}, {112, 50}, {112, 68}, {100, 68}});
  const Footprint rectangle{.corner = {100, 50}, .size = {12, 18}};
  EXPECT_EQ(polygon.corners().size(), 4U);
  EXPECT_EQ(polygon.lower(), rectangle.lower());
  EXPECT_EQ(polygon.far_corner(), rectangle.far_corner());
  EXPECT_NEAR(polygon.radius2() / rectangle.radius2(), 1, 1e-12);
  EXPECT_TRUE((polygon.corner + polygon.middle()).isApprox(rectangle.corner + rectangle.middle(), 1e-14));
}

// A square of 20 with a court of 10 by 5, and an L: by hand from squares.
TEST(Footprint, CourtsAndNotchesAreNoPartOfTheArea) {
  const Footprint square =
      polygon_footprint({100, 0}, {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{{5, 5}, {15, 5}, {15, 10}, {5, 10}}});
  EXPECT_NEAR(square.area(), 350, 1e-12);
  EXPECT_TRUE(square.middle().isApprox(PlanPoint(10, (4000 - 50 * 7.5) / 350), 1e-14));
  const double y = square.middle().y();
  const double second = 400 * (800 / 12.0 + (10 - y) * (10 - y)) - 50 * (125 / 12.0 + (7.5 - y) * (7.5 - y));
  EXPECT_NEAR(square.radius2(), second / 350, 1e-10);
  EXPECT_FALSE(square.is_convex());
  EXPECT_TRUE(square.contains({10, 7.5}));  // of the hull
  EXPECT_EQ(fault_of_court(square, 0), std::nullopt);
  const Footprint l_shape = polygon_footprint({0, 0}, {{0, 0}, {20, 0}, {20, 5}, {5, 5}, {5, 20}, {0, 20}});
  EXPECT_NEAR(l_shape.area(), 175, 1e-12);
  EXPECT_NEAR(l_shape.middle().x(), (100 * 10 + 75 * 2.5) / 175, 1e-13);
  EXPECT_FALSE(l_shape.is_convex());
  const auto fault = [](std::vector<std::vector<PlanPoint>> courts) {
    const std::size_t last = courts.size() - 1;
    return fault_of_court(polygon_footprint({0, 0}, {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, std::move(courts)), last)
        .value_or("none");
  };
  const std::vector<PlanPoint> court = {{5, 5}, {15, 5}, {15, 10}, {5, 10}};
  EXPECT_EQ(fault({{{0, 5}, {5, 5}, {5, 10}}}), "must lie in the outline");  // it touches
  EXPECT_EQ(fault({{{25, 5}, {30, 5}, {30, 10}}}), "must lie in the outline");
  EXPECT_EQ(fault({court, {{6, 6}, {7, 6}, {7, 7}}}), "must not meet court 1");
  EXPECT_EQ(fault({court, {{15, 7}, {17, 7}, {17, 9}}}), "must not meet court 1");
  EXPECT_EQ(fault({court, {{6, 16}, {7, 16}, {7, 17}}}), "none");
}

// Two squares of 4 and of 2, by hand from both.
TEST(Footprint, PartsStandBesideItAndCount) {
  const std::vector<PlanPoint> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Footprint both =
      with_parts(polygon_footprint({100, 50}, square, {}), {{{-4, 6}, {-6, 6}, {-6, 8}, {-4, 8}}});  // clockwise
  EXPECT_FALSE(both.is_convex());
  EXPECT_EQ(both.lower(), PlanPoint(94, 50));
  EXPECT_EQ(both.far_corner(), PlanPoint(104, 58));
  EXPECT_DOUBLE_EQ(both.area(), 20);
  const PlanPoint middle = (16 * PlanPoint(2, 2) + 4 * PlanPoint(-5, 7)) / 20;
  EXPECT_LE((both.middle() - middle).norm(), 1e-14 * middle.norm());
  const double moment = 16 * (32 / 12.0 + (middle - PlanPoint(2, 2)).squaredNorm()) +
                        4 * (8 / 12.0 + (middle - PlanPoint(-5, 7)).squaredNorm());
  EXPECT_NEAR(both.radius2(), moment / 20, 1e-13 * moment);
  EXPECT_TRUE(both.contains({-2, 5}));  // between both
  EXPECT_EQ(fault_of_part(both, 0), std::nullopt);
}

TEST(Footprint, PartsThatStandInOneAnotherAreNone) {
  const auto fault = [](std::vector<std::vector<PlanPoint>> parts) {
    Footprint square = polygon_footprint({0, 0}, {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{{5, 5}, {15, 5}, {15, 15}}});
    square = with_parts(std::move(square), std::move(parts));
    EXPECT_EQ(fault_of_court(square, 0), std::nullopt);
    return fault_of_part(square, square.rings.size() - 1).value_or("none");
  };
  const std::string beside = "must stand beside the polygon and all other parts";
  EXPECT_EQ(fault({{{20, 5}, {25, 5}, {25, 10}}}), beside);                               // it touches
  EXPECT_EQ(fault({{{1, 1}, {2, 1}, {2, 2}}}), beside);                                   // within
  EXPECT_EQ(fault({{{-5, -5}, {30, -5}, {30, 30}, {-5, 30}}}), beside);                   // round it
  EXPECT_EQ(fault({{{25, 0}, {35, 0}, {35, 10}}, {{30, 1}, {31, 1}, {31, 2}}}), beside);  // within another part
  EXPECT_EQ(fault({{{25, 0}, {35, 0}, {35, 10}}, {{36, 1}, {37, 1}, {37, 2}}}), "none");
  EXPECT_EQ(fault({{{12, 6}, {14, 6}, {14, 8}}}), "none");  // in the court, joined by a bridge
}

TEST(Footprint, WhatIsNoConvexPolygon) {
  const auto fault = [](const std::vector<PlanPoint>& corners) { return fault_of_polygon(corners).value_or("none"); };
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {4, 3}}), "none");
  EXPECT_EQ(fault({{0, 0}, {4, 3}, {4, 0}}), "none");
  EXPECT_EQ(fault({{0, 0}, {2, 0}, {4, 0}, {4, 3}}), "none");
  EXPECT_EQ(fault({{0, 0}, {4, 0}}), "must have three corners or more, not 2");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {4, 3}, {0, 0}}), "must have different corners: 4 and 1 are one");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {8, 0}}), "must have an area");
  EXPECT_EQ(fault({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), "must go round once: its edges behind corners 1 and 3 cross");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), "must be convex: it turns inwards at corner 3, (1, 1)");
  std::vector<PlanPoint> star;
  for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(i * 2.513274), std::sin(i * 2.513274));
  EXPECT_EQ(fault(star).substr(0, 18), "must go round once");
}

TEST(Footprint, OutlinesNeedNotBeConvex) {
  const auto fault = [](const std::vector<PlanPoint>& corners) { return fault_of_outline(corners).value_or("none"); };
  const std::vector<PlanPoint> l_shape = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(fault(l_shape), "none");
  EXPECT_EQ(fault({l_shape.rbegin(), l_shape.rend()}), "none");
  EXPECT_EQ(fault({{0, 0}, {4, 4}, {4, 0}, {0, 3}}), "must go round once: its edges behind corners 1 and 3 meet");
  EXPECT_EQ(fault({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), "must go round once: its edges behind corners 1 and 3 meet");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {8, 0}}), "must have an area");
  // Two triangles that have a corner in common, the second time in the middle of an edge.
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}),
            "must go round once: its edges behind corners 2 and 5 meet");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
            "must go round once: its edges behind corners 1 and 3 meet");
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {4, 0}, {0, 4}}), "must have different corners: 2 and 3 are one");
}

TEST(Footprint, AHullIsTheLeastConvexPolygonAround) {
  const std::vector<PlanPoint> expected = {{0, 0}, {4, 0}, {4, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(convex_hull({{1, 1}, {4, 1}, {4, 0}, {2, 0}, {0, 0}, {0, 3}, {1, 3}}), expected);
  EXPECT_EQ(convex_hull(expected), expected);
  EXPECT_EQ(convex_hull({{0, 0}, {0, 3}, {1, 3}, {0, 0}, {4, 1}, {4, 0}}), expected);
}

TEST(Footprint, AFloorHasItsCentreOfMassAndInertiaByDefault) {
  Plan plan{.footprint = polygon_footprint({0, 0}, {{0, 0}, {6, 0}, {0, 9}}), .storey_heights = {3}, .masses = {40}};
  plan.rigidity = PlanRigidity{.centres = {{2, 3}}, .x = {1e3}, .y = {1e3}, .torsion = {1e4}};
  const PlanModel model = plan_model(plan);
  EXPECT_TRUE(model.centres[0].isApprox(PlanPoint(2, 3), 1e-15));
  EXPECT_NEAR(model.mass(2, 2), 40 * (36 + 81) / 18.0, 1e-12);
  plan.centres_of_mass = {{5, 5}};
  EXPECT_THROW(static_cast<void>(plan_model(plan)), std::exception);
}

}  // namespace
}  // namespace bentur
