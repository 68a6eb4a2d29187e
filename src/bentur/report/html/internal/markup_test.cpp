#include "bentur/report/html/internal/markup.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bentur::html
