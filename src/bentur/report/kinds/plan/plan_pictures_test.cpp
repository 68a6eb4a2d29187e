// The figures of buildings in plan, against the run they are of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/scene/plan_scene.h"
#include "bentur/report/words.h"
#include "bentur/structure/modes.h"
#include "tests/support/drawn_run.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

const PlanRun& twisting() {
  static const PlanRun run = test::plan_run(test::twisting_pair(), 0.002);
  return run;
}

FigureOptions in_language(const std::string& language) {
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  return options;
}

std::vector<std::string> names_of(const PlanRun& run) {
  std::vector<std::string> names;
  for (const FigureKind& kind : figure_kinds(run)) names.push_back(kind.name);
  return names;
}

const Curve& labelled(const Panel& panel, const std::string& label) {
  for (const Curve& curve : panel.curves) {
    if (curve.label == label) return curve;
  }
  throw std::out_of_range(label);
}

TEST(PlanPictures, ARunGivesWhatItHas) {
  EXPECT_EQ(names_of(twisting()), (std::vector<std::string>{"overview", "scene", "displacement", "opening", "orbit",
                                                            "force", "friction-cone", "energy"}));
  const PlanRun smooth = test::plan_run(test::twisting_pair(", friction = 0.3"));
  EXPECT_EQ(names_of(smooth).size(), 7U);
  const PlanRun calm = test::plan_run(test::twisting_pair("pga = 3.4", "pga = 0.3"));
  EXPECT_EQ(names_of(calm),
            (std::vector<std::string>{"overview", "scene", "displacement", "opening", "orbit", "energy"}));
  EXPECT_NE(make_figure(calm, "scene").finding.find("closest, without contact"), std::string::npos);
  for (const PlanRun* const run : {&smooth, &calm}) EXPECT_THROW((void)make_figure(*run, "friction-cone"), NoFigure);
  EXPECT_THROW((void)make_figure(calm, "force"), NoFigure);
}

/// The period marked in a spectrum along x is that of the mode which moves the most mass along x, not the longest.
TEST(PlanPictures, FloorSpectraMarkThePeriodOfTheirDirection) {
  PlanRun run = twisting();
  run.closer = dense_findings(run);
  const std::vector<FloorSpectra::Floor>& floors = run.closer.floors.floors;
  ASSERT_FALSE(floors.empty());
  const Figure figure = make_figure(run, "floor-spectrum");
  ASSERT_EQ(figure.panels.size(), floors.size());
  for (std::size_t i = 0; i < floors.size(); ++i) {
    ASSERT_NEAR(std::abs(floors[i].along.x()), 1, 1e-12);
    const PlanBuilding& building = run.problem.buildings[floors[i].building];
    const ModalProperties modes = modal_properties(building.modes, building.model.load.col(0));
    Eigen::Index most = 0;
    modes.effective_mass_fraction.maxCoeff(&most);
    ASSERT_EQ(figure.panels[i].rules.size(), 1U) << i;
    EXPECT_NEAR(figure.panels[i].rules[0].at, modes.periods(most), 1e-12 * modes.periods(most)) << i;
  }
}

TEST(PlanPictures, CurvesAreToldApartInGrey) {
  for (const FigureKind& kind : figure_kinds(twisting())) {
    test::expect_told_apart_in_grey(make_figure(twisting(), kind.name), kind.name);
  }
}

