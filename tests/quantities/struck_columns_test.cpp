// What columns bear that floors strike: told of a run, of a study, in files of results and figures.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/run_results.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/report.h"
#include "bentur/report/studies/file_kinds.h"
#include "bentur/runner/sweep.h"
#include "tests/support/column_case.h"

namespace bentur {
namespace {

using Json = nlohmann::json;

Case the_case() {
  Diagnostics diagnostics;
  std::optional<Case> c = read_case_text(test::struck_columns, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return c.value();
}

RunResults simulated(Case c) {
  Problem problem = make_problem(c);
  SolveOptions options;
  options.output_step = c.analysis.output_step;
  options.course = true;
  Response response = solve(problem, c.analysis.solver, options);
  return run_results(std::move(c), std::move(problem), std::move(response));
}

const RunResults& the_run() {
  static const RunResults results = simulated(the_case());
  return results;
}

TEST(StruckColumns, AreStruckWhereOneBuildingAloneHasAFloor) {
  const Problem& problem = the_run().problem;
  ASSERT_EQ(problem.points.size(), 4U);
  const std::vector<Eigen::Index> struck = {1, 0, 1};  // the building, at 3.0, 4.4 and 6.0
  const std::vector<Eigen::Index> nodes = {0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = struck_column(problem, problem.points[i]);
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->building, struck[i]) << i;
    EXPECT_EQ(found->node, nodes[i]) << i;
    EXPECT_GT(the_run().response.points[i].impacts, 0) << i;
  }
  EXPECT_FALSE(struck_column(problem, problem.points[3])) << "roofs meet";
  EXPECT_FALSE(the_run().response.points[3].column);
}

// The peaks are those of the continuous response: no sample and no instant of the exact course exceeds them, and
// samples of 1 ms come near.
TEST(StruckColumns, PeaksAreThoseOfTheHistories) {
  const RunResults& run = the_run();
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t i = k % 3;
    const StruckColumn struck = struck_column(run.problem, run.problem.points[i]).value();
    const Histories& of = k < 3 ? run.response.histories : run.response.course;
    const Eigen::MatrixXd& forces = of.column_forces.at(struck.building);
    const auto sampled = [&](Eigen::Index row) { return forces.row(6 * struck.node + row).cwiseAbs().maxCoeff(); };
    const ColumnPeaks& column = run.response.points[i].column.value();
    const double peaks[] = {column.shear_below, column.shear_above, column.moment_bottom,
                            column.moment_node, column.moment_node, column.moment_top};
    for (Eigen::Index row = 0; row < 6; ++row) {
      EXPECT_LE(sampled(row), peaks[row] * (1 + 1e-12)) << i << " " << row;
      if (row != 3 && row != 4) {
        EXPECT_GT(sampled(row), 0.98 * peaks[row]) << i << " " << row;
      }
    }
    EXPECT_GT(std::max(sampled(3), sampled(4)), 0.98 * column.moment_node);
    EXPECT_EQ(column.shear, std::max(column.shear_below, column.shear_above));
    EXPECT_EQ(column.moment, std::max({column.moment_bottom, column.moment_node, column.moment_top}));
    EXPECT_GT(column.shear, column.shear_no_contact) << "it is struck";
  }
}

// What the node does between its floors, from the same sum of modes: its opening is width + x_right − x_left.
TEST(StruckColumns, TheOpeningIsThatOfTheNode) {
  const Histories& histories = the_run().response.histories;
  const Problem& problem = the_run().problem;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const ContactPoint& point = problem.points[i];
    const auto x = [&](Eigen::Index b, Eigen::Index floor) -> Eigen::RowVectorXd {
      const Eigen::Index floors = problem.buildings[b].model.floors();
      return floor < floors ? histories.displacement[b].row(floor) : histories.node_displacement[b].row(floor - floors);
    };
    const Eigen::RowVectorXd expected =
        (x(point.left + 1, point.right_floor) - x(point.left, point.left_floor)).array() + point.width;
    EXPECT_LE((histories.opening.row(i) - expected).cwiseAbs().maxCoeff(), 1e-15) << i;
  }
}

