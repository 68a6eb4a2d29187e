#include "bentur/model/closer/frame_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/kinds.h"
#include "tests/support/column_case.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"

namespace bentur {
namespace {

using Eigen::Index;

/// Elastic frames on soil, on bearings that stand on soil, and calibrated to a period.
constexpr const char* supported = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.8, displacement_amplitude = 0.05 }
analysis = { duration = 3.0 }
[[building]]
name = "Soil"
damping = 0.03
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3.5, 3.0, 3.0]
bay_widths = [6.0, 4.0]
columns = [{ width = 0.3, depth = 0.4, density = 2.5 }]
beams = [{ width = 0.3, depth = 0.4, density = 2.5 }]
floor_masses = [40.0, 40.0, 30.0]
[building.soil]
half_space = { shear_wave_velocity = 150.0, density = 1.9, poisson = 0.33, radius = 4.0 }
foundation = { mass = 80.0, inertia = 600.0 }
[[building]]
name = "Bearings"
damping = 0.03
calibrate_period = 0.5
isolation = { mass = 60.0, stiffness = 2e4 }
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3.5, 3.0, 3.0]
bay_widths = [5.0]
columns = [{ width = 0.3, depth = 0.4, density = 2.5 }]
beams = [{ width = 0.3, depth = 0.4, density = 2.5 }]
floor_masses = [40.0, 40.0, 30.0]
[[gap]]
between = ["Soil", "Bearings"]
width = 0.03
contact = { law = "linear", stiffness = 2e5 }
)";

/// Two frames of ten storeys and one bay.
constexpr const char* slender_frames = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.8, displacement_amplitude = 0.05 }
analysis = { duration = 2.0 }
[[building]]
name = "Left"
damping = 0.03
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3, 3, 3, 3, 3, 3, 3, 3, 3, 3]
bay_widths = [5.0]
columns = [{ width = 0.3, depth = 0.4, density = 2.5 }]
beams = [{ width = 0.3, depth = 0.4, density = 2.5 }]
floor_masses = 20.0
[[building]]
name = "Right"
damping = 0.03
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3, 3, 3, 3, 3, 3, 3, 3, 3, 3]
bay_widths = [5.0]
columns = [{ width = 0.3, depth = 0.6, density = 2.5 }]
beams = [{ width = 0.3, depth = 0.4, density = 2.5 }]
floor_masses = 20.0
[[gap]]
between = ["Left", "Right"]
width = 0.03
contact = { law = "linear", stiffness = 2e5 }
)";

double sum_of_columns(const FrameForces& frame, Index storey, double height) {
  double sum = 0;
  for (Index n = 0; n < std::ssize(frame.members); ++n) {
    const FrameMember& member = frame.members[n];
    const bool is_cut = !member.of_beam && member.level == storey + 1 && member.from < height && member.to > height;
    if (is_cut) sum += frame.instant.shears(n);
  }
  return sum;
}

/// The solver has the shear of a storey from all that acts above it, M ẍ and contact; columns carry as much.
TEST(FrameForces, ColumnsCarryTheShearOfTheStorey) {
  for (const char* text : {supported, test::hinged}) {
    const RunResults run = test::drawn_run(text, 5e-4);  // samples at the instants of the dense run
    ASSERT_FALSE(run.response.impacts.empty());
    ASSERT_EQ(run.figures.frames.size(), 2U);
    const std::vector<double>& time = run.response.histories.time;
    for (const FrameForces& frame : run.figures.frames) {
      const StructuralModel& model = run.problem.buildings[frame.building].model;
      const Index column = std::lower_bound(time.begin(), time.end(), frame.time - 1e-9) - time.begin();
      const auto shears = run.response.histories.storey_shear[frame.building].col(column);
      double level = 0;
      for (Index storey = 0; storey + model.first_storey() < model.floors(); ++storey) {
        const Index floor = storey + model.first_storey();
        const double expected = shears(floor), just_above_its_foot = level + 0.001 * model.storey_heights[floor];
        level += model.storey_heights[floor];
        EXPECT_NEAR(sum_of_columns(frame, storey, just_above_its_foot), expected,
                    1e-6 * run.response.buildings[frame.building].storey_shear.maxCoeff())
            << run.problem.buildings[frame.building].name << ", storey " << storey;
      }
    }
  }
}

