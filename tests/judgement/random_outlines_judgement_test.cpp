// What is said of gaps between outlines that turn inwards: never that one is enough where some wall of the two meets,
// in the run or in that of the motion reversed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/outlines/shapes.h"
#include "tests/support/random_numbers.h"

namespace bentur {
namespace {

using namespace bentur::test;

BuildingSpec house(const Footprint& footprint, const std::vector<double>& heights, Shapes& by, std::size_t number) {
  Plan plan{.footprint = footprint, .storey_heights = heights, .masses = {}};
  const PlanPoint middle = footprint.middle();
  for (std::size_t f = 0; f < heights.size(); ++f) plan.masses.push_back(by.any(60, 300));
  plan.centres_of_mass = {middle + PlanPoint(by.any(-1, 1), by.any(-1, 1))};
  const double k = by.any(2e4, 2e5);
  plan.rigidity = PlanRigidity{.centres = {middle}, .x = {k}, .y = {k * by.any(0.5, 2)}, .torsion = {60 * k}};
  BuildingSpec spec;
  spec.name = fmt::format("H{}", number);
  spec.structure = plan;
  spec.damping = ModalDamping{{0.05}};
  return spec;
}

/// A block around a house that turns inwards, or the two of it that are told apart by no levels in common.
Case block(unsigned seed) {
  Shapes by(seed);
  std::vector<Footprint> outlines = footprints(by);
  if (seed % 3 != 0 && outlines.size() > 2) outlines.resize(2);
  const bool meet = seed % 4 != 0;
  Case c;
  c.units = {.length = "m", .force = "kN", .gravity = 9.81};
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const std::vector<double> heights = meet || b % 2 == 0 ? std::vector{3.0, 3.0} : std::vector{4.5};
    c.buildings.push_back(house(outlines[b], heights, by, b));
  }
  for (std::size_t a = 0; a < outlines.size(); ++a) {
    for (std::size_t b = a + 1; b < outlines.size(); ++b) {
      const auto joint = joint_between(outlines[a], outlines[b]);
      if (!joint || joint->width > 0.3) continue;
      GapSpec gap;
      gap.left = static_cast<Eigen::Index>(joint->swapped ? b : a);
      gap.right = static_cast<Eigen::Index>(joint->swapped ? a : b);
      gap.stretch = *joint;
      gap.contact.numbers = {{"stiffness", {1e5}}};
      if (meet) gap.levels = {{0, 0, 3.0}, {1, 1, 6.0}};
      c.gaps.push_back(gap);
    }
  }
  SampledMotion x{0.02, {}}, y{0.02, {}};
  const double size = std::pow(10, by.any(-1, 0.5));
  for (int i = 0; i < 150; ++i) {
    x.acceleration.push_back(size * by.any(-1, 1));
    y.acceleration.push_back(size * by.any(-1, 1));
  }
  c.excitation.motion = x;
  c.excitation_y.motion = y;
  c.analysis.duration = 3;
  c.analysis.goes_on = true;
  return c;
}

/// Whether two of a gap meet in a run with contact, anywhere.
bool meets(const PlanProblem& problem, const PlanResponse& response, std::size_t gap) {
  const Eigen::Index first = first_contact(problem, gap);
  std::size_t watched = 0;
  for (std::size_t g = 0; g < gap; ++g) watched += problem.gaps[g].watched.size();
  const auto begin = response.points.begin() + first;
  const auto floors = response.watched.begin() + static_cast<std::ptrdiff_t>(watched);
  return std::any_of(begin, begin + std::ssize(problem.gaps[gap].contacts),
                     [](const PointSummary& one) { return one.impacts + one.settling > 0; }) ||
         std::any_of(floors, floors + std::ssize(problem.gaps[gap].watched),
                     [](const WatchedSummary& one) { return one.closes; });
}

struct Tally {
  long gaps = 0, enough = 0, small = 0, beside = 0;
};

void examine(unsigned seed, Tally& tally) {
  SCOPED_TRACE(fmt::format("block {}", seed));
  const Case c = block(seed);
  if (c.gaps.empty()) return;
  PlanProblem problem = make_plan_problem(c);
  PlanProblem other = problem;
  for (GroundMotion& motion : other.motions) {
    for (double& value : std::get<SampledMotion>(motion).acceleration) value *= -1;
  }
  const SolveOptions options{.limits = {.events = 50000}, .levels = true, .both_ways = true};
  PlanResponse response = solve(problem, ExactSolver{}, options);
  if (response.status != Status::done) return;
  const PlanRun run = run_results(c, std::move(problem), std::move(response));
  other.duration = run.problem.duration;
  const PlanResponse reversed = solve(other, ExactSolver{}, {.limits = {.events = 50000}});
  const std::vector<JudgedGap> judged = judged_gaps(run);
  for (std::size_t g = 0; g < judged.size(); ++g) {
    ++tally.gaps;
    const Judgement& judgement = judged[g].judgement;
    const bool struck = meets(run.problem, run.response, g);
    tally.enough += judgement.is_enough() ? 1 : 0;
    tally.small += judgement.value == Sufficiency::too_small ? 1 : 0;
    if (struck) {
      EXPECT_EQ(judgement.value, Sufficiency::too_small) << judged[g].facts.left << " | " << judged[g].facts.right;
    }
    // What closes is of a place that is reported, wherever it is.
    for (const LevelFacts& level : judged[g].facts.levels) {
      if (level.at.beside && level.given.need > level.at.width) ++tally.beside;
    }
    if (!judgement.is_enough() || reversed.status != Status::done) continue;
    EXPECT_FALSE(meets(other, reversed, g)) << "reversed, " << judged[g].facts.left << " | " << judged[g].facts.right;
  }
}

TEST(RandomOutlines, AreNeverEnoughWhereSomeWallMeets) {
  const auto [first, count] = seeds_of("BENTUR_JUDGED_OUTLINES", {1, 1500}, {1, 150});
  Tally tally;
  for (unsigned seed = first; seed < first + count; ++seed) examine(seed, tally);
  fmt::print("{} gaps: {} enough, {} too small, {} places beside a joint that fall short\n", tally.gaps, tally.enough,
             tally.small, tally.beside);
  EXPECT_GT(tally.gaps, count);
  EXPECT_GT(tally.enough, 0.05 * count);
  EXPECT_GT(tally.small, 0.2 * count);
  EXPECT_GT(tally.beside, 0.1 * count);
}

// Where contacts beside a joint say what their pair of parts needs, floors are watched that contacts leave out.
TEST(RandomOutlines, AreWatchedWhereTheyWouldTouch) {
  const auto [first, count] = seeds_of("BENTUR_JUDGED_OUTLINES", {1, 1500}, {1, 15});
  long places = 0, seams = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("block {}", seed));
    Case c = block(seed);
    const PlanProblem touching = make_plan_problem(c);
    for (GapSpec& gap : c.gaps) gap.levels.clear();
    const PlanProblem watching = make_plan_problem(c);
    for (std::size_t g = 0; g < touching.gaps.size(); ++g) {
      const std::vector<PlanWatched>& watched = watching.gaps[g].watched;
      for (const PlanContact& contact : touching.gaps[g].contacts) {
        if (contact.pair == 0 || !touching.gaps[g].is_of_pair(contact)) continue;
        ++places;
        seams += contact.family > 0 ? 1 : 0;
        EXPECT_TRUE(std::any_of(watched.begin(), watched.end(), [&](const PlanWatched& one) {
          return one.beside && one.elevation == contact.elevation && one.beside->left == contact.beside->left &&
                 one.beside->right == contact.beside->right;
        }));
      }
    }
  }
  fmt::print("{} places, {} of pairs whose joint is a seam\n", places, seams);
  EXPECT_GT(places, count);
}

}  // namespace
}  // namespace bentur
