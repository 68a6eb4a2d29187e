#include "bentur/io/schema/case_keys.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bentur/contact/laws.h"
#include "bentur/io/schema/json_schema.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/model/case.h"

namespace bentur {
namespace {

/// Every key of a table and of those below it, each table once.
template <class Look>
void for_every_key(const KeyTable& table, std::set<const KeyTable*>& seen, const Look& look) {
  if (!seen.insert(&table).second) return;
  for (const Key& key : table.keys) {
    look(table, key);
    if (key.table != nullptr) for_every_key(*key.table, seen, look);
  }
}

TEST(CaseKeys, EachIsWhole) {
  std::set<const KeyTable*> seen;
  std::size_t count = 0;
  for_every_key(case_keys(), seen, [&](const KeyTable& table, const Key& key) {
    SCOPED_TRACE(std::string(table.name) + "." + std::string(key.name));
    ++count;
    EXPECT_FALSE(key.label.english.empty() || key.label.indonesian.empty());
    const bool may_be_table =
        key.kind == Key::Kind::number || key.kind == Key::Kind::choice || key.kind == Key::Kind::file;
    EXPECT_EQ(key.kind == Key::Kind::table, key.table != nullptr && !may_be_table);
    if (key.kind == Key::Kind::choice) {
      EXPECT_GT(key.words.size() + (key.table != nullptr ? 1 : 0), 1U);  // a table stands for a word
    }
    EXPECT_TRUE(key.word_labels.empty() || key.word_labels.size() == key.words.size());
    if (key.kind == Key::Kind::flag && key.form == Key::Form::one) {
      EXPECT_TRUE(key.default_value);
    }
    if (key.default_value && key.kind == Key::Kind::number) {
      EXPECT_EQ(broken_rule(key.range, *key.default_value), "");
    }
    if (!key.with.empty()) {
      EXPECT_NE(table.find(key.with), nullptr);
    }
    for (const Condition& condition : key.conditions) {
      const Key* const by = table.find(condition.key);
      ASSERT_NE(by, nullptr);
      if (by->kind == Key::Kind::flag) continue;
      for (const std::string_view word : condition.words) {
        EXPECT_NE(std::find(by->words.begin(), by->words.end(), word), by->words.end()) << word;
      }
    }
  });
  EXPECT_GT(count, 150U);
  EXPECT_GT(seen.size(), 30U);
}

/// What the schema says of a text by itself, no reader asking.
std::vector<std::string> found_in(const std::string& text) {
  Diagnostics diagnostics;
  const TomlValue root = *parse_toml(text, "a.toml", diagnostics);
  check_values(TomlView(root, "", "a.toml", diagnostics), case_keys());
  std::vector<std::string> found;
  for (const Diagnostic& one : diagnostics.errors()) found.push_back(one.message());
  return found;
}

TEST(CaseKeys, AValueOfTheWrongKindIsRefusedThoughNobodyReadsIt) {
  EXPECT_EQ(found_in("[analysis]\nsolver = [\"exact\"]\nboth_ways = 1\nlimits = { steps = \"many\" }\nduration = 5\n"),
            (std::vector<std::string>{"analysis.solver is a list, must be a text in quotes",
                                      "analysis.both_ways = 1, must be true or false",
                                      "analysis.limits.steps = \"many\", must be a number"}));
  EXPECT_EQ(found_in("building = [{ name = \"A\", stick = { masses = [1, \"2\"], stiffnesses = 3 }, soil = true }]\n"),
            (std::vector<std::string>{"building[\"A\"].stick.masses[1] = \"2\", must be a number",
                                      "building[\"A\"].stick.stiffnesses = 3, must be a list",
                                      "building[\"A\"].soil = true, must be a table"}));
  EXPECT_EQ(found_in("gap = [{ contact = { stiffness = \"axial\" }, width = [0.1, -1] }]\n"),
            (std::vector<std::string>{"gap[0].width[1] = -1, must be >= 0"}));
  EXPECT_EQ(found_in("[excitation]\npga = \"0.35 g\"\nfile = \"a\"\ncolumn = 2\n"), std::vector<std::string>());
}

TEST(CaseKeys, DefaultsAreThoseOfACaseMadeInCpp) {
  EXPECT_EQ(analysis_keys().at("output_step").default_value, AnalysisSpec{}.output_step);
  EXPECT_EQ(analysis_keys().at("collapse_drift").default_value, AnalysisSpec{}.collapse_drift);
  EXPECT_EQ(analysis_keys().at("step").default_value, RungeKuttaSolver{}.step);
  EXPECT_EQ(analysis_keys().at("tolerance").default_value, AdaptiveSolver{}.tolerance);
  EXPECT_EQ(limit_keys().at("steps").default_value, LimitsSpec{}.steps);
  EXPECT_EQ(limit_keys().at("events").default_value, LimitsSpec{}.events);
  EXPECT_EQ(limit_keys().at("memory").default_value, LimitsSpec{}.memory);
  EXPECT_EQ(unit_keys().at("length").words.front(), Units{}.length);
  EXPECT_EQ(unit_keys().at("force").words.front(), Units{}.force);
}

TEST(CaseKeys, AKeyIsThatOfTheWordThatStandsBesideIt) {
  Diagnostics diagnostics;
  const TomlValue root = parse_toml(
                             "[[gap]]\ncontact = { law = \"hertz\", stiffness = 1 }\n"
                             "[excitation]\nkind = \"spectrum\"\nshape = \"table\"\n",
                             "", diagnostics)
                             .value();
  const auto dimension_at = [&](const char* path) {
    std::string error;
    return key_at(case_keys(), *parse_path(path, error), root)->dimension;
  };
  EXPECT_EQ(dimension_at("gap[0].contact.stiffness"), dimension::hertz_stiffness);
  EXPECT_EQ(dimension_at("gap[1].contact.stiffness[3]"), dimension::stiffness);
  EXPECT_EQ(dimension_at("building[0].damping.rayleigh.periods"), dimension::time);
  EXPECT_EQ(dimension_at("initial.velocities.A[1]"), dimension::velocity);
  std::string error;
  EXPECT_EQ(key_at(case_keys(), *parse_path("gap[0].contact.colour", error), root), nullptr);
  EXPECT_EQ(key_at(case_keys(), *parse_path("initial.colour.A", error), root), nullptr);
}

TEST(JsonSchema, HasEveryLawWithItsKeys) {
  const auto schema = nlohmann::json::parse(json_schema(case_keys(), "A case"));
  const auto& contact = schema["properties"]["gap"]["items"]["properties"]["contact"];
  EXPECT_EQ(contact["properties"]["law"]["enum"].size(), contact_laws().size());
  for (const LawEntry& law : contact_laws()) {
    for (const Key& key : law.keys) EXPECT_TRUE(contact["properties"].contains(key.name)) << key.name;
  }
  EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-04/schema#");
}

TEST(JsonSchema, SaysOfEachMeaningWhatANumberMayBe) {
  const auto schema = nlohmann::json::parse(json_schema(case_keys(), "A case"));
  const auto& excitation = schema["properties"]["excitation"];
  const auto number = [&](const char* key, std::size_t meaning) {
    return excitation["properties"][key]["x-bentur"][meaning]["number"];
  };
  EXPECT_EQ(number("pga", 0), (nlohmann::json{{"type", "number"}, {"minimum", 0.0}, {"exclusiveMinimum", true}}));
  EXPECT_EQ(number("scale", 0)["not"]["enum"][0], 0);
  EXPECT_EQ(excitation["properties"]["pga"]["x-bentur"][0]["unit"], "length/s²");
  EXPECT_EQ(number("column", 0)["minimum"], 1);
  EXPECT_EQ(number("column", 1)["minimum"], 2);
  // A spectrum has accelerations without a file, and their unit.
  EXPECT_EQ(excitation["dependencies"]["column"][0], "file");
  EXPECT_FALSE(excitation["dependencies"].contains("unit"));
}

}  // namespace
}  // namespace bentur
