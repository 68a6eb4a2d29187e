// What members of frames in plan carry, and spectra of floors there, by what the solver and a row know of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "tests/support/drawn_run.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

using Eigen::Index;

const std::string above = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.7, displacement_amplitude = 0.04 }
analysis = { duration = 3.0 }
)";
const std::string members = R"(elastic_modulus = 3e7
bay_widths = [6.0, 5.0]
columns = [{ width = 0.4, depth = 0.5 }]
beams = [{ width = 0.3, depth = 0.5 }]
)";

std::string frame_in_row(const std::string& name, double mass) {
  const std::string of = std::to_string(mass);
  return "[[building]]\nname = \"" + name + "\"\ndamping = 0.05\n[building.frame]\nstorey_heights = [3.5, 3.0]\n" +
         test::with(members, "depth = 0.5", "depth = 0.5, mass = 1e-9") + "floor_masses = [" + of + ", " + of + "]\n";
}

/// Two such frames along x, as far from the middle as each other, with the masses of both.
std::string frames_in_plan(const std::string& name, double mass, double left) {
  const std::string of = std::to_string(2 * mass);
  std::string text = "[[building]]\nname = \"" + name + "\"\ndamping = 0.05\n[building.plan]\ncorner = [" +
                     std::to_string(left) + ", 0]\nsize = [11.0, 10.0]\nstorey_heights = [3.5, 3.0]\nmasses = [" + of +
                     ", " + of + "]\n";
  for (const char* const at : {"0.0", "10.0"}) {
    text += std::string("[[building.plane]]\nname = \"at ") + at + "\"\nalong = \"x\"\nat = " + at +
            "\n[building.plane.frame]\n" + members;
  }
  for (const char* const at : {"3.0", "8.0"}) {
    text += std::string("[[building.plane]]\nname = \"y ") + at + "\"\nalong = \"y\"\nat = " + at +
            "\nstiffnesses = [90000.0, 90000.0]\n";
  }
  return text;
}

std::string gap(const std::string& stiffness, const std::string& width) {
  return "[[gap]]\nbetween = [\"A\", \"B\"]\n" + width + "contact = { law = \"linear\", stiffness = " + stiffness +
         " }\n";
}

PlanRun in_plan() {
  PlanRun run = test::plan_run(above + frames_in_plan("A", 60, 0) + frames_in_plan("B", 90, 11.02) + gap("4e5", ""));
  run.closer = dense_findings(run);
  return run;
}

/// A building whose frames are alike and do not twist is a row's with half of its masses, struck half as hard.
TEST(PlanFrames, AreThoseOfARowWhereNothingTwists) {
  const PlanRun plan = in_plan();
  const RunResults row =
      test::drawn_run(above + frame_in_row("A", 60) + frame_in_row("B", 90) + gap("2e5", "width = 0.02\n"));
  ASSERT_FALSE(row.response.impacts.empty());
  ASSERT_EQ(row.figures.frames.size(), 2U);
  ASSERT_EQ(plan.closer.frames.size(), 4U);
  for (std::size_t n = 0; n < 4; ++n) {
    const FrameForces &found = plan.closer.frames[n], &expected = row.figures.frames[n / 2];
    ASSERT_EQ(found.members.size(), expected.members.size());
    const auto near = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, const char* what) {
      // Both are extremes over samples of the same spacing; damping of plans is by the same two modes.
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 2e-3 * b.cwiseAbs().maxCoeff()) << what << " of frame " << n;
    };
    near(found.most.moments, expected.most.moments, "largest moments");
    near(found.least.moments, expected.least.moments, "least moments");
    near(found.most.shears, expected.most.shears, "shears");
    near(found.most_without_contact.moments, expected.most_without_contact.moments, "moments without contact");
  }
}

TEST(PlanFrames, SpectraOfFloorsAreThoseOfARowWhereNothingTwists) {
  const PlanRun plan = in_plan();
  const RunResults row =
      test::drawn_run(above + frame_in_row("A", 60) + frame_in_row("B", 90) + gap("2e5", "width = 0.02\n"));
  const FloorSpectra &found = plan.closer.floors, &expected = row.figures.floor_spectra;
  ASSERT_EQ(found.floors.size(), expected.floors.size());
  for (std::size_t i = 0; i < found.floors.size(); ++i) {
    EXPECT_EQ(found.floors[i].building, expected.floors[i].building);
    EXPECT_EQ(found.floors[i].floor, expected.floors[i].floor);
    EXPECT_LT((found.floors[i].along - Eigen::Vector2d::UnitX()).norm(), 1e-12);
    const auto at = [](const FloorSpectra& spectra, const std::vector<double>& values, double period) {
      const auto next = std::lower_bound(spectra.periods.begin(), spectra.periods.end(), period);
      return values.at(static_cast<std::size_t>(next - spectra.periods.begin()));
    };
    for (const double period : {0.04, 0.08, 0.2, 0.5, 1.0}) {
      const double with = at(expected, expected.floors[i].with_contact, period);
      // Next periods of both lists are at most 1.3 % apart, along slopes of less than twice the period's.
      EXPECT_NEAR(at(found, found.floors[i].with_contact, period), with, 0.04 * with) << period;
    }
  }
}

