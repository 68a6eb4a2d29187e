// Many houses: what is solved island by island is what is solved with all houses stepped together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/core/in_a_thread.h"
#include "bentur/pounding/plan/free_touches.h"
#include "bentur/pounding/plan/no_force.h"
#include "bentur/pounding/plan/outline/near.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/same_response.h"

namespace bentur::many_plans {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class LawOf { linear, kelvin_voigt, some_hertz };

class Blocks {
 public:
  explicit Blocks(unsigned seed) : engine_(seed) {}

  /// Rows of houses of two storeys, party walls and corners some millimetres to centimetres apart; between some of them
  /// the roofs are watched alone.
  PlanProblem make(LawOf law, Index columns = 4, Index rows = 3) {
    PlanProblem problem;
    double below = 0;
    for (Index r = 0; r < rows; ++r) {
      double left = 0, tallest = 0;
      for (Index c = 0; c < columns; ++c) {
        const PlanPoint size(any(7, 12), any(7, 12));
        problem.buildings.push_back(
            house("H" + std::to_string(r * columns + c), {.corner = {left, below}, .size = size}));
        left += size.x() + any(0.002, 0.03);
        tallest = std::max(tallest, size.y());
      }
      below += tallest + any(0.002, 0.02);
    }
    std::vector<Footprint> footprints;
    for (const PlanBuilding& building : problem.buildings) footprints.push_back(building.model.footprint);
    for (const auto& [a, b] : pairs_near(footprints, 0.3)) add_gap(problem, a, b, law);
    for (GroundMotion& motion : problem.motions) {
      std::vector<double> acceleration;
      const double period = any(0.3, 0.9), phase = any(0, 3);
      for (int n = 0; n <= 200; ++n) {
        const double t = 0.02 * n;
        acceleration.push_back(3 * std::sin(0.25 * std::numbers::pi * t) *
                               std::sin(2 * std::numbers::pi * t / period + phase));
      }
      motion = SampledMotion{0.02, acceleration};
    }
    problem.duration = 4;
    return problem;
  }

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

  PlanBuilding house(const std::string& name, const Footprint& footprint) {
    Plan plan{.footprint = footprint, .storey_heights = {3, 3}, .masses = {any(50, 200), any(50, 150)}};
    const double k = (plan.masses[0] + plan.masses[1]) * std::pow(2 * std::numbers::pi / any(0.15, 0.5), 2);
    const PlanPoint middle = footprint.middle(), size = footprint.size;
    const PlanPoint centre = middle + any(-0.15, 0.15) * size;
    const double torsion = any(0.1, 0.3) * k * size.squaredNorm();
    plan.rigidity = PlanRigidity{
        .centres = {centre, centre}, .x = {k, 0.7 * k}, .y = {1.3 * k, k}, .torsion = {torsion, 0.8 * torsion}};
    return make_plan_building(name, plan_model(plan), ModalDamping{{0.03}});
  }

  void add_gap(PlanProblem& problem, Index a, Index b, LawOf kind) {
    const Footprint &one = problem.buildings[a].model.footprint, &other = problem.buildings[b].model.footprint;
    const auto joint = joint_between(one, other);
    if (!joint || joint->width > 0.3) return;
    PlanGap gap{.left = a, .right = b, .stretch = *joint};
    if (joint->swapped) std::swap(gap.left, gap.right);
    const double stiffness = std::pow(10, any(4.8, 5.8));
    const bool is_watched = !joint->is_corner() && any(0, 1) < 0.2, is_hertz = any(0, 1) < 0.1;
    const auto law = [&](double share) -> std::shared_ptr<const ContactLaw> {
      const double k = share * stiffness;
      if (kind == LawOf::kelvin_voigt) {
        return std::make_shared<KelvinVoigt>(k, 0.14, share * 60, KelvinVoigt::Release::zero_force);
      }
      if (kind == LawOf::some_hertz && is_hertz) return std::make_shared<Hertz>(10 * k);
      return std::make_shared<Linear>(k);
    };
    std::vector<PlanContact> beside;
    for (const Index floor : {0, 1}) {
      const double elevation = 3.0 * static_cast<double>(floor + 1);
      if (is_watched && floor == 1) {
        for (const double along : {joint->from, joint->to}) {
          gap.watched.push_back(
              {.floor_of = gap.left, .floor = floor, .facing_floor = floor, .elevation = elevation, .along = along});
        }
        continue;
      }
      const bool swapped = joint->swapped;
      for (const StretchPoint& point : points_between(swapped ? other : one, swapped ? one : other, *joint, 2, 0.6)) {
        PlanContact contact{.left_floor = floor,
                            .right_floor = floor,
                            .elevation = elevation,
                            .along = point.along,
                            .law = law(point.share)};
        contact.family = point.family;
        contact.beside = point.beside;
        (contact.is_of_joint() ? gap.contacts : beside).push_back(std::move(contact));
      }
    }
    for (PlanContact& contact : beside) gap.contacts.push_back(std::move(contact));
    problem.gaps.push_back(std::move(gap));
  }

