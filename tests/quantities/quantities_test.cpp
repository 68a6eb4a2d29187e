// A quantity is one line of a table. Here one of each owner is added to it, and found in everything that is told of a
// run or a study.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/run_results.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/report.h"
#include "bentur/report/studies/file_kinds.h"
#include "bentur/runner/sweep.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string example = std::string(BENTUR_SOURCE_DIR) + "/examples/free-impact.toml";

/// 100 · item + floor + 7, so that each place has a value of its own.
double made_up(const RunView&, const QuantityPlace& at) {
  return 100.0 * static_cast<double>(at.item) + static_cast<double>(at.floor) + 7;
}

struct Added {
  Owner owner;
  std::string key;
};
const std::vector<Added> added = {{Owner::run, "made_up_of_run"},     {Owner::building, "made_up_of_building"},
                                  {Owner::floor, "made_up_of_floor"}, {Owner::point, "made_up_of_point"},
                                  {Owner::gap, "made_up_of_gap"},     {Owner::impact, "made_up_of_impact"},
                                  {Owner::link, "made_up_of_link"},   {Owner::hinge, "made_up_of_hinge"}};

class NewQuantity : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const Added& one : added) {
      add_quantity({.key = one.key,
                    .owner = one.owner,
                    .units = "F s",
                    .symbol = "M",
                    .long_name = "made up",
                    .label = {"Made up", "Buatan"},
                    .source = {.row = {.value = made_up}}});
    }
    Diagnostics diagnostics;
    Case c = read_case(example, diagnostics).value();
    c.links = {{.elevations = c.gaps[0].elevations, .numbers = {{"damping", {1}}}}};
    Problem problem = make_problem(c);
    SolveOptions options;
    options.output_step = 0.01;
    Response response = solve(problem, c.analysis.solver, options);
    ASSERT_FALSE(response.impacts.empty());
    results = new RunResults(run_results(std::move(c), std::move(problem), std::move(response)));
  }
  static void TearDownTestSuite() { delete results; }

  static RunResults* results;
};
RunResults* NewQuantity::results = nullptr;

TEST_F(NewQuantity, IsInTheSummary) {
  const Json json = Json::parse(summary_json(*results, "1"));
  EXPECT_EQ(json.at("made_up_of_run"), 7);
  EXPECT_EQ(json.at("buildings").at(1).at("made_up_of_building"), 107);
  EXPECT_EQ(json.at("buildings").at(1).at("made_up_of_floor").at(0), 107);
  EXPECT_EQ(json.at("gaps").at(0).at("made_up_of_gap"), 7);
  EXPECT_EQ(json.at("gaps").at(0).at("points").at(0).at("made_up_of_point"), 7);
  EXPECT_EQ(json.at("links").at(0).at("points").at(0).at("made_up_of_link"), 7);
}

TEST_F(NewQuantity, IsInTheListOfImpacts) {
  const std::string csv = impacts_csv(results->view());
  const std::string unit = results->c.units.force + " s";
  EXPECT_NE(csv.find(",made_up_of_impact [" + unit + "]\n"), std::string::npos) << csv.substr(0, csv.find('\n'));
  EXPECT_NE(csv.find(",7\n"), std::string::npos);
}

TEST_F(NewQuantity, IsInTheHistories) {
  const NetcdfReader file(histories_netcdf(*results, "1"), "histories.nc");
  for (const std::string name : {"made_up_of_run", "made_up_of_building_1", "made_up_of_floor_1", "made_up_of_gap",
                                 "made_up_of_point", "impact_made_up_of_impact", "link_made_up_of_link"}) {
    EXPECT_EQ(file.numbers(name).at(0), 7) << name;
    EXPECT_EQ(file.at(name).units, results->c.units.force + " s") << name;
    EXPECT_EQ(file.at(name).long_name.rfind("made up", 0), 0U) << name;
    EXPECT_EQ(file.attribute(name, "symbol"), "M") << name;
  }
}

TEST_F(NewQuantity, HasItsColumnInTables) {
  for (const std::size_t language : {0U, 1U}) {
    for (const Owner owner : {Owner::floor, Owner::point, Owner::impact, Owner::link}) {
      const std::vector<TableColumn> columns = table_columns(owner, results->view(), {{0, 0}}, language);
      EXPECT_EQ(columns.back().label, language == 0 ? "Made up" : "Buatan");
      EXPECT_EQ(columns.back().unit, "kN·s") << "of a run in newtons with large forces";
      EXPECT_EQ(columns.back().cells, std::vector<std::string>{"0.007"});
    }
  }
}

TEST_F(NewQuantity, IsInTheReport) {
  EXPECT_NE(report_html(*results, {.language = "en", .version = "1"}).find("Made up"), std::string::npos);
  EXPECT_NE(report_html(*results, {.language = "id", .version = "1"}).find("Buatan"), std::string::npos);
}

