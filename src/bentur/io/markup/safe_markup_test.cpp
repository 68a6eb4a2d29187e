#include "bentur/io/markup/safe_markup.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bentur {
namespace {

const std::string open_svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\">";

std::string logo_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto made = safe_markup(text, "logo.svg", MarkupKind::logo, diagnostics);
  EXPECT_EQ(made.has_value(), diagnostics.ok());
  return made.value_or("");
}

std::string errors_of(const std::string& text, MarkupKind kind = MarkupKind::logo) {
  Diagnostics diagnostics;
  EXPECT_FALSE(safe_markup(text, "file", kind, diagnostics).has_value()) << text;
  std::string told;
  for (const Diagnostic& one : diagnostics.errors()) told += one.text() + "\n";
  return told;
}

/// Whether markup has nothing but elements and attributes named here, which are a list of this test's own, and no value
/// that could lead outside.
void expect_harmless(const std::string& markup) {
  static const std::set<std::string> elements = {"svg",
                                                 "g",
                                                 "defs",
                                                 "path",
                                                 "rect",
                                                 "circle",
                                                 "ellipse",
                                                 "line",
                                                 "polyline",
                                                 "polygon",
                                                 "text",
                                                 "tspan",
                                                 "stop",
                                                 "br",
                                                 "hr",
                                                 "div",
                                                 "p",
                                                 "span",
                                                 "h1",
                                                 "h2",
                                                 "h3",
                                                 "em",
                                                 "table",
                                                 "tbody",
                                                 "tr",
                                                 "td",
                                                 "th",
                                                 "ul",
                                                 "li",
                                                 "b",
                                                 "i",
                                                 "ol",
                                                 "small",
                                                 "strong",
                                                 "thead",
                                                 "clipPath",
                                                 "linearGradient",
                                                 "radialGradient"};
  static const std::set<std::string> never = {"style",      "src",        "srcset",       "action", "data",
                                              "formaction", "background", "poster",       "values", "from",
                                              "to",         "begin",      "attributeName"};
  static const std::regex tag("<(/?)([A-Za-z0-9]+)((?: [A-Za-z0-9:-]+=\"[^\"<>]*\")*)>");
  std::string rest;
  auto last = markup.begin();
  for (std::sregex_iterator i(markup.begin(), markup.end(), tag), end; i != end; ++i) {
    EXPECT_TRUE(elements.contains((*i)[2])) << (*i)[2];
    rest.append(last, (*i)[0].first);
    last = (*i)[0].second;
    const std::string attributes = (*i)[3];
    static const std::regex attribute(" ([A-Za-z0-9:-]+)=\"([^\"]*)\"");
    for (std::sregex_iterator a(attributes.begin(), attributes.end(), attribute); a != end; ++a) {
      const std::string name = (*a)[1], value = (*a)[2];
      EXPECT_FALSE(name.starts_with("on")) << name;
      EXPECT_FALSE(never.contains(name)) << name;
      EXPECT_EQ(value.find_first_of(":/\\@<>{}"), std::string::npos) << name << " = " << value;
      const bool is_link = name.ends_with("href");
      EXPECT_TRUE(!is_link || value.starts_with("#logo-") || value.starts_with("#head-")) << value;
      EXPECT_TRUE(name != "id" || value.starts_with("logo-") || value.starts_with("head-")) << value;
      if (const auto url = value.find("url"); url != std::string::npos) {
        EXPECT_TRUE(value.starts_with("url(#logo-") || value.starts_with("url(#head-")) << value;
      }
    }
  }
  rest.append(last, markup.end());
  EXPECT_EQ(rest.find('<'), std::string::npos) << rest;
}

