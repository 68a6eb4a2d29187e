// Eccentric buildings in plan by chance, held by frames in both directions whose members yield, lose strength or break:
// `exact` against `adaptive`, the energy, and what must change nothing: mirrors, quarter turns, frames seen from
// behind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "bentur/structure/frame/frame_hinges.h"
#include "tests/support/random_numbers.h"

namespace bentur::hinged_plans {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// How a plan is told.
struct Told {
  Eigen::Matrix2d map = Eigen::Matrix2d::Identity();  ///< a quarter turn, a mirror
  bool behind = false;                                ///< frames are seen from there
  [[nodiscard]] bool swaps() const { return map(0, 0) == 0; }
};

/// A frame on a line in plan.
struct Stand {
  PlaneFrame frame;
  PlanPoint through, direction;
};

struct Drawn {
  Plan plan;
  std::vector<Stand> frames = {};
};

PlaneFrame from_behind(PlaneFrame frame) {
  std::reverse(frame.bay_widths.begin(), frame.bay_widths.end());
  for (Section& column : frame.columns) {
    std::reverse(column.moment_capacity.begin(), column.moment_capacity.end());
    std::reverse(column.shear_capacity.begin(), column.shear_capacity.end());
  }
  return frame;
}

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}

  std::vector<Drawn> make() {
    const PlanPoint first(any(8, 14), any(8, 14)), second(any(8, 14), any(8, 14));
    const double gap = any(0.001, 0.008), shift = any(-0.4, 0.4) * std::min(first.y(), second.y());
    std::vector<Drawn> all = {building({0, 0}, first), building({first.x() + gap, shift}, second)};
    stiffness = std::pow(10, any(4.8, 5.8));
    for (GroundMotion& motion : motions) {
      motion = HarmonicMotion{.period = any(0.35, 0.8), .displacement_amplitude = any(0.02, 0.05)};
    }
    return all;
  }

  double stiffness = 0;
  std::array<GroundMotion, 2> motions;

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  bool chance(double of) { return any(0, 1) < of; }

  Section member(double inertia, double capacity, std::size_t capacities) {
    Section section{.area = 0.1, .inertia = inertia};
    if (chance(0.1)) return section;  // stays elastic
    const std::size_t given = chance(0.5) ? capacities : 1;
    for (std::size_t n = 0; n < given; ++n) section.moment_capacity.push_back(capacity * any(0.8, 1.25));
    section.hardening = chance(0.3) ? 0 : any(0.003, 0.01);
    if (softens_ && chance(0.7)) {
      section.backbone = {.plastic = any(0.002, 0.008), .softening = any(0.03, 0.08), .residual = any(0.1, 0.6)};
      if (chance(0.5)) section.backbone.ultimate = section.backbone.plastic + any(0.001, 0.004);
    }
    return section;
  }

  PlaneFrame frame(const std::vector<double>& heights) {
    PlaneFrame frame;
    frame.elastic_modulus = 3e7;
    frame.storey_heights = heights;
    const int bays = chance(0.5) ? 1 : 2;
    for (int bay = 0; bay < bays; ++bay) frame.bay_widths.push_back(any(4, 6));
    const std::size_t lines = frame.bay_widths.size() + 1;
    for (std::size_t j = 0; j < heights.size(); ++j) {
      frame.columns.push_back(member(any(1e-3, 3e-3), any(60, 140), lines));
      frame.beams.push_back(member(any(1e-3, 3e-3), any(50, 140), 2));
      if (chance(0.4)) frame.beams.back().line_load = any(1, 6);
      if (breaks_ && chance(0.5)) frame.columns.back().shear_capacity = {any(40, 100)};
      if (breaks_) frame.columns.back().residual_shear = 0.3;
    }
    return frame;
  }

  Drawn building(const PlanPoint& corner, const PlanPoint& size) {
    const auto storeys = static_cast<std::size_t>(chance(0.5) ? 1 : 2);
    softens_ = chance(0.3);
    breaks_ = !softens_ && chance(0.3);
    Drawn made{.plan = {.footprint = {.corner = corner, .size = size},
                        .storey_heights = std::vector<double>(storeys, 3.0),
                        .masses = std::vector<double>(storeys, any(60, 140)),
                        .centres_of_mass = {size.cwiseProduct(PlanPoint(any(0.35, 0.65), any(0.35, 0.65)))}}};
    Plan& plan = made.plan;
    if (chance(0.4)) plan.gravity_loads = std::vector<double>(storeys, 9.81 * plan.masses[0]);
    made.frames = {{frame(plan.storey_heights), {0, any(0, 0.3) * size.y()}, PlanPoint::UnitX()},
                   {frame(plan.storey_heights), {any(0, 0.4) * size.x(), 0}, PlanPoint::UnitY()}};
    if (chance(0.6)) {
      const double turned = any(-0.2, 0.2);
      made.frames.push_back(
          {frame(plan.storey_heights), {0, any(0.7, 1) * size.y()}, {std::cos(turned), std::sin(turned)}});
    }
    plan.rigidity = PlanRigidity{.centres = {size / 2}, .x = {any(3e3, 2e4)}, .y = {any(3e3, 2e4)}, .torsion = {4e5}};
    return made;
  }

  std::mt19937_64 engine_;
  bool softens_ = false, breaks_ = false;
};