// A frame whose period is asked for is the frame of another modulus: in every shear and moment, at rest and in motion.
TEST(StruckColumns, ACalibratedFrameIsOneOfAnotherModulus) {
  Case calibrated = the_case();
  for (BuildingSpec& building : calibrated.buildings) {
    building.calibrate_period = 0.6 * 2 * std::numbers::pi / make_building(building).first_omega();
  }
  const RunResults of_period = simulated(calibrated);
  Case scaled = the_case();
  for (std::size_t b = 0; b < 2; ++b) {
    const double factor = of_period.problem.buildings[b].model.stiffness_factor.value();
    EXPECT_NEAR(factor, 1 / 0.36, 1e-9);
    std::get<PlaneFrame>(scaled.buildings[b].structure).elastic_modulus *= factor;
  }
  const RunResults of_modulus = simulated(scaled);
  for (std::size_t b = 0; b < 2; ++b) {
    const StructuralModel& one = of_period.problem.buildings[b].model;
    const StructuralModel& other = of_modulus.problem.buildings[b].model;
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(one.dofs(), 1, 2);
    const Eigen::VectorXd forces = one.column_forces * one.stiffness.ldlt().solve(load);
    const Eigen::VectorXd expected = other.column_forces * other.stiffness.ldlt().solve(load);
    EXPECT_LE((forces - expected).norm(), 1e-12 * expected.norm()) << b;
    // Equilibrium at rest: both pieces of the column take the load at a node.
    for (Eigen::Index node = 0; node < one.nodes(); ++node) {
      EXPECT_NEAR(forces(6 * node) + forces(6 * node + 1), load(one.floors() + node), 1e-9 * forces.norm());
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const ColumnPeaks& one = of_period.response.points[i].column.value();
    const ColumnPeaks& other = of_modulus.response.points[i].column.value();
    for (const auto value : {&ColumnPeaks::shear, &ColumnPeaks::moment, &ColumnPeaks::shear_no_contact,
                             &ColumnPeaks::moment_no_contact, &ColumnPeaks::shear_below, &ColumnPeaks::shear_above,
                             &ColumnPeaks::moment_bottom, &ColumnPeaks::moment_node, &ColumnPeaks::moment_top}) {
      EXPECT_NEAR(one.*value, other.*value, 1e-7 * std::abs(other.*value)) << i;
    }
  }
  const Json told = Json::parse(summary_json(of_period, "1")).at("buildings");
  EXPECT_EQ(told.at(0).at("stiffness_factor"), of_period.problem.buildings[0].model.stiffness_factor.value());
  EXPECT_FALSE(Json::parse(summary_json(of_modulus, "1")).at("buildings").at(0).contains("stiffness_factor"));
  const std::string page = report_html(of_period, {.language = "en", .version = "1"});
  EXPECT_NE(page.find("All stiffness times</th><td>2.778"), std::string::npos);
}

// With contact out of reach a struck column bears what it bears alone, and what is told without contact is that.
TEST(StruckColumns, WithoutContactItIsTheFreeResponse) {
  Case c = the_case();
  c.gaps[0].widths.assign(4, 10.0);
  const RunResults apart = simulated(std::move(c));
  for (std::size_t i = 0; i < 3; ++i) {
    const ColumnPeaks& free = apart.response.points[i].column.value();
    const ColumnPeaks& struck = the_run().response.points[i].column.value();
    EXPECT_EQ(apart.response.points[i].impacts, 0);
    EXPECT_NEAR(free.shear, struck.shear_no_contact, 1e-9 * free.shear);
    EXPECT_NEAR(free.moment, struck.moment_no_contact, 1e-9 * free.moment);
    EXPECT_NEAR(free.shear, free.shear_no_contact, 1e-9 * free.shear);
  }
}

TEST(StruckColumns, TheSummaryTellsDemandOverCapacity) {
  const Json points = Json::parse(summary_json(the_run(), "1")).at("gaps").at(0).at("points");
  const double capacities[] = {400, 300, 400};
  for (std::size_t i = 0; i < 3; ++i) {
    const ColumnPeaks& peaks = the_run().response.points[i].column.value();
    const Json& column = points.at(i).at("column");
    EXPECT_EQ(points.at(i).at("struck"), i == 1 ? "West" : "East");
    EXPECT_EQ(column.at("peak_shear"), peaks.shear);
    EXPECT_EQ(column.at("peak_moment_no_contact"), peaks.moment_no_contact);
    EXPECT_EQ(column.at("shear_demand_capacity"), peaks.shear / capacities[i]);
    EXPECT_EQ(column.at("moment_demand_capacity"), peaks.moment / 350);
    EXPECT_EQ(column.at("demand_capacity"), std::max(peaks.shear / capacities[i], peaks.moment / 350));
  }
  for (const bool of_shear : {true, false}) {  // of one the demand over it alone
    Case one = the_case();
    (of_shear ? one.gaps[0].column_capacity->moment : one.gaps[0].column_capacity->shear).clear();
    const Json column =
        Json::parse(summary_json(simulated(std::move(one)), "1")).at("gaps").at(0).at("points").at(0).at("column");
    const ColumnPeaks& peaks = the_run().response.points[0].column.value();
    EXPECT_EQ(column.contains("shear_demand_capacity"), of_shear);
    EXPECT_EQ(column.contains("moment_demand_capacity"), !of_shear);
    EXPECT_EQ(column.at("demand_capacity"), of_shear ? peaks.shear / 400 : peaks.moment / 350);
    EXPECT_EQ(column.at("demand_capacity_no_contact"),
              of_shear ? peaks.shear_no_contact / 400 : peaks.moment_no_contact / 350);
  }
  EXPECT_FALSE(points.at(3).contains("column"));
  EXPECT_FALSE(points.at(3).contains("struck"));
  Case c = the_case();
  c.gaps[0].column_capacity.reset();
  const Json without = Json::parse(summary_json(simulated(std::move(c)), "1")).at("gaps").at(0).at("points").at(0);
  EXPECT_TRUE(without.at("column").contains("peak_shear"));
  EXPECT_FALSE(without.at("column").contains("demand_capacity"));
}

TEST(StruckColumns, TheListOfImpactsNamesThem) {
  const std::string csv = impacts_csv(the_run().view());
  EXPECT_EQ(csv.rfind("left,right,elevation [m],struck,start [s],", 0), 0U) << csv.substr(0, 60);
  EXPECT_NE(csv.find("\nWest,East,4.4,West,"), std::string::npos);
  EXPECT_NE(csv.find("\nWest,East,6,East,"), std::string::npos);
  EXPECT_NE(csv.find("\nWest,East,8.5,,"), std::string::npos) << "floors meet there";
}

TEST(StruckColumns, AreReadBackFromTheHistories) {
  const RunResults& run = the_run();
  const NetcdfReader file(histories_netcdf(run, "1"), "histories.nc");
  EXPECT_EQ(file.at("node_displacement_2").units, "m");
  EXPECT_EQ(file.at("node_shear_above_1").units, "kN");
  EXPECT_EQ(file.at("node_moment_top_2").units, "kN m");
  EXPECT_EQ(file.texts("point_struck"), (std::vector<std::string>{"East", "West", "East", ""}));
  EXPECT_TRUE(std::isnan(file.numbers("column_shear").at(3)));
  const RunResults read = read_run(file);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(read.problem.buildings[b].model.node_elevations, run.problem.buildings[b].model.node_elevations);
    EXPECT_EQ(read.response.histories.node_displacement[b], run.response.histories.node_displacement[b]);
    EXPECT_EQ(read.response.histories.column_forces[b], run.response.histories.column_forces[b]);
    EXPECT_EQ(read.response.course.column_forces[b], run.response.course.column_forces[b]);
  }
  for (const std::string key : {"column_shear", "column_moment_node", "column_moment_no_contact",
                                "column_demand_capacity", "column_demand_capacity_no_contact"}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Quantity& quantity = quantity_named(key, Owner::point);
      EXPECT_EQ(value_of(quantity, read.view(), {i, 0}), value_of(quantity, run.view(), {i, 0})) << key << i;
    }
    EXPECT_TRUE(std::isnan(value_of(quantity_named(key, Owner::point), read.view(), {3, 0}))) << key;
  }
  for (const char* kind : {"column-shear", "column-moment"}) {
    const Figure figure = make_figure(file, kind);
    ASSERT_FALSE(figure.panels.empty()) << kind;
    EXPECT_GE(figure.panels.back().curves.size(), 2U) << kind << " around the hardest impact";
    EXPECT_EQ(figure.panels[0].rules.size(), 4U) << "largest and capacity, on either side";
  }
  FigureOptions roofs;
  roofs.elevation = 8.5;
  EXPECT_THROW((void)make_figure(file, "column-shear", roofs), NoFigure);
}

