// Buildings and links of every kind: what is asked for beside the answer does not change it, to the bit, nor do floors
// that are only watched; and it is what `adaptive` finds, which takes none of the shortcuts of `exact`. Nor does it
// matter how they are described.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/pounding.h"
#include "tests/invariance/difference.h"
#include "tests/invariance/every_kind.h"
#include "tests/invariance/movement.h"
#include "tests/invariance/transforms.h"
#include "tests/invariance/unit_change.h"
#include "tests/support/random_numbers.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// BENTUR_EVERY_KIND=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen() { return test::seeds_of("BENTUR_EVERY_KIND", {1, 300}, {1, 40}); }

/// Nothing where gravity loads are more than a weak building bears.
std::optional<Problem> made(const Case& c) {
  try {
    return make_problem(c);
  } catch (const InvalidParameter&) {
    return std::nullopt;
  }
}

TEST(EveryKind, IsNotChangedByWhatIsAskedForBesideIt) {
  const auto [first, count] = chosen();
  long impacts = 0, still = 0, unmade = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    const std::optional<Problem> drawn = made(EveryKindGenerator(seed).make());
    if (!drawn) {
      ++unmade;
      continue;
    }
    const Problem& problem = *drawn;
    const Response plain = solve(problem);
    ASSERT_TRUE(plain.status == Status::done || plain.status == Status::collapsed) << plain.message;
    SolveOptions all;
    all.output_step = 0.0137;
    all.energy_audit = true;
    const Response looked = solve(problem, ExactSolver{}, all);
    ASSERT_EQ(looked.status, plain.status) << looked.message;
    expect_same(plain, looked);
    Problem unwatched = problem;
    unwatched.watched.clear();
    expect_same(plain, solve(unwatched));
    const Response other = solve(problem, AdaptiveSolver{1e-10});
    ASSERT_TRUE(other.status == Status::done || other.status == Status::collapsed) << other.message;
    EXPECT_EQ(plain.impacts.empty(), other.impacts.empty());
    // When those begin that touch from the start is a matter of round-off.
    const bool apart = std::none_of(problem.points.begin(), problem.points.end(),
                                    [](const ContactPoint& point) { return point.width == 0; });
    if (apart && !plain.impacts.empty() && !other.impacts.empty()) {
      EXPECT_NEAR(plain.impacts[0].start, other.impacts[0].start, 1e-5 * problem.duration);
    }
    // Impulses at one instant take energy together: the part of a point that was opening is less than nothing.
    std::vector<double> taken;
    double last = -problem.duration;
    for (const Impact& impact : looked.impacts) {
      const bool impulse = impact.start == impact.end;
      if (!impulse || impact.start - last > 1e-10 * problem.duration) taken.push_back(0.0);
      taken.back() += impact.energy_lost;
      last = impulse ? impact.start : -problem.duration;
    }
    for (const double energy : taken) EXPECT_GE(energy, -1e-10 * looked.energy->peak_input);
    impacts += static_cast<long>(plain.impacts.size());
    still += plain.impacts.empty() ? 1 : 0;
  }
  fmt::print("{} cases, {} impacts, {} cases without, {} that cannot be\n", count, impacts, still, unmade);
  EXPECT_GT(impacts, 2 * static_cast<long>(count));
  EXPECT_GT(still, 0);
  EXPECT_LT(unmade, count / 5 + 1);
}

// A floor that has stood still is pressed against the next one within the first step of an integrated contact.
TEST(EveryKind, TouchesAtOnceWhereItStoodStill) {
  EXPECT_EQ(solve(made(EveryKindGenerator(109148).make()).value()).status, Status::done);
}

// A building that is held still against a wall has no motion by which to measure the errors of a step: steps of 1e-9 s.
TEST(EveryKind, IsHeldStillInFewSteps) {
  for (const unsigned seed : {6517U, 6955U}) {
    const Problem problem = make_problem(EveryKindGenerator(seed).make());
    SolveOptions options;
    options.limits.steps = 20000;
    EXPECT_EQ(solve(problem, AdaptiveSolver{1e-10}, options).status, Status::done);
  }
}

Problem reversed(Problem problem) {
  if (auto* sampled = std::get_if<SampledMotion>(&problem.motion)) {
    for (double& value : sampled->acceleration) value *= -1;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&problem.motion)) harmonic->displacement_amplitude *= -1;
  return problem;
}

