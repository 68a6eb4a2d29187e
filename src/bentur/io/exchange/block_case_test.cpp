#include "bentur/io/exchange/block_case.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/pounding/plan/faces.h"

namespace bentur {
namespace {

struct RingText {
  std::vector<PlanPoint> corners;
  [[nodiscard]] std::string text() const {
    std::string all = "[";
    for (const PlanPoint& at : corners) all += fmt::format("[{}, {}], ", at.x(), at.y());
    return all + fmt::format("[{}, {}]]", corners[0].x(), corners[0].y());
  }
};

std::vector<PlanPoint> box(double x, double y, double a, double b) {
  return {{x, y}, {x + a, y}, {x + a, y + b}, {x, y + b}};
}

std::string house(const std::string& properties, const std::vector<PlanPoint>& outline, const std::string& holes = "") {
  return fmt::format(
      "\n{{\"type\": \"Feature\", \"properties\": {{{}}}, \"geometry\": {{\"type\": \"Polygon\", \"coordinates\": "
      "[{}{}]}}}}",
      properties, RingText{outline}.text(), holes);
}

std::string collection(const std::vector<std::string>& features) {
  std::string all;
  for (const std::string& one : features) {
    all += std::string(all.empty() ? "" : ",") + (one.starts_with("\n") ? "" : "\n") + one;
  }
  return "{\"type\": \"FeatureCollection\", \"features\": [" + all + "\n]}";
}

struct Block {
  Diagnostics diagnostics;
  std::optional<ImportedCase> made;
  std::optional<Case> c;
  PlanProblem problem;

