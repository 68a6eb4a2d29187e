// Where outlines touch: corners that meet, edges that end, what slips off. Geometry is the judge.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/random_numbers.h"

namespace bentur::outlines {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using LawOf = std::function<std::shared_ptr<const ContactLaw>(double share)>;

constexpr double stiffness = 4e5, mass = 200, reach = 0.6;

std::shared_ptr<const ContactLaw> linear(double share) { return std::make_shared<Linear>(share * stiffness); }

/// Nothing holds it for as long as the tests look.
PlanBuilding free_floor(const std::string& name, const Footprint& footprint, double of_mass = mass) {
  Plan plan{.footprint = footprint, .storey_heights = {3}, .masses = {of_mass}};
  plan.rigidity = PlanRigidity{.centres = {footprint.middle()}, .x = {1e-7}, .y = {1e-7}, .torsion = {1e-7}};
  return make_plan_building(name, plan_model(plan), ModalDamping{{0.0}});
}

PlanGap gap_between(const PlanProblem& problem, Index one, Index other, const LawOf& law, double friction = 0) {
  const auto &a = problem.buildings[one].model.footprint, &b = problem.buildings[other].model.footprint;
  const auto joint = joint_between(a, b);
  EXPECT_TRUE(joint);
  PlanGap gap{.left = one, .right = other, .stretch = *joint};
  if (joint->swapped) std::swap(gap.left, gap.right);
  for (const StretchPoint& point : points_between(joint->swapped ? b : a, joint->swapped ? a : b, *joint, 2, reach)) {
    PlanContact contact{.elevation = 3, .along = point.along, .law = law(point.share)};
    if (friction > 0) contact.rubbing = std::make_shared<Rubbing>(contact.law, friction, point.share * stiffness);
    contact.family = point.family;
    contact.beside = point.beside;
    gap.contacts.push_back(contact);
  }
  return gap;
}

/// What all points of a joint bear of what a long one does.
double whole_share(const Stretch& joint, std::optional<double> spread) {
  double sum = 0;
  for (const StretchPoint& one : points_of(joint, 2, spread)) sum += one.share;
  return sum;
}

Footprint square(const PlanPoint& corner, double side = 10) { return {.corner = corner, .size = {side, side}}; }

/// A square at rest and one that comes from its lower left.
PlanProblem thrown(const PlanPoint& corner, const PlanPoint& velocity, const LawOf& law = linear) {
  PlanProblem problem;
  problem.buildings = {free_floor("A", square({0, 0})), free_floor("B", square(corner))};
  problem.gaps = {gap_between(problem, 0, 1, law)};
  problem.initial_velocity = {Vector3d(velocity.x(), velocity.y(), 0), Vector3d::Zero()};
  problem.duration = 0.2;
  return problem;
}

double kinetic(const PlanResponse& response) { return response.energy->histories.kinetic.tail(1)(0); }

PlanResponse solved(const PlanProblem& problem, const Solver& solver = ExactSolver{}) {
  PlanResponse response = solve(problem, solver, {.output_step = 0.001, .energy_audit = true});
  EXPECT_EQ(response.status, Status::done) << response.message;
  EXPECT_TRUE(response.discrepancies.empty());
  EXPECT_LE(response.energy->relative_residual(), 1e-9);
  return response;
}

// Computed by small steps by another hand; the digits are those that were told.
/// A joint of up to `spread` bears what a corner does, one of twice that all of it, and so in between.
TEST(Outlines, SpreadSaysWhatBelongsToACorner) {
  const auto joint = joint_between(square({0, 0}), square({10.01, 9}));  // 1 m in common
  ASSERT_TRUE(joint);
  EXPECT_DOUBLE_EQ(whole_share(*joint, {}), 0.5);  // 2.5 m
  EXPECT_DOUBLE_EQ(whole_share(*joint, 2.5), 0.5);
  EXPECT_DOUBLE_EQ(whole_share(*joint, 1.0), 0.5);
  EXPECT_NEAR(whole_share(*joint, 0.8), 0.5 * (1 + 0.25), 1e-12);
  EXPECT_DOUBLE_EQ(whole_share(*joint, 0.5), 1.0);
  // Corners of an arc that are nearer than that to one another are one place.
  const Footprint round = polygon_footprint(
      {0, 0}, {{10.05, 0}, {18, 0}, {18, 10}, {10.05, 10}, {9.9905, 5.2}, {9.99, 5.0}, {9.9905, 4.8}});
  const auto at_arc = joint_between({.corner = {0, 0}, .size = {9.98, 10}}, round);
  ASSERT_TRUE(at_arc);
  EXPECT_EQ(points_of(*at_arc, 2, 0.5).size(), 3U);  // the tip and both ends
  EXPECT_EQ(points_of(*at_arc, 2, 0.1).size(), 5U);
}

TEST(Outlines, CornersTouchOnTheSideThatClosesLast) {
  struct Throw {
    PlanPoint velocity;
    double start, force, impulse, end;
    int across;
  };
  for (const Throw& one : {Throw{{0.8660254, 0.5}, 0.0200, 1413.365, 39.9520, 0.0644, 1},
                           Throw{{0.5, 0.8660254}, 0.0200, 1413.365, 39.9520, 0.0644, 0},
                           Throw{{0.7660444, 0.6427876}, 0.01556, 1816.987, 51.3613, 0.05996, 1}}) {
    const PlanProblem problem = thrown({10.01, 10.01}, one.velocity);
    const PlanResponse response = solved(problem);
    ASSERT_EQ(response.impacts.size(), 1U);
    const Impact& impact = response.impacts.front();
    const PlanContact& contact = problem.gaps[0].contacts[static_cast<std::size_t>(impact.point)];
    EXPECT_NEAR(problem.gaps[0].at(contact).normal[one.across], 1, 1e-12);
    EXPECT_NEAR(impact.start, one.start, 5e-6);
    EXPECT_NEAR(impact.end, one.end, 5e-5);
    EXPECT_NEAR(impact.peak_force, one.force, 1e-6 * one.force);
    EXPECT_NEAR(impact.impulse, one.impulse, 2e-6 * one.impulse);
    EXPECT_FALSE(impact.slipped);
    EXPECT_NEAR(kinetic(response), 0.5 * mass, 1e-6 * mass);
  }
}

// Runge-Kutta's rule on the six equations, its last step halved until it ends where y opens. Whole small steps alone
// come 4e-7 s too late.
TEST(Outlines, WhatSlipsOffLosesWhatItsSpringsHold) {
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{.tolerance = 1e-12})}) {
    const PlanResponse response = solved(thrown({10.02, 9.9}, {0.5, -2}), solver);
    ASSERT_EQ(response.impacts.size(), 2U);
    for (const Impact& impact : response.impacts) {
      EXPECT_TRUE(impact.slipped);
      EXPECT_NEAR(impact.start, 0.04, 5e-6);
      EXPECT_NEAR(impact.end, 0.05013, 5e-6);
      EXPECT_NEAR(impact.peak_force, 464.605846, 1e-4);
      EXPECT_NEAR(impact.energy_lost, 1.079293, 1e-5);
    }
    EXPECT_NEAR(response.impacts[0].impulse + response.impacts[1].impulse, 2 * 2.45746, 2e-3);
    EXPECT_NEAR(kinetic(response), 422.841414, 1e-5);
    EXPECT_NEAR(response.energy->histories.contact_lost.tail(1)(0), 425 - 422.841414, 1e-5);
  }
}

