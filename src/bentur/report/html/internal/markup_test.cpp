#include "bentur/report/html/internal/markup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bentur/report/html/internal/each_of.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

TEST(Markup, TextCannotBringInMarkup) {
  EXPECT_EQ(Html::text("</p><script>alert(1)</script>").str(), "&lt;/p&gt;&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(Html::text("\" onload='x' `y`").str(), "&quot; onload=&#39;x&#39; &#96;y&#96;");
  EXPECT_EQ(Html::text("a & b &lt; c").str(), "a &amp; b &amp;lt; c");
}

TEST(Markup, TextOfAnyLanguageStaysAsItIs) {
  EXPECT_EQ(Html::text("Gedung Ü, 建物, ½\n").str(), "Gedung Ü, 建物, ½\n");
  EXPECT_EQ(Html::text("").str(), "");
}

TEST(Markup, WhatIsNoTextBecomesTheReplacementCharacter) {
  EXPECT_EQ(Html::text(std::string_view("a\0b\x07", 4)).str(), "a\uFFFDb\uFFFD");
  EXPECT_EQ(Html::text("a\xFF\xC3").str(), "a\uFFFD\uFFFD");
  EXPECT_EQ(Html::text("\xC3<").str(), "\uFFFD&lt;") << "half a character does not swallow the next one";
}

TEST(Markup, JsonCannotEndItsScript) {
  EXPECT_EQ(json_markup(R"({"a":"</script><!--"})").str(), R"({"a":"\u003c/script>\u003c!--"})");
}

TEST(Markup, TableEscapesNamesUnitsAndCells) {
  HtmlTable table;
  table.add("<n>", "<u>", {"<c>"}, false);
  table.add("x", "", std::vector<double>{1.5});
  table.mark(0);
  const std::string markup = table.markup("id=\"t\"").str();
  EXPECT_NE(markup.find("<table id=\"t\">"), std::string::npos);
  EXPECT_NE(markup.find("&lt;n&gt;<br><small>&lt;u&gt;</small>"), std::string::npos);
  EXPECT_NE(markup.find("<tr class=\"marked\"><td class=\"t\">&lt;c&gt;</td><td>1.5</td></tr>"), std::string::npos);
  EXPECT_EQ(facts({{"<a>", "<b>"}}).str().find("<a>"), std::string::npos);
}

/// What a table is of stands in its head, which paper repeats, and in a heading, which a screen has; it is no text of
/// the case that could bring in markup.
TEST(Markup, ATitleStandsInTheHeadOfItsTable) {
  HtmlTable table;
  table.add("Level", "m", std::vector<double>{300, 200});
  table.add("Needed", "m", std::vector<double>{5, 0.25});
  EXPECT_EQ(table.markup().str().find("titles"), std::string::npos);
  const std::string markup = under("h4", "A <&> B", table).str();
  EXPECT_EQ(markup.find("<h4>A &lt;&amp;&gt; B</h4><div class=\"wide\""), 0U) << markup;
  EXPECT_NE(
      markup.find("<table aria-label=\"A &lt;&amp;&gt; B\"><thead><tr class=\"titles\" hidden><th scope=\"colgroup\" "
                  "colspan=\"2\">A &lt;&amp;&gt; B</th></tr><tr><th scope=\"col\">Level"),
      std::string::npos)
      << markup;
  EXPECT_TRUE(under("h4", "None", HtmlTable()).str().empty());
}

/// On a telephone a table that is broader is cards, each cell with its heading; a narrow one stays a table.
TEST(Markup, BroadTablesAreCardsOnATelephone) {
  HtmlTable table;
  table.add("Level", "m", std::vector<double>{300, 200});
  table.add("Peak force", "kN", std::vector<double>{5, 0.25});
  table.add("Where", "", {"a", "b"}, false);
  EXPECT_EQ(table.markup().str().find("data-head"), std::string::npos);
  EXPECT_NE(table.markup().str().find("<table>"), std::string::npos);
  table.add("Why", "", {"a text that is longer than a telephone", "no"}, false);
  const std::string cards = table.markup("id=\"t\"").str();
  EXPECT_NE(cards.find("<table id=\"t\" class=\"cards\">"), std::string::npos) << cards;
  EXPECT_NE(cards.find("<td data-head=\"Peak force [kN]\">5.00</td>"), std::string::npos) << cards;
  EXPECT_NE(cards.find("<td class=\"t\" data-head=\"Where\">a</td>"), std::string::npos) << cards;
  EXPECT_NE(cards.find("<td class=\"t long\" data-head=\"Why\">no</td>"), std::string::npos) << cards;
  EXPECT_EQ(table.printed(2).str().find("data-head"), std::string::npos) << "paper has room";
}

