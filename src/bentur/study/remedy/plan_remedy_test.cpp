// Remedies for buildings in plan, confirmed by plain runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/study/remedy/least_gap.h"
#include "bentur/study/remedy/objective_slopes.h"
#include "bentur/study/remedy/optimiser.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/remedy/remedy_story.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

/// A building with a wall along one side, and an even one `gap` east of it. @param north of the side without a wall
std::string case_of(double gap, double north) {
  return fmt::format(R"(
[plan]
clearance = 0.50
contact = {{ law = "linear", stiffness = 4e5 }}
[[building]]
name = "Walled"
damping = 0.05
plan = {{ corner = [0, 0], size = [12, 18], storey_heights = [3.5, 3.2], masses = [200, 180] }}
[[building.plane]]
along = "x"
at = 0.0
stiffnesses = [9e4, 9e4]
[[building.plane]]
along = "x"
at = 18.0
stiffnesses = [{1:.17g}, {1:.17g}]
[[building.plane]]
along = "y"
at = 6.0
stiffnesses = [4e4, 4e4]
[[building]]
name = "Even"
damping = 0.05
plan = {{ corner = [{0:.17g}, 0], size = [15, 18], storey_heights = [3.5, 3.2], masses = [250, 220] }}
rigidity = {{ centre = [7.5, 9], x = 1.2e5, y = 1.2e5, torsion = 1.2e7 }}
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
[analysis]
duration = 3.0
)",
                     12 + gap, north);
}

