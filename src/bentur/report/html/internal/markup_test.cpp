#include "bentur/report/html/internal/markup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bentur/report/html/internal/each_of.h"

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
  EXPECT_NE(page.find("On paper the first 14 of 17 columns, without: c13, Slides. "), std::string::npos) << page;
}

}  // namespace
}  // namespace bentur::html