/// What a row has and a plan has not is refused by what it is.
TEST(PlanPictures, KindsOfARowAreRefused) {
  const auto refusal = [](const std::string& kind) -> std::string {
    try {
      (void)make_figure(twisting(), kind);
    } catch (const NoFigure& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("envelope").find("no figure \"envelope\" of buildings in plan, but of a row."), 0U);
  EXPECT_EQ(refusal("orbits").find("no figure \"orbits\" of this run; did you mean \"orbit\"?"), 0U);
  FigureOptions options;
  options.gap = 1;
  EXPECT_THROW((void)make_figure(twisting(), "scene", options), NoFigure);
  options.gap.reset();
  options.elevation = 5;
  EXPECT_THROW((void)make_figure(twisting(), "scene", options), NoFigure);
}

/// All texts are words of the catalogue, names, or symbols and numbers, and both languages draw.
TEST(PlanPictures, TextsAreInTheCatalogue) {
  std::set<std::string> known;
  for (const std::string& key : text_keys("figure.text.")) known.insert(catalogue_entry(key)->at("en"));
  FigureOptions options;
  options.say = [&](std::string_view english) {
    EXPECT_TRUE(known.contains(std::string(english))) << english << " is not in the catalogue";
    return "§" + std::string(english);
  };
  const std::regex symbols(R"([xy] = [0-9.]+ m|±μF, μ = 0.3)");
  for (const PlanRun& run : {twisting(), test::plan_run(test::twisting_pair() + test::wall_beside)}) {
    std::set<std::string> names = {"§opening", ""};
    for (const PlanBuilding& building : run.problem.buildings) names.insert(building.name);
    for (const FigureKind& kind : figure_kinds(run)) {
      const Figure figure = make_figure(run, kind.name, options);
      const bool is_story = kind.name == "overview";  // the first sentence of the verdict, which has words of its own
      EXPECT_NE(figure.finding.find(is_story ? " " : "§"), std::string::npos) << kind.name << " tells nothing";
      std::vector<std::string> shown;
      for (const Panel& panel : figure.panels) {
        for (const std::string& text : {panel.title, panel.x.label, panel.y.label, panel.events.label})
          shown.push_back(text);
        for (const Curve& curve : panel.curves) shown.push_back(curve.label);
        for (const RuleLine& rule : panel.rules) shown.push_back(rule.label);
      }
      for (const std::string& text : shown) {
        EXPECT_TRUE(text.find("§") != std::string::npos || names.contains(text) || std::regex_match(text, symbols))
            << kind.name << ": " << text;
        EXPECT_EQ(text.find("{}"), std::string::npos) << text;
      }
      for (const std::string language : {"en", "id"}) {
        const Figure drawn = make_figure(run, kind.name, in_language(language));
        EXPECT_NE(figure_svg(drawn).find("</svg>"), std::string::npos);
      }
    }
  }
}

/// The case of docs/theory/plan.md whose two corners slip off one another; the other corners of a neighbour are so near
/// to one another that some are merged.
TEST(PlanPictures, TheSceneShowsWhatSlipsOffAndWhichCornersAreMerged) {
  const std::string soft = "rigidity = { centre = [5, 5], x = 1e-4, y = 1e-4, torsion = 1e-4 }\n";
  const std::string text =
      "[units]\nlength = \"m\"\nforce = \"kN\"\n[plan]\nclearance = 0.2\ncontact = { law = \"linear\", stiffness = 4e5 "
      "}\n[[building]]\nname = \"A\"\ndamping = 0.0\nplan = { corner = [0, 0], size = [10, 10], storey_heights = [3], "
      "masses = [200] }\n" +
      soft +
      "[[building]]\nname = \"B\"\ndamping = 0.0\nplan = { corner = [10.02, 9.9], size = [10, 10], storey_heights = "
      "[3], masses = [200] }\n" +
      soft +
      "[[building]]\nname = \"Round\"\nrigid = true\nelevations = [3]\nplan = { polygon = [[-10, 4], [-0.3, 4], "
      "[-0.05, 4.7], [-0.02, 5], [-0.05, 5.3], [-0.3, 6], [-10, 6]] }\n"
      "[excitation]\nkind = \"none\"\n[initial]\nvelocities = { A = [[0.5, -2, 0]] }\n[analysis]\nduration = 0.2\n";
  const PlanRun run = test::plan_run(text, 0.001);
  std::size_t merged = 0;
  for (const PlanGap& gap : run.problem.gaps) merged += merged_corners(run.problem, gap).size();
  ASSERT_GT(merged, 0U);
  const Panel panel = make_figure(run, "scene").panels.front();
  EXPECT_EQ(labelled(panel, "merged corner").x.size(), 2 * merged);
  // Both ends slip off at one instant, of which the picture is.
  const Curve& slid = labelled(panel, "slips off");
  EXPECT_EQ(slid.mark, Mark::diamond);
  EXPECT_EQ(slid.x, labelled(panel, "strikes now").x);
  EXPECT_EQ(slid.x.size(), 4U);
  const std::vector<Curve> without = make_figure(twisting(), "scene").panels.front().curves;
  EXPECT_TRUE(std::none_of(without.begin(), without.end(), [](const Curve& one) { return one.mark == Mark::diamond; }));
}

/// Footprints meet in the picture where they meet in the run: the corner that strikes is at the other edge, but for its
/// penetration.
TEST(PlanPictures, TheSceneShowsTheHardestImpact) {
  const PlanRun& run = twisting();
  const Figure figure = make_figure(run, "scene");
  const Panel& panel = figure.panels.front();
  EXPECT_TRUE(panel.to_scale);
  EXPECT_NE(panel.title.find("magnified 20 times"), std::string::npos) << panel.title;
  EXPECT_NE(panel.title.find("2045 kN"), std::string::npos) << panel.title;
  EXPECT_NE(panel.title.find("y = 18 m"), std::string::npos) << panel.title;
  const PlanScene scene(run);
  ASSERT_EQ(scene.magnification(), 20);
  const Curve& now = labelled(panel, "strikes now");
  ASSERT_EQ(now.x.size(), 2U);
  EXPECT_NEAR(now.x[0] - now.x[1], 20 * 0.01023, 0.01);  // the penetration, between two samples
  EXPECT_EQ(labelled(panel, "contact point").x.size(), 2U);
  const Curve& walled = labelled(panel, "Walled");
  EXPECT_NE(std::find(walled.x.begin(), walled.x.end(), now.x[0]), walled.x.end());
  // At rest the gap is magnified as well, and nothing but gaps is.
  EXPECT_NEAR(scene.place({12.04, 3}).x() - scene.place({12, 3}).x(), 20 * 0.04, 1e-12);
  EXPECT_NEAR(scene.place({12, 18}).x() - scene.place({0, 0}).x(), 12, 1e-12);
  EXPECT_NEAR(scene.place({12, 18}).y() - scene.place({0, 0}).y(), 18, 1e-12);
  // Half of the stretch is struck at most, by the hardest impact of all, and never at its other end.
  const auto found = std::find_if(panel.curves.begin(), panel.curves.end(), [](const Curve& curve) {
    return curve.label.starts_with("hardest impact 102") && curve.label.ends_with(" to 2045 kN");
  });
  ASSERT_NE(found, panel.curves.end());
  const Curve& strip = *found;
  EXPECT_EQ(strip.tone, Tone::red);
  EXPECT_NEAR(strip.y[0], 9, 1e-12);
  EXPECT_NEAR(strip.top[0], 18, 1e-12);
  // Centres of mass and of rigidity of the example.
  const Curve &mass = labelled(panel, "centre of mass"), &rigidity = labelled(panel, "centre of rigidity");
  ASSERT_EQ(mass.x.size(), 2U);
  ASSERT_EQ(rigidity.x.size(), 2U);
  EXPECT_NEAR(mass.y[0] - rigidity.y[0], 9 - 18.0 * 2 / 11, 0.02);  // turned by 20 · 2 mrad
  EXPECT_NEAR(mass.x[1], rigidity.x[1], 1e-9);
}

/// Across the gap at each place where a floor goes inside what it faces and no contact is modelled; nowhere else.
TEST(PlanPictures, GapsAreHatchedWhereContactIsNotModelled) {
  const PlanRun run = test::plan_run(test::twisting_pair("[3.5, 3.2]\nmasses = [250", "[3.5, 2.0]\nmasses = [250"));
  const PlanScene scene(run);
  const PlanGap& gap = run.problem.gaps.front();
  std::vector<PlanPoint> places;
  for (std::size_t i = 0; i < gap.watched.size(); ++i) {
    if (run.response.watched[i].closes) places.push_back(scene.place(gap.middle(gap.watched[i])));
  }
  ASSERT_FALSE(places.empty());
  for (const char* const kind : {"scene", "overview"}) {
    const Panel panel = make_figure(run, kind).panels.front();
    const Curve& hatches = labelled(panel, "contact not modelled");
    EXPECT_EQ(hatches.tone, Tone::red);
    for (std::size_t i = 0; i < places.size(); ++i) {  // four lines about each place
      PlanPoint middle(0, 0);
      for (std::size_t k = 0; k < 4; ++k) {
        for (const std::size_t end : {0, 1}) {
          const std::size_t at = (4 * i + k) * 3 + end;
          middle += PlanPoint(hatches.x.at(at), hatches.y.at(at)) / 8;
        }
      }
      EXPECT_NEAR((middle - places[i]).norm(), 0, 1e-9) << kind;
    }
    EXPECT_ANY_THROW((void)labelled(make_figure(twisting(), kind).panels.front(), "contact not modelled"));
  }
}

/// The opening figure tells of the gap that it shows, the one hit hardest, by its name where there are several.
TEST(PlanPictures, TheOverviewTellsOfTheGapThatItShows) {
  EXPECT_EQ(make_figure(twisting(), "overview").finding.find("Walled and Frame collide 7"), 0U);
  const PlanRun beside = test::plan_run(test::twisting_pair() + test::wall_beside);
  const Figure whole = make_figure(beside, "overview");  // the wall is hit harder
  EXPECT_EQ(whole.finding.find("Walled | W: Walled and W collide"), 0U) << whole.finding;
  FigureOptions options;
  options.gap = 0;
  const Figure other = make_figure(beside, "overview", options);
  EXPECT_EQ(other.finding.find("Walled | Frame: Walled and Frame collide"), 0U) << other.finding;
  options.width = page_width;
  EXPECT_EQ(make_figure(beside, "overview", options).columns, 2);
  // What is given and needed, of one gap with numbers and the level, of several by their names with the level.
  const Panel of_one = make_figure(twisting(), "overview").panels.back(), of_two = whole.panels.back();
  EXPECT_EQ(of_one.title, "needed at level 6.7 m");
  EXPECT_EQ(of_one.y.names,
            (std::vector<std::string>{"reversed: 0.08825 m", "as recorded: 0.08747 m", "given: 0.04000 m"}));
  ASSERT_EQ(of_two.y.names.size(), 2U);
  for (const std::string& name : of_two.y.names) EXPECT_TRUE(name.ends_with(" m")) << name;
}

/// Impacts that take no time are told by their impulses.
TEST(PlanPictures, ImpulsesColourGapsWhereThereAreNoForces) {
  const PlanRun run = test::plan_run(test::twisting_pair("law = \"linear\", stiffness = 4e5, friction = 0.3",
                                                         "law = \"restitution\", restitution = 0.5"));
  ASSERT_FALSE(run.response.impacts.empty());
  double hardest = 0;
  for (const Impact& impact : run.response.impacts) hardest = std::max(hardest, impact.impulse);
  const Panel panel = make_figure(run, "scene").panels.front();
  const auto red = std::find_if(panel.curves.begin(), panel.curves.end(), [](const Curve& curve) {
    return curve.tone == Tone::red && curve.label.starts_with("hardest impact ");
  });
  ASSERT_NE(red, panel.curves.end());
  const auto last = red->label.find(" to ") + std::string(" to ").size();
  EXPECT_NEAR(std::stod(red->label.substr(last)), hardest, 1e-3 * hardest) << red->label;
  EXPECT_NE(red->label.find("kN·s"), std::string::npos);
}

/// Three buildings around a corner: gaps of both axes are magnified alike, and an edge that a gap's line crosses at a
/// right angle is longer for it, with no corner of its own, which would be a kink when the building turns.
TEST(PlanScene, GapsOfBothAxesAreMagnified) {
  const std::string third =
      "\n[[building]]\nname = \"T\"\nrigid = true\nelevations = [3.5]\nplan = { corner = [4, 18.03], size = [18, 5] "
      "}\n";
  const PlanRun run = test::plan_run(test::twisting_pair() + third);
  const PlanScene scene(run);
  const double m = scene.magnification();
  EXPECT_NEAR(scene.place({5, 18.03}).y() - scene.place({5, 18}).y(), m * 0.03, 1e-12);
  EXPECT_NEAR(scene.place({22, 20}).x() - scene.place({4, 20}).x(), 18 + (m - 1) * 0.04, 1e-12);
  const std::vector<PlanPoint> outline = scene.outlines(run.problem.buildings.back().model.footprint).front();
  EXPECT_EQ(outline.size(), 5U);
  EXPECT_EQ(outline.front(), outline.back());
}

/// A polygon is drawn with its own edges, and floors that touch in the picture touch: across the gap, which is oblique,
/// places are apart by the magnified gap.
/// A square of 4 by 4 around the origin, below one that covers its right half and has a court of 1 by 1 in it.
TEST(PlanScene, WhatIsCoveredIsNotSeen) {
  const auto square = [](double x, double y, double half) {
    return std::vector<PlanPoint>{
        {x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}, {x - half, y - half}};
  };
  const std::vector<PlanPoint> low = square(0, 0, 2);
  EXPECT_EQ(seen_parts(low, {}), PlanRings{low});
  const PlanRings high{square(3, 0, 3), square(2, 0, 0.5)};
  EXPECT_TRUE(lies_in({1, 1}, high));
  EXPECT_FALSE(lies_in({-1, 1}, high));
  EXPECT_FALSE(lies_in({2, 0.2}, high)) << "in its court";
  double length = 0;
  for (const std::vector<PlanPoint>& line : seen_parts(low, {high})) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      length += (line[i + 1] - line[i]).norm();
      const PlanPoint middle = (line[i] + line[i + 1]) / 2;
      EXPECT_FALSE(lies_in(middle, high));
    }
  }
  EXPECT_NEAR(length, 2 + 4 + 2 + 1, 1e-12);  // half of three sides' ends, the left side, and what the court shows
  EXPECT_TRUE(seen_parts(square(3, 2, 0.5), {high}).empty());
}

