// A block from above by what is judged of its gaps, and courts in pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/html/plan/plan_animation.h"
#include "bentur/report/html/plan/plan_report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// Two rows of houses, of which the second has a court and the third is an L; the last stands far from the others.
std::string block() {
  std::string text = R"(
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.1
contact = { law = "linear", stiffness = 4e5 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.02
[excitation.y]
kind = "harmonic"
period = 0.4
displacement_amplitude = 0.01
[analysis]
duration = 2.0
)";
  for (int n = 0; n < 9; ++n) {
    const double left = n == 8 ? 100 : 10.02 * (n % 4), low = n < 4 || n == 8 ? 0 : 12.03;
    const char* const outline = n == 1   ? "polygon = [[0, 0], [10, 0], [10, 12], [0, 12]]\n"
                                           "court = [{ polygon = [[3, 3], [7, 3], [7, 9], [3, 9]] }]"
                                : n == 2 ? "polygon = [[0, 0], [10, 0], [10, 5], [5, 5], [5, 12], [0, 12]]"
                                         : "size = [10.0, 12.0]";
    text += fmt::format(
        "[[building]]\nname = \"H{}\"\ndamping = 0.05\n[building.plan]\ncorner = [{}, {}]\n{}\n"
        "storey_heights = [3.0]\nmasses = [100.0]\n",
        n + 1, left, low, outline);
    for (const char* const along : {"along = \"x\"\nat = 1.0", "along = \"x\"\nat = 4.0", "along = \"y\"\nat = 1.0"}) {
      text += fmt::format("[[building.plane]]\n{}\nstiffnesses = [{}]\n", along, 10000 + 4000 * (n * 5 % 9));
    }
  }
  return text;
}

const PlanRun& run() {
  static const PlanRun made = test::plan_run(block());
  return made;
}

long curves_of(const Figure& figure, const std::string& label) {
  const std::vector<Curve>& curves = figure.panels.front().curves;
  return std::count_if(curves.begin(), curves.end(), [&](const Curve& one) { return one.label == label; });
}

TEST(PlanMap, HasTheColourOfTheWorstThatIsJudged) {
  const Figure figure = make_figure(run(), "map");
  const std::vector<JudgedGap> judged = judged_gaps(run());
  ASSERT_GT(judged.size(), 10U);
  std::set<Sufficiency> all;
  for (std::size_t g = 0; g < judged.size(); ++g) {
    const std::string name = gap_name(run().problem, run().problem.gaps[g]);
    ASSERT_EQ(curves_of(figure, name), 1) << name;
    for (const Curve& curve : figure.panels.front().curves) {
      if (curve.label != name) continue;
      const Sufficiency value = judged[g].judgement.value;
      all.insert(value);
      EXPECT_EQ(curve.tone, value == Sufficiency::too_small ? Tone::red
                            : value == Sufficiency::unknown ? Tone::amber
                                                            : Tone::teal);
    }
  }
  EXPECT_GT(all.size(), 1U);
  long named = 0;
  for (const Curve& curve : figure.panels.front().curves) named += curve.in_legend ? 1 : 0;
  EXPECT_EQ(named, std::ssize(all) + 2) << "and what numbers and discs are";
  for (const Curve& curve : figure.panels.front().curves) {
    if (curve.label == "H9") {
      EXPECT_EQ(curve.tone, Tone::grey);
    } else if (curve.label == "H1") {
      EXPECT_EQ(curve.tone, Tone::red);
    }
  }
  EXPECT_FALSE(figure.finding.empty());
}

TEST(PlanMap, HasTheNumbersOfTheTable) {
  const Story story = run_story(run());
  const auto table = std::find_if(story.tables.begin(), story.tables.end(),
                                  [](const StoryTable& one) { return one.kind == "row_worst"; });
  ASSERT_NE(table, story.tables.end());
  const std::vector<std::string>& names = table->columns.front().texts;
  ASSERT_EQ(names.size(), 10U);
  const Panel panel = make_figure(run(), "map").panels.front();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto text = std::find_if(panel.texts.begin(), panel.texts.end(),
                                   [&](const PlaceText& one) { return one.text == std::to_string(i + 1); });
    const auto curve =
        std::find_if(panel.curves.begin(), panel.curves.end(), [&](const Curve& one) { return one.label == names[i]; });
    ASSERT_TRUE(text != panel.texts.end() && curve != panel.curves.end()) << names[i];
    const double beside = curve->mark == Mark::disc ? 2.5 : 1e-9;  // [m] of houses of 10 m
    const auto near_the_end = [](const std::vector<double>& of) {
      return of.front() + 0.85 * (of.back() - of.front());
    };
    EXPECT_NEAR(text->x, near_the_end(curve->x), beside) << names[i];
    EXPECT_NEAR(text->y, near_the_end(curve->y), beside) << names[i];
  }
}

/// Each number has a ground of its own, by which it is told from names, and the legend says what it is.
TEST(PlanMap, NumbersStandOnAGroundThatTheLegendNames) {
  const Panel panel = make_figure(run(), "map").panels.front();
  const auto grounds = std::find_if(panel.curves.begin(), panel.curves.end(),
                                    [](const Curve& one) { return one.label == "place among the worst"; });
  ASSERT_NE(grounds, panel.curves.end());
  EXPECT_TRUE(grounds->in_legend);
  ASSERT_EQ(grounds->x.size(), 10U);
  EXPECT_GT(1.8 * grounds->mark_size, 96 / 2.54 * text_width("10") / 2 + 1.5) << "radius of a circle [px]";
  for (std::size_t i = 0; i < grounds->x.size(); ++i) {
    const auto text = std::find_if(panel.texts.begin(), panel.texts.end(),
                                   [&](const PlaceText& one) { return one.text == std::to_string(i + 1); });
    ASSERT_NE(text, panel.texts.end());
    EXPECT_EQ(text->x, grounds->x[i]);
    EXPECT_EQ(text->y, grounds->y[i]);
    EXPECT_EQ(text->side, PlaceText::Side::middle);
  }
}

TEST(PlanMap, IsOfManyHousesAloneAndInTheirReport) {
  const auto has = [](const PlanRun& of) {
    const std::vector<FigureKind> kinds = figure_kinds(of);
    return std::any_of(kinds.begin(), kinds.end(), [](const FigureKind& one) { return one.name == "map"; });
  };
  const PlanRun pair = test::plan_run(test::twisting_pair());
  EXPECT_FALSE(has(pair));
  EXPECT_TRUE(has(run()));
  const std::string caption = "numbers are places in the table of the worst";
  EXPECT_EQ(plan_report_html(pair, {.version = "0"}).find(caption), std::string::npos);
  EXPECT_NE(plan_report_html(run(), {.version = "0"}).find(caption), std::string::npos);
}

TEST(PlanMap, CourtsAreDrawn) {
  for (const char* const kind : {"map", "scene"}) {
    const Figure figure = make_figure(run(), kind);
    EXPECT_EQ(curves_of(figure, "H2"), 2) << kind;
    EXPECT_EQ(curves_of(figure, "H3"), 1) << kind;
  }
  const std::string data = html::plan_animation_json(run(), Words("en"), {});
  EXPECT_NE(data.find("\"rings\":[[],[[["), std::string::npos);
}

}  // namespace
}  // namespace bentur