/// A card is called by as many of the first columns as it takes to tell it from all others.
TEST(Markup, CardsHaveTitlesOfTheirOwn) {
  HtmlTable table;
  table.add("Member", "", {"column", "column", "beam", "column"}, false);
  table.add("Level", "m", {"3", "3", "3", "6"});
  table.add("End", "", {"top", "bottom", "left", "top"}, false);
  for (const char* const name : {"Rotation", "Residual", "Moment", "Energy"}) {
    table.add(name, "kN·m", std::vector<double>{1, 2, 3, 4});
  }
  const std::string cards = table.markup().str();
  for (const char* const rest : {"Level [m] 3, top", "Level [m] 3, bottom", "Level [m] 3, left", "Level [m] 6, top"}) {
    EXPECT_NE(cards.find("data-head=\"Member\" data-rest=\", " + std::string(rest) + "\""), std::string::npos) << cards;
  }
  EXPECT_NE(cards.find("<td class=\"t told\" data-head=\"End\">bottom</td>"), std::string::npos) << cards;
  EXPECT_NE(cards.find("class=\"cards four\""), std::string::npos) << "four cells are left: " << cards;
  EXPECT_EQ(table.printed(4).str().find("data-rest"), std::string::npos) << "a row is no card";
  HtmlTable alike;  // two contacts at one corner that nothing struck
  for (const char* const name : {"Level-of-the-roof", "Needed-of-the-gap", "Force-at-a-corner"}) {
    alike.add(name, "m", std::vector<double>{6, 6, 3});
  }
  EXPECT_NE(alike.markup().str().find("[m]\" data-rest=\" (2)\">6<"), std::string::npos) << alike.markup().str();
}

/// Others have a form that is theirs by what they are, however broad they are.
TEST(Markup, SomeTablesHaveAFormOfTheirOwnOnATelephone) {
  HtmlTable table;
  table.add("Gap", "", {"A | B"}, false);
  table.add("Width", "m", std::vector<double>{0.1});
  using Form = HtmlTable::OnTelephone;
  for (const auto& [form, name, in_cells] :
       {std::tuple(Form::gaps, "gaps", true), {Form::checks, "checks", true}, {Form::said, "said", false}}) {
    const std::string markup = table.markup("", form).str();
    EXPECT_NE(markup.find("<table class=\"" + std::string(name) + "\">"), std::string::npos) << markup;
    EXPECT_EQ(markup.find("data-head") != std::string::npos, in_cells) << name;
  }
}

/// Joined, numbers of one column have equally many decimals, so that two digits of the smallest are seen.
TEST(Markup, JoinedColumnsHaveDecimalsAlike) {
  HtmlTable joined;
  for (const double size : {1.0, 100.0, 0.01}) {
    HtmlTable one;
    one.add("Level", "m", std::vector<double>{3 * size, 6.5 * size});
    one.add("Needed", "m", {"≤ 0.5", "–"}, true, {0.5, NAN});
    one.add("Start", "s", {"1.0000", "2.5000"}, true);
    joined.join("House", one);
  }
  const std::string markup = joined.printed(6).str();
  for (const char* const cell : {"3.000", "6.500", "300.000", "650.000", "0.030", "0.065", "≤ 0.5", "–", "2.5000"}) {
    EXPECT_NE(markup.find("<td>" + std::string(cell) + "</td>"), std::string::npos) << cell << markup;
  }
}