TEST(PlanScene, PolygonsAreDrawnAsTheyAre) {
  const PlanRun run =
      test::plan_run(test::twisting_pair("size = [15.0, 18.0]", "polygon = [[0, 0], [15, 0], [15, 18], [2, 18]]"));
  const Footprint& footprint = run.problem.buildings[1].model.footprint;
  ASSERT_EQ(footprint.polygon.size(), 4U);
  const PlanScene scene(run);
  const Stretch& stretch = run.problem.gaps[0].stretch;
  ASSERT_TRUE(stretch.is_oblique());
  const double m = scene.magnification(), along = stretch.from;
  const PlanPoint apart = scene.place(stretch.on_edge(1, along)) - scene.place(stretch.on_edge(0, along));
  EXPECT_GT(m, 1);
  EXPECT_NEAR(stretch.normal(along).dot(apart), m * stretch.width, 1e-12);
  const std::vector<PlanPoint> outline = scene.outlines(footprint).front();
  for (const PlanPoint& corner : footprint.corners()) {
    EXPECT_NE(std::find(outline.begin(), outline.end(), corner), outline.end()) << corner.transpose();
  }
  EXPECT_EQ(outline.front(), outline.back());
  const Figure figure = make_figure(run, "scene");
  for (const Curve& curve : figure.panels[0].curves) {
    for (std::size_t i = 0; i < curve.top.size(); ++i) EXPECT_GE(curve.top[i], curve.y[i]);
  }
}

