#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/structure/modes.h"
#include "tests/support/column_case.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"
#include "tests/support/kinds_case.h"

namespace bentur {
namespace {

/// Runs that several of these tests look at.
const RunResults& linked_run() {
  static const RunResults run = test::drawn_run(test::linked);
  return run;
}
const RunResults& supported_run() {
  static const RunResults run = test::drawn_run(test::every_kind);
  return run;
}
const RunResults& hinged_frames() {
  static const RunResults run = test::drawn_run(test::hinged);
  return run;
}
const RunResults& apart_run() {
  static const RunResults run = test::drawn_run(test::sticks_in_mm(5000, 3500));
  return run;
}

/// What a curve goes around, counted as often as it does; from its last point straight back to its first.
double area_of(const Curve& curve) {
  double area = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const std::size_t next = (i + 1) % curve.x.size();
    area += (curve.x[next] - curve.x[i]) * (curve.y[next] + curve.y[i]) / 2;
  }
  return area;
}

TEST(Pictures, AxesHaveTwoNumbersAtLeast) {
  for (const RunResults* run : {&linked_run(), &supported_run(), &hinged_frames(), &apart_run()}) {
    for (const FigureKind& kind : figure_kinds(*run)) {
      const Figure figure = make_figure(*run, kind.name);
      const Layout placing = layout(figure);
      for (const PlacedPanel& placed : placing.panels) {
        if (placed.panel->to_scale) continue;  // the buildings themselves
        EXPECT_TRUE(placed.y.labels.size() >= 2 || !placed.panel->y.names.empty()) << kind.name;
        EXPECT_GE(placed.x.labels.size(), 2U) << kind.name;
      }
    }
  }
}

TEST(Pictures, TheToneOfABuildingIsUsedForNothingElse) {
  for (const RunResults* run : {&linked_run(), &supported_run(), &hinged_frames(), &apart_run()}) {
    const std::vector<Building>& buildings = run->problem.buildings;
    std::size_t of_buildings = 0;
    for (const FigureKind& kind : figure_kinds(*run)) {
      const Figure figure = make_figure(*run, kind.name);
      for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
          for (std::size_t b = 0; b < 6; ++b) {
            if (curve.tone != building_tone(b)) continue;
            ASSERT_LT(b, buildings.size()) << kind.name;
            const bool is_named = (curve.label + panel.title).find(buildings[b].name) != std::string::npos;
            EXPECT_TRUE(is_named || panel.to_scale) << kind.name << ": " << curve.label << " of " << panel.title;
            ++of_buildings;
          }
        }
      }
    }
    EXPECT_GT(of_buildings, 5U);
  }
}

/// The number at a peak stands where its curve has it.
TEST(Pictures, ThePeakOfAForceIsWrittenWhereItIs) {
  for (const RunResults* run : {&linked_run(), &hinged_frames()}) {
    std::size_t found = 0;
    for (const Panel& panel : make_figure(*run, "force").panels) {
      for (const PlaceText& text : panel.texts) {
        ++found;
        const Curve& curve = panel.curves.front();
        const auto most = std::max_element(curve.y.begin(), curve.y.end());
        EXPECT_NEAR(text.y, *most, 1e-9 * *most);
        EXPECT_NEAR(text.x, curve.x[most - curve.y.begin()], 1e-6);
      }
    }
    EXPECT_EQ(found, 1U);
  }
}

TEST(Pictures, ThePeakOfADisplacementIsWrittenWhereItIs) {
  for (const RunResults* run : {&linked_run(), &hinged_frames(), &apart_run()}) {
    std::set<std::string> named;
    for (const Panel& panel : make_figure(*run, "displacement").panels) {
      for (const PlaceText& text : panel.texts) {
        double peak = text.y;
        for (const Curve& one : panel.curves) peak = one.label.empty() && one.y[1] == text.y ? one.y[0] : peak;
        for (const Curve& one : panel.curves) {
          double most = 0;
          for (const double y : one.y) most = std::max(most, std::abs(y));
          if (std::count(one.y.begin(), one.y.end(), peak) > 0 && most == std::abs(peak)) named.insert(one.label);
        }
        EXPECT_EQ(text.text.starts_with("−"), peak < 0);
      }
      const Layout placing = layout({.panels = {panel}});
      for (const PlaceText& text : panel.texts) {  // and within the frame
        const double at = along(placing.panels.front().y, text.y) * panel.height;
        EXPECT_GT(at + (text.side == PlaceText::Side::below ? -0.4 : 0), 0);
        EXPECT_LT(at + (text.side == PlaceText::Side::above ? 0.4 : 0), panel.height);
      }
    }
    named.erase("");
    EXPECT_EQ(named.size(), 2U);
  }
}