/// Of hinges the solver knows the moment by their own law and rows, and its peak between all samples.
TEST(FrameForces, MomentsAreThoseOfTheHinges) {
  const RunResults run = test::drawn_run(test::hinged);
  for (const FrameForces& frame : run.figures.frames) {
    const Hinges& hinges = run.problem.buildings[frame.building].model.hinges;
    const std::vector<BuildingPeaks::Hinge>& peaks = run.response.buildings[frame.building].hinges;
    ASSERT_EQ(peaks.size(), hinges.places.size());
    int yielded = 0;
    for (std::size_t h = 0; h < peaks.size(); ++h) {
      const HingePlace& place = hinges.places[h];
      const bool second = place.end == HingePlace::End::top || place.end == HingePlace::End::right ||
                          place.end == HingePlace::End::node;
      Index at = -1;
      for (Index n = 0; n < std::ssize(frame.members); ++n) {
        const FrameMember& member = frame.members[n];
        const bool same =
            member.of_beam == place.of_beam && member.level == place.level && member.number == place.number;
        // Of pieces of a struck column the lowest has the bottom and the node, the highest the top.
        if (same && (at < 0 || place.end == HingePlace::End::top)) at = n;
      }
      ASSERT_GE(at, 0);
      const Index station = second ? 4 : 0;
      const double largest = std::max(frame.most.moments(station, at), -frame.least.moments(station, at));
      EXPECT_NEAR(largest, peaks[h].peak_moment, 1e-3 * peaks[h].peak_moment);
      yielded += peaks[h].first_yield.has_value() ? 1 : 0;
    }
    EXPECT_GT(yielded, 0);
  }
}

