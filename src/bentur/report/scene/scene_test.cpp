#include "bentur/report/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/run_results.h"
#include "bentur/report/scene/names.h"
#include "bentur/report/scene/plan_scene.h"
#include "bentur/report/scene/tones.h"
#include "tests/support/kinds_case.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// The first half second.
RunResults begun(Case c) {
  c.analysis.duration = std::min(c.analysis.duration, 0.5);
  Problem problem = make_problem(c);
  SolveOptions options;
  options.output_step = 0.01;
  Response response = solve(problem, c.analysis.solver, options);
  return run_results(std::move(c), std::move(problem), std::move(response));
}

RunResults begun(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, std::string(BENTUR_SOURCE_DIR) + "/examples/case.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return begun(std::move(*c));
}

/// Every example of the program, by its name, and a case of every kind of building.
std::vector<std::pair<std::string, RunResults>> all_runs() {
  std::vector<std::pair<std::string, RunResults>> runs;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(BENTUR_SOURCE_DIR) + "/examples")) {
    if (entry.path().extension() != ".toml") continue;
    Diagnostics diagnostics;
    auto c = read_case(entry.path(), diagnostics);
    if (c) runs.emplace_back(entry.path().stem().string(), begun(std::move(*c)));
  }
  runs.emplace_back("every kind", begun(test::every_kind));
  return runs;
}

Scene scene_of(const RunResults& run) { return scene_of(run.problem, run.response); }

std::vector<const SceneShape*> shapes_of(const Scene& scene, SceneRole role, Eigen::Index item) {
  std::vector<const SceneShape*> found;
  for (const SceneShape& shape : scene.shapes) {
    if (shape.role == role && shape.item == item) found.push_back(&shape);
  }
  return found;
}

SceneMotion random_motion(const RunResults& run, unsigned seed) {
  std::mt19937 any(seed);
  std::uniform_real_distribution<double> sway(-0.1, 0.1);
  SceneMotion motion = at_rest(run.response.histories);
  for (Eigen::VectorXd& one : motion) {
    for (double& value : one) value = sway(any);
  }
  return motion;
}

/// Its first point hangs at the floor of a building.
void expect_hangs(const std::vector<ScenePoint>& line, const Building& building, Eigen::Index b, Eigen::Index floor) {
  ASSERT_EQ(line.front().movers.size(), 1U);
  EXPECT_EQ(line.front().movers.front().building, b);
  EXPECT_EQ(line.front().movers.front().row, floor);
  EXPECT_EQ(line.front().height, building.model.elevations[floor]);
}

TEST(Scene, HasEverythingOfEveryExample) {
  std::size_t links = 0, bearings = 0, soils = 0, walls = 0;
  for (const auto& [name, run] : all_runs()) {
    SCOPED_TRACE(name);
    const Scene scene = scene_of(run);
    const std::vector<Building>& buildings = run.problem.buildings;
    EXPECT_EQ(shapes_of(scene, SceneRole::ground, 0).size(), 1U);
    for (Eigen::Index b = 0; b < std::ssize(buildings); ++b) {
      const Building& building = buildings[b];
      const auto count = [&](SceneRole role) { return shapes_of(scene, role, b).size(); };
      EXPECT_EQ(count(SceneRole::wall), building.is_rigid() ? 1U : 0U);
      EXPECT_EQ(count(SceneRole::column), building.is_rigid() ? 0U : 1U);
      EXPECT_EQ(count(SceneRole::bearing), building.model.slab ? 1U : 0U);
      EXPECT_EQ(count(SceneRole::soil), building.model.foundation ? 1U : 0U);
      walls += count(SceneRole::wall);
      bearings += count(SceneRole::bearing);
      soils += count(SceneRole::soil);
      for (const SceneShape* slabs : shapes_of(scene, SceneRole::slab, b)) {
        EXPECT_EQ(std::ssize(slabs->lines), building.model.floors());
        EXPECT_EQ(slabs->tone, tones_of(run.problem, run.response).at(b));
      }
    }
    for (Eigen::Index k = 0; k < std::ssize(run.problem.links); ++k) {
      const Link& link = run.problem.links[k];
      std::size_t drawn = 0;
      for (const SceneShape& shape : scene.shapes) {
        if (shape.role < SceneRole::spring || shape.role > SceneRole::link || shape.item != k) continue;
        ++drawn;
        expect_hangs(shape.lines[0], buildings[link.left], link.left, link.left_floor);
        expect_hangs(shape.lines[1], buildings[link.right], link.right, link.right_floor);
        EXPECT_EQ(shape.tone, Tone::grey);
      }
      EXPECT_EQ(drawn, link.kind == "spring-dashpot" ? 2U : 1U) << link.kind;
      links += drawn;
    }
  }
  EXPECT_EQ(links, 5U);  // two springs with dashpots and one that yields
  EXPECT_EQ(bearings, 2U);
  EXPECT_EQ(soils, 2U);
  EXPECT_EQ(walls, 4U);
}

