#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"
#include "bentur/report/story_text.h"
#include "tests/support/drawn_run.h"

namespace bentur {
namespace {

RunResults example_run(const std::string& name) {
  Diagnostics diagnostics;
  auto c = read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = 0.01;
  options.course = true;
  options.both_ways = true;
  Response response = solve(problem, c->analysis.solver, options);
  return run_results(std::move(*c), std::move(problem), std::move(response));
}

Figure overview(const RunResults& run, const std::string& language = "en", double width = page_width) {
  FigureOptions options;
  options.width = width;
  options.language = language;
  options.say = figure_words(language);
  return make_figure(run, "overview", options);
}

/// Where bars end, from the uppermost down.
std::vector<double> ends_of_bars(const Panel& panel) {
  std::vector<const Curve*> bars;
  for (const Curve& curve : panel.curves) bars.push_back(&curve);
  std::sort(bars.begin(), bars.end(), [](const Curve* a, const Curve* b) { return a->y[0] > b->y[0]; });
  std::vector<double> ends;
  for (const Curve* bar : bars) ends.push_back(bar->x[1]);
  return ends;
}

TEST(Overview, TellsWhatTheVerdictTellsFirst) {
  const RunResults run = example_run("linked-pair");
  for (const std::string language : {"en", "id"}) {
    const Figure figure = overview(run, language);
    EXPECT_EQ(figure.finding, said(run_story(run).statements, Words(language)).front().text);
    EXPECT_NE(figure_svg(figure).find("<desc>Tall"), std::string::npos);
  }
  EXPECT_NE(overview(run, "id").panels[0].title.find("benturan 4"), std::string::npos);
}

TEST(Overview, SaysItsGapsWithTheirUnits) {
  for (const char* const name : {"free-impact", "linked-pair"}) {  // of no motion, and the longest numbers
    const RunResults run = example_run(name);
    for (const std::string language : {"en", "id"}) {
      const Figure figure = overview(run, language, column_width);
      const Layout placing = layout(figure);
      ASSERT_EQ(placing.panels.back().y.labels.size(), name == std::string("free-impact") ? 2U : 3U);
      for (const auto& [at, text] : placing.panels.back().y.labels) {
        EXPECT_EQ(text.find("…"), std::string::npos) << name << ": " << text;
      }
    }
  }
}

/// A name may be cut, a number with its exponent and its unit never.
TEST(Overview, CutsNoNumberHoweverSmall) {
  RunResults run = example_run("linked-pair");
  for (ContactPoint& point : run.problem.points) point.width = 1.324e-8;
  for (PointSummary& point : run.response.points) point.gap_needed = point.gap_needed_reversed.emplace(2.9521e-10);
  for (const double width : {column_width, page_width}) {
    const Figure figure = overview(run, "en", width);
    const Layout placing = layout(figure);
    for (const auto& [at, text] : placing.panels.back().y.labels) {
      EXPECT_TRUE(text.ends_with("10⁻⁸ m") || text.ends_with("10⁻¹⁰ m")) << text;
      EXPECT_GT(placing.panels.back().left, text_width(text)) << text;
    }
  }
}

TEST(Overview, MarksTheHardestImpactWhereTheGapOpens) {
  const RunResults run = example_run("row-of-three");  // whose forces are largest where they are deepest
  const Impact& hardest = *std::max_element(run.response.impacts.begin(), run.response.impacts.end(),
                                            [](const Impact& a, const Impact& b) { return is_harder(b, a); });
  const Panel panel = overview(run).panels.at(1);
  const Curve& mark = panel.curves.back();
  ASSERT_EQ(mark.x.size(), 1U);
  EXPECT_NEAR(mark.x[0], hardest.peak_force_time, 1e-9);
  EXPECT_NEAR(mark.y[0], -hardest.peak_penetration, 1e-6 * hardest.peak_penetration);
  const auto closed = std::find_if(panel.curves.begin(), panel.curves.end(),
                                   [](const Curve& curve) { return curve.label == "closed at 0"; });
  ASSERT_NE(closed, panel.curves.end());
  EXPECT_EQ(closed->y, (std::vector<double>{0, 0}));
}

/// In a column what the lines of the opening are stands at their ends, that of the instant above all curves, and no
/// line of a legend above the frame, which is wider than that of the bars, whose names stand beside them.
TEST(Overview, NamesLinesWhereTheyEnd) {
  for (const char* const example : {"linked-pair", "hinged-frame", "m12-el-centro"}) {
    for (const char* const language : {"en", "id"}) {
      const Figure figure = overview(example_run(example), language, column_width);
      const Layout placing = layout(figure);
      const PlacedPanel &opening = placing.panels.at(1), &bars = placing.panels.at(2);
      EXPECT_TRUE(opening.legend.empty()) << example;
      EXPECT_EQ(opening.names.size(), 3U) << example;
      EXPECT_GT(opening.right - opening.left, 5) << example;
      EXPECT_LT(opening.left, bars.left) << example;
      EXPECT_GT(bars.right, opening.right) << example;
      double highest = -INFINITY;
      for (const Curve& curve : figure.panels[1].curves) {
        if (curve.tone == Tone::red) continue;
        for (const double y : curve.y) highest = std::max(highest, y);
      }
      const double above = (1 - along(opening.y, highest)) * (opening.top - opening.bottom);
      EXPECT_GT(above, 0.4) << example << ": room for a name [cm]";
    }
  }
}

TEST(Overview, BarsAreGivenAndNeeded) {
  const RunResults pair = example_run("linked-pair");
  const GoverningLevel level = governing_level(pair.problem, pair.response, 0);
  const Panel bars = overview(pair).panels.back();
  EXPECT_EQ(ends_of_bars(bars),
            (std::vector<double>{level.width, level.gap_needed, level.gap_needed_reversed.value()}));
  EXPECT_EQ(bars.y.names,
            (std::vector<std::string>{"reversed: 0.06682 m", "as recorded: 0.04946 m", "given: 0.03000 m"}));
  EXPECT_EQ(bars.title, "needed at level " + number(level.elevation) + " m");
  const RunResults row = example_run("row-of-three");
  std::vector<double> expected;
  std::vector<std::string> names;  // with the level of the need, for whose word there is no room; the last uppermost
  for (Eigen::Index gap = 0; gap < 2; ++gap) {
    const GoverningLevel one = governing_level(row.problem, row.response, gap);
    expected.insert(expected.end(), {one.width, one.gap_needed, one.gap_needed_reversed.value()});
    names.insert(names.begin(), gap_name(row.problem, gap) + ", " + number(one.elevation) + " m");
  }
  EXPECT_EQ(ends_of_bars(overview(row).panels.back()), expected);
  EXPECT_EQ(overview(row).panels.back().y.names, names);
  const Figure figure = overview(row);
  const Layout placing = layout(figure);
  std::vector<std::string> key;
  for (const LegendEntry& entry : placing.panels.back().legend) {
    key.push_back(entry.label);
    EXPECT_EQ(entry.outline, entry.label == "reversed");
  }
  EXPECT_EQ(key, (std::vector<std::string>{"given", "needed as recorded, gap too small", "reversed"}));
}

/// Each value has the name of its direction, whichever the run is of; a motion that is none has one.
TEST(Overview, BarsNameTheDirectionOfTheRecord) {
  RunResults pair = example_run("linked-pair");
  const std::vector<std::string> as_recorded = overview(pair).panels.back().y.names;
  for (PointSummary& point : pair.response.points) std::swap(point.gap_needed, *point.gap_needed_reversed);
  for (WatchedSummary& floor : pair.response.watched) std::swap(floor.gap_needed, *floor.gap_needed_reversed);
  pair.c.excitation.record.value().reversed = true;
  EXPECT_EQ(overview(pair).panels.back().y.names, as_recorded);
  std::vector<std::string> labels;  // of the table of levels, that of the run first
  for (const StoryColumn& column : gap_story(pair).tables.front().columns) {
    if (column.label == "column.recorded" || column.label == "column.reversed") labels.push_back(column.label);
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"column.reversed", "column.recorded"}));
  for (PointSummary& point : pair.response.points) point.gap_needed_reversed.reset();
  for (WatchedSummary& floor : pair.response.watched) floor.gap_needed_reversed.reset();
  pair.problem.motion = NoMotion{};
  pair.c.excitation = {};
  EXPECT_EQ(overview(pair).panels.back().y.names.size(), 2U);
}

