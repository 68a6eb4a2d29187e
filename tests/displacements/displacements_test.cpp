#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

/// Two buildings of which another program has found the displacements, in mm; the lower one ends between two floors
/// of the other.
std::string case_text(double width, const std::string& first = "", const std::string& code = "") {
  return R"(
[units]
length = "mm"
force = "kN"
[[building]]
name = "Tall"
displacements = { elevations = [4000, 8000, 12000], u = [10, 20, 30])" +
         first + R"( }
[[building]]
name = "Low"
displacements = { elevations = [4000, 10000], u = [15, 40], period = 0.8, damping_ratio = 0.05 }
[[gap]]
between = ["Tall", "Low"]
width = )" +
         std::to_string(width) + R"(
[excitation]
kind = "displacements"
)" + code;
}

const std::string with_period = ", period = 1.0, damping_ratio = 0.05";

struct Read {
  Case c;
  Problem problem;
  SpectralGaps gaps;
};

Read read_whole(const std::string& text) {
  Diagnostics diagnostics;
  const auto c = read_case_text(text, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  if (!c) return {};
  const Problem problem = make_still_problem(*c);
  return {*c, problem, spectral_gaps(problem, *c->excitation.spectrum, c->code, c->units)};
}

std::vector<std::string> errors_of(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_case_text(text, "case.toml", diagnostics));
  std::vector<std::string> rules;
  for (const Diagnostic& one : diagnostics.errors()) rules.push_back(one.text());
  return rules;
}

std::string changed(std::string text, const std::string& old, const std::string& made) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), made);
}

TEST(Displacements, AreCombinedAtEveryLevelWhereTheBuildingsFaceOneAnother) {
  const Read read = read_whole(case_text(100, with_period));
  ASSERT_EQ(read.gaps.levels.size(), 3U);  // 4 m, 8 m where Low has 31.67 mm between floors, 10 m where Tall has 25
  const double low = 15 + 25 * 4000.0 / 6000, tall = 25;
  EXPECT_NEAR(read.gaps.levels[0].abs, 10 + 15, 1e-9);
  EXPECT_NEAR(read.gaps.levels[1].abs, 20 + low, 1e-9);
  EXPECT_NEAR(read.gaps.levels[2].abs, tall + 40, 1e-9);
  EXPECT_NEAR(read.gaps.levels[2].srss, std::hypot(tall, 40), 1e-9);
  const double rho = 0.16563;  // of 1 s and 0.8 s, 5 % damped: docs/separation-rules.md
  EXPECT_NEAR(read.gaps.levels[2].ddc, std::sqrt(tall * tall + 1600 - 2 * rho * tall * 40), 1e-3);
  EXPECT_NEAR(read.gaps.levels[2].gap_needed, tall + 40, 1e-9) << "both at once";
}

TEST(Displacements, DdcNeedsThePeriodsOfBoth) {
  const Read read = read_whole(case_text(100));
  for (const LevelSeparation& level : read.gaps.levels) EXPECT_TRUE(std::isnan(level.ddc));
  const auto found = rule_findings(read.problem, read.gaps.levels, read.c.code, 0, false, false);
  EXPECT_EQ(found.at(2).silence, RuleFinding::Silence::periods);
}

TEST(Displacements, RulesThatAmplifyTakeThemAsGiven) {
  const Read read = read_whole(case_text(200, with_period + ", amplification = 4",
                                         "[code]\nsame_owner = true\nrpa-2024 = {}\nasce-7-16 = { "
                                         "deflection_amplification = [4, 1], importance_factor = 1 }\n"));
  const LevelSeparation& top = read.gaps.levels.back();
  EXPECT_NEAR(top.abs, 4 * 25 + 40, 1e-9);
  EXPECT_EQ(top.codes[0].rule, "asce-7-16");
  EXPECT_NEAR(top.codes[0].gap, std::hypot(4 * 25, 40), 1e-9);
  EXPECT_NEAR(top.codes[1].gap, std::hypot(4 * 25, 40), 1e-9) << "what is expected, which the case makes of u";
}

TEST(Displacements, AreEnoughWhereBothAtOnceAre) {
  const std::string rule = "[code]\nsame_owner = true\nrpa-2024 = {}\n";
  const auto judged = [&](double width) {
    const Read read = read_whole(case_text(width, with_period, rule));
    return judged_gaps(read.c, read.problem, read.gaps).at(0).judgement;
  };
  EXPECT_TRUE(judged(65.001).is_enough());
  const Judgement between = judged(64.9);
  EXPECT_EQ(between.value, Sufficiency::unknown);
  ASSERT_EQ(between.reasons.size(), 1U);
  EXPECT_EQ(between.reasons[0].kind, Reason::Kind::phase);
  EXPECT_NEAR(between.reasons[0].value, 65, 1e-9);
  EXPECT_EQ(judged(47.1).value, Sufficiency::too_small) << "less than RPA's √(25² + 40²) = 47.17";
}

