// Outlines that turn inwards: their parts, and what touches where. Geometry is the judge, by Boost's polygons.
#include "bentur/pounding/plan/outline/parts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/outline/edges.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/random_numbers.h"

namespace bentur::outline_parts {
namespace {

using Eigen::Index;
using At = boost::geometry::model::d2::point_xy<double>;
using Polygon = boost::geometry::model::polygon<At, false>;
using Line = boost::geometry::model::linestring<At>;

constexpr double reach = 0.6;

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

Footprint told(std::vector<PlanPoint> corners, std::vector<std::vector<PlanPoint>> courts = {}) {
  return polygon_footprint({0, 0}, std::move(corners), std::move(courts));
}

/// `x` by `y` with its lower left corner at `at`, turned about that.
Footprint box(const PlanPoint& at, double x, double y) {
  return told({at, at + PlanPoint(x, 0), at + PlanPoint(x, y), at + PlanPoint(0, y)});
}

/// An L, of which the upper right is left out.
Footprint l_shape(const PlanPoint& at, double x, double y, double arm, double leg) {
  return told({at, at + PlanPoint(x, 0), at + PlanPoint(x, arm), at + PlanPoint(leg, arm), at + PlanPoint(leg, y),
               at + PlanPoint(0, y)});
}

class Shapes {
 public:
  explicit Shapes(unsigned seed) : engine_(seed) {}

  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  int among(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

  /// A star with so many arms, by chance with a court.
  Footprint star() {
    std::vector<PlanPoint> corners, court;
    const int count = among(5, 14);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + any(0, 0.5)) / count;
      corners.push_back(any(4, 12) * PlanPoint(std::cos(angle), std::sin(angle)));
    }
    for (int i = 0, n = among(3, 6); i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + any(0, 0.5)) / n;
      court.push_back(any(0.3, 1.2) * PlanPoint(std::cos(angle), std::sin(angle)));
    }
    if (fault_of_outline(corners)) return star();
    Footprint made = told(corners);
    if (any(0, 1) < 0.5) return made;
    Footprint with = told(corners, {court});
    return fault_of_outline(court) || fault_of_court(with, 0) ? made : with;
  }

  Footprint turned(const Footprint& from, double angle) {
    Footprint made = from;
    const PlanPoint middle = from.corner + from.middle();
    const auto turn = [&](std::vector<PlanPoint>& ring) {
      for (PlanPoint& at : ring) at = middle + Eigen::Rotation2Dd(angle) * (at - middle);
    };
    made.polygon = from.corners();
    made.corner = {0, 0};
    turn(made.polygon);
    for (auto& ring : made.rings) turn(ring);
    return told(made.polygon, made.rings);
  }

 private:
  std::mt19937 engine_;
};

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

PlanBuilding house(Shapes& by, const std::string& name, const Footprint& footprint) {
  Plan plan{.footprint = footprint, .storey_heights = {3}, .masses = {by.any(50, 200)}};
  const double k = plan.masses[0] * std::pow(2 * std::numbers::pi / by.any(0.2, 0.8), 2);
  const PlanPoint middle = footprint.middle(), size = footprint.size;
  plan.rigidity = PlanRigidity{.centres = {middle + by.any(-0.15, 0.15) * size},
                               .x = {k},
                               .y = {by.any(0.5, 2) * k},
                               .torsion = {by.any(0.1, 0.3) * k * size.squaredNorm()}};
  return make_plan_building(name, plan_model(plan), ModalDamping{{0.03}});
}