  std::mt19937 engine_;
};

void expect_near(const MatrixXd& one, const MatrixXd& other, double part, const char* what) {
  ASSERT_EQ(one.rows(), other.rows()) << what;
  ASSERT_EQ(one.cols(), other.cols()) << what;
  if (one.size() == 0) return;
  EXPECT_LE((one - other).cwiseAbs().maxCoeff(), part * other.cwiseAbs().maxCoeff()) << what;
}

/// What an account of all energy asks for is stepped together.
void expect_the_same(const PlanProblem& problem, double part) {
  const PlanResponse one = solve(problem, ExactSolver{}, {.output_step = 0.01});
  const PlanResponse other = solve(problem, ExactSolver{}, {.output_step = 0.01, .energy_audit = true});
  ASSERT_EQ(one.status, Status::done) << one.message;
  ASSERT_EQ(other.status, Status::done) << other.message;
  EXPECT_TRUE(one.discrepancies.empty());
  EXPECT_NE(one.steps, other.steps);
  EXPECT_EQ(one.events, other.events);
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  EXPECT_GT(one.impacts.size(), 50U);
  const auto list = [](const PlanResponse& response, const auto& of) {
    VectorXd values(std::ssize(response.impacts));
    for (Index n = 0; n < values.size(); ++n) values(n) = of(response.impacts[static_cast<std::size_t>(n)]);
    return values;
  };
  const auto compare = [&](const char* what, const auto& of) {
    expect_near(list(one, of), list(other, of), part, what);
  };
  compare("point", [](const Impact& impact) { return static_cast<double>(impact.point); });
  compare("start", [](const Impact& impact) { return impact.start; });
  compare("end", [](const Impact& impact) { return impact.end; });
  compare("slipped", [](const Impact& impact) { return impact.slipped ? 1.0 : 0.0; });
  compare("closing speed", [](const Impact& impact) { return impact.closing_speed; });
  compare("force", [](const Impact& impact) { return impact.peak_force; });
  compare("penetration", [](const Impact& impact) { return impact.peak_penetration; });
  compare("impulse", [](const Impact& impact) { return impact.impulse; });
  compare("energy", [](const Impact& impact) { return impact.energy_lost; });
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const PlanPeaks &peaks = one.buildings[b], &others = other.buildings[b];
    expect_near(peaks.x, others.x, part, "x");
    expect_near(peaks.y, others.y, part, "y");
    expect_near(peaks.rotation, others.rotation, part, "rotation");
    expect_near(peaks.acceleration_x, others.acceleration_x, part, "acceleration");
    expect_near(peaks.angular_acceleration, others.angular_acceleration, part, "angular acceleration");
    expect_near(peaks.shear_y, others.shear_y, part, "shear");
    expect_near(one.histories.x[b], other.histories.x[b], part, "history of x");
    expect_near(one.histories.rotation[b], other.histories.rotation[b], part, "history of rotation");
    expect_near(one.histories.acceleration_y[b], other.histories.acceleration_y[b], part, "history of acceleration");
  }
  ASSERT_EQ(one.watched.size(), other.watched.size());
  for (std::size_t n = 0; n < one.watched.size(); ++n) {
    EXPECT_NEAR(one.watched[n].least_opening, other.watched[n].least_opening, part);
  }
  EXPECT_EQ(one.histories.time, other.histories.time);
  expect_near(one.histories.opening, other.histories.opening, part, "openings");
  expect_near(one.histories.force, other.histories.force, part, "forces");
}