TEST(SafeMarkup, KeepsWhatALogoIsMadeOf) {
  const std::string made = logo_of(
      "<?xml version=\"1.0\"?><!-- by a program --><!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x.dtd\">\n" +
      open_svg +
      "<metadata><rdf:RDF xmlns:rdf=\"x\"><cc:Work/></rdf:RDF></metadata><sodipodi:namedview id=\"v\"/>"
      "<defs><linearGradient id=\"a\"><stop offset=\"0\" style=\"stop-color:#f00;stop-opacity:1\"/></linearGradient>"
      "<linearGradient id=\"b\" xlink:href=\"#a\"/></defs>"
      "<path id=\"data\" inkscape:label=\"x\" style=\"fill:url(#b);stroke:none;-inkscape-stroke:none;line-height:1\" "
      "fill=\"red\" d=\"M0 0,h10 v-1e-3z\"/>"
      "<text x='1' y='2' font-family='Arial'>A &amp; B &#x26; \xC3\xA9</text></svg>\n");
  EXPECT_EQ(
      made,
      "<svg viewBox=\"0 0 10 10\"><defs><linearGradient id=\"logo-a\"><stop stop-color=\"#f00\" "
      "stop-opacity=\"1\" offset=\"0\"></stop></linearGradient><linearGradient id=\"logo-b\" "
      "xlink:href=\"#logo-a\"></linearGradient></defs><path fill=\"url(#logo-b)\" stroke=\"none\" "
      "id=\"logo-data\" d=\"M0 0,h10 v-1e-3z\"></path><text x=\"1\" y=\"2\" font-family=\"Arial\">A &amp; B &amp; "
      "\xC3\xA9</text></svg>");
  expect_harmless(made);
}

TEST(SafeMarkup, ASizeInPixelsIsAViewBox) {
  EXPECT_EQ(logo_of("<svg width=\"120px\" height=\"40\"><path d=\"M0 0\"/></svg>"),
            "<svg viewBox=\"0 0 120 40\"><path d=\"M0 0\"></path></svg>");
  EXPECT_NE(errors_of("<svg width=\"10cm\" height=\"40\"/>").find("needs a viewBox"), std::string::npos);
}

TEST(SafeMarkup, RefusesWhatRunsOrLoads) {
  const std::pair<const char*, const char*> hostile[] = {
      {"<script>alert(1)</script>", "takes no <script>"},
      {"<SCRIPT>alert(1)</SCRIPT>", "takes no <SCRIPT>"},
      {"<style>path{fill:url(http://a.example/x)}</style>", "takes no <style>"},
      {"<foreignObject><div/></foreignObject>", "takes no <foreignObject>"},
      {"<image href=\"http://a.example/x.png\"/>", "takes no <image>"},
      {"<image href=\"data:image/png;base64,AAAA\"/>", "takes no <image>"},
      {"<use href=\"#a\"/>", "takes no <use>"},
      {"<a href=\"javascript:alert(1)\"><path/></a>", "takes no <a>"},
      {"<animate attributeName=\"href\" to=\"javascript:alert(1)\"/>", "takes no <animate>"},
      {"<set attributeName=\"onclick\" to=\"alert(1)\"/>", "takes no <set>"},
      {"<filter id=\"f\"/>", "takes no <filter>"},
      {"<iframe/>", "takes no <iframe>"},
      {"<svg/>", "takes no <svg>"},
      {"<p/>", "takes no <p>"},
      {"<path onclick=\"alert(1)\"/>", "<path> takes no onclick here"},
      {"<path OnLoad='alert(1)'/>", "<path> takes no OnLoad here"},
      {"<path href=\"#a\"/>", "<path> takes no href here"},
      {"<path xlink:href=\"#a\"/>", "<path> takes no xlink:href here"},
      {"<path class=\"a\"/>", "<path> takes no class here"},
      {"<path filter=\"url(#f)\"/>", "<path> takes no filter here"},
      {"<path fill=\"url(http://a.example/x#a)\"/>", "must name nothing outside"},
      {"<path fill=\"URL(//a.example/x)\"/>", "must name nothing outside"},
      {"<path fill=\"&#117;rl(x.svg#a)\"/>", "must name nothing outside"},
      {"<path fill=\"u\\72l(x)\"/>", "must be of letters"},
      {"<path d=\"url(#a)\"/>", "must name nothing outside"},
      {"<path fill=\"red;background:x\"/>", "must be of letters"},
      {"<path style=\"fill:expression(alert(1));behavior:url(x)\"/>", "takes no behavior here"},
      {"<path style=\"background-image:url(http://a.example/)\"/>", "takes no background-image here"},
      {"<path style=\"fill:url(//a.example/)\"/>", "must name nothing outside"},
      {"<path id=\"a b\"/>", "must be a letter"},
      {"<linearGradient xlink:href=\"http://a.example/#a\"/>", "must name nothing outside"},
      {"<text>&nbsp;</text>", "is no character"},
      {"<text>&xxe;</text>", "is no character"},
      {"<text>&#0;</text>", "is no character"},
      {"<![CDATA[<script>]]>", "begins no tag"},
      {"<?xml-stylesheet href=\"http://a.example/x.css\"?>", "begins no tag"},
      {"<path d=M0 />", "must have a value in quotes"},
      {"<path d=\"M0\" d=\"M1\"/>", "is given twice"},
      {"<g>", "closes </svg> where <g> is open"},
      {"</svg></svg>", "closes </svg>, which is not open"},
      {"<path d=\"M0", "ends within d of <path>"},
      {"<!-- ", "ends within a comment"},
      {"text", "has text where a logo has none"},
      {"<text>\x01</text>", "control character"},
      {"<text>\xFF</text>", "not valid UTF-8"},
  };
  for (const auto& [inner, rule] : hostile) {
    const std::string told = errors_of(open_svg + inner + "</svg>");
    EXPECT_NE(told.find(rule), std::string::npos) << inner << ": " << told;
  }
  EXPECT_NE(errors_of("<!DOCTYPE svg [<!ENTITY a \"aaaa\">]>" + open_svg + "</svg>").find("entities of its own"),
            std::string::npos);
  EXPECT_NE(errors_of("<html/>").find("takes no <html>"), std::string::npos);
  EXPECT_NE(errors_of("").find("must be one <svg>"), std::string::npos);
  EXPECT_NE(errors_of(open_svg + "</svg>" + open_svg + "</svg>").find("must be one <svg>"), std::string::npos);
}