  [[nodiscard]] std::string errors() const {
    std::string all;
    for (const Diagnostic& one : diagnostics.errors()) all += one.text() + "\n";
    return all;
  }
  [[nodiscard]] std::string taken() const {
    std::string all;
    for (const std::string& one : made->taken) all += one + "\n";
    return all;
  }
};

Block block_of(const std::string& text, const BlockRules& rules = {},
               const GeoJsonOptions& options = {.metres = true}) {
  Block block;
  const auto houses = read_geojson(text, "block.geojson", options, block.diagnostics);
  if (houses) block.made = make_block_case(*houses, "block.geojson", rules, block.diagnostics);
  if (!block.made) return block;
  MadeParts made;
  block.c = read_case_text(block.made->text, "block.toml", block.diagnostics, &made);
  block.problem = std::move(made.plan);
  return block;
}

TEST(Block, HousesBecomeACaseWhosePeriodsAreThoseOfTheRule) {
  const Block block = block_of(collection({house(R"("name": "A", "building:levels": 3)", box(500, 900, 12, 18)),
                                           house(R"("name": "B", "height": "12.4 m")", box(512.04, 900, 9, 18))}));
  ASSERT_TRUE(block.c) << block.errors();
  ASSERT_EQ(block.problem.buildings.size(), 2U);
  for (const auto& [building, storeys, height, mass] :
       {std::tuple(0, 3, 9.0, 12 * 18.0), std::tuple(1, 4, 12.4, 9 * 18.0)}) {
    const PlanBuilding& made = block.problem.buildings[building];
    ASSERT_EQ(made.model.floors(), storeys);
    EXPECT_NEAR(made.model.elevations.back(), height, 1e-12);
    EXPECT_NEAR(made.model.floor_masses.back(), mass, 1e-3);
    const double omega = 2 * std::numbers::pi / (0.0466 * std::pow(height, 0.9));
    // Along x, y and about the vertical: a stiffness that is spread evenly turns as fast as it sways.
    for (int mode = 0; mode < 3; ++mode) EXPECT_NEAR(made.modes.omega(mode) / omega, 1, 1e-4) << mode;
    EXPECT_GT(made.modes.omega(3), 1.5 * omega);
    // Nothing turns it: the centre of mass is that of rigidity to the last digit.
    EXPECT_EQ(made.model.stiffness(0, 2), 0);
  }
  ASSERT_EQ(block.c->gaps.size(), 1U);
  EXPECT_NEAR(block.c->gaps[0].stretch.width, 0.04, 1e-12);
  EXPECT_NE(block.taken().find("storeys are 3 m high, where no height is given: \"A\"\n"), std::string::npos);
  EXPECT_NE(block.taken().find("where no number is given: \"B\", 4\n"), std::string::npos);
  EXPECT_NE(block.taken().find("joints: \"A\" and \"B\", 0.04 m\n"), std::string::npos);
  for (const std::string& one : block.made->taken) {  // every one of them stands in the case
    EXPECT_NE(block.made->text.find("# - " + one.substr(0, 40)), std::string::npos) << one;
  }
}

TEST(Block, AHullAndHolesLeaveTheMassWhereItIs) {
  const std::vector<PlanPoint> l_shape = {{0, 0}, {0, 10}, {4, 10}, {4, 4}, {10, 4}, {10, 0}};  // clockwise
  const std::string other = house(R"("levels": 2)", box(10.1, 0, 8, 8));
  const std::string text = collection({house(R"("name": "L", "levels": 2)", l_shape), other});
  const Block as_it_is = block_of(text);
  ASSERT_TRUE(as_it_is.c) << as_it_is.errors();
  EXPECT_EQ(as_it_is.problem.buildings[0].model.footprint.polygon.size(), 6U);
  EXPECT_NEAR(as_it_is.problem.buildings[0].model.floor_masses[0], 64, 1e-9);
  const Block block = block_of(text, {.hull = true});
  ASSERT_TRUE(block.c) << block.errors();
  const PlanBuilding& made = block.problem.buildings[0];
  EXPECT_EQ(made.model.footprint.polygon.size(), 5U);
  EXPECT_NEAR(made.model.floor_masses[0], 64, 1e-9);
  const double middle = (40 * 5 + 24 * 2) / 64.0, mass = 64;
  const PlanPoint from_corner = made.model.centres[0] - made.model.footprint.lower();
  EXPECT_NEAR(from_corner.x(), middle, 1e-3);
  EXPECT_NEAR(from_corner.y(), middle, 1e-3);
  const double inertia = 40 * (100 + 16) / 12.0 + 24 * (16 + 36) / 12.0 + 40 * (25 + 4) + 24 * (4 + 49.0);
  EXPECT_NEAR(made.model.mass(2, 2) / (inertia - mass * 2 * middle * middle), 1, 1e-5);
  EXPECT_NE(block.taken().find("\"L\", 18 m² more"), std::string::npos);

  const std::string hole = ", [[2, 2], [6, 2], [6, 8], [2, 8], [2, 2]]";
  const Block court = block_of(collection({house(R"("levels": 2)", box(0, 0, 10, 10), hole), other}));
  ASSERT_TRUE(court.c) << court.errors();
  EXPECT_NEAR(court.problem.buildings[0].model.floor_masses[0], 76, 1e-9);
  EXPECT_NEAR((court.problem.buildings[0].model.centres[0] - court.problem.buildings[0].model.footprint.lower()).x(),
              (100 * 5 - 24 * 4) / 76.0, 1e-3);
  EXPECT_EQ(court.problem.buildings[0].model.footprint.rings.size(), 1U);
  EXPECT_NE(block_of(collection({house(R"("levels": 2)", box(0, 0, 5, 10), hole), other})).errors().find("must lie in"),
            std::string::npos);
}

TEST(Block, SmallOverlapsAreTrimmedAndLargerOnesAreErrors) {
  const auto text = [](double deep) {
    return collection(
        {house(R"("name": "A", "levels": 2)", box(0, 0, 10, 10)),
         house(R"("name": "B", "levels": 2)", box(10 - deep, 0, 8, 10)),
         house(R"("name": "C", "levels": 2)", {{0, 10}, {5, 9.97}, {10, 10}, {10, 14}, {5, 13.96}, {0, 14}})});
  };
  const Block block = block_of(text(0.08));
  ASSERT_TRUE(block.c) << block.errors();
  EXPECT_NEAR(block.c->buildings[0].footprint().size.x(), 10, 1e-9);  // the earlier one stays
  EXPECT_NEAR(block.c->buildings[1].footprint().size.x(), 7.92, 1e-9);
  EXPECT_NEAR(block.problem.buildings[1].model.floor_masses[0], 79.2, 1e-3);
  EXPECT_EQ(block.c->gaps[0].stretch.width, 0);
  EXPECT_NE(block.taken().find("\"B\", by 0.08 m at \"A\""), std::string::npos);
  EXPECT_NE(block.taken().find("\"C\", by 0.03 m at \"A\""), std::string::npos);
  EXPECT_NE(block.taken().find("are made straight: \"C\", by 0.04 m\n"), std::string::npos);
  EXPECT_EQ(block.c->buildings[2].footprint().polygon.size(), 4U);
  EXPECT_NE(block_of(text(0.3)).errors().find("features[1] (\"B\") overlaps \"A\" by 0.3 m, 3 m², must be at most "
                                              "--snap 0.1 m"),
            std::string::npos);
  EXPECT_FALSE(block_of(text(0.08), {.snap = 0.05}).made);
}

TEST(Block, RulesBeyondAllMeasureAreErrors) {
  const std::string text = collection({house(R"("name": "A", "levels": 2)", box(0, 0, 10, 10)),
                                       house(R"("name": "B", "levels": 2)", box(10, 0, 8, 10))});
  EXPECT_EQ(block_of(text, {.floor_mass = 1e307}).errors(),
            "block.geojson: error: --floor-mass 1e+307, must be in (0, 1000] t/m²\n");
  EXPECT_NE(block_of(text, {.period_coefficient = 1e300}).errors().find("(\"A\") has a first period of"),
            std::string::npos);
  EXPECT_TRUE(block_of(text, {.floor_mass = 1000, .period_coefficient = 100}).c);
  EXPECT_TRUE(block_of(text, {.clearance = 1e9, .floor_mass = 1e-3}).c);
  EXPECT_NE(block_of(text, {.floor_mass = 1e-300}).errors().find("would become a case with an error"),
            std::string::npos);
}

TEST(Block, FloorsThatMeetNowhereMeetWhereTheyAreNearest) {
  const Block block = block_of(collection({house(R"("name": "Hall", "levels": 1, "height": 7.4)", box(0, 0, 10, 10)),
                                           house(R"("name": "Flats", "levels": 4)", box(10.02, 0, 8, 10))}));
  ASSERT_TRUE(block.c) << block.errors();
  ASSERT_EQ(block.c->gaps.size(), 1U);
  ASSERT_EQ(block.c->gaps[0].levels.size(), 1U);
  EXPECT_NE(block.taken().find("\"Hall\" and \"Flats\", 1.4 m apart in height"), std::string::npos);
  EXPECT_NE(
      block_of(collection({house(R"("levels": 1)", box(0, 0, 10, 10)), house(R"("levels": 4)", box(20, 0, 8, 10))}))
          .errors()
          .find("nothing can touch"),
      std::string::npos);
}

TEST(Block, EveryErrorIsSaidAtOnceWithItsFeature) {
  const std::string errors =
      block_of(
          collection({
              house(R"("name": "A", "height": "tall", "levels": -2.5)", box(0, 0, 10, 10)),
              house(R"("name": "A\n", "levels": 2, "storeys": 3)", box(20, 0, 10, 10)),
              R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,1]]]}})",
              R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0,0],["a",0],[1,1],[0,0]]]}})",
              R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": 7}})",
              R"({"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[], []]}})",
              "7",
          }))
          .errors();
  for (const char* const one : {
           "block.geojson:2:1: error: features[0] (\"A\").properties.height = \"tall\", must be metres in (0, 1000]",
           "features[0] (\"A\").properties.levels = -2.5, must be a whole number from 1 to 200",
           "features[1].properties.name = \"A\\x0a\", must be one line",
           "properties.storeys = 3, must not stand beside levels = 2; --levels PROPERTY says which is read; --without",
           "features[2] (\"building 3\").geometry.coordinates[0] must end where it begins",
           "coordinates[0][1] is a list, must be a list of numbers",
           "features[4] (\"building 5\").geometry.coordinates must be a list of rings",
           "features[5] (\"building 6\").geometry has 2 polygons, must be one: parts that stand apart move apart; "
           "--parts "
           "takes each as a house of its own; --without \"building 6\" leaves it out",
           "features[6] must be a Feature",
       }) {
    EXPECT_NE(errors.find(one), std::string::npos) << one << "\n" << errors;
  }
  const auto error_of = [](const std::string& text, bool metres = true) {
    const Block block = block_of(text, {}, {.metres = metres});
    EXPECT_FALSE(block.made);
    return block.errors();
  };
  const auto pair = [](const std::vector<PlanPoint>& outline, const std::string& properties) {
    return collection({house(properties, outline), house(R"("levels": 2)", box(200, 0, 10, 10))});
  };
  const auto expect = [&](const std::string& text, const char* what, bool metres = true) {
    EXPECT_NE(error_of(text, metres).find(what), std::string::npos) << what << "\n" << error_of(text, metres);
  };
  expect("", "block.geojson:1:1: error: is not JSON from here on");
  expect("{\n  \"type\": NaN}", "block.geojson:2:11: error: is not JSON");
  expect("[1e999]", "too large");
  expect(std::string(200000, '['), "is not JSON");
  expect(std::string(100000, '[') + std::string(100000, ']'), "must be a GeoJSON FeatureCollection");
  expect("{\"type\": \"Topology\"}", "must be a GeoJSON FeatureCollection");
  expect("{\"type\": \"FeatureCollection\", \"features\": []}", "has 0 polygons, a block has two or more");
  expect(collection(std::vector<std::string>(1001, house("", box(0, 0, 1, 1)))),
         "has 1001 polygons, a block has at most 1000; --around NAME --radius METRES takes those near one");
  expect(pair(box(0, 0, 10, 10), ""),
         "nor a height; --levels PROPERTY reads storeys from another one, --storeys gives all such");
  expect(pair(box(0, 0, 10, 10), R"("levels": 100, "height": 12)"), "has storeys of 0.12 m");
  expect(pair({{0, 0}, {8, 8}, {8, 0}, {0, 7}}, R"("levels": 2)"), "must go round once");
  expect(pair({{0, 0}, {8, 0}, {4, 0}, {2, 0}}, R"("levels": 2)"), "edges behind corners 1 and 3 meet");
  expect(pair({{0, 0}, {0, 0}, {4, 0}, {4, 0}}, R"("levels": 2)"), "must have three corners or more, not 2");
  expect(pair(box(0, 0, 0.5, 0.5), R"("levels": 2)"), "has 0.25 m² of floor");
  expect(pair(box(9000, 0, 10, 10), R"("levels": 2)"), "from end to end, a block is at most 2000 m");
  expect(pair(box(500, 0, 10, 10), R"("levels": 2)"), "give --metres where coordinates are metres", false);
  const std::string crs =
      R"({"type": "FeatureCollection", "crs": {"properties": {"name": "EPSG:32748"}}, "features": []})";
  expect(crs, "crs = \"EPSG:32748\", must be WGS 84", false);
}

