// What is told of a fragility: of collapse and of the runs that stand each by itself.
#include "bentur/study/fragility/fragility_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

TEST(FragilityJson, CountsCollapseAndTheRunsThatStandApart) {
  OutcomeTable table{.levels = {1, 2}, .cases = 1, .records = 4, .outcomes = {}};
  const auto run = [&](bool event, bool collapsed) {
    table.outcomes.push_back(event || collapsed ? Outcome::event : Outcome::no_event);
    table.demands.push_back(event ? 4 : 2);
    table.collapsed.push_back(collapsed ? 1 : 0);
  };
  const bool at_high[][2] = {{true, false}, {true, true}, {true, false}, {false, false}};
  for (const auto& [event, collapsed] : at_high) {
    run(false, false);
    run(event, collapsed);
  }
  table.threshold = 3;
  IdaResults results;
  results.table = table;
  std::string error;
  const FragilityRequest request{.event = "drift > 3"};
  const auto report = fragility_report(results, request, error);
  ASSERT_TRUE(report) << error;
  const auto json = nlohmann::json::parse(fragility_json(*report, request, "0"));
  const auto& curve = json.at("curves").at(0);
  EXPECT_EQ(curve.at("events"), 3);
  EXPECT_EQ(curve.at("runs"), 8);
  EXPECT_EQ(curve.at("collapse").at("events"), 1);
  EXPECT_EQ(curve.at("collapse").at("runs"), 8);
  EXPECT_EQ(curve.at("standing").at("events"), 2);
  EXPECT_EQ(curve.at("standing").at("runs"), 7);
}

TEST(FragilityReport, StripesNeedLevels) {
  IdaResults results;
  results.table = {.levels = {0.0}, .cases = 1, .records = 3, .outcomes = std::vector<Outcome>(3)};
  results.table.own = {1, 2, 3};
  results.table.demands = {1, 2, 3};
  results.table.collapsed = {0, 0, 0};
  results.table.threshold = 2.5;
  std::string error;
  EXPECT_FALSE(fragility_report(results, {.event = "drift > 2.5", .method = FragilityMethod::stripes}, error));
  EXPECT_EQ(error, "--method stripes needs levels that all records are scaled to, and these are not scaled");
  const FragilityRequest request{.event = "drift > 2.5", .method = FragilityMethod::cloud};
  const auto report = fragility_report(results, request, error);
  ASSERT_TRUE(report) << error;
  const auto json = nlohmann::json::parse(fragility_json(*report, request, "0"));
  EXPECT_EQ(json.at("intensity").at("scaled"), false);
  EXPECT_TRUE(json.at("intensity").at("levels").empty());
  EXPECT_EQ(json.at("curves").at(0).at("counts").size(), 3U);
}

TEST(FragilityMethods, AreNamedInTheirOrder) {
  for (const std::string& name : fragility_methods()) EXPECT_EQ(name_of(fragility_method(name)), name);
  EXPECT_EQ(fragility_method("likelihood"), FragilityMethod::likelihood);
  EXPECT_EQ(fragility_method("cloud"), FragilityMethod::cloud);
  EXPECT_EQ(fragility_method("stripes"), FragilityMethod::stripes);
  EXPECT_THROW((void)fragility_method("guess"), InvalidParameter);
}

}  // namespace
}  // namespace bentur
