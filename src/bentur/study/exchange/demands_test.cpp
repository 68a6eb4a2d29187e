// Demands by hand; those of runs are in tests/sweep/exchange_test.py.
#include "bentur/study/exchange/demands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace bentur {
namespace {

constexpr double none = NAN;

/// Results of a study as they would be read from a file.
class Results final : public ResultSource {
 public:
  void add(const std::string& name, std::vector<std::string> dimensions, std::vector<std::size_t> shape,
           std::vector<double> values, const std::string& units = "1", const std::string& building = "") {
    variables_.push_back({name, units, "", std::move(dimensions), std::move(shape), {}, false});
    values_[name] = std::move(values);
    buildings_[name] = building;
  }
  void remove(const std::string& name) {
    std::erase_if(variables_, [&](const StoredVariable& one) { return one.name == name; });
  }

  [[nodiscard]] const std::vector<StoredVariable>& variables() const noexcept override { return variables_; }
  [[nodiscard]] std::size_t dimension_size(std::string_view) const override { return 0; }
  [[nodiscard]] std::vector<double> numbers(std::string_view name) const override {
    return values_.at(std::string(name));
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view, std::size_t) const override { return {}; }
  [[nodiscard]] std::vector<std::string> texts(std::string_view) const override { return {}; }
  [[nodiscard]] std::string attribute(std::string_view name, const std::string&) const override {
    return buildings_.at(std::string(name));
  }
  [[nodiscard]] std::string attribute(const std::string&) const override { return {}; }
  [[noreturn]] void fail(const std::string& why) const override { throw std::runtime_error(why); }