TEST(Pictures, CurvesAreToldApartInGrey) {
  for (const RunResults* run : {&linked_run(), &supported_run(), &hinged_frames(), &apart_run()}) {
    for (const FigureKind& kind : figure_kinds(*run)) {
      test::expect_told_apart_in_grey(make_figure(*run, kind.name), kind.name);
    }
  }
  // Neighbours are by their tones, so that their columns need no dashes; displacements over one another have them too.
  for (std::size_t b = 0; b < std::size(building_tones); ++b) {
    EXPECT_TRUE(are_distinct_in_grey(building_tone(b), building_tone(b + 1))) << b;
  }
  for (const Panel& panel : make_figure(hinged_frames(), "scene").panels) {
    for (const Curve& curve : panel.curves) EXPECT_NE(curve.line, Line::dashed) << curve.label;
  }
  const Panel together = make_figure(hinged_frames(), "displacement").panels.back();
  ASSERT_GE(together.curves.size(), 2U);
  EXPECT_EQ(together.curves[0].line, Line::solid);
  EXPECT_EQ(together.curves[1].line, Line::dashed);
}

TEST(Pictures, NoLineIsAHairline) {
  for (const RunResults* run : {&linked_run(), &supported_run(), &hinged_frames()}) {
    for (const FigureKind& kind : figure_kinds(*run)) {
      for (const Panel& panel : make_figure(*run, kind.name).panels) {
        for (const Curve& curve : panel.curves) EXPECT_GE(0.75 * curve.width, 0.5) << kind.name;  // [pt]
      }
    }
  }
}

/// Of one or two buildings, beside the periods.
TEST(Pictures, ModesSayTheirPartOfTheMass) {
  const RunResults& run = hinged_frames();
  const Figure figure = make_figure(run, "modes");
  ASSERT_EQ(figure.panels.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b) {
    const Eigen::VectorXd parts = modal_properties(run.problem.buildings[b]).effective_mass_fraction;
    for (std::size_t mode = 0; mode < figure.panels[b].curves.size(); ++mode) {
      const std::string part = std::to_string(std::lround(100 * parts(static_cast<Eigen::Index>(mode))));
      EXPECT_TRUE(figure.panels[b].curves[mode].label.ends_with(" s, " + part + " %"));
    }
  }
  EXPECT_EQ(figure.lacks, "");
}

TEST(Pictures, EnvelopesEndOnANumberAndHaveItsHalfOrItsQuarters) {
  int with_quarters = 0;
  for (const RunResults* run : {&linked_run(), &supported_run(), &apart_run()}) {
    const Figure figure = make_figure(*run, "envelope");
    const Layout placing = layout(figure);
    for (const PlacedPanel& placed : placing.panels) {
      EXPECT_TRUE(placed.x.labels.size() == 3 || placed.x.labels.size() == 5) << placed.x.labels.size();
      with_quarters += placed.x.labels.size() == 5 ? 1 : 0;
      EXPECT_EQ(placed.x.labels.front().second, "0");
      EXPECT_EQ(placed.x.labels.back().first, placed.x.to);
    }
  }
  EXPECT_GT(with_quarters, 0);
}