/// The solver has the largest shear of a plane between all samples; its columns carry it.
void expect_columns_carry(const std::string& text) {
  PlanRun run = test::plan_run(text);
  run.closer = dense_findings(run);
  const std::vector<PlanFramePlace> places = frames_with_members(run.c, run.problem);
  ASSERT_EQ(run.closer.frames.size(), places.size());
  const std::vector<double>& time = run.response.histories.time;
  int compared = 0;
  for (const FrameForces& frame : run.closer.frames) {
    const PlanFramePlace& place = places[frame.building];
    const PlanModel::Plane& plane = run.problem.buildings[place.building].model.planes[place.plane];
    const Eigen::VectorXd& peaks = run.response.buildings[place.building].planes[place.plane].shear;
    for (Index storey = 0; storey < peaks.size(); ++storey) {
      double most = 0, least = 0, whole = 0;  // all columns of a storey sway alike, so that their extremes are one's
      for (Index n = 0; n < std::ssize(frame.members); ++n) {
        const FrameMember& member = frame.members[n];
        if (member.of_beam || member.level != storey + 1) continue;
        most += frame.most.shears(n);
        least += frame.least.shears(n);
        whole += frame.instant.shears(n);
      }
      EXPECT_NEAR(std::max(most, -least), peaks(storey), 0.01 * peaks(storey)) << plane.name << ", storey " << storey;
      EXPECT_LE(std::abs(whole), 1.001 * peaks(storey));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8);
  EXPECT_FALSE(time.empty());
}

TEST(PlanFrames, ColumnsCarryTheShearOfThePlane) {
  const std::string text =
      test::with(above + frames_in_plan("A", 60, 0) + frames_in_plan("B", 90, 11.02) + gap("4e5", ""),
                 "along = \"x\"\nat = 0.0", "along = \"x\"\nat = 2.0");  // so that they twist
  expect_columns_carry(text);
  // Brought to a period that is not its own, with members as much softer.
  expect_columns_carry(test::with(text, "name = \"A\"\n", "name = \"A\"\ncalibrate_period = 0.5\n"));
}

/// Of both buildings the frame that carries most, in the building's colour, by what draws a row's; said how many are
/// not there. Only where there are frames.
TEST(PlanFrames, AreDrawnAsThoseOfARow) {
  const PlanRun run = in_plan();
  const RunResults row =
      test::drawn_run(above + frame_in_row("A", 60) + frame_in_row("B", 90) + gap("2e5", "width = 0.02\n"));
  for (const char* const kind : {"frame-moment", "frame-shear", "frame-axial"}) {
    const Figure found = make_figure(run, kind), expected = make_figure(row, kind);
    ASSERT_EQ(found.panels.size(), 4U) << kind;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(found.panels[i].curves.front().tone, expected.panels[i].curves.front().tone) << kind;
      ASSERT_EQ(found.panels[i].texts.size(), expected.panels[i].texts.size());
    }
    EXPECT_EQ(found.panels[0].title.substr(0, 9), "A, at 0.0") << found.panels[0].title;
    FigureOptions indonesian;
    indonesian.say = figure_words("id");
    EXPECT_NE(make_figure(run, kind, indonesian).finding.find("2 dari 4 portal"), std::string::npos);
    EXPECT_NE(found.finding.find("2 of 4 frames are shown"), std::string::npos) << found.finding;
  }
  const Figure spectra = make_figure(run, "floor-spectrum");
  for (const Panel& panel : spectra.panels) {
    EXPECT_NE(panel.title.find("along x"), std::string::npos) << panel.title;
    EXPECT_EQ(panel.curves.size(), 2U);
  }
  PlanRun springs = test::plan_run(test::twisting_pair());
  springs.closer = dense_findings(springs);
  EXPECT_THROW((void)make_figure(springs, "frame-moment"), NoFigure);
  EXPECT_FALSE(make_figure(springs, "floor-spectrum").panels.empty());
}

/// Columns that break slip, of which no history is kept: such a frame is left out, others of the building are not.
TEST(PlanFrames, LeaveOutThoseWhoseColumnsBreak) {
  PlanRun run = test::plan_run(test::hinged_pair());
  const std::vector<PlanFramePlace> places = frames_with_members(run.c, run.problem);
  ASSERT_EQ(places.size(), 1U);
  const PlanModel& model = run.problem.buildings[places[0].building].model;
  EXPECT_EQ(model.planes[places[0].plane].name, "middle");
  run.closer = dense_findings(run);
  ASSERT_EQ(run.closer.frames.size(), 1U);
  // Of hinges the solver knows the moment by their own law, and its peak between all samples.
  const FrameForces& frame = run.closer.frames.front();
  const Hinges& hinges = model.planes[places[0].plane].hinges;
  const auto& peaks = run.response.buildings[places[0].building].planes[places[0].plane].frame.hinges;
  ASSERT_EQ(peaks.size(), hinges.places.size());
  int compared = 0;
  for (std::size_t h = 0; h < peaks.size(); ++h) {
    const HingePlace& place = hinges.places[h];
    if (place.of_beam) continue;  // beams carry loads at rest besides
    for (Index n = 0; n < std::ssize(frame.members); ++n) {
      const FrameMember& member = frame.members[n];
      if (member.of_beam || member.level != place.level || member.number != place.number) continue;
      const Index station = place.end == HingePlace::End::top ? 4 : 0;
      const double largest = std::max(frame.most.moments(station, n), -frame.least.moments(station, n));
      EXPECT_GT(largest, 0.5 * peaks[h].peak_moment);
      EXPECT_LT(largest, 1.5 * peaks[h].peak_moment);
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace bentur
