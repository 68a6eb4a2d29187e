// Outlines that turn inwards: their parts, and what touches where. Geometry is the judge, by Boost's polygons.
#include "bentur/pounding/plan/outline/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "bentur/structure/plan/footprint_parts.h"
#include "tests/support/outlines/block.h"
#include "tests/support/random_numbers.h"

namespace bentur::outline_parts {
namespace {

using Eigen::Index;
using test::box, test::drawn_block, test::l_shape, test::outlines_problem, test::Shapes, test::told;
using At = boost::geometry::model::d2::point_xy<double>;
using Polygon = boost::geometry::model::polygon<At, false>;
using Line = boost::geometry::model::linestring<At>;

Polygon polygon_of(const std::vector<std::vector<PlanPoint>>& rings) {
  Polygon polygon;
  for (const PlanPoint& at : rings.front()) polygon.outer().emplace_back(at.x(), at.y());
  for (std::size_t i = 1; i < rings.size(); ++i) {
    auto& ring = polygon.inners().emplace_back();
    for (const PlanPoint& at : rings[i]) ring.emplace_back(at.x(), at.y());
  }
  boost::geometry::correct(polygon);
  return polygon;
}

/// How deep a place is in an outline [length]: its distance from the nearest edge; 0 outside.
double depth_in(const std::vector<std::vector<PlanPoint>>& rings, const Polygon& polygon, const PlanPoint& at) {
  const At point(at.x(), at.y());
  if (!boost::geometry::within(point, polygon)) return 0;
  double least = 1e9;
  for (const auto& ring : rings) {
    Line line;
    for (const PlanPoint& corner : ring) line.emplace_back(corner.x(), corner.y());
    line.push_back(line.front());
    least = std::min(least, boost::geometry::distance(point, line));
  }
  return least;
}

void expect_parts(const Footprint& outline, Shapes by) {
  const std::vector<OutlinePart> parts = parts_of(outline);
  const auto rings = outline.all_rings();
  const Polygon whole = polygon_of(rings);
  ASSERT_TRUE(boost::geometry::is_valid(whole));
  std::size_t own = 0, edges = 0;
  for (const auto& ring : rings) edges += ring.size();
  for (const OutlinePart& part : parts) {
    EXPECT_FALSE(fault_of_polygon(part.footprint.polygon)) << *fault_of_polygon(part.footprint.polygon);
    for (int i = 0; i < 40; ++i) {  // not by Boost's difference(), which has a court too much where one touches a part
      PlanPoint at = PlanPoint::Zero();
      double sum = 0;
      for (const PlanPoint& corner : part.footprint.corners()) {
        const double weight = by.any(0.001, 1);
        at += weight * corner;
        sum += weight;
      }
      EXPECT_TRUE(boost::geometry::within(At(at.x() / sum, at.y() / sum), whole));
    }
    for (const char one : part.own) own += one != 0 ? 1 : 0;
  }
  EXPECT_EQ(own, edges);
}

TEST(OutlineParts, LieWithinTheOutlineAndHaveEachEdgeOnce) {
  expect_parts(l_shape({3, 4}, 20, 15, 6, 5), Shapes(1));
  expect_parts(told({{0, 0}, {20, 0}, {20, 15}, {0, 15}}, {{{5, 5}, {15, 5}, {15, 10}, {5, 10}}}), Shapes(2));
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Shapes shapes(seed);
    expect_parts(shapes.star(), shapes);
  }
}

// What is left of an outline touches the other one and does not overlap it, and has the rest of its area.
TEST(OutlineParts, WhatIsCutBackTouches) {
  long cut = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Shapes by(seed);
    const Footprint kept = by.turned(l_shape({0, 0}, by.any(14, 20), by.any(12, 18), 5, 6), by.any(-0.2, 0.2));
    Footprint other = by.turned(box({6 - by.any(-0.05, 0.08), 5 - by.any(-0.05, 0.08)}, 6, 5), by.any(-0.2, 0.2));
    if (!overlap(kept, other)) continue;
    const double common = common_area(kept, other), area = other.area();
    const auto rest = cut_back(other, kept);
    if (!rest) continue;
    ++cut;
    EXPECT_FALSE(overlap(*rest, kept)) << overlap_depth(*rest, kept);
    EXPECT_LE(rest->area(), area - common + 1e-5 * area);
    EXPECT_GE(rest->area(), 0.5 * (area - common));  // the largest part
  }
  EXPECT_GT(cut, 50);
}

