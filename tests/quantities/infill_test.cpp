// Infill of frames: told of a run, in its summary, its histories, its table, its verdict and its report, and in
// studies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/run_results.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/report.h"
#include "bentur/runner/sweep.h"
#include "tests/support/study_of.h"

namespace bentur {
namespace {

using Json = nlohmann::json;

/// An open storey below a filled one, beside a stick.
/// `columns`: more of their section.
std::string filled_case(const std::string& panel, const std::string& columns = "") {
  return R"(
[units]
length = "m"
force = "kN"

[[building]]
name = "Filled"
damping = { mass_proportional = 0.03 }

[building.frame]
elastic_modulus = 2.6e7
storey_heights = [3.0, 3.0]
bay_widths = [4.0, 6.0]
columns = [{ width = 0.4, depth = 0.4, density = 2.4)" +
         columns + R"( }]
beams = [{ width = 0.3, depth = 0.5, density = 2.4 }]
floor_masses = 60
infill = [{ stiffness = 5e4, yield = inf }, )" +
         panel + R"(]

[[building]]
name = "Stick"
damping = 0.03
stick = { storey_heights = [3.0, 3.0], masses = [60.0, 50.0], stiffnesses = [9e4, 7e4] }

[[gap]]
between = ["Filled", "Stick"]
width = 0.01
contact = { law = "linear", stiffness = 1e5 }

[excitation]
kind = "harmonic"
period = 0.3
displacement_amplitude = 0.02

[analysis]
duration = 4.0
output_step = 0.01
energy_audit = true
)";
}

RunResults run_of(const std::string& panel, const std::string& columns = "") {
  Diagnostics diagnostics;
  std::optional<Case> c = read_case_text(filled_case(panel, columns), "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = c->analysis.output_step;
  options.energy_audit = true;
  Response response = solve(problem, c->analysis.solver, options);
  EXPECT_EQ(response.status, Status::done) << response.message;
  return run_results(std::move(*c), std::move(problem), std::move(response));
}

const std::string weak =
    "{ thickness = 0.1, modulus = 3e6, strength = 2000, plastic_drift = 0.002, softening_drift = 0.005 }";
const std::string strong = "{ thickness = 0.1, modulus = 3e6, strength = 1e7 }";

const RunResults& lost() {
  static const RunResults run = run_of(weak);
  return run;
}

const Statement* statement(const Story& story, const std::string& kind) {
  const auto found = std::find_if(story.statements.begin(), story.statements.end(),
                                  [&](const Statement& one) { return one.kind == kind; });
  return found == story.statements.end() ? nullptr : &*found;
}

TEST(InfillResults, AreOfEachStorey) {
  const BuildingPeaks::Infill& infill = lost().response.buildings[0].infill;
  ASSERT_EQ(infill.force.size(), 2);
  EXPECT_TRUE(std::isnan(infill.ductility(0))) << "it cannot yield";
  EXPECT_EQ(infill.energy(0), 0);
  EXPECT_EQ(infill.strength_left(0), 1);
  EXPECT_TRUE(std::isnan(infill.failed_time(0)));
  EXPECT_GT(infill.ductility(1), 1);
  EXPECT_EQ(infill.strength_left(1), 0);
  EXPECT_GT(infill.energy(1), 0);
  EXPECT_GT(infill.failed_time(1), 0);
  const std::vector<InfillPanel>& panels = lost().problem.buildings[0].model.infills;
  ASSERT_EQ(panels.size(), 4U);
  for (Eigen::Index storey : {0, 1}) {
    // Elastic below: k Δ; above the wider bay is the stronger one.
    const double drift = lost().response.buildings[0].drift_ratio(storey) * 3;
    const double shear = storey == 0 ? 5e4 * drift : panels[3].backbone.yield;
    EXPECT_NEAR(infill.shear(storey), shear, 1e-9 * shear);
    EXPECT_GT(infill.force(storey), infill.shear(storey));
  }
  EXPECT_EQ(lost().response.buildings[1].infill.force.size(), 0);
  EXPECT_EQ(lost().response.discrepancies.size(), 0U);
}

TEST(InfillResults, StandInTheSummaryAndItsTables) {
  const Json json = Json::parse(summary_json(lost(), "1"));
  const Json& building = json["buildings"][0];
  const BuildingPeaks::Infill& infill = lost().response.buildings[0].infill;
  EXPECT_EQ(building["infill_force"][1], infill.force(1));
  EXPECT_EQ(building["infill_shear"][0], infill.shear(0));
  EXPECT_TRUE(building["infill_failed_time"][0].is_null());
  EXPECT_FALSE(json["buildings"][1].contains("infill_force"));
  const std::vector<TableColumn> columns =
      table_columns(Owner::floor, lost().view(), floors_from_top(lost().problem, 0), 0, QuantityTable::yielding);
  ASSERT_EQ(columns.size(), 6U);
  EXPECT_EQ(columns[1].label, "On the column");
  EXPECT_TRUE(table_columns(Owner::floor, lost().view(), floors_from_top(lost().problem, 1), 0, QuantityTable::yielding)
                  .empty());
}

TEST(InfillResults, HaveTheCourseOfEveryStrut) {
  const Histories& histories = lost().response.histories;
  const std::vector<InfillPanel>& panels = lost().problem.buildings[0].model.infills;
  for (Eigen::Index n = 0; n < 4; ++n) {
    const InfillPanel& panel = panels[n];
    const auto drift = 3 * histories.drift_ratio[0].row(panel.storey);
    const Eigen::RowVectorXd apart = histories.infill_shortening[0].row(n) - panel.cosine * drift;
    EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_GT(drift.maxCoeff(), 1e-3);
    const double most = histories.infill_force[0].row(n).cwiseAbs().maxCoeff();
    EXPECT_LE(most, lost().response.buildings[0].infill.force(panel.storey) * (1 + 1e-12));
    if (panel.storey > 0) continue;
    const Eigen::VectorXd elastic = panel.stiffness / panel.cosine * drift;
    EXPECT_LT((histories.infill_force[0].row(n).transpose() - elastic).cwiseAbs().maxCoeff(), 1e-12 * most);
  }
  EXPECT_EQ(histories.infill_force[1].rows(), 0);
}

TEST(InfillResults, SayHowFarStrutsPushColumnsBeyondWhatTheyBear) {
  EXPECT_EQ(lost().response.buildings[0].infill.column_demand.size(), 0) << "no column has a capacity";
  const RunResults safe = run_of(weak, ", shear_capacity = 1e4");
  EXPECT_EQ(statement(run_story(safe), "infill_columns"), nullptr);
  // Between what columns bear as part of the frame, by which none breaks, and that with what struts push.
  const BuildingPeaks& bear = safe.response.buildings[0];
  double alone = 0;
  for (const BuildingPeaks::Breaking& column : bear.columns) alone = std::max(alone, column.peak_shear);
  const double capacity = 0.5 * (alone + 1e4 * bear.infill.column_demand.maxCoeff());
  ASSERT_GT(capacity, 1.1 * alone);
  const RunResults run = run_of(weak, ", shear_capacity = " + std::to_string(capacity));
  const BuildingPeaks::Infill& infill = run.response.buildings[0].infill;
  ASSERT_EQ(infill.column_demand.size(), 2);
  // At samples Q + F of every column and panel beside it, as Q = G x while none has broken.
  const Histories& histories = run.response.histories;
  const StructuralModel& model = run.problem.buildings[0].model;
  Eigen::Vector2d most = Eigen::Vector2d::Zero();
  for (std::size_t c = 0; c < model.hinges.columns.size(); ++c) {
    const BreakingColumn& column = model.hinges.columns[c];
    ASSERT_FALSE(run.response.buildings[0].columns[c].break_time);
    for (std::size_t n = 0; n < model.infills.size(); ++n) {
      const InfillPanel& panel = model.infills[n];
      const bool beside = panel.bay + 1 == column.line || panel.bay + 2 == column.line;
      if (panel.storey + 1 != column.storey || !beside) continue;
      const Eigen::RowVectorXd sum = model.hinges.rows.row(static_cast<Eigen::Index>(c)) * histories.displacement[0] +
                                     panel.cosine * histories.infill_force[0].row(static_cast<Eigen::Index>(n));
      most(panel.storey) = std::max(most(panel.storey), sum.cwiseAbs().maxCoeff() / column.capacity);
    }
  }
  for (Eigen::Index storey : {0, 1}) {
    EXPECT_LE(most(storey), infill.column_demand(storey) * (1 + 1e-12));
    EXPECT_GT(most(storey), 0.95 * infill.column_demand(storey));
    EXPECT_GT(infill.column_demand(storey), infill.shear(storey) / capacity) << "on one side";
  }
  EXPECT_GT(infill.column_demand.maxCoeff(), 1);
  ASSERT_NE(statement(run_story(run), "infill_columns"), nullptr);
  EXPECT_NE(report_html(run, {.language = "id", .version = "1"}).find("kali kapasitas gesernya"), std::string::npos);
}

TEST(InfillResults, AreReadBackFromTheHistories) {
  const RunResults read = read_run(NetcdfReader(histories_netcdf(lost(), "1"), "histories.nc"));
  int compared = 0;
  for (const Quantity* quantity : quantities_of(Owner::floor)) {
    if (quantity->source.when != When::infill && quantity->source.when != When::infill_columns) continue;
    for (const QuantityPlace& at : floors_of(lost().problem, 0)) {
      const double one = value_of(*quantity, lost().view(), at), other = value_of(*quantity, read.view(), at);
      EXPECT_TRUE(one == other || (std::isnan(one) && std::isnan(other))) << quantity->key << at.floor;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 14);
  const Histories &of = lost().response.histories, &again = read.response.histories;
  ASSERT_EQ(again.infill_force[0].rows(), 4);
  EXPECT_EQ(again.infill_force[0], of.infill_force[0]);
  EXPECT_EQ(again.infill_shortening[0], of.infill_shortening[0]);
  EXPECT_EQ(read.problem.buildings[0].model.infills[3].bay, 1);
  EXPECT_EQ(read.problem.buildings[0].model.infills[3].storey, 1);
}

TEST(InfillResults, AreASentenceWhenStrengthIsLost) {
  const Story story = run_story(lost());
  const Statement* fails = statement(story, "infill_fails");
  ASSERT_NE(fails, nullptr);
  EXPECT_EQ(fails->severity, Severity::warning);
  EXPECT_NE(statement(story, "infill"), nullptr);
  for (const std::string language : {"en", "id"}) {
    const std::string page = report_html(lost(), {.language = language, .version = "1"});
    EXPECT_NE(page.find(language == "en" ? "Infill of Filled fails, first in storey 2"
                                         : "Dinding pengisi Filled gagal, pertama di tingkat 2"),
              std::string::npos);
    EXPECT_NE(page.find(language == "en" ? "Strut of the infill" : "Strut dinding pengisi"), std::string::npos);
  }
  const RunResults whole = run_of(strong);
  EXPECT_EQ(statement(run_story(whole), "infill_fails"), nullptr);
  EXPECT_EQ(statement(run_story(whole), "infill_weakens"), nullptr);
  EXPECT_NE(statement(run_story(whole), "infill"), nullptr);
  const RunResults kept = run_of(weak.substr(0, weak.size() - 2) + ", residual = 0.2 }");
  EXPECT_EQ(statement(run_story(kept), "infill_fails"), nullptr);
  EXPECT_NE(statement(run_story(kept), "infill_weakens"), nullptr);
}

TEST(InfillResults, AreThoseOfAFreeResponseToo) {
  const FreeResponse free(lost().problem);
  const BuildingPeaks& peaks = free.response().buildings[0];
  ASSERT_EQ(peaks.infill.shear.size(), 2);
  EXPECT_NEAR(peaks.infill.shear(0), 5e4 * 3 * peaks.drift_ratio(0), 1e-9 * peaks.infill.shear(0));
}

TEST(InfillResults, StandInTheRowsOfASweepOverTheThickness) {
  const TemporaryFolder folder;
  SweepOptions options;
  options.output = folder.path() / "study.nc";
  options.threads = 1;
  Ranks alone;
  Diagnostics diagnostics;
  const std::string text = filled_case(weak);
  const auto report =
      sweep(test::study_of(text.c_str(), folder.path(), "building[0].frame.infill[1].thickness", "0.05, 0.1, 0.2"),
            options, alone, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(report && report->finished && report->failed == 0) << report->first_failure;
  const NetcdfReader file(options.output);
  const std::vector<double> shear = file.numbers("infill_shear_1");  // runs × storeys
  ASSERT_EQ(shear.size(), 6U);
  EXPECT_LT(shear[1], shear[3]);
  EXPECT_LT(shear[3], shear[5]);
  EXPECT_EQ(shear[3], lost().response.buildings[0].infill.shear(1)) << "0.1 is the case itself";
  EXPECT_EQ(file.at("infill_shear_1").units, "kN");
  EXPECT_EQ(file.find("infill_shear_2"), nullptr);
}

}  // namespace
}  // namespace bentur