TEST(Outlines, WhatIsPassedByDoesNotTouch) {
  // Beside one another before they are abreast: x closes 0.05 m past the end of y.
  const PlanResponse past = solved(thrown({10.08, -9.95}, {1, 1}));
  EXPECT_TRUE(past.impacts.empty());
  EXPECT_NEAR(kinetic(past), mass, 1e-6);
  // Nor does it need more than it has.
  const PlanProblem problem = thrown({10.08, -9.95}, {1, 1});
  for (std::size_t i = 0; i < past.points.size(); ++i) {
    const PlanContact& contact = problem.gaps[0].contacts[i];
    if (contact.is_of_joint()) {
      EXPECT_LE(past.points[i].gap_needed, problem.gaps[0].width_at(contact));
    }
  }
}

// Along 45° both sides close at once: half each, and B goes straight on.
TEST(Outlines, SidesThatCloseAtOnceShare) {
  const double v = std::sqrt(0.5);
  const PlanResponse response = solved(thrown({10.01, 10.01}, {v, v}));
  ASSERT_EQ(response.impacts.size(), 2U);
  EXPECT_NEAR(response.impacts[0].impulse, response.impacts[1].impulse, 1e-9);
  for (const PlanPeaks& peaks : response.buildings) EXPECT_LE(peaks.rotation(0), 1e-12);
  EXPECT_NEAR(kinetic(response), 0.5 * mass, 1e-6 * mass);
  // One mass against another along the diagonal, k/4 along each side.
  const double force = v * std::sqrt(mass / 2 * stiffness / 4);
  EXPECT_NEAR(response.impacts[0].peak_force, force, 1e-6 * force);
}

