// What the files of a run of buildings in plan hold, against the run and against one another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/files/result_reading.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/story/story.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

PlanRun twisting_pair(double output_step) { return test::plan_run(test::twisting_pair(), output_step); }

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

TEST(PlanNetcdf, HoldsTheRunAndItsHistories) {
  const PlanRun run = twisting_pair(0.001);
  ASSERT_EQ(run.response.status, Status::done) << run.response.message;
  const std::string bytes = histories_netcdf(run, "test");
  EXPECT_EQ(bytes, histories_netcdf(run, "test"));
  const NetcdfReader file(bytes, "histories.nc");
  const std::size_t times = file.dimension_size("time");
  EXPECT_EQ(times, 15001U);
  EXPECT_EQ(file.at("displacement_x_1").shape, (std::vector<std::size_t>{times, 2}));
  EXPECT_EQ(file.attribute("displacement_x_1", "units"), "m");
  EXPECT_EQ(file.at("ground_acceleration").shape, (std::vector<std::size_t>{times, 1}));  // along one axis
  EXPECT_NEAR(largest(file.numbers("ground_acceleration")), 3.4, 1e-3);
  EXPECT_EQ(file.attribute("rotation_2", "units"), "rad");
  EXPECT_EQ(file.texts("building_name"), (std::vector<std::string>{"Walled", "Frame"}));
  EXPECT_EQ(file.texts("plane_name_1"),
            (std::vector<std::string>{"south wall", "north frame", "west frame", "east frame"}));
  EXPECT_EQ(file.numbers("footprint_2"), (std::vector<double>{12.04, 0, 12.04 + 15, 18}));
  // The first building has planes, the second one none.
  const std::vector<PlanPeaks>& free = run.response.buildings_no_contact;
  const Eigen::VectorXd edges = free[1].edge_drift_ratio(), plane = free[0].planes[1].drift_ratio;
  EXPECT_EQ(file.numbers("peak_drift_ratio_no_contact_2"), std::vector<double>(edges.begin(), edges.end()));
  const std::vector<double> of_planes = file.numbers("plane_peak_drift_ratio_no_contact_1");
  EXPECT_EQ((std::vector<double>{of_planes[2], of_planes[3]}), std::vector<double>(plane.begin(), plane.end()));
  EXPECT_NE(file.numbers("peak_drift_ratio_no_contact_2"), file.numbers("peak_drift_ratio_2"));
  // Samples stay within the peaks of the continuous response, and come near.
  for (const auto& [history, peak] :
       {std::pair{"displacement_x_1", "peak_displacement_x_1"}, std::pair{"displacement_y_2", "peak_displacement_y_2"},
        std::pair{"rotation_1", "peak_rotation_1"}, std::pair{"acceleration_x_1", "peak_acceleration_x_1"},
        std::pair{"force", "peak_force"}, std::pair{"force_along", "peak_tangential_force"}}) {
    const double sampled = largest(file.numbers(history)), whole = largest(file.numbers(peak));
    EXPECT_LE(sampled, whole * (1 + 1e-12)) << history;
    EXPECT_GE(sampled, 0.97 * whole) << history;  // a sample every millisecond, impacts of 40
  }
  // The opening at a corner is what both floors move there, the slip likewise (P-1), (P-6).
  const std::vector<double> x_left = file.numbers("displacement_x_1"), y_left = file.numbers("displacement_y_1"),
                            turn_left = file.numbers("rotation_1"), x_right = file.numbers("displacement_x_2"),
                            y_right = file.numbers("displacement_y_2"), turn_right = file.numbers("rotation_2");
  const std::vector<double> opening = file.numbers("opening"), slip = file.numbers("slip"),
                            force = file.numbers("force"), along = file.numbers("force_along");
  const std::vector<double> y = file.numbers("point_y"), level = file.numbers("point_elevation");
  const std::size_t points = y.size();
  ASSERT_EQ(points, 4U);
  long slid = 0;
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t floor = 2 * t + (level[i] > 4 ? 1 : 0), at = t * points + i;
      const double closed =
          x_left[floor] - turn_left[floor] * (y[i] - 9) - (x_right[floor] - turn_right[floor] * (y[i] - 9));
      const double moved = y_left[floor] + 6 * turn_left[floor] - (y_right[floor] - 7.5 * turn_right[floor]);
      ASSERT_NEAR(opening[at], 0.04 - closed, 1e-14) << t;
      ASSERT_NEAR(slip[at], moved, 1e-14) << t;
      ASSERT_LE(std::abs(along[at]), 0.3 * force[at] * (1 + 1e-9)) << t;
      ASSERT_EQ(force[at] > 0, opening[at] < 0) << t;
      slid += force[at] > 0 && std::abs(along[at]) > 0.3 * force[at] * (1 - 1e-9) ? 1 : 0;
    }
  }
  EXPECT_GT(slid, 10);
  // Energies at the same instants.
  EXPECT_EQ(file.at("energy_input").shape, (std::vector<std::size_t>{times}));
  EXPECT_EQ(file.numbers("impact_point").size(), run.response.impacts.size());
  EXPECT_EQ(largest(file.numbers("impact_tangential_impulse")) > 0, true);
}