TEST(Pictures, ASpectrumReachesTheBuildingsPeriods) {
  RunResults run = test::drawn_run(test::linked);
  Building& building = run.problem.buildings.front();
  building.modes.omega *= 2 * M_PI / 7 / building.modes.omega(0);  // T₁ = 7 s
  std::vector<double> record(400);
  for (std::size_t i = 0; i < record.size(); ++i) record[i] = std::sin(0.3 * static_cast<double>(i));
  run.problem.motion = SampledMotion(0.02, record);
  run.figures = figure_data(run);
  const Figure figure = make_figure(run, "spectrum");
  bool found = false;
  for (const Panel& panel : figure.panels) {
    for (const Curve& curve : panel.curves) {
      if (curve.label != "T₁ of A") continue;
      found = true;
      EXPECT_GT(curve.y.front(), 0);
      EXPECT_LT(curve.x.front(), *panel.x.to);
    }
  }
  EXPECT_TRUE(found);
  EXPECT_NE(figure.finding.find("T₁ of A 7 s"), std::string::npos) << figure.finding;
}

/// From no penetration and no force, up as the force jumps, and back there.
TEST(Pictures, TheLoopOfAnImpactIsClosed) {
  const RunResults& run = linked_run();
  const Figure figure = make_figure(run, "loop");
  ASSERT_EQ(figure.panels.front().curves.size(), 2U);
  const Curve& closing = figure.panels.front().curves[0];
  const Curve& parting = figure.panels.front().curves[1];
  EXPECT_EQ(closing.x.front(), 0);
  EXPECT_EQ(closing.y.front(), 0);
  EXPECT_EQ(closing.x[1], 0);
  EXPECT_GT(closing.y[1], 0) << "a dashpot acts from the start on";
  EXPECT_EQ(closing.x.back(), parting.x.front());
  EXPECT_EQ(parting.x.back(), 0);
  EXPECT_EQ(parting.y.back(), 0);
  const Impact& impact = run.response.impacts.at(run.figures.close_up->impact);
  Curve whole = closing;
  whole.x.insert(whole.x.end(), parting.x.begin(), parting.x.end());
  whole.y.insert(whole.y.end(), parting.y.begin(), parting.y.end());
  const double factor = run.view().shown.force;
  EXPECT_NEAR(area_of(whole), factor * impact.energy_lost, 0.01 * factor * impact.energy_lost);
  EXPECT_NE(parting.label.find("% of the work lost"), std::string::npos);
  EXPECT_EQ(parting.label.find("e = "), std::string::npos) << "speeds are those of buildings that go on pushing";
  EXPECT_NE(figure.finding.find("e = "), std::string::npos);
}

/// One choice of the hardest place for all figures of a run, also where impacts have no force and the fastest counts.
TEST(Pictures, OfInstantImpactsAllFiguresShowTheFastest) {
  std::string text = test::sticks_in_mm(5, 3500);
  const std::string law = "law = \"linear\", stiffness = 4e5";
  text.replace(text.find(law), law.size(), "law = \"restitution\", restitution = 0.65");
  const RunResults run = test::drawn_run(text);
  const auto fastest =
      std::max_element(run.response.impacts.begin(), run.response.impacts.end(),
                       [](const Impact& a, const Impact& b) { return a.closing_speed < b.closing_speed; });
  ASSERT_NE(fastest, run.response.impacts.end());
  const std::string level = "level " + number(run.problem.points[fastest->point].elevation) + " mm";
  for (const char* const kind : {"overview", "scene", "displacement", "opening"}) {
    std::string titles;
    for (const Panel& panel : make_figure(run, kind).panels) titles += panel.title + "; ";
    EXPECT_NE(titles.find(level), std::string::npos) << kind << ": " << titles;
  }
}

/// Where hinges have taken most of the energy it is said, to those who do not see the picture too.
TEST(Pictures, TheFindingOnEnergyNamesYielding) {
  Diagnostics diagnostics;
  const Case c = *read_case_text(test::hinged, BENTUR_SOURCE_DIR "/examples/case.toml", diagnostics);
  Problem problem = make_problem(c);
  SolveOptions options = solve_options(c);
  options.output_step = 0.01;
  options.energy_audit = true;
  Response response = solve(problem, c.analysis.solver, options);
  const Figure figure = make_figure(run_results(c, std::move(problem), std::move(response)), "energy");
  const std::string word = "yielding ";
  const std::size_t at = figure.finding.find(word);
  ASSERT_NE(at, std::string::npos) << figure.finding;
  double drawn = NAN;
  for (const Curve& curve : figure.panels.front().curves) {
    if (curve.label == "yielding") drawn = curve.y.back();
  }
  EXPECT_NEAR(std::stod(figure.finding.substr(at + word.size())), drawn, 1e-3 * drawn) << figure.finding;
  EXPECT_GT(drawn, 0);
}

