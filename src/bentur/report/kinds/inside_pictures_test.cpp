#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/report/kinds/kinds.h"
#include "tests/support/drawn_run.h"

// Where a floor goes inside what it faces, as no contact is modelled there, pictures show and say that.
namespace bentur {
namespace {

/// The roof of five storeys beside the columns of eight; their first floors alone are near one level.
RunResults five_beside_eight(const std::string& width) {
  return test::drawn_run(R"(
units = { length = "m", force = "kN" }
excitation = { kind = "record", file = "../data/el-centro-1940-ns.csv", unit = "g" }
analysis = { duration = 10.0 }
[[building]]
name = "High"
damping = 0.05
generic = { storeys = 8, storey_height = 3.2, floor_mass = 255.0, period = 0.95, stiffness_ratio = 30 }
[[building]]
name = "Low"
damping = 0.05
generic = { storeys = 5, storey_height = 3.5, floor_mass = 185.0, period = 0.43, stiffness_ratio = 30 }
[[gap]]
between = ["High", "Low"]
contact = { law = "linear", stiffness = 1e6 }
width = )" + width);
}

/// Those first floors stay apart.
const RunResults& unmodelled() {
  static const RunResults run = five_beside_eight("0.03");
  return run;
}

const WatchedSummary& deepest() {
  const std::vector<WatchedSummary>& all = unmodelled().response.watched;
  return *std::min_element(all.begin(), all.end(), [](const WatchedSummary& a, const WatchedSummary& b) {
    return a.least_opening < b.least_opening;
  });
}

constexpr const char* roof_inside = "roof of Low 0.07143 m inside High, contact not modelled";

TEST(InsidePictures, TheStillNamesTheFloorAndHatchesIt) {
  ASSERT_TRUE(unmodelled().response.impacts.empty());
  ASSERT_TRUE(deepest().closes);
  for (const char* kind : {"scene", "overview"}) {
    const Panel panel = make_figure(unmodelled(), kind).panels.front();
    EXPECT_NE(panel.title.find(roof_inside), std::string::npos) << panel.title;
    const auto red = std::find_if(panel.curves.begin(), panel.curves.end(),
                                  [](const Curve& curve) { return curve.tone == Tone::red; });
    ASSERT_NE(red, panel.curves.end()) << kind;
    double low = INFINITY, high = -INFINITY, left = INFINITY, right = -INFINITY;
    for (std::size_t i = 0; i < red->x.size(); ++i) {
      if (std::isnan(red->x[i])) continue;
      low = std::min(low, red->y[i]), high = std::max(high, red->y[i]);
      left = std::min(left, red->x[i]), right = std::max(right, red->x[i]);
    }
    EXPECT_NEAR((low + high) / 2, 17.5, 1e-9);
    EXPECT_GT(right - left, 20 * 0.0714);  // as much as displacements are magnified
  }
  EXPECT_NE(make_figure(unmodelled(), "scene").finding.find(roof_inside), std::string::npos);
}

/// Watched floors that are inside what they face at the peak of the hardest impact.
long inside_now(const RunResults& run) {
  const std::vector<Impact>& impacts = run.response.impacts;
  const double time = std::max_element(impacts.begin(), impacts.end(), [](const Impact& a, const Impact& b) {
                        return a.peak_force < b.peak_force;
                      })->peak_force_time;
  const Histories& course = run.response.course;
  const auto sample = std::min_element(course.time.begin(), course.time.end(),
                                       [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); }) -
                      course.time.begin();
  return std::count_if(run.problem.watched.begin(), run.problem.watched.end(), [&](const WatchedFloor& floor) {
    const auto moved = [&](const Eigen::VectorXd& row, Eigen::Index building) {
      return row.head(course.displacement[building].rows()).dot(course.displacement[building].col(sample));
    };
    return moved(floor.left_row, floor.left) - moved(floor.right_row, floor.right) > floor.width;
  });
}

/// Where first floors collide, too, the still is of an impact: it says what it does not show.
TEST(InsidePictures, AnImpactElsewhereHidesNoFloorInside) {
  const RunResults run = five_beside_eight("0.005");
  ASSERT_FALSE(run.response.impacts.empty());
  ASSERT_TRUE(run.figures.nearest && run.figures.nearest->closes);
  for (const char* kind : {"scene", "overview"}) {
    const Figure figure = make_figure(run, kind);
    EXPECT_NE(figure.panels.front().title.find("impact"), std::string::npos) << figure.panels.front().title;
    EXPECT_NE(figure.part.find("inside High, contact not modelled, deepest at"), std::string::npos) << figure.part;
    // What is inside at the instant that is drawn is hatched and counted.
    const std::vector<Curve>& curves = figure.panels.front().curves;
    const auto hatched = std::count_if(curves.begin(), curves.end(), [](const Curve& one) {
      return one.tone == Tone::red && one.width == 0.9;  // bursts are thicker
    });
    const std::string counted = "Floors inside at this instant, hatched: " + std::to_string(hatched) + "; the deepest:";
    EXPECT_EQ(figure.part.starts_with(counted), hatched > 0) << figure.part;
    EXPECT_EQ(hatched, inside_now(run)) << kind;
  }
  // Its opening is of the level of its bars, with the instant that is drawn.
  const std::vector<Panel> panels = make_figure(run, "overview").panels;
  EXPECT_EQ(panels.back().title, "needed at level 17.5 m");
  EXPECT_NE(panels.at(1).title.find("level 17.5 m"), std::string::npos) << panels.at(1).title;
  EXPECT_LT(panels.at(1).curves.back().y.front(), 0);
  const std::string part = make_figure(unmodelled(), "scene").part;
  EXPECT_TRUE(part.starts_with("Floors inside at this instant, hatched: ") && part.ends_with(roof_inside)) << part;
}

/// Of both ways of the motion the verdict tells the one in which a floor goes deeper, where both were run.
TEST(InsidePictures, TheVerdictTellsTheDeeperWay) {
  RunResults run = five_beside_eight("0.03");
  const auto told = [&](const std::string& name) {
    const std::vector<Statement> all = run_story(run).statements;
    const auto found =
        std::find_if(all.begin(), all.end(), [](const Statement& one) { return one.kind == "unmodelled"; });
    return std::find_if(found->values.begin(), found->values.end(),
                        [&](const StoryValue& one) { return one.name == name; })
        ->value;
  };
  EXPECT_EQ(std::get<std::string>(told("way")), "");  // the other one was not asked for
  ReversedRun& other = run.response.reversed.emplace();
  other.points = run.response.points;
  other.drifts = drifts_no_contact(run.response);
  other.watched = run.response.watched;
  for (WatchedSummary& floor : other.watched) floor.least_opening *= 2;
  EXPECT_EQ(std::get<std::string>(told("way")), "story.way.recorded");  // with contact it was not run
  other.has_contact = true;
  EXPECT_EQ(std::get<std::string>(told("way")), "story.way.reversed");
  EXPECT_NEAR(std::get<double>(told("depth")), -2 * deepest().least_opening, 1e-12);
}

/// The least opening is that of the continuous response, which the solver finds without any history.
TEST(InsidePictures, TheOpeningIsThatOfItsLevel) {
  const Figure figure = make_figure(unmodelled(), "opening");
  EXPECT_NE(figure.finding.find(roof_inside), std::string::npos) << figure.finding;
  EXPECT_NE(figure.panels.front().title.find("level 17.5 m"), std::string::npos);
  const Curve& opening = figure.panels.front().curves.front();
  const auto least = std::min_element(opening.y.begin(), opening.y.end());
  const double scale = 0.2;  // displacements of both [m], of which a course leaves no curve by more than 1/1000
  EXPECT_NEAR(*least, deepest().least_opening, 1e-3 * scale);
  EXPECT_NEAR(opening.x[static_cast<std::size_t>(least - opening.y.begin())], deepest().least_time, 0.02);
  EXPECT_NEAR(opening.y.front(), 0.03, 1e-12);
  const Panel in_overview = make_figure(unmodelled(), "overview").panels.at(1);
  EXPECT_EQ(in_overview.curves.back().y.front(), deepest().least_opening);
}

/// The column moves between the floors above and below it.
TEST(InsidePictures, DisplacementsAreOfTheFloorAndOfWhatItFaces) {
  const Figure figure = make_figure(unmodelled(), "displacement");
  const Histories& course = unmodelled().response.course;
  std::vector<Curve> curves;
  for (const Panel& panel : figure.panels) {
    if (panel.curves.size() == 1) curves.push_back(panel.curves.front());
  }
  if (curves.empty()) curves = figure.panels.front().curves;
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].label, "High");
  for (std::size_t i = 0; i < course.time.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    EXPECT_EQ(curves[1].y[i], course.displacement[1](4, column));
    const double below = course.displacement[0](4, column), above = course.displacement[0](5, column);
    const double slack = 0.05 * std::abs(above - below) + 1e-4;  // of a column that bends
    EXPECT_GT(curves[0].y[i], std::min(below, above) - slack);
    EXPECT_LT(curves[0].y[i], std::max(below, above) + slack);
  }
}

/// A level that is asked for is drawn as it is.
TEST(InsidePictures, AnotherLevelMayBeAskedFor) {
  FigureOptions options;
  options.elevation = 3.35;
  EXPECT_NE(make_figure(unmodelled(), "opening", options).finding.find("closest approach"), std::string::npos);
}

}  // namespace
}  // namespace bentur