TEST(Block, PlacesAndNamesAreReadAsTheyStand) {
  const std::string text = collection({
      R"({"type": "Feature", "id": "way/7", "properties": {"levels": "2", "roof:shape": "flat"}, "geometry": {"type": "MultiPolygon", "coordinates": [[[[10,45],[10.0001,45],[10.0001,45.0001],[10,45.0001],[10,45]]]]}})",
      R"({"type": "Feature", "id": 8, "properties": {"name": "Row", "levels": 2, "height": null}, "geometry": {"type": "Polygon", "coordinates": [[[10.0001,45,3],[10.0002,45],[10.0002,45.0001],[10.0001,45.0001],[10.0001,45,3]]]}})",
      R"({"type": "Feature", "properties": {"name": "Row", "levels": 2}, "geometry": {"type": "Polygon", "coordinates": [[[10.0002,45],[10.0003,45],[10.0003,45.0001],[10.0002,45.0001],[10.0002,45]]]}})",
      R"({"type": "Feature", "properties": null, "geometry": {"type": "Point", "coordinates": [10, 45]}})",
      R"({"type": "Feature", "properties": null, "geometry": null})",
  });
  const Block block = block_of(text, {}, {});
  ASSERT_TRUE(block.c) << block.errors();
  ASSERT_EQ(block.c->buildings.size(), 3U);
  EXPECT_EQ(block.c->buildings[0].name, "way/7");
  EXPECT_EQ(block.c->buildings[2].name, "Row (2)");
  EXPECT_NEAR(block.c->buildings[0].footprint().size.x(), 7.8847, 1e-3);
  EXPECT_NEAR(block.c->buildings[0].footprint().size.y(), 11.1132, 1e-3);
  ASSERT_EQ(block.c->gaps.size(), 2U);
  EXPECT_EQ(block.c->gaps[0].stretch.width, 0);  // they have their corners in common
  ASSERT_EQ(block.made->unread.size(), 2U);
  EXPECT_EQ(block.made->unread[0].what, "property \"roof:shape\" of 1 feature");
  EXPECT_EQ(block.made->unread[1].what, "geometry \"Point\" of 1 feature");
  EXPECT_EQ(block.made->unread[1].first, 5);
  EXPECT_NE(block.taken().find("features without geometry are left out: \"building 5\"\n"), std::string::npos);
}