/// Each face of a contact point or a watched floor by itself, there and back, as watched floors before a wall.
std::vector<WatchedFloor> faces_alone(const Problem& problem) {
  std::vector<WatchedFloor> alone;
  const auto add = [&](Eigen::Index left, const Eigen::VectorXd& left_row, const Eigen::VectorXd& right_row) {
    for (const double sign : {1.0, -1.0}) {
      WatchedFloor one;
      one.left = one.floor_of = one.gap = left;
      one.right = left + 1;
      one.left_row = sign * left_row;
      one.right_row = sign * right_row;
      alone.push_back(one);
    }
  };
  const auto both = [&](Eigen::Index left, const Eigen::VectorXd& left_row, const Eigen::VectorXd& right_row) {
    add(left, left_row, Eigen::VectorXd::Zero(right_row.size()));
    add(left, Eigen::VectorXd::Zero(left_row.size()), right_row);
  };
  for (const ContactPoint& point : problem.points) {
    const auto unit = [&](Eigen::Index b, Eigen::Index dof) -> Eigen::VectorXd {
      return Eigen::VectorXd::Unit(problem.buildings[b].model.dofs(), dof);
    };
    both(point.left, unit(point.left, point.left_floor), unit(point.left + 1, point.right_floor));
  }
  for (const WatchedFloor& floor : problem.watched) both(floor.left, floor.left_row, floor.right_row);
  return alone;
}

// What the reversed motion needs is taken from the response without contact where that is its mirror image, and the
// peak of a floor from the building's; the long way is a run under the reversed motion, and each face watched alone.
TEST(EveryKind, NeedsBothWaysRoundWhatTheReversedMotionNeeds) {
  const auto [first, count] = chosen();
  long mirrored = 0, others = 0, columns = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    const std::optional<Problem> drawn = made(EveryKindGenerator(seed).make());
    if (!drawn) continue;
    Problem problem = *drawn;
    problem.kinematics = Kinematics::relative;  // peaks are relative to the own base
    if (seed % 2 == 0) {                        // from rest, where it can be a mirror image
      problem.initial_displacement.clear();
      problem.initial_velocity.clear();
    }
    SolveOptions ways;
    ways.levels = ways.both_ways = true;
    const Response response = solve(problem, ExactSolver{}, ways);
    const FreeResponse back(reversed(problem));
    double scale = 0;
    for (const BuildingPeaks& peaks : response.buildings) {
      scale = std::max(scale, peaks.displacement_no_contact.maxCoeff());
    }
    Problem looked = problem;
    looked.watched = faces_alone(problem);
    std::stable_sort(looked.watched.begin(), looked.watched.end(),
                     [](const WatchedFloor& a, const WatchedFloor& b) { return a.left < b.left; });
    const FreeResponse faces(looked);
    const bool ends =
        back.response().status == Status::done && response.status == Status::done && !response.collapse_no_contact;
    // Faces in the order of their buildings: those of points and watched floors of each gap.
    std::vector<double> sways;
    for (std::size_t i = 0; i < looked.watched.size(); i += 2) {
      sways.push_back(std::max(faces.response().watched[i].gap_needed, faces.response().watched[i + 1].gap_needed));
    }
    std::size_t at = 0;
    const auto check = [&](const auto& told, const auto& reversed_need) {
      if (ends && !std::holds_alternative<NoMotion>(problem.motion)) {
        ASSERT_TRUE(told.gap_needed_reversed.has_value());
        EXPECT_NEAR(*told.gap_needed_reversed, reversed_need.gap_needed, 1e-9 * scale);
      }
      EXPECT_NEAR(told.peak_left, sways[at++], 1e-9 * scale);
      EXPECT_NEAR(told.peak_right, sways[at++], 1e-9 * scale);
    };
    for (const Gap& gap : gaps_of(problem)) {
      for (const Eigen::Index i : gap.points) check(response.points[i], back.response().points[i]);
      for (const Eigen::Index i : gap.watched) {
        check(response.watched[i], back.response().watched[i]);
        columns += problem.watched[i].facing_floor ? 0 : 1;
      }
    }
    (is_mirrored(system_of(problem)) ? mirrored : others) += 1;
  }
  fmt::print("{} mirrored, {} others, {} columns\n", mirrored, others, columns);
  EXPECT_GT(mirrored, 0);
  EXPECT_GT(others, 0);
  EXPECT_GT(columns, 0);
}

/// The case with its gaps, motion and speeds changed by a 1e-12th of themselves, up or down.
Case nudged(Case c, unsigned seed) {
  std::mt19937 random(seed);
  const auto nudge = [&random] { return random() % 2 == 0 ? 1 + 1e-12 : 1 - 1e-12; };
  for (GapSpec& gap : c.gaps) scale(gap.widths, nudge());
  c.excitation.motion = scaled(c.excitation.motion, nudge());
  scale(c.excitation.delays, nudge());
  for (auto& values : c.initial.velocities) scale(values, nudge());
  return c;
}