/// What the ground does along x and y is what a wall does, which the solver has followed.
TEST(PlanNetcdf, TheGroundAlongBothAxesIsThatOfAWall) {
  const TemporaryFolder folder;  // of another step than the first component
  std::ofstream record(folder.path() / "other.txt");
  for (int n = 0; n < 500; ++n) record << std::sin(0.11 * n) * std::exp(-0.004 * n) << "\n";
  record.close();
  const std::string other = "\n[excitation.y]\nkind = \"record\"\nfile = \"" + (folder.path() / "other.txt").string() +
                            "\"\nformat = \"one-column\"\nunit = \"m/s2\"\npga = 2.1\ntime_step = 0.017\n";
  for (const std::string& text : {test::twisting_pair(), test::twisting_pair() + other}) {
    const PlanRun run = test::plan_run(text + test::wall_beside, 0);
    ASSERT_EQ(run.response.status, Status::done) << run.response.message;
    const NetcdfReader file(histories_netcdf(run, "test"), "histories.nc");
    const double x = file.numbers("peak_ground_acceleration_x").at(0);
    const double y = file.numbers("peak_ground_acceleration_y").at(0);
    EXPECT_NEAR(file.numbers("peak_acceleration_x_3").at(0) / x, 1, 1e-12);
    EXPECT_NEAR(file.numbers("peak_acceleration_y_3").at(0) / y, 1, 1e-12);
    EXPECT_EQ(file.attribute("peak_ground_acceleration_y", "units"), "m s-2");
    if (text.ends_with(other)) continue;
    EXPECT_NEAR(x, 3.4 * std::cos(std::numbers::pi / 6), 1e-14);
    EXPECT_NEAR(y, 3.4 * 0.5, 1e-14);
  }
}

TEST(PlanNetcdf, WithoutSamplesHoldsWhatHasNoTime) {
  const NetcdfReader file(histories_netcdf(twisting_pair(0), "test"), "histories.nc");
  EXPECT_FALSE(file.has("displacement_x_1"));
  EXPECT_TRUE(file.has("peak_displacement_x_1"));
  EXPECT_TRUE(file.has("gap_needed") || file.has("point_gap_needed"));
}

TEST(PlanNetcdf, SamplesChangeNothing) {
  const PlanRun with = twisting_pair(0.01), without = twisting_pair(0);
  EXPECT_EQ(impacts_csv(with), impacts_csv(without));
  EXPECT_EQ(with.response.buildings[0].rotation, without.response.buildings[0].rotation);
}

/// Everything that is told of a run, files and sentences, is the same of what is read back.
void expect_read_back(PlanRun run) {
  run.c.source->copied = true;
  const TemporaryFolder folder;
  AtomicFiles files(folder.path());
  files.add("summary.json", summary_json(run, "0"), ResultKind::summary);
  files.add("histories.nc", histories_netcdf(run, "0"), ResultKind::histories);
  files.add("case.toml", run.c.source->text, ResultKind::case_copy);
  files.commit();
  PlanRun read = read_plan_results(folder.path());
  read.response.wall_time = run.response.wall_time;
  read.c.source->copied = true;
  EXPECT_EQ(impacts_csv(read), impacts_csv(run));
  EXPECT_EQ(summary_json(read, "0"), summary_json(run, "0"));
  EXPECT_EQ(histories_netcdf(read, "0"), histories_netcdf(run, "0"));
  const std::vector<Statement> told = run_story(run).statements, again = run_story(read).statements;
  ASSERT_EQ(again.size(), told.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    ASSERT_EQ(again[i].kind, told[i].kind);
    ASSERT_EQ(again[i].values.size(), told[i].values.size());
    for (std::size_t k = 0; k < told[i].values.size(); ++k) {
      EXPECT_EQ(again[i].values[k].value, told[i].values[k].value) << told[i].kind << " " << told[i].values[k].name;
    }
  }
}

