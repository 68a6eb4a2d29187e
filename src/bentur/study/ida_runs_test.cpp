// The axis of intensities that [ida] gives a study.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <variant>

#include "bentur/io/temporary_folder.h"
#include "bentur/model/run_results.h"
#include "bentur/solve/spectrum/response_spectrum.h"
#include "bentur/study/study_runs.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const std::string tests_folder = (fs::path(BENTUR_SOURCE_DIR) / "tests").string();
const std::string records = "[[vary]]\nparameter = 'excitation.file'\nname = 'record'\nfiles = ['" + tests_folder +
                            "/bad_input/good.AT2', {file = '" + tests_folder +
                            "/bad_input/good-two-column.txt', unit = 'm/s2'}]\n";
const std::string two_widths = "[[vary]]\nparameter = 'gap[0].width'\nvalues = [0.0, 0.0001]\n";

StudyRuns runs_of(const std::string& text) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "ida.toml";
  std::ofstream(file) << "case = '" << tests_folder << "/bad_study/plain-case.toml'\n" << text;
  Diagnostics diagnostics;
  auto study = read_study(file, diagnostics);
  const auto memo = std::make_shared<CaseMemo>();
  auto facts = study ? check_study(*study, *memo, diagnostics) : std::nullopt;
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return {std::move(study.value()), std::move(facts.value()), memo};
}

/// The case of a run, with the record multiplied by `scale`.
ReadCase case_of(const StudyRuns& runs, std::size_t run, double scale) {
  TomlValue root = runs.study().case_root;
  put_choices(runs.study(), runs.choices(run), root);
  put_value(root, {"excitation", "scale"}, toml_number(scale));
  Diagnostics diagnostics;
  const std::string name = runs.study().case_file.string();
  ReadCase read =
      read_case_parts(TomlView(root, "", name, diagnostics), runs.study().case_file.parent_path(), diagnostics);
  EXPECT_TRUE(diagnostics.ok());
  return read;
}

double value_of(const StudyRuns& runs, const RunResult& result, const std::string& name) {
  const auto quantity = std::find_if(runs.quantities().begin(), runs.quantities().end(),
                                     [&](const RowPart& q) { return q.name == name; });
  return result.values.at(quantity->first);
}

std::vector<RunResult> all(const StudyRuns& runs) {
  std::vector<std::size_t> order(runs.design().runs());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = runs.design().run_at(i);
  return runs.solve(order, [] { return true; });
}

TEST(IdaRuns, EachRunIsTheCaseWithItsRecordScaled) {
  const StudyRuns runs =
      runs_of("[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = [0.1, 0.5, 2]\n" + records + two_widths);
  EXPECT_EQ(runs.study().axes, (std::vector<std::string>{"record", "width", "intensity"}));
  ASSERT_EQ(runs.design().runs(), 12U);
  const double peaks[] = {0.06, 0.03 / 9.80665};  // of the two files [g]
  const std::vector<double>& intensities = runs.facts().intensities.values;
  ASSERT_EQ(intensities.size(), 2U);
  double impacts = 0;
  for (const RunResult& result : all(runs)) {
    ASSERT_EQ(result.status, RunStatus::done) << result.message;
    const std::vector<Choice> choices = runs.choices(result.run);
    const std::size_t record = choices[0].level;
    EXPECT_NEAR(intensities[record], peaks[record], 1e-15);
    const double level = std::vector<double>{0.1, 0.5, 2}[choices[2].level];
    EXPECT_NEAR(value_of(runs, result, "peak_ground_acceleration"), level * 9.80665, 1e-14 * level * 9.80665);
    // By hand: bit for bit at the first level, which the others are made from.
    const ReadCase read = case_of(runs, result.run, level / intensities[record]);
    const Problem problem = make_problem(read.c);
    Problem closed = problem;
    for (ContactPoint& point : closed.points) point.width = 0;
    std::vector<double> row(row_size(runs.quantities()));
    const RunResults alone = run_results(read.c, problem, FreeResponse(closed, read.c.analysis.solver).solve(problem));
    fill_row(runs.quantities(), alone.view(), row);
    if (choices[2].level == 0) {
      EXPECT_EQ(std::memcmp(result.values.data(), row.data(), row.size() * sizeof(double)), 0) << result.run;
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (std::isnan(row[i])) continue;
      EXPECT_NEAR(result.values[i], row[i], 1e-9 * std::abs(row[i])) << result.run << ' ' << i;
    }
    impacts += value_of(runs, result, "impacts");
  }
  EXPECT_GT(impacts, 0);
}

TEST(IdaRuns, RunsOfOneRecordAndLevelShareTheirFreeResponse) {
  const StudyRuns runs = runs_of("[ida]\nintensity = 'pga'\nlevels = [0.1, 0.5, 2]\n" + records + two_widths);
  EXPECT_TRUE(runs.design().has_groups());
  for (std::size_t run = 0; run < runs.design().runs(); ++run) {
    const std::size_t other = run / 6 * 6 + run % 3;  // the one with the first width
    EXPECT_EQ(runs.design().group(run), runs.design().group(other));
    EXPECT_EQ(runs.design().run_at(run) / 6, run / 6);
  }
}