TEST(StruckColumns, TheReportHasASectionOfThem) {
  for (const std::string language : {"en", "id"}) {
    const std::string page = report_html(the_run(), {.language = language, .version = "1"});
    EXPECT_NE(page.find("<section id=\"columns\">"), std::string::npos) << language;
    EXPECT_NE(page.find(language == "en" ? "column of West" : "kolom West"), std::string::npos) << "list of impacts";
    // The animation bends them: in a column of East stands, between its floors, what a struck node moves.
    for (const char* const struck : {"[3.0,1,", "[6.0,1,"}) EXPECT_NE(page.find(struck), std::string::npos) << struck;
  }
  Case c = the_case();
  c.gaps[0].elevations = {8.5};
  c.gaps[0].widths = {0.01};
  c.gaps[0].column_capacity.reset();
  EXPECT_EQ(report_html(simulated(std::move(c)), {.language = "en", .version = "1"}).find("<section id=\"columns\">"),
            std::string::npos)
      << "nothing is struck";
}

TEST(StruckColumns, AStudyKeepsWhatTheyBear) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "case.toml") << test::struck_columns;
  std::ofstream(folder.path() / "study.toml") << R"(case = 'case.toml'
[[vary]]
parameter = 'gap[0].width'
values = [0.005, 0.01, 10.0]
[[vary]]
parameter = 'gap[0].column_capacity.moment'
values = [350.0, 700.0]
)";
  SweepOptions options;
  options.output = folder.path() / "study.nc";
  options.threads = 1;
  Ranks alone;
  Diagnostics diagnostics;
  const auto report = sweep(folder.path() / "study.toml", options, alone, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(report && report->finished && report->failed == 0) << report->first_failure;
  const NetcdfReader file(options.output);
  const std::vector<double> shear = file.numbers("column_shear"), ratio = file.numbers("column_demand_capacity"),
                            moment = file.numbers("column_moment_demand_capacity");
  ASSERT_EQ(shear.size(), 3U * 2U * 4U);
  const auto at = [](std::size_t width, std::size_t capacity, std::size_t point) {
    return (width * 2 + capacity) * 4 + point;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const ColumnPeaks& column = the_run().response.points[i].column.value();
    EXPECT_NEAR(shear[at(1, 0, i)], column.shear, 1e-9 * column.shear);
    EXPECT_NEAR(shear[at(2, 0, i)], column.shear_no_contact, 1e-9 * column.shear);
    EXPECT_NEAR(moment[at(1, 0, i)], 2 * moment[at(1, 1, i)], 1e-12);
    EXPECT_GE(ratio[at(0, 0, i)], moment[at(0, 0, i)]);
  }
  EXPECT_TRUE(std::isnan(shear[at(1, 0, 3)])) << "roofs meet";
  const Figure figure = make_figure(file, "column_demand_capacity");
  EXPECT_FALSE(figure.panels.at(0).curves.empty());
}

}  // namespace
}  // namespace bentur