TEST(Outlines, CornersThatCollideWithoutTime) {
  const LawOf bounces = [](double) { return std::make_shared<Restitution>(1.0); };
  const PlanResponse response = solved(thrown({10.01, 10.01}, {0.8660254, 0.5}, bounces));
  ASSERT_EQ(response.impacts.size(), 1U);
  EXPECT_NEAR(response.impacts[0].impulse, 39.9520, 1e-3);  // as in contact, whose end has it all back
  EXPECT_NEAR(kinetic(response), 0.5 * mass, 1e-6 * mass);
}

// A joint that grows from corner to corner: its force has no jump.
TEST(Outlines, ShortJointsGrowOutOfCorners) {
  double before = 0;
  for (const double common : {-1e-3, 1e-6, 1e-3, 0.01, 0.1, 0.5, 1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0}) {
    const double slide = common < 0 ? 0.002 : 0;  // it is there when it strikes
    const PlanProblem problem = thrown({10.01, 10 - common}, {1, 100 * slide});
    const PlanResponse response = solved(problem);
    double force = 0, share = 0;
    for (const PointSummary& point : response.points) force += point.peak_force;
    for (const PlanContact& contact : problem.gaps[0].contacts) {
      if (contact.is_of_joint()) share += contact.law->parameters().front().second / stiffness;
    }
    EXPECT_NEAR(share, std::clamp(common / 5, 0.5, 1.0), 1e-9) << common;
    EXPECT_GT(force, 0) << common;
    if (before > 0 && common < 0.2) {
      EXPECT_NEAR(force, before, 0.03 * before) << common;
    }
    before = force;
  }
}

Footprint told(const PlanPoint& at, std::vector<PlanPoint> corners) {
  return polygon_footprint(at, std::move(corners));
}

/// A house turned by 45°, its right corner at the origin drawn with so many points.
Footprint turned_house(int points, double radius) {
  const double half = 5 * std::sqrt(2.0);
  std::vector<PlanPoint> corners = {{-half, half}, {-2 * half, 0}, {-half, -half}};
  if (points == 1) corners.push_back({0, 0});
  for (int i = 0; i < points && points > 1; ++i) {
    const double angle = std::numbers::pi / 4 * (2.0 * i / (points - 1) - 1);
    const PlanPoint middle(-radius * std::sqrt(2.0), 0);
    corners.push_back(middle + radius * PlanPoint(std::cos(angle), std::sin(angle)));
  }
  return told({0, 0}, corners);
}

double force_on_wall(const Footprint& house, double of_mass) {
  double right = -1e9;
  for (const PlanPoint& corner : house.corners()) right = std::max(right, corner.x());
  PlanProblem problem;
  problem.buildings = {free_floor("A", house, of_mass),
                       rigid_plan_building("W", {.corner = {right + 0.001, -15}, .size = {1, 30}}, {3})};
  problem.gaps = {gap_between(problem, 0, 1, linear)};
  problem.initial_velocity = {Vector3d(0.5, 0, 0), Vector3d::Zero()};
  problem.duration = 0.5;
  const PlanResponse response = solve(problem, ExactSolver{}, {.output_step = 0.0005});
  EXPECT_EQ(response.status, Status::done) << response.message;
  return response.histories.force.colwise().sum().maxCoeff();
}

TEST(Outlines, ACornerIsAsStiffHoweverFinelyItIsDrawn) {
  const double sharp = force_on_wall(turned_house(1, 0), 150);
  EXPECT_NEAR(sharp, 0.5 * std::sqrt(150 * stiffness / 2), 1e-3 * sharp);
  for (const int points : {2, 3, 5, 9}) {
    EXPECT_NEAR(force_on_wall(turned_house(points, 0.3), 150), sharp, 0.05 * sharp) << points;
  }
}

