#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "tests/support/column_case.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"
#include "tests/support/kinds_case.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

std::vector<std::string> texts_of(const Figure& figure) {
  std::vector<std::string> texts;
  for (const Panel& panel : figure.panels) {
    texts.insert(texts.end(), {panel.title, panel.x.label, panel.y.label, panel.note, panel.events.label});
    for (const Curve& curve : panel.curves) texts.push_back(curve.label);
    for (const RuleLine& rule : panel.rules) texts.push_back(rule.label);
    if (panel.map) texts.push_back(panel.map->label);
  }
  std::erase(texts, "");
  return texts;
}

/// Every text that a figure shows is a word of the catalogue, the name of a building, or symbols and numbers.
TEST(FigureWords, EveryTextOfARunIsInTheCatalogue) {
  std::set<std::string> known;
  for (const std::string& key : text_keys("figure.text.")) known.insert(catalogue_entry(key)->at("en"));
  const std::regex symbols(R"((T[₁₂₃]|S[ad]|ζ|[xVMN])[^a-zA-Z]*( s(, [0-9]+ %)?|%| \[.*\])?|[0-9.]+)");
  for (const std::string& text :
       {std::string(test::struck_columns), std::string(test::every_kind), std::string(test::linked),
        std::string(test::hinged), std::string(test::hinged_alone), test::sticks_in_mm(5000, 3500)}) {
    const RunResults results = test::drawn_run(text);
    std::set<std::string> names;
    for (const Building& building : results.problem.buildings) names.insert(building.name);
    FigureOptions options;
    options.say = [&](std::string_view english) {
      EXPECT_TRUE(known.contains(std::string(english))) << english << " is not in the catalogue";
      return "§" + std::string(english);
    };
    for (const FigureKind& kind : figure_kinds(results)) {
      const Figure figure = make_figure(results, kind.name, options);
      const bool is_story = kind.name == "overview";  // the first sentence of the verdict, which has words of its own
      EXPECT_NE(figure.finding.find(is_story ? " " : "§"), std::string::npos) << kind.name << " tells nothing";
      EXPECT_EQ(figure.finding.find("{}"), std::string::npos) << kind.name << ": " << figure.finding;
      for (const std::string& shown : texts_of(figure)) {
        const bool is_word = shown.find("§") != std::string::npos;
        const std::size_t comma = shown.find(", ");  // "Tower, M [kN·m]"
        const bool is_of_one = comma != std::string::npos && names.contains(shown.substr(0, comma));
        const std::string symbol = is_of_one ? shown.substr(comma + 2) : shown;
        EXPECT_TRUE(is_word || names.contains(shown) || std::regex_match(symbol, symbols))
            << kind.name << ": " << shown;
      }
    }
  }
}

/// What names an SVG or a PDF is of the language of its texts: in Indonesian the text below the figure in a report.
TEST(FigureWords, TitlesAreOfTheLanguageAskedFor) {
  const Words say("id");
  FigureOptions indonesian;
  indonesian.say = figure_words("id");
  indonesian.language = "id";
  const auto expect = [&](const auto& run, bool in_plan) {
    for (const FigureKind& kind : figure_kinds(run)) {
      const std::string english = make_figure(run, kind.name).title,
                        title = make_figure(run, kind.name, indonesian).title;
      EXPECT_NE(title, english) << kind.name;
      EXPECT_FALSE(title.empty()) << kind.name;
      EXPECT_TRUE(say(caption_key(kind.name, in_plan)).starts_with(title)) << kind.name << ": " << title;
    }
  };
  for (const std::string& text : {std::string(test::struck_columns), std::string(test::every_kind)}) {
    expect(test::drawn_run(text), false);
  }
  expect(test::plan_run(test::twisting_pair(), 0.002), true);
}

/// A tower of 154 m as well: the numbers along the height are levels, of which no power of ten goes into the unit.
TEST(FigureWords, LevelsAreNeverInPowersOfTen) {
  for (const double storey : {3500.0, 50000.0}) {
    const RunResults results = test::drawn_run(test::sticks_in_mm(25, storey));
    ASSERT_FALSE(results.response.impacts.empty());
    bool told = false;
    for (const FigureKind& kind : figure_kinds(results)) {
      const Figure figure = make_figure(results, kind.name);
      for (const std::string& shown : texts_of(figure)) {
        EXPECT_EQ(shown.find("e+"), std::string::npos) << kind.name << ": " << shown;
        told = told || shown.find(fmt::format("level {:.0f} mm", 4000 + 3 * storey)) != std::string::npos;
      }
      for (const Panel& panel : figure.panels) {
        if (panel.y.label != "Level z [mm]") continue;
        EXPECT_NE(figure_text(figure, "x").script.find("\"Level z [mm]\""), std::string::npos);
      }
    }
    EXPECT_TRUE(told);
  }
  FigureOptions elsewhere;
  elsewhere.elevation = 12345;
  try {
    (void)make_figure(test::drawn_run(test::sticks_in_mm(25, 3500)), "opening", elsewhere);
    FAIL();
  } catch (const NoFigure& refused) {
    EXPECT_EQ(std::string(refused.what()), "no contact point at level 12345 mm: there are 4000, 7500, 11000, 14500");
  }
}

/// Without an impact there is one response: nothing of it is called "with contact".
TEST(FigureWords, AnEnvelopeWithoutImpactSaysWhatItIs) {
  const auto labels = [](const RunResults& results) {
    std::set<std::string> found;
    for (const Panel& panel : make_figure(results, "envelope").panels) {
      for (const Curve& curve : panel.curves) found.insert(curve.label);
    }
    return found;
  };
  const RunResults apart = test::drawn_run(test::sticks_in_mm(5000, 3500));
  ASSERT_TRUE(apart.response.impacts.empty());
  EXPECT_EQ(labels(apart), std::set<std::string>{"largest displacement"});
  EXPECT_EQ(make_figure(apart, "envelope").title.find("contact"), std::string::npos);
  EXPECT_EQ(labels(test::drawn_run(test::sticks_in_mm(25, 3500))),
            (std::set<std::string>{"with contact", "without contact"}));
}

}  // namespace
}  // namespace bentur
