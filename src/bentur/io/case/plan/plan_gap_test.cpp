// What is told of the gaps of buildings in plan: needs at points and at both ends of what is watched, rules of codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/story.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

using nlohmann::json;

/// B has floors at 3.5, 5.5 and 7.7, A at 3.5 and 6.7, the wall above A at 3.5.
const std::string three_in_plan = R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.1
contact = { law = "linear", stiffness = 4e5 }
[[building]]
name = "A"
damping = 0.05
plan = { corner = [0, 0], size = [12, 18], storey_heights = [3.5, 3.2], masses = [200, 180] }
plane = [{ along = "x", at = 0.5, stiffnesses = 9e4 }, { along = "x", at = 17, stiffnesses = 2e4 },
         { along = "y", at = 1, stiffnesses = 6e4 }, { along = "y", at = 11, stiffnesses = 6e4 }]
[[building]]
name = "B"
damping = 0.05
plan = { corner = [12.02, 4], size = [9, 20], storey_heights = [3.5, 2.0, 2.2], masses = [100, 90, 80] }
plane = [{ along = "x", at = 1, stiffnesses = 5e4 }, { along = "x", at = 18, stiffnesses = 6e4 },
         { along = "y", at = 4, stiffnesses = 6e4 }]
[[building]]
name = "W"
rigid = true
elevations = [3.5]
plan = { corner = [2, 18.01], size = [6, 1] }
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

std::vector<std::string> plan_gap_errors(const std::string& text) {
  Diagnostics diagnostics;
  (void)read_case_text(text, "a.toml", diagnostics);
  std::vector<std::string> errors;
  for (const Diagnostic& error : diagnostics.errors()) errors.push_back(error.message());
  return errors;
}