/// Houses around one that turns inwards, some of them in its notch, its court or between its wings.
std::vector<Footprint> footprints(Shapes& by) {
  const auto joint = [&] { return by.any(0.004, 0.03); };
  const double x = by.any(16, 24), y = by.any(14, 20), arm = by.any(4, 6), leg = by.any(4, 6);
  const double g = joint(), h = joint();
  const int kind = by.among(0, 5);
  std::vector<Footprint> all;
  if (kind == 0) {  // a house in the notch of an L, and one before it
    all = {l_shape({0, 0}, x, y, arm, leg), box({leg + g, arm + h}, by.any(4, 8), by.any(4, 7)),
           box({x + joint(), by.any(-2, 3)}, by.any(6, 9), by.any(6, 9)),
           box({by.any(-9, 3), -8 - joint()}, by.any(6, 9), 8)};
  } else if (kind == 1) {  // between the wings of a U
    const double wide = by.any(5, 8);
    all = {told({{0, 0},
                 {2 * leg + wide, 0},
                 {2 * leg + wide, y},
                 {leg + wide, y},
                 {leg + wide, arm},
                 {leg, arm},
                 {leg, y},
                 {0, y}}),
           box({leg + g, arm + h}, wide - g - joint(), by.any(4, 7))};
  } else if (kind == 2) {  // in a court
    all = {told({{0, 0}, {x, 0}, {x, y}, {0, y}}, {{{leg, arm}, {x - leg, arm}, {x - leg, y - arm}, {leg, y - arm}}}),
           box({leg + g, arm + h}, x - 2 * leg - g - joint(), y - 2 * arm - h - joint()),
           box({-8 - joint(), by.any(-3, 3)}, 8, by.any(6, 9))};
  } else if (kind == 3) {  // on both sides of the stem of a T
    const double from = 0.5 * (x - leg);
    all = {told({{from, 0},
                 {from + leg, 0},
                 {from + leg, y - arm},
                 {x, y - arm},
                 {x, y},
                 {0, y},
                 {0, y - arm},
                 {from, y - arm}}),
           box({from - g - 6, y - arm - h - 7}, 6, 7), box({from + leg + joint(), y - arm - joint() - 8}, 5, 8)};
  } else if (kind == 4) {  // four L's around a crossing
    const auto mirrored = [](const Footprint& from, double sx, double sy) {
      std::vector<PlanPoint> corners = from.corners();
      for (PlanPoint& at : corners) at = {sx * at.x(), sy * at.y()};
      return told(corners);
    };
    const double w = 0.5 * by.any(0.002, 0.03);
    for (const double sx : {1.0, -1.0}) {
      for (const double sy : {1.0, -1.0}) {
        all.push_back(
            mirrored(l_shape({w, 0.5 * g}, by.any(9, 14), by.any(9, 14), by.any(3, 5), by.any(3, 5)), sx, sy));
      }
    }
  } else {  // steps of a façade before a long house, with a bay that is round
    std::vector<PlanPoint> corners = {{0, 0}, {x, 0}, {x, 6}};
    const double step = by.any(0.01, 0.08);
    for (int i = 0; i <= 8; ++i) {
      const double angle = std::numbers::pi * i / 8;
      corners.emplace_back(0.5 * x + 2 + 2 * std::cos(angle), 6 + step * std::sin(angle));
    }
    corners.insert(corners.end(), {{0.3 * x, 6}, {0.3 * x, 6 - step}, {0, 6 - step}});
    all = {told(corners), box({by.any(-3, 3), 6 + step + g}, x, 7)};
  }
  if (by.any(0, 1) < 0.4) {
    for (Footprint& one : all) one = by.turned(one, by.any(-0.001, 0.001));
  }
  std::vector<Footprint> apart;
  for (const Footprint& one : all) {
    if (std::none_of(apart.begin(), apart.end(), [&](const Footprint& other) { return overlap(one, other); })) {
      apart.push_back(one);
    }
  }
  return apart;
}

/// As a case makes it.
PlanGap gap_between(const PlanProblem& problem, Index one, Index other, const ContactLaw* law, double k,
                    double friction) {
  const auto &a = problem.buildings[one].model.footprint, &b = problem.buildings[other].model.footprint;
  const auto joint = joint_between(a, b);
  EXPECT_TRUE(joint);
  PlanGap gap{.left = one, .right = other, .stretch = *joint};
  if (joint->swapped) std::swap(gap.left, gap.right);
  for (const StretchPoint& point : points_between(joint->swapped ? b : a, joint->swapped ? a : b, *joint, 2, reach)) {
    if (point.seam) {
      gap.seams.push_back({.elevation = 3,
                           .family = point.family,
                           .pair = point.pair,
                           .at = point.beside ? *point.beside : joint->at(point.along)});
      continue;
    }
    PlanContact contact{.elevation = 3, .along = point.along, .law = nullptr};
    if (dynamic_cast<const Restitution*>(law) != nullptr) {
      contact.law = std::make_shared<Restitution>(0.7);
    } else {
      contact.law = std::make_shared<Linear>(point.share * k);
      if (friction > 0) contact.rubbing = std::make_shared<Rubbing>(contact.law, friction, point.share * k);
    }
    contact.family = point.family;
    contact.beside = point.beside;
    contact.pair = point.pair;
    gap.contacts.push_back(contact);
  }
  return gap;
}

PlanProblem block(unsigned seed, bool bounces = false) {
  Shapes by(seed);
  PlanProblem problem;
  for (const Footprint& one : footprints(by)) {
    problem.buildings.push_back(house(by, "B" + std::to_string(problem.buildings.size()), one));
  }
  const double k = std::pow(10, by.any(5, 6.2)), friction = by.any(0, 1) < 0.2 ? by.any(0.1, 0.5) : 0;
  const Restitution bounce(0.7);
  for (Index a = 0; a < std::ssize(problem.buildings); ++a) {
    for (Index b = a + 1; b < std::ssize(problem.buildings); ++b) {
      PlanGap gap = gap_between(problem, a, b, bounces ? &bounce : nullptr, k, bounces ? 0 : friction);
      if (gap.stretch.width < 1) problem.gaps.push_back(std::move(gap));
    }
  }
  for (GroundMotion& motion : problem.motions) {
    motion = HarmonicMotion{.period = by.any(0.3, 0.9), .displacement_amplitude = by.any(0.006, 0.02)};
  }
  problem.duration = 4;
  return problem;
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
    const PlanProblem problem = block(seed);
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

TEST(OutlineParts, ImpactsWithoutTimeKeepThemApart) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = block(seed, true);
    const PlanResponse response = solve(problem, ExactSolver{}, {.output_step = 0.004, .energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    EXPECT_LE(response.energy->relative_residual(), 1e-9);
  }
}

}  // namespace
}  // namespace bentur::outline_parts