TEST_F(NewQuantity, IsKeptOfEveryRunOfAStudyAndCanBeDrawn) {
  const TemporaryFolder folder;
  const fs::path study = folder.path() / "study.toml", output = folder.path() / "study.nc";
  std::ofstream(study) << "case = '" << example << "'\n[[vary]]\nparameter = 'gap[0].width'\nfrom = 0.01\nto = 0.02\n"
                       << "count = 3\n";
  Diagnostics diagnostics;
  Ranks alone;
  SweepOptions options;
  options.output = output;
  options.threads = 1;
  const auto report = sweep(study, options, alone, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(report && report->finished && report->failed == 0) << report->first_failure;
  const NetcdfReader file(output);
  for (const Added& one : added) {
    if (one.owner == Owner::impact) continue;                             // as many as there happen to be
    if (one.owner == Owner::link || one.owner == Owner::hinge) continue;  // the example has none
    const bool numbered = one.owner == Owner::building || one.owner == Owner::floor;
    EXPECT_EQ(file.numbers(one.key + (numbered ? "_1" : "")).at(0), 7) << one.key;
    EXPECT_FALSE(make_figure(file, one.key).panels.empty()) << one.key;
  }
}

const std::string without_contact = "_no_contact";

bool is_there(const std::string& key, Owner owner) {
  return std::any_of(quantities().begin(), quantities().end(),
                     [&](const Quantity& one) { return one.key == key && one.owner == owner; });
}

/// Of what is the same in another direction the key in the first one, empty of all others.
std::string first_direction(const std::string& key) {
  for (const std::string other : {"_y", "_north", "_west", "_east"}) {
    const std::string first = other == "_y" ? "_x" : "_south";
    if (key.ends_with(other)) return key.substr(0, key.size() - other.size()) + first;
    if (key.ends_with(other + without_contact)) {
      return key.substr(0, key.size() - other.size() - without_contact.size()) + first + without_contact;
    }
  }
  return "";
}

/// "| `peak_force` | point | force | max F | largest contact force |", a row of docs/result-quantities.md: of all that
/// differ in nothing but their owner, with what they are in other directions and with contact switched off.
std::string row_of(const Quantity& quantity) {
  const std::string_view owners[] = {"run",    "building", "floor", "plane",  "point",  "gap",
                                     "impact", "link",     "hinge", "column", "bearing"};
  std::string unit = unit_text(quantity.units, {.length = "length", .force = "force"}), symbol, owner;
  for (const char c : quantity.symbol) symbol += c == '|' ? "\\|" : std::string(1, c);
  for (const Quantity& one : quantities()) {
    if (one.key == quantity.key && one.units == quantity.units && one.symbol == quantity.symbol &&
        one.long_name == quantity.long_name)
      owner += (owner.empty() ? "" : ", ") + std::string(owners[static_cast<int>(one.owner)]);
  }
  const bool both = is_there(std::string(quantity.key) + without_contact, quantity.owner);
  std::string directions;
  for (const std::string other : {"y", "north", "west", "east"}) {
    for (const Quantity& one : quantities()) {
      const std::string_view key = one.key;
      if (one.owner == quantity.owner && key.ends_with("_" + other) &&
          first_direction(std::string(key)) == quantity.key)
        directions += ", `…_" + other + "`";
    }
  }
  return fmt::format("| `{}`{}{} | {} | {} | {} | {} |\n", quantity.key, directions, both ? ", `…_no_contact`" : "",
                     owner, unit.empty() ? "–" : unit, symbol.empty() ? "–" : symbol, quantity.long_name);
}

TEST(Quantities, EveryOneIsInTheDocuments) {
  std::ifstream stream(std::string(BENTUR_SOURCE_DIR) + "/docs/result-quantities.md");
  const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  for (const Quantity& quantity : quantities()) {
    const std::string key(quantity.key);
    const bool is_twin =
        key.ends_with(without_contact) && is_there(key.substr(0, key.size() - without_contact.size()), quantity.owner);
    const bool is_other_direction = is_there(first_direction(key), quantity.owner);
    if (quantity.long_name == "made up" || is_twin || is_other_direction) continue;  // the row of its twin has it
    EXPECT_NE(page.find(row_of(quantity)), std::string::npos) << row_of(quantity);
  }
}

/// What rows and plans both have has the same name in both; along x and y it ends in the axis, and what storeys do by
/// themselves is told of planes. What is left rows have alone.
TEST(Quantities, PlansHaveThoseOfRows) {
  std::set<std::string> alone;
  const auto has = [](const std::string& key, Owner owner) {
    return std::any_of(quantities().begin(), quantities().end(), [&](const Quantity& one) {
      return one.key == key && one.owner == owner && one.source.plan.value;
    });
  };
  const auto along = [](std::string key, const char* axis) {
    const std::size_t end = key.find("_no_contact");
    return key.insert(end == std::string::npos ? key.size() : end, axis);
  };
  for (const Quantity& quantity : quantities()) {
    const std::string key(quantity.key);
    if (!quantity.source.row.value || quantity.long_name == "made up") continue;
    const bool is_along = has(along(key, "_x"), quantity.owner) && has(along(key, "_y"), quantity.owner);
    const bool of_planes = quantity.owner == Owner::floor && has(key, Owner::plane);
    if (!has(key, quantity.owner) && !is_along && !of_planes) alone.insert(key);
  }
  std::erase_if(alone, [](const std::string& key) { return key.starts_with("infill_") || key.starts_with("column_"); });
  EXPECT_TRUE(alone.empty()) << fmt::format("{}", fmt::join(alone, ", "));
}

}  // namespace
}  // namespace bentur
