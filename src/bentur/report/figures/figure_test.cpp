#include "bentur/report/figures/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/files/picture.h"

namespace bentur {
namespace {

Curve line(const std::string& label, double slope) {
  Curve curve;
  curve.label = label;
  for (int i = 0; i <= 10; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(slope * i);
  }
  return curve;
}

Figure simple(const std::string& text) {
  Panel panel;
  panel.title = text;
  panel.x.label = text;
  panel.y.label = text;
  panel.curves = {line(text, 1), line("other", 2)};
  panel.rules = {{.at = 3, .vertical = true, .label = text}};
  panel.events = {text, {1, 2}};
  Figure figure;
  figure.title = text;
  figure.panels = {panel};
  return figure;
}

TEST(FigureSvg, RaisedAndLoweredDigitsAreCommonOnesThatEveryFontHas) {
  const std::string svg = figure_svg(simple("T₁ of A, 2 × 10⁻⁶ m²"));
  const std::string begin = svg.substr(svg.find("<text"));
  for (const char* const letter : {"₁", "⁻", "⁶", "²"}) EXPECT_EQ(begin.find(letter), std::string::npos) << letter;
  // A space at an end of a span is dropped by a renderer.
  EXPECT_NE(begin.find(">T<tspan dy=\"1.71\" font-size=\"6.93\">1</tspan> <tspan dy=\"-1.71\">of A, 2 × 10</tspan>"),
            std::string::npos)
      << begin.substr(0, 400);
  EXPECT_NE(
      begin.find(">−6</tspan> <tspan dy=\"3.52\">m</tspan><tspan dy=\"-3.52\" font-size=\"6.93\">2</tspan></text>"),
      std::string::npos);
  EXPECT_NEAR(text_width("m²"), text_width("m") + small_size * text_width("2"), 1e-12);
}

/// A script without what stands between double quotes.
std::string unquoted(const std::string& script) {
  std::string text;
  bool inside = false;
  for (std::size_t i = 0; i < script.size(); ++i) {
    EXPECT_FALSE(inside && script[i] == '\n') << "a quote does not end";
    if (script[i] == '"') {
      inside = !inside;
    } else if (inside && script[i] == '\\') {
      ++i;
    } else if (!inside) {
      text += script[i];
    }
  }
  return text;
}

const char* const nasty[] = {"<script>alert(1)</script>",
                             "\"; system('touch pwned') #",
                             "'; system('touch pwned') #",
                             "''; system(''touch pwned'') #",
                             "'.system('touch pwned').'",
                             "`touch pwned`",
                             "$(touch pwned)",
                             "a\n!touch pwned\nb",
                             "@touch ^a _b {/Bold pwned} \\042 %s",
                             "]]></text><script>pwned</script>",
                             "&#60;script&#62;pwned &amp; &lt;"};

TEST(FigureText, TextsStandBetweenQuotesOnly) {
  for (const char* text : nasty) {
    const std::string outside = unquoted(figure_text(simple(text), text).script);
    for (const char* word : {"pwned", "touch", "system", "script>", "`", "$", "@"}) {
      EXPECT_EQ(outside.find(word), std::string::npos) << text << " " << word;
    }
    std::istringstream data(figure_text(simple(text), "name").data);
    std::string row;
    std::getline(data, row);  // the headings, in one line
    EXPECT_EQ(std::count(row.begin(), row.end(), '"') % 2, 0) << row;
    while (std::getline(data, row)) EXPECT_EQ(row.find_first_not_of("0123456789.e+-,"), std::string::npos) << row;
  }
}

/// The numbers of an attribute, wherever it stands: of "x" those in ` x="12.3"`.
std::vector<double> numbers(const std::string& svg, const std::string& attribute) {
  std::vector<double> list;
  const std::string opening = " " + attribute + "=\"";
  for (std::size_t at = svg.find(opening); at != std::string::npos; at = svg.find(opening, at + 1)) {
    list.push_back(std::stod(svg.substr(at + opening.size())));
  }
  return list;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(FigureSvg, ShowsTextsAsTheyAre) {
  const std::string plain = figure_svg(simple("x"));
  for (const char* text : nasty) {
    const std::string svg = figure_svg(simple(text));
    EXPECT_EQ(count(svg, "<"), count(plain, "<")) << text << ": no tag more";
    EXPECT_EQ(count(svg, "<script"), 0U) << text;
    EXPECT_EQ(count(svg, "]]>"), 0U) << text;
    const std::string element = figure_element(simple("x"), text);
    EXPECT_EQ(count(element, "<"), count(figure_element(simple("x"), "x"), "<")) << text;
    EXPECT_EQ(count(element, "\""), count(figure_element(simple("x"), "x"), "\"")) << text;
  }
}

TEST(FigureSvg, SaysTheSameTwice) {
  EXPECT_EQ(figure_svg(simple("x")), figure_svg(simple("x")));
  const FigureText a = figure_text(simple("x"), "name"), b = figure_text(simple("x"), "name");
  EXPECT_EQ(a.script, b.script);
  EXPECT_EQ(a.data, b.data);
}

TEST(FigureSvg, IsAJournalsColumn) {
  EXPECT_EQ(numbers(figure_svg(simple("x")), "width").front(), 332.6);  // 8.8 cm of 96 pixels an inch
}

TEST(FigureSvg, PointsStandWhereTheirValuesAre) {
  Figure figure = simple("x");
  Panel& panel = figure.panels[0];
  panel.rules.clear();
  panel.events = {};
  panel.x.from = panel.y.from = 0;
  panel.x.to = 10, panel.y.to = 20;
  panel.curves = {{.x = {0, 5, 7, 10, 12}, .y = {0, 20, NAN, 10, 10}, .mark = Mark::disc}};
  const std::string svg = figure_svg(figure);
  const PlacedPanel placed = layout(figure).panels[0];
  const double width = (placed.right - placed.left) / 2.54 * 96, height = (placed.top - placed.bottom) / 2.54 * 96;
  const std::string path = svg.substr(svg.find("<path d=\"M0 ") + 9);
  double x[4] = {}, y[4] = {};
  ASSERT_EQ(std::sscanf(path.c_str(), "M%lf %lfL%lf %lfM%lf %lfL%lf %lf\"", &x[0], &y[0], &x[1], &y[1], &x[2], &y[2],
                        &x[3], &y[3]),
            8)
      << path.substr(0, 80);
  const double at[4] = {0, 5, 10, 12}, up[4] = {0, 20, 10, 10};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(x[i], at[i] / 10 * width, 0.006) << i;
    EXPECT_NEAR(y[i], (1 - up[i] / 20) * height, 0.006) << i;
  }
  EXPECT_EQ(count(svg, "<circle"), 3U) << "not where there is no value, and not outside of the frame";
}

TEST(FigureSvg, TextsStandBesideTheirPlaces) {
  Figure figure = simple("x");
  Panel& panel = figure.panels[0];
  panel.rules.clear();
  panel.events = {};
  panel.x.from = panel.y.from = 0;
  panel.x.to = panel.y.to = 10;
  panel.curves = {{.x = {5}, .y = {5}, .line = Line::none, .mark = Mark::disc, .mark_size = 2}};
  using Side = PlaceText::Side;
  panel.texts = {{5, 5, "east", Side::right}, {5, 5, "west", Side::left}, {5, 5, "north", Side::above}};
  panel.texts.push_back({.x = 5, .y = 5, .text = "south", .side = Side::below});
  panel.texts.push_back({.x = 11, .y = 5, .text = "beyond"});
  panel.texts.push_back({.x = 0, .y = 8, .text = "a peak at the edge", .side = Side::above});
  const std::string svg = figure_svg(figure);
  EXPECT_EQ(count(svg, "r=\"3.2\" class=\"fill-ink stroke-paper\""), 1U) << "twice as large";
  const auto place = [&](const std::string& text) {
    const std::string tag = svg.substr(svg.rfind("<text", svg.find(">" + text + "<")));
    double x = 0, y = 0;
    EXPECT_EQ(std::sscanf(tag.c_str(), "<text x=\"%lf\" y=\"%lf\"", &x, &y), 2) << text;
    return std::pair(x, y);
  };
  EXPECT_GT(place("east").first, place("north").first + 3.2);
  EXPECT_LT(place("west").first, place("north").first - 3.2);
  EXPECT_LT(place("north").second, place("east").second - 6);
  EXPECT_GT(place("south").second, place("east").second + 6);
  EXPECT_EQ(count(svg, "beyond"), 0U);
  const double half = text_width("a peak at the edge") / 2 * 96 / 2.54, left = placed_figure(figure, "").panels[0].left;
  EXPECT_GE(place("a peak at the edge").first - half, left) << "numbers stand beside the frame";
  EXPECT_NE(figure_text(figure, "x").script.find("[5.0,5.0,\"north\",0,1,"), std::string::npos);
}

TEST(FigureSvg, AreasAndMapsAreFilledAndCutOff) {
  Figure figure;
  Panel panel;
  panel.curves = {{.x = {0, 1, 2}, .y = {0, 1, 0}, .top = {1, 2, 1}, .tone = Tone::pale_blue}};
  figure.panels = {panel};
  EXPECT_EQ(count(figure_svg(figure), "Z\" class=\"fill-pale-blue\""), 1U);
  panel.curves.clear();
  panel.map = HeatMap{{0, 1, 2}, {0, 1, 2}, {0, 1, 2, std::numeric_limits<double>::quiet_NaN()}, "z [m]"};
  figure.panels = {panel};
  const std::string svg = figure_svg(figure);
  EXPECT_EQ(count(svg, "#ffffe0"), 2U) << "the cell of the scale's begin, and that begin";
  EXPECT_EQ(count(svg, "crispEdges"), 3U + 65U) << "three cells, and the scale";
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
}

/// A line that would be a block is a band between its lowest and its highest values, in the script as in the picture.
TEST(FigureSvg, ALineThatFillsTheFrameIsABand) {
  const auto vibrations = [](double count) {
    constexpr int samples = 20000;
    Curve curve{.label = "x", .tone = Tone::blue};
    for (int i = 0; i <= samples; ++i) {
      curve.x.push_back(0.001 * i);
      curve.y.push_back(std::sin(6.283 * count * i / samples) * (i < samples / 2 ? 1 : 2));
    }
    return Figure{.panels = {{.curves = {curve}}}};
  };
  const Figure lines = vibrations(100), block = vibrations(1000);
  EXPECT_FALSE(has_bands(lines));
  ASSERT_TRUE(has_bands(block));
  const std::string band = "class=\"fill-blue stroke-blue\"";
  EXPECT_EQ(count(figure_svg(lines), band), 0U);
  EXPECT_EQ(count(figure_svg(block), band), 1U);
  EXPECT_NE(figure_text(lines, "name").script.find("\"band\":0"), std::string::npos);
  const FigureText text = figure_text(block, "name");
  EXPECT_NE(text.script.find("\"band\":0.3"), std::string::npos);
  EXPECT_LT(count(text.data, "\n"), 130U) << "the edges alone";
}

/// Ten buildings have ten colours, none of which is that of anything else.
TEST(FigureSvg, ColoursOfTenBuildingsDiffer) {
  std::set<std::string> found = {colour(Tone::black).paper, colour(Tone::grey).paper, colour(Tone::red).paper,
                                 colour(Tone::teal).paper, colour(Tone::amber).paper};
  const std::size_t others = found.size();
  for (std::size_t b = 0; b < 10; ++b) found.insert(colour(building_tone(b)).paper);
  EXPECT_EQ(found.size(), others + 10);
  const std::vector<std::string> listed = building_colours();
  for (std::size_t b = 0; b < listed.size(); ++b) EXPECT_EQ(listed[b], colour(building_tone(b)).paper);
}

/// A drawing that stands alone says in itself what of many things it shows; in a page the caption does.
TEST(FigureSvg, ADrawingSaysWhatItShowsOfAll) {
  Figure figure{.panels = {{.curves = {{.x = {0, 1}, .y = {0, 1}}}}}};
  const std::string whole = figure_svg(figure);
  figure.part = "Shown are 7 of 12 buildings: those of the hardest impact, those that the verdict names";
  const std::string svg = figure_svg(figure);
  EXPECT_NE(svg.find(">Shown are 7 of 12 buildings: those of the hardest"), std::string::npos);
  const auto height = [](const std::string& of) { return std::stod(of.substr(of.find(" height=\"") + 9)); };
  EXPECT_NEAR(height(svg) - height(whole), (0.1 + 2 * line_height) * 96 / 2.54, 0.1) << "two lines below it";
  EXPECT_EQ(figure_element(figure, "Drift").find("Shown are"), std::string::npos);
  EXPECT_NE(figure_text(figure, "drift").script.find("Shown are 7 of 12 buildings"), std::string::npos);
}

TEST(FigureSvg, APanelAcrossColumnsIsAsBroadAsTheyAre) {
  const Panel panel{.x = {.label = "x"}, .y = {.label = "y"}, .curves = {{.x = {0, 1}, .y = {0, 1}}}};
  Figure figure{.panels = {panel, panel, panel}, .columns = 2, .width = 17};
  figure.panels[0].across = 2;
  const std::vector<PanelPlace> placed = placed_figure(figure, "").panels;
  EXPECT_DOUBLE_EQ(placed[0].left, placed[1].left);
  EXPECT_DOUBLE_EQ(placed[0].left + placed[0].width, placed[2].left + placed[2].width);
  EXPECT_DOUBLE_EQ(placed[1].top, placed[2].top) << "the others stand below it, side by side";
  EXPECT_GT(placed[1].top, placed[0].top + placed[0].height);
}

TEST(FigureSvg, LinesAreSeenOnPaperAndOnADarkScreen) {
  for (const Tone tone :
       {Tone::black, Tone::blue, Tone::orange, Tone::grey, Tone::green, Tone::purple, Tone::red, Tone::teal,
        Tone::magenta, Tone::olive, Tone::amber, Tone::indigo, Tone::brown, Tone::cyan, Tone::navy}) {
    const Colour& one = colour(tone);
    EXPECT_GE(contrast(one.paper, paper.paper), 4.5) << one.name;
    EXPECT_GE(contrast(one.dark, paper.dark), 4.5) << one.name;
    EXPECT_NE(figure_style().find(std::string("--") + one.name + ":" + one.dark), std::string::npos);
  }
}

/// Every letter of a page has 4.5 to every ground on which letters stand, every edge of what can be pressed 3 to the
/// page.
TEST(PageStyle, LettersAndEdgesAreSeenOnEveryGround) {
  std::map<std::string, Colour> named = {{"ink", colour(Tone::black)},
                                         {"grey", colour(Tone::grey)},
                                         {"red", colour(Tone::red)},
                                         {"amber", colour(Tone::amber)},
                                         {"paper", paper}};
  for (const Colour& one : page_colours) {
    named[one.name] = one;
    EXPECT_NE(page_style().find(std::string("--") + one.name + ":" + one.paper), std::string::npos);
    EXPECT_NE(page_style().find(std::string("--") + one.name + ":" + one.dark), std::string::npos);
    EXPECT_EQ(figure_style().find(std::string("--") + one.name + ":"), std::string::npos);
  }
  const auto expect = [&](const char* one, const char* ground, double least) {
    EXPECT_GE(contrast(named.at(one).paper, named.at(ground).paper), least) << one << " on " << ground;
    EXPECT_GE(contrast(named.at(one).dark, named.at(ground).dark), least) << one << " on " << ground << ", dark";
  };
  for (const char* const letters : {"ink", "grey", "red", "amber", "link", "clear"}) {
    for (const char* const ground : {"paper", "band", "stage", "mark"}) expect(letters, ground, 4.5);
  }
  for (const char* const ground : {"paper", "band", "stage"}) expect("edge", ground, 3);
}

TEST(Picture, PdfAndPngToo) {
  EXPECT_EQ(draw(simple("x"), "svg"), figure_svg(simple("x")));
  if (!can_draw("pdf")) GTEST_SKIP() << "rsvg-convert is not installed";
  EXPECT_EQ(draw(simple("x"), "pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(draw(simple("x"), "png").substr(1, 3), "PNG");
}

TEST(FigureSvg, TheFindingIsTheDescription) {
  Figure figure = simple("x");
  EXPECT_EQ(figure_svg(figure).find("<desc>"), std::string::npos);
  EXPECT_NE(figure_element(figure, "Force").find("aria-label=\"Force\""), std::string::npos);
  figure.finding = "peak < 5 kN at 3.57 s";
  EXPECT_NE(figure_svg(figure).find("<desc>peak &lt; 5 kN at 3.57 s</desc>"), std::string::npos);
  EXPECT_NE(figure_element(figure, "Force").find("aria-label=\"Force: peak &lt; 5 kN at 3.57 s\""), std::string::npos);
}

TEST(FigureSvg, RefusesEmptyFrames) {
  Figure figure = simple("x");
  for (Curve& curve : figure.panels[0].curves) {
    for (double& y : curve.y) y = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_THROW(static_cast<void>(figure_svg(figure)), InvalidParameter);
  figure.panels.clear();
  EXPECT_THROW(static_cast<void>(figure_svg(figure)), InvalidParameter);
  figure = simple("x");
  figure.panels[0].curves[0].y.pop_back();
  EXPECT_THROW(static_cast<void>(figure_svg(figure)), InvalidParameter);
  figure = simple("x");
  figure.panels[0].map = HeatMap{{0, 1}, {0, 1}, {1, 2}, "z"};
  EXPECT_THROW(static_cast<void>(figure_svg(figure)), InvalidParameter);
}

TEST(FigureText, LargeMapsAreMergedAndKeepTheLargest) {
  Panel panel;
  HeatMap map;
  for (int i = 0; i <= 500; ++i) map.x_edges.push_back(i);
  for (int j = 0; j <= 300; ++j) map.y_edges.push_back(j);
  map.values.assign(150000, 1.0);
  map.values[77777] = 42;
  panel.map = map;
  Figure figure;
  figure.panels = {panel};
  const FigureText text = figure_text(figure, "map");
  EXPECT_LT(text.data.size(), 1000000U);
  EXPECT_NE(text.data.find(",42\n"), std::string::npos);
}

/// Boxes of text of a panel's legend: lower and upper end in x and y.
struct Box {
  double left, right, bottom, top;
};

TEST(Layout, LegendsLieAboveTheFramesAndNotOnOneAnother) {
  for (const std::size_t length : {3U, 12U, 30U, 90U}) {
    for (int columns = 1; columns <= 3; ++columns) {
      for (const bool shared : {false, true}) {
        Figure figure;
        figure.columns = columns;
        figure.shared_legend = shared;
        for (int p = 0; p < 4; ++p) {
          Panel panel;
          panel.title = "panel";
          panel.x.label = "x [m]";
          panel.y.label = "y [m]";
          for (int c = 0; c < 5; ++c) panel.curves.push_back(line(std::string(length, 'n'), c + 1));
          figure.panels.push_back(panel);
        }
        const Layout result = layout(figure);
        std::vector<Box> boxes;
        for (const PlacedPanel& placed : result.panels) {
          EXPECT_GT(placed.right - placed.left, 0.9);
          EXPECT_LE(placed.right, result.width);
          EXPECT_GT(placed.bottom, 0.5);
          for (const LegendEntry& entry : placed.legend) {
            const double right = entry.x + sample_width + 0.1 + text_width(entry.label);
            boxes.push_back({entry.x, right, entry.y - line_height / 2, entry.y + line_height / 2});
            EXPECT_GE(entry.y - line_height / 2, placed.top - 1e-9);
            EXPECT_LE(right, result.width + 0.3);
            EXPECT_LE(entry.y + line_height / 2, result.height);
          }
        }
        EXPECT_FALSE(boxes.empty());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            const bool apart = boxes[i].right <= boxes[j].left || boxes[j].right <= boxes[i].left ||
                               boxes[i].top <= boxes[j].bottom + 1e-9 || boxes[j].top <= boxes[i].bottom + 1e-9;
            EXPECT_TRUE(apart) << length << " " << columns << " " << i << " " << j;
          }
        }
      }
    }
  }
}

/// Where columns as wide as the longest entry would take lines more.
TEST(Layout, EntriesOfUnlikeLengthsStandBehindOneAnother) {
  Panel panel{.x = {.label = "x"}, .y = {.label = "y"}};
  for (const char* const label : {"an entry that takes most of the width", "second", "third", "fourth", "fifth"}) {
    panel.curves.push_back(line(label, 1));
  }
  const Layout placed = layout({.panels = {panel}});
  const std::vector<LegendEntry>& entries = placed.panels.front().legend;
  ASSERT_EQ(entries.size(), 5U);
  std::set<double> lines;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    lines.insert(entries[i].y);
    EXPECT_LE(entries[i].x + sample_width + beside_sample + text_width(entries[i].label), placed.width);
    if (i == 0 || entries[i].y != entries[i - 1].y) continue;
    EXPECT_GT(entries[i].x, entries[i - 1].x + sample_width + beside_sample + text_width(entries[i - 1].label));
  }
  EXPECT_EQ(lines.size(), 2U);
}

TEST(Layout, AUnitStaysWithItsNumber) {
  for (double width = 2; width < 8.8; width += 0.1) {
    Figure figure = simple("Old frame | New frame, level 10 m");
    figure.width = width;
    figure.panels[0].x.label = "Storey shear, ratio [m]";
    const Layout placing = layout(figure);
    for (const auto& lines : {placing.panels[0].title, placing.panels[0].x_label}) {
      for (const std::string& line : lines) EXPECT_TRUE(line != "m" && line != "[m]") << width;
    }
  }
}

/// Of four side by side one has the label for all: below the middle of the row, in one line, though it is broader than
/// a panel. Of axes that differ each has its own below it.
TEST(Layout, ALabelForAllOfARowStandsBelowItsMiddle) {
  Figure figure;
  figure.columns = 4;
  figure.width = page_width;
  for (int i = 0; i < 4; ++i) figure.panels.push_back(simple("").panels.front());
  for (Panel& panel : figure.panels) panel.x.label = "";
  figure.panels[2].x.label = "Amplification of the largest displacement by contact [-]";
  Layout placing = layout(figure);
  EXPECT_NEAR(placing.panels[2].x_label_x, (placing.panels.front().left + placing.panels.back().right) / 2, 1e-9);
  EXPECT_EQ(placing.panels[2].x_label.size(), 1U);
  figure.panels[0].x.label = figure.panels[2].x.label = "Time [s]";
  placing = layout(figure);
  for (const int i : {0, 2}) {
    EXPECT_NEAR(placing.panels[i].x_label_x, (placing.panels[i].left + placing.panels[i].right) / 2, 1e-9) << i;
  }
}

TEST(Layout, NumbersOfAnAxisDoNotTouch) {
  for (double high = 0.00011; high < 1e8; high *= 2.3) {
    Panel panel;
    panel.curves = {line("a", 1)};
    for (double& x : panel.curves[0].x) x *= high / 10;
    Figure figure;
    figure.columns = 3;
    figure.panels = {panel, panel, panel};
    for (const PlacedPanel& placed : layout(figure).panels) {
      for (std::size_t i = 1; i < placed.x.labels.size(); ++i) {
        const double apart = (placed.x.labels[i].first - placed.x.labels[i - 1].first) / (placed.x.to - placed.x.from) *
                             (placed.right - placed.left);
        EXPECT_GT(apart, (text_width(placed.x.labels[i].second) + text_width(placed.x.labels[i - 1].second)) / 2)
            << high;
      }
    }
  }
}

}  // namespace
}  // namespace bentur
