// Bearings and planes of buildings in plan in studies.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "bentur/study/study_variables.h"
#include "tests/support/plan_study.h"

namespace bentur {
namespace {

class PlanPlaces : public test::PlanStudy {};

const std::string on_bearings = R"(isolation = { mass = 90, bearing = [
  { at = [[1, 1], [8, 3]], stiffness = 4e3 },
  { at = [4, 17], stiffness = 3e3, characteristic_strength = 30, yield_displacement = 0.01 }] }
)";

/// What each bearing bears and how it yields is kept for each run, as that of the case alone.
TEST_F(PlanPlaces, TellOfBearings) {
  put(case_, "name = \"Frame\"\n", "name = \"Frame\"\n" + on_bearings);
  const auto runs = runs_of(
      "[[vary]]\nparameter = 'building[1].isolation.bearing[1].characteristic_strength'\nname = 'strength'\n"
      "values = [20.0, 60.0]\n");
  ASSERT_TRUE(runs) << first_error();
  std::vector<double> energies;
  for (const RunResult& result : runs->solve(std::vector<std::size_t>{0, 1}, [] { return true; })) {
    ASSERT_EQ(result.status, RunStatus::done) << result.message;
    const auto level = runs->choices(result.run)[0].level;
    const std::vector<double> row = alone(*runs, [&](std::string& text) {
      put(text, "characteristic_strength = 30",
          level == 0 ? "characteristic_strength = 20.0" : "characteristic_strength = 60.0");
    });
    test::expect_same(result.values, row, runs->quantities());
    for (const RowPart& part : runs->quantities()) {
      if (!part.name.starts_with("bearing_")) continue;
      EXPECT_TRUE(part.name.ends_with("_2")) << part.name << ": one building stands on bearings";
      ASSERT_EQ(part.count, 3) << part.name;
      const bool of_yield =
          part.name.find("residual") != std::string::npos || part.name.find("hysteretic") != std::string::npos;
      EXPECT_EQ(std::isnan(row[part.first]), of_yield) << part.name << ": the first stays elastic";
      EXPECT_FALSE(std::isnan(row[part.first + 2])) << part.name;
      if (part.name == "bearing_hysteretic_energy_2") energies.push_back(row[part.first + 2]);
    }
  }
  ASSERT_EQ(energies.size(), 2);
  EXPECT_GT(energies[0], 1);  // [kN m]
  EXPECT_NE(energies[0], energies[1]);
  std::map<std::string, StudyVariable> told;
  for (StudyVariable& variable : study_file(*runs, "0").variables) told[variable.name] = std::move(variable);
  const auto dimensions = [&](const std::string& name) {
    std::vector<std::string> names;
    for (const ResultDimension& dimension : told[name].dimensions) names.push_back(dimension.name);
    return names;
  };
  EXPECT_EQ(dimensions("bearing_peak_force_x_2"), (std::vector<std::string>{"strength", "bearing_2"}));
  EXPECT_EQ(dimensions("bearing_residual_y_2"), (std::vector<std::string>{"strength", "bearing_2"}));
  EXPECT_EQ(std::get<std::vector<double>>(told["bearing_x_2"].values), (std::vector<double>{13.02, 20.02, 16.02}));
  EXPECT_EQ(std::get<std::vector<double>>(told["bearing_y_2"].values), (std::vector<double>{1, 3, 17}));
  EXPECT_EQ(told.count("bearing_x_1") + told.count("bearing_peak_force_x_1"), 0);
}

TEST_F(PlanPlaces, BearingsThatMoveHaveNoPlace) {
  put(case_, "name = \"Frame\"\n", "name = \"Frame\"\n" + on_bearings);
  const auto runs =
      runs_of("[[vary]]\nparameter = 'building[1].plan.corner[0]'\nname = 'corner'\nvalues = [12.01, 12.03]\n");
  ASSERT_TRUE(runs) << first_error();
  bool kept = false;
  for (const StudyVariable& variable : study_file(*runs, "0").variables) {
    EXPECT_NE(variable.name, "bearing_x_2");
    kept = kept || variable.name == "bearing_peak_displacement_x_2";
  }
  EXPECT_TRUE(kept);
}

/// Of elastic bearings nothing is told of yielding, so that which can yield is the same in all runs.
TEST_F(PlanPlaces, BearingsThatYieldInSomeRunsAreAnError) {
  std::string elastic = on_bearings;
  put(elastic, ", characteristic_strength = 30, yield_displacement = 0.01", "");
  put(case_, "name = \"Frame\"\n", "name = \"Frame\"\n" + elastic);
  ASSERT_TRUE(runs_of("[[vary]]\nparameter = 'building[1].isolation.mass'\nvalues = [80.0, 90.0]\n")) << first_error();
  EXPECT_FALSE(runs_of(
      "[[vary]]\nparameter = 'building[1].isolation.bearing[1]'\nlabels = ['elastic', 'yielding']\nvalues = [{ at = "
      "[4, "
      "17], stiffness = 3e3 }, { at = [4, 17], stiffness = 3e3, characteristic_strength = 30, yield_displacement = "
      "0.01 }]\n"));
  EXPECT_NE(first_error().find("numbers of floors, planes, bearings and contact points"), std::string::npos)
      << first_error();
}

TEST_F(PlanPlaces, PlanesThatTurnHaveNoAngle) {
  const auto angles = [&](const std::string& vary) {
    const auto runs = runs_of(vary);
    if (!runs) ADD_FAILURE() << first_error();
    for (const StudyVariable& variable : study_file(*runs, "0").variables) {
      if (variable.name == "plane_angle_1") return std::get<std::vector<double>>(variable.values);
    }
    return std::vector<double>{};
  };
  put(case_, "along = \"y\"\nat = 12.0\n", "angle = 120\nthrough = [12, 0]\n");
  const std::vector<double> still = angles("[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.1, 0.3]\n");
  ASSERT_EQ(still.size(), 4);
  EXPECT_EQ((std::vector<double>{still.begin(), still.begin() + 3}), (std::vector<double>{0, 0, 90}));
  EXPECT_NEAR(still[3], 120, 1e-12);
  EXPECT_TRUE(
      angles("[[vary]]\nparameter = 'building[0].plane[3].angle'\nname = 'turned'\nvalues = [100.0, 120.0]\n").empty());
}

}  // namespace
}  // namespace bentur