TEST(ManyPlans, IslandsAreWhatAllHousesAreTogether) {
#ifdef BENTUR_SANITIZED
  constexpr unsigned last = 2;
#else
  constexpr unsigned last = 8;
#endif
  for (unsigned seed = 1; seed <= last; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same(Blocks(seed).make(seed % 2 == 0 ? LawOf::linear : LawOf::kelvin_voigt), 1e-8);
  }
}

// A segment is gone over together from where a contact begins whose force is no line.
TEST(ManyPlans, IslandsGiveWayWhereAForceIsNoLine) {
  for (unsigned seed = 11; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    expect_the_same(Blocks(seed).make(LawOf::some_hertz), 1e-5);
  }
}

// What a house costs is counted, not timed, of 60 to 240 houses under one motion: pairs looked at, places that are
// watched, steps and events. Were all pairs looked at, or did an event of one house end the steps of all, it would grow
// fourfold; what is drawn parts the blocks by some per cent.
TEST(ManyPlans, CostIsLinearInHouses) {
  struct Counts {
    double pairs = 0, places = 0, steps = 0, events = 0;
  };
  const auto of_a_house = [](Index rows) {
    PlanProblem problem = Blocks(7).make(LawOf::linear, 12, rows);
    problem.motions[0] = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.02};
    problem.motions[1] = HarmonicMotion{.period = 0.4, .displacement_amplitude = 0.01};
    problem.duration = 1.5;
    std::vector<Footprint> footprints;
    for (const PlanBuilding& building : problem.buildings) footprints.push_back(building.model.footprint);
    const PlanResponse response = solve(problem, ExactSolver{});
    EXPECT_EQ(response.status, Status::done) << response.message;
    const auto houses = static_cast<double>(problem.buildings.size());
    Counts counts{static_cast<double>(pairs_near(footprints, 0.3).size()) / houses,
                  static_cast<double>(response.points.size()) / houses, static_cast<double>(response.steps) / houses,
                  static_cast<double>(response.events) / houses};
    std::printf("%g houses, of each %.3g pairs, %.3g places, %.3g steps, %.3g events\n", houses, counts.pairs,
                counts.places, counts.steps, counts.events);
    return counts;
  };
  const Counts few = of_a_house(5), some = of_a_house(10), many = of_a_house(20);
  for (const auto member : {&Counts::pairs, &Counts::places, &Counts::steps, &Counts::events}) {
    EXPECT_GT(few.*member, 1);
    EXPECT_LE(some.*member, 1.25 * few.*member);
    EXPECT_LE(many.*member, 1.25 * few.*member);
  }
}

// The reversed motion by a thread of its own.
TEST(ManyPlans, TwoThreadsFindWhatOneDoes) {
  for (unsigned seed = 41; seed <= 43; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = Blocks(seed).make(LawOf::kelvin_voigt);
    SolveOptions options{.both_ways = true};
    const PlanResponse alone = solve(problem, ExactSolver{}, options);
    options.beside = in_a_thread;
    const PlanResponse beside = solve(problem, ExactSolver{}, options);
    EXPECT_TRUE(alone.reversed->has_contact);
    test::expect_same_outcome(alone, beside);
  }
}

// Contacts of meetings that cannot touch get room; the long way leaves them where they are.
TEST(ManyPlans, RoomForOthersDoesNotChangeWhatTouches) {
  std::size_t touching = 0, apart = 0;
  for (unsigned seed = 51; seed <= 130; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = Blocks(seed).make(LawOf::linear);
    const System system = system_of(problem);
    const FreeSolution free(system, ExactSolver{});
    FreeTouches touches(system, free, {});
    std::vector<Contact> contacts = system.contacts;
    for (Contact& contact : contacts) contact.law = no_force();
    std::vector<char> wanted(contacts.size(), 0);
    for (const Impact& impact : free.solve(contacts).impacts) wanted[static_cast<std::size_t>(impact.point)] = 1;
    for (std::size_t n = 0; n < contacts.size(); ++n) {
      if (contacts[n].place.meeting < 0) continue;
      EXPECT_EQ(touches.found()[n], wanted[n]) << n;
      (wanted[n] != 0 ? touching : apart) += 1;
    }
  }
  EXPECT_GT(touching, 40U);
  EXPECT_GT(apart, 40U);
}

}  // namespace
}  // namespace bentur::many_plans
