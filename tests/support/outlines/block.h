#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/outlines/shapes.h"

// Blocks of such houses, written in several ways.
namespace bentur::test {

constexpr double reach_of_outlines = 0.6;  // [m]

/// How a block is written: nothing of it may change what happens.
struct OutlinesWritten {
  Eigen::Matrix2d map = Eigen::Matrix2d::Identity();  ///< a quarter turn, a mirror
  bool backwards = false;                             ///< the order of the buildings
  std::size_t first_corner = 0;                       ///< of every ring
  bool clockwise = false;                             ///< the order of the corners of every ring

  [[nodiscard]] bool swaps() const { return map(0, 0) == 0; }
  [[nodiscard]] std::vector<PlanPoint> ring(std::vector<PlanPoint> corners) const {
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first_corner % corners.size()),
                corners.end());
    for (PlanPoint& at : corners) at = map * at;
    if (clockwise) std::reverse(corners.begin(), corners.end());
    return corners;
  }
};

/// As a case makes it.
inline PlanGap gap_between(const PlanProblem& problem, Eigen::Index one, Eigen::Index other, const ContactLaw* law,
                           double k, double friction) {
  const auto &a = problem.buildings[one].model.footprint, &b = problem.buildings[other].model.footprint;
  const auto joint = joint_between(a, b);
  EXPECT_TRUE(joint);
  PlanGap gap{.left = one, .right = other, .stretch = *joint};
  if (joint->swapped) std::swap(gap.left, gap.right);
  for (const StretchPoint& point :
       points_between(joint->swapped ? b : a, joint->swapped ? a : b, *joint, 2, reach_of_outlines)) {
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

/// One house of a block, its centre of rigidity from (0, 0).
struct DrawnHouse {
  Footprint footprint;
  double mass = 0, x = 0, y = 0, torsion = 0;
  PlanPoint centre = PlanPoint::Zero();
};

/// What a block is drawn from; in m, kN, s.
struct DrawnBlock {
  std::vector<DrawnHouse> houses;
  double stiffness = 0, friction = 0;
  std::array<HarmonicMotion, 2> motions;
};

inline DrawnBlock drawn_block(unsigned seed) {
  Shapes by(seed);
  DrawnBlock drawn;
  for (const Footprint& one : footprints(by)) {
    DrawnHouse& house = drawn.houses.emplace_back();
    house.footprint = one;
    house.mass = by.any(50, 200);
    house.x = house.mass * std::pow(2 * std::numbers::pi / by.any(0.2, 0.8), 2);
    house.centre = one.middle() + by.any(-0.15, 0.15) * one.size;
    house.y = by.any(0.5, 2) * house.x;
    house.torsion = by.any(0.1, 0.3) * house.x * one.size.squaredNorm();
  }
  drawn.stiffness = std::pow(10, by.any(5, 6.2));
  drawn.friction = by.any(0, 1) < 0.2 ? by.any(0.1, 0.5) : 0;
  for (HarmonicMotion& motion : drawn.motions) {
    motion = HarmonicMotion{.period = by.any(0.3, 0.9), .displacement_amplitude = by.any(0.006, 0.02)};
  }
  return drawn;
}

/// @param bounces contact that takes no time, without friction
inline PlanProblem outlines_problem(const DrawnBlock& drawn, const OutlinesWritten& written = {},
                                    bool bounces = false) {
  PlanProblem problem;
  for (std::size_t b = 0; b < drawn.houses.size(); ++b) {
    const std::size_t from = written.backwards ? drawn.houses.size() - 1 - b : b;
    const DrawnHouse& house = drawn.houses[from];
    std::vector<std::vector<PlanPoint>> courts;
    for (const std::vector<PlanPoint>& ring : house.footprint.rings) courts.push_back(written.ring(ring));
    Plan plan{.footprint = told(written.ring(house.footprint.corners()), courts),
              .storey_heights = {3},
              .masses = {house.mass}};
    plan.rigidity = PlanRigidity{.centres = {written.map * house.centre},
                                 .x = {written.swaps() ? house.y : house.x},
                                 .y = {written.swaps() ? house.x : house.y},
                                 .torsion = {house.torsion}};
    problem.buildings.push_back(make_plan_building("B" + std::to_string(from), plan_model(plan), ModalDamping{{0.03}}));
  }
  const Restitution bounce(0.7);
  for (Eigen::Index a = 0; a < std::ssize(problem.buildings); ++a) {
    for (Eigen::Index b = a + 1; b < std::ssize(problem.buildings); ++b) {
      PlanGap gap =
          gap_between(problem, a, b, bounces ? &bounce : nullptr, drawn.stiffness, bounces ? 0 : drawn.friction);
      if (gap.stretch.width < 1) problem.gaps.push_back(std::move(gap));
    }
  }
  problem.motions = {drawn.motions[0], drawn.motions[1]};
  problem.axes = written.map;
  problem.duration = 4;
  return problem;
}

}  // namespace bentur::test