class PlanRemedies : public testing::Test {
 protected:
  [[nodiscard]] PlanRun run(double gap, double north) const {
    Diagnostics diagnostics;
    MadeParts made;
    PlanProblem& problem = made.plan;
    const auto c = read_case_text(case_of(gap, north), folder_.path() / "case.toml", diagnostics, &made);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    PlanResponse response = solve(problem, c->analysis.solver, {.levels = true, .both_ways = true});
    return {*c, std::move(problem), std::move(response)};
  }
  [[nodiscard]] RemedySearch found(const std::string& study) const {
    std::ofstream(folder_.path() / "case.toml") << case_of(0.02, 2e4);
    std::ofstream(folder_.path() / "study.toml") << "case = 'case.toml'\n" << study;
    Diagnostics diagnostics;
    auto search = seek_remedy(folder_.path() / "study.toml", {}, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    return std::move(search.value());
  }
  [[nodiscard]] static double hardest(const PlanRun& run) {
    double most = 0;
    for (const PointSummary& point : run.response.points) most = std::max(most, point.peak_force);
    return most;
  }

  const TemporaryFolder folder_;
};

TEST_F(PlanRemedies, TheLeastGapKeepsThemApartAndALittleLessDoesNot) {
  const LeastGaps found = least_gaps(run(0.02, 2e4));
  ASSERT_EQ(found.gaps.size(), 1U);
  const LeastGap& gap = found.gaps[0];
  EXPECT_EQ(gap.name, "Walled | Even");
  EXPECT_TRUE(gap.is_short);
  EXPECT_NEAR(gap.given, 0.02, 1e-12);
  const PlanRun apart = run(gap.width, 2e4);
  EXPECT_TRUE(apart.response.impacts.empty());
  EXPECT_EQ(least_gap_story(least_gaps(apart)).statements.front().kind, "least_gap_enough");
  EXPECT_TRUE(least_gaps(run(gap.needed * (1 - 1e-6), 2e4)).gaps[0].is_short);
}

/// Of contacts, of centres of mass and of edges, which lie elsewhere in what was found.
TEST_F(PlanRemedies, SlopesAreThoseOfTheObjectiveByDifferences) {
  std::ofstream(folder_.path() / "case.toml") << case_of(0.02, 2e4);
  for (const std::string objective :
       {"gap_needed", "peak_force", "peak_displacement_north_no_contact", "peak_displacement_north"}) {
    SCOPED_TRACE(objective);
    std::ofstream(folder_.path() / "study.toml")
        << "case = 'case.toml'\n[remedy]\nobjective = '" + objective + "'\nevaluations = 10\n" +
               "[[vary]]\nparameter = 'building[0].plane[1].stiffnesses'\nfrom = 2e4\nto = 9e4\n" +
               "[[vary]]\nparameter = 'building[1].plan.corner[0]'\nfrom = 12.01\nto = 12.05\n";
    Diagnostics diagnostics;
    const std::optional<Study> read = read_study(folder_.path() / "study.toml", diagnostics);
    ASSERT_TRUE(read && diagnostics.ok()) << diagnostics.errors().front().text();
    const auto memo = std::make_shared<CaseMemo>();
    const std::optional<StudyFacts> facts = check_study(*read, *memo, diagnostics);
    ASSERT_TRUE(diagnostics.ok()) << diagnostics.errors().front().text();
    std::vector<RowPart> of;
    for (const RowPart& part : quantities_of(*facts)) {
      if (is_quantity(part.name, objective) && part.building == 0)
        of.push_back(part);  // the other one hangs on neither
    }
    ASSERT_FALSE(of.empty());
    const ObjectiveSlopes slopes(of, *read, {0, 1}, memo);
    ASSERT_TRUE(slopes.may_be());
    const std::vector<std::size_t> first = {0};
    const auto largest = [&](double stiffness, double corner) {
      const std::vector<double> places = {stiffness, corner};
      const auto parts = slopes.parts(StudyRuns(chosen_study(*read, places), *facts, memo, slopes.at(places))
                                          .solve(first, [] { return true; })[0]
                                          .values);
      return *std::max_element(parts.begin(), parts.end(),
                               [](const auto& a, const auto& b) { return a.value < b.value; });
    };
    constexpr double h = 1e-5;  // its square, of u
    const FunctionPart here = largest(0.4, 0.3);
    const double by_stiffness = (largest(0.4 + h, 0.3).value - largest(0.4 - h, 0.3).value) / (2 * h);
    const double by_corner = (largest(0.4, 0.3 + h).value - largest(0.4, 0.3 - h).value) / (2 * h);
    const double most = std::max(std::abs(by_stiffness), std::abs(by_corner));
    EXPECT_GT(most, 0);
    EXPECT_NEAR(here.slope[0], by_stiffness, 1e-5 * most);
    EXPECT_NEAR(here.slope[1], by_corner, 1e-5 * most);
  }
}

TEST_F(PlanRemedies, ASideIsStiffenedUntilTheBuildingTurnsNoMore) {
  if (!has_optimiser()) GTEST_SKIP() << "built without NLopt";
  const std::string study =
      "[remedy]\nobjective = 'peak_force'\nevaluations = 40\n"
      "[[vary]]\nparameter = 'building[0].plane[1].stiffnesses'\nfrom = 2e4\nto = 9e4\n"
      "[[vary]]\nparameter = 'excitation.period'\nvalues = [0.45, 0.5, 0.6]\n";
  const RemedySearch search = found(study);
  EXPECT_EQ(search.buildings, (std::vector<std::string>{"Walled", "Even"}));
  EXPECT_EQ(search.runs_each, 3U);
  EXPECT_LT(search.best()->objective, search.trials.front().objective);
  double most = 0;
  for (const double period : {0.45, 0.5, 0.6}) {
    PlanRun one = run(0.02, search.best()->values[0]);
    MadeParts made;
    Diagnostics diagnostics;
    std::string text = case_of(0.02, search.best()->values[0]);
    text.replace(text.find("period = 0.5"), 12, fmt::format("period = {}", period));
    const auto c = read_case_text(text, folder_.path() / "case.toml", diagnostics, &made);
    one.problem = std::move(made.plan);
    one.response = solve(one.problem, c->analysis.solver, {.levels = true});
    most = std::max(most, hardest(one));
  }
  EXPECT_EQ(most, search.best()->objective);
}

}  // namespace
}  // namespace bentur
