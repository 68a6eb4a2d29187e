#include "bentur/report/words.h"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/model/gap/code_rules.h"
#include "bentur/model/quantities.h"
#include "bentur/report/html/internal/assets.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/studies/sweep_data.h"
#include "tests/support/example_laws.h"

namespace bentur {
namespace {

/// The {names} a text has, of {name:has|have} too.
std::set<std::string> names(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    found.insert(std::string(text.substr(open + 1, text.find_first_of(":}", open) - open - 1)));
  }
  return found;
}

TEST(Catalogue, EveryKeyHasATextInEveryLanguageThatTakesTheSameValues) {
  ASSERT_EQ(report_languages(), (std::vector<std::string>{"en", "id"}));
  EXPECT_GT(text_keys().size(), 200U);
  for (const std::string& key : text_keys()) {
    const Texts& texts = *catalogue_entry(key);
    EXPECT_EQ(texts.size(), report_languages().size()) << key << ": another language than those of the file";
    for (const std::string& language : report_languages()) {
      ASSERT_TRUE(texts.contains(language)) << key << " " << language;
      EXPECT_FALSE(texts.at(language).empty()) << key << " " << language;
      EXPECT_EQ(names(texts.at(language)), names(texts.begin()->second)) << key;
    }
  }
}

/// What is read in a report, which may be handed in, is no talk of a terminal: of options, commands, or in quotes of
/// code.
TEST(Catalogue, ReportsDoNotTalkOfTheCommandLine) {
  const std::regex talk("--[a-z]|`|bentur (run|gap|report|plot|modes|ida|sweep)");
  std::size_t looked_at = 0;
  for (const char* const part : {"story.", "remark", "impacts.", "gap.", "peaks.", "plan.", "figure.", "check.",
                                 "sensitivity.", "appendix.", "input.", "screening.", "damage.", "columns."}) {
    for (const std::string& key : text_keys(part)) {
      const bool is_of_terminal = key.starts_with("story.least_gap") || key.starts_with("story.risk");
      if (is_of_terminal) continue;
      for (const auto& [language, text] : *catalogue_entry(key)) {
        EXPECT_FALSE(std::regex_search(text, talk)) << key << ": " << text;
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 1000U);
}

/// Each counted sentence with 1: none says "1 columns break". Those of two or more, by their nature, are left out.
TEST(Catalogue, NothingIsCountedAsSeveralWhereItIsOne) {
  const std::regex several(
      "\\b1 (more )?(gaps|hinges|columns|floors|joints|runs|records|storeys|modes|levels|steps|events)\\b"
      "|\\b1 of (the )?9( runs| files)? (are|have|do|form|break|collapse|need)\\b");
  const std::set<std::string> of_several = {
      "appendix.gaps",          // pages of cases with many
      "appendix.entries.gap",   // likewise
      "appendix.gaps.printed",  // likewise
      "story.columns_beyond",   // after one that is told
      "story.sensitivity_takes_mean",
      "story.table.row_worst",
      "story.suite_too_few",  // codes ask for seven or so
      "sweep.runs_cut",       // thirty
      "checked.steps",        // thousands
  };
  const std::set<std::string> totals = {"runs", "files", "all"};
  std::size_t counted = 0;
  for (const std::string& key : text_keys()) {
    const bool has_no_names = key.starts_with("figure.text.");
    if (has_no_names || key.ends_with(".many") || key.starts_with("story.row_") || of_several.contains(key)) continue;
    std::vector<std::pair<std::string, std::string>> ones;
    for (const std::string& name : names(catalogue_entry(key)->at("en"))) {
      ones.emplace_back(name, totals.contains(name) ? "9" : "1");
    }
    const std::string text = Words("en")(key, ones);
    counted += text.find("1 of 9") != std::string::npos ? 1 : 0;
    std::smatch found;
    EXPECT_FALSE(std::regex_search(text, found, several)) << key << ": " << found.str() << "\n" << text;
  }
  EXPECT_GT(counted, 9U);
}

/// A table holds the text of one key in each language, tables of longer keys, or both.
void collect(const TomlValue& table, const std::string& key, std::map<std::string, Texts>& into) {
  for (const TomlMember& member : table.members) {
    if (member.value.kind == TomlValue::Kind::text) into[key][member.key] = member.value.text;
    collect(member.value, key.empty() ? member.key : key + "." + member.key, into);
  }
}

TEST(Catalogue, WhatIsReadKeyByKeyIsWhatTheWholeFileHas) {
  Diagnostics diagnostics;
  const auto whole = parse_toml(std::string(html::asset("texts.toml")), "texts.toml", diagnostics);
  ASSERT_TRUE(whole) << diagnostics.errors().front().text();
  std::map<std::string, Texts> all;
  collect(*whole, "", all);
  std::map<std::string, Texts> by_key;
  for (const std::string& key : text_keys()) by_key[key] = *catalogue_entry(key);
  EXPECT_EQ(by_key, all);
  EXPECT_EQ(catalogue_entry("story"), nullptr);
  EXPECT_EQ(catalogue_entry("languages"), nullptr);
}

TEST(Catalogue, QuantitiesHaveALabelInEveryLanguage) {
  EXPECT_EQ(std::size(Quantity{}.label), report_languages().size());
  for (const Quantity& quantity : quantities()) {
    for (const std::string_view label : quantity.label) {
      EXPECT_EQ(label.empty(), quantity.label[0].empty()) << quantity.key;
    }
  }
}

TEST(Catalogue, WhatALawWorksWithIsAKey) {
  for (const test::LawExample& example : test::example_laws()) {
    for (const auto& [name, value] : example.make(1e5)->parameters()) {
      EXPECT_NE(contact_keys().find(name), nullptr) << name;
    }
  }
}

TEST(Catalogue, SaysOfEveryRuleOfACodeWhatItTakes) {
  for (const CodeRule& rule : code_rules()) {
    const std::string said = std::string(rule.assumes) + "; " + std::string(rule.motion);
    EXPECT_EQ(Words("en")("gap.takes." + std::string(rule.name)), said);
  }
}

TEST(Catalogue, HasACaptionForEveryFigure) {
  const Words say("en");
  for (const std::string& name : run_figure_names()) {
    EXPECT_NO_THROW(static_cast<void>(say("figure." + name))) << name;
  }
  for (const SweepKind& kind : sweep_kinds()) {
    EXPECT_NO_THROW(static_cast<void>(say("figure.sweep." + kind.kind))) << kind.kind;
  }
  for (const char* name : {"ida.without_fractiles", "fragility.without_bounds", "collapse.without_bounds"}) {
    EXPECT_NO_THROW(static_cast<void>(say(std::string("figure.sweep.") + name))) << name;
  }
}

TEST(Words, ValuesAreTakenAsTheyAre) {
  const Words say("en");
  EXPECT_EQ(say("story.no_pounding", {{"left", "{right}"}, {"right", "}{"}, {"duration", "10 s"}}),
            "{right} and }{ do not touch in 10 s.");
}

TEST(Words, OneAndManyHaveWordsOfTheirOwn) {
  const Words say("en");
  const auto broken = [&](const std::string& value) {
    const std::string text = say("remark.broken_columns", {{"value", value}, {"usual", "usual is none"}});
    return text.substr(0, text.find(" in shear"));
  };
  EXPECT_EQ(broken("1"), "1 column breaks");
  EXPECT_EQ(broken("2"), "2 columns break");
  EXPECT_EQ(broken("11"), "11 columns break");
  EXPECT_TRUE(Words("id")("remark.broken_columns", {{"value", "1"}, {"usual", ""}}).starts_with("1 kolom patah"));
}

TEST(Words, CountsInBothLanguages) {
  EXPECT_EQ(Words("en").count("story.count.times", 1), "once");
  EXPECT_EQ(Words("en").count("story.count.times", 24), "24 times");
  EXPECT_EQ(Words("id").count("story.count.times", 24), "24 kali");
}

TEST(Words, MistakesAreNamed) {
  EXPECT_THROW(Words("fr"), InvalidParameter);
  EXPECT_THROW(static_cast<void>(Words("en")("no.such.key")), InvalidParameter);
  EXPECT_THROW(static_cast<void>(Words("en")("story.no_pounding", {{"left", "A"}})), InvalidParameter);
}

}  // namespace
}  // namespace bentur