/// Between two samples in a straight line, and by (P-1).
TEST(PlanScene, FloorsMoveAsTheHistoriesSay) {
  const PlanRun& run = twisting();
  const PlanHistories& histories = run.response.histories;
  const Eigen::Vector3d at = floor_motion(histories, 0, 1, histories.time[700]);
  const Eigen::Vector3d next = floor_motion(histories, 0, 1, histories.time[701]);
  EXPECT_EQ(at.x(), histories.x[0](1, 700));
  EXPECT_EQ(at.z(), histories.rotation[0](1, 700));
  const double middle = 0.5 * (histories.time[700] + histories.time[701]);
  EXPECT_LE((floor_motion(histories, 0, 1, middle) - 0.5 * (at + next)).norm(), 1e-15);
  const PlanPoint corner = movement_of(run.problem.buildings[0].model, 1, {12, 18}, at);
  EXPECT_NEAR(corner.x(), at.x() - 9 * at.z(), 1e-15);
  EXPECT_NEAR(corner.y(), at.y() + 6 * at.z(), 1e-15);
}

TEST(PlanPictures, HistoriesAreThoseOfTheRun) {
  const PlanRun& run = twisting();
  FigureOptions window;
  window.from = 0;
  window.to = 15;
  const Figure moves = make_figure(run, "displacement", window);
  ASSERT_EQ(moves.panels.size(), 3U);
  const auto most = [](const std::vector<double>& values) {
    double found = 0;
    for (const double value : values) found = std::max(found, std::abs(value));
    return found;
  };
  const PlanPeaks& peaks = run.response.buildings[0];
  EXPECT_NEAR(most(moves.panels[0].curves[0].y), peaks.x(1), 1e-3 * peaks.x(1));
  EXPECT_NEAR(most(moves.panels[1].curves[0].y), peaks.y(1), 1e-3 * peaks.y(1));
  EXPECT_NEAR(most(moves.panels[2].curves[0].y), 1e3 * peaks.rotation(1), peaks.rotation(1));
  for (int floor = 0; floor < 2; ++floor) {  // the course holds extrema themselves
    const PlanHistories& course = run.response.course;
    EXPECT_NEAR(course.x[0].row(floor).cwiseAbs().maxCoeff(), peaks.x(floor), 1e-9 * peaks.x(floor));
    EXPECT_NEAR(course.rotation[0].row(floor).cwiseAbs().maxCoeff(), peaks.rotation(floor),
                1e-9 * peaks.rotation(floor));
  }
  EXPECT_EQ(moves.panels[0].events.x.size(), 6U);
  // The force reaches the peak of the run, though no sample does.
  const Figure force = make_figure(run, "force", window);
  ASSERT_EQ(force.panels.size(), 1U);
  EXPECT_NEAR(most(force.panels[0].curves[0].y), run.response.points[3].peak_force, 1e-9);
  EXPECT_EQ(make_figure(run, "opening").panels.front().curves.size(), 2U);
}

