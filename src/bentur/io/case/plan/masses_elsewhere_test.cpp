// Masses that may stand elsewhere, either way, against a case for each of their places.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/plan/masses_elsewhere.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// Two buildings so far apart and a wall above them; A and B have masses at these places. @param more of the planes of
/// A
std::string three(const std::string& a, const std::string& b, const std::string& more, double width,
                  double wall = 0.01) {
  return R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.3
contact = { law = "linear", stiffness = 4e5 }
[[building]]
name = "A"
damping = 0.05
[building.plan]
corner = [0, 0]
size = [12, 18]
storey_heights = [3.5, 3.2]
masses = [200, 180]
)" + a + R"(
[[building.plane]]
along = "x"
at = 0.5
stiffnesses = 9e4
)" + more +
         R"(
[[building.plane]]
along = "x"
at = 17
stiffnesses = 2e4
[[building.plane]]
along = "y"
at = 6
stiffnesses = 9e4
[[building]]
name = "B"
damping = 0.05
[building.plan]
corner = [)" +
         std::to_string(12 + width) + R"(, 4]
size = [9, 20]
storey_heights = [3.5, 2.0, 2.2]
masses = [100, 90, 80]
)" + b + R"(
[[building.plane]]
along = "x"
at = 1
stiffnesses = 5e4
[[building.plane]]
along = "x"
at = 18
stiffnesses = 6e4
[[building.plane]]
along = "y"
at = 4
stiffnesses = 6e4
[[building]]
name = "W"
rigid = true
elevations = [3.5]
plan = { corner = [2, )" +
         std::to_string(18 + wall) + R"(], size = [6, 1] }
[excitation]
kind = "harmonic"
period = 0.6
displacement_amplitude = 0.02
[excitation.y]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.01
[analysis]
duration = 4
)";
}

const std::string yields = "yield_forces = 300\nhardening = 0.1\n";

std::string at(double x, double y) {
  return "accidental_eccentricity = [" + std::to_string(x) + ", " + std::to_string(y) + "]";
}

/// The most that each point and watched floor needs, as the motion is given and reversed, one run after the other.
struct Needs {
  std::vector<double> given, reversed;

  void raise(const PlanResponse& response) {
    std::vector<double> mine, other;
    for (const auto& one : response.points) mine.push_back(one.gap_needed);
    for (const auto& one : response.watched) mine.push_back(one.gap_needed);
    for (const auto& one : response.points) other.push_back(one.gap_needed_reversed.value());
    for (const auto& one : response.watched) other.push_back(one.gap_needed_reversed.value());
    raise(mine, given);
    raise(other, reversed);
  }
  static void raise(const std::vector<double>& from, std::vector<double>& to) {
    to.resize(from.size(), 0);
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = std::max(to[i], from[i]);
  }
};

/// Both buildings at each of their five places: what the key does in one run.
void expect_most_of_all(const std::string& more) {
  const std::array<std::pair<double, double>, 5> places = {{{0, 0}, {0.05, 0}, {-0.05, 0}, {0, 0.05}, {0, -0.05}}};
  Needs most;
  for (const auto& [ax, ay] : places) {
    for (const auto& [bx, by] : places) {
      most.raise(test::told_plan_run(three(at(ax, ay), at(bx, by), more, 0.2)).response);
    }
  }
  const PlanRun both =
      test::told_plan_run(three("accidental_eccentricity = 0.05", "accidental_eccentricity = 0.05", more, 0.2));
  Needs found;
  found.raise(both.response);
  EXPECT_EQ(found.given, most.given);
  EXPECT_EQ(found.reversed, most.reversed);
  Needs expected;  // which is more than masses where they are expected need
  expected.raise(test::told_plan_run(three("", "", more, 0.2)).response);
  EXPECT_NE(found.given, expected.given);
}

TEST(MassesElsewhere, NeedWhatTheWorstOfAllPlacesNeeds) { expect_most_of_all(""); }

TEST(MassesElsewhere, DoSoWhereBuildingsYieldAndEitherWayOfTheMotionIsItsOwn) { expect_most_of_all(yields); }

/// The choice that a point keeps needs what it needs, by a run with its masses there; of the worst the story says
/// where.
TEST(MassesElsewhere, SayWhichPlacesNeedTheMost) {
  const std::string away = "accidental_eccentricity = 0.05";
  const PlanRun run = test::told_plan_run(three(away, away, "", 0.2));
  const std::vector<MassPlaces> choices = mass_choices(run.problem);
  std::set<int> kept;
  for (std::size_t i = 0; i < run.response.points.size(); ++i) {
    const PointSummary& point = run.response.points[i];
    for (const bool reversed : {false, true}) {
      const int choice = reversed ? point.masses_reversed : point.masses;
      kept.insert(choice);
      const MassPlaces places =
          choice == 0 ? MassPlaces(run.problem.buildings.size(), -1) : choices.at(static_cast<std::size_t>(choice) - 1);
      const PlanResponse there =
          PlanFreeResponse(with_masses_at(run.problem, places), run.c.analysis.solver, {}, {}, true).response();
      EXPECT_EQ(reversed ? there.points[i].gap_needed_reversed : there.points[i].gap_needed,
                reversed ? point.gap_needed_reversed : point.gap_needed);
    }
  }
  EXPECT_GT(kept.size(), 1U);
  const std::vector<Statement> told = run_story(run).statements;
  const auto worst =
      std::find_if(told.begin(), told.end(), [](const Statement& one) { return one.kind == "masses_worst"; });
  ASSERT_NE(worst, told.end());
  const auto text = [&](const char* name) {
    for (const StoryValue& one : worst->values) {
      if (one.name == name) return std::get<std::string>(one.value);
    }
    return std::string();
  };
  EXPECT_NE(text("left_masses").find("5\u00A0%\u00A0"), std::string::npos) << text("left_masses");
}

