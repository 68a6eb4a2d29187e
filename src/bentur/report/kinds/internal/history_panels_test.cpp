#include "bentur/report/kinds/internal/history_panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/report/kinds/kinds.h"
#include "tests/support/column_case.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"

namespace bentur {
namespace {

/// Each panel over the whole run names what it shows, as its colour alone is no name.
TEST(HistoryPanels, PartsAreNamed) {
  std::string text = test::struck_columns;
  const std::string brief = "duration = 4.0";
  const RunResults run = test::drawn_run(text.replace(text.find(brief), brief.size(), "duration = 20.0"));
  const Figure figure = make_figure(run, "column-moment");
  ASSERT_EQ(figure.panels.size(), 4U);
  EXPECT_TRUE(figure.panels[0].title.ends_with(": bottom")) << figure.panels[0].title;
  EXPECT_EQ(figure.panels[1].title, "where struck");
  EXPECT_EQ(figure.panels[2].title, "top");
}

/// Peaks of few impacts, whose courses are not known, stand on stems from zero, each with its value.
TEST(HistoryPanels, FewPeaksStandOnStems) {
  std::vector<Impact> impacts(3);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    impacts[i].start = 1.0 + static_cast<double>(i);
    impacts[i].peak_force_time = impacts[i].start + 0.1;
    impacts[i].end = impacts[i].start + 0.2;
    impacts[i].peak_force = 100.0 - 10.0 * static_cast<double>(i);
  }
  const HistoryPlace place{.impacts = &impacts, .samples = {0, 5}, .whole = {0, 5}, .period = 3};
  const Figure figure = force_history_figure(place, {}, {}, {}, "F", 2);
  const Panel& panel = figure.panels.back();
  ASSERT_EQ(panel.curves.size(), 2U);
  const Curve &marks = panel.curves.front(), &stems = panel.curves.back();
  EXPECT_EQ(marks.line, Line::none);
  EXPECT_EQ(marks.y, (std::vector<double>{200, 180, 160}));
  for (std::size_t i = 0; i < marks.x.size(); ++i) {
    EXPECT_TRUE(stems.x.at(3 * i) == marks.x[i] && stems.x.at(3 * i + 1) == marks.x[i]);
    EXPECT_TRUE(stems.y.at(3 * i) == 0 && stems.y.at(3 * i + 1) == marks.y[i]);
  }
  ASSERT_EQ(panel.texts.size(), 2U) << "all but the largest, which has its unit too";
  EXPECT_EQ(panel.texts[0].text, "180");
  EXPECT_EQ(panel.texts[1].text, "160");
}

/// Samples of a run without its course have no corners: between them is what is known of the course to be there.
TEST(HistoryPanels, SamplesAreJoinedAsTheyMove) {
  const auto largest_turn = [](const Curve& curve, double from, double to) {
    double most = 0;
    for (std::size_t i = 1; i + 1 < curve.x.size(); ++i) {
      if (curve.x[i - 1] < from || curve.x[i + 1] > to) continue;
      const auto rate = [&](std::size_t k) { return (curve.y[k + 1] - curve.y[k]) / (curve.x[k + 1] - curve.x[k]); };
      most = std::max(most, std::abs(rate(i) - rate(i - 1)));
    }
    return most;
  };
  Curve samples;
  std::vector<double> rates;
  for (int i = 0; i <= 100; ++i) {
    samples.x.push_back(0.02 * i);
    samples.y.push_back(std::sin(20 * samples.x.back()));
    rates.push_back(20 * std::cos(20 * samples.x.back()));
  }
  const Curve fine = finer(samples, rates, {0.5, 1});
  EXPECT_LT(largest_turn(fine, 0.5, 1), 0.1 * largest_turn(samples, 0.5, 1));
  for (std::size_t i = 0; i < fine.x.size(); ++i) {
    EXPECT_NEAR(fine.y[i], std::sin(20 * fine.x[i]), 1e-4);
    EXPECT_TRUE(i == 0 || fine.x[i] > fine.x[i - 1]);
  }
  RunResults run = test::drawn_run(test::hinged, 0.02);
  run.response.course = {};
  const Panel panel = make_figure(run, "displacement").panels.back();
  EXPECT_GT(panel.curves.front().x.size(), 300U);
}

Figure energy_of(std::string text, const std::string& contact) {
  const std::size_t at = text.find("contact = {");
  text.replace(at, text.find('}', at) + 1 - at, contact);
  Diagnostics diagnostics;
  Case c = *read_case_text(text, BENTUR_SOURCE_DIR "/examples/case.toml", diagnostics);
  Problem problem = make_problem(c);
  SolveOptions options;
  options.output_step = 0.01;
  options.energy_audit = true;
  Response response = solve(problem, c.analysis.solver, options);
  return make_figure(run_results(std::move(c), std::move(problem), std::move(response)), "energy");
}

/// Of contact that loses nothing there is no line along zero, and the caption says so.
TEST(HistoryPanels, EnergyOfElasticContactHasNoLine) {
  const auto has_contact = [](const Figure& figure) {
    const std::vector<Curve>& curves = figure.panels.front().curves;
    return std::any_of(curves.begin(), curves.end(), [](const Curve& one) { return one.label == "contact"; });
  };
  const Figure elastic = energy_of(test::hinged, R"(contact = { law = "linear", stiffness = 2e5 })");
  EXPECT_FALSE(has_contact(elastic));
  EXPECT_EQ(elastic.lacks, "contact");
  const Figure lossy =
      energy_of(test::hinged, R"(contact = { law = "kelvin-voigt", stiffness = 2e5, restitution = 0.5 })");
  EXPECT_TRUE(has_contact(lossy));
  EXPECT_EQ(lossy.lacks, "");
}

}  // namespace
}  // namespace bentur