TEST(Scene, PointsLieBetweenWhatMovesThem) {
  for (const auto& [name, run] : all_runs()) {
    SCOPED_TRACE(name);
    const Scene scene = scene_of(run);
    const SceneMotion motion = random_motion(run, 7);
    const ScenePlaces places(scene, scene.magnification, motion);
    for (const SceneShape& shape : scene.shapes) {
      for (const auto& line : shape.lines) {
        for (const ScenePoint& point : line) {
          double sum = 0, low = 1e300, high = -1e300;
          for (const SceneMover& mover : point.movers) {
            sum += mover.weight;
            SceneMover alone = mover;
            alone.weight = 1;
            const double x = places({point.height, {alone}})[0];
            low = std::min(low, x);
            high = std::max(high, x);
          }
          EXPECT_NEAR(sum, 1, 1e-14);
          const double slack = 1e-12 * std::max(std::abs(low), std::abs(high));
          EXPECT_GE(places(point)[0], low - slack);
          EXPECT_LE(places(point)[0], high + slack);
        }
      }
    }
  }
}

/// What is between the two faces of a contact point in the picture is its opening, magnified.
TEST(Scene, WhatTouchesTouchesInThePicture) {
  for (const auto& [name, run] : all_runs()) {
    SCOPED_TRACE(name);
    const Scene scene = scene_of(run);
    const SceneMotion motion = random_motion(run, 11);
    for (const double magnification : {1.0, scene.magnification}) {
      const ScenePlaces places(scene, magnification, motion);
      for (std::size_t i = 0; i < run.problem.points.size(); ++i) {
        const ContactPoint& point = run.problem.points[i];
        const Eigen::Index b = point.left + 1;
        if (run.problem.buildings[b].is_rigid() || point.right_floor >= run.problem.buildings[b].model.floors())
          continue;
        const SceneShape& slabs = *shapes_of(scene, SceneRole::slab, b).front();
        const double face = places(slabs.lines[point.right_floor].front())[0];
        const double opening = point.width + motion[b](point.right_floor) - motion[point.left](point.left_floor);
        EXPECT_NEAR(face - places(scene.contacts[i])[0], magnification * opening, 1e-11 * scene.breadths[0]);
      }
    }
  }
}

TEST(Scene, ColumnsBendWhereTheyAreStruck) {
  Diagnostics diagnostics;
  auto c = read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/struck-column.toml", diagnostics);
  ASSERT_TRUE(c);
  const RunResults run = begun(std::move(*c));
  const Scene scene = scene_of(run);
  for (Eigen::Index b = 0; b < 2; ++b) {
    const StructuralModel& model = run.problem.buildings[b].model;
    ASSERT_GT(model.nodes(), 0);
    const auto& lines = shapes_of(scene, SceneRole::column, b).front()->lines;
    const auto nodes_in = [&](const std::vector<ScenePoint>& line) {
      return std::count_if(line.begin(), line.end(),
                           [&](const ScenePoint& point) { return point.movers[0].row >= model.floors(); });
    };
    for (const auto& line : lines) {
      const bool faces = &line == (b == 0 ? &lines.back() : &lines.front());
      EXPECT_EQ(nodes_in(line), faces ? model.nodes() : 0);
      EXPECT_TRUE(std::is_sorted(line.begin(), line.end(), [](const ScenePoint& low, const ScenePoint& high) {
        return low.height < high.height;
      }));
    }
  }
}

TEST(Scene, AStillIsOfTheHardestImpactElseOfTheClosestApproach) {
  Response response;
  response.histories.time = {0, 1, 2, 3};
  response.histories.opening.resize(2, 4);
  response.histories.opening << 3, 2, 1, 2, 5, 5, 0.5, 0.2;
  EXPECT_EQ(telling_instant(response).point, 1);
  EXPECT_EQ(telling_instant(response).time, 3);
  EXPECT_EQ(telling_instant(response, 0).column, 2);
  NearestFloor nearest{.least_opening = 0.1, .least_time = 1.4};
  EXPECT_EQ(telling_instant(response, {}, &nearest).time, 1.4);
  EXPECT_EQ(telling_instant(response, {}, &nearest).column, 1);
  EXPECT_FALSE(telling_instant(response, {}, &nearest).point);
  nearest.least_opening = 0.3;
  EXPECT_EQ(telling_instant(response, {}, &nearest).point, 1);
  response.impacts = {{.point = 1, .start = 0.5, .peak_force = 3, .peak_force_time = 0.6},
                      {.point = 0, .start = 1.5, .peak_force = 9, .peak_force_time = 1.6}};
  EXPECT_EQ(telling_instant(response).impact, 1);
  EXPECT_EQ(telling_instant(response).time, 1.6);
  EXPECT_EQ(telling_instant(response, 1).impact, 0);
}