/// With stiffnesses that are wrong, and the first period that mends them; `factors` counts buildings so described.
Case calibrated(Case c, double factor, long& factors) {
  for (BuildingSpec& spec : c.buildings) {
    BuildingSpec fixed;
    fixed.structure = spec.structure;
    fixed.damping = ModalDamping{{0.0}};
    fixed.gravity = spec.gravity;
    if (auto* stick = std::get_if<Stick>(&fixed.structure)) stick->yield_forces.clear();
    const double period = 2 * std::numbers::pi / make_building(fixed).first_omega();
    if (auto* frame = std::get_if<PlaneFrame>(&spec.structure)) {
      frame->elastic_modulus *= factor;
    } else if (auto* stick = std::get_if<Stick>(&spec.structure)) {
      scale(stick->stiffnesses, factor);
    } else if (auto* matrices = std::get_if<MatricesSpec>(&spec.structure)) {
      matrices->stiffness *= factor;
    } else {
      continue;
    }
    spec.calibrate_period = period;
    ++factors;
  }
  return c;
}

/// With one contact point more, a floor above the first one, `farther` apart, which is too far to close; nothing where
/// there are no such floors, or where rebounds without duration follow one another ever faster: which of them is the
/// last depends on the round-off of coordinates, and that on how far apart all floors are.
std::optional<Problem> with_one_more(Problem problem, double farther) {
  const bool rebounds = std::any_of(problem.points.begin(), problem.points.end(),
                                    [](const ContactPoint& point) { return point.law->name() == "restitution"; });
  if (problem.points.empty() || rebounds) return std::nullopt;
  ContactPoint more = problem.points.front();
  const StructuralModel &left = problem.buildings[more.left].model, &right = problem.buildings[more.left + 1].model;
  ++more.left_floor;
  ++more.right_floor;
  if (more.left_floor >= left.floors() || more.right_floor >= right.floors()) return std::nullopt;
  if (left.elevations[more.left_floor] != right.elevations[more.right_floor]) return std::nullopt;
  more.elevation = left.elevations[more.left_floor];
  more.width += farther;
  problem.points.insert(problem.points.begin() + 1, more);
  return problem;
}

TEST(EveryKind, IsTheSameHoweverItIsDescribed) {
  const auto [first, count] = chosen();
  long compared = 0, sensitive = 0, factors = 0, levels = 0, impacts = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = EveryKindGenerator(seed).make();
    const std::optional<Problem> drawn = made(c);
    if (!drawn) continue;
    const Problem& problem = *drawn;
    const Response base = solve(problem);
    if (base.status == Status::collapsed || base.collapse_no_contact)
      continue;  // where it ends is a matter of round-off
    impacts += static_cast<long>(base.impacts.size());
    const double duration = c.analysis.duration;
    Movement movement(problem, base, [&c](unsigned of) { return make_problem(nudged(c, of)); });
    const auto compare = [&](const char* how, const Response& other) {
      ++compared;
      const Difference apart = difference(base, starting_as(base, other, problem), duration);
      if (apart.size <= same) return;
      if (other.status == base.status && movement.explains(apart)) {
        ++sensitive;
        return;
      }
      ADD_FAILURE() << how << ": " << apart.what << ", apart by " << apart.size << "; by perturbations "
                    << movement.most();
    };
    compare("mirrored", mirrored_back(solve(make_problem(mirrored(c))), problem));
    const UnitChange units = seed % 2 == 0 ? UnitChange{100, 1} : UnitChange{1 / 0.0254, 1 / 4.4482216152605};
    compare(seed % 2 == 0 ? "cm, N" : "in, lbf", in_units_back(solve(make_problem(in_units(c, units))), units));
    compare("calibrated", solve(make_problem(calibrated(c, seed % 3 == 0 ? 0.2 : 4.5, factors))));
    const std::optional<Problem> higher = with_one_more(problem, 4 * farthest_displacement(base));
    if (!higher) continue;
    Response more = solve(*higher);
    ASSERT_EQ(more.points.at(1).impacts, 0);
    more.points.erase(more.points.begin() + 1);
    for (Impact& impact : more.impacts) impact.point -= impact.point > 0 ? 1 : 0;
    compare("one level more", more);
    ++levels;
  }
  fmt::print("{} comparisons, {} impacts, {} of them sensitive; {} buildings calibrated, {} levels more\n", compared,
             impacts, sensitive, factors, levels);
  EXPECT_GT(factors, static_cast<long>(count) / 4);
  EXPECT_GT(levels, static_cast<long>(count) / 8);
  EXPECT_LT(sensitive, 0.15 * static_cast<double>(compared) + 1);
}

}  // namespace
}  // namespace bentur