PlanProblem problem_of(unsigned seed, const Told& told = {}) {
  Generator generator(seed);
  PlanProblem problem;
  for (Drawn& drawn : generator.make()) {
    Plan& plan = drawn.plan;
    const Footprint from = plan.footprint;
    plan.footprint = {.corner = (told.map * from.corner).cwiseMin(told.map * from.far_corner()),
                      .size = told.map.cwiseAbs() * from.size};
    const auto local = [&](const PlanPoint& at) -> PlanPoint {
      return told.map * (from.corner + at) - plan.footprint.corner;
    };
    for (PlanPoint& centre : plan.centres_of_mass) centre = local(centre);
    plan.rigidity->centres = {local(plan.rigidity->centres[0])};
    if (told.swaps()) std::swap(plan.rigidity->x, plan.rigidity->y);
    for (const Stand& stand : drawn.frames) {
      PlanPlane& plane = plan.planes.emplace_back();
      plane.name = fmt::format("frame {}", plan.planes.size());
      plane.through = local(stand.through);
      plane.direction = told.map * (told.behind ? PlanPoint(-stand.direction) : stand.direction);
      stand_frame(told.behind ? from_behind(stand.frame) : stand.frame, plane);
    }
    const std::string name = "B" + std::to_string(problem.buildings.size());
    problem.buildings.push_back(make_plan_building(name, plan_model(plan), MassProportionalDamping{0.04}));
  }
  const PlanModel &one = problem.buildings[0].model, &other = problem.buildings[1].model;
  const auto stretch = facing(one.footprint, other.footprint);
  PlanGap gap{.left = 0, .right = 1, .stretch = stretch.value()};
  if (stretch->swapped) std::swap(gap.left, gap.right);
  for (Index floor = 0; floor < std::min(one.floors(), other.floors()); ++floor) {
    for (const StretchPoint& point : points_of(*stretch, 2)) {
      gap.contacts.push_back({floor, floor, one.elevations[floor], point.along,
                              std::make_shared<Linear>(point.share * generator.stiffness)});
    }
  }
  problem.gaps = {gap};
  problem.motions = generator.motions;
  problem.axes = told.map;
  problem.duration = 2;
  return problem;
}

PlanResponse run(const PlanProblem& problem, const Solver& solver = ExactSolver{}) {
  return solve(problem, solver, {.energy_audit = true});
}