/// Of the gap that is worst but not hit hardest, where its bars are of a level at which it is hit.
TEST(Overview, TheWorstGapOpensAtTheLevelOfItsBars) {
  RunResults row = example_run("row-of-three");
  ASSERT_EQ(overview(row).panels.size(), 4U);
  const std::vector<ContactPoint>& points = row.problem.points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    PointSummary& point = row.response.points[i];
    const bool is_below = points[i].gap == 1 && points[i + 1].gap == 1 && point.impacts > 0;
    if (!is_below) continue;
    const double before = std::exchange(point.gap_needed, 10.0);
    const std::string level = number(points[i].elevation) + " m";
    for (const std::string kind : {"overview", "opening", "displacement"}) {
      FigureOptions options;
      options.width = page_width;
      const std::vector<Panel> panels = make_figure(row, kind, options).panels;
      EXPECT_TRUE(std::any_of(panels.begin(), panels.end(), [&](const Panel& one) {
        return one.title.starts_with("Middle | East, level " + level);
      })) << kind;
    }
    EXPECT_TRUE(overview(row).panels.back().y.names.front().ends_with(level));
    const int impacts = std::exchange(point.impacts, 0);  // not there: where it is hit hardest
    EXPECT_EQ(overview(row).panels[2].title, "Middle | East, level " + number(points.back().elevation) + " m");
    point.impacts = impacts;
    point.gap_needed = before;
    return;
  }
  FAIL() << "no lower level is hit";
}

