// Remedies against brute force and plain runs.
#include "bentur/study/remedy/remedy.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "bentur/io/temporary_folder.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/modes.h"
#include "bentur/study/remedy/optimiser.h"
#include "bentur/study/remedy/remedy_story.h"
#include "bentur/study/study_output.h"

namespace bentur {
namespace {

/// Two sticks, apart by 2 cm, with a damper at each floor; and foam in place of a contact, if `contact` says so.
std::string case_of(const std::string& contact) {
  return fmt::format(R"(
[units]
length = "m"
force = "kN"
[[building]]
name = "West"
damping = 0.03
stick = {{ storey_heights = [3, 3], masses = [60, 50], stiffnesses = [30e3, 25e3] }}
[[building]]
name = "East"
damping = 0.03
stick = {{ storey_heights = [3, 3], masses = [40, 35], stiffnesses = [60e3, 50e3] }}
[[gap]]
between = ["West", "East"]
width = 0.02
contact = {}
[[link]]
between = ["West", "East"]
elevations = [3.0]
law = "spring-dashpot"
damping = 1.0
[[link]]
between = ["West", "East"]
elevations = [6.0]
law = "spring-dashpot"
damping = 1.0
[excitation]
kind = "harmonic"
period = 0.45
displacement_amplitude = 0.02
[analysis]
duration = 3.0
)",
                     contact);
}

constexpr const char* spring = R"({ law = "linear", stiffness = 2e5 })";
constexpr const char* dampers = R"(
[[vary]]
parameter = "link[0].damping"
name = "lower"
from = 1
to = 3000
[[vary]]
parameter = "link[1].damping"
name = "upper"
from = 1
to = 3000
)";
constexpr const char* both_ways = R"(
[[vary]]
parameter = "excitation.period"
values = [0.4, 0.55]
)";

class Remedies : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_optimiser()) GTEST_SKIP() << "built without NLopt";
    put("case.toml", case_of(spring));
  }

  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

  [[nodiscard]] std::filesystem::path study(const std::string& text) const {
    put("study.toml", "case = 'case.toml'\n" + text);
    return folder_.path() / "study.toml";
  }
  [[nodiscard]] RemedySearch found(const std::string& text, const RemedyOptions& options = {}) const {
    Diagnostics diagnostics;
    auto search = seek_remedy(study(text), options, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    return std::move(search.value());
  }
  [[nodiscard]] std::string errors(const std::string& text) const {
    Diagnostics diagnostics;
    EXPECT_FALSE(seek_remedy(study(text), {}, diagnostics).has_value());
    std::string all;
    for (const Diagnostic& one : diagnostics.errors()) all += one.message() + "\n";
    return all;
  }
  /// Of a plain run of the case with these values put in as a user would.
  [[nodiscard]] static Response run_with(const RemedySearch& search, const std::vector<double>& values) {
    TomlValue root = search.study.case_root;
    std::size_t i = 0;
    for (const Vary& vary : search.study.varies) {
      if (!vary.sought) continue;
      const double value = values[i++];
      put_value(root, vary.path, vary.factor ? toml_number(value * vary.original.real) : toml_number(value), 0);
    }
    Diagnostics diagnostics;
    const std::string name = "case.toml";
    const ReadCase read = read_case_parts(TomlView(root, "", name, diagnostics), "", diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    return solve(make_problem(read.c), read.c.analysis.solver);
  }
  [[nodiscard]] static std::set<std::string> kinds_of(const RemedySearch& search) {
    std::set<std::string> all;
    for (const Statement& one : remedy_story(search).statements) all.insert(one.kind);
    return all;
  }
  [[nodiscard]] static double hardest(const Response& response) {
    double most = 0;
    for (const PointSummary& point : response.points) most = std::max(most, point.peak_force);
    return most;
  }
  [[nodiscard]] static double needed(const Response& response) {
    double most = 0;
    for (const PointSummary& point : response.points) most = std::max(most, point.gap_needed);
    return most;
  }

  const TemporaryFolder folder_;
};

TEST_F(Remedies, TwoDampersAreAsGoodAsBruteForceFinds) {
  // With as many evaluations as a study has that does not say.
  const RemedySearch search = found("[remedy]\nobjective = 'gap_needed'\n" + std::string(dampers));
  ASSERT_LE(search.trials.size(), 200U);
  const RemedyTrial& best = *search.best();
  double brute = INFINITY;
  constexpr int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      brute = std::min(brute, needed(run_with(search, {1 + 2999.0 * i / steps, 1 + 2999.0 * j / steps})));
    }
  }
  EXPECT_LE(best.objective, 1.01 * brute);
  EXPECT_LT(best.objective, 0.8 * search.trials.front().objective);
  EXPECT_EQ(needed(run_with(search, best.values)), best.objective);
}

