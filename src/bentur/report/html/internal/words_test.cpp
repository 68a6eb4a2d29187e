#include "bentur/report/html/internal/words.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/report/kinds/internal/sweep_data.h"
#include "bentur/report/kinds/kinds.h"
#include "tests/support/example_laws.h"

namespace bentur::html {
namespace {

/// The {names} a text has.
std::set<std::string> names(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    found.insert(std::string(text.substr(open + 1, text.find('}', open) - open - 1)));
  }
  return found;
}

TEST(Catalogue, EveryKeyOnceWithATextInEveryLanguageThatTakesTheSameValues) {
  std::set<std::string_view> keys;
  ASSERT_EQ(report_languages().size(), std::size(Entry{}.texts));
  for (const Entry& entry : catalogue()) {
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
    for (const std::string_view text : entry.texts) {
      EXPECT_FALSE(text.empty()) << entry.key;
      EXPECT_EQ(names(text), names(entry.texts[0])) << entry.key;
    }
  }
}

TEST(Catalogue, HasWordsForWhatEveryLawWorksWith) {
  const Words say("id");
  for (const test::LawExample& example : test::example_laws()) {
    for (const auto& [name, value] : example.make(1e5)->parameters()) {
      EXPECT_NO_THROW(static_cast<void>(say("parameter." + std::string(name)))) << name;
    }
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
}

TEST(Words, ValuesAreTakenAsTheyAre) {
  const Words say("en");
  EXPECT_EQ(say("verdict.apart", {{"left", "{right}"}, {"right", "}{"}, {"duration", "10 s"}}),
            "{right} and }{ do not touch in 10 s.");
}

TEST(Words, CountsInBothLanguages) {
  EXPECT_EQ(Words("en").count("verdict.times", 1), "once");
  EXPECT_EQ(Words("en").count("verdict.times", 24), "24 times");
  EXPECT_EQ(Words("id").count("verdict.times", 24), "24 kali");
}

TEST(Words, MistakesAreNamed) {
  EXPECT_THROW(Words("fr"), InvalidParameter);
  EXPECT_THROW(static_cast<void>(Words("en")("no.such.key")), InvalidParameter);
  EXPECT_THROW(static_cast<void>(Words("en")("verdict.apart", {{"left", "A"}})), InvalidParameter);
}

}  // namespace
}  // namespace bentur::html