TEST(PlanScene, CentresOfRigidityAreThoseOfTheStoreysAboveBearings) {
  const PlanRun run = test::plan_run(R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.7, displacement_amplitude = 0.04 }
analysis = { duration = 0.1 }
plan = { clearance = 0.1, contact = { law = "linear", stiffness = 3e5 } }
[[building]]
name = "A"
damping = 0.05
plan = { corner = [2.0, 1.0], size = [12.0, 18.0], storey_heights = [3.5, 3.2], masses = [200, 180] }
rigidity = { centre = [[3.0, 9.0], [9.0, 4.0]], x = 9e4, y = 8e4, torsion = 5e6 }
isolation = { mass = 100, bearing = [{ at = [[1, 1], [11, 1], [1, 17], [11, 17]], stiffness = 2000 }] }
[[building]]
name = "W"
rigid = true
elevations = [6.7]
plan = { corner = [14.05, 1.0], size = [1.0, 18.0] }
)");
  std::vector<std::pair<Eigen::Index, PlanPoint>> found;
  for (const PlanCentre& centre : centres_of(run)) {
    EXPECT_EQ(centre.building, 0);
    if (centre.of_rigidity) found.emplace_back(centre.floor, centre.at);
  }
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], (std::pair<Eigen::Index, PlanPoint>(1, {5, 10})));
  EXPECT_EQ(found[1], (std::pair<Eigen::Index, PlanPoint>(2, {11, 5})));
}

/// What holds the storeys of a building known by its modes, and where, they do not say.
TEST(PlanScene, CentresOfABuildingKnownByItsModesAreOfMassAlone) {
  const std::string given = "[building.modal]\nperiods = [0.5]\nshapes = [[1, 0, 0.01, 2, 0.1, 0.02]]\n";
  std::string text = test::twisting_pair();
  const std::size_t first = text.find("[[building.plane]]"), next = text.find("[[building]]", first);
  text.replace(first, next - first, given);
  const PlanRun run = test::plan_run(text);
  const std::vector<PlanCentre> centres = centres_of(run);
  const auto of_first = [](const PlanCentre& one) { return one.building == 0; };
  EXPECT_EQ(std::count_if(centres.begin(), centres.end(), of_first), 2);
  EXPECT_TRUE(std::none_of(centres.begin(), centres.end(),
                           [&](const PlanCentre& one) { return of_first(one) && one.of_rigidity; }));
}

TEST(SceneNames, AreShortWhereTheyBeginAlike) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(short_names({"House 5.5", "House 5.6", "House 12.1"}), (Names{"5.5", "5.6", "12.1"}));
  EXPECT_EQ(short_names({"East", "North", "Workshop"}), (Names{"East", "North", "Workshop"}));
  EXPECT_EQ(short_names({"Block A wing 1", "Block A wing 2", "Block A yard"}), (Names{"wing 1", "wing 2", "yard"}));
  EXPECT_EQ(short_names({"Town hall", "Town hall of the old"}), (Names{"1", "2"})) << "one is long";
  EXPECT_EQ(short_names({"A 1", "A 1"}), (Names{"1", "2"})) << "two are alike";
  EXPECT_EQ(short_names({"House", "House 2"}), (Names{"House", "House 2"}));
  EXPECT_EQ(short_names({"Tower"}), Names{"Tower"});
  EXPECT_TRUE(short_names({}).empty());
}

TEST(Scene, BarsOfScalesAreNoLongerThanWhatTheyAreOf) {
  for (const auto& [value, bar] : std::vector<std::pair<double, double>>{
           {1642, 1000}, {9999, 5000}, {2, 2}, {0.0499, 0.02}, {0.05, 0.05}, {1, 1}, {100 * (1 - 1e-12), 100}}) {
    EXPECT_NEAR(at_most_125(value), bar, 1e-12 * bar) << value;
  }
}

}  // namespace
}  // namespace bentur