TEST(SafeMarkup, WhatAProgramKeepsForItselfIsLeftOutWithAllInIt) {
  const std::string made =
      logo_of(open_svg +
              "<svg:script>alert(1)</svg:script><x:a><script>alert(2)</script></x:a>"
              "<title>alert(3)</title><metadata><image href=\"http://a.example\"/></metadata></svg>");
  EXPECT_EQ(made, "<svg viewBox=\"0 0 10 10\"></svg>");
}

TEST(SafeMarkup, TellsEverythingAtItsPlace) {
  const std::string told = errors_of(open_svg + "\n  <script/>\n<path onclick=\"x\"\n   fill=\"url(x)\"/></svg>");
  EXPECT_EQ(told,
            "file:2:3: error: a logo takes no <script>: shapes, texts and gradients alone\n"
            "file:3:7: error: <path> takes no onclick here\n"
            "file:4:4: error: fill = \"url(x)\", must name nothing outside, but an id in the picture: url(#a)\n");
}

TEST(SafeMarkup, NeitherDepthNorSizeEndsTheProgram) {
  std::string deep = open_svg, many = open_svg;
  for (int i = 0; i < 60000; ++i) deep += "<g>";
  for (int i = 0; i < 10000; ++i) many += "<g/>";
  EXPECT_NE(errors_of(deep).find("nests deeper"), std::string::npos);
  EXPECT_NE(errors_of(many + "</svg>").find("more than 5000 elements"), std::string::npos);
}