double apart(const VectorXd& a, const VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(a.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
}

/// What all hinges of a frame, and all columns that break, did: sums, and the largest.
VectorXd sums(const BuildingPeaks& frame) {
  VectorXd all = VectorXd::Zero(7);
  for (const BuildingPeaks::Hinge& hinge : frame.hinges) {
    all(0) += hinge.dissipated_energy;
    all(1) = std::max(all(1), hinge.peak_rotation);
    all(2) = std::max(all(2), hinge.peak_moment);
    all(3) += hinge.first_yield.value_or(0);
    all(4) += hinge.strength_left.value_or(1);
  }
  for (const BuildingPeaks::Breaking& column : frame.columns) {
    all(5) += column.break_time.value_or(0);
    all(6) = std::max(all(6), column.peak_shear);
  }
  return all;
}

void expect_alike(const PlanResponse& one, const PlanResponse& other, const Told& told, double tolerance) {
  ASSERT_EQ(other.status, one.status) << other.message;
  ASSERT_EQ(other.impacts.size(), one.impacts.size());
  double impulses[2] = {0, 0};
  for (const Impact& impact : one.impacts) impulses[0] += impact.impulse;
  for (const Impact& impact : other.impacts) impulses[1] += impact.impulse;
  EXPECT_NEAR(impulses[0], impulses[1], tolerance * impulses[0]);
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    SCOPED_TRACE(b);
    const PlanPeaks &found = other.buildings[b], &wanted = one.buildings[b];
    EXPECT_LE(apart(wanted.x, told.swaps() ? found.y : found.x), tolerance);
    EXPECT_LE(apart(wanted.y, told.swaps() ? found.x : found.y), tolerance);
    EXPECT_LE(apart(wanted.rotation, found.rotation), tolerance);
    EXPECT_LE(apart(wanted.shear_x, told.swaps() ? found.shear_y : found.shear_x), 10 * tolerance);
    EXPECT_LE(apart(wanted.torque, found.torque), 10 * tolerance);
    for (std::size_t p = 0; p < wanted.planes.size(); ++p) {
      EXPECT_LE(apart(wanted.planes[p].drift_ratio, found.planes[p].drift_ratio), tolerance);
      EXPECT_LE(apart(wanted.planes[p].shear, found.planes[p].shear), 10 * tolerance);
      const VectorXd mine = sums(wanted.planes[p].frame), same = sums(found.planes[p].frame);
      for (Index i = 0; i < mine.size(); ++i) EXPECT_NEAR(mine(i), same(i), 10 * tolerance * (1e-3 + mine(i))) << i;
      const auto &mechanism = wanted.planes[p].frame.mechanism, &too = found.planes[p].frame.mechanism;
      ASSERT_EQ(mechanism.has_value(), too.has_value());
      if (!mechanism) continue;
      EXPECT_NEAR(mechanism->time, too->time, 10 * tolerance);
      EXPECT_EQ(mechanism->storeys, too->storeys);
    }
  }
}

/// BENTUR_HINGED_PLANS=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> seeds() { return test::seeds_of("BENTUR_HINGED_PLANS", {1, 8}, {1, 4}); }

/// What an elastic building would hold at the largest displacements over the energy put in: what members hold that lose
/// strength is the difference between numbers of this size.
double held_at_peak(const PlanProblem& problem, const PlanResponse& response) {
  double most = 1;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const VectorXd stiffness = problem.buildings[b].model.stiffness.diagonal();
    double held = 0;
    for (Index f = 0; f < problem.buildings[b].model.floors(); ++f) {
      const PlanPeaks& peaks = response.buildings[b];
      held +=
          0.5 * stiffness.segment<3>(3 * f).dot(Eigen::Vector3d(peaks.x(f), peaks.y(f), peaks.rotation(f)).cwiseAbs2());
    }
    most = std::max(most, held / response.energy->peak_input);
  }
  return most;
}