TEST(OutlineParts, AConvexOutlineIsOnePart) {
  const std::vector<OutlinePart> parts = parts_of(box({1, 2}, 3, 4));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].own, std::vector<char>(4, 1));
  EXPECT_EQ(parts_of({.corner = {1, 2}, .size = {3, 4}}).size(), 1U);
}

/// First and last seed; of BENTUR_RANDOM_OUTLINES "FROM:TO" where that is set.
std::pair<unsigned, unsigned> seeds() { return test::seeds_of("BENTUR_RANDOM_OUTLINES", {1, 50}, {1, 6}); }

/// All rings of a floor where it is, with all second-order parts of its rotation left out as in (P-1).
std::vector<std::vector<PlanPoint>> displaced(const PlanModel& model, const PlanPoint& by, double theta) {
  std::vector<std::vector<PlanPoint>> rings = model.footprint.all_rings();
  const PlanPoint centre = model.footprint.corner + model.centres[0];
  for (auto& ring : rings) {
    for (PlanPoint& at : ring) {
      const PlanPoint arm = at - centre;
      at += by + theta * PlanPoint(-arm.y(), arm.x());
    }
  }
  return rings;
}

double deepest(const std::vector<std::vector<PlanPoint>>& one, const std::vector<std::vector<PlanPoint>>& other) {
  const Polygon of_one = polygon_of(one), of_other = polygon_of(other);
  double depth = 0;
  for (const auto& ring : one) {
    for (const PlanPoint& at : ring) depth = std::max(depth, depth_in(other, of_other, at));
  }
  for (const auto& ring : other) {
    for (const PlanPoint& at : ring) depth = std::max(depth, depth_in(one, of_one, at));
  }
  return depth;
}