/// Of a column that is struck the solver has its own peaks at the ends of both pieces.
TEST(FrameForces, PiecesOfAStruckColumnAreThoseOfTheSolver) {
  const RunResults run = test::drawn_run(test::hinged);
  int compared = 0;
  for (const FrameForces& frame : run.figures.frames) {
    const StructuralModel& model = run.problem.buildings[frame.building].model;
    for (Index node = 0; node < model.nodes(); ++node) {
      const double height = model.node_elevations[node] - (model.elevations[0] - model.storey_heights[0]);
      const auto peaks = run.response.buildings[frame.building].column_forces.segment<6>(6 * node);
      const auto alone = run.response.buildings[frame.building].column_forces_no_contact.segment<6>(6 * node);
      for (Index n = 0; n < std::ssize(frame.members); ++n) {
        const FrameMember& member = frame.members[n];
        const bool below = std::abs(member.to - height) < 1e-9, above = std::abs(member.from - height) < 1e-9;
        if (member.of_beam || !(below || above)) continue;
        const double with = std::max(frame.most.shears(n), -frame.least.shears(n));
        const double without = std::max(frame.most_without_contact.shears(n), -frame.least_without_contact.shears(n));
        EXPECT_NEAR(with, peaks(below ? 0 : 1), 2e-3 * with);
        EXPECT_NEAR(without, alone(below ? 0 : 1), 2e-3 * without);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 2);
}

/// The line around the diagrams of all columns of a frame at the instant, or of all beams; nullptr without one.
const Curve* outline_of(const FrameForces& frame, const Panel& panel, bool of_beams) {
  const std::size_t of_member = std::size(MemberForces::stations) + 3;
  const auto members = std::count_if(frame.members.begin(), frame.members.end(),
                                     [&](const FrameMember& member) { return member.of_beam == of_beams; });
  const double place = of_beams ? frame.members.back().place : frame.members.front().place;
  for (const Curve& curve : panel.curves) {
    if (!curve.top.empty() || curve.x.size() != of_member * static_cast<std::size_t>(members)) continue;
    if ((of_beams ? curve.y[curve.y.size() - of_member] : curve.x.front()) == place) return &curve;
  }
  return nullptr;
}

/// One scale for all members of all frames at the instant, the largest of columns at most 0.45 of the shortest bay, of
/// beams of the shortest storey: the moments at the stations, right of columns and below beams.
TEST(FrameForces, PicturesDrawThemToOneScale) {
  const RunResults run = test::drawn_run(test::hinged);
  const Figure figure = make_figure(run, "frame-moment");
  ASSERT_EQ(figure.panels.size(), 2 * run.figures.frames.size());
  const PanelPlace first = placed_figure(figure, "").panels.front();
  double scale = 0, largest = 0, fullest = 0;  // the last of the room that a frame has for its largest
  for (std::size_t f = 0; f < run.figures.frames.size(); ++f) {
    const FrameForces& frame = run.figures.frames[f];
    const std::size_t of_member = std::size(MemberForces::stations) + 3;  // back to the member at either end, and a gap
    const Curve* const drawn[] = {outline_of(frame, figure.panels[2 * f], false),
                                  outline_of(frame, figure.panels[2 * f], true)};
    ASSERT_TRUE(drawn[0] != nullptr && drawn[1] != nullptr);
    std::size_t place[] = {0, 0};  // of the next column and beam
    double in_columns = 0, in_beams = 0, bay = 1e9, storey = 1e9, most = 0;
    const StructuralModel& model = run.problem.buildings[frame.building].model;
    for (Index k = model.first_storey(); k < model.floors(); ++k) storey = std::min(storey, model.storey_heights[k]);
    for (std::size_t n = 0; n < frame.members.size(); ++n) {
      const FrameMember& member = frame.members[n];
      if (member.of_beam) bay = std::min(bay, member.length());
      const Curve& outline = *drawn[member.of_beam ? 1 : 0];
      const std::size_t first_of_it = of_member * place[member.of_beam ? 1 : 0]++;
      for (std::size_t k = 0; k < std::size(MemberForces::stations); ++k) {
        const double x = outline.x[first_of_it + 1 + k], y = outline.y[first_of_it + 1 + k];
        const double offset = member.of_beam ? member.place - y : x - member.place;
        const double moment = frame.instant.moments(static_cast<Index>(k), static_cast<Index>(n));
        if (scale == 0 && std::abs(moment) > 10) scale = offset / moment;
        EXPECT_NEAR(offset, scale * moment, scale > 0 ? 1e-9 : 10) << n << ", " << k;
        double& of_kind = member.of_beam ? in_beams : in_columns;
        of_kind = std::max(of_kind, std::abs(moment));
        most = std::max(most, std::abs(frame.most.moments(static_cast<Index>(k), static_cast<Index>(n))));
        most = std::max(most, std::abs(frame.least.moments(static_cast<Index>(k), static_cast<Index>(n))));
      }
    }
    EXPECT_GT(scale, 0);
    largest = std::max({largest, in_columns, in_beams});
    fullest = std::max({fullest, scale * in_columns / (0.45 * bay), scale * in_beams / (0.45 * storey)});
    const PanelPlace picture = placed_figure(figure, "").panels[2 * f];
    const double one_cm = 96 / 2.54 * (picture.x.second - picture.x.first) / picture.width;
    EXPECT_NEAR(one_cm, 96 / 2.54 * (first.x.second - first.x.first) / first.width, 1e-9) << "frames as well";
    const std::string& name = run.problem.buildings[frame.building].name;
    EXPECT_NE(figure.finding.find(name + ": largest moment " + number(most) + " kN·m"), std::string::npos)
        << figure.finding;
  }
  EXPECT_NEAR(fullest, 1, 1e-9);
  // A bar below the first frame is as long as the number beside it is drawn, which some moment reaches.
  const PlaceText& bar = figure.panels.front().texts.front();
  EXPECT_NEAR(bar.x, scale * std::stod(bar.text), 1e-9) << bar.text;
  EXPECT_TRUE(bar.text.ends_with(" kN·m") && bar.y < 0);
  EXPECT_LE(std::stod(bar.text), largest);
  EXPECT_GT(std::stod(bar.text), largest / 2.5);
}

/// Diagrams of forces of less than a fifth of another building's have a scale of their own, which the titles say, with
/// a bar that some force of that building reaches; all others have one.
TEST(FrameForces, SmallOnesHaveTheirOwnScale) {
  std::string text = supported;
  const std::size_t second = text.find("name = \"Bearings\"");
  for (const char* const part :
       {"0.3, depth = 0.4, density = 2.5 }]\nbeams", "0.3, depth = 0.4, density = 2.5 }]\nfloor"}) {
    const std::size_t at = text.find(part, second);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 16, "0.1, depth = 0.1");
  }
  text.replace(text.find("calibrate_period = 0.5\n"), 23, "");
  text.replace(text.find("[40.0, 40.0, 30.0]", second), 18, "[1.0, 1.0, 1.0]");
  const RunResults run = test::drawn_run(text);
  ASSERT_EQ(run.figures.frames.size(), 2U);
  std::vector<double> most;  // of each panel
  for (const FrameForces& frame : run.figures.frames) {
    most.push_back(frame.instant.moments.cwiseAbs().maxCoeff());
    most.push_back(0);
    for (const FrameForces::Forces* one :
         {&frame.most, &frame.least, &frame.most_without_contact, &frame.least_without_contact}) {
      most.back() = std::max(most.back(), one->moments.cwiseAbs().maxCoeff());
    }
  }
  ASSERT_TRUE(most[2] < 0.1 * most[0] && most[3] < 0.1 * most[1]);
  const Figure figure = make_figure(run, "frame-moment");
  ASSERT_EQ(figure.panels.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(figure.panels[i].title.ends_with(", own scale"), i >= 2) << figure.panels[i].title;
    const std::vector<PlaceText>& texts = figure.panels[i].texts;
    const auto with_unit =
        std::count_if(texts.begin(), texts.end(), [](const PlaceText& one) { return one.text.ends_with(" kN·m"); });
    ASSERT_EQ(with_unit, 1) << "a bar of each scale";
    const double value = std::stod(figure.panels[i].texts.front().text);
    EXPECT_TRUE(value <= most[i] && value > most[i] / 2.5) << value << " of " << most[i];
  }
  for (const Panel& panel : make_figure(test::drawn_run(supported), "frame-moment").panels) {
    EXPECT_FALSE(panel.title.ends_with(", own scale")) << panel.title;
  }
}

/// On a telephone one below another, as wide as it is.
TEST(FrameForces, AreDrawnNarrowToo) {
  FigureOptions options;
  options.narrow = true;
  const Figure figure = make_figure(test::drawn_run(test::hinged), "frame-moment", options);
  EXPECT_EQ(figure.columns, 1);
  EXPECT_EQ(figure.width, column_width);
  EXPECT_EQ(make_figure(test::drawn_run(supported), "floor-spectrum", options).width, column_width);
}

TEST(FrameForces, SpectraOfFloorsAreDrawnInG) {
  const RunResults run = test::drawn_run(supported);
  const Figure figure = make_figure(run, "floor-spectrum");
  const FloorSpectra& spectra = run.figures.floor_spectra;
  ASSERT_EQ(figure.panels.size(), spectra.floors.size());
  for (std::size_t i = 0; i < spectra.floors.size(); ++i) {
    const std::vector<Curve>& curves = figure.panels[i].curves;
    ASSERT_EQ(curves.size(), 2U);
    for (std::size_t k = 0; k < spectra.periods.size(); ++k) {
      EXPECT_EQ(curves[0].x[k], spectra.periods[k]);
      EXPECT_NEAR(curves[1].y[k], spectra.floors[i].without_contact[k] / 9.80665, 1e-12);
      EXPECT_NEAR(curves[0].y[k], spectra.floors[i].with_contact[k] / 9.80665, 1e-12);
    }
  }
  EXPECT_NE(figure.finding.find("times that without contact"), std::string::npos);
}

TEST(FrameForces, SpectraSayWhichFloorsTheyAreOf) {
  FloorSpectra spectra{.periods = {0.03, 2}, .floors = std::vector<FloorSpectra::Floor>(6)};
  const std::vector<std::string> gaps = {"A | B", "B | C"};
  FigureOptions options;
  options.gap = 1;
  EXPECT_TRUE(floors_text(spectra, 0, gaps, {}, 3, options).starts_with("Shown is A | B, with the hardest impact"));
  options.gap = 0;
  EXPECT_EQ(floors_text(spectra, 0, gaps, {}, 3, options), "");
  EXPECT_EQ(floors_text(spectra, {}, gaps, {}, 12, {}), "Shown are roofs of 6 of 12 buildings, the first of the case");
  spectra.periods.front() = 0.175;
  EXPECT_EQ(floors_text(spectra, 0, gaps, {}, 3, options),
            "Periods begin at 0.175 s: of shorter ones samples are too far apart");
}

/// Numbers stand within the picture, on no line, no mark and no other number, as the picture is drawn; each beside its
/// dot, or joined to it by a line of at most two centimetres, as diagrams leave little room between columns.
void expect_numbers_are_free(const Panel& panel, const PanelPlace& place, const std::string& what) {
  constexpr double a_cm = 96 / 2.54;  // [px]
  const double scale = place.width / (place.x.second - place.x.first);
  const auto right = [&](double x) { return scale * (x - place.x.first); };
  const auto up = [&](double y) { return scale * (y - place.y.first); };
  const double high = 0.13 * a_cm;
  const auto box_of = [&](const PlaceText& text) {
    const double half = a_cm * text_width(text.text) / 2,
                 middle = right(text.x) + (text.side == PlaceText::Side::right ? half : 0);
    return Box{middle - half, middle + half, up(text.y) - high, up(text.y) + high};
  };
  for (const PlaceText& text : panel.texts) {
    const Box box = box_of(text);
    const std::string of = what + ": " + text.text;
    for (const PlaceText& other : panel.texts)
      EXPECT_FALSE(&other != &text && box.meets(box_of(other))) << of << ", " << other.text;
    if (text.side == PlaceText::Side::right) continue;  // of the bar below the frame
    EXPECT_GE(box.left, 0) << of;
    EXPECT_LE(box.right, place.width) << of;
    bool has_dot = false;
    for (const Curve& curve : panel.curves) {
      if (!curve.top.empty()) continue;
      if (curve.mark == Mark::disc) {
        const double x = right(curve.x.front()), y = up(curve.y.front());
        EXPECT_FALSE(x > box.left && x < box.right && y > box.bottom && y < box.top) << of << " on a dot";
        const double half = (box.right - box.left) / 2;
        const double across = std::abs(x - (box.left + box.right) / 2),
                     along = std::abs(y - (box.bottom + box.top) / 2);
        const double far = std::hypot(std::max(0.0, across - half), std::max(0.0, along - high));
        const bool is_beside = far < 0.35 * a_cm && (across < 0.85 * half + 0.1 * a_cm || along < 0.19 * a_cm);
        const bool is_joined = std::any_of(panel.curves.begin(), panel.curves.end(), [&](const Curve& line) {
          return line.x.size() == 2 && line.x[0] == curve.x[0] && line.y[0] == curve.y[0] &&
                 std::abs(right(line.x[1]) - (box.left + box.right) / 2) < half + 3 &&
                 std::abs(up(line.y[1]) - (box.bottom + box.top) / 2) < high + 4;
        });
        has_dot = has_dot || ((is_beside || is_joined) && far < 2 * a_cm);
      }
      for (std::size_t n = 1; n < curve.x.size(); ++n) {
        if (curve.line == Line::none || std::isnan(curve.x[n - 1]) || std::isnan(curve.x[n])) continue;
        EXPECT_FALSE(box.meets(right(curve.x[n - 1]), up(curve.y[n - 1]), right(curve.x[n]), up(curve.y[n]))) << of;
      }
    }
    EXPECT_TRUE(has_dot) << of;
  }
}

TEST(FrameForces, NumbersLieOnNoLineAndAtTheirDots) {
  const RunResults run = test::drawn_run(test::hinged);
  int looked_at = 0;
  for (const std::string kind : {"frame-forces", "frame-envelope", "frame-moment", "frame-shear", "frame-axial"}) {
    const Figure figure = make_figure(run, kind);
    const std::vector<PanelPlace> places = placed_figure(figure, "").panels;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string what = kind + ", panel " + std::to_string(i);
      const std::string& title = figure.panels[i].title;
      const bool is_of_moments =
          title.find(", M [") != std::string::npos && (kind != "frame-moment" || !title.ends_with(", largest"));
      EXPECT_GE(std::ssize(figure.panels[i].texts), is_of_moments ? 3 : 1) << what << ": of each storey";
      expect_numbers_are_free(figure.panels[i], places[i], what);
      ++looked_at;
    }
  }
  EXPECT_EQ(looked_at, 24);
}

