#include "bentur/io/exchange/geojson.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"

namespace bentur {
namespace {

/// A house 10 m wide on the line y = 0, its properties as JSON.
std::string house_at(double x, const std::string& properties, const std::string& more = "") {
  return fmt::format(
      R"({{"type": "Feature", {}"properties": {{{}}}, "geometry": {{"type": "Polygon", "coordinates": [[[{}, 0], [{}, 0], [{}, 12], [{}, 12], [{}, 0]]]}}}})",
      more, properties, x, x + 10, x + 10, x, x);
}

std::string houses_text(const std::vector<std::string>& features) {
  std::string all;
  for (const std::string& one : features) all += (all.empty() ? "\n" : ",\n") + one;
  return "{\"type\": \"FeatureCollection\", \"features\": [" + all + "\n]}";
}

struct HousesRead {
  std::optional<Houses> houses;
  std::string errors, said;  ///< line by line
  std::string names;         ///< with storeys and height
};

HousesRead read_houses(const std::string& text, GeoJsonOptions options = {}) {
  options.metres = true;
  Diagnostics diagnostics;
  HousesRead read;
  read.houses = read_geojson(text, "ward.geojson", options, diagnostics);
  EXPECT_EQ(read.houses.has_value(), diagnostics.ok());
  for (const Diagnostic& one : diagnostics.errors()) read.errors += one.text() + "\n";
  if (!read.houses) return read;
  for (const std::string& one : read.houses->left_out) read.said += one + "\n";
  for (const std::string& one : read.houses->taken) read.said += one + "\n";
  for (const UnreadLines& one : read.houses->unread) read.said += fmt::format("{}: {}\n", one.first, one.what);
  for (const House& one : read.houses->all) {
    read.names += (read.names.empty() ? "" : ", ") + one.name;
    if (one.storeys) read.names += fmt::format(" {}", *one.storeys);
    if (one.height) read.names += fmt::format(" {} m", number(*one.height));
  }
  return read;
}

const std::string two_levels = R"("levels": 2, "name": )";

TEST(GeoJson, TagsOfOpenStreetMapAreReadAndListedWhereTheyAreReadOtherwise) {
  const HousesRead read = read_houses(houses_text({
      house_at(0, R"("name": "A", "building:levels": "3;4", "height": "12.5 m")"),
      house_at(10, R"("name": "B", "building:levels": "3.5")"),
      house_at(20, R"("name": "C", "num_floors": 4, "height": 12.8)"),
      house_at(30, R"("name": "D", "height": "40'6\"")"),
      house_at(40, R"("name": "E", "levels": 2.5, "storeys": "3", "height": "12,5")"),
  }));
  EXPECT_EQ(read.errors, "");
  EXPECT_EQ(read.names, "A 4 12.5 m, B 4, C 4 12.8 m, D 12.34 m, E 3 12.5 m");
  EXPECT_EQ(read.said,
            "storeys are whole (of several the most, a part of one is one, of a sum all): \"A\", 3;4 as 4; \"B\", 3.5 "
            "as 4; \"E\", 2.5 as 3\n"
            "heights with a decimal comma or in feet are read as metres: \"D\", 40'6\" as 12.344 m; \"E\", 12,5 as "
            "12.5 m\n");
}

TEST(GeoJson, ATagThatCannotBeReadNamesTheOptionsThatHelp) {
  const std::string text = houses_text({house_at(0, R"("name": "A", "levels": "many", "height": "tall")"),
                                        house_at(10, R"("name": "B", "levels": 2)"),
                                        house_at(20, R"("name": "C", "levels": true, "height": 9)")});
  EXPECT_EQ(
      read_houses(text).errors,
      "ward.geojson:2:1: error: features[0] (\"A\").properties.height = \"tall\", must be metres in (0, 1000], as "
      "12.5 or \"12.5 m\", or feet as \"40 ft\"; --storeys takes it as not given; --without \"A\" leaves it out\n"
      "ward.geojson:2:1: error: features[0] (\"A\").properties.levels = \"many\", must be a whole number from 1 "
      "to 200, as 3 or \"3;4\", of which the most; --storeys takes it as not given; --without \"A\" leaves it "
      "out\n"
      "ward.geojson:4:1: error: features[2] (\"C\").properties.levels = true, must be a whole number from 1 to "
      "200, as 3 or \"3;4\", of which the most; --storeys takes it as not given; --without \"C\" leaves it "
      "out\n");
  const HousesRead none = read_houses(text, {.unread_as_none = true});
  EXPECT_EQ(none.names, "A, B 2, C 9 m");
  EXPECT_EQ(none.said,
            "what cannot be read is as if not given, as there is --storeys: \"A\", height = \"tall\"; \"A\", levels = "
            "\"many\"; \"C\", levels = true\n");
  EXPECT_EQ(read_houses(text, {.without = {"A", "C"}}).errors,
            "ward.geojson: error: has 1 polygon, a block has two or more; --without leaves out: \"A\"; \"C\"\n");
}

TEST(GeoJson, StoreysMayStandInAnotherPropertyAndInTags) {
  const std::string text = houses_text({
      house_at(0, R"("type": "way", "tags": {"name": "A", "building": "yes", "building:levels": "3"})"),
      house_at(10, R"("name": "B", "layer_no": 5, "levels": 4, "tags": {"name": "none", "height": "15"})"),
      house_at(20, R"("name": "C", "levels": 1)"),
  });
  const HousesRead usual = read_houses(text);
  EXPECT_EQ(usual.names, "A 3, B 4 15 m, C 1");
  EXPECT_EQ(usual.said,
            "2: property \"tags.building\" of 1 feature\n2: property \"type\" of 1 feature\n"
            "3: property \"layer_no\" of 1 feature\n");
  const HousesRead named = read_houses(text, {.levels = "layer_no"});
  EXPECT_EQ(named.names, "A 3, B 5 15 m, C 1");  // who has no such property is read as usual
  EXPECT_TRUE(
      named.said.starts_with("storeys are those of property \"layer_no\"; read as usual, without it: \"A\"; \"C\"\n"));
  EXPECT_NE(named.said.find("3: property \"levels\" of 1 feature\n"), std::string::npos) << named.said;
  EXPECT_EQ(read_houses(text, {.levels = "layer_n"}).errors,
            "ward.geojson: error: --levels = \"layer_n\", did you mean \"layer_no\"?\n");
  EXPECT_EQ(read_houses(text, {.levels = "x"}).errors,
            "ward.geojson: error: --levels = \"x\", must be a property of a house that is read\n");
  const std::string two =
      houses_text({house_at(0, R"("name": "A", "levels": 3, "num_floors": 5)"), house_at(10, R"("levels": 3)")});
  EXPECT_NE(read_houses(two).errors.find("num_floors = 5, must not stand beside levels = 3; --levels PROPERTY says"),
            std::string::npos);
  EXPECT_EQ(read_houses(two, {.levels = "num_floors"}).names, "A 5, building 2 3");
}

TEST(GeoJson, HousesAroundOneAreThoseWithAPointWithinTheRadius) {
  // Every 20 m one, 10 m wide; what is wrong about one that is left out is nobody's concern.
  const std::string text = houses_text({
      house_at(0, two_levels + "\"A\"", R"("id": "way/1", )"),
      house_at(20, two_levels + "\"B\"", R"("id": 2, )"),
      house_at(40, R"("levels": 1, "name": "C")"),
      house_at(60, R"("levels": "none", "name": "D\n")"),
      house_at(80, two_levels + "\"B\""),
  });
  const auto around = [&](const std::string& whom, double radius, std::vector<std::string> without = {}) {
    return read_houses(text, {.around = whom, .radius = radius, .without = std::move(without)});
  };
  EXPECT_EQ(around("A", 9.99).errors,
            "ward.geojson: error: has 1 polygon, a block has two or more; who is further than --radius 9.99 m from "
            "\"A\" is left out: 4 houses\n");
  EXPECT_EQ(around("A", 10).names, "A 2, B 2");
  EXPECT_EQ(around("way/1", 10).names, "A 2, B 2");
  EXPECT_EQ(around("A", 30).names, "A 2, B 2, C 1");
  EXPECT_EQ(around("A", 30).said, "who is further than --radius 30 m from \"A\" is left out: 2 houses\n");
  EXPECT_EQ(around("B", 9).names, "B 2, B (2) 2");        // both
  EXPECT_EQ(around("25, 6", 15).names, "A 2, B 2, C 1");  // in the middle of B
  EXPECT_EQ(around("-12,6", 32).names, "A 2, B 2");
  // The corner of B at (20, 12) is 23.43 m from (5, 30), the wall of A 18 m.
  EXPECT_EQ(around("5,30", 23.5).names, "A 2, B 2");
  EXPECT_EQ(around("5,30", 23.4).names, "");
  EXPECT_EQ(around("C", 30, {"C", "building 4"}).names, "A 2, B 2, B (2) 2");
  EXPECT_NE(around("C", 10).errors.find("features[3] (\"building 4\").properties.levels = \"none\", must be a whole"),
            std::string::npos);
  EXPECT_NE(around("C", 10).errors.find("features[3].properties.name = \"D\\x0a\", must be one line"),
            std::string::npos);
  for (const char* const nowhere : {"E", "1", ",", "1,", ",1", "1,x", "1,2,3", "1e9,0"}) {
    EXPECT_EQ(around(nowhere, 12).errors,
              fmt::format("ward.geojson: error: --around = \"{}\", must be the name or id of a polygon, or X,Y in "
                          "metres\n",
                          nowhere));
  }
  EXPECT_EQ(around("building4", 12).errors,
            "ward.geojson: error: --around = \"building4\", did you mean \"building 4\"?\n");
}

TEST(GeoJson, HousesAreLeftOutByNameAndById) {
  const std::string text = houses_text({house_at(0, two_levels + "\"A\""), house_at(10, two_levels + "\"A\""),
                                        house_at(20, R"("levels": 0)", R"("id": 17, )"),
                                        house_at(30, two_levels + "\"C\"", R"("id": "way/4", )")});
  EXPECT_EQ(read_houses(text, {.without = {"17"}}).names, "A 2, A (2) 2, C 2");
  EXPECT_EQ(read_houses(text, {.without = {"A (2)", "17"}}).names, "A 2, C 2");
  EXPECT_EQ(read_houses(text, {.without = {"A (2)", "17"}}).said, "--without leaves out: \"A (2)\"; \"17\"\n");
  EXPECT_EQ(read_houses(text, {.without = {"17", "way/4"}}).names, "A 2, A (2) 2");
  EXPECT_NE(read_houses(text, {.without = {"A", "17"}}).errors.find("has 1 polygon"), std::string::npos);
  EXPECT_EQ(read_houses(text, {.without = {"17", "way/5"}}).errors,
            "ward.geojson: error: --without = \"way/5\", must be the name or id of a polygon\n");
}

TEST(GeoJson, PartsBecomeHousesOfTheirOwn) {
  const std::string parts =
      R"({"type": "Feature", "properties": {"name": "Mill", "levels": 3}, "geometry": {"type": "MultiPolygon", )"
      R"("coordinates": [[[[0,0],[9,0],[9,9],[0,9],[0,0]]], [[[20,0],[29,0],[29,9],[20,9],[20,0]], )"
      R"([[22,2],[24,2],[24,4],[22,2]]], [[[40,0],[49,0],[49,9],[40,0]]]]}})";
  const std::string text = houses_text({parts, house_at(9, two_levels + "\"Mill, part 2\"")});
  EXPECT_EQ(read_houses(text).errors,
            "ward.geojson:2:1: error: features[0] (\"Mill\").geometry has 3 polygons, must be one: parts that stand "
            "apart move apart; --parts takes each as a house of its own; --without \"Mill\" leaves it out\n");
  const HousesRead read = read_houses(text, {.parts = true});
  EXPECT_EQ(read.names, "Mill, part 1 3, Mill, part 2 (2) 3, Mill, part 3 3, Mill, part 2 2");
  EXPECT_EQ(read.said,
            "parts of a MultiPolygon are houses of their own, of the same storeys and height: \"Mill\", 3 parts\n");
  EXPECT_EQ(read.houses->all[1].holes.size(), 1U);
  EXPECT_EQ(read.houses->all[1].key, "features[0] (\"Mill, part 2 (2)\")");
  const HousesRead fewer = read_houses(text, {.parts = true, .without = {"Mill, part 3"}});
  EXPECT_EQ(fewer.names, "Mill, part 1 3, Mill, part 2 (2) 3, Mill, part 2 2");
  EXPECT_EQ(fewer.said.substr(0, fewer.said.find('\n')), "--without leaves out: \"Mill, part 3\"");
  EXPECT_EQ(read_houses(text, {.parts = true, .without = {"Mill, part 4"}}).errors,
            "ward.geojson: error: --without = \"Mill, part 4\", did you mean \"Mill, part 2\"?\n");
  EXPECT_EQ(read_houses(parts, {.parts = true}).names, "Mill, part 1 3, Mill, part 2 3, Mill, part 3 3");  // a Feature
}

TEST(GeoJson, FeaturesMayStandOneALineAndOneMayStandAlone) {
  const std::string a = house_at(0, two_levels + "\"A\""), b = house_at(10, two_levels + "\"B\"");
  for (const std::string& text : {a + "\n" + b, a + "\r\n\r\n  " + b + "\n\n", "\xEF\xBB\xBF" + a + "\n" + b,
                                  "\x1e" + a + "\n\x1e" + b + "\n", "\n\x1e\n" + a + "\x1e" + b}) {
    EXPECT_EQ(read_houses(text).names, "A 2, B 2") << read_houses(text).errors;
  }
  EXPECT_EQ(read_houses(a + "\n\n " + b + "\n  {\"type\": 3, x").errors,
            "ward.geojson:4:15: error: is not JSON from here on\n");
  EXPECT_EQ(read_houses("\x1e" + a + "\n\x1e" + b + "\n\x1e{").errors,
            "ward.geojson:3:3: error: is not JSON from here on\n");
  EXPECT_EQ(read_houses(a + "\n\n 7\n" + b).errors, "ward.geojson:3:2: error: features[1] must be a Feature\n");
  EXPECT_EQ(read_houses(a + "\n[1e999]").errors, "ward.geojson:2:1: error: has a number that is too large\n");
  EXPECT_EQ(read_houses(a).errors, "ward.geojson: error: has 1 polygon, a block has two or more\n");
  EXPECT_EQ(read_houses("\n {\n\"type\": \"Feature\"}").errors,
            "ward.geojson: error: has 0 polygons, a block has two or more; features without geometry are left out: "
            "\"building 1\"\n");
  // A list that another line follows is as wrong as ever.
  EXPECT_NE(read_houses(houses_text({a}) + "\n" + b).errors.find("is not JSON from here on"), std::string::npos);
  EXPECT_EQ(read_houses("{\"type\": \"Polygon\"}").errors,
            "ward.geojson: error: must be a GeoJSON FeatureCollection with its features (RFC 7946), a Feature, or "
            "features one a line (RFC 8142)\n");
}

TEST(GeoJson, FeaturesWithoutGeometryAreNamed) {
  std::vector<std::string> features = {house_at(0, two_levels + "\"A\""), house_at(10, two_levels + "\"B\"")};
  for (int i = 0; i < 22; ++i) {
    features.push_back(
        fmt::format(R"({{"type": "Feature", "id": {}, "properties": {{}}, "geometry": null}})", 100 + i));
  }
  const HousesRead read = read_houses(houses_text(features));
  EXPECT_EQ(read.names, "A 2, B 2");
  EXPECT_TRUE(read.said.starts_with("features without geometry are left out: \"100\"; \"101\"; "));
  EXPECT_TRUE(read.said.ends_with("\"119\"; and 2 more\n"));
}

}  // namespace
}  // namespace bentur
