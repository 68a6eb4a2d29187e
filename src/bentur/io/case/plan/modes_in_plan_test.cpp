// Buildings in plan that are known by their modes, against the planes that these are of and against rows.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bentur/io/results/result_json.h"
#include "bentur/model/story/hand_in.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Json = nlohmann::json;

std::string list(const std::vector<double>& values) { return fmt::format("[{:.17g}]", fmt::join(values, ", ")); }

/// Modes of a building that has been solved, of any scale, as a table. @param count how many, the longest first
std::string told(const Modes& modes, Index count) {
  std::string periods, shapes;
  for (Index mode = 0; mode < count; ++mode) {
    const Eigen::VectorXd shape = (static_cast<double>(mode) + 2.5) * modes.shapes.col(mode);
    periods += fmt::format("{}{:.17g}", mode > 0 ? ", " : "", 2 * std::numbers::pi / modes.omega(mode));
    shapes += (mode > 0 ? ", " : "") + list({shape.begin(), shape.end()});
  }
  return "[building.modal]\nperiods = [" + periods + "]\nshapes = [" + shapes + "]\n";
}

/// @param holds what holds the storeys of the first
std::string two(const std::string& holds) {
  return R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.1
contact = { law = "kelvin-voigt-approach", stiffness = 4e5, restitution = 0.6, friction = 0.3 }
[[building]]
name = "A"
damping = 0.04
[building.plan]
corner = [0, 0]
size = [12, 18]
storey_heights = [3.5, 3.2]
masses = [200, 180]
centres_of_mass = [[6.2, 8.7], [6.0, 9.0]]
)" + holds +
         R"(
[[building]]
name = "B"
damping = 0.05
[building.plan]
corner = [12.02, 4]
size = [9, 20]
storey_heights = [3.5, 3.2]
masses = [100, 90]
[building.rigidity]
centre = [4, 9]
x = 5e4
y = 6e4
torsion = 3e6
[excitation]
kind = "harmonic"
period = 0.6
displacement_amplitude = 0.05
[excitation.y]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
[analysis]
duration = 4
)";
}

const std::string planes = R"(
[[building.plane]]
along = "x"
at = 0.5
stiffnesses = [9e4, 7e4]
[[building.plane]]
along = "x"
at = 17
stiffnesses = [4e4, 3e4]
[[building.plane]]
along = "y"
at = 7
stiffnesses = 8e4
)";

/// Differences of numbers, relative to the largest of either list.
void expect_near(const Eigen::Ref<const MatrixXd>& found, const Eigen::Ref<const MatrixXd>& expected, double part,
                 const char* what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  if (expected.size() == 0) return;
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), part * expected.cwiseAbs().maxCoeff()) << what;
}

/// Every number of one value of JSON is that of the other; lists are held to their largest.
void expect_same(const Json& found, const Json& expected, const std::string& at, double largest = 0) {
  constexpr double part = 1e-9;  // round-off of modes, grown by four seconds of impacts
  if (expected.is_number()) {
    const double size = std::max(largest, std::abs(expected.get<double>()));
    EXPECT_NEAR(found.get<double>(), expected.get<double>(), part * size) << at;
    return;
  }
  ASSERT_EQ(found.type(), expected.type()) << at;
  if (expected.is_array()) {
    ASSERT_EQ(found.size(), expected.size()) << at;  // edges drift in place of planes
    double most = 0;
    for (const Json& one : expected) most = std::max(most, one.is_number() ? std::abs(one.get<double>()) : 0.0);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expect_same(found[i], expected[i], fmt::format("{}[{}]", at, i), most);
    }
  } else if (expected.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      if (key != "planes") expect_same(found.at(key), value, at + "." + key);  // which modes say nothing of
    }
  } else {
    EXPECT_EQ(found, expected) << at;
  }
}

/// All that is told and all histories: with every mode the planes and the modes are one building.
TEST(ModesInPlan, AllOfThemAreThePlanesTheyAreOf) {
  const PlanRun by_planes = test::plan_run(two(planes));
  const PlanRun by_modes = test::plan_run(two(told(by_planes.problem.buildings[0].modes, 6)));
  ASSERT_GT(by_planes.response.impacts.size(), 5U);
  Json found = Json::parse(summary_json(by_modes, "x")), expected = Json::parse(summary_json(by_planes, "x"));
  EXPECT_EQ(found["buildings"][0]["modal"]["modes"], 6);
  found["buildings"][0].erase("modal");
  expect_same(found["buildings"], expected["buildings"], "buildings");
  expect_same(found["gaps"], expected["gaps"], "gaps");
  const PlanHistories &one = by_modes.response.histories, &other = by_planes.response.histories;
  constexpr double part = 1e-9;
  for (std::size_t b = 0; b < 2; ++b) {
    expect_near(one.x[b], other.x[b], part, "x");
    expect_near(one.y[b], other.y[b], part, "y");
    expect_near(one.rotation[b], other.rotation[b], part, "rotation");
    expect_near(one.acceleration_x[b], other.acceleration_x[b], part, "acceleration");
  }
  expect_near(one.force, other.force, part, "force");
  expect_near(one.force_along, other.force_along, part, "force along");
  EXPECT_TRUE(std::none_of(by_modes.remarks.begin(), by_modes.remarks.end(),
                           [](const Remark& remark) { return remark.key == "modal_mass"; }));
}

/// With fewer all moves in these, a blow meets more mass than there is, which is said, and what they are is told.
TEST(ModesInPlan, FewOfThemSayWhatTheyLeaveOut) {
  const PlanRun by_planes = test::told_plan_run(two(planes));
  const Modes& solved = by_planes.problem.buildings[0].modes;
  const PlanRun few = test::told_plan_run(two(told(solved, 3)));
  const PlanBuilding& building = few.problem.buildings[0];
  ASSERT_EQ(building.modes.omega.size(), 3);
  EXPECT_LE((building.modes.shapes - solved.shapes.leftCols(3)).norm(), 1e-12 * solved.shapes.norm());
  EXPECT_TRUE(std::any_of(few.remarks.begin(), few.remarks.end(),
                          [](const Remark& remark) { return remark.key == "modal_mass" && remark.subject == "A"; }));
  const std::vector<Statement> assumptions = hand_in(few).assumptions;
  EXPECT_TRUE(std::any_of(assumptions.begin(), assumptions.end(), [](const Statement& one) {
    return one.kind == "assumption.modal" && one.buildings == std::vector<Index>{0};
  }));
}

}  // namespace
}  // namespace bentur
