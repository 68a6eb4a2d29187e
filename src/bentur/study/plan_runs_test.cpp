// Studies of buildings in plan: every run against the same case read and solved alone.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <numeric>
#include <utility>

#include "bentur/io/case/plan/plan_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/study_runs.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

const char* const twisting_case = R"(
[plan]
clearance = 0.10
contact = { law = "linear", stiffness = 4e5, friction = 0.3 }
[[building]]
name = "Walled"
damping = 0.05
plan = { corner = [0, 0], size = [12, 18], storey_heights = [3.5, 3.2], masses = [200, 180] }
[[building.plane]]
name = "south wall"
along = "x"
at = 0.0
stiffnesses = [9e4, 9e4]
yield_forces = [900, 700]
hysteresis = "bilinear"
hardening = 0.05
[[building.plane]]
name = "north frame"
along = "x"
at = 18.0
stiffnesses = [2e4, 2e4]
[[building.plane]]
name = "west frame"
along = "y"
at = 0.0
stiffnesses = [4e4, 4e4]
[[building.plane]]
name = "east frame"
along = "y"
at = 12.0
stiffnesses = [4e4, 4e4]
[[building]]
name = "Frame"
damping = 0.05
plan = { corner = [12.02, 0], size = [15, 18], storey_heights = [3.5, 3.2], masses = [250, 220] }
rigidity = { centre = [7.5, 9], x = 1.2e5, y = 1.2e5, torsion = 1.2e7 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
angle = 30
[analysis]
duration = 3.0
)";

class PlanRuns : public testing::Test {
 protected:
  std::optional<StudyRuns> runs_of(const std::string& rest) {
    std::ofstream(folder_.path() / "case.toml") << twisting_case;
    std::ofstream(folder_.path() / "study.toml") << "case = 'case.toml'\n" << rest;
    auto study = read_study(folder_.path() / "study.toml", diagnostics_);
    const auto memo = std::make_shared<CaseMemo>();
    auto facts = study ? check_study(*study, *memo, diagnostics_) : std::nullopt;
    if (!facts) return std::nullopt;
    return std::optional<StudyRuns>(std::in_place, std::move(*study), std::move(*facts), memo);
  }

  std::string first_error() { return diagnostics_.ok() ? "" : diagnostics_.errors().front().message(); }

  /// The row of a case that is read and solved by itself.
  std::vector<double> alone(const StudyRuns& runs, const std::function<void(std::string&)>& change) {
    std::string text = twisting_case;
    change(text);
    Diagnostics diagnostics;
    PlanProblem problem;
    const auto c = read_plan_case_text(text, folder_.path() / "case.toml", diagnostics, &problem);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    PlanResponse response = solve(problem, c->analysis.solver, {.levels = true});
    std::vector<double> row(row_size(runs.quantities()));
    fill_row(runs.quantities(), {*c, problem, std::move(response)}, row);
    return row;
  }

  static void put(std::string& text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::vector<RowPart>& parts) {
  ASSERT_EQ(a.size(), b.size());
  for (const RowPart& part : parts) {
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      if (std::isnan(a[i]) && std::isnan(b[i])) continue;
      EXPECT_EQ(a[i], b[i]) << part.name << " " << i - part.first;
    }
  }
}

TEST_F(PlanRuns, EachIsTheCaseAlone) {
  const auto runs = runs_of(R"(
[[vary]]
parameter = "plan.contact.friction"
values = [0.1, 0.5]
[[vary]]
parameter = "building[1].plan.corner[0]"
name = "corner"
values = [12.01, 12.03]
)");
  ASSERT_TRUE(runs) << first_error();
  ASSERT_EQ(runs->plan().runs(), 4);
  std::vector<std::size_t> all(4);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<RunResult> results = runs->solve(all, [] { return true; });
  ASSERT_EQ(results.size(), 4);
  double impacts = 0, ductility = 0;
  for (const RunResult& result : results) {
    ASSERT_EQ(result.status, RunStatus::done) << result.message;
    const std::vector<Choice> chosen = runs->choices(result.run);
    const std::vector<double> row = alone(*runs, [&](std::string& text) {
      put(text, "friction = 0.3", chosen[0].level == 0 ? "friction = 0.1" : "friction = 0.5");
      put(text, "[12.02, 0]", chosen[1].level == 0 ? "[12.01, 0]" : "[12.03, 0]");
    });
    expect_same(result.values, row, runs->quantities());
    for (const RowPart& part : runs->quantities()) {
      for (std::size_t i = part.first; i < part.first + part.count; ++i) {
        if (part.name == "impacts") impacts += row[i];
        if (part.name == "plane_ductility_1" && !std::isnan(row[i])) ductility = std::max(ductility, row[i]);
      }
    }
  }
  EXPECT_GT(impacts, 4);
  EXPECT_GT(ductility, 1);
}

TEST_F(PlanRuns, SaysWhereItsValuesAre) {
  const auto runs =
      runs_of("[[vary]]\nparameter = 'building[1].plan.corner[0]'\nname = 'corner'\nvalues = [12.01, 12.03]\n");
  ASSERT_TRUE(runs) << first_error();
  const StudyFile file = study_file(*runs, "0");
  std::map<std::string, std::vector<std::size_t>> shapes;
  for (const StudyVariable& variable : file.variables) {
    for (const ResultDimension& dimension : variable.dimensions) shapes[variable.name].push_back(dimension.size);
  }
  EXPECT_EQ(shapes["plane_peak_drift_ratio_1"], (std::vector<std::size_t>{2, 4, 2}));
  EXPECT_EQ(shapes["plane_name_1"], (std::vector<std::size_t>{4}));
  EXPECT_EQ(shapes["peak_rotation_2"], (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(shapes["peak_tangential_force"], (std::vector<std::size_t>{2, 4}));
  EXPECT_EQ(shapes["gap_needed"], (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(shapes.count("plane_name_2"), 0) << "of rigidity given as sums";
  EXPECT_EQ(shapes.count("point_x"), 0) << "it differs between runs";
}

TEST_F(PlanRuns, WhatTheyDoNotTakeIsAnError) {
  EXPECT_FALSE(runs_of("[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, 0.0]\n"));
  EXPECT_NE(first_error().find("with plan.contact.friction = 0: which buildings meet"), std::string::npos)
      << first_error();
}

TEST_F(PlanRuns, IdaIsRefused) {
  EXPECT_FALSE(runs_of("[ida]\nintensity = 'pga'\nlevels = [1.0, 2.0]\n"));
  EXPECT_NE(first_error().find("does not go with buildings in plan"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, ValuesOfTheCaseAreChecked) {
  EXPECT_FALSE(runs_of("[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, -0.5]\n"));
  EXPECT_NE(first_error().find("must be >= 0"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, GapOverRecordsIsRefused) {
  ASSERT_TRUE(runs_of("[[vary]]\nparameter = 'excitation.period'\nvalues = [0.4, 0.5]\n")) << first_error();
  EXPECT_FALSE(gap_study(folder_.path() / "study.toml", std::nullopt, {}, diagnostics_));
  EXPECT_NE(first_error().find("does not go with buildings in plan"), std::string::npos) << first_error();
}

}  // namespace
}  // namespace bentur