/// The largest moment at the blow has its number and a red dot, which the legend names.
TEST(FrameForces, WhatAStruckColumnCarriesIsMarked) {
  const RunResults run = test::drawn_run(test::struck_columns);
  const Figure figure = make_figure(run, "frame-envelope");
  ASSERT_EQ(figure.panels.size(), 3 * run.figures.frames.size());
  for (const FrameForces& frame : run.figures.frames) {
    double most = 0;
    for (Index i = 0; i < std::ssize(run.problem.points); ++i) {
      const auto struck = struck_column(run.problem, run.problem.points[i]);
      if (!struck || struck->building != frame.building || run.response.points[i].impacts == 0) continue;
      for (Index n = 0; n < std::ssize(frame.members); ++n) {
        const FrameMember& member = frame.members[n];
        if (member.of_beam || std::abs(member.to - run.problem.points[i].elevation) > 1e-9) continue;
        const Index end = frame.most.moments.rows() - 1;
        most = std::max({most, frame.most.moments(end, n), -frame.least.moments(end, n)});
      }
    }
    ASSERT_GT(most, 0);
    const auto is_of = [&](const Panel& panel) {
      return panel.title == run.problem.buildings[frame.building].name + ", M [kN·m], largest";
    };
    const Panel& panel = *std::find_if(figure.panels.begin(), figure.panels.end(), is_of);
    const auto dot = std::find_if(panel.curves.begin(), panel.curves.end(), [](const Curve& one) {
      return one.label == "struck column, at the blow" && one.mark == Mark::disc && one.tone == Tone::red;
    });
    ASSERT_NE(dot, panel.curves.end()) << panel.title;
    EXPECT_TRUE(std::any_of(panel.texts.begin(), panel.texts.end(), [&](const PlaceText& one) {
      return one.text == short_number(most);
    })) << number(most);
  }
}