TEST(Displacements, AreToldAsSuch) {
  const Read read = read_whole(case_text(60, with_period));
  const Story story = spectral_story(read.c, read.problem, read.gaps);
  std::vector<std::string> kinds;
  for (const Statement& one : story.statements) kinds.push_back(one.kind);
  EXPECT_NE(std::find(kinds.begin(), kinds.end(), "not_known"), kinds.end());
  EXPECT_NE(std::find(kinds.begin(), kinds.end(), "given_peaks"), kinds.end());
  for (const StoryTable& table : story.tables) {
    for (const StoryColumn& column : table.columns) EXPECT_NE(column.label, "spectral.difference");
  }
  const auto json = nlohmann::json::parse(spectral_gap_json(read.c, read.problem, read.gaps, "1"));
  EXPECT_EQ(json["excitation"]["kind"], "displacements");
  EXPECT_EQ(json["buildings"][0]["given"]["displacements"], (std::vector<double>{10, 20, 30}));
  EXPECT_EQ(json["gaps"][0]["judgement"]["value"], "not known");
}

TEST(Displacements, OfANeighbourStandBesideABuildingUnderASpectrum) {
  const std::string text = R"(
[units]
length = "mm"
force = "kN"
[[building]]
name = "Computed"
damping = 0.05
stick = { storey_heights = [4000, 4000], masses = [0.2, 0.2], stiffnesses = [100, 100] }
[[building]]
name = "Known"
displacements = { elevations = [4000, 8000], u = [15, 40] }
[[building]]
name = "Wall"
rigid = true
elevations = [0, 5000]
[[gap]]
between = ["Computed", "Known"]
width = 100
[[gap]]
between = ["Known", "Wall"]
width = 100
[excitation]
kind = "spectrum"
shape = "asce-7-22"
short_period = 1.0
one_second = 0.6
long_period = 8
reduction = [2, 1, 1]
[code]
asce-7-16 = { deflection_amplification = 2, importance_factor = 1 }
)";
  const Read read = read_whole(text);
  ASSERT_EQ(read.gaps.levels.size(), 5U);  // two, and at 0, 4 and 5 m beside the wall
  const double computed = read.gaps.peaks[0].cqc(1);
  EXPECT_GT(computed, 10);
  EXPECT_NEAR(read.gaps.levels[1].abs, computed + 40, 1e-9);
  EXPECT_NEAR(read.gaps.levels[1].codes[0].to_left.value(), computed, 1e-9) << "reduced by 2, amplified by 2";
  EXPECT_NEAR(read.gaps.levels[1].codes[0].to_right.value(), 80, 1e-9);
  EXPECT_NEAR(read.gaps.levels[2].abs, 0, 1e-12) << "at its foot";
  EXPECT_NEAR(read.gaps.levels[4].abs, 15 + 25 * 0.25, 1e-9) << "at 5 m";
  EXPECT_TRUE(judged_gaps(read.c, read.problem, read.gaps).at(1).judgement.is_enough());
}

TEST(Displacements, AreRefusedWhereSomethingIsToBeSolved) {
  const std::string text = case_text(100);
  EXPECT_THROW((void)make_problem(read_whole(text).c), InvalidParameter);
  EXPECT_THROW((void)solve(read_whole(text).problem, ExactSolver{}), InvalidParameter);
  const auto found = errors_of(changed(text, "kind = \"displacements\"",
                                       "kind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 1\n[analysis]\n"
                                       "duration = 1"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("known by its displacements alone"), std::string::npos) << found[0];
}

TEST(Displacements, SayWhatIsWrong) {
  const auto has = [](const std::vector<std::string>& all, const std::string& part) {
    for (const std::string& one : all) {
      if (one.find(part) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(has(errors_of(changed(case_text(9), "u = [10, 20, 30]", "u = [10, 20]")), "has 2 entries, expected 3"));
  EXPECT_TRUE(has(errors_of(changed(case_text(9), "u = [10, 20, 30]", "u = [10, -20, 30]")), "u[1] = -20"));
  EXPECT_TRUE(has(errors_of(case_text(9, ", period = 1")), "damping_ratio is missing"));
  EXPECT_TRUE(has(errors_of(case_text(9, ", damping_ratio = 0.05")), "goes with period"));
  EXPECT_TRUE(has(errors_of(changed(case_text(9), "[excitation]\nkind = \"displacements\"", "")),
                  "excitation is missing (kind = \"displacements\" where nothing is to be computed)"));
  EXPECT_TRUE(has(errors_of(changed(case_text(9), "name = \"Low\"", "name = \"Low\"\ndamping = 0.05")),
                  "damping is not for a building known by its displacements"));
  EXPECT_TRUE(has(
      errors_of(changed(case_text(9), "[excitation]", "contact = { law = \"linear\", stiffness = 1 }\n[excitation]")),
      "contact is not for a building known by its displacements"));
  EXPECT_TRUE(
      has(errors_of(changed(case_text(9),
                            "displacements = { elevations = [4000, 10000], u = [15, 40], period = "
                            "0.8, damping_ratio = 0.05 }",
                            "damping = 0.05\nstick = { storey_heights = [4000], masses = [1], stiffnesses = [1] }")),
          "has none; kind = \"spectrum\""));
}

}  // namespace
}  // namespace bentur