/// The second panel of forces spans the course of the hardest impact, and little more.
TEST(Pictures, AroundTheHardestImpactIsItsCourse) {
  const RunResults& run = linked_run();
  const Figure figure = make_figure(run, "force");
  ASSERT_EQ(figure.panels.size(), 2U);
  const Impact& hardest = *hardest_impact(run.response.impacts);
  const double length = hardest.end - hardest.start, from = *figure.panels[1].x.from, to = *figure.panels[1].x.to;
  EXPECT_TRUE(from < hardest.start && to > hardest.end);
  EXPECT_LT(to - from, 5 * length);
}

TEST(Pictures, AJumpOfTheForceIsUpright) {
  const Figure figure = make_figure(linked_run(), "impact");
  const Curve& force = figure.panels.at(1).curves.front();
  const auto start = std::find(force.x.begin(), force.x.end(), 0) - force.x.begin();
  EXPECT_EQ(force.x.at(start + 1), 0);
  EXPECT_EQ(force.y.at(start), 0);
  EXPECT_GT(force.y.at(start + 1), 0);
  const Impact& impact = linked_run().response.impacts.at(linked_run().figures.close_up->impact);
  const double length = 1e3 * (impact.end - impact.start);
  EXPECT_LT(*figure.panels[1].x.to - *figure.panels[1].x.from, 1.2 * length) << "little but the impact";
}

TEST(Pictures, StoreyShearIsOneValueAStorey) {
  const RunResults& run = linked_run();
  const Figure figure = make_figure(run, "forces");
  ASSERT_EQ(figure.panels.size(), 2U);
  const Curve& shear = figure.panels[1].curves.front();
  ASSERT_EQ(shear.x.size(), 4U);
  EXPECT_EQ(shear.x[0], shear.x[1]);
  EXPECT_EQ(shear.x[2], shear.x[3]);
  EXPECT_EQ(shear.y, (std::vector<double>{0, 4, 4, 7}));
  EXPECT_EQ(figure.panels[0].curves.front().y, (std::vector<double>{4, 7})) << "accelerations are those of floors";
}

TEST(Pictures, WithoutContactTheClosestApproachIsMarked) {
  const RunResults& run = apart_run();
  const Eigen::MatrixXd& opening = run.response.course.opening;
  const Figure figure = make_figure(run, "opening");
  const Curve& mark = figure.panels.back().curves.back();
  EXPECT_EQ(mark.label, "closest");
  EXPECT_EQ(mark.y.front(), opening.minCoeff());
  EXPECT_NE(figure.finding.find("closest approach: "), std::string::npos);
  const Figure displacements = make_figure(run, "displacement");
  EXPECT_NE(displacements.finding.find("closest approach: "), std::string::npos);
  ASSERT_FALSE(displacements.panels.back().rules.empty());
  EXPECT_EQ(displacements.panels.back().rules.back().at, mark.x.front());
  for (const FigureKind& kind : figure_kinds(run)) {
    EXPECT_NE(kind.name, "impact");
    EXPECT_NE(kind.name, "loop");
  }
  EXPECT_EQ(make_figure(linked_run(), "opening").finding.find("closest"), std::string::npos);
}