/// A free response that ended in a collapse tells nothing of what would have been needed.
TEST(Overview, HasNoBarFromAPartOfTheFacts) {
  RunResults pair = example_run("linked-pair");
  pair.response.collapse_no_contact = pair.response.reversed.value().collapse_no_contact = Collapse{};
  const Panel bars = overview(pair).panels.back();
  EXPECT_EQ(ends_of_bars(bars), std::vector<double>{0.03});
  EXPECT_EQ(bars.y.names[1], "as recorded: not known");
  EXPECT_EQ(bars.title, "");
}

TEST(Overview, TheLabelOfAnAxisStandsAtItsNumbers) {
  const RunResults run = example_run("linked-pair");
  for (const char* const language : {"en", "id"}) {
    const Figure figure = overview(run, language, column_width);
    const Layout placing = layout(figure);
    const PlacedPanel& opening = placing.panels[1];
    double numbers = 0;
    for (const auto& [at, text] : opening.y.labels) numbers = std::max(numbers, text_width(text));
    EXPECT_NEAR(opening.y_label_x, opening.left - 0.2 - numbers - 0.2, 1e-9);
    EXPECT_LT(opening.y_label_x, opening.cell_left + 1) << "whatever the bars below it are called";
  }
}

TEST(Overview, StandsBesideOnAPageAndBelowOneAnotherInAColumn) {
  const RunResults run = example_run("linked-pair");
  const Figure wide = overview(run), narrow = overview(run, "en", column_width);
  const Layout beside = layout(wide), below = layout(narrow);
  const auto& [scene, opening, bars] = std::tie(beside.panels[0], beside.panels[1], beside.panels[2]);
  EXPECT_LT(scene.right, opening.cell_left);
  EXPECT_EQ(scene.bottom, bars.bottom);
  EXPECT_LT(opening.left, bars.left);
  EXPECT_GT(opening.bottom, bars.top);
  EXPECT_GT(below.panels[0].bottom, below.panels[1].top);
  for (const Layout* one : {&beside, &below}) {  // lengths are alike both ways
    const PlacedPanel& placed = one->panels[0];
    EXPECT_NEAR((placed.x.to - placed.x.from) / (placed.right - placed.left),
                (placed.y.to - placed.y.from) / (placed.top - placed.bottom), 1e-12);
    EXPECT_LE(one->height, 2 * one->width);
  }
}

