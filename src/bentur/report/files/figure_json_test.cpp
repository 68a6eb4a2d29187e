#include "bentur/report/files/figure_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bentur {
namespace {

std::string errors_of(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(figure_from_json(text, "f.json", diagnostics));
  std::string all;
  for (const Diagnostic& one : diagnostics.errors()) all += one.text() + "\n";
  return all;
}

TEST(FigureJson, ReadsEveryMember) {
  Diagnostics diagnostics;
  const std::optional<Figure> figure = figure_from_json(R"({
    "title": "t", "finding": "f", "columns": 2, "shares": [1, 2], "width": 17, "shared_legend": true,
    "panels": [
      {"title": "p", "height": 3, "rows": 2, "across": 2, "note": "n", "to_scale": true,
       "x": {"label": "x [m]", "from": 0, "to": 2.5, "places": [0, 1], "numbers": false, "least": [0, 1]},
       "y": {"label": "y [m]", "logarithmic": true, "names": ["a", "b"], "number": "record"},
       "curves": [{"label": "c", "x": [0, 1, 2], "y": [1, null, 3], "top": [2, 3, 4], "tone": "bark",
                   "line": "dash-dot-dot", "mark": "cross", "legend_mark": "disc", "width": 1.5, "complete": true,
                   "mark_size": 2.5}],
       "rules": [{"at": 1, "vertical": true, "label": "r", "tone": "red", "line": "dotted"}],
       "texts": [{"x": 1, "y": 2, "text": "w", "side": "above", "tone": "grey"}],
       "events": {"label": "e", "x": [0.5]}},
      {"map": {"x_edges": [0, 1], "y_edges": [0, 1], "values": [2], "label": "m", "ratio": true, "range": [1, 2]}}]})",
                                                        "f.json", diagnostics);
  ASSERT_TRUE(figure && diagnostics.ok());
  EXPECT_EQ(figure->columns, 2);
  EXPECT_EQ(figure->shares, (std::vector<double>{1, 2}));
  EXPECT_TRUE(figure->shared_legend);
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.rows, 2);
  EXPECT_EQ(panel.across, 2);
  EXPECT_TRUE(panel.to_scale);
  EXPECT_EQ(panel.x.to, 2.5);
  EXPECT_FALSE(panel.x.numbers);
  EXPECT_EQ(panel.y.names, (std::vector<std::string>{"a", "b"}));
  const Curve& curve = panel.curves.at(0);
  EXPECT_TRUE(std::isnan(curve.y[1]));
  EXPECT_EQ(curve.tone, Tone::bark);
  EXPECT_EQ(curve.line, Line::dash_dot_dot);
  EXPECT_EQ(curve.mark, Mark::cross);
  EXPECT_EQ(curve.legend_mark, Mark::disc);
  EXPECT_EQ(curve.mark_size, 2.5);
  EXPECT_EQ(panel.texts.at(0).side, PlaceText::Side::above);
  EXPECT_EQ(panel.texts.at(0).text, "w");
  EXPECT_EQ(panel.texts.at(0).tone, Tone::grey);
  EXPECT_EQ(panel.rules.at(0).tone, Tone::red);
  EXPECT_EQ(panel.events.x, std::vector<double>{0.5});
  ASSERT_TRUE(figure->panels.at(1).map);
  EXPECT_EQ(figure->panels.at(1).map->range, std::make_pair(1.0, 2.0));
}

TEST(FigureJson, TellsAllMistakesAtOnce) {
  const std::string errors = errors_of(R"({"panles": [], "width": 0, "columns": 1.5, "panels": [
    {"curves": [{"x": [1, "2"], "y": 3, "tone": "gray", "line": 2}], "x": {"from": 2, "to": 1},
     "y": {"logarithmic": true, "from": 0}, "map": [], "to_scale": 1, "rows": 0}]})");
  for (const char* text :
       {"f.json: error: panles is not a known key, did you mean \"panels\"?", "width = 0, must be in [2, 100]",
        "columns = 1.5, must be a whole number", "panels[0].curves[0].x[1] = \"2\", must be a number",
        "panels[0].curves[0].y = 3, must be a list of numbers",
        "panels[0].curves[0].tone = \"gray\", did you mean \"grey\"?",
        "panels[0].curves[0].line = 2, must be one of none, solid, dashed, dotted, dash-dot",
        "panels[0].x.to = 1, must be greater than from", "panels[0].y is logarithmic, and so must end above zero",
        "panels[0].map is a list, must be a table of keys", "panels[0].to_scale = 1, must be true or false",
        "panels[0].rows = 0, must be 1 or more"}) {
    EXPECT_NE(errors.find(text), std::string::npos) << text << "\n" << errors;
  }
}

TEST(FigureJson, NumbersAreSuchThatAnAxisHasALength) {
  const auto figure = [](const std::string& size) {
    return R"({"panels": [{"curves": [{"x": [0, 1], "y": [)" + size + ", -" + size + "]}]}]}";
  };
  const std::string errors = errors_of(figure("1e308"));
  EXPECT_NE(errors.find("panels[0].curves[0].y[1] = -1e+308, must be in [-1e300, 1e300]"), std::string::npos) << errors;
  Diagnostics diagnostics;
  const auto largest = figure_from_json(figure("1e300"), "f.json", diagnostics);
  ASSERT_TRUE(largest);
  const std::string svg = figure_svg(*largest);
  for (const char* const number : {">−1.0<", ">0<", ">1.0<", ">[10<", ">300</tspan>"})
    EXPECT_NE(svg.find(number), std::string::npos) << number;
}

TEST(FigureJson, TextThatIsNoJsonIsRefusedWithItsPlace) {
  EXPECT_EQ(errors_of("{\"panels\": [}"), "f.json:1:13: error: is not JSON from here on\n");
  EXPECT_EQ(errors_of("{\n \"panels\":\n  ]}"), "f.json:3:3: error: is not JSON from here on\n");
  EXPECT_EQ(errors_of(""), "f.json:1:1: error: is not JSON from here on\n");
  EXPECT_NE(errors_of("[]").find("must be a table of keys"), std::string::npos);
  EXPECT_NE(errors_of(std::string(100000, '[')).find("error"), std::string::npos);
}

}  // namespace
}  // namespace bentur