/// The area of a link's loop is what it dissipates, but for what its spring still holds.
TEST(Pictures, LoopsOfLinksHaveTheAreaThatIsDissipated) {
  const RunResults& run = linked_run();
  const double factor = run.view().shown.force;
  for (std::size_t i = 0; i < 2; ++i) {
    FigureOptions options;
    options.elevation = run.problem.links[i].elevation;
    const Figure figure = make_figure(run, "link-loop", options);
    const double dissipated = factor * run.response.links[i].energy_dissipated;
    ASSERT_GT(dissipated, 0);
    EXPECT_NEAR(area_of(figure.panels.front().curves.front()), dissipated, 0.02 * dissipated) << i;
  }
  const auto& peaks = run.response.links;
  const std::size_t hardest = peaks[0].peak_tension > peaks[1].peak_tension ? 0 : 1;
  EXPECT_NE(make_figure(run, "link-loop").panels.front().title.find(hardest == 0 ? "level 7 m" : "level 4 m"),
            std::string::npos);
}

TEST(Pictures, LoopsOfBearingsAndSoil) {
  const RunResults& run = supported_run();
  const Figure bearings = make_figure(run, "bearing-loop");
  ASSERT_EQ(bearings.panels.size(), 1U);
  EXPECT_EQ(bearings.panels[0].title, "Isolated, bearings");
  const Figure soil = make_figure(run, "soil-loop");
  ASSERT_EQ(soil.panels.size(), 2U);
  EXPECT_EQ(soil.panels[0].title, "Weak");
  const auto largest = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [](double a, double b) { return std::max(a, std::abs(b)); });
  };
  const Eigen::VectorXd& peaks = run.response.buildings[2].foundation;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(largest(soil.panels[i].curves[0].x), peaks(static_cast<Eigen::Index>(i)), 0.01 * peaks(i)) << i;
    EXPECT_GT(area_of(soil.panels[i].curves[0]), 0) << "dashpots dissipate";
  }
}

/// Newtons become kN where the largest force is 10⁴ N or more, other units stay.
TEST(Pictures, ForcesOfFiveDigitsInNewtonsAreInKilonewtons) {
  EXPECT_EQ(linked_run().view().shown.units.force, "kN");
  EXPECT_EQ(shown_units({.force = "N"}, 9999).units.force, "N");
  EXPECT_EQ(shown_units({.force = "N"}, 1e4).units.force, "kN");
  EXPECT_EQ(shown_units({.force = "kgf"}, 1e9).units.force, "kgf");
  const Figure figure = make_figure(linked_run(), "force");
  const std::vector<double>& forces = figure.panels.back().curves.front().y;
  const double peak = *std::max_element(forces.begin(), forces.end());
  double most = 0;
  for (const PointSummary& point : linked_run().response.points) most = std::max(most, point.peak_force);
  EXPECT_NEAR(peak, most / 1e3, 1e-6 * most);
  EXPECT_EQ(figure.panels.front().y.label, "Contact force F [kN]");
}

/// What the modes take from the spectrum of a case, at their own damping.
TEST(Pictures, ADesignSpectrumHasTheBuildingsOrdinates) {
  Diagnostics diagnostics;
  const Case c = read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/gaps/design-spectrum.toml", diagnostics).value();
  const Problem problem = make_still_problem(c);
  const SpectralGaps spectral = spectral_gaps(problem, *c.excitation.spectrum, c.code, c.units);
  const Figure figure = design_spectrum_figure(c, problem, spectral);
  ASSERT_EQ(figure.panels.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b) {
    const Curve& acceleration = figure.panels[0].curves.at(1 + b);
    const Curve& displacement = figure.panels[1].curves.at(1 + b);
    EXPECT_EQ(displacement.y.front(), spectral.modes[b].displacement(0));
    EXPECT_EQ(acceleration.label, "T₁ of " + problem.buildings[b].name);
    const double omega = problem.buildings[b].first_omega();
    EXPECT_NEAR(acceleration.y.front() * 9.80665, omega * omega * displacement.y.front(), 1e-9);
    EXPECT_GT(acceleration.x.back(), *figure.panels[0].x.from);
    EXPECT_NE(figure.finding.find(acceleration.label), std::string::npos);
  }
}