/// Of a linear contact without a dashpot force and penetration have one course, and both ways are one line: nothing is
/// drawn twice.
TEST(Impact, OfAnElasticContactDrawsNothingTwice) {
  RunResults run = example_run("row-of-three");
  run.figures = figure_data(run);
  ASSERT_TRUE(is_lossless(run));
  const Impact& hardest = run.response.impacts.at(run.figures.close_up->impact);
  for (const std::string kind : {"impact", "loop"}) {
    const Figure figure = make_figure(run, kind);
    ASSERT_EQ(figure.panels.size(), 1U) << kind;
    EXPECT_EQ(figure.lacks, kind == "impact" ? "penetration" : "") << "its caption names what is there";
    ASSERT_EQ(figure.panels.front().curves.size(), 1U) << kind;
    EXPECT_NE(figure.panels.front().curves.front().label.find(kind == "loop" ? "on one line" : "has this course too"),
              std::string::npos);
    ASSERT_EQ(figure.panels.front().texts.size(), 1U) << kind;
    EXPECT_EQ(figure.panels.front().texts.front().text,
              shown_value(run, hardest.peak_force, "F") + ", δ = " + shown_value(run, hardest.peak_penetration, "L"));
  }
  RunResults lossy = example_run("linked-pair");
  lossy.figures = figure_data(lossy);
  ASSERT_FALSE(is_lossless(lossy));
  EXPECT_EQ(make_figure(lossy, "impact").panels.size(), 2U);
  EXPECT_EQ(make_figure(lossy, "loop").panels.front().curves.size(), 2U);
}

/// The close-up of an impact is of the gap that is asked for, also where another one is hit harder.
TEST(Impact, IsOfTheGapThatIsAskedFor) {
  RunResults run = example_run("row-of-three");
  run.figures = figure_data(run);
  for (const std::size_t gap : {0, 1}) {
    const Impact* hardest = nullptr;
    for (const Impact& one : run.response.impacts) {
      if (run.problem.points[one.point].gap != static_cast<Eigen::Index>(gap)) continue;
      if (hardest == nullptr || one.peak_force > hardest->peak_force) hardest = &one;
    }
    ASSERT_NE(hardest, nullptr);
    FigureOptions options;
    options.gap = gap;
    const Figure figure = make_figure(run, "impact", options);
    const std::vector<double>& force = figure.panels.back().curves.front().y;
    EXPECT_NEAR(*std::max_element(force.begin(), force.end()), hardest->peak_force, 0.01 * hardest->peak_force) << gap;
    EXPECT_NE(figure.panels.front().title.find(gap_name(run.problem, static_cast<Eigen::Index>(gap))),
              std::string::npos);
  }
  RunResults read = run;  // results whose case is not at hand have one impact in close-up
  read.c.buildings.clear();
  FigureOptions other;
  other.gap = run.problem.points[run.response.impacts.at(run.figures.close_up->impact).point].gap == 0 ? 1 : 0;
  EXPECT_THROW((void)make_figure(read, "impact", other), NoFigure);
}

