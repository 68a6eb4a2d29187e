// The least gap of a case, confirmed by runs with it.
#include "bentur/study/remedy/least_gap.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

/// Two sticks whose upper floors do not meet: the lower one's roof faces a column.
std::string case_of(double width, const std::string& excitation, const std::string& more = "") {
  return fmt::format(R"(
[units]
length = "m"
force = "kN"
[[building]]
name = "West"
damping = 0.03
p_delta = true
stick = {{ storey_heights = [3, 3, 3], masses = [60, 60, 50], stiffnesses = [30e3, 25e3, 25e3]{} }}
[[building]]
name = "East"
damping = 0.03
stick = {{ storey_heights = [3, 4], masses = [40, 35], stiffnesses = [60e3, 50e3] }}
[[gap]]
between = ["West", "East"]
width = {:.17g}
contact = {{ law = "linear", stiffness = 2e5 }}
{}
)",
                     more, width, excitation);
}

constexpr const char* shaken = R"([excitation]
kind = "harmonic"
period = 0.45
displacement_amplitude = 0.02
[analysis]
duration = 3.0)";

class LeastGapOf : public testing::Test {
 protected:
  [[nodiscard]] Case case_with(const std::string& text) const {
    std::ofstream(folder_.path() / "case.toml") << text;
    Diagnostics diagnostics;
    auto read = read_case(folder_.path() / "case.toml", diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    return std::move(read.value());
  }
  [[nodiscard]] static RunResults run(const Case& c) {
    Problem problem = make_problem(c);
    Response response = solve(problem, c.analysis.solver, solve_options(c));
    return run_results(c, std::move(problem), std::move(response));
  }
  static std::string kind_of(const LeastGaps& found) { return least_gap_story(found).statements.front().kind; }

  const TemporaryFolder folder_;
};

TEST(RoundedUp, HasThreeFiguresAndIsNeverLess) {
  EXPECT_EQ(rounded_up(0.2109), 0.211);
  EXPECT_EQ(rounded_up(0.211), 0.211);
  EXPECT_EQ(rounded_up(0.99901), 1.0);
  EXPECT_EQ(rounded_up(123.01), 124);
  EXPECT_EQ(rounded_up(12341), 12400);
  EXPECT_EQ(rounded_up(0), 0);
  for (double x = 1e-6; x < 1e6; x *= 1.037) {
    EXPECT_GE(rounded_up(x), x);
    EXPECT_LE(rounded_up(x), x * 1.0101);
  }
}

TEST_F(LeastGapOf, AMotionKeepsTheBuildingsApartBothWaysRoundAndALittleLessDoesNot) {
  const LeastGaps found = least_gaps(run(case_with(case_of(0.01, shaken))));
  ASSERT_EQ(found.gaps.size(), 1U);
  const LeastGap& gap = found.gaps[0];
  EXPECT_TRUE(found.both_ways);
  EXPECT_TRUE(gap.is_short);
  EXPECT_EQ(gap.given, 0.01);
  EXPECT_EQ(kind_of(found), "least_gap_short");
  // A run with it: no impact, and no floor in a column.
  const RunResults apart = run(case_with(case_of(gap.width, shaken)));
  EXPECT_EQ(apart.response.impacts.size(), 0U);
  ASSERT_FALSE(apart.response.watched.empty());
  for (const WatchedSummary& floor : apart.response.watched) EXPECT_FALSE(floor.closes);
  const LeastGaps again = least_gaps(apart);
  EXPECT_FALSE(again.gaps[0].is_short);
  EXPECT_EQ(again.gaps[0].needed, gap.needed);
  EXPECT_EQ(kind_of(again), "least_gap_enough");
  EXPECT_TRUE(least_gaps(run(case_with(case_of(gap.needed * (1 - 1e-6), shaken)))).gaps[0].is_short);
}

TEST_F(LeastGapOf, ASpectrumIsItsLargestDifference) {
  const Case c = case_with(case_of(
      0.01,
      "[excitation]\nkind = 'spectrum'\nshape = 'table'\nperiods = [0, 3]\naccelerations = [0.3, 0.3]\nunit = 'g'"));
  const Problem problem = make_still_problem(c);
  const SpectralGaps spectral = spectral_gaps(problem, *c.excitation.spectrum, c.code, c.units);
  double most = 0;
  for (const LevelSeparation& one : spectral.levels) most = std::max(most, one.gap_needed);
  const LeastGaps found = least_gaps(c, problem, spectral);
  EXPECT_EQ(found.gaps[0].needed, most);
  EXPECT_FALSE(found.both_ways);
  EXPECT_EQ(kind_of(found), "least_gap_spectrum_short");  // a mean: nobody is said to stay apart
  LeastGaps wide = found;
  wide.gaps[0].is_short = false;
  wide.gaps[0].judged = Sufficiency::enough;
  EXPECT_EQ(kind_of(wide), "least_gap_spectrum");
}

// What keeps a gap from being known to be enough, and what rules ask beyond it, is said beside its least width.
TEST_F(LeastGapOf, AGapThatIsTooSmallKeepsItsDoubtsAndRules) {
  LeastGaps found{.title = "", .units = {.length = "m"}, .buildings = {"A", "B"}};
  found.gaps = {{.name = "A | B", .left = 0, .right = 1, .is_facing = true, .needed = 0.0113, .width = 0.0113}};
  LeastGap& gap = found.gaps.front();
  gap.judged = Sufficiency::too_small;
  gap.is_short = true;
  const auto word = [&](const std::string& name) {
    const Story story = least_gap_story(found);
    for (const StoryValue& value : story.statements.front().values) {
      if (value.name == name) return std::get<std::string>(value.value);
    }
    return std::string("none");
  };
  EXPECT_EQ(word("doubt") + word("rules"), "");
  gap.is_doubted = true;
  gap.asked = 0.2;
  EXPECT_EQ(kind_of(found), "least_gap_short");
  EXPECT_EQ(word("doubt"), "story.least_gap_more");
  EXPECT_EQ(word("rules"), "story.least_gap_asked");
  gap.asked = 0.01;  // less than what the motion needs
  EXPECT_EQ(word("rules"), "");
  gap.is_known = false;
  gap.is_beside = true;
  EXPECT_EQ(kind_of(found), "least_gap_beside");
}

TEST_F(LeastGapOf, OfAGapBesideOneThatClosesItIsSaidWhetherItIsTooSmall) {
  const std::string third = R"(
[[building]]
name = "Far"
damping = 0.03
stick = { storey_heights = [3, 4], masses = [40, 35], stiffnesses = [50e3, 40e3] }
[[gap]]
between = ["East", "Far"]
width = )";
  const auto story_of = [&](double first, const std::string& second) {
    return least_gap_story(least_gaps(run(
        case_with(case_of(first, third + second + "\ncontact = { law = \"linear\", stiffness = 2e5 }\n" + shaken)))));
  };
  const Story small = story_of(0.01, "0.01");
  EXPECT_EQ(small.statements.front().kind, "least_gap_alone_small");
  const Story wide = story_of(2.0, "0.01");
  const auto of_first =
      std::find_if(wide.statements.begin(), wide.statements.end(), [](const Statement& one) { return one.gap == 0; });
  ASSERT_NE(of_first, wide.statements.end());
  EXPECT_EQ(of_first->kind, "least_gap_alone");
}