TEST(PlanReading, WhatWasWrittenIsWhatIsRead) {
  expect_read_back(twisting_pair(0.01));
  // With a plane that yields, and beside a wall.
  const std::string before = "[[building.plane]]\nname = \"west",
                    yields = "yield_forces = [900, 900]\nhardening = 0.05\n";
  expect_read_back(test::plan_run(test::twisting_pair(before, yields + before)));
  expect_read_back(test::plan_run(test::twisting_pair() + test::wall_beside));
  // With one that loses strength, and a link; under gravity that brings a building down.
  const std::string softens = "backbone = { yield = 900, cap = 1.05, plastic_drift = 0.002, softening_drift = 0.01 }\n";
  const std::string link =
      "\n[[link]]\nbetween = [\"Frame\", \"Walled\"]\nelevations = [6.7]\nlaw = \"cable\"\nstiffness = 2e4\n"
      "at = 10\nalong = \"x\"\n";
  PlanRun softened = test::plan_run(test::twisting_pair(before, softens + before) + link);
  EXPECT_EQ(softened.response.links.size(), 1U);
  expect_read_back(std::move(softened));
  const std::string name = "name = \"Walled\"\n";
  PlanRun fallen = test::plan_run(test::with(test::twisting_pair(name, name + "p_delta = true\n"), "[analysis]\n",
                                             "[analysis]\ncollapse_drift = 1e-3\n"));
  EXPECT_EQ(fallen.response.status, Status::collapsed);
  expect_read_back(std::move(fallen));
  // With masses that may stand elsewhere, where drifts and a collapse are of any of their places.
  const std::string size = "size = [12.0, 18.0]\n", away = size + "accidental_eccentricity = 0.1\n";
  expect_read_back(test::plan_run(test::twisting_pair(size, away)));
  expect_read_back(test::plan_run(test::with(test::twisting_pair(name, name + "p_delta = true\n"), size, away)));
  // One on soil beside one on bearings, one of which yields.
  const std::string soil =
      "soil = { half_space = { shear_wave_velocity = 180, density = 1.9, poisson = 0.4, radius = 8 }, "
      "foundation = { mass = 200, inertia = 3000 } }\n";
  const std::string bearings =
      "isolation = { mass = 90, bearing = [{ at = [[1, 1], [8, 3]], stiffness = 4e3 }, "
      "{ at = [4, 17], stiffness = 3e3, characteristic_strength = 30, yield_displacement = 0.01 }] }\n";
  const std::string frame = "name = \"Frame\"\n";
  PlanRun carried = test::plan_run(test::with(test::twisting_pair(name, name + soil), frame, frame + bearings), 0.01);
  EXPECT_EQ(carried.response.buildings[0].foundation.size(), 5);
  EXPECT_EQ(carried.response.buildings[1].bearings.x.size(), 3);
  expect_read_back(std::move(carried));
}