TEST_F(Remedies, TheSmallestOfTwoDampersKeepsTheLimitAsBruteForceDoes) {
  const std::string text = "[remedy]\nobjective = 'gap_needed'\nlimit = 0.05\nevaluations = 300\n";
  const RemedySearch search = found(text + dampers);
  const RemedyTrial& smallest = *search.smallest();
  EXPECT_LE(needed(run_with(search, smallest.values)), 0.05);
  double brute = INFINITY;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Response response = run_with(search, {1 + 2999.0 * i / steps, 1 + 2999.0 * j / steps});
      if (needed(response) <= 0.05) brute = std::min(brute, 0.5 * (i + j) / steps);
    }
  }
  ASSERT_TRUE(std::isfinite(brute));
  EXPECT_LE(smallest.size, brute * 1.01);
  EXPECT_GT(search.trials.front().objective, 0.05);
}

TEST_F(Remedies, TheLeastGapIsThatWhichIsNeeded) {
  const RemedySearch search = found(
      "[remedy]\nobjective = 'impacts'\nlimit = 0\nevaluations = 60\n"
      "[[vary]]\nparameter = 'gap[0].width'\nfrom = 0\nto = 0.4\n");
  const RemedyTrial& smallest = *search.smallest();
  const double width = needed(run_with(search, smallest.values));
  EXPECT_GE(smallest.values[0], width);
  EXPECT_LE(smallest.values[0], width + 1e-3 * 0.4);
  EXPECT_EQ(run_with(search, smallest.values).impacts.size(), 0U);
}

TEST_F(Remedies, AFillerIsSizedForTheHardestImpactOfAllRecords) {
  put("case.toml", case_of("{ law = 'filler', crushing_force = 50, thickness = 0.02, crushing_strain = 0.03, "
                           "locking_strain = 0.6, locked_stiffness = 1e6 }"));
  const RemedySearch search =
      found("[remedy]\nobjective = 'peak_force'\nlimit = 600\nevaluations = 150\n" + std::string(both_ways) +
            "[[vary]]\nparameter = 'gap[0].contact.thickness'\nfrom = 0.02\nto = 0.5\n"
            "[[vary]]\nparameter = 'gap[0].contact.crushing_force'\nfrom = 50\nto = 500\n");
  EXPECT_EQ(search.runs_each, 2U);
  EXPECT_GT(search.trials.front().objective, 600);
  ASSERT_NE(search.smallest(), nullptr);
  // The largest over both periods, by plain runs.
  double most = 0;
  for (const double period : {0.4, 0.55}) {
    RemedySearch one = search;
    put_value(one.study.case_root, {"excitation", "period"}, toml_number(period), 0);
    most = std::max(most, hardest(run_with(one, search.smallest()->values)));
  }
  EXPECT_EQ(most, search.smallest()->objective);
  EXPECT_LE(most, 600);
}

TEST_F(Remedies, SaysWhenNoneSufficesAndWhatLiesAtABound) {
  // Stiffer alone, the two need less; how much, nobody lets it try.
  const RemedySearch search = found(
      "[remedy]\nobjective = 'gap_needed'\nlimit = 1e-4\nevaluations = 40\n"
      "[[vary]]\nparameter = 'building[0].stick.stiffnesses'\nfactor = true\nfrom = 1\nto = 1.2\n");
  EXPECT_EQ(search.smallest(), nullptr);
  EXPECT_EQ(remedy_story(search).statements.front().kind, "remedy_none");
  EXPECT_EQ(kinds_of(search).count("remedy_at_bound"), 1U);
  EXPECT_NEAR(search.best()->values[0], 1.2, 1e-3);
}