TEST(MassesElsewhere, AreInTheFreeResponseOfManyRuns) {
  const std::string away = "accidental_eccentricity = 0.05";
  const PlanRun run = test::told_plan_run(three(away, away, "", 0.2));
  const PlanFreeResponse free(run.problem, run.c.analysis.solver, {}, {}, true);
  Needs whole, shared, solved;
  whole.raise(run.response);
  shared.raise(free.response());
  solved.raise(free.solve(run.problem, solve_options(run.c)));
  EXPECT_EQ(shared.given, whole.given);
  EXPECT_EQ(shared.reversed, whole.reversed);
  EXPECT_EQ(solved.given, whole.given);
  EXPECT_EQ(solved.reversed, whole.reversed);
}

TEST(MassesElsewhere, LeaveTheRunItselfAsItIs) {
  const PlanRun both = test::told_plan_run(three("accidental_eccentricity = 0.05", "", "", 0.01));
  const PlanRun alone = test::told_plan_run(three("", "", "", 0.01));
  ASSERT_FALSE(alone.response.impacts.empty());
  ASSERT_EQ(both.response.impacts.size(), alone.response.impacts.size());
  for (std::size_t i = 0; i < alone.response.impacts.size(); ++i) {
    EXPECT_EQ(both.response.impacts[i].peak_force, alone.response.impacts[i].peak_force);
  }
}

/// A gap between what masses where they are expected need and what they need elsewhere: nothing touches in the run.
TEST(MassesElsewhere, MakeAGapTooSmallThatTheRunDoesNotClose) {
  const auto need = [](const PlanRun& run) {
    double most = 0;
    for (const JudgedGap& one : judged_gaps(run)) {
      if (one.facts.right != "B") continue;
      for (const LevelFacts& level : one.facts.levels) {
        most = std::max({most, level.given.need.value(), level.reversed.need.value()});
      }
    }
    return most;
  };
  const std::string away = "accidental_eccentricity = 0.1";
  const double expected = need(test::told_plan_run(three("", "", "", 0.2, 1))),
               worst = need(test::told_plan_run(three(away, away, "", 0.2, 1)));
  ASSERT_GT(worst, 1.01 * expected);
  const double width = 0.5 * (expected + worst);
  const PlanRun without = test::told_plan_run(three("", "", "", width, 1)),
                with = test::told_plan_run(three(away, away, "", width, 1));
  const auto gap = [](const PlanRun& run) {
    for (const JudgedGap& one : judged_gaps(run)) {
      if (one.facts.right == "B") return one.judgement;
    }
    return Judgement{};
  };
  EXPECT_NE(gap(without).value, Sufficiency::too_small);
  ASSERT_EQ(gap(with).value, Sufficiency::too_small);
  EXPECT_EQ(gap(with).reasons.front().kind, Reason::Kind::need);
  const Story told = run_story(with);
  EXPECT_TRUE(std::any_of(told.statements.begin(), told.statements.end(),
                          [](const Statement& one) { return one.kind == "masses_elsewhere"; }));
}

/// Every two neighbours of a block go through every choice of both.
TEST(MassesElsewhere, GoThroughEveryChoiceOfNeighbours) {
  constexpr Eigen::Index across = 4, count = across * across;
  PlanProblem block;
  block.buildings.resize(count);
  block.elsewhere.assign(count, std::vector<PlanBuilding>(4));
  block.elsewhere[5].clear();  // a wall
  const auto join = [&](Eigen::Index a, Eigen::Index b) {
    block.gaps.push_back({.left = a, .right = b, .stretch = {}});
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    if (i % across + 1 < across) join(i, i + 1);
    if (i + across < count) join(i, i + across);
    if (i % across + 1 < across && i + across < count) join(i, i + across + 1);
  }
  const std::vector<MassPlaces> choices = mass_choices(block);
  EXPECT_EQ(choices.size(), 24U);
  for (const PlanGap& gap : block.gaps) {
    std::set<std::pair<int, int>> seen = {{-1, -1}};
    for (const MassPlaces& one : choices) seen.insert({one[gap.left], one[gap.right]});
    const bool has_wall = gap.left == 5 || gap.right == 5;
    EXPECT_EQ(seen.size(), has_wall ? 5U : 25U) << gap.left << ' ' << gap.right;
  }
  block.elsewhere.clear();
  EXPECT_TRUE(mass_choices(block).empty());
}

/// Eight that all face one another need more columns than 25 runs have.
TEST(MassesElsewhere, TakeALongerArrayWhereAllAreNeighbours) {
  constexpr Eigen::Index count = 8;
  PlanProblem block;
  block.buildings.resize(count);
  block.elsewhere.assign(count, std::vector<PlanBuilding>(4));
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) block.gaps.push_back({.left = a, .right = b, .stretch = {}});
  }
  const std::vector<MassPlaces> choices = mass_choices(block);
  EXPECT_EQ(choices.size(), 124U);
  for (const PlanGap& gap : block.gaps) {
    std::set<std::pair<int, int>> seen = {{-1, -1}};
    for (const MassPlaces& one : choices) seen.insert({one[gap.left], one[gap.right]});
    EXPECT_EQ(seen.size(), 25U);
  }
}

}  // namespace
}  // namespace bentur
