#include "bentur/report/figures/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "bentur/core/errors.h"
#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text_width.h"

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

/// A script without what stands between single quotes.
std::string unquoted(std::string script) {
  const std::string quote = R"('."\047".')";
  for (std::size_t at = 0; (at = script.find(quote)) != std::string::npos;) script.erase(at, quote.size());
  std::string text;
  bool inside = false;
  for (const char c : script) {
    EXPECT_FALSE(inside && c == '\n') << "a quote does not end";
    if (c == '\'') {
      inside = !inside;
    } else if (!inside) {
      text += c;
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
    for (std::string row; std::getline(data, row);) {
      EXPECT_TRUE(row.empty() || row[0] == '#' || row.find_first_not_of("0123456789.e+- ") == std::string::npos) << row;
    }
  }
}

TEST(FigureText, GnuplotShowsThemAndDoesNothingElse) {
  if (!gnuplot_version()) GTEST_SKIP() << "gnuplot is not installed";
  for (const char* text : nasty) {
    const std::string svg = draw(figure_text(simple(text), "'it's"), "'it's", "svg");
    EXPECT_EQ(svg.find("<script"), std::string::npos) << text;
    EXPECT_EQ(svg.find("]]>"), std::string::npos) << text;
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
  }
}

TEST(FigureText, SaysTheSameTwice) {
  const FigureText a = figure_text(simple("x"), "name");
  const FigureText b = figure_text(simple("x"), "name");
  EXPECT_EQ(a.script, b.script);
  EXPECT_EQ(a.data, b.data);
  if (!gnuplot_version()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(draw(a, "name", "svg"), draw(b, "name", "svg"));
}

TEST(FigureText, PdfAndPngToo) {
  if (!gnuplot_version()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(draw(figure_text(simple("x"), "name"), "name", "pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(draw(figure_text(simple("x"), "name"), "name", "png").substr(1, 3), "PNG");
}

TEST(FigureText, AJournalsColumn) {
  const std::string script = figure_text(simple("x"), "name").script;
  EXPECT_NE(script.find("pdfcairo size 8.8cm,"), std::string::npos);
  EXPECT_NE(script.find("svg name 'bentur_name' size 333,"), std::string::npos);  // 8.8 cm of 96 pixels an inch
}

TEST(FigureText, EmptyFramesAreRefused) {
  Figure figure = simple("x");
  for (Curve& curve : figure.panels[0].curves) {
    for (double& y : curve.y) y = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_THROW(static_cast<void>(figure_text(figure, "name")), InvalidParameter);
  figure.panels.clear();
  EXPECT_THROW(static_cast<void>(figure_text(figure, "name")), InvalidParameter);
  figure = simple("x");
  figure.panels[0].curves[0].y.pop_back();
  EXPECT_THROW(static_cast<void>(figure_text(figure, "name")), InvalidParameter);
  figure = simple("x");
  figure.panels[0].map = HeatMap{{0, 1}, {0, 1}, {1, 2}, "z"};
  EXPECT_THROW(static_cast<void>(figure_text(figure, "name")), InvalidParameter);
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
  EXPECT_NE(text.data.find(" 42\n"), std::string::npos);
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