TEST_F(Remedies, ABuildingIsSizedToAPeriodFromItsOwnOn) {
  const RemedySearch search = found(
      "[remedy]\nobjective = 'gap_needed'\nevaluations = 40\n"
      "[[vary]]\nparameter = 'building[\"West\"].calibrate_period'\nfrom = 0.3\nto = 0.6\n");
  Diagnostics diagnostics;
  const ReadCase bare =
      read_case_parts(TomlView(search.study.case_root, "", "case.toml", diagnostics), "", diagnostics);
  const Problem problem = make_problem(bare.c);
  const double own = modal_properties(problem.buildings[0]).periods(0);
  ASSERT_TRUE(own > 0.3 && own < 0.6) << own;
  EXPECT_NEAR(search.trials.front().values[0], own, 1e-12);
  EXPECT_NEAR(search.trials.front().objective, needed(solve(problem, bare.c.analysis.solver)), 1e-9);
  EXPECT_EQ(search.trials.front().size, 0);
  EXPECT_EQ(needed(run_with(search, search.best()->values)), search.best()->objective);
  EXPECT_LT(search.best()->objective, search.trials.front().objective);
}

TEST_F(Remedies, NothingIsNeededWhereTheCaseKeepsTheLimit) {
  const RemedySearch search =
      found("[remedy]\nobjective = 'gap_needed'\nlimit = 10\nevaluations = 20\n" + std::string(dampers));
  EXPECT_EQ(search.smallest(), &search.trials.front());
  EXPECT_EQ(search.trials.front().values, (std::vector<double>{1, 1}));
  EXPECT_EQ(kinds_of(search).count("remedy_not_needed"), 1U);
}

TEST_F(Remedies, AStoppedSearchGoesOnToTheSameEnd) {
  for (const char* const objective : {"gap_needed", "base_shear_coefficient"}) {
    const std::string text =
        fmt::format("[remedy]\nobjective = '{}'\nevaluations = 40\n", objective) + both_ways + dampers;
    const RemedySearch whole = found(text);
    RemedyOptions options;
    options.journal = folder_.path() / (std::string(objective) + ".part");
    options.goes_on = [](double part) { return part < 0.3; };
    const RemedySearch part = found(text, options);
    EXPECT_TRUE(part.stopped);
    EXPECT_EQ(part.trials.size(), 12U);
    EXPECT_EQ(kinds_of(part).count("remedy_stopped"), 1U);
    options.goes_on = {};
    Diagnostics diagnostics;
    EXPECT_THROW((void)seek_remedy(study(text), options, diagnostics), std::runtime_error);  // there, and not to resume
    options.resume = true;
    int asked_early = 0;
    options.goes_on = [&](double done) {
      asked_early += done < 0.3 ? 1 : 0;
      return true;
    };
    const RemedySearch rest = found(text, options);
    if (whole.with_slopes == 0) {  // what was tried is not run again; derivatives are
      EXPECT_EQ(asked_early, 0);
    }
    EXPECT_FALSE(rest.stopped);
    EXPECT_EQ(remedy_json(rest, "1"), remedy_json(whole, "1"));
    EXPECT_EQ(whole.with_slopes > 0, std::string(objective) == "gap_needed");
  }
}

/// That a search takes the larger need of both directions of the motion of a case, [analysis] of which comes last.
/// @param reversed the same with the motion reversed
void expect_both_directions(const std::function<RemedySearch(const std::string&)>& of, const std::string& text,
                            const std::string& reversed) {
  const RemedySearch both = of(text);
  EXPECT_EQ(both.runs_each, 2U);
  EXPECT_TRUE(both.both_ways);
  const RemedySearch one = of(text + "both_ways = false\n");
  EXPECT_EQ(one.runs_each, 1U);
  EXPECT_FALSE(one.both_ways);
  const RemedySearch other = of(reversed + "both_ways = false\n");
  ASSERT_NE(one.trials.at(0).objective, other.trials.at(0).objective);
  EXPECT_DOUBLE_EQ(both.trials.at(0).objective, std::max(one.trials[0].objective, other.trials[0].objective));
}