TEST(HingedPlans, BothSolversEnergyAndWhatChangesNothing) {
  const auto [first, count] = seeds();
  long yielded = 0, mechanisms = 0, weaker = 0, broken = 0, impacts = 0;
  double worst_energy = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("BENTUR_HINGED_PLANS={}:1", seed));
    const PlanProblem problem = problem_of(seed);
    const PlanResponse exact = run(problem);
    ASSERT_TRUE(exact.status == Status::done || exact.status == Status::collapsed) << exact.message;
    const double residual = exact.energy->relative_residual() / held_at_peak(problem, exact);
    worst_energy = std::max(worst_energy, residual);
    EXPECT_LE(residual, 1e-12);
    impacts += std::ssize(exact.impacts);
    for (const PlanPeaks& peaks : exact.buildings) {
      for (const PlanPeaks::Plane& plane : peaks.planes) {
        mechanisms += plane.frame.mechanism ? 1 : 0;
        for (const auto& hinge : plane.frame.hinges) {
          yielded += hinge.first_yield ? 1 : 0;
          weaker += hinge.strength_left.value_or(1) < 1 ? 1 : 0;
        }
        for (const auto& column : plane.frame.columns) broken += column.break_time ? 1 : 0;
      }
    }
    expect_alike(exact, run(problem, AdaptiveSolver{.tolerance = 1e-12}), {}, 1e-8);
    Eigen::Matrix2d quarter, mirror;
    quarter << 0, -1, 1, 0;
    mirror << -1, 0, 0, 1;
    const std::vector<Told> all = {{.map = quarter}, {.map = mirror}, {.map = quarter * mirror}, {.behind = true}};
    for (const unsigned one : {seed % 4, (seed + 3) % 4}) {
      const Told& told = all[one];
      expect_alike(exact, run(problem_of(seed, told)), told, 1e-9);
    }
  }
  std::printf("%u plans, %ld impacts, %ld hinges formed, %ld weaker, %ld columns broken, %ld mechanisms; energy %.2g\n",
              count, impacts, yielded, weaker, broken, mechanisms, worst_energy);
  EXPECT_GT(yielded, 8 * count);
  EXPECT_GT(impacts, count);
  EXPECT_GE(mechanisms, count / 2);
}

/// Members that never come to their capacity are elastic ones: forces of hinges are then the zeros of rest.
TEST(HingedPlans, OutOfReachAreElasticFrames) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto with = [&](bool hinges) {
      Generator generator(seed);
      std::vector<Drawn> drawn = generator.make();
      PlanProblem problem = problem_of(seed);
      problem.buildings.clear();
      for (Drawn& one : drawn) {
        one.plan.planes.clear();
        for (Stand& stand : one.frames) {
          for (auto* const members : {&stand.frame.columns, &stand.frame.beams}) {
            for (Section& section : *members) {
              section = {.area = section.area, .inertia = section.inertia};
              if (hinges) section.moment_capacity = {1e9};
            }
          }
          PlanPlane plane{.name = "frame", .through = stand.through, .direction = stand.direction};
          stand_frame(stand.frame, plane);
          EXPECT_EQ(plane.hinges.size() > 0, hinges);
          one.plan.planes.push_back(plane);
        }
        problem.buildings.push_back(make_plan_building("B", plan_model(one.plan), MassProportionalDamping{0.04}));
      }
      return run(problem);
    };
    const PlanResponse elastic = with(false), hinged = with(true);
    ASSERT_EQ(elastic.impacts.size(), hinged.impacts.size());
    EXPECT_GT(elastic.impacts.size(), 0U);
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_LE(apart(elastic.buildings[b].x, hinged.buildings[b].x), 1e-12);
      EXPECT_LE(apart(elastic.buildings[b].rotation, hinged.buildings[b].rotation), 1e-12);
      EXPECT_LE(apart(elastic.buildings[b].torque, hinged.buildings[b].torque), 1e-12);
      for (const PlanPeaks::Plane& plane : hinged.buildings[b].planes) {
        EXPECT_FALSE(plane.frame.mechanism);
        EXPECT_EQ(plane.yielding.residual_drift_ratio.cwiseAbs().maxCoeff(), 0);
        for (const BuildingPeaks::Hinge& hinge : plane.frame.hinges) EXPECT_FALSE(hinge.first_yield);
      }
    }
  }
}

TEST(HingedPlans, RefuseWhatAPlaneCannotHave) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {3};
  frame.bay_widths = {5};
  frame.columns = frame.beams = {{.area = 0.1, .inertia = 1e-3, .moment_capacity = {50}}};
  PlanPlane plane;
  stand_frame(frame, plane);
  EXPECT_EQ(plane.hinges.places.size(), 6U);
  frame.nodes = {{.left = true, .elevation = 1.5}};
  EXPECT_THROW(stand_frame(frame, plane), InvalidParameter);
  frame.nodes.clear();
  frame.infills = {Infill{.stiffness = -1e3}};
  EXPECT_THROW(stand_frame(frame, plane), InvalidParameter);
  frame.infills.clear();
  frame.beams[0].line_load = 100;  // its beams yield by that alone
  EXPECT_THROW(stand_frame(frame, plane), InvalidParameter);
}

}  // namespace
}  // namespace bentur::hinged_plans