TEST(Block, WhatIsMadeOfAnyBlockIsACase) {
  std::mt19937 random(20260);
  const auto part = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int i = 0; i < 25; ++i) {
    // A turned grid whose corners are off by up to 3 cm, some houses with corners on their walls.
    const double angle = part(0, 2 * std::numbers::pi), a = part(6, 15), b = part(6, 15), open = part(0, 0.2);
    std::vector<std::string> houses;
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 3; ++column) {
        std::vector<PlanPoint> outline = box(column * (a + open), row * b, a, b);
        if (part(0, 1) < 0.5) outline.insert(outline.begin() + 1, 0.5 * (outline[0] + outline[1]));
        for (PlanPoint& at : outline) {
          const PlanPoint off = at + PlanPoint(part(-0.03, 0.03), part(-0.03, 0.03));
          at = {std::cos(angle) * off.x() - std::sin(angle) * off.y(),
                std::sin(angle) * off.x() + std::cos(angle) * off.y()};
        }
        houses.push_back(house(fmt::format("\"height\": {:.2f}", part(3, 30)), outline));
      }
    }
    const Block block = block_of(collection(houses));
    ASSERT_TRUE(block.c) << i << "\n" << block.errors() << (block.made ? block.made->text : "");
    EXPECT_GE(block.c->gaps.size(), 7U);
    for (std::size_t later = 1; later < block.c->buildings.size(); ++later) {
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        EXPECT_FALSE(overlap(block.c->buildings[earlier].footprint(), block.c->buildings[later].footprint()));
      }
    }
  }
}

}  // namespace
}  // namespace bentur
