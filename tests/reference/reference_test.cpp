// The cases of ../shared/reference against the answers of an independent program, and their energy accounts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/pounding/pounding.h"
#include "tests/reference/shared_folder.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const char* const loosen = BENTUR_SOURCE_DIR "/tests/reference/loosen.py";
const fs::path shared = test::shared_folder();

const char* const all_cases[] = {"absolute-delay",
                                 "bilinear",
                                 "darmawan-lumped-frames",
                                 "free-impact",
                                 "friction-pendulum",
                                 "hertz-damp",
                                 "hinges/hinges-oscase",
                                 "hinges/hinges-p-delta",
                                 "hinges/hinges-pair",
                                 "hinges/hinges-plastic-mechanism",
                                 "hinges/hinges-portal",
                                 "hinges/hinges-resonance",
                                 "hinges/hinges-wall",
                                 "hinges/hinges-wall-elastic",
                                 "isolated-frame",
                                 "isolated-moat",
                                 "jankowski",
                                 "kelvin-voigt-approach",
                                 "kelvin-voigt-creep",
                                 "kelvin-voigt-separation",
                                 "kelvin-voigt-zero-force",
                                 "link-cable",
                                 "link-damper",
                                 "m12-el-centro-gap-02",
                                 "m12-el-centro-gap-04",
                                 "m12-el-centro-touching",
                                 "m12-harmonic-gap-02",
                                 "m12-uncondensed",
                                 "matrices-unequal-heights",
                                 "p-delta",
                                 "p-delta-collapse",
                                 "restitution",
                                 "row-of-three-sticks",
                                 "slab-column",
                                 "soil-p-delta-yield",
                                 "soil-pair",
                                 "three-and-two-storeys-undamped",
                                 "unequal-bays",
                                 "yield-bilinear-pair",
                                 "yield-peak-oriented",
                                 "yield-with-contact-row"};

class Reference : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(shared)) GTEST_SKIP() << "the reference cases (../shared) are not here";
    Diagnostics diagnostics;
    case_ = read_case(shared / "reference" / (name_ + ".toml"), diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
    ASSERT_TRUE(case_);
    problem_ = make_problem(*case_);
  }

  /// It came to its end, or to the collapse that is expected.
  [[nodiscard]] bool completed(const Response& response) const {
    return response.status == (name_ == "p-delta-collapse" ? Status::collapsed : Status::done);
  }

  /// Whether the independent program's comparison agrees, with its relative tolerances times `factor`.
  void judge(const Response& response, const std::string& solver, int factor) const {
    ASSERT_TRUE(completed(response)) << response.message;
    const auto file = [&](const std::string& kind) {
      const std::string stem = fs::path(name_).filename().string();
      return fs::path(BENTUR_BINARY_DIR) / ("reference-" + stem + "-" + solver + kind + ".json");
    };
    std::ofstream(file("")) << summary_json(run_results(*case_, problem_, response), "test");
    run(loosen, {(shared / "reference" / (name_ + ".expected.json")).string(), std::to_string(factor),
                 file("-expected").string()});
    run((shared / "tools/compare.py").string(), {file("-expected").string(), file("").string()});
  }

  /// Every contact law of the case has straight branches, or takes no time.
  [[nodiscard]] bool piecewise_linear() const {
    const std::set<std::string_view> nonlinear = {"darmawan", "hertz", "hertz-damp", "jankowski"};
    return std::none_of(problem_.points.begin(), problem_.points.end(),
                        [&](const ContactPoint& point) { return nonlinear.count(point.law->name()) > 0; });
  }

  [[nodiscard]] Response audited(const Solver& solver) const {
    SolveOptions options;
    options.energy_audit = true;
    options.output_step = problem_.duration / 64;  // so that the last sample is the end
    return solve(problem_, solver, options);
  }

  const std::string name_ = GetParam();
  std::optional<Case> case_;
  Problem problem_;

 private:
  static void run(const std::string& script, const std::vector<std::string>& arguments) {
    std::string command = "python3 '" + script + "'";
    for (const std::string& argument : arguments) command += " '" + argument + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  }
};

TEST_P(Reference, ExactAgreesWithTheIndependentProgram) { judge(solve(problem_), "exact", 1); }

TEST_P(Reference, AdaptiveAgreesWithTheIndependentProgramToTenTolerances) {
  judge(solve(problem_, AdaptiveSolver{}), "adaptive", 10);
}

/// The account closes, and what contact has lost is what the list of impacts says.
void expect_account(const Response& response, double duration, double limit) {
  ASSERT_TRUE(response.energy);
  const EnergyAudit& account = *response.energy;
  ASSERT_GT(account.peak_input, 0);
  EXPECT_LE(account.relative_residual(), limit);
  double lost = 0;
  for (const Impact& impact : response.impacts) lost += impact.energy_lost;
  // What collapses between two samples has its last impact before.
  const double until = response.collapse ? response.collapse->time / duration : 1;
  ASSERT_EQ(account.histories.contact_lost.size(), 1 + std::floor(64 * until));
  // Both are integrals of the same expansions by Gauss's rule, of 15 points in the account and of 7 or more in the
  // list; what they differ by is bounded like the residual.
  EXPECT_NEAR(account.histories.contact_lost.tail(1)(0) / account.peak_input, lost / account.peak_input, 1e-9);
}

TEST_P(Reference, ExactAccountsForAllEnergy) {
  const Response response = audited(ExactSolver{});
  expect_account(response, problem_.duration, piecewise_linear() ? 1e-9 : 1e-8);
  test::expect_same(response, solve(problem_));
}

TEST_P(Reference, AdaptiveAccountsForAllEnergy) {
  const Response response = audited(AdaptiveSolver{});
  expect_account(response, problem_.duration, 1e-8);
  test::expect_same(response, solve(problem_, AdaptiveSolver{}));
}

INSTANTIATE_TEST_SUITE_P(, Reference, testing::ValuesIn(all_cases), [](const auto& test) {
  std::string name = fs::path(test.param).filename().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ReferenceCases, EveryOneIsInTheListAbove) {
  if (!fs::exists(shared)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  std::set<std::string> there;
  for (const std::string folder : {"", "hinges/"}) {
    for (const auto& entry : fs::directory_iterator(shared / "reference" / folder)) {
      if (entry.path().extension() == ".toml") there.insert(folder + entry.path().stem().string());
    }
  }
  EXPECT_EQ(there, std::set<std::string>(std::begin(all_cases), std::end(all_cases)));
}

}  // namespace
}  // namespace bentur