/// The area under the force of an impact is its impulse: straight lines between places of the course leave the force by
/// no more than 2.5e-4 of its largest.
TEST(PlanPictures, TheAreaUnderAForceIsItsImpulse) {
  for (const PlanRun& run : {twisting(), test::plan_run(test::twisting_pair(", friction = 0.3"), 0.01)}) {
    int seen = 0;
    for (const Impact& impact : run.response.impacts) {
      if (!(impact.impulse > 1e-3 * run.response.points[impact.point].impulse)) continue;
      const PlanHistories& course = run.response.course;
      double area = 0;
      for (std::size_t i = 1; i < course.time.size(); ++i) {
        const double from = course.time[i - 1], to = course.time[i];
        if (from < impact.start - 1e-12 || to > impact.end + 1e-12) continue;
        const auto k = static_cast<Eigen::Index>(i);
        area += (to - from) * (course.force(impact.point, k - 1) + course.force(impact.point, k)) / 2;
      }
      EXPECT_NEAR(area, impact.impulse, 1e-3 * impact.impulse) << impact.start;
      ++seen;
    }
    EXPECT_GT(seen, 5);
  }
  // As it is drawn, with the peak of the run, though no sample has it.
  FigureOptions window;
  window.from = 0;
  window.to = 15;
  const PlanRun coarse = test::plan_run(test::twisting_pair(), 0.01);
  const Curve drawn = make_figure(coarse, "force", window).panels.front().curves.front();
  double area = 0;
  for (std::size_t i = 1; i < drawn.x.size(); ++i) {
    area += (drawn.x[i] - drawn.x[i - 1]) * (drawn.y[i] + drawn.y[i - 1]) / 2;
  }
  double impulse = 0;
  for (const Impact& impact : coarse.response.impacts) impulse += impact.point == 3 ? impact.impulse : 0;
  EXPECT_NEAR(area, impulse, 1e-3 * impulse);
}