TEST_F(LeastGapOf, NothingIsKnownWhereABuildingCollapses) {
  const std::string weak = ", backbone = { yield = 20, plastic_drift = 0.001, softening_drift = 0.002 }";
  const LeastGaps found = least_gaps(run(case_with(case_of(0.01, shaken, weak))));
  ASSERT_FALSE(found.gaps[0].is_known);
  EXPECT_EQ(kind_of(found), "least_gap_unknown");
  const auto json = nlohmann::json::parse(least_gap_json(found, "0"));
  EXPECT_TRUE(json["gaps"][0]["least_gap"].is_null());
  EXPECT_NE(json["gaps"][0]["judgement"], "enough");
  EXPECT_NE(json["gaps"][0]["too_narrow"], false);
}

/// GB 50011 asks for 100 mm at least, more than the buildings need and less than they have.
TEST_F(LeastGapOf, ARuleThatAsksForMoreIsSaidBesideWhatIsGiven) {
  const std::string code = "\n[code]\nsame_owner = true\ngb-50011-2010 = { intensity = 8, system = \"frame\" }\n";
  std::string quiet = shaken;
  quiet.replace(quiet.find("0.02"), 4, "0.002");
  const LeastGaps found = least_gaps(run(case_with(case_of(2.0, quiet) + code)));
  ASSERT_EQ(found.gaps.size(), 1U);
  EXPECT_LT(found.gaps[0].width, 0.1);
  ASSERT_TRUE(found.gaps[0].asked.has_value());
  EXPECT_GE(*found.gaps[0].asked, 0.1);
  const Statement said = least_gap_story(found).statements.at(0);
  EXPECT_TRUE(std::any_of(said.values.begin(), said.values.end(), [](const StoryValue& one) {
    const auto* const word = std::get_if<std::string>(&one.value);
    return one.name == "rules" && word != nullptr && *word == "story.least_gap_asked";
  })) << said.kind;
}

}  // namespace
}  // namespace bentur
