// A block from above by what is judged of its gaps, and courts in pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/scene/plan_scene.h"
#include "bentur/report/words.h"
#include "tests/support/drawn_run.h"
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
  EXPECT_EQ(named, std::ssize(all) + 1) << "and what numbers are";
  for (const Curve& curve : figure.panels.front().curves) {
    if (curve.label == "H9") {
      EXPECT_EQ(curve.tone, Tone::grey);
    } else if (curve.label == "H1") {
      EXPECT_EQ(curve.tone, Tone::red);
    }
  }
  EXPECT_FALSE(figure.finding.empty());
}

TEST(PlanMap, IsToldApartInGreyAsItsOverviewAndScene) {
  for (const char* const kind : {"map", "overview", "scene", "opening"}) {
    test::expect_told_apart_in_grey(make_figure(run(), kind), kind);
  }
}

TEST(PlanMap, TheSceneSaysWhichNamesAreBlack) {
  EXPECT_TRUE(make_figure(run(), "scene").part.starts_with("Names in black: "));
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
    const auto off_the_crossings = [](const std::vector<double>& of) {
      return of.front() + 0.72 * (of.back() - of.front());
    };
    EXPECT_NEAR(text->x, off_the_crossings(curve->x), beside) << names[i];
    EXPECT_NEAR(text->y, off_the_crossings(curve->y), beside) << names[i];
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
  EXPECT_EQ(report_html(pair, {.version = "0"}).find(caption), std::string::npos);
  EXPECT_NE(report_html(run(), {.version = "0"}).find(caption), std::string::npos);
}

TEST(PlanMap, CourtsAreDrawn) {
  for (const char* const kind : {"map", "scene"}) {
    const Figure figure = make_figure(run(), kind);
    EXPECT_EQ(curves_of(figure, "H2"), 2) << kind;
    EXPECT_EQ(curves_of(figure, "H3"), 1) << kind;
  }
  const std::string data = html::animation_json(run(), {}, Words("en"));
  EXPECT_NE(data.find("\"rings\":[[],[[["), std::string::npos);
}

/// Whether a text of a picture lies within rings with all four corners of what it takes, and on none of their edges.
bool is_within(const PlaceText& text, double one_cm, const PlanRings& rings) {
  const double half = one_cm * text_width(text.text) / 2, high = 0.13 * one_cm;
  const Box box{text.x - half, text.x + half, text.y - high, text.y + high};
  for (const std::vector<PlanPoint>& ring : rings) {
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      if (box.meets(ring[i].x(), ring[i].y(), ring[i + 1].x(), ring[i + 1].y())) return false;
    }
  }
  return lies_in({text.x, text.y}, rings);
}

PlanRings closed(std::vector<PlanPoint> corners) {
  corners.push_back(corners.front());
  return {corners};
}