TEST(Outlines, ARoundTowerIsAsStiffHoweverFinelyItIsDrawn) {
  double first = 0;
  for (const int corners : {8, 16, 32, 64}) {
    std::vector<PlanPoint> outline;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      outline.emplace_back(6 * std::cos(angle), 6 * std::sin(angle));
    }
    const double force = force_on_wall(told({0, 0}, outline), 100);
    if (first == 0) first = force;
    EXPECT_NEAR(force, first, 0.1 * first) << corners;
  }
}

/// A floor where it is, with all second-order parts of its rotation left out as in (P-1).
Footprint displaced(const PlanModel& model, const PlanPoint& by, double theta) {
  std::vector<PlanPoint> corners = model.footprint.corners();
  const PlanPoint centre = model.footprint.corner + model.centres[0];
  for (PlanPoint& at : corners) {
    const PlanPoint arm = at - centre;
    at += by + theta * PlanPoint(-arm.y(), arm.x());
  }
  return {.corner = {0, 0}, .size = {30, 30}, .polygon = corners};
}

class Blocks {
 public:
  explicit Blocks(unsigned seed) : engine_(seed) {}

  /// Three to five houses around a crossing or along a street, some of them turned, with corners cut, or round.
  PlanProblem make() {
    PlanProblem problem;
    const double joint = any(0.005, 0.03);
    const PlanPoint sizes(any(7, 12), any(7, 12));
    const std::vector<PlanPoint> corners = {{0, 0},
                                            {sizes.x() + joint, any(-0.2, 0.2)},
                                            {any(-0.2, 0.2), sizes.y() + joint + 0.21},
                                            {sizes.x() + any(0.001, 0.05), sizes.y() + any(0.001, 0.05) + 0.21}};
    const int kind = among(0, 3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Footprint footprint{.corner = corners[i], .size = i == 0 ? sizes : PlanPoint(any(7, 12), any(7, 12))};
      if (kind == 3 && i == 1) footprint.corner.y() = sizes.y() - any(-0.03, 0.15);  // an edge that ends
      if (kind == 3 && i == 2) footprint.corner = {-sizes.x() + any(-0.1, 0.1), -footprint.size.y() - any(0.001, 0.02)};
      if (i == 1) footprint.size.y() = sizes.y() + any(-0.3, 0);
      if (i == 2) footprint.size.x() = sizes.x() + any(-0.3, 0);
      if (kind == 1) footprint = cut(footprint);
      if (kind == 2) footprint = turned(footprint, any(-0.004, 0.004));
      if (std::any_of(problem.buildings.begin(), problem.buildings.end(),
                      [&](const PlanBuilding& one) { return overlap(one.model.footprint, footprint); })) {
        continue;
      }
      problem.buildings.push_back(house("B" + std::to_string(i), footprint));
    }
    const LawOf law = [k = std::pow(10, any(5, 6.2))](double share) { return std::make_shared<Linear>(share * k); };
    for (Index a = 0; a < std::ssize(problem.buildings); ++a) {
      for (Index b = a + 1; b < std::ssize(problem.buildings); ++b) {
        PlanGap gap = gap_between(problem, a, b, law);
        if (gap.stretch.width < 1) problem.gaps.push_back(std::move(gap));
      }
    }
    for (GroundMotion& motion : problem.motions) {
      motion = HarmonicMotion{.period = any(0.3, 0.9), .displacement_amplitude = any(0.006, 0.02)};
    }
    problem.duration = 5;
    return problem;
  }

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  int among(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

  Footprint cut(const Footprint& from) {
    std::vector<PlanPoint> corners;
    const std::vector<PlanPoint> all = from.corners();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const PlanPoint before = (all[(i + 3) % 4] - all[i]).normalized(),
                      after = (all[(i + 1) % 4] - all[i]).normalized();
      const double part = any(0, 1) < 0.5 ? 0 : any(0.1, 1.5);
      if (part > 0) corners.push_back(all[i] + part * before);
      corners.push_back(all[i] + part * after);
    }
    return told({0, 0}, corners);
  }
  static Footprint turned(const Footprint& from, double angle) {
    std::vector<PlanPoint> corners = from.corners();
    const PlanPoint middle = from.corner + from.middle();
    for (PlanPoint& at : corners) at = middle + Eigen::Rotation2Dd(angle) * (at - middle);
    return told({0, 0}, corners);
  }
  PlanBuilding house(const std::string& name, const Footprint& footprint) {
    Plan plan{.footprint = footprint, .storey_heights = {3}, .masses = {any(50, 200)}};
    const double k = plan.masses[0] * std::pow(2 * std::numbers::pi / any(0.2, 0.8), 2);
    const PlanPoint middle = footprint.middle(), size = footprint.size;
    plan.rigidity = PlanRigidity{.centres = {middle + any(-0.15, 0.15) * size},
                                 .x = {k},
                                 .y = {any(0.5, 2) * k},
                                 .torsion = {any(0.1, 0.3) * k * size.squaredNorm()}};
    return make_plan_building(name, plan_model(plan), ModalDamping{{0.03}});
  }