/// What strikes now has a mark that the legend names, and rays that reach no other level.
TEST(Scene, WhatStrikesNowIsNamedAndByItself) {
  const RunResults row = example_run("row-of-three");
  const Panel panel = make_figure(row, "scene").panels.front();
  const auto now = std::find_if(panel.curves.begin(), panel.curves.end(),
                                [](const Curve& one) { return one.label == "strikes now"; });
  ASSERT_NE(now, panel.curves.end());
  const auto rays = std::count_if(panel.curves.begin(), panel.curves.end(), [](const Curve& one) {
    return one.tone == Tone::red && one.mark == Mark::none && one.width == 1.6;
  });
  EXPECT_EQ(std::ssize(now->x), rays);
  const double storey = scene_of(row.problem, row.response).storey;
  for (const Curve& one : panel.curves) {
    if (one.tone != Tone::red || one.mark != Mark::none || one.width != 1.6) continue;
    double low = INFINITY, high = -low;
    for (const double y : one.y) {
      low = std::fmin(low, y);
      high = std::fmax(high, y);
    }
    EXPECT_LT(high - low, 1.15 * storey);
  }
}

/// Of many buildings each frame has room for numbers, by which its curve can be read.
TEST(Heights, OfTwelveBuildingsHaveFourNumbersEach) {
  std::string text = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.5, displacement_amplitude = 0.04 }
analysis = { duration = 2.0 }
)";
  for (int b = 1; b <= 12; ++b) {
    text += fmt::format(
        "[[building]]\nname = \"House {}\"\ndamping = 0.05\ngeneric = {{ storeys = 2, storey_height = 3.0, floor_mass "
        "= 100.0, period = {}, stiffness_ratio = 30.0 }}\n",
        b, 0.2 + 0.1 * (b * 5 % 7));
    if (b == 1) continue;
    text += fmt::format(
        "[[gap]]\nbetween = [\"House {}\", \"House {}\"]\nwidth = 0.02\ncontact = {{ law = \"linear\", stiffness = "
        "1e5 }}\n",
        b - 1, b);
  }
  const RunResults row = test::drawn_run(text);
  for (const char* const kind : {"amplification", "drift"}) {
    const Figure figure = make_figure(row, kind);
    const Layout placing = layout(figure);
    EXPECT_EQ(placing.panels.size(), 12U) << kind;
    for (const PlacedPanel& one : placing.panels) EXPECT_GE(one.x.labels.size(), 4U) << kind;
  }
}

/// Each line has the name of its building, of which none lies on another.
TEST(Spectrum, LinesOfFirstPeriodsHaveTheirNames) {
  SpectrumCurves curves;
  for (double period = 0.02; period < 6; period *= 1.05) {
    curves.periods.push_back(period);
    curves.acceleration.push_back(1 / (1 + period));
    curves.displacement.push_back(period);
  }
  for (std::size_t b = 0; b < 6; ++b) {
    curves.marks.push_back({"House " + std::to_string(b + 1), 0.5 + 0.1 * static_cast<double>(b), b});
  }
  const Figure figure = spectrum_figure(curves);
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.texts.size(), 6U);
    for (std::size_t i = 0; i < panel.texts.size(); ++i) {
      const PlaceText& one = panel.texts[i];
      EXPECT_EQ(one.text, std::to_string(i + 1));
      EXPECT_EQ(one.x, curves.marks[i].period);
      EXPECT_LT(one.y, *panel.y.to);
      EXPECT_GT(one.y, *std::max_element(panel.curves.front().y.begin(), panel.curves.front().y.end()));
      for (std::size_t k = 0; k < i; ++k) {
        const double apart = std::log(one.x / panel.texts[k].x) / std::log(*panel.x.to / *panel.x.from);
        EXPECT_TRUE(one.y != panel.texts[k].y || apart * (column_width - 1.8) > text_width(one.text)) << one.text;
      }
    }
    for (const Curve& curve : panel.curves) EXPECT_TRUE(curve.label.find("T₁") != 0 || !curve.in_legend);
  }
}

}  // namespace
}  // namespace bentur