TEST(IdaRuns, SpectralAccelerationIsReached) {
  const StudyRuns runs =
      runs_of("[ida]\nintensity = 'sa'\nperiod = 0.2\ndamping = 0.02\nlevels = [0.3, 3]\n" + records);
  for (const RunResult& result : all(runs)) {
    const std::vector<Choice> choices = runs.choices(result.run);
    const double factor = record_factor(runs.facts().intensities, runs.facts().intensities.place(choices),
                                        runs.study().ida->levels[choices[runs.study().ida->axis.value()].level]);
    const ReadCase read = case_of(runs, result.run, factor);
    const auto& motion = std::get<SampledMotion>(read.c.excitation.motion);
    const double level = choices[1].level == 0 ? 0.3 : 3;  // [m/s²], the case's own unit
    EXPECT_NEAR(oscillator_peaks(motion, 0.2, 0.02).pseudo_acceleration, level, 1e-12 * level);
  }
}

TEST(IdaRuns, ACloudTakesRecordsAsTheirFilesHaveThem) {
  const StudyRuns cloud = runs_of("[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = 'unscaled'\n" + records + two_widths);
  EXPECT_EQ(cloud.study().axes, (std::vector<std::string>{"record", "width"}));
  const std::vector<double>& intensities = cloud.facts().intensities.values;
  ASSERT_EQ(intensities.size(), 2U);
  // Run by run and to the last bit what a sweep over the same records gives; the case scales nothing.
  const StudyRuns sweep = runs_of(records + two_widths);
  const std::vector<RunResult> a = all(cloud), b = all(sweep);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].status, RunStatus::done) << a[i].message;
    ASSERT_EQ(a[i].run, b[i].run);
    const double peak = intensities[cloud.choices(a[i].run)[0].level];
    EXPECT_NEAR(value_of(cloud, a[i], "peak_ground_acceleration"), peak * 9.80665, 1e-14);
    EXPECT_EQ(std::memcmp(a[i].values.data(), b[i].values.data(), a[i].values.size() * sizeof(double)), 0) << i;
  }
}

TEST(IdaRuns, ACloudLeavesOutWhatTheCaseScalesItsRecordBy) {
  const std::string scaled =
      "[[vary]]\nparameter = 'excitation'\nname = 'record'\nlabels = ['a', 'b']\n"
      "values = [{ kind = 'record', file = '../bad_input/good.AT2', pga = 77 }, "
      "{ kind = 'record', file = '../bad_input/good.AT2', scale = 3 }]\n";
  const StudyRuns cloud = runs_of("[ida]\nintensity = 'pga'\nlevels = 'unscaled'\n" + scaled);
  for (const RunResult& result : all(cloud)) {
    EXPECT_NEAR(value_of(cloud, result, "peak_ground_acceleration"), 0.06 * 9.80665, 1e-14);
  }
}

TEST(IdaRuns, WithoutFilesTheCasesOwnRecordIsScaledWhateverTheCaseScalesItBy) {
  const StudyRuns plain = runs_of("[ida]\nintensity = 'pga'\nlevels = [0.5, 1.5]\n");
  EXPECT_EQ(plain.design().runs(), 2U);
  const StudyRuns scaled = runs_of(
      "[ida]\nintensity = 'pga'\nlevels = [0.5, 1.5]\n[[vary]]\nparameter = 'excitation'\nlabels = ['a']\n"
      "values = [{ kind = 'record', file = '../bad_input/good.AT2', pga = 77 }]\n");
  const std::vector<RunResult> one = all(plain), other = all(scaled);
  ASSERT_EQ(one.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(std::memcmp(one[i].values.data(), other[i].values.data(), one[i].values.size() * sizeof(double)), 0);
  }
}

TEST(IdaRuns, SamplesAreARecordAndABuildingThatEveryLevelHas) {
  const StudyRuns runs = runs_of(
      "[sampling]\nmethod = 'latin-hypercube'\ncount = 8\nseed = 3\n[ida]\nintensity = 'pga'\n"
      "unit = 'g'\nlevels = [0.1, 0.5, 2]\n" +
      records +
      "[[vary]]\nparameter = 'gap[0].width'\ndistribution = { uniform = { low = 0.0, high = "
      "0.8 } }\n");
  EXPECT_EQ(runs.study().axes, (std::vector<std::string>{"draw", "intensity"}));
  ASSERT_EQ(runs.design().runs(), 24U);
  std::vector<int> of_records(2, 0), of_slices(8, 0);
  for (std::size_t draw = 0; draw < 8; ++draw) {
    std::vector<double> widths;
    std::vector<std::string> files;
    for (std::size_t level = 0; level < 3; ++level) {
      const TomlValue root = chosen_case(runs.study(), runs.choices(3 * draw + level));
      widths.push_back(find_value(root, {"gap", std::size_t{0}, "width"})->real);
      files.push_back(find_value(root, {"excitation", "file"})->text);
    }
    EXPECT_EQ(widths, std::vector<double>(3, widths.front()));
    EXPECT_EQ(files, std::vector<std::string>(3, files.front()));
    ++of_slices.at(static_cast<std::size_t>(widths.front() / 0.1));
    ++of_records.at(files.front().find("AT2") != std::string::npos ? 0 : 1);
    // The key that goes with the file is its own.
    const TomlValue root = chosen_case(runs.study(), runs.choices(3 * draw));
    EXPECT_EQ(find_value(root, {"excitation", "unit"}) != nullptr,
              of_records[1] > 0 && files.front().find("AT2") == std::string::npos);
  }
  // A Latin hypercube: one width in each slice, and each record for half of the draws.
  EXPECT_EQ(of_slices, std::vector<int>(8, 1));
  EXPECT_EQ(of_records, std::vector<int>(2, 4));
  for (const RunResult& result : all(runs)) EXPECT_EQ(result.status, RunStatus::done) << result.message;
}

}  // namespace
}  // namespace bentur