  std::mt19937 engine_;
};

/// First and last seed; of BENTUR_RANDOM_OUTLINES "FROM:TO" where that is set.
std::pair<unsigned, unsigned> seeds() { return test::seeds_of("BENTUR_RANDOM_OUTLINES", {1, 50}, {1, 8}); }

// No overlap is deeper than a contact tells, and no force acts where there is none, but for what products of rotations
// and displacements make, which the equations leave out, and for rotation times d where corners are merged.
TEST(Outlines, GeometryIsTheJudgeOfRandomBlocks) {
  const auto [first, last] = seeds();
  long impacts = 0, slips = 0, beside = 0, overlaps = 0;
  for (unsigned seed = first; seed <= last; ++seed) {
    SCOPED_TRACE("BENTUR_RANDOM_OUTLINES=" + std::to_string(seed) + ":" + std::to_string(seed));
    const PlanProblem problem = Blocks(seed).make();
    const PlanResponse response = solve(problem, ExactSolver{}, {.output_step = 0.002, .energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    EXPECT_TRUE(response.discrepancies.empty());
    EXPECT_LE(response.energy->relative_residual(), 1e-9);
    impacts += std::ssize(response.impacts);
    for (const Impact& impact : response.impacts) slips += impact.slipped ? 1 : 0;
    Index point = 0;
    for (const PlanGap& gap : problem.gaps) {
      const PlanModel &left = problem.buildings[gap.left].model, &right = problem.buildings[gap.right].model;
      double theta = 0, moved = 0;
      for (const Index b : {gap.left, gap.right}) {
        theta += response.buildings[b].rotation(0);
        moved += response.buildings[b].x(0) + response.buildings[b].y(0);
      }
      const double size = std::max(left.footprint.size.maxCoeff(), right.footprint.size.maxCoeff());
      const double left_out = theta * moved + theta * theta * size + 1e-9;
      const auto places = static_cast<std::size_t>(std::count_if(
          gap.contacts.begin(), gap.contacts.end(), [&](const PlanContact& one) { return one.is_of_joint(); }));
      const double merged = gap.stretch.corners_along().size() > places ? 0.25 * gap.stretch.shorter * theta : 0;
      for (std::size_t t = 0; t < response.histories.time.size(); ++t) {
        const auto at = [&](Index b, const PlanModel& model) {
          const auto column = static_cast<Index>(t);
          return displaced(model, {response.histories.x[b](0, column), response.histories.y[b](0, column)},
                           response.histories.rotation[b](0, column));
        };
        const double depth = overlap_depth(at(gap.left, left), at(gap.right, right));
        double told = 0;
        bool pushes = false;
        for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
          const Index row = point + static_cast<Index>(i);
          if (!(response.histories.force(row, static_cast<Index>(t)) > 0)) continue;
          pushes = true;
          told = std::max(told, -response.histories.opening(row, static_cast<Index>(t)));
          beside += gap.contacts[i].is_of_joint() ? 0 : 1;
        }
        overlaps += depth > left_out + merged ? 1 : 0;
        if (pushes) {
          ASSERT_GE(depth, -left_out) << gap_name(problem, gap) << " at " << response.histories.time[t];
        }
        ASSERT_LE(depth, told + left_out + merged) << gap_name(problem, gap) << " at " << response.histories.time[t];
      }
      point += std::ssize(gap.contacts);
    }
  }
  std::printf("%u blocks, %ld impacts, %ld slipped, %ld samples overlap, %ld points beside a joint push\n",
              last - first + 1, impacts, slips, overlaps, beside);
  EXPECT_GT(impacts, 10 * static_cast<long>(last - first));
  EXPECT_GT(slips, 0);
  EXPECT_GT(beside, 0);
}

}  // namespace
}  // namespace bentur::outlines