std::string with_piece(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

bool story_tells(const Story& story, const std::string& kind) {
  return std::any_of(story.statements.begin(), story.statements.end(),
                     [&](const Statement& one) { return one.kind == kind; });
}

// The free response knows of no contact: floors that are watched alone need what they need with it.
TEST(PlanGaps, APairWithoutContactIsWatchedAtAllItsFloors) {
  const PlanRun with = test::told_plan_run(three_in_plan);
  const std::string none = "[[gap]]\nbetween = [\"A\", \"B\"]\nelevations = []\n";
  const PlanRun run = test::told_plan_run(with_piece(three_in_plan, "[excitation]", none + "[excitation]"));
  ASSERT_EQ(run.problem.gaps.size(), 2U);
  const PlanGap& gap = run.problem.gaps[0];
  EXPECT_TRUE(gap.contacts.empty());
  ASSERT_EQ(gap.watched.size(), 6U);
  EXPECT_EQ(gap.watched[0].elevation, 3.5);
  EXPECT_TRUE(gap.watched[0].facing_floor);
  for (const std::size_t i : {0U, 1U}) {
    const double needed = with.response.points[i].gap_needed;
    EXPECT_GT(needed, 0);
    EXPECT_NEAR(run.response.watched[i].gap_needed, needed, 1e-12);
  }
  for (const std::size_t i : {2U, 3U, 4U, 5U}) {
    EXPECT_NEAR(run.response.watched[i].gap_needed, with.response.watched[i - 2].gap_needed, 1e-12);
  }
}

TEST(PlanGaps, WatchBothEndsOfWhatFacesAnEdge) {
  const PlanRun run = test::told_plan_run(three_in_plan);
  ASSERT_EQ(run.problem.gaps.size(), 2U);
  const PlanGap& gap = run.problem.gaps[0];
  ASSERT_EQ(gap.watched.size(), 4U);
  for (const std::size_t i : {0U, 1U, 2U, 3U}) {
    EXPECT_EQ(gap.watched[i].floor_of, i < 2 ? 1 : 0);
    EXPECT_EQ(gap.watched[i].elevation, i < 2 ? 5.5 : 6.7);
    EXPECT_EQ(gap.watched[i].floor, 1);
    EXPECT_FALSE(gap.watched[i].facing_floor);
    EXPECT_EQ(gap.watched[i].along, i % 2 == 0 ? 4 : 18);
  }
  EXPECT_TRUE(run.problem.gaps[1].watched.empty());
  // Levels that a case leaves out are watched against each other.
  const std::string low = "[[gap]]\nbetween = [\"B\", \"A\"]\nlevel_tolerance = 1.1\nelevations = [3.5]\n";
  const PlanRun left_out = test::told_plan_run(with_piece(three_in_plan, "[excitation]", low + "[excitation]"));
  const std::vector<PlanWatched>& watched = left_out.problem.gaps[0].watched;
  ASSERT_EQ(watched.size(), 4U);  // 5.5 of B, and 6.7 with 7.7
  EXPECT_EQ(watched[2].floor_of, 0);
  EXPECT_EQ(watched[2].facing_floor, 2);
  EXPECT_NEAR(watched[2].elevation, 7.2, 1e-14);
}

TEST(PlanGaps, TellWhatIsNeededOfPointsAndOfWhatIsWatched) {
  const PlanRun run = test::told_plan_run(three_in_plan);
  const json summary = json::parse(summary_json(run, "test")), told = json::parse(gap_json(run, "test"));
  for (const std::size_t g : {0U, 1U}) {
    const json &gap = summary["gaps"][g], &of_gap = told["gaps"][g];
    double needed = 0, reversed = 0;
    for (const char* const list : {"points", "watched_floors"}) {
      ASSERT_EQ(gap[list].size(), of_gap[list].size());
      for (std::size_t i = 0; i < gap[list].size(); ++i) {
        const json &level = gap[list][i], &same = of_gap[list][i];
        needed = std::max(needed, level["gap_needed"].get<double>());
        reversed = std::max(reversed, level["gap_needed_reversed"].get<double>());
        EXPECT_EQ(level["at"], same["at"]);
        EXPECT_EQ(level["gap_needed"], same["gap_needed"]);
        const double left = level["peak_left_no_contact"], right = level["peak_right_no_contact"];
        EXPECT_DOUBLE_EQ(same["abs"], left + right);
        EXPECT_DOUBLE_EQ(same["srss"], std::hypot(left, right));
        EXPECT_TRUE(same["ddc"].is_null());
        // Two that move by themselves need no more than both together.
        EXPECT_LE(level["gap_needed"].get<double>(), (left + right) * (1 + 1e-12));
        EXPECT_GT(left + right, 0);
      }
    }
    EXPECT_EQ(gap["gap_needed"], needed);
    EXPECT_EQ(gap["gap_needed_reversed"], reversed);
    EXPECT_EQ(of_gap["gap_needed"], needed);
    EXPECT_EQ(of_gap["rules"][2]["rule"], "ddc");
    EXPECT_EQ(of_gap["rules"][2]["given_is"], "not_evaluated");
    EXPECT_EQ(of_gap["rules"][2]["reason"], "turning");
    EXPECT_EQ(of_gap["screening"].size(), gap["between"][1] == "W" ? 0U : 8U);
  }
  EXPECT_EQ(summary["gaps"][0]["watched_floors"][0]["faces"], "edge");
  EXPECT_EQ(summary["gaps"][0]["watched_floors"][3]["at"], json({12.01, 18}));
  EXPECT_EQ(summary["gaps"][1]["watched_floors"], json::array());
}

/// Of the case above by hand: floors of A at 3.5 and 6.7 m, of B at 3.5, 5.5 and 7.7 m.
TEST(PlanGaps, AreScreenedWithTheirEccentricities) {
  const auto screened = [](const std::string& text) {
    std::map<std::string, json> by_rule;
    const json told = json::parse(gap_json(test::told_plan_run(text), "test"));
    for (const json& gap : told["gaps"]) {
      for (const json& one : gap["screening"]) by_rule.emplace(one["rule"], one);
    }
    return by_rule;
  };
  const auto without = screened(three_in_plan);
  ASSERT_EQ(without.size(), 8U);
  EXPECT_NEAR(without.at("floors-meet")["value"].get<double>(), 1.2, 1e-12);  // 6.7 against 5.5 m
  EXPECT_EQ(without.at("storeys-apart")["value"], 1);
  EXPECT_EQ(without.at("end-of-row")["verdict"], "does not apply");  // a wall makes no row
  EXPECT_EQ(without.at("gap-per-storey")["verdict"], "needs screening.seismicity");
  EXPECT_NEAR(without.at("mass-ratio")["value"].get<double>(), 380.0 / 270, 1e-12);
  // A: held along x at 0.5 and 17 m by 9 to 2, its middle at 9 m of 18; B 1 and 18 m by 5 to 6 of 20, and at 4 of 9 m.
  const double of_a = 100 * (9 - (9 * 0.5 + 2 * 17) / 11) / 18, of_b = 100 * (10 - (5.0 + 6 * 18) / 11) / 20;
  EXPECT_GT(of_a, std::fmax(std::abs(of_b), 100 * 0.5 / 9));
  EXPECT_NEAR(without.at("eccentricity")["value"].get<double>(), of_a, 1e-10);
  EXPECT_EQ(without.at("eccentricity")["limit"], 20);
  EXPECT_EQ(without.at("eccentricity")["verdict"], "attention");
  const auto with =
      screened(with_piece(three_in_plan, "[excitation]", "[screening]\nseismicity = \"high\"\n[excitation]"));
  EXPECT_NEAR(with.at("gap-per-storey")["limit"].get<double>(), 2 * 1.5 * 0.0254, 1e-12);
  EXPECT_NEAR(with.at("gap-per-height")["value"].get<double>(), 100 * 0.02 / 6.7, 1e-10);
  EXPECT_EQ(with.at("pounding")["verdict"], "attention");  // too narrow, and floors do not meet
}

/// A third one behind A makes a row that B ends; one beside A, in the corner, does not.
TEST(PlanGaps, ABuildingBehindAnotherMakesARow) {
  const auto ends = [](const std::string& corner) {
    const std::string third = "[[building]]\nname = \"C\"\ndamping = 0.05\nplan = { corner = " + corner +
                              ", size = [12, 18], storey_heights = [3.5, 3.2], masses = [200, 180] }\n"
                              "rigidity = { centre = [6, 9], x = 9e4, y = 9e4, torsion = 9e6 }\n";
    const json told = json::parse(gap_json(test::told_plan_run(with_piece(three_in_plan, "[[building]]\nname = \"W\"",
                                                                          third + "[[building]]\nname = \"W\"")),
                                           "test"));
    for (const json& gap : told["gaps"]) {
      if (gap["between"] == json({"A", "B"})) return gap["screening"][2]["verdict"].get<std::string>();
    }
    return std::string("no gap");
  };
  EXPECT_EQ(ends("[-12.02, 0]"), "attention");
  EXPECT_EQ(ends("[0, -18.02]"), "does not apply");
}

TEST(PlanGaps, RulesOfCodesTakeTheMovementOfEachPlaceAcrossTheGap) {
  const std::string code =
      "[code]\nen-1998-1 = { behaviour_factor = [2, 3, 1] }\nsame_owner = [true, false]\nfloors_aligned = [false, "
      "true]\n";
  const PlanRun run = test::told_plan_run(with_piece(three_in_plan, "[excitation]", code + "[excitation]"));
  const json summary = json::parse(summary_json(run, "test")), told = json::parse(gap_json(run, "test"));
  for (const char* const list : {"points", "watched_floors"}) {
    for (std::size_t i = 0; i < 2; ++i) {
      const json& level = summary["gaps"][0][list][i];
      const double left = level["peak_left_no_contact"], right = level["peak_right_no_contact"];
      EXPECT_DOUBLE_EQ(told["gaps"][0][list][i]["codes"][0]["gap"], std::hypot(2 * left, 3 * right));
    }
  }
  // Across a property line, where the floors of the wall have one of A each: 0.7 q u.
  for (std::size_t i = 0; i < 2; ++i) {
    const double moves = summary["gaps"][1]["points"][i]["peak_left_no_contact"];
    const json& asked = told["gaps"][1]["points"][i]["codes"][0];
    EXPECT_GT(moves, 1e-4);
    EXPECT_EQ(summary["gaps"][1]["points"][i]["peak_right_no_contact"], 0);
    EXPECT_DOUBLE_EQ(asked["gap"], 0.7 * 2 * moves);
    EXPECT_DOUBLE_EQ(asked["to_property_line"][0], 0.7 * 2 * moves);
  }
  EXPECT_EQ(plan_gap_errors(
                with_piece(three_in_plan, "[excitation]",
                           "[code]\nen-1998-1 = { behaviour_factor = [2, 3] }\nsame_owner = [true]\n[excitation]")),
            (std::vector<std::string>{"code.en-1998-1.behaviour_factor has 2 entries, expected 3 (one per building)",
                                      "code.same_owner has 1 entry, expected 2 (one per gap)"}));
}

TEST(PlanGaps, RulesFromHeightsAlone) {
  const std::string code = "[code]\ngb-50011-2010 = { intensity = 8, system = \"frame\" }\n";
  Diagnostics diagnostics;
  const auto c =
      read_case_text(with_piece(three_in_plan, "[excitation]", code + "[excitation]"), "a.toml", diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  ASSERT_TRUE(c);
  const PlanProblem problem = make_plan_problem(*c);
  const json told = json::parse(height_rules_json(*c, problem, "test"));
  ASSERT_EQ(told["gaps"].size(), 2U);
  const json& rule = told["gaps"][0]["rules"][0];
  EXPECT_DOUBLE_EQ(rule["gap"], 0.1);  // up to 15 m
  EXPECT_EQ(rule["given_is"], "too_small");
  EXPECT_EQ(rule["levels"].size(), 6U);
  EXPECT_TRUE(story_tells(height_rules_story(*c, problem), "rules_short"));
}

TEST(PlanGaps, SayWhereAFloorMeetsAnEdge) {
  PlanRun run = test::told_plan_run(three_in_plan);
  const bool meets = std::any_of(run.response.watched.begin(), run.response.watched.end(),
                                 [](const WatchedSummary& one) { return one.closes; });
  ASSERT_TRUE(meets);
  const Story story = run_story(run);
  EXPECT_TRUE(story_tells(story, "unmodelled"));
  const json gap = json::parse(summary_json(run, "test"))["gaps"][0];
  EXPECT_EQ(gap["unmodelled_contacts"], gap["unmodelled_contact"].size());
  ASSERT_GT(gap["unmodelled_contact"].size(), 0U);
  EXPECT_NE(gap["unmodelled_contact"][0]["to_model"].get<std::string>().find("strikes_columns"), std::string::npos);
  // Far enough apart nothing meets, and the need is told of the place that governs.
  const std::string apart = with_piece(three_in_plan, "corner = [12.02, 4]", "corner = [12.45, 4]");
  const PlanRun far = test::told_plan_run(with_piece(apart, "clearance = 0.1", "clearance = 0.5"));
  EXPECT_FALSE(story_tells(run_story(far), "unmodelled"));
  // The other gap closes, so that this is not what would do.
  EXPECT_TRUE(story_tells(gap_story(far), "gap_need_alone"));
  run.row.reset();  // which was made of the whole response
  run.response.watched.clear();
  EXPECT_THROW((void)row_of(run), InvalidParameter);
}

/// Corner to corner they touch where both edges close; the motion is along x alone, so that along y there is no need.
TEST(PlanGaps, KnowOfEdgesThatNeverCloseTogetherOnlyABound) {
  const auto bounds = [](const std::string& corner) {
    const PlanRun run = test::told_plan_run(with_piece(R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.1
contact = { law = "linear", stiffness = 4e5 }
[[building]]
name = "A"
damping = 0.05
plan = { corner = [0, 0], size = [10, 10], storey_heights = [3], masses = [100] }
rigidity = { centre = [5, 5], x = 4e4, y = 4e4, torsion = 2e6 }
[[building]]
name = "B"
damping = 0.05
plan = { corner = [10.03, CORNER], size = [10, 10], storey_heights = [3], masses = [100] }
rigidity = { centre = [5, 5], x = 9e4, y = 9e4, torsion = 4e6 }
[excitation]
kind = "harmonic"
period = 0.3
displacement_amplitude = 0.02
[analysis]
duration = 2
)",
                                                       "CORNER", corner));
    const Story story = gap_story(run);
    std::vector<std::size_t> rows;
    for (const StoryTable& table : story.tables) {
      for (const StoryColumn& column : table.columns) {
        if (column.label == "column.recorded" || column.label == "column.simulated")
          rows.insert(rows.end(), column.at_most.begin(), column.at_most.end());
      }
    }
    EXPECT_EQ(story_tells(story, "needs_at_most"), !rows.empty());
    return rows;
  };
  EXPECT_FALSE(bounds("10.03").empty());
  EXPECT_TRUE(bounds("0").empty());
}

/// What is unusual of levels that meet, as of rows.
TEST(PlanGaps, AreRemarkedOnAsThoseOfRows) {
  const auto remarked = [](const std::string& text, const std::string& key) {
    Diagnostics diagnostics;
    const auto c = read_case_text(text, "a.toml", diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
    for (const Remark& one : remarks(*c, make_plan_problem(*c))) {
      if (one.key == key && one.subject == "A | B") return one.value;
    }
    return 0.0;
  };
  const std::string near = three_in_plan + "[[gap]]\nbetween = [\"A\", \"B\"]\nlevel_tolerance = 1.0\n";
  EXPECT_EQ(remarked(three_in_plan, "level_tolerance"), 0);
  EXPECT_NEAR(remarked(near, "level_tolerance"), 1.0, 1e-12);  // 7.7 and 6.7 m
  const std::string pushed = three_in_plan + "[initial]\ndisplacements = { A = [[0.05, 0, 0], [0.0, 0, 0]] }\n";
  EXPECT_EQ(remarked(three_in_plan, "initial_overlap"), 0);
  EXPECT_NEAR(remarked(pushed, "initial_overlap"), 0.05 - 0.02, 1e-12);
  const std::string touching = with_piece(three_in_plan, "corner = [12.02, 4]", "corner = [12, 4]");
  EXPECT_EQ(remarked(touching, "soft_contact"), 0);
  EXPECT_GT(remarked(with_piece(touching, "stiffness = 4e5", "stiffness = 4e4"), "soft_contact"), 0.1);
}

/// Two floors with 0.1 m in common, of which one slides past the other: the numbers of docs/theory/plan.md.
TEST(PlanGaps, SayWhatSlipsOff) {
  const std::string soft = "rigidity = { centre = [5, 5], x = 1e-4, y = 1e-4, torsion = 1e-4 }\n";
  const std::string floor = "storey_heights = [3], masses = [200] }\n" + soft;
  const std::string text =
      "[units]\nlength = \"m\"\nforce = \"kN\"\n[plan]\nclearance = 0.2\ncontact = { law = \"linear\", stiffness = 4e5 "
      "}\n[[building]]\nname = \"A\"\ndamping = 0.0\nplan = { corner = [0, 0], size = [10, 10], " +
      floor + "[[building]]\nname = \"B\"\ndamping = 0.0\nplan = { corner = [10.02, 9.9], size = [10, 10], " + floor +
      "[excitation]\nkind = \"none\"\n[initial]\nvelocities = { A = [[0.5, -2, 0]] }\n[analysis]\nduration = 0.2\n";
  const PlanRun run = test::told_plan_run(text);
  const std::vector<Statement> told = run_story(run).statements;
  const auto slips = std::find_if(told.begin(), told.end(), [](const Statement& one) { return one.kind == "slips"; });
  ASSERT_NE(slips, told.end());
  const auto value = [&](const std::string& name) {
    return std::find_if(slips->values.begin(), slips->values.end(),
                        [&](const StoryValue& one) { return one.name == name; })
        ->value;
  };
  EXPECT_EQ(std::get<long>(value("times")), 2);  // both ends of what they have in common
  EXPECT_NEAR(std::get<double>(value("time")), 0.05013, 5e-6);
  EXPECT_NEAR(std::get<double>(value("energy")), 1.0794, 2e-4);
  const json impacts = json::parse(summary_json(run, "test"))["impacts"];
  ASSERT_EQ(impacts.size(), 2U);
  for (const json& one : impacts) EXPECT_EQ(one["slipped"], true);
  EXPECT_FALSE(story_tells(run_story(test::told_plan_run(three_in_plan)), "slips"));
}

}  // namespace
}  // namespace bentur
