// Studies of buildings in plan: every run against the same case read and solved alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <utility>

#include "bentur/excitation/motion_measures.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/study_variables.h"
#include "tests/support/plan_study.h"

namespace bentur {
namespace {

using test::expect_same;

class PlanRuns : public test::PlanStudy {};

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
  ASSERT_EQ(runs->design().runs(), 4);
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

/// Its rows over the degrees of freedom are the same to the bit wherever a building stands along x.
TEST_F(PlanRuns, WhereABuildingStandsDoesNotMatterWithoutContact) {
  std::ofstream(folder_.path() / "case.toml") << case_;
  const auto problem = [&](const std::string& corner) {
    std::string text = case_;
    put(text, "[12.02, 0]", corner);
    Diagnostics diagnostics;
    MadeParts made;
    EXPECT_TRUE(read_case_text(text, folder_.path() / "case.toml", diagnostics, &made));
    return made.plan;
  };
  const PlanFreeResponse free(problem("[12.02, 0]"));
  for (const char* const corner : {"[12.01, 0]", "[12.03, 0]", "[12.0371, 0]"}) {
    EXPECT_TRUE(free.serves(problem(corner))) << corner;
  }
  EXPECT_FALSE(free.serves(problem("[12.02, 0.1]"))) << "other places of it are struck";
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

/// What links bear is kept for each run, as that of the case alone.
TEST_F(PlanRuns, TellOfLinks) {
  case_ +=
      "\n[[link]]\nbetween = [\"Frame\", \"Walled\"]\nelevations = [3.5, 6.7]\nlaw = \"cable\"\nstiffness = 2e4\n"
      "at = 3\nalong = \"x\"\n";
  const auto runs = runs_of("[[vary]]\nparameter = 'link[0].stiffness'\nname = 'stiffness'\nvalues = [1e4, 4e4]\n");
  ASSERT_TRUE(runs) << first_error();
  double most = 0;
  for (const RunResult& result : runs->solve(std::vector<std::size_t>{0, 1}, [] { return true; })) {
    const auto level = runs->choices(result.run)[0].level;
    const std::vector<double> row = alone(*runs, [&](std::string& text) {
      put(text, "stiffness = 2e4", level == 0 ? "stiffness = 1e4" : "stiffness = 4e4");
    });
    expect_same(result.values, row, runs->quantities());
    for (const RowPart& part : runs->quantities()) {
      if (part.name == "link_peak_tension") most = std::max(most, row[part.first + 1]);
    }
  }
  EXPECT_GT(most, 10);  // [kN]
  std::map<std::string, std::vector<std::size_t>> shapes;
  const StudyFile file = study_file(*runs, "0");
  for (const StudyVariable& variable : file.variables) {
    for (const ResultDimension& dimension : variable.dimensions) shapes[variable.name].push_back(dimension.size);
  }
  EXPECT_EQ(shapes["link_peak_tension"], (std::vector<std::size_t>{2, 2}));
  for (const char* const name : {"link_left", "link_right", "link_along", "link_elevation", "link_x", "link_y"}) {
    EXPECT_EQ(shapes[name], (std::vector<std::size_t>{2})) << name;
  }
}

TEST_F(PlanRuns, WhatTheyDoNotTakeIsAnError) {
  EXPECT_FALSE(runs_of("[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, 0.0]\n"));
  EXPECT_NE(first_error().find("with plan.contact.friction = 0: which buildings meet"), std::string::npos)
      << first_error();
}

const std::string pairs = R"(
[[vary]]
parameter = "excitation.file"
name = "record"
files = ["a-x.csv", "b-x.csv"]
together = "pair"
[[vary]]
parameter = "excitation.y.file"
name = "record_y"
files = ["a-y.csv", "b-y.csv"]
together = "pair"
)";

TEST_F(PlanRuns, OfAnIdaBothComponentsAreScaledAlike) {
  shake(true);
  const auto runs = runs_of(pairs + "[ida]\nintensity = 'pga'\nlevels = [1.5, 4.0]\npolarity = 'both'\n");
  ASSERT_TRUE(runs) << first_error();
  ASSERT_EQ(runs->design().runs(), 8);
  const RecordIntensities& intensities = runs->facts().intensities;
  ASSERT_EQ(intensities.values.size(), 4);
  // The same numbers as of the files, read alone.
  const auto peak = [this](const char* name) {
    std::ifstream file(folder_.path() / name);
    double largest = 0;
    for (std::string line; std::getline(file, line);) {
      largest = std::max(largest, std::abs(std::stod(line.substr(line.find(',') + 1))));
    }
    return largest;
  };
  const double of_a = std::sqrt(peak("a-x.csv") * peak("a-y.csv"));
  const double of_b = std::sqrt(peak("b-x.csv") * peak("b-y.csv"));
  for (const std::size_t i : {0, 1}) EXPECT_DOUBLE_EQ(intensities.values[i], of_a);
  for (const std::size_t i : {2, 3}) EXPECT_DOUBLE_EQ(intensities.values[i], of_b);
  std::vector<std::size_t> all(8);
  std::iota(all.begin(), all.end(), 0);
  double impacts = 0;
  for (const RunResult& result : runs->solve(all, [] { return true; })) {
    ASSERT_EQ(result.status, RunStatus::done) << result.message;
    const std::vector<Choice> chosen = runs->choices(result.run);
    const bool second = chosen[0].level == 1;
    const double level = chosen[2].level == 0 ? 1.5 : 4.0;
    const std::string scale = fmt::format("scale = {}", level / (second ? of_b : of_a));
    const std::string way = chosen[1].level == 0 ? "" : "\npolarity = 'reversed'";
    const std::vector<double> row = alone(*runs, [&](std::string& text) {
      put(text, "pga = 9.0", scale + way);
      put(text, "scale = 7.0", scale + way);
      if (!second) return;
      put(text, "a-x.csv", "b-x.csv");
      put(text, "a-y.csv", "b-y.csv");
    });
    expect_same(result.values, row, runs->quantities());
    for (const RowPart& part : runs->quantities()) {
      if (part.name == "impacts") impacts += std::accumulate(&row[part.first], &row[part.first + part.count], 0.0);
    }
  }
  EXPECT_GT(impacts, 4);
}

/// Elastic plans scale with their records: the response without contact is solved once for each. 10⁻⁹ of the largest of
/// a quantity, as impacts amplify what is rounded otherwise.
TEST_F(PlanRuns, OfAnIdaOfElasticPlansScaledOnesAreThoseOfEachAlone) {
  shake(true);
  put(case_, "yield_forces = [900, 700]\nhysteresis = \"bilinear\"\nhardening = 0.05\n", "");
  const auto runs = runs_of(
      "[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, 0.5]\n"
      "[ida]\nintensity = 'pga'\nlevels = [1.5, 2.5, 4.0]\n");
  ASSERT_TRUE(runs) << first_error();
  ASSERT_EQ(runs->design().runs(), 6);
  std::vector<std::size_t> all(6);
  std::iota(all.begin(), all.end(), 0);
  std::size_t to_the_bit = 0, otherwise = 0;
  double impacts = 0;
  for (const RunResult& result : runs->solve(all, [] { return true; })) {
    ASSERT_EQ(result.status, RunStatus::done) << result.message;
    const std::vector<Choice> chosen = runs->choices(result.run);
    const double level = std::vector<double>{1.5, 2.5, 4.0}[chosen[1].level];
    const std::string scale = fmt::format("scale = {}", level / runs->facts().intensities.values.at(0));
    const std::vector<double> row = alone(*runs, [&](std::string& text) {
      put(text, "pga = 9.0", scale);
      put(text, "scale = 7.0", scale);
      put(text, "friction = 0.3", chosen[0].level == 0 ? "friction = 0.1" : "friction = 0.5");
    });
    for (const RowPart& part : runs->quantities()) {
      if (part.name == "energy_lost") continue;  // linear contact loses nothing: round-off
      double largest = 0;
      for (std::size_t i = part.first; i < part.first + part.count; ++i) largest = std::fmax(largest, std::abs(row[i]));
      for (std::size_t i = part.first; i < part.first + part.count; ++i) {
        ASSERT_EQ(std::isnan(row[i]), std::isnan(result.values[i])) << part.name;
        if (std::isnan(row[i])) continue;
        (row[i] == result.values[i] ? to_the_bit : otherwise) += 1;
        EXPECT_NEAR(row[i], result.values[i], chosen[1].level == 0 ? 0 : 1e-9 * largest) << part.name;
        if (part.name == "impacts") impacts += row[i];
      }
    }
  }
  EXPECT_GT(impacts, 6);
  EXPECT_GT(to_the_bit, 100U);
  EXPECT_GT(otherwise, 20U) << "none of them has been scaled";
}

TEST_F(PlanRuns, AnIdaSaysWhoseIntensityItIs) {
  shake(true);
  const auto value = [this](const std::string& component) {
    const auto runs = runs_of("[ida]\nintensity = 'sa'\nperiod = 0.5\nunit = 'm/s2'\nlevels = [1.0]\ncomponent = '" +
                              component + "'\n");
    if (!runs) ADD_FAILURE() << first_error();
    const StudyFile file = study_file(*runs, "0");
    for (const StudyVariable& variable : file.variables) {
      if (variable.name != "intensity") continue;
      const std::string told = component.size() == 1 ? "[excitation" : component.substr(0, 6);
      EXPECT_NE(variable.long_name.find(told), std::string::npos) << variable.long_name;
    }
    return runs->facts().intensities.values.at(0);
  };
  const double x = value("x"), y = value("y");
  EXPECT_GT(std::abs(x - y), 0.1);
  EXPECT_EQ(value("larger"), std::max(x, y));
  EXPECT_EQ(value("geometric-mean"), std::sqrt(x * y));
}

TEST_F(PlanRuns, AnIdaOfOneComponentHasItsIntensity) {
  shake(false);
  const auto runs = runs_of("[ida]\nintensity = 'pga'\nlevels = [2.0]\n");
  ASSERT_TRUE(runs) << first_error();
  const std::vector<std::size_t> all = {0};
  const RunResult result = runs->solve(all, [] { return true; }).at(0);
  ASSERT_EQ(result.status, RunStatus::done) << result.message;
  const std::string scale = fmt::format("scale = {}", 2.0 / runs->facts().intensities.values.at(0));
  expect_same(result.values, alone(*runs, [&](std::string& text) { put(text, "pga = 9.0", scale); }),
              runs->quantities());
  EXPECT_FALSE(runs_of("[ida]\nintensity = 'pga'\nlevels = [2.0]\ncomponent = 'x'\n"));
  EXPECT_NE(first_error().find("goes with [excitation.y]"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, AnIdaNeedsRecordsAlongBoth) {
  case_ += "[excitation.y]\nkind = 'harmonic'\nperiod = 0.5\ndisplacement_amplitude = 0.03\n";
  EXPECT_FALSE(runs_of("[ida]\nintensity = 'pga'\nlevels = [1.0, 2.0]\n"));
  EXPECT_NE(first_error().find("needs records: excitation.kind"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, ScaleOfYIsForAnIdaToSet) {
  shake(true);
  EXPECT_FALSE(
      runs_of("[ida]\nintensity = 'pga'\nunit = 'm/s2'\nlevels = [1.0]\n[[vary]]\nparameter = 'excitation.y.scale'\n"
              "values = [1.0, 2.0]\n"));
  EXPECT_NE(first_error().find("is set by [ida]"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, NormalisationIsOfBothComponents) {
  shake(true);
  put(case_, "pga = 9.0\n", "");
  std::string study = pairs;
  put(study, "files = [\"a-x.csv\", \"b-x.csv\"]\n", "files = [\"a-x.csv\", \"b-x.csv\"]\nnormalisation = 'pgv'\n");
  const auto runs = runs_of(study);
  ASSERT_TRUE(runs) << first_error();
  const std::vector<double>& factors = runs->study().varies[0].normalisation;
  ASSERT_EQ(factors.size(), 2);
  const auto pgv = [this](const std::string& name) {
    std::string text = test::twisting_case;
    Diagnostics diagnostics;
    put(text, "kind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 0.03\n",
        "kind = 'record'\nfile = '" + name + "'\nunit = 'm/s2'\n");
    return motion_measures(read_case_text(text, folder_.path() / "case.toml", diagnostics)->excitation.motion).pgv;
  };
  const double a = std::sqrt(pgv("a-x.csv") * pgv("a-y.csv")), b = std::sqrt(pgv("b-x.csv") * pgv("b-y.csv"));
  EXPECT_NEAR(factors[0] * a, factors[1] * b, 1e-12 * a);
  EXPECT_NEAR(factors[0], 0.5 * (a + b) / a, 1e-12);
  const std::vector<std::size_t> second = {1};
  const RunResult result = runs->solve(second, [] { return true; }).at(0);
  ASSERT_EQ(result.status, RunStatus::done) << result.message;
  const std::vector<double> row = alone(*runs, [&](std::string& text) {
    put(text, "file = 'a-x.csv'", fmt::format("file = 'b-x.csv'\nscale = {}", factors[1]));
    put(text, "file = 'a-y.csv'", "file = 'b-y.csv'");
    put(text, "scale = 7.0", fmt::format("scale = {}", 7.0 * factors[1]));
  });
  expect_same(result.values, row, runs->quantities());
}

TEST_F(PlanRuns, NormalisationOfOneComponentAloneIsAnError) {
  shake(true);
  put(case_, "pga = 9.0\n", "");
  std::string study = pairs;
  put(study, "together = \"pair\"\n", "normalisation = 'pgv'\n");
  put(study, "together = \"pair\"\n", "");
  EXPECT_FALSE(runs_of(study));
  EXPECT_NE(first_error().find("is of both components: excitation.y.file must move together"), std::string::npos)
      << first_error();
}

TEST_F(PlanRuns, ValuesOfTheCaseAreChecked) {
  EXPECT_FALSE(runs_of("[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, -0.5]\n"));
  EXPECT_NE(first_error().find("must be >= 0"), std::string::npos) << first_error();
}

TEST_F(PlanRuns, GapsOverRecordsAreThoseOfEachAlone) {
  shake(true);
  ASSERT_TRUE(runs_of(pairs + R"(
[[vary]]
parameter = "plan.contact.friction"
values = [0.1, 0.5]
[[vary]]
parameter = "building[1].plan.corner[0]"
name = "corner"
values = [12.02, 12.03]
[ida]
intensity = 'pga'
levels = [1.0, 3.0]
)")) << first_error();
  const auto study = gap_study(
      folder_.path() / "study.toml", 2.0, [](double) { return true; }, diagnostics_);
  ASSERT_TRUE(study) << first_error();
  EXPECT_EQ(study->asked, 4) << "contacts do not matter";
  ASSERT_EQ(study->needs.size(), 2);
  ASSERT_EQ(study->gaps.size(), 1);
  EXPECT_EQ(study->gaps[0].name, "Walled | Frame");
  EXPECT_TRUE(study->together->gaps[0].given.empty()) << "the corners leave different widths";
  const auto runs = runs_of(pairs + "[ida]\nintensity = 'pga'\nlevels = [2.0]\n");
  ASSERT_TRUE(runs) << first_error();
  for (std::size_t corner = 0; corner < 2; ++corner) {
    const RecordNeeds& needs = study->needs[corner];
    ASSERT_EQ(needs.records.size(), 2);
    std::size_t beyond = 0;
    for (std::size_t record = 0; record < 2; ++record) {
      const std::string scale = fmt::format("scale = {}", 2.0 / runs->facts().intensities.values[record]);
      std::string text = case_;
      put(text, "pga = 9.0", scale);
      put(text, "scale = 7.0", scale);
      put(text, "[12.02, 0]", corner == 0 ? "[12.02, 0]" : "[12.03, 0]");
      if (record == 1) put(text, "a-x.csv", "b-x.csv");
      if (record == 1) put(text, "a-y.csv", "b-y.csv");
      Diagnostics diagnostics;
      MadeParts made;
      PlanProblem& problem = made.plan;
      const auto c = read_case_text(text, folder_.path() / "case.toml", diagnostics, &made);
      ASSERT_TRUE(c);
      const PlanRun run{*c, problem, solve(problem, c->analysis.solver, {.levels = true})};
      const RunResults pair = *row_of(run);
      const LevelSeparation largest = largest_of(separations(pair.problem, pair.response, pair.c.code, pair.c.units));
      const GapNeed& need = needs.records[record].gaps.at(0);
      EXPECT_EQ(need.gap_needed, largest.gap_needed);
      EXPECT_EQ(need.abs, largest.abs);
      EXPECT_EQ(need.srss, largest.srss);
      EXPECT_TRUE(std::isnan(need.ddc)) << "periods of one direction are not known";
      EXPECT_GT(need.gap_needed, 0);
      beyond += need.gap_needed > problem.gaps[0].stretch.width ? 1 : 0;
    }
    ASSERT_EQ(needs.gaps[0].given.size(), 1);
    EXPECT_EQ(needs.gaps[0].given[0].beyond, beyond);
    EXPECT_NEAR(needs.gaps[0].given[0].widths.at(0), corner == 0 ? 0.02 : 0.03, 1e-12);
  }
}

}  // namespace
}  // namespace bentur
