#include "bentur/model/plan/plan_places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// Houses in plan, whatever stands there moves little.
PlanRun houses(const std::string& all) {
  return test::plan_run(R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.2
contact = { law = "linear", stiffness = 4e5 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.001
[analysis]
duration = 0.1
)" + all);
}

/// @param outline "size = [10.0, 12.0]", or a polygon
std::string house(int number, double x, double y, const std::string& outline = "size = [10.0, 12.0]") {
  return fmt::format(
      "[[building]]\nname = \"H{}\"\ndamping = 0.05\nplan = {{ corner = [{}, {}], {}, storey_heights = [3.0], "
      "masses = [100.0] }}\nrigidity = {{ centre = [5.0, 6.0], x = 2e4, y = 2e4, torsion = 1e6 }}\n",
      number, x, y, outline);
}

/// Two rows of four houses, and some of them this much farther to the right.
PlanRun block(const std::set<Eigen::Index>& moved = {}, double way = 0) {
  std::string all;
  for (int n = 0; n < 8; ++n) {
    all += house(n + 1, 10.02 * (n % 4) + (moved.count(n) > 0 ? way : 0), n < 4 ? 0 : 12.03);
  }
  return houses(all);
}

std::size_t gap_of(const PlanProblem& problem, const std::string& name) {
  const std::vector<std::string> names = gap_names(problem);
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// All gaps along the line of one become wider with it, so that none closes.
TEST(PlanPlaces, WhoIsBeyondAGapMovesWithoutComingNearerToAnyone) {
  const PlanRun before = block();
  const std::size_t gap = gap_of(before.problem, "H2 | H3");
  ASSERT_LT(gap, before.problem.gaps.size());
  const std::vector<Eigen::Index> beyond = buildings_beyond(before.problem, gap);
  EXPECT_EQ(beyond, (std::vector<Eigen::Index>{2, 3, 6, 7}));
  constexpr double way = 0.05;
  const std::set<Eigen::Index> moved(beyond.begin(), beyond.end());
  const PlanRun after = block(moved, way);
  const std::vector<std::string> names = gap_names(after.problem);
  ASSERT_EQ(names, gap_names(before.problem));
  for (std::size_t g = 0; g < names.size(); ++g) {
    const PlanGap& was = before.problem.gaps[g];
    if (was.stretch.is_corner()) continue;
    const bool widens = moved.count(was.left) != moved.count(was.right);
    EXPECT_NEAR(after.problem.gaps[g].stretch.width, was.stretch.width + (widens ? way : 0), 1e-9) << names[g];
  }
}

/// H3 is nobody's neighbour, and in the way; H4 is beside the way.
TEST(PlanPlaces, WhoIsMetBeyondAGapMovesToo) {
  const PlanRun run = houses(house(1, 0, 0) + house(2, 10.02, 0) + house(3, 20.52, 11.0) + house(4, 20.52, 24.0));
  ASSERT_EQ(run.problem.gaps.size(), 1U);
  const std::vector<Eigen::Index> beyond = buildings_beyond(run.problem, 0);
  EXPECT_EQ(beyond, (std::vector<Eigen::Index>{1, 2}));
  EXPECT_FALSE(first_in_the_way(run.problem, 0, beyond));
}

/// H1 turns round H2 on three sides: its arm, 25 m to the right, stays where it is.
TEST(PlanPlaces, WhoStaysIsMetAfterTheWayBetween) {
  const std::string arms =
      "polygon = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [25.0, 20.0], [25.0, 5.0], [10.0, 5.0], [10.0, 20.0], "
      "[0.0, 20.0]]";
  const PlanRun run = houses(house(1, 0, 0, arms) + house(2, 10.02, 6.0));
  for (std::size_t gap = 0; gap < run.problem.gaps.size(); ++gap) {
    if (run.problem.gaps[gap].stretch.n.x() < 0.9) continue;
    const std::vector<Eigen::Index> beyond = buildings_beyond(run.problem, gap);
    ASSERT_EQ(beyond, (std::vector<Eigen::Index>{1}));
    const auto met = first_in_the_way(run.problem, gap, beyond);
    ASSERT_TRUE(met);
    EXPECT_EQ(met->building, 0);
    EXPECT_NEAR(met->way, 25.0 - 20.02, 1e-9);
    return;
  }
  FAIL() << "no gap across x";
}

}  // namespace
}  // namespace bentur
