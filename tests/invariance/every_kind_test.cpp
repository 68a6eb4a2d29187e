// Buildings and links of every kind: what is asked for beside the answer does not change it, to the bit, nor do floors
// that are only watched; and it is what `adaptive` finds, which takes none of the shortcuts of `exact`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/solve/solver.h"
#include "tests/invariance/every_kind.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// BENTUR_EVERY_KIND=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen() {
#ifdef __SANITIZE_ADDRESS__
  std::pair<unsigned, unsigned> range = {1, 40};
#else
  std::pair<unsigned, unsigned> range = {1, 600};
#endif
  if (const char* text = std::getenv("BENTUR_EVERY_KIND")) {
    unsigned first = 1, count = 0;
    if (std::sscanf(text, "%u:%u", &first, &count) == 2) range = {first, count};
  }
  return range;
}

TEST(EveryKind, IsNotChangedByWhatIsAskedForBesideIt) {
  const auto [first, count] = chosen();
  long impacts = 0, still = 0, unmade = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    Problem problem;
    try {
      problem = make_problem(EveryKindGenerator(seed).make());
    } catch (const InvalidParameter& error) {  // gravity loads that a weak building does not bear
      ++unmade;
      continue;
    }
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
    impacts += static_cast<long>(plain.impacts.size());
    still += plain.impacts.empty() ? 1 : 0;
  }
  fmt::print("{} cases, {} impacts, {} cases without, {} that cannot be\n", count, impacts, still, unmade);
  EXPECT_GT(impacts, 2 * static_cast<long>(count));
  EXPECT_GT(still, 0);
  EXPECT_LT(unmade, count / 5 + 1);
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
      one.left = one.floor_of = left;
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
    Problem problem;
    try {
      problem = make_problem(EveryKindGenerator(seed).make());
    } catch (const InvalidParameter&) {
      continue;
    }
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
    (is_mirrored(problem) ? mirrored : others) += 1;
  }
  fmt::print("{} mirrored, {} others, {} columns\n", mirrored, others, columns);
  EXPECT_GT(mirrored, 0);
  EXPECT_GT(others, 0);
  EXPECT_GT(columns, 0);
}

}  // namespace
}  // namespace bentur