/// Letters of 20 m with legs of 6 m, and a court: the middle of none of them but of T is within.
TEST(PlanNames, LieWithinOutlinesThatTurnInwards) {
  const PlanRings l = closed({{0, 0}, {20, 0}, {20, 6}, {6, 6}, {6, 20}, {0, 20}});
  const PlanRings u = closed({{0, 0}, {20, 0}, {20, 20}, {14, 20}, {14, 6}, {6, 6}, {6, 20}, {0, 20}});
  const PlanRings t = closed({{7, 0}, {13, 0}, {13, 14}, {20, 14}, {20, 20}, {0, 20}, {0, 14}, {7, 14}});
  PlanRings with_court = closed({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  with_court.push_back(closed({{5, 5}, {15, 5}, {15, 15}, {5, 15}}).front());
  for (const PlanRings& rings : {l, u, t, with_court}) {
    for (const NameRows& rows : {NameRows{.half_height = 0.5}, {.parts = {0.8, 0.2, 0.5}, .half_height = 0.5}}) {
      const PlaceText name = place_of_name("Yard", rings, rows);
      ASSERT_GT(name.room, 3);
      EXPECT_TRUE(is_within(name, 1, rings)) << name.x << ", " << name.y;
    }
  }
  EXPECT_EQ(place_of_name("Yard", closed({{0, 0}, {20, 0}, {20, 0.5}, {0, 0.5}}), {.half_height = 0.5}).room, 0);
}

TEST(PlanNames, GiveWayToMarks) {
  const PlanRings square = closed({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  NameRows rows{.half_height = 0.5};
  EXPECT_EQ(place_of_name("Yard", square, rows).y, 10);
  rows.marks = {{9.8, 10.2, 9.8, 10.2}};
  EXPECT_EQ(place_of_name("Yard", square, rows).y, 17) << "another row has more room";
  for (const double y : {17.0, 3.0}) rows.marks.push_back({13.8, 14.2, y - 0.2, y + 0.2});
  const PlaceText beside = place_of_name("Yard", square, rows);
  EXPECT_LE(beside.x + beside.room / 2, 13.8) << "in its broader part";
}

/// As they are drawn: on no mark, no ray and no other text, also where a centre is where a name would stand.
TEST(PlanNames, LieOnNoMarkOfAScene) {
  for (const char* const centre : {"centre = [7.5, 9.0]", "centre = [7.5, 13.5]", "centre = [7.5, 4.5]"}) {
    const PlanRun pair = test::plan_run(test::twisting_pair("centre = [7.5, 9.0]", centre));
    for (const char* const kind : {"scene", "overview"}) {
      const Figure figure = make_figure(pair, kind);
      const Panel& panel = figure.panels.front();
      const PanelPlace place = placed_figure(figure, "").panels.front();
      const double one_cm = 96 / 2.54 * (place.x.second - place.x.first) / place.width;
      const auto box_of = [&](const PlaceText& text) {
        const double half = one_cm * text_width(text.text) / 2, high = 0.13 * one_cm;
        return Box{text.x - half, text.x + half, text.y - high, text.y + high};
      };
      ASSERT_EQ(panel.texts.size(), 2U) << centre;
      EXPECT_FALSE(box_of(panel.texts[0]).meets(box_of(panel.texts[1])));
      for (const PlaceText& text : panel.texts) {
        const Box box = box_of(text);
        for (const Curve& curve : panel.curves) {
          if (curve.mark == Mark::none && curve.tone != Tone::red) continue;
          const double half = 0.04 * one_cm * (curve.mark == Mark::none ? 0 : curve.mark_size);
          for (std::size_t i = 0; i < curve.x.size(); ++i) {
            EXPECT_FALSE(box.meets({curve.x[i] - half, curve.x[i] + half, curve.y[i] - half, curve.y[i] + half}))
                << centre << ", " << kind << ": " << text.text << " on " << curve.label;
          }
        }
      }
    }
  }
}

/// As it is drawn, in a column, where those of the court and of the L have no room, and over a page.
TEST(PlanMap, NamesLieWithinTheirOutlines) {
  for (const double width : {column_width, page_width}) {
    FigureOptions options;
    options.width = width;
    const Figure figure = make_figure(run(), "map", options);
    const Panel& panel = figure.panels.front();
    const PanelPlace place = placed_figure(figure, "").panels.front();
    const double one_cm = 96 / 2.54 * (place.x.second - place.x.first) / place.width;
    for (const PlanBuilding& building : run().problem.buildings) {
      const auto is_it = [&](const PlaceText& one) { return one.text == building.name; };
      const auto text = std::find_if(panel.texts.begin(), panel.texts.end(), is_it);
      ASSERT_NE(text, panel.texts.end()) << building.name;
      if (one_cm * text_width(text->text) > text->room) {  // is not drawn
        EXPECT_TRUE(width == column_width && (building.name == "H2" || building.name == "H3")) << building.name;
        continue;
      }
      PlanRings rings = building.model.footprint.all_rings();
      for (std::vector<PlanPoint>& ring : rings) ring.push_back(ring.front());
      EXPECT_TRUE(is_within(*text, one_cm, rings)) << building.name;
    }
  }
}

/// A bar as long as the number beside it says, and the axes of the case; both below the block.
TEST(PlanMap, HasAScaleAndDirections) {
  const Panel panel = make_figure(run(), "map").panels.front();
  const auto text = [&](const auto& is_it) { return std::find_if(panel.texts.begin(), panel.texts.end(), is_it); };
  const auto bar = text([](const PlaceText& one) { return one.text.ends_with(" m"); });
  ASSERT_NE(bar, panel.texts.end());
  const auto ends_there = [&](const Curve& one) { return !one.x.empty() && one.x.back() == bar->x; };
  const auto curve = std::find_if(panel.curves.begin(), panel.curves.end(), ends_there);
  ASSERT_NE(curve, panel.curves.end());
  EXPECT_NEAR(bar->x - curve->x.front(), std::stod(bar->text), 1e-9);
  const auto x = text([](const PlaceText& one) { return one.text == "x"; });
  const auto y = text([](const PlaceText& one) { return one.text == "y"; });
  ASSERT_TRUE(x != panel.texts.end() && y != panel.texts.end());
  EXPECT_TRUE(x->x > y->x && y->y > x->y) << "arrows of a plan as it is drawn";
  for (const auto& one : {bar, x, y}) EXPECT_LT(one->y, 0) << "below the lowest house";
}

/// Corners that meet are told apart by more than their colour.
TEST(PlanMap, CornersDifferInSizeAndFill) {
  const Panel panel = make_figure(run(), "map").panels.front();
  std::set<Tone> tones;
  std::set<std::pair<Mark, double>> marks;
  for (const Curve& curve : panel.curves) {
    const bool is_corner = curve.label.find(" | ") != std::string::npos && curve.mark != Mark::none;
    if (!is_corner) continue;
    tones.insert(curve.tone);
    marks.insert({curve.mark, curve.mark_size});
  }
  EXPECT_GT(tones.size(), 1U);
  EXPECT_EQ(marks.size(), tones.size());
}

/// In the scene of many houses the names of those that strike now are black, the others grey; where nothing strikes
/// there is no mark.
TEST(PlanMap, TheSceneOfABlockStressesWhatStrikesNow) {
  const std::regex outlines("polygon = .*\n(court = .*\n)?");  // which leave names little room
  const PlanRun run = test::plan_run(std::regex_replace(block(), outlines, "size = [10.0, 12.0]\n"));
  const Panel panel = make_figure(run, "scene").panels.front();
  const auto hardest = hardest_impact(run.response.impacts);
  ASSERT_NE(hardest, nullptr);
  std::set<std::string> strike;
  for (const Impact& impact : run.response.impacts) {
    if (impact.start > hardest->peak_force_time || impact.end < hardest->peak_force_time) continue;
    const PlanGap& gap = run.problem.gaps[contact_at(run.problem, impact.point).gap];
    for (const Eigen::Index b : {gap.left, gap.right}) strike.insert(run.problem.buildings[b].name);
  }
  std::set<Tone> tones;
  for (const PlaceText& name : panel.texts) {
    EXPECT_EQ(name.tone, strike.contains(name.text) ? Tone::black : Tone::grey) << name.text;
    tones.insert(name.tone);
  }
  EXPECT_EQ(tones.size(), 2U);
  for (const Curve& curve : panel.curves) EXPECT_NE(curve.label, "contact point");
}

/// What moves has names at the same places: within the outlines, and in the table beside it those of the texts.
TEST(PlanMap, NamesInMotionAreThoseOfTheTexts) {
  std::string text = block();
  for (std::size_t at = 0; (at = text.find("name = \"H", at)) != std::string::npos; ++at)
    text.insert(at + 9, "ouse 5.");
  const PlanRun many = test::plan_run(text);
  const auto data = nlohmann::json::parse(html::animation_json(many, {}, Words("en")));
  const PlanScene scene(many);
  for (std::size_t b = 0; b < many.problem.buildings.size(); ++b) {
    EXPECT_EQ(data["buildings"][b]["name"].get<std::string>(), "House 5." + std::to_string(b + 1));
    EXPECT_EQ(data["names"]["short"][b].get<std::string>(), "5." + std::to_string(b + 1));
    PlanRings rings = many.problem.buildings[b].model.footprint.all_rings();
    for (std::vector<PlanPoint>& ring : rings) ring.push_back(ring.front());
    const auto& row = data["scene"]["names"][b];
    const PlanPoint left(row[0][0].get<double>(), row[0][1].get<double>());
    const PlanPoint right(row[1][0].get<double>(), row[1][1].get<double>());
    for (const double part : {0.01, 0.5, 0.99}) EXPECT_TRUE(lies_in(left + part * (right - left), rings)) << b;
  }
  EXPECT_EQ(report_html(many, {.version = "0"}).find("1 House 5.1, 2 House 5.2"), std::string::npos);
}

}  // namespace
}  // namespace bentur