/// Frames that are wider than a third of a page have a row for moments, for shears and for axial forces, where both are
/// larger than three beside one another; slender ones have one each, as have more than two.
TEST(FrameForces, WideFramesHaveRowsOfTheirOwn) {
  const RunResults run = test::drawn_run(test::hinged);
  const Figure wide = make_figure(run, "frame-forces");
  EXPECT_EQ(wide.columns, 2);
  EXPECT_EQ(wide.width, page_width);
  const std::string first = run.problem.buildings[0].name, second = run.problem.buildings[1].name;
  const std::vector<std::string> titles = {first + ", M",  second + ", M", first + ", V",
                                           second + ", V", first + ", N",  second + ", N"};
  ASSERT_EQ(wide.panels.size(), titles.size());
  for (std::size_t i = 0; i < titles.size(); ++i) EXPECT_TRUE(wide.panels[i].title.starts_with(titles[i])) << i;
  EXPECT_EQ(make_figure(run, "frame-moment").columns, 2);
  const Figure slender = make_figure(test::drawn_run(slender_frames), "frame-forces");
  EXPECT_EQ(slender.columns, 3);
  EXPECT_TRUE(slender.panels[1].title.starts_with(slender.panels[0].title.substr(0, 4)));
}

/// The largest of the run both ways is an area between two lines of one tone, that without contact dashed around it.
TEST(FrameForces, EnvelopesAreBands) {
  const RunResults run = test::drawn_run(test::hinged);
  const Figure figure = make_figure(run, "frame-shear");
  const FrameForces& frame = run.figures.frames.front();
  const Panel& panel = figure.panels[1];
  std::vector<const Curve*> areas, lines, dashed;
  for (const Curve& curve : panel.curves) {
    if (!curve.top.empty()) areas.push_back(&curve);
    if (curve.top.empty() && curve.tone == Tone::black && curve.line == Line::solid && curve.x.size() > 8)
      lines.push_back(&curve);
    if (curve.line == Line::dashed) dashed.push_back(&curve);
  }
  ASSERT_TRUE(areas.size() == 2 && lines.size() == 2 && dashed.size() == 2) << "of beams and of columns";
  EXPECT_EQ(areas.front()->tone, Tone::pale);
  // The band of a beam is as high as the largest shears both ways are apart, by the scale of the bar.
  const auto beam =
      std::find_if(frame.members.begin(), frame.members.end(), [](const FrameMember& one) { return one.of_beam; });
  const Index n = beam - frame.members.begin();
  const PlaceText& bar = panel.texts.front();
  ASSERT_EQ(bar.side, PlaceText::Side::right);
  EXPECT_NEAR(std::abs(areas.front()->top[0] - areas.front()->y[0]),
              bar.x / std::stod(bar.text) * (frame.most.shears(n) - frame.least.shears(n)), 1e-9);
}

/// What is not known is not there: rotations with mass of their own, and columns that have slipped.
TEST(FrameForces, AreLeftOutWhereTheyAreNotKnown) {
  std::string text = supported;
  text.insert(text.find("[building.soil]"), "condensation = \"none\"\n");
  const RunResults run = test::drawn_run(text);
  ASSERT_EQ(run.figures.frames.size(), 1U);
  EXPECT_EQ(run.figures.frames.front().building, 1);
}

}  // namespace
}  // namespace bentur