TEST(PlanReading, FramesWithHingesAreWhatWasWritten) {
  PlanRun run = test::plan_run(test::hinged_pair());
  ASSERT_EQ(run.response.status, Status::done) << run.response.message;
  const std::string bytes = histories_netcdf(run, "test");
  const NetcdfReader file(bytes, "histories.nc");
  const std::size_t times = file.dimension_size("time"), hinges = file.dimension_size("hinge_1");
  EXPECT_EQ(hinges, 40U);  // of two frames of two storeys and two bays
  EXPECT_EQ(file.at("hinge_rotation_1").shape, (std::vector<std::size_t>{times, hinges}));
  EXPECT_EQ(file.texts("hinge_plane_1").front(), "middle");
  EXPECT_EQ(file.texts("hinge_plane_1").back(), "across");
  EXPECT_EQ(file.texts("breaking_column_plane_1"), (std::vector<std::string>(6, "across")));
  const std::vector<double> peaks = file.numbers("hinge_peak_rotation_1");
  EXPECT_LE(largest(file.numbers("hinge_rotation_1")), largest(peaks) * (1 + 1e-12));
  EXPECT_GE(largest(file.numbers("hinge_rotation_1")), 0.9 * largest(peaks));
  // What moments and rotations of the histories say at each instant, the law has told.
  const auto& planes = run.response.buildings[0].planes;
  long formed = 0;
  for (const PlanPeaks::Plane& plane : planes) {
    for (const BuildingPeaks::Hinge& hinge : plane.frame.hinges) formed += hinge.first_yield ? 1 : 0;
  }
  EXPECT_GT(formed, 5);
  std::vector<std::string> kinds;
  for (const Statement& one : run_story(run).statements) kinds.push_back(one.kind);
  const auto tells = [&](const char* kind) { return std::count(kinds.begin(), kinds.end(), kind); };
  EXPECT_EQ(tells("hinges") + tells("hinges_none"), 2);
  EXPECT_EQ(tells("columns_break") + tells("columns_whole"), 1);
  EXPECT_EQ(run_story(run).tables.front().kind, tells("columns_break") > 0 ? "broken_columns" : "hinges");
  const std::string json = summary_json(run, "0");
  for (const char* const key : {"\"hinge_order\"", "\"rotation_demand\"", "\"mechanism\"", "\"breaking_columns\"",
                                "\"hinge_energy\"", "\"peak_edge_drift_ratio\""}) {
    EXPECT_NE(json.find(key), std::string::npos) << key;
  }
  expect_read_back(std::move(run));
}

/// A record that is not at hand has told the duration of a case that gives none.
TEST(PlanReading, KnowsHowLongARecordWas) {
  PlanRun run = test::plan_run(test::twisting_pair("duration = 15.0"));
  ASSERT_GT(run.problem.duration, 15);
  const double duration = run.problem.duration;
  expect_read_back(std::move(run));
  EXPECT_GT(duration, 15);
}

TEST(PlanReading, RefusesWhatIsNotOfOneRun) {
  const PlanRun run = twisting_pair(0.01);
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
  };
  write("histories.nc", histories_netcdf(run, "0"));
  write("summary.json", summary_json(run, "0"));
  EXPECT_THROW((void)read_plan_results(folder.path()), std::runtime_error);  // without its case
  write("case.toml", run.c.source->text + "# changed\n");
  EXPECT_THROW((void)read_plan_results(folder.path()), std::runtime_error);
  write("case.toml", run.c.source->text);
  EXPECT_NO_THROW((void)read_plan_results(folder.path()));
  write("summary.json", "{}");
  EXPECT_THROW((void)read_plan_results(folder.path()), std::runtime_error);
}

/// The first of the pair by two of its modes, from a table beside the case.
std::string by_modes(const std::filesystem::path& table) {
  std::string text = test::twisting_pair();
  const std::size_t first = text.find("[[building.plane]]"), next = text.find("[[building]]", first);
  return text.replace(first, next - first,
                      "[building.modal]\nperiods = [0.5, 0.4]\nshapes_file = '" + table.string() + "'\n");
}

TEST(PlanReading, OfABuildingKnownByItsModesNeedsTheirTable) {
  const TemporaryFolder folder;
  const std::filesystem::path table = folder.path() / "shapes.csv";
  std::ofstream(table) << "0.6,0,0.01,0,0.6,0\n1,0,0.02,0,1,0\n";
  const PlanRun run = test::plan_run(by_modes(table));
  EXPECT_NE(summary_json(run, "0").find("\"mass_shares\""), std::string::npos);
  expect_read_back(run);
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
  };
  write("histories.nc", histories_netcdf(run, "0"));
  write("summary.json", summary_json(run, "0"));
  write("case.toml", run.c.source->text);
  std::filesystem::remove(table);
  try {
    (void)read_plan_results(folder.path());
    ADD_FAILURE() << "was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("shapes_file"), std::string::npos) << error.what();
  }
}

TEST(PlanCsv, HasARowForEachImpact) {
  const PlanRun run = twisting_pair(0);
  const std::string csv = impacts_csv(run);
  EXPECT_EQ(csv.substr(0, csv.find(",start")), "left,right,elevation [m],x [m],y [m]");
  EXPECT_NE(csv.find(",tangential_impulse [kN s],slipped\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + std::ssize(run.response.impacts));
  EXPECT_NE(csv.find("\nWalled,Frame,6.7,12.02,18,"), std::string::npos);
}

}  // namespace
}  // namespace bentur
