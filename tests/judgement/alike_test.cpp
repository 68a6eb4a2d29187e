#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/story/story.h"

namespace bentur {
namespace {

/// Two houses 5 cm apart, the second of this period [s].
RunResults houses(double period) {
  const std::string text = fmt::format(R"(
units = {{ length = "m", force = "kN" }}
excitation = {{ kind = "record", file = "el-centro-1940-ns.csv", unit = "g" }}
building = [
  {{ name = "A", damping = 0.05, generic = {{ storeys = 1, storey_height = 3.0, floor_mass = 100.0, period = 0.3, stiffness_ratio = 30.0 }} }},
  {{ name = "B", damping = 0.05, generic = {{ storeys = 1, storey_height = 3.0, floor_mass = 100.0, period = {}, stiffness_ratio = 30.0 }} }},
]
gap = [{{ between = ["A", "B"], width = 0.05, contact = {{ law = "linear", stiffness = 1e5 }} }}]
)",
                                       period);
  Diagnostics diagnostics;
  auto c = read_case_text(text, std::string(BENTUR_SOURCE_DIR) + "/data/case.toml", diagnostics);
  Problem problem = make_problem(*c);
  Response response = solve(problem, c->analysis.solver, solve_options(*c));
  return run_results(std::move(*c), std::move(problem), std::move(response));
}

bool says_alike(const RunResults& run) {
  const std::vector<Statement> all = run_story(run).statements;
  return std::any_of(all.begin(), all.end(), [](const Statement& one) { return one.kind == "move_alike"; });
}

double needed(const RunResults& run) { return run.response.points.front().gap_needed; }

/// Twins need nothing as long as they are twins: that is said beside "enough", and of others it is not.
TEST(BuildingsThatMoveAlike, AreSaidToNeedMoreAsSoonAsTheyDiffer) {
  const RunResults twins = houses(0.3), softer = houses(0.3 / std::sqrt(0.9)), others = houses(0.4);
  EXPECT_TRUE(says_alike(twins));
  EXPECT_LT(needed(twins), 1e-12);
  EXPECT_GT(needed(softer), 0.1 * softer.response.points.front().peak_left);
  EXPECT_FALSE(says_alike(others));
}

}  // namespace
}  // namespace bentur