/// Of a push to one side, and of a harmonic motion, which begins with a jump to one side.
TEST_F(Remedies, GapsNeededAreThoseOfBothDirections) {
  const auto of = [&](const std::string& text) {
    put("case.toml", text);
    return found("[remedy]\nobjective = 'gap_needed'\nevaluations = 10\n" + std::string(dampers));
  };
  const auto with_polarity = [](std::string text, const std::string& before) {
    return text.insert(text.find(before) + before.size(), "\npolarity = 'reversed'");
  };
  const std::string harmonic = case_of(spring);
  std::string pushed = harmonic;
  const std::size_t motion = pushed.find("[excitation]"), analysis = pushed.find("[analysis]");
  pushed.replace(
      motion, analysis - motion,
      "[excitation]\nkind = 'record'\ntime_step = 0.1\nvalues = [0, 3, 3, 3, 0, -1, -1, 0, 0]\nunit = 'm/s2'\n");
  expect_both_directions(of, pushed, with_polarity(pushed, "unit = 'm/s2'"));
  expect_both_directions(of, harmonic, with_polarity(harmonic, "period = 0.45"));
}

/// A choice that keeps a limit by numbers that may not hold says so first.
TEST_F(Remedies, AnInputInDoubtIsSaid) {
  const std::string asked =
      "[remedy]\nobjective = 'peak_force'\nlimit = 1e9\nevaluations = 10\n" + std::string(dampers);
  const auto with = [&](const std::string& amplitude) {
    std::string text = case_of(spring);
    const std::string given = "displacement_amplitude = 0.02";
    put("case.toml", text.replace(text.find(given), given.size(), amplitude));
    return found(asked);
  };
  const RemedySearch doubted = with("acceleration_amplitude = 0.3");
  EXPECT_EQ(remedy_story(doubted).statements.front().kind, "remedy_open");
  EXPECT_EQ(nlohmann::json::parse(remedy_json(doubted, "1"))["smallest"]["not_known"], 1);
  const RemedySearch known = with("acceleration_amplitude = '0.3 g'");
  EXPECT_EQ(kinds_of(known).count("remedy_open"), 0U);
  EXPECT_EQ(nlohmann::json::parse(remedy_json(known, "1"))["smallest"]["not_known"], 0);
}

TEST_F(Remedies, RefuseWhatMakesNoSense) {
  const std::string near = errors("[remedy]\nobjective = 'gap_neded'\nlimit = -1\n" + std::string(dampers));
  EXPECT_NE(near.find("did you mean \"gap_needed\""), std::string::npos) << near;
  EXPECT_NE(near.find("remedy.limit"), std::string::npos) << near;
  const std::string from = errors(
      "[remedy]\nobjective = 'peak_force'\n[[vary]]\nparameter = 'link[0].damping'\nfrom = 0\nto = 2\nspacing = "
      "'log'\n");
  EXPECT_EQ(from.find("needs a [[vary]]"), std::string::npos) << from;
  EXPECT_NE(errors("[remedy]\nobjective = 'pek_force'\n" + std::string(dampers)).find("did you mean \"peak_force\""),
            std::string::npos);
  EXPECT_NE(errors("[remedy]\nobjective = 'peak_force'\n" + std::string(both_ways)).find("needs a [[vary]] with from"),
            std::string::npos);
  EXPECT_NE(
      errors("[remedy]\nobjective = 'peak_force'\n[sampling]\nmethod = 'sobol'\ncount = 4\n" + std::string(dampers))
          .find("does not go with [remedy]"),
      std::string::npos);
  EXPECT_NE(errors(both_ways).find("[remedy] is missing"), std::string::npos);
  EXPECT_NE(errors("[remedy]\nobjective = 'peak_force'\n[[vary]]\nparameter = 'link[0].damping'\nfrom = -3\nto = 2\n")
                .find("must be"),
            std::string::npos);
  Diagnostics diagnostics;
  EXPECT_EQ(checked_runs(study("[remedy]\nobjective = 'peak_force'\n" + std::string(dampers)), StudyKind::sweep,
                         "bentur ", diagnostics),
            nullptr);
}

}  // namespace
}  // namespace bentur