/// Of what is given, on paper: columns that say the same in all rows are said once, in tables no broader than a page;
/// every building in one table.
TEST(EachOf, SaysOnPaperOnceWhatIsAlikeInAll) {
  EachOf all(true);
  for (int n = 0; n < 8; ++n) {
    HtmlTable table;
    table.add("Damping", "%", std::vector<double>{5});
    table.add("Stiffness", "kN/m", std::vector<double>{4e4 + n});
    for (int k = 0; k < 3; ++k) table.add("Masses " + std::to_string(k), "t", {std::string(45, "12345678"[n])}, false);
    all.add("House " + std::to_string(n), Html::text("whole"), {table});
  }
  const std::string page = all.markup(Words("en"), "appendix.entries.building").str();
  const std::string printed = page.substr(0, page.find("<details"));
  EXPECT_NE(printed.find("Alike in all: Damping 5\u00A0%."), std::string::npos) << printed;
  EXPECT_EQ(printed.find("<th scope=\"col\">Damping"), std::string::npos);
  std::size_t tables = 0, rows = 0;
  for (std::size_t at = 0; (at = printed.find("<table", at)) != std::string::npos; ++at) ++tables;
  for (std::size_t at = 0; (at = printed.find(">House 7<", at)) != std::string::npos; ++at) ++rows;
  EXPECT_EQ(tables, 2U) << "of some 118 letters each";
  std::size_t titles = 0;
  const std::string title = ">8 buildings, each as it is given</th></tr><tr><th scope=\"col\" class=\"t\">Building<";
  for (std::size_t at = 0; (at = printed.find(title, at)) != std::string::npos; ++at) ++titles;
  EXPECT_EQ(titles, 2U) << "both are called what they are of: " << printed;
  EXPECT_EQ(rows, 2U) << "each names its rows";
  for (const char* const name : {"Stiffness", "Masses 0", "Masses 1", "Masses 2"}) {
    EXPECT_NE(printed.find(name), std::string::npos) << name;
  }
}

/// What has no table in short on paper is said to be in the file.
TEST(EachOf, SaysWhereTheRestIs) {
  EachOf many, few;
  for (int n = 0; n < 8; ++n) (n < 3 ? few : many).add("Gap " + std::to_string(n), Html::text("whole"));
  many.add("Gap 8", Html::text("whole"));
  many.add("Gap 9", Html::text("whole"));
  const std::string said =
      "<p class=\"print joined\">7 gaps, each by itself: in the file from which this was printed.</p>";
  EXPECT_NE(many.folded(Words("en"), "appendix.gaps").str().find(said), std::string::npos);
  EXPECT_EQ(few.folded(Words("en"), "appendix.gaps").str().find("printed"), std::string::npos) << "paper has them";
}

/// Of one row nothing is alike in all.
TEST(Markup, OneRowKeepsItsColumns) {
  HtmlTable table;
  table.add("Gap", "", {"A | B"}, false);
  table.add("Width", "m", std::vector<double>{0.1});
  EXPECT_TRUE(table.take_alike().empty());
  EXPECT_EQ(table.columns(), 2U);
}

/// Of a table that is too broad for paper it is said which columns are not there, each name once.
TEST(EachOf, NamesTheColumnsThatPaperLacks) {
  EachOf all;
  for (int n = 0; n < 8; ++n) {
    HtmlTable table;
    for (int k = 0; k < 14; ++k) table.add("c" + std::to_string(k), "", std::vector<double>{1.0 * k});
    table.add("Slides", "m", std::vector<double>{1});
    table.add("Slides", "m", std::vector<double>{2});
    all.add("Pair " + std::to_string(n), Html::text("whole"), {table});
  }
  const std::string page = all.markup(Words("en"), "appendix.contacts").str();
  EXPECT_NE(page.find("On paper the first 12 of 17 columns, without: c11, c12, c13, Slides. "), std::string::npos)
      << page;
}

TEST(Names, OfManyBuildingsHaveAKeyOfNumbersUnlessTheyEndWithThem) {
  EXPECT_EQ(numbered({"House 1", "House 2", "7"}), "3\u00A07");
  EXPECT_EQ(numbered({"House 2", "House 1"}), "1\u00A0House 2, 2\u00A0House 1");
  EXPECT_EQ(numbered({"Bank", "12"}), "1\u00A0Bank, 2\u00A012");
  EXPECT_EQ(numbered({"House 1", "House 2"}), "");
  EXPECT_EQ(numbered({"House 1.1", "House 1.2"}), "1\u00A0House 1.1, 2\u00A0House 1.2");
}

}  // namespace
}  // namespace bentur::html
