#include "bentur/files/result_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

class ReadBack : public testing::TestWithParam<const char*> {};

/// Numbers in JSON and CSV read back to the same double, and NetCDF holds doubles: what was written is what is read.
TEST_P(ReadBack, WhatWasWrittenIsWhatIsRead) {
  Diagnostics diagnostics;
  const auto c = read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/" + GetParam() + ".toml", diagnostics);
  ASSERT_TRUE(c);
  const Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = c->analysis.output_step;
  options.course = true;
  options.energy_audit = c->analysis.energy_audit;
  const Response response = solve(problem, c->analysis.solver, options);
  const TemporaryFolder folder;
  AtomicFiles files(folder.path());
  const RunResults written = run_results(*c, problem, response);
  files.add("summary.json", summary_json(written, "0"), ResultKind::summary);
  files.add("impacts.csv", impacts_csv(written.view()), ResultKind::impacts);
  files.add("histories.nc", histories_netcdf(written, "0"), ResultKind::histories);
  files.commit();

  const RunResults results = read_results(folder.path());
  EXPECT_EQ(results.c.title, c->title);
  EXPECT_EQ(results.c.units.length, c->units.length);
  EXPECT_EQ(results.c.units.force, c->units.force);
  EXPECT_EQ(results.c.excitation.delays, c->excitation.delays);
  EXPECT_EQ(results.c.excitation.record.has_value(), c->excitation.record.has_value());
  if (c->excitation.record) {
    EXPECT_EQ(results.c.excitation.record->pga, c->excitation.record->pga);
  }
  EXPECT_EQ(name(results.c.analysis.solver), name(c->analysis.solver));
  EXPECT_EQ(results.response.events, response.events);
  // Judged alike, for the same reasons, though the samples of a record are not read back.
  const std::vector<JudgedGap> judged = judged_gaps(results), as_written = judged_gaps(written);
  ASSERT_EQ(judged.size(), as_written.size());
  for (std::size_t gap = 0; gap < judged.size(); ++gap) {
    std::vector<std::string> reasons, wanted;
    long without_case = 0;  // whose rules are not known
    for (const Reason& one : judged[gap].judgement.reasons) {
      const bool of_rules =
          one.kind == Reason::Kind::not_looked_at && one.count == static_cast<long>(NotLookedAt::rules);
      without_case += of_rules ? 1 : 0;
      if (!of_rules) reasons.push_back(word_of(one));
    }
    EXPECT_EQ(without_case, 1);
    for (const Reason& one : as_written[gap].judgement.reasons) wanted.push_back(word_of(one));
    EXPECT_EQ(reasons, wanted) << gap;
  }
  ASSERT_EQ(results.problem.buildings.size(), problem.buildings.size());
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& one = problem.buildings[b];
    const Building& two = results.problem.buildings[b];
    EXPECT_EQ(two.name, one.name);
    EXPECT_EQ(two.model.elevations, one.model.elevations);
    EXPECT_TRUE(two.modes.omega.isApprox(one.modes.omega, 1e-14));  // by way of the periods
    Eigen::MatrixXd shapes = one.modes.shapes.topRows(one.model.floors());
    for (auto shape : shapes.colwise()) shape /= shape.cwiseAbs().maxCoeff();  // as the file has them
    EXPECT_EQ(two.modes.shapes, shapes);
    for (std::size_t i = 0; i < one.model.storey_heights.size(); ++i) {
      EXPECT_NEAR(two.model.storey_heights[i], one.model.storey_heights[i], 1e-12 * one.model.elevations.back());
    }
    EXPECT_EQ(results.response.buildings[b].displacement, response.buildings[b].displacement);
    EXPECT_EQ(results.response.buildings[b].displacement_no_contact, response.buildings[b].displacement_no_contact);
    EXPECT_EQ(results.response.buildings[b].acceleration, response.buildings[b].acceleration);
    EXPECT_EQ(results.response.histories.displacement[b], response.histories.displacement[b]);
    EXPECT_EQ(results.response.course.displacement[b], response.course.displacement[b]);
    EXPECT_EQ(results.response.course.storey_shear[b], response.course.storey_shear[b]);
    if (one.is_rigid()) continue;
    EXPECT_EQ(results.response.buildings[b].acceleration_no_contact, response.buildings[b].acceleration_no_contact);
    EXPECT_EQ(results.response.buildings[b].storey_shear_no_contact, response.buildings[b].storey_shear_no_contact);
    test::expect_same_values(results.response.buildings[b].drift_ratio_no_contact,
                             response.buildings[b].drift_ratio_no_contact);
  }
  EXPECT_GT(response.course.time.size(), 100U);
  EXPECT_EQ(results.response.course.time, response.course.time);
  EXPECT_EQ(results.response.course.opening, response.course.opening);
  EXPECT_EQ(results.response.course.force, response.course.force);
  ASSERT_EQ(results.problem.points.size(), problem.points.size());
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    EXPECT_EQ(results.problem.points[i].left, problem.points[i].left);
    EXPECT_EQ(results.problem.points[i].left_floor, problem.points[i].left_floor);
    EXPECT_EQ(results.problem.points[i].right_floor, problem.points[i].right_floor);
    EXPECT_EQ(results.problem.points[i].width, problem.points[i].width);
    EXPECT_EQ(results.response.points[i].gap_needed, response.points[i].gap_needed);
    EXPECT_EQ(results.response.points[i].peak_force, response.points[i].peak_force);
    EXPECT_EQ(results.response.points[i].peak_force_time, response.points[i].peak_force_time);
  }
  ASSERT_EQ(results.problem.links.size(), problem.links.size());
  for (std::size_t i = 0; i < problem.links.size(); ++i) {
    EXPECT_EQ(results.problem.links[i].right_floor, problem.links[i].right_floor);
    EXPECT_EQ(results.response.links[i].peak_tension, response.links[i].peak_tension);
    EXPECT_EQ(results.response.links[i].energy_dissipated, response.links[i].energy_dissipated);
  }
  ASSERT_EQ(results.c.links.size(), c->links.size());
  for (std::size_t k = 0; k < c->links.size(); ++k) {
    EXPECT_EQ(results.c.links[k].law, c->links[k].law);
    EXPECT_EQ(results.c.links[k].elevations, c->links[k].elevations);
    for (const auto& [key, given] : c->links[k].numbers) EXPECT_EQ(results.c.links[k].number(key, 0), given.front());
  }
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto &one = response.buildings[b].yielding, &two = results.response.buildings[b].yielding;
    test::expect_same_values(two.ductility, one.ductility);
    test::expect_same_values(two.residual_drift_ratio, one.residual_drift_ratio);
    test::expect_same_values(two.hysteretic_energy, one.hysteretic_energy);
    EXPECT_EQ(results.response.buildings[b].foundation, response.buildings[b].foundation);
    EXPECT_EQ(results.problem.buildings[b].model.slab, problem.buildings[b].model.slab);
    EXPECT_EQ(results.problem.buildings[b].model.foundation.has_value(),
              problem.buildings[b].model.foundation.has_value());
    EXPECT_EQ(results.problem.buildings[b].is_rigid(), problem.buildings[b].is_rigid());
    const Eigen::MatrixXd &shear = response.histories.storey_shear[b],
                          &read = results.response.histories.storey_shear[b];
    test::expect_same_values(read.reshaped(), shear.reshaped());
  }
  EXPECT_EQ(results.response.histories.time, response.histories.time);
  EXPECT_EQ(results.response.histories.opening, response.histories.opening);
  EXPECT_EQ(results.response.energy.has_value(), response.energy.has_value());
  if (response.energy) {
    EXPECT_EQ(results.response.energy->histories.hysteretic, response.energy->histories.hysteretic);
  }
  // The same list of impacts writes the same file.
  EXPECT_EQ(impacts_csv(results.view()), impacts_csv(written.view()));

  // With the copy of the case the buildings and laws are there as they were given.
  EXPECT_TRUE(results.c.buildings.empty());
  AtomicFiles copy(folder.path());
  copy.add("case.toml", c->source->text, ResultKind::case_copy);
  copy.commit();
  const RunResults whole = read_results(folder.path());
  ASSERT_EQ(whole.c.buildings.size(), c->buildings.size());
  EXPECT_EQ(whole.c.units.gravity, c->units.gravity);
  EXPECT_EQ(whole.c.excitation.delays, c->excitation.delays);
  EXPECT_EQ(whole.c.excitation.record.has_value(), c->excitation.record.has_value());
  EXPECT_EQ(peak_acceleration(whole.problem.motion), c->excitation.record ? 0 : peak_acceleration(problem.motion));
  EXPECT_EQ(whole.problem.delays, problem.delays);
  EXPECT_EQ(whole.problem.duration, results.problem.duration);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    EXPECT_EQ(whole.problem.buildings[b].model.stiffness, problem.buildings[b].model.stiffness);
    EXPECT_EQ(whole.problem.buildings[b].modal_damping, problem.buildings[b].modal_damping);
  }
  for (std::size_t i = 0; i < problem.links.size(); ++i) {
    EXPECT_EQ(whole.problem.links[i].law->parameters(), problem.links[i].law->parameters());
  }
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    EXPECT_EQ(whole.problem.points[i].law->parameters(), problem.points[i].law->parameters());
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, ReadBack,
                         testing::Values("m12-el-centro", "m12-harmonic", "row-of-three", "kelvin-voigt-pair",
                                         "restitution-asked", "free-impact", "yielding-pair", "linked-pair",
                                         "isolated-moat", "generic-neighbour", "struck-column", "breaking-column"),
                         [](const auto& instance) {
                           std::string label = instance.param;
                           std::replace(label.begin(), label.end(), '-', '_');
                           return label;
                         });

