// Columns that break in shear: told of a run, in its summary, its histories, its verdict and its report.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/run_results.h"
#include "bentur/model/story/hand_in.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/report.h"
#include "tests/support/column_case.h"

namespace bentur {
namespace {

using Json = nlohmann::json;

/// The struck columns of the case with what the sections of East bear.
RunResults brittle(const std::string& capacity) {
  std::string text = test::struck_columns;
  const auto replace = [&](const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
  };
  const std::string section = "{ width = 0.5, depth = 0.5, density = 2.4 }";
  replace(section, section.substr(0, section.size() - 2) + ", shear_capacity = " + capacity + " }");
  replace("column_capacity = { shear = [400.0, 300.0, 400.0, 500.0], moment = 350.0 }\n", "");
  Diagnostics diagnostics;
  std::optional<Case> c = read_case_text(text, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = c->analysis.output_step;
  Response response = solve(problem, c->analysis.solver, options);
  EXPECT_EQ(response.status, Status::done) << response.message;
  return run_results(std::move(*c), std::move(problem), std::move(response));
}

const RunResults& broken() {
  static const RunResults run = brittle("[60.0, 250.0, 250.0], residual_shear = 0.1");
  return run;
}

bool tells(const Story& story, const std::string& kind) {
  return std::any_of(story.statements.begin(), story.statements.end(),
                     [&](const Statement& one) { return one.kind == kind; });
}

TEST(BreakingColumns, AreToldByPieces) {
  const RunResults& run = broken();
  const std::vector<BreakingColumn>& places = run.problem.buildings[1].model.hinges.columns;
  ASSERT_EQ(places.size(), 8U) << "three lines by two storeys, two of the left one in two pieces";
  EXPECT_EQ(places[0].piece, 1);
  EXPECT_EQ(places[1].piece, 2);
  EXPECT_EQ(places[2].piece, 0);
  const std::vector<BuildingPeaks::Breaking>& columns = run.response.buildings[1].columns;
  EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [](const auto& one) { return one.break_time; }));
  for (std::size_t n = 0; n < columns.size(); ++n) {
    EXPECT_LE(columns[n].peak_shear, places[n].capacity * (1 + 1e-9)) << n;
    EXPECT_EQ(columns[n].break_time.has_value(), columns[n].released_energy > 0) << n;
  }
  EXPECT_TRUE(run.response.buildings[0].columns.empty());
}

TEST(BreakingColumns, GiveTheGapItsCapacity) {
  const std::vector<ContactPoint>& points = broken().problem.points;
  EXPECT_EQ(points[0].column_shear_capacity, 60) << "at 3.0 m West strikes the left line of East";
  EXPECT_EQ(points[1].column_shear_capacity, 0) << "at 4.4 m it is West that is struck";
  EXPECT_EQ(points[2].column_shear_capacity, 60);
  EXPECT_EQ(points[3].column_shear_capacity, 0) << "floors meet";
}

TEST(BreakingColumns, StandInTheSummary) {
  const RunResults& run = broken();
  const Json json = Json::parse(summary_json(run, "1"));
  const Json& told = json["buildings"][1]["breaking_columns"];
  ASSERT_EQ(told.size(), 8U);
  EXPECT_EQ(told[0]["storey"], 1);
  EXPECT_EQ(told[0]["line"], 1);
  EXPECT_EQ(told[0]["piece"], 1);
  EXPECT_EQ(told[0]["shear_capacity"], 60);
  EXPECT_FALSE(told[2].contains("piece"));
  for (std::size_t n = 0; n < told.size(); ++n) {
    EXPECT_EQ(told[n]["break_time"].is_null(), !run.response.buildings[1].columns[n].break_time) << n;
    EXPECT_EQ(told[n]["peak_shear"], run.response.buildings[1].columns[n].peak_shear) << n;
  }
  EXPECT_FALSE(json["buildings"][0].contains("breaking_columns"));
}

TEST(BreakingColumns, AreReadBackFromTheHistories) {
  const RunResults& run = broken();
  const RunResults read = read_run(NetcdfReader(histories_netcdf(run, "1"), "histories.nc"));
  const std::vector<BreakingColumn>& places = read.problem.buildings[1].model.hinges.columns;
  ASSERT_EQ(places.size(), 8U);
  for (const Quantity* quantity : quantities_of(Owner::column)) {
    for (const QuantityPlace& at : breaking_columns_of(run.problem, 1)) {
      const double one = value_of(*quantity, run.view(), at), other = value_of(*quantity, read.view(), at);
      EXPECT_TRUE(one == other || (std::isnan(one) && std::isnan(other))) << quantity->key << at.floor;
    }
  }
  EXPECT_EQ(places[1].piece, 2);
  EXPECT_EQ(places[7].line, 3);
  EXPECT_EQ(places[0].capacity, 60);
}

TEST(BreakingColumns, AreARedSentenceAndATable) {
  const Story story = run_story(broken());
  EXPECT_TRUE(tells(story, "columns_break"));
  const std::vector<Remark>& remarks = broken().remarks;
  EXPECT_TRUE(std::any_of(remarks.begin(), remarks.end(),
                          [](const Remark& one) { return one.key == "broken_columns" && one.subject == "East"; }));
  EXPECT_EQ(story.statements.front().severity, Severity::danger);
  const auto table = std::find_if(story.tables.begin(), story.tables.end(),
                                  [](const StoryTable& one) { return one.kind == "broken_columns"; });
  ASSERT_NE(table, story.tables.end());
  const std::vector<double>& times = table->columns[3].numbers;
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_FALSE(times.empty());
  for (const std::string language : {"en", "id"}) {
    const std::string page = report_html(broken(), {.language = language, .version = "1"});
    EXPECT_NE(page.find(language == "en" ? "Columns of East that broke in shear" : "Kolom East yang patah geser"),
              std::string::npos);
  }
}

TEST(BreakingColumns, ThatHoldAreToldToo) {
  const RunResults run = brittle("1e6");
  const Story story = run_story(run);
  EXPECT_TRUE(tells(story, "columns_whole"));
  EXPECT_FALSE(tells(story, "columns_break"));
  const auto checks_met = [](const RunResults& of) {
    const StoryTable table = hand_in(of).checks;
    for (std::size_t n = 0; n < table.columns.at(0).texts.size(); ++n) {
      if (table.columns[0].texts[n] == "check.shear_capacity") return table.columns[5].texts[n];
    }
    return std::string("none");
  };
  EXPECT_EQ(checks_met(run), "check.met");
  EXPECT_EQ(checks_met(broken()), "check.not_met");
}

TEST(BreakingColumns, StandInTheRowsOfStudies) {
  const RunResults& run = broken();
  const std::vector<RowPart> parts = row_parts(run.problem, run.c.units, false);
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [](const RowPart& one) { return one.name == "breaking_column_break_time_2"; });
  ASSERT_NE(part, parts.end());
  EXPECT_EQ(part->count, 8);
  std::vector<double> row(row_size(parts));
  fill_row(parts, run.view(), row);
  EXPECT_EQ(std::isnan(row[part->first]), !run.response.buildings[1].columns[0].break_time);
}

}  // namespace
}  // namespace bentur
