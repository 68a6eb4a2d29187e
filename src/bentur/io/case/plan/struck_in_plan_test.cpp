// Floors of buildings in plan that strike columns of frames: the same as in a row that they stand for, and what a case
// is told that has no such column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/story.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

using test::with;

const std::string short_motion = R"(
[excitation]
kind = "harmonic"
period = 0.7
displacement_amplitude = 0.04
[analysis]
duration = 3
)";

/// Two frames of Tall side by side, whose columns the only floor of Low strikes.
const std::string struck_pair = R"(
[units]
length = "m"
force = "kN"
[plan]
contact = { law = "kelvin-voigt", stiffness = 5e5, restitution = 0.65 }
[[building]]
name = "Tall"
damping = 0.05
plan = { corner = [0, 0], size = [12, 9], storey_heights = [3.5, 3.2, 3.2], masses = [180, 180, 150] }
[[building.plane]]
name = "A"
along = "x"
at = 0.5
frame = { elastic_modulus = 2.6e7, bay_widths = [6, 6], columns = [{ width = 0.45, depth = 0.45, density = 2.5 }], beams = [{ width = 0.3, depth = 0.5 }] }
[[building.plane]]
name = "B"
along = "x"
at = 8.5
frame = { elastic_modulus = 2.6e7, bay_widths = [6, 6], columns = [{ width = 0.45, depth = 0.45, density = 2.5 }], beams = [{ width = 0.3, depth = 0.5 }] }
[[building.plane]]
name = "wall"
along = "y"
at = 6
stiffnesses = [2e5, 2e5, 2e5]
[[building]]
name = "Low"
damping = 0.05
plan = { corner = [12.02, 0], size = [10, 9], storey_heights = [4.6], masses = [250] }
rigidity = { centre = [5.0, 4.5], x = 90000.0, y = 90000.0, torsion = 4e6 }
[[gap]]
between = ["Tall", "Low"]
strikes_columns = true
elevations = [4.6]
column_capacity = { shear = 150.0, moment = 120.0 }
)" + short_motion;

/// Both frames as one, with twice their stiffness and mass. Floors have what the columns have not.
const std::string struck_row = R"(
[units]
length = "m"
force = "kN"
[[building]]
name = "Tall"
damping = 0.05
[building.frame]
elastic_modulus = 5.2e7
storey_heights = [3.5, 3.2, 3.2]
bay_widths = [6, 6]
columns = [{ width = 0.45, depth = 0.45, density = 5.0 }]
beams = [{ width = 0.3, depth = 0.5, mass = 0 }]
floor_masses = [169.824375, 170.28, 145.14]
mass_matrix = "lumped"
[[building]]
name = "Low"
damping = 0.05
[building.stick]
storey_heights = [4.6]
masses = [250]
stiffnesses = [90000.0]
[[gap]]
between = ["Tall", "Low"]
width = 0.02
strikes_columns = true
elevations = [4.6]
contact = { law = "kelvin-voigt", stiffness = 5e5, restitution = 0.65 }
)" + short_motion;

Response response_of_row() {
  Diagnostics diagnostics;
  MadeParts made;
  const auto c = read_case_text(struck_row, "case.toml", diagnostics, &made);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return solve(make_problem(*c), ExactSolver{}, solve_options(*c));
}

TEST(StruckInPlan, AreThoseOfTheRowThatTheyStandFor) {
  const PlanRun run = test::told_plan_run(struck_pair);
  const Response row = response_of_row();
  ASSERT_EQ(run.response.points.size(), 2U);  // a column of each frame
  ASSERT_EQ(row.points.size(), 1U);
  EXPECT_TRUE(run.response.watched.empty() || run.response.watched.front().gap_needed >= 0);
  const PointSummary& by_row = row.points.front();
  ASSERT_GT(by_row.impacts, 2);
  for (const PointSummary& point : run.response.points) {
    EXPECT_EQ(point.impacts, by_row.impacts);
    EXPECT_NEAR(point.gap_needed, by_row.gap_needed, 1e-9);
    EXPECT_NEAR(point.peak_force, by_row.peak_force / 2, 1e-5 * by_row.peak_force);
    ASSERT_TRUE(point.column && by_row.column);
    EXPECT_NEAR(point.column->shear, by_row.column->shear / 2, 1e-5 * by_row.column->shear);
    EXPECT_NEAR(point.column->moment_node, by_row.column->moment_node / 2, 1e-5 * by_row.column->moment_node);
    EXPECT_NEAR(point.column->moment_no_contact, by_row.column->moment_no_contact / 2,
                1e-6 * by_row.column->moment_no_contact);
  }
  EXPECT_NEAR(run.response.buildings[0].x(2), row.buildings[0].displacement(2), 1e-6);
}

