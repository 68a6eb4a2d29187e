// The cases of ../shared/reference/plan against the answers of an independent program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "tests/reference/shared_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path plan_folder = test::shared_folder() / "reference" / "plan";
const std::set<std::string> cases = {"plan-asymmetric-pair", "plan-symmetric", "plan-friction", "plan-l-of-three"};
// Its edges touch at rest, and push from the start on, as they do without friction. The answers have three of four ends
// begin 4e-6 s later, where δ, which grows as t⁴, leaves their round-off: durations may be so much longer.
const std::string touches_at_rest = "plan-yielding-planes";

void judge_plan(const std::string& name, const Solver& solver, int factor) {
  SCOPED_TRACE(name + ", " + std::string(bentur::name(solver)));
  Diagnostics diagnostics;
  const auto c = read_case(plan_folder / (name + ".toml"), diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  ASSERT_TRUE(c);
  const PlanProblem problem = make_plan_problem(*c);
  const PlanResponse response = solve(problem, solver, {.energy_audit = true});
  ASSERT_EQ(response.status, Status::done) << response.message;
  EXPECT_LE(response.energy->relative_residual(), factor > 1 ? 1e-8 : 1e-12);
  const std::string stem =
      (fs::path(BENTUR_BINARY_DIR) / ("reference-" + name)).string() + std::string(bentur::name(solver));
  std::ofstream(stem + ".json") << summary_json({*c, problem, response}, "test");
  const auto run = [](const std::string& command) { EXPECT_EQ(std::system(command.c_str()), 0) << command; };
  std::string expected = (plan_folder / (name + ".expected.json")).string();
  if (name == touches_at_rest) {
    nlohmann::json answers = nlohmann::json::parse(std::ifstream(expected));
    auto& points = answers.at("gaps").at(0).at("points");
    for (std::size_t n = 0; n < points.size(); ++n) {
      const double later = response.points.at(n).contact_duration - points[n].at("contact_duration").get<double>();
      EXPECT_NEAR(later, 2.5e-6, 2.5e-6) << n;
      points[n].erase("contact_duration");
    }
    expected = stem + "-answers.json";
    std::ofstream(expected) << answers;
  }
  run("python3 '" BENTUR_SOURCE_DIR "/tests/reference/loosen.py' '" + expected + "' " + std::to_string(factor) + " '" +
      stem + "-expected.json'");
  run("python3 '" + (plan_folder / "../../tools/compare.py").string() + "' '" + stem + "-expected.json' '" + stem +
      ".json'");
}

TEST(PlanReference, AgreesWithTheIndependentProgram) {
  if (!fs::exists(plan_folder)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  for (const std::string& name : cases) judge_plan(name, ExactSolver{}, 1);
  judge_plan(touches_at_rest, ExactSolver{}, 1);
}

TEST(PlanReference, AdaptiveAgreesToTenTolerances) {
  if (!fs::exists(plan_folder)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  // Not plan-symmetric: of its ends one touches first by the solver's tolerance, and a force that jumps then turns the
  // floor for that long.
  judge_plan("plan-asymmetric-pair", AdaptiveSolver{}, 10);
}

TEST(PlanReference, LeavesNoCaseOut) {
  if (!fs::exists(plan_folder)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  for (const auto& entry : fs::directory_iterator(plan_folder)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(cases.count(name) > 0 || name == touches_at_rest) << name << " is in no list above";
  }
}

}  // namespace
}  // namespace bentur