/// Samples pass peaks by; what is written at a peak is that of the run, between two of them.
TEST(PlanPictures, WithoutACoursePeaksAreThoseOfTheRun) {
  PlanRun sampled = test::plan_run(test::twisting_pair(), 0.05);
  const Figure exact = make_figure(sampled, "displacement");
  sampled.response.course = {};
  const Figure figure = make_figure(sampled, "displacement");
  EXPECT_EQ(figure.finding, exact.finding);
  std::set<std::string> known, shown;
  for (const Panel& panel : exact.panels) {
    for (const PlaceText& text : panel.texts) known.insert(text.text);
  }
  for (const Panel& panel : figure.panels) {
    for (const PlaceText& text : panel.texts) {
      shown.insert(text.text);
      EXPECT_TRUE(known.count(text.text) > 0) << text.text;
      double peak = text.y;  // or where a line from there ends
      for (const Curve& one : panel.curves) peak = one.label.empty() && one.y[1] == text.y ? one.y[0] : peak;
      const auto holds = [&](const Curve& curve) {
        return !curve.label.empty() && std::count(curve.y.begin(), curve.y.end(), peak) > 0;
      };
      EXPECT_TRUE(std::any_of(panel.curves.begin(), panel.curves.end(), holds)) << "the curve has its peak there";
    }
  }
  EXPECT_FALSE(shown.empty());
}

/// Where no course is kept, no force is drawn that was not computed: each impact by its peak.
TEST(PlanPictures, WithoutACourseForcesAreTheirPeaks) {
  PlanRun run = twisting();
  run.response.course = {};
  FigureOptions window;
  window.from = 0;
  window.to = 3;
  const Curve drawn = make_figure(run, "force", window).panels.front().curves.front();
  EXPECT_EQ(drawn.line, Line::none);
  for (const double force : drawn.y) {
    const auto& all = run.response.impacts;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Impact& one) { return one.peak_force == force; }));
  }
}

TEST(PlanPictures, FrictionStaysWithinItsCone) {
  const Figure figure = make_figure(twisting(), "friction-cone");
  const Curve& path = labelled(figure.panels.front(), "samples in contact");
  std::size_t slides = 0;
  for (std::size_t i = 0; i < path.x.size(); ++i) {
    if (std::isnan(path.x[i])) continue;
    EXPECT_LE(std::abs(path.y[i]), 0.3 * path.x[i] * (1 + 1e-9));
    slides += std::abs(path.y[i]) > 0.3 * path.x[i] * (1 - 1e-9) ? 1 : 0;
  }
  EXPECT_GE(slides, 10U);
}

}  // namespace
}  // namespace bentur