TEST(ReadResults, SaysWhereASummaryIsNoneInWordsOfItsOwn) {
  Diagnostics diagnostics;
  Case c = *read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/free-impact.toml", diagnostics);
  Problem problem = make_problem(c);
  Response response = solve(problem, c.analysis.solver, {.output_step = 0.01, .course = true});
  const RunResults written = run_results(std::move(c), std::move(problem), std::move(response));
  const auto refusal = [&](const std::string& summary) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "summary.json") << summary;
    std::ofstream(folder.path() / "histories.nc", std::ios::binary) << histories_netcdf(written, "0");
    try {
      static_cast<void>(read_results(folder.path()));
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
    return std::string("read");
  };
  std::string summary = summary_json(written, "0");
  EXPECT_EQ(refusal(summary), "read");
  EXPECT_EQ(refusal("{\n  \"title\": ]"), "summary.json:2:12: is not JSON from here on");
  summary.replace(summary.find("\"gaps\""), 6, "\"gasp\"");
  EXPECT_EQ(refusal(summary), "summary.json: is JSON, but lacks what a summary of bentur run has");
}

/// Of floors that face columns the one that goes deepest is the roof of B, which is the last of them.
TEST(ReadResults, TheFloorThatComesNearestIsThatOfTheRun) {
  Diagnostics diagnostics;
  std::optional<Case> c = read_case_text(R"(
units = { length = "m", force = "kN" }
gap = [{ between = ["A", "B"], width = 0.01, contact = { law = "linear", stiffness = 1e6 } }]
excitation = { kind = "harmonic", period = 0.7, displacement_amplitude = 0.03 }
analysis = { duration = 2.0 }
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3, 3, 3, 3], masses = [100, 100, 100, 90], stiffnesses = [9e4, 8e4, 8e4, 7e4] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3, 4, 4], masses = [80, 80, 70], stiffnesses = [1.5e5, 1.4e5, 1.3e5] }
)",
                                         "case.toml", diagnostics);
  ASSERT_TRUE(c);
  const std::string text = c->source->text;
  Problem problem = make_problem(*c);
  Response response = solve(problem, c->analysis.solver, {.output_step = 0.01, .course = true});
  const RunResults written = run_results(*std::move(c), std::move(problem), std::move(response));
  ASSERT_TRUE(written.figures.nearest);
  const WatchedFloor& deepest = written.problem.watched[written.figures.nearest->watched];
  ASSERT_GT(written.figures.nearest->watched, 0);
  for (const bool with_case : {false, true}) {
    const TemporaryFolder folder;
    AtomicFiles files(folder.path());
    files.add("summary.json", summary_json(written, "0"), ResultKind::summary);
    files.add("histories.nc", histories_netcdf(written, "0"), ResultKind::histories);
    if (with_case) files.add("case.toml", text, ResultKind::case_copy);
    files.commit();
    const RunResults read = read_results(folder.path());
    ASSERT_TRUE(read.figures.nearest);
    const WatchedFloor& floor = read.problem.watched[read.figures.nearest->watched];
    EXPECT_EQ(floor.floor_of, deepest.floor_of);
    EXPECT_EQ(floor.elevation, deepest.elevation);
  }
}

TEST(ReadResults, SaysWhichFileIsMissing) {
  const TemporaryFolder folder;
  try {
    static_cast<void>(read_results(folder.path()));
    FAIL() << "an empty folder holds no results";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("summary.json: there is no such file"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bentur