// No corner is deeper in another outline than a contact tells, and no force acts where outlines are apart, but for what
// products of rotations and displacements make, and for rotation times d where corners are merged.
TEST(OutlineParts, GeometryIsTheJudgeOfRandomBlocks) {
  const auto [first, last] = seeds();
  long impacts = 0, slips = 0, deep = 0, of_pairs = 0, seams = 0;
  for (unsigned seed = first; seed <= last; ++seed) {
    SCOPED_TRACE("BENTUR_RANDOM_OUTLINES=" + std::to_string(seed) + ":" + std::to_string(seed));
    const PlanProblem problem = outlines_problem(drawn_block(seed));
    const PlanResponse response = solve(problem, ExactSolver{}, {.output_step = 0.004, .energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    EXPECT_TRUE(response.discrepancies.empty());
    EXPECT_LE(response.energy->relative_residual(), 1e-9);
    impacts += std::ssize(response.impacts);
    for (const Impact& impact : response.impacts) slips += impact.slipped ? 1 : 0;
    Index point = 0;
    for (const PlanGap& gap : problem.gaps) {
      seams += std::ssize(gap.seams);
      const PlanModel &left = problem.buildings[gap.left].model, &right = problem.buildings[gap.right].model;
      double theta = 0, moved = 0;
      for (const Index b : {gap.left, gap.right}) {
        theta += response.buildings[b].rotation(0);
        moved += response.buildings[b].x(0) + response.buildings[b].y(0);
      }
      const double size = std::max(left.footprint.size.maxCoeff(), right.footprint.size.maxCoeff());
      const double left_out = theta * moved + theta * theta * size + 1e-9;
      const double merged = 0.25 * gap.stretch.shorter * theta;
      for (std::size_t t = 0; t < response.histories.time.size(); ++t) {
        const auto at = [&](Index b, const PlanModel& model) {
          const auto column = static_cast<Index>(t);
          return displaced(model, {response.histories.x[b](0, column), response.histories.y[b](0, column)},
                           response.histories.rotation[b](0, column));
        };
        double said = 0;
        bool pushes = false;
        for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
          const Index row = point + static_cast<Index>(i);
          if (!(response.histories.force(row, static_cast<Index>(t)) > 0)) continue;
          pushes = true;
          said = std::max(said, -response.histories.opening(row, static_cast<Index>(t)));
          of_pairs += gap.contacts[i].pair > 0 ? 1 : 0;
        }
        const auto one = at(gap.left, left), other = at(gap.right, right);
        const double depth = deepest(one, other);
        deep += depth > left_out ? 1 : 0;
        if (pushes) {
          ASSERT_LE(boost::geometry::distance(polygon_of(one), polygon_of(other)), left_out)
              << gap_name(problem, gap) << " at " << response.histories.time[t];
        }
        ASSERT_LE(depth, said + left_out + merged) << gap_name(problem, gap) << " at " << response.histories.time[t];
      }
      point += std::ssize(gap.contacts);
    }
  }
  std::printf("%u blocks, %ld impacts, %ld slipped, %ld samples are deep, %ld points of other pairs push, %ld seams\n",
              last - first + 1, impacts, slips, deep, of_pairs, seams);
  EXPECT_GT(impacts, 10 * static_cast<long>(last - first));
  EXPECT_GT(deep, 0);
  EXPECT_GT(of_pairs, 0);
  EXPECT_GT(seams, 0);
}

/// A house between two wings, of which nothing but the outline is what they are joined by.
PlanResponse between_wings(const Footprint& wings) {
  Plan plan{
      .footprint = wings, .storey_heights = {3}, .masses = {300}, .centres_of_mass = {{9, 12}}, .inertias = {3e4}};
  plan.rigidity = PlanRigidity{.centres = {{8, 15}}, .x = {2e4}, .y = {3e4}, .torsion = {2e6}};
  Plan house{.footprint = {.corner = {5.01, 2}, .size = {7.97, 7}}, .storey_heights = {3}, .masses = {100}};
  house.rigidity = PlanRigidity{.centres = {{4, 3}}, .x = {3e4}, .y = {2e4}, .torsion = {3e5}};
  PlanProblem problem;
  problem.buildings = {make_plan_building("wings", plan_model(plan), ModalDamping{{0.03}}),
                       make_plan_building("house", plan_model(house), ModalDamping{{0.05}})};
  problem.gaps = {test::gap_between(problem, 0, 1, nullptr, 4e5, 0.2)};
  problem.motions = {HarmonicMotion{.period = 0.6, .displacement_amplitude = 0.02},
                     HarmonicMotion{.period = 0.45, .displacement_amplitude = 0.01}};
  problem.duration = 5;
  PlanResponse response = solve(problem, ExactSolver{}, {.energy_audit = true});
  EXPECT_EQ(response.status, Status::done) << response.message;
  EXPECT_LE(response.energy->relative_residual(), 1e-12);
  return response;
}

// Two wings are a U whose bottom is far away: all is alike to the round-off.
TEST(OutlineParts, PartsThatStandApartMoveAsOne) {
  const PlanResponse apart =
      between_wings(with_parts(told({{0, 0}, {5, 0}, {5, 35}, {0, 35}}), {{{13, 0}, {18, 0}, {18, 35}, {13, 35}}}));
  const PlanResponse whole =
      between_wings(told({{0, 0}, {5, 0}, {5, 30}, {13, 30}, {13, 0}, {18, 0}, {18, 35}, {0, 35}}));
  ASSERT_EQ(apart.impacts.size(), whole.impacts.size());
  EXPECT_GT(apart.impacts.size(), 10U);
  double left = 0, right = 0, most = 0;
  ASSERT_EQ(apart.points.size(), whole.points.size());
  for (std::size_t i = 0; i < apart.points.size(); ++i) most = std::max(most, whole.points[i].peak_force);
  for (std::size_t i = 0; i < apart.points.size(); ++i) {
    EXPECT_NEAR(apart.points[i].peak_force, whole.points[i].peak_force, 1e-9 * most);
    (i < apart.points.size() / 2 ? left : right) += apart.points[i].peak_force;
  }
  EXPECT_GT(left, 0);
  EXPECT_GT(right, 0);  // both wings are struck
  EXPECT_NEAR(apart.buildings[0].rotation(0), whole.buildings[0].rotation(0), 1e-9 * whole.buildings[0].rotation(0));
}

TEST(OutlineParts, ImpactsWithoutTimeKeepThemApart) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = outlines_problem(drawn_block(seed), {}, true);
    const PlanResponse response = solve(problem, ExactSolver{}, {.output_step = 0.004, .energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    EXPECT_LE(response.energy->relative_residual(), 1e-9);
  }
}

}  // namespace
}  // namespace bentur::outline_parts
