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

/// Two rows of four houses, and some of them this much farther to the right.
PlanRun block(const std::set<Eigen::Index>& moved = {}, double way = 0) {
  std::string text = R"(
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
)";
  for (int n = 0; n < 8; ++n) {
    text += fmt::format(
        "[[building]]\nname = \"H{}\"\ndamping = 0.05\nplan = {{ corner = [{}, {}], size = [10.0, 12.0], "
        "storey_heights = [3.0], masses = [100.0] }}\nrigidity = {{ centre = [5.0, 6.0], x = 2e4, y = 2e4, "
        "torsion = 1e6 }}\n",
        n + 1, 10.02 * (n % 4) + (moved.count(n) > 0 ? way : 0), n < 4 ? 0 : 12.03);
  }
  return test::plan_run(text);
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

}  // namespace
}  // namespace bentur