 private:
  std::vector<StoredVariable> variables_;
  std::map<std::string, std::vector<double>> values_;
  std::map<std::string, std::string> buildings_;
};

/// Three runs, the second of which failed: "Planes" of two floors, "Edges" of one, a wall, "Lone" with a plane along x
/// alone, and "Carried" of a slab and a floor.
Results three_runs() {
  Results made;
  const auto of_runs = [&](const std::string& name, std::vector<double> values, const std::string& units) {
    made.add(name, {"gap"}, {3}, std::move(values), units);
  };
  of_runs("status", {0, 1, 0}, "");
  of_runs("message", {0, 0, 0}, "");
  of_runs("gap", {1, 2, 3}, "cm");
  of_runs("peak_ground_acceleration_x", {100, none, 110}, "cm s-2");
  of_runs("peak_ground_acceleration_y", {50, none, 60}, "cm s-2");
  const auto of_floors = [&](const std::string& name, const std::string& building, std::size_t floors,
                             std::vector<double> values, const std::string& units = "1") {
    made.add(name, {"gap", "elevation"}, {3, floors}, std::move(values), units, building);
  };
  const auto of_planes = [&](const std::string& name, const std::string& building, std::size_t planes,
                             std::size_t floors, std::vector<double> values) {
    made.add(name, {"gap", "plane", "elevation"}, {3, planes, floors}, std::move(values), "1", building);
  };
  of_floors("peak_acceleration_x_1", "Planes", 2, {200, 300, none, none, 220, 330}, "cm s-2");
  of_floors("peak_acceleration_y_1", "Planes", 2, {20, 30, none, none, 22, 33}, "cm s-2");
  made.add("plane_angle_1", {"plane"}, {4}, {0, 90, 30, 180}, "degree");
  of_planes("plane_peak_drift_ratio_1", "Planes", 4, 2,
            {0.01,  0.02,  0.05,  0.06,  0.03, 0.01,  0.02,  0.015,  // of the planes one after the other
             none,  none,  none,  none,  none, none,  none,  none,   // the run that failed
             0.001, 0.002, 0.005, 0.006, 0.0,  0.001, 0.004, 0.0005});
  of_planes("plane_residual_drift_ratio_1", "Planes", 4, 2,
            {0.001,   -0.002, none, none, -0.003, 0.001, none, none,  // two planes along x yield
             none,    none,   none, none, none,   none,  none, none,  //
             -0.0001, 0,      none, none, 0.0002, 0,     none, none});
  for (const auto& [name, number] : {std::pair("Edges", "2"), std::pair("Wall", "3"), std::pair("Lone", "4")}) {
    for (const char* const axis : {"x_", "y_"}) {
      of_floors(std::string("peak_acceleration_") + axis + number, name, 1, {10, none, 20}, "cm s-2");
    }
  }
  of_floors("peak_drift_ratio_south_2", "Edges", 1, {0.01, none, 0.02});
  of_floors("peak_drift_ratio_north_2", "Edges", 1, {0.03, none, 0.01});
  of_floors("peak_drift_ratio_west_2", "Edges", 1, {0.001, none, 0.002});
  of_floors("peak_drift_ratio_east_2", "Edges", 1, {0.0005, none, 0.004});
  made.add("plane_angle_4", {"plane"}, {1}, {0}, "degree");
  of_planes("plane_peak_drift_ratio_4", "Lone", 1, 1, {0.01, none, 0.02});
  of_floors("peak_acceleration_x_5", "Carried", 2, {80, 90, none, none, 81, 91}, "cm s-2");
  of_floors("peak_acceleration_y_5", "Carried", 2, {40, 45, none, none, 41, 46}, "cm s-2");
  made.add("plane_angle_5", {"plane"}, {2}, {-90, 45}, "degree");
  of_planes("plane_peak_drift_ratio_5", "Carried", 2, 2,
            {none, 0.01, none, 0.02, none, none, none, none, none, 0.03, none, 0.01});
  return made;
}

std::string error_of(const Results& results, const std::string& building) {
  try {
    (void)demand_sample(results, {.building = building});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanDemands, GoAlongBothAxes) {
  const Demands demands = demand_sample(three_runs(), {.building = "Planes"});
  EXPECT_EQ(demands.csv,
            "realization by bentur,1-PFA-0-1,1-PFA-1-1,1-PFA-2-1,1-PFA-0-2,1-PFA-1-2,1-PFA-2-2,"
            "1-PID-1-1,1-PID-2-1,1-PID-1-2,1-PID-2-2,1-RID-1-1,1-RID-2-1,1-ERROR\n"
            "Units,mps2,mps2,mps2,mps2,mps2,mps2,unitless,unitless,unitless,unitless,unitless,unitless,unitless\n"
            "0,1,2,3,0.5,0.2,0.3,0.03,0.02,0.05,0.06,0.003,0.002,0\n"
            "1,,,,,,,,,,,,,1\n"
            "2,1.1,2.2,3.3000000000000003,0.6,0.22,0.33,0.004,0.002,0.005,0.006,0.0002,0,0\n");
  EXPECT_EQ(demands.runs, 3U);
  EXPECT_EQ(demands.errors, 1U);
}

TEST(PlanDemands, OfEdgesWithoutPlanes) {
  const Demands demands = demand_sample(three_runs(), {.building = "Edges", .only = {{"gap", "3"}}});
  EXPECT_EQ(demands.csv,
            "realization by bentur,1-PFA-0-1,1-PFA-1-1,1-PFA-0-2,1-PFA-1-2,1-PID-1-1,1-PID-1-2,1-ERROR\n"
            "Units,mps2,mps2,mps2,mps2,unitless,unitless,unitless\n"
            "0,1.1,0.2,0.6,0.2,0.02,0.004,0\n");
}

/// A slab is a floor, but no storey is below it; a plane at 45 degrees counts for both axes.
TEST(PlanDemands, NoStoreyIsBelowASlab) {
  const Demands demands = demand_sample(three_runs(), {.building = "Carried", .only = {{"gap", "1"}}});
  EXPECT_EQ(demands.csv,
            "realization by bentur,1-PFA-0-1,1-PFA-1-1,1-PFA-2-1,1-PFA-0-2,1-PFA-1-2,1-PFA-2-2,1-PID-2-1,1-PID-2-2,"
            "1-ERROR\n"
            "Units,mps2,mps2,mps2,mps2,mps2,mps2,unitless,unitless,unitless\n"
            "0,1,0.8,0.9,0.5,0.4,0.45,0.02,0.02,0\n");
}

TEST(Demands, OfARowNoStoreyIsBelowASlab) {
  Results row;
  row.add("status", {"gap"}, {1}, {0});
  row.add("message", {"gap"}, {1}, {0});
  row.add("peak_ground_acceleration", {"gap"}, {1}, {2}, "m s-2");
  row.add("peak_acceleration_2", {"gap", "elevation"}, {1, 3}, {1, 3, 4}, "m s-2", "B");
  row.add("peak_drift_ratio_2", {"gap", "elevation"}, {1, 3}, {none, 0.01, 0.02}, "1", "B");
  row.add("residual_drift_ratio_2", {"gap", "elevation"}, {1, 3}, {none, -0.001, none}, "1", "B");
  EXPECT_EQ(demand_sample(row, {.building = "B"}).csv,
            "realization by bentur,1-PFA-0-1,1-PFA-1-1,1-PFA-2-1,1-PFA-3-1,1-PID-2-1,1-PID-3-1,1-RID-2-1,1-ERROR\n"
            "Units,mps2,mps2,mps2,mps2,unitless,unitless,unitless,unitless\n"
            "0,2,1,3,4,0.01,0.02,0.001,0\n");
}

TEST(PlanDemands, WhatCannotBeToldIsNamed) {
  Results results = three_runs();
  EXPECT_EQ(error_of(results, "Barn"), "has no building \"Barn\"; there are Planes, Edges, Wall, Lone, Carried");
  EXPECT_EQ(error_of(results, "Wall"), "has no drifts of building \"Wall\": it moves with the ground");
  EXPECT_EQ(error_of(results, "Lone"),
            "has no drifts along y of building \"Lone\": none of its planes is along it. Give the case one, or hold "
            "the building by rigidity alone, whose edges tell their drifts");
  results.remove("plane_angle_1");
  EXPECT_EQ(error_of(results, "Planes"),
            "has no plane_angle_1, which tells planes along x from those along y: they turn between runs, or an "
            "earlier version wrote it");
  results.remove("peak_ground_acceleration_y");
  EXPECT_EQ(error_of(results, "Edges"), "has no peak_ground_acceleration_y, which demands need");
}

}  // namespace
}  // namespace bentur
