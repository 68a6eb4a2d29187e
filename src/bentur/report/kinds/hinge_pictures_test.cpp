#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "bentur/report/kinds/kinds.h"
#include "bentur/report/scene/scene.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"
#include "tests/support/kinds_case.h"

namespace bentur {
namespace {

const RunResults& hinged_run() {
  static const RunResults run = test::drawn_run(test::hinged);
  return run;
}
const RunResults& alone_run() {
  static const RunResults run = test::drawn_run(test::hinged_alone);
  return run;
}

std::size_t marks_labelled(const Panel& panel, const std::string& label) {
  std::size_t count = 0;
  for (const Curve& curve : panel.curves) count += curve.label == label ? curve.x.size() : 0;
  return count;
}

/// How many hinges of a building turn beyond its limit number `level`, from peaks alone.
std::size_t beyond(const RunResults& run, Eigen::Index b, Eigen::Index level) {
  std::size_t count = 0;
  const Eigen::MatrixXd& limits = run.problem.buildings[b].model.hinges.rotation_limits;
  for (Eigen::Index h = 0; h < limits.rows(); ++h) {
    count += run.response.buildings[b].hinges[h].peak_rotation > limits(h, level) ? 1 : 0;
  }
  return count;
}

TEST(HingePictures, AreColouredByLimitsAndNumberedByOrder) {
  const RunResults& run = hinged_run();
  const Figure figure = make_figure(run, "hinges");
  ASSERT_EQ(figure.panels.size(), 2U);
  std::size_t coloured = 0;
  for (Eigen::Index b = 0; b < 2; ++b) {
    const Panel& panel = figure.panels[b];
    const std::vector<std::vector<Eigen::Index>> order = hinge_order(run.response.buildings[b], run.problem.duration);
    ASSERT_GT(order.size(), 2U);
    const std::size_t cp = beyond(run, b, 2), ls = beyond(run, b, 1), io = beyond(run, b, 0);
    EXPECT_EQ(marks_labelled(panel, "beyond CP"), cp);
    EXPECT_EQ(marks_labelled(panel, "beyond LS"), ls - cp);
    EXPECT_EQ(marks_labelled(panel, "beyond IO"), io - ls);
    coloured += io;
    std::multiset<std::string> numbers, wanted;
    for (const PlaceText& one : panel.texts) numbers.insert(one.text);
    for (std::size_t group = 0; group < order.size(); ++group) {
      for (std::size_t k = 0; k < order[group].size(); ++k) wanted.insert(std::to_string(group + 1));
    }
    EXPECT_EQ(numbers, wanted);
    EXPECT_EQ(marks_labelled(panel, "has yielded"), wanted.size() - io);
    EXPECT_EQ(marks_labelled(panel, "has not yielded"), run.response.buildings[b].hinges.size() - wanted.size());
  }
  EXPECT_GT(coloured, 3U);
  EXPECT_NE(figure.finding.find("hinges form, the first at "), std::string::npos) << figure.finding;
}

TEST(HingePictures, ColumnsThatBreakAreCrossedFromThenOn) {
  std::string text = test::hinged_alone;
  const std::string capacity = "moment_capacity = 150.0";
  text.replace(text.find(capacity), capacity.size(), capacity + ", shear_capacity = [85.0, 110.0]");
  const RunResults run = test::drawn_run(text.c_str());
  const std::vector<BuildingPeaks::Breaking>& columns = run.response.buildings[0].columns;
  const std::vector<BreakingColumn>& known = run.problem.buildings[0].model.hinges.columns;
  ASSERT_EQ(columns.size(), known.size());
  std::size_t broken = 0;
  for (const BuildingPeaks::Breaking& column : columns) broken += column.break_time ? 1 : 0;
  ASSERT_GT(broken, 0U);
  EXPECT_EQ(marks_labelled(make_figure(run, "hinges").panels[0], "broken in shear"), broken);

  const Scene scene = scene_of(run.problem, run.response);
  ASSERT_EQ(scene.breaks.size(), broken);
  const SceneMotion rest = at_rest(run.response.histories);
  const ScenePlaces places(scene, 1, rest);
  for (const SceneBreak& one : scene.breaks) {
    EXPECT_EQ(one.time, *columns[one.column].break_time);
    const auto [x, y] = places(one.at);
    EXPECT_NEAR(y, 3.5 * (static_cast<double>(known[one.column].storey) - 0.5), 1e-9);
    EXPECT_NEAR(x, known[one.column].line == 1 ? 0 : scene.breadths[0], 1e-9);
  }
  const double shown = telling_instant(run.response).time;
  const auto by_then =
      std::count_if(scene.breaks.begin(), scene.breaks.end(), [&](const SceneBreak& one) { return one.time <= shown; });
  const Figure still = make_figure(run, "scene");
  EXPECT_EQ(std::ssize(still.panels), 1);
  EXPECT_EQ(marks_labelled(still.panels[0], "broken in shear"), static_cast<std::size_t>(by_then));
}

/// By one tone, as parts of the largest rotation say nothing about damage.
TEST(HingePictures, WithoutLimitsAreMarkedByTheLargestRotation) {
  const RunResults& run = alone_run();
  double largest = 0;
  for (const BuildingPeaks::Hinge& hinge : run.response.buildings[0].hinges) {
    largest = std::max(largest, hinge.peak_rotation);
  }
  std::size_t most = 0;
  for (const BuildingPeaks::Hinge& hinge : run.response.buildings[0].hinges) {
    most += hinge.peak_rotation > 0.75 * largest ? 1 : 0;
  }
  const Figure figure = make_figure(run, "hinges");
  std::size_t largest_ones = 0;
  for (const Curve& curve : figure.panels.at(0).curves) {
    if (curve.label.find(" mrad, 3/4 of the largest") != std::string::npos) largest_ones += curve.x.size();
    if (curve.mark != Mark::disc) continue;
    EXPECT_EQ(curve.tone, Tone::black) << curve.label;
  }
  EXPECT_EQ(largest_ones, most);
}

/// The scene shows what has formed by then, and no more.
TEST(HingePictures, OfAStillAreThoseThatHaveFormedByThen) {
  const RunResults& run = hinged_run();
  const Scene scene = scene_of(run.problem, run.response);
  const double instant = telling_instant(run.response).time;
  std::size_t formed = 0, drawn = 0;
  for (Eigen::Index b = 0; b < 2; ++b) {
    for (const BuildingPeaks::Hinge& hinge : run.response.buildings[b].hinges) {
      formed += hinge.first_yield && *hinge.first_yield <= instant ? 1 : 0;
    }
  }
  for (const char* kind : {"scene", "overview"}) {
    drawn = 0;
    const Figure figure = make_figure(run, kind);
    for (const Curve& curve : figure.panels.front().curves) {
      if (curve.label == "has yielded" || curve.label.starts_with("beyond ")) drawn += curve.x.size();
    }
    EXPECT_EQ(drawn, formed) << kind;
  }
  EXPECT_GT(formed, 0U);
}

/// Levels come one after the other, and as far as the peaks say.
TEST(HingePictures, LevelsAreThoseOfThePeaks) {
  for (const RunResults* run : {&hinged_run(), &alone_run()}) {
    const Scene scene = scene_of(run->problem, run->response);
    std::size_t all = 0;
    for (const BuildingPeaks& peaks : run->response.buildings) all += peaks.hinges.size();
    ASSERT_EQ(scene.hinges.size(), all);
    for (const SceneHinge& one : scene.hinges) {
      const BuildingPeaks::Hinge& hinge = run->response.buildings[one.building].hinges[one.hinge];
      EXPECT_EQ(one.order > 0, hinge.first_yield.has_value());
      EXPECT_TRUE(std::is_sorted(one.reached.begin(), one.reached.end()));
      if (hinge.first_yield) {
        EXPECT_EQ(one.reached[0], *hinge.first_yield);
      }
      const Eigen::MatrixXd& limits = run->problem.buildings[one.building].model.hinges.rotation_limits;
      for (int k = 0; k < 3; ++k) {
        const double bound =
            scene.bounds.are_limits ? limits(one.hinge, k) : HingeBounds::parts[k] * scene.bounds.largest;
        EXPECT_EQ(std::isfinite(one.reached[k + 1]), hinge.first_yield && hinge.peak_rotation > bound);
      }
    }
  }
}

/// Near the ends of their members, as at rest so in motion: on the lines that are drawn of these.
TEST(HingePictures, StandAtTheEndsOfTheirMembers) {
  const RunResults& run = hinged_run();
  const Scene scene = scene_of(run.problem, run.response);
  const SceneMotion rest = at_rest(run.response.histories);
  const ScenePlaces places(scene, 1, rest);
  const double faces[] = {0, scene.breadths[0] + scene.gaps[0]};
  const std::vector<double> lines[] = {{0, 6, 10}, {0, 5}}, levels[] = {{0, 3.5, 7}, {0, 4.4, 8.8}};
  std::size_t nodes = 0;
  for (const SceneHinge& one : scene.hinges) {
    const HingePlace& place = run.problem.buildings[one.building].model.hinges.places[one.hinge];
    const auto [x, y] = places(one.at);
    const std::vector<double>&line = lines[one.building], &level = levels[one.building];
    const double across = x - faces[one.building];
    using End = HingePlace::End;
    if (place.of_beam) {
      EXPECT_NEAR(y, level[place.level], 1e-12);
      const double end = line[place.number - (place.end == End::left ? 1 : 0)];
      EXPECT_NEAR(across, end + (place.end == End::left ? 1 : -1) * 0.15 * level[1], 1e-9);
    } else if (place.end == End::node) {
      ++nodes;
      EXPECT_NEAR(across, line[place.number - 1], 1e-9);
      EXPECT_NEAR(std::min(std::abs(y - 3.5), std::abs(y - 7)), 0, 1e-9) << "a floor of the other strikes there";
    } else {
      EXPECT_NEAR(across, line[place.number - 1], 1e-9);
      const double end = level[place.level - (place.end == End::bottom ? 1 : 0)];
      // Not beyond the middle of the piece between the struck place, at 3.5, and the floor.
      const bool is_short = one.building == 1 && place.level == 1 && place.number == 1 && place.end == End::top;
      const double clear = is_short ? (4.4 - 3.5) / 2 : 0.15 * level[1];
      EXPECT_NEAR(y, end + (place.end == End::bottom ? 1 : -1) * clear, 1e-9);
    }
  }
  EXPECT_EQ(nodes, 2U);
}

/// What is inside the loop of moment over rotation is what the hinge dissipated, with what its hardening stores.
TEST(HingePictures, TheLoopHasTheAreaOfTheEnergy) {
  for (const RunResults* run : {&hinged_run(), &alone_run()}) {
    const Figure figure = make_figure(*run, "hinge-loop");
    const Building& building = run->problem.buildings.front();
    const std::vector<BuildingPeaks::Hinge>& hinges = run->response.buildings.front().hinges;
    const auto worst = std::max_element(hinges.begin(), hinges.end(),
                                        [](const auto& a, const auto& b) { return a.peak_rotation < b.peak_rotation; });
    const Curve& loop = figure.panels.front().curves.front();
    double work = 0;
    for (std::size_t k = 1; k < loop.x.size(); ++k) {
      work += (loop.x[k] - loop.x[k - 1]) * (loop.y[k] + loop.y[k - 1]) / 2;
    }
    work /= 1e3 * run->view().shown.factor("F L");  // of mrad
    const double hardening = building.model.hinges.hardening(worst - hinges.begin());
    const double stored = hardening * worst->residual_rotation * worst->residual_rotation / 2;
    EXPECT_NEAR(work, worst->dissipated_energy + stored, 2e-3 * worst->dissipated_energy);
    EXPECT_GT(work, 0);
    EXPECT_NE(figure.finding.find(" mrad at the end; "), std::string::npos) << figure.finding;
  }
}

TEST(HingePictures, DriftsAreThoseOfTheResponse) {
  const RunResults& run = alone_run();
  const Figure figure = make_figure(run, "drift");
  ASSERT_EQ(figure.panels.size(), 2U);
  const BuildingPeaks& peaks = run.response.buildings[0];
  const std::vector<double> peak = figure.panels[0].curves.front().x, left = figure.panels[1].curves.front().x;
  ASSERT_EQ(peak.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(peak[k], 100 * peaks.drift_ratio(static_cast<Eigen::Index>(k / 2)), 1e-12);
    EXPECT_NEAR(left[k], 100 * peaks.yielding.residual_drift_ratio(static_cast<Eigen::Index>(k / 2)), 1e-12);
  }
  const RunResults elastic = test::drawn_run(test::sticks_in_mm(25, 3500));
  EXPECT_EQ(make_figure(elastic, "drift").panels.size(), 1U);
  for (const FigureKind& kind : figure_kinds(elastic)) EXPECT_FALSE(kind.name.starts_with("hinge"));
}

}  // namespace
}  // namespace bentur