/// Thousands of impacts: the peak of each in place of courses that would fill the frame, and marks that stay apart.
TEST(Pictures, ManyImpactsDoNotFillTheFrame) {
  RunResults run = linked_run();
  const std::vector<Impact> few = run.response.impacts;
  const Impact hardest = few.at(run.figures.close_up->impact);
  for (const int many : {131, 2400}) {
    run.response.impacts.clear();
    for (int i = 0; i < many; ++i) {
      Impact one = hardest;
      one.start = 5.0 * i / many;
      one.end = one.peak_force_time = one.start + 1e-4;
      run.response.impacts.push_back(one);
    }
    const Figure figure = make_figure(run, "force");
    const Curve& peaks = figure.panels.front().curves.front();
    EXPECT_EQ(peaks.line, Line::none) << many;
    EXPECT_EQ(peaks.x.size(), static_cast<std::size_t>(many));
  }
  const Figure displacements = make_figure(run, "displacement");
  EXPECT_LE(displacements.panels.front().events.x.size(), 101U);
  EXPECT_GE(displacements.panels.front().events.x.size(), 50U);
  EXPECT_EQ(make_figure(linked_run(), "force").panels.front().curves.front().line, Line::solid);
}

/// Over the whole run none hides another; together they are around the hardest impact alone.
TEST(Pictures, EveryForceOfAColumnHasAPanelOfItsOwn) {
  std::string text = test::struck_columns;
  const std::string brief = "duration = 4.0";
  const RunResults run = test::drawn_run(text.replace(text.find(brief), brief.size(), "duration = 20.0"));
  for (const auto& [kind, forces] : {std::pair{"column-shear", 2U}, std::pair{"column-moment", 3U}}) {
    const Figure figure = make_figure(run, kind);
    ASSERT_EQ(figure.panels.size(), forces + 1) << kind;
    for (std::size_t i = 0; i < forces; ++i) EXPECT_EQ(figure.panels[i].curves.size(), 1U) << kind << i;
    EXPECT_EQ(figure.panels.back().curves.size(), forces) << kind;
  }
}

/// What was computed is seen beside the line through it, and there is one scale to each panel.
TEST(Pictures, AgainstTheGapTheNeedIsMarkedAndEveryPointSeen) {
  const GapCurve curve{.name = "A | B",
                       .widths = {0, 0.01, 0.02},
                       .forces = {900, 500, 0},
                       .amplifications = {1.4, 0.9, 1},
                       .given = 0.005,
                       .needed = 0.015,
                       .length = "m",
                       .force_unit = "kN"};
  const Figure figure = gap_curve_figure(curve);
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_NE(figure.finding.find("900 kN"), std::string::npos);
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.curves.size(), 1U) << "another quantity has a panel of its own";
    EXPECT_EQ(panel.curves[0].mark, Mark::disc) << "each point that was computed is seen";
    EXPECT_EQ(panel.curves[0].x, curve.widths);
    const auto at = [&](double width) {
      return std::any_of(panel.rules.begin(), panel.rules.end(), [&](const RuleLine& rule) {
        return rule.vertical && rule.at == width && !rule.label.empty();
      });
    };
    EXPECT_TRUE(at(curve.given) && at(*curve.needed));
    EXPECT_GE(*panel.x.to, 0.02);
  }
}

/// Two points in an empty frame tell nothing that a table does not.
TEST(Pictures, OfSingleFloorsThereIsNothingOverTheHeight) {
  const std::string text = R"(
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0], masses = [30.0], stiffnesses = [4e4] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3.0], masses = [30.0], stiffnesses = [9e4] }
[[gap]]
between = ["A", "B"]
width = 0.001
contact = { law = "linear", stiffness = 1e6 }
[excitation]
kind = "harmonic"
period = 0.2
displacement_amplitude = 0.02
[analysis]
duration = 2.0
)";
  std::size_t silent = 0;
  for (const FigureKind& kind : figure_kinds(test::drawn_run(text))) {
    for (const char* name : {"forces", "envelope", "amplification", "modes"}) {
      if (kind.name != name) continue;
      EXPECT_FALSE(kind.tells) << name;
      ++silent;
    }
  }
  EXPECT_GE(silent, 2U);
}

}  // namespace
}  // namespace bentur