TEST(SafeMarkup, AHeadHasTextsTablesPicturesAndWords) {
  Diagnostics diagnostics;
  const auto made = safe_markup(
      "<div class=\"row line\"><h1>{title}</h1>{logo}</div><hr>\n<p>a {b} &lt;{number}&gt; }{</p>"
      "<table><tr><td colspan=\"2\">x<br/>y</td></tr></table>" +
          open_svg + "<rect id=\"main\" width=\"1\" height=\"1\"/></svg>",
      "head.html", MarkupKind::head, diagnostics);
  ASSERT_FALSE(made.has_value());
  ASSERT_EQ(diagnostics.errors().size(), 1U);
  EXPECT_EQ(diagnostics.errors()[0].text(),
            "head.html:2:4: error: there is nothing for {b}, there are title, name, number, engineer, date, revision, "
            "code_basis, logo, file, version");
  Diagnostics none;
  const auto right =
      safe_markup("<p class=\"right\">{number} }{ {\n{logo}</p>" + open_svg + "<rect id=\"main\"/></svg>", "head.html",
                  MarkupKind::head, none);
  ASSERT_TRUE(right.has_value());
  EXPECT_EQ(*right,
            "<p class=\"head-right\">{number} &#125;&#123; &#123;\n{logo}</p><svg viewBox=\"0 0 10 10\"><rect "
            "id=\"head-main\"></rect></svg>");
  const std::string filled =
      filled_template(*right, [](const std::string& word) { return word == "number" ? "{logo}" : "L"; });
  EXPECT_EQ(filled.substr(0, 46), "<p class=\"head-right\">{logo} &#125;&#123; &#12") << "what stands in a value stays";
  EXPECT_NE(errors_of("<p onclick=\"x\" style=\"color:red\">{nmuber}</p><form/><a href=\"x\"/>", MarkupKind::head)
                .find("did you mean \"number\"?"),
            std::string::npos);
  EXPECT_NE(errors_of("<svg viewBox=\"0 0 1 1\"><p/></svg>", MarkupKind::head).find("takes no <p> here"),
            std::string::npos);
  EXPECT_NE(errors_of("<p class=\"wide\"/>", MarkupKind::head).find("must be of left"), std::string::npos);
}

/// Whatever pieces are put together: what is taken is harmless, and taken again it stays what it is.
TEST(SafeMarkup, WhatIsTakenOfAnythingIsHarmless) {
  const std::vector<std::string> pieces = {"<svg viewBox=\"0 0 1 1\">",
                                           "</svg>",
                                           "<g>",
                                           "</g>",
                                           "<path ",
                                           "fill=\"url(#a)\" ",
                                           "onload=\"x\" ",
                                           "/>",
                                           ">",
                                           "<script>",
                                           "</script>",
                                           "<x:script>",
                                           "</x:script>",
                                           "<!--",
                                           "-->",
                                           "style=\"fill:red\" ",
                                           "style='a:b' ",
                                           "\"",
                                           "'",
                                           "<text>",
                                           "</text>",
                                           "&lt;script&gt;",
                                           "&#60;",
                                           "{logo}",
                                           "{",
                                           "<p>",
                                           "</p>",
                                           "id=\"a\" ",
                                           "<br>",
                                           "a",
                                           "<title>",
                                           "</title>",
                                           "href=\"#a\" ",
                                           "<linearGradient xlink:href=\"#a\"/>",
                                           "<![CDATA[",
                                           "]]>",
                                           "\n",
                                           "<"};
  std::mt19937 random(20);
  int taken = 0;
  for (int round = 0; round < 4000; ++round) {
    const bool is_logo = round % 2 == 0;
    std::string text = is_logo ? open_svg : "<div>";
    for (std::size_t i = random() % 9; i > 0; --i) text += pieces[random() % pieces.size()];
    text += is_logo ? "</svg>" : "</div>";
    const MarkupKind kind = is_logo ? MarkupKind::logo : MarkupKind::head;
    Diagnostics diagnostics;
    const auto made = safe_markup(text, "", kind, diagnostics);
    ASSERT_EQ(made.has_value(), diagnostics.ok()) << text;
    if (!made) continue;
    ++taken;
    expect_harmless(filled_template(*made, [](const std::string&) { return "w"; }));
  }
  EXPECT_GT(taken, 300);
}

}  // namespace
}  // namespace bentur
