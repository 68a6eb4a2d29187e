#include "bentur/report/run_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bentur/model/run_results.h"
#include "tests/support/drawn_run.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

std::string example(const std::string& name) {
  std::ifstream stream(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

RunTables tables_of(const RunResults& run) { return run_tables(run.view(), run.c, Words("en")); }

std::vector<std::string> labels(const RunTable& table) {
  std::vector<std::string> all;
  for (const TableColumn& column : table.columns) all.push_back(column.label);
  return all;
}

const TableColumn& named(const RunTable& table, const std::string& label) {
  return *std::find_if(table.columns.begin(), table.columns.end(),
                       [&](const TableColumn& column) { return column.label == label; });
}

bool has(const RunTable& table, const std::string& label) {
  const std::vector<std::string> all = labels(table);
  return std::find(all.begin(), all.end(), label) != all.end();
}

/// What contact loses is a column only where it loses something.
TEST(RunTables, OfElasticContactHaveNoLosses) {
  const RunResults elastic = test::drawn_run(example("m12-el-centro"));
  const RunResults lossy = test::drawn_run(example("kelvin-voigt-pair"));
  EXPECT_TRUE(is_elastic(elastic.response.points));
  EXPECT_FALSE(is_elastic(lossy.response.points));
  const std::string lost(quantity_named("energy_lost", Owner::point).label[0]);
  EXPECT_FALSE(has(tables_of(elastic).contacts.at(0).points, lost));
  EXPECT_TRUE(has(tables_of(lossy).contacts.at(0).points, lost));
  EXPECT_FALSE(has(impact_table(elastic.view(), {0}, Words("en")), lost));
  EXPECT_TRUE(has(impact_table(lossy.view(), {0}, Words("en")), lost));
}

/// The highest level first, with the numbers of the response.
TEST(RunTables, StandFromTheTopDown) {
  const RunResults run = test::drawn_run(example("m12-el-centro"));
  const RunTable points = tables_of(run).contacts.at(0).points;
  const std::vector<double>& levels = named(points, "Level").values;
  EXPECT_TRUE(std::is_sorted(levels.rbegin(), levels.rend()));
  ASSERT_EQ(points.places.size(), levels.size());
  const std::vector<std::string>& impacts = named(points, "Impacts").cells;
  for (std::size_t row = 0; row < impacts.size(); ++row) {
    EXPECT_EQ(impacts[row], std::to_string(run.response.points[points.places[row].item].impacts));
  }
  const RunTable struck = points.where([](const QuantityPlace& at) { return at.item == 1; });
  ASSERT_EQ(struck.places.size(), 1U);
  EXPECT_EQ(named(struck, "Level").cells.size(), 1U);
  EXPECT_EQ(named(struck, "Level").values, std::vector<double>{run.problem.points[1].elevation});
}

/// A floor that strikes a column: what it strikes stands in the list of impacts too, and the column in a table.
TEST(RunTables, NameTheColumnThatIsStruck) {
  const RunResults run = test::drawn_run(example("breaking-column"));
  const RunTable struck = tables_of(run).struck;
  ASSERT_FALSE(struck.is_empty());
  EXPECT_EQ(named(struck, "Struck").cells, std::vector<std::string>{"Old frame"});
  EXPECT_TRUE(named(struck, "Struck").is_words);
  EXPECT_NE(named(impact_table(run.view(), {0}, Words("en")), "Struck").cells.at(0).find("Old frame"),
            std::string::npos);
  EXPECT_TRUE(tables_of(test::drawn_run(example("m12-el-centro"))).struck.is_empty());
}

/// Buildings in plan have places with x and y, planes, and bearings where there is a slab; rows have none.
TEST(RunTables, OfBuildingsInPlanHavePlaces) {
  const PlanRun run = test::plan_run(test::twisting_pair());
  const RunTables tables = run_tables(run, Words("en"));
  const std::vector<std::string> places = labels(tables.contacts.at(0).points);
  EXPECT_EQ(std::vector<std::string>(places.begin(), places.begin() + 3),
            (std::vector<std::string>{"Level", "x", "y"}));
  EXPECT_FALSE(tables.buildings.at(0).planes.is_empty());
  EXPECT_TRUE(tables.buildings.at(0).bearings.is_empty());
  EXPECT_TRUE(tables.buildings.at(0).foundation.is_empty());
  const RunTable impacts = impact_table(run, {1, 0}, Words("en"));
  EXPECT_EQ(impacts.columns.at(0).cells, (std::vector<std::string>{"2", "1"}));
  EXPECT_TRUE(has(impacts, "y"));
  EXPECT_FALSE(has(impacts, "Struck"));
  EXPECT_TRUE(tables_of(test::drawn_run(example("m12-el-centro"))).buildings.at(0).planes.is_empty());
}

/// Sway and rocking of a foundation in a row are a table as those in plan.
TEST(RunTables, OfABuildingOnSoilHaveItsFoundation) {
  const RunResults run = test::drawn_run(example("generic-neighbour"));
  const std::vector<BuildingTables> buildings = tables_of(run).buildings;
  const auto on_soil = std::find_if(buildings.begin(), buildings.end(),
                                    [](const BuildingTables& one) { return !one.foundation.is_empty(); });
  ASSERT_NE(on_soil, buildings.end());
  EXPECT_EQ(labels(on_soil->foundation), (std::vector<std::string>{"Sway", "Rocking"}));
}

}  // namespace
}  // namespace bentur