TEST(StruckInPlan, AreToldAsInARow) {
  const PlanRun run = test::told_plan_run(struck_pair);
  const auto row = row_of(run);
  ASSERT_EQ(row->problem.points.size(), 2U);
  EXPECT_EQ(struck_column(row->problem, row->problem.points[0])->building, 0);
  const Story story = run_story(run);
  const auto has = [&](const char* kind) {
    return std::any_of(story.statements.begin(), story.statements.end(),
                       [&](const Statement& one) { return one.kind == kind; });
  };
  EXPECT_TRUE(has("column_shear"));
  EXPECT_TRUE(has("pounding"));
  const auto json = nlohmann::json::parse(summary_json(run, ""));
  const auto& point = json["gaps"][0]["points"][1];
  EXPECT_EQ(point["struck"], "Tall");
  EXPECT_DOUBLE_EQ(point["column"]["peak_shear"], run.response.points[1].column->shear);
  EXPECT_DOUBLE_EQ(point["column"]["shear_demand_capacity"], run.response.points[1].column->shear / 150);
}

/// Errors of a case.
std::vector<std::string> errors_of_struck(const std::string& text) {
  Diagnostics diagnostics;
  MadeParts made;
  (void)read_case_text(text, "case.toml", diagnostics, &made);
  std::vector<std::string> found;
  for (const Diagnostic& one : diagnostics.errors()) found.push_back(one.text());
  return found;
}

TEST(StruckInPlan, RefuseWhereThereIsNone) {
  const auto one_says = [](const std::string& text, const std::string& words) {
    const std::vector<std::string> errors = errors_of_struck(text);
    EXPECT_TRUE(std::any_of(errors.begin(), errors.end(),
                            [&](const std::string& one) { return one.find(words) != std::string::npos; }))
        << words << ": " << (errors.empty() ? "no error" : errors.front());
  };
  EXPECT_TRUE(errors_of_struck(struck_pair).empty());
  one_says(with(struck_pair, "elevations = [4.6]", "elevations = [5.0]"), "neither building has a floor there");
  one_says(with(struck_pair, "corner = [12.02, 0], size = [10, 9]", "corner = [12.02, 3], size = [10, 3]"),
           "has no frame across the joint");
  one_says(with(struck_pair, ", density = 2.5", ""), "whose columns have no mass there");
  one_says(with(struck_pair, "strikes_columns = true\n", ""), "column_capacity");
  one_says(with(struck_pair, "elevations = [4.6]\n", ""), "strikes_columns = true needs to know where");
  one_says(with(struck_pair, "storey_heights = [4.6]", "storey_heights = [12.0]"),
           "neither building has a floor there");
  // All at once: of both columns a capacity each, for the one level.
  one_says(with(struck_pair, "shear = 150.0,", "shear = [150.0, 1.0],"), "column_capacity.shear");
}

// Soil, bearings and a calibrated period change nothing of who is struck.
TEST(StruckInPlan, StandOnWhatTheirBuildingStandsOn) {
  const std::string soil = R"(
soil = { sway = { stiffness = 5e5, damping = 1e3 }, rocking = { stiffness = 5e6, damping = 1e4 }, twist = "rigid", foundation = { mass = 100, inertia = 900 } }
)";
  const std::string bearings = R"(
[building.isolation]
mass = 150
bearing = [{ at = [1, 1], stiffness = 3000 }, { at = [11, 1], stiffness = 3000 }, { at = [1, 8], stiffness = 3000 }, { at = [11, 8], stiffness = 3000 }]
)";
  const std::string name = "name = \"Tall\"\n";
  for (const std::string& text :
       {with(struck_pair, name, name + soil),
        with(struck_pair, "[[building]]\nname = \"Low\"", bearings + "[[building]]\nname = \"Low\""),
        with(struck_pair, name, name + "calibrate_period = 0.8\n"),
        with(struck_pair, name, name + "p_delta = true\n")}) {
    const PlanRun run = test::told_plan_run(text);
    ASSERT_EQ(run.response.points.size(), 2U);
    for (const PointSummary& point : run.response.points) {
      ASSERT_TRUE(point.column);
      EXPECT_GT(point.column->shear_no_contact, 0);
    }
    // Both frames do the same.
    EXPECT_NEAR(run.response.points[0].gap_needed, run.response.points[1].gap_needed, 1e-9);
  }
}

}  // namespace
}  // namespace bentur
