#include "bentur/study/study_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "bentur/io/temporary_folder.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// Two sticks that are shaken a tenth of a second apart, close enough for impacts.
const char* const case_text = R"(
[units]
length = "cm"
force = "kgf"
[[building]]
name = "West"
damping = 0.05
stick = { storey_heights = [100, 100], masses = [0.2, 0.2], stiffnesses = [9000, 9000] }
[[building]]
name = "East"
damping = 0.05
stick = { storey_heights = [100, 100], masses = [0.2, 0.2], stiffnesses = [6000, 6000] }
[[gap]]
between = ["West", "East"]
width = 0.02
contact = { law = "linear", stiffness = [2e5, 2e5] }
[excitation]
kind = "harmonic"
period = 0.3
displacement_amplitude = 1.0
delays = [0.0, 0.1]
[analysis]
duration = 1.5
)";

class Runs : public testing::Test {
 protected:
  static StudyRuns runs_of(const std::string& varies) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "case.toml") << case_text;
    std::ofstream(folder.path() / "study.toml") << "case = 'case.toml'\n" << varies;
    Diagnostics diagnostics;
    auto study = read_study(folder.path() / "study.toml", diagnostics);
    const auto memo = std::make_shared<CaseMemo>();
    auto facts = study ? check_study(*study, *memo, diagnostics) : std::nullopt;
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    return {std::move(study.value()), std::move(facts.value()), memo};
  }

  /// The row of a run as a case of its own gives it: nothing shared, nothing remembered.
  static std::vector<double> alone(const StudyRuns& runs, std::size_t run) {
    TomlValue root = runs.study().case_root;
    put_choices(runs.study(), runs.choices(run), root);
    Diagnostics diagnostics;
    const std::string name = runs.study().case_file.string();
    const ReadCase read =
        read_case_parts(TomlView(root, "", name, diagnostics), runs.study().case_file.parent_path(), diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    const Problem problem = make_problem(read.c);
    std::vector<double> row(row_size(runs.quantities()));
    const RunResults alone = run_results(read.c, problem, solve(problem, read.c.analysis.solver));
    fill_row(runs.quantities(), alone.view(), row);
    return row;
  }

  static void expect_same_as_alone(const StudyRuns& runs) {
    std::vector<std::size_t> order(runs.design().runs());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = runs.design().run_at(i);
    std::vector<RunResult> results = runs.solve(order, [] { return true; });
    ASSERT_EQ(results.size(), order.size());
    std::reverse(order.begin(), order.end());  // other runs now begin the groups
    std::vector<RunResult> backwards = runs.solve(order, [] { return true; });
    std::reverse(backwards.begin(), backwards.end());
    double impacts = 0;
    const auto quantity = std::find_if(runs.quantities().begin(), runs.quantities().end(),
                                       [](const RowPart& q) { return q.name == "impacts"; });
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].status, RunStatus::done) << results[i].message;
      const std::vector<double> expected = alone(runs, results[i].run);
      ASSERT_EQ(results[i].values.size(), expected.size());
      const std::size_t bytes = expected.size() * sizeof(double);  // NaN too
      EXPECT_EQ(std::memcmp(results[i].values.data(), expected.data(), bytes), 0) << results[i].run;
      EXPECT_EQ(std::memcmp(results[i].values.data(), backwards[i].values.data(), bytes), 0) << results[i].run;
      impacts += expected[quantity->first];
    }
    EXPECT_GT(impacts, 0);
  }
};

/// By the drift that counts as collapse, and by a displacement that no ground has.
TEST_F(Runs, SayWhatKeepsTheirNeedsFromBeingKnown) {
  const auto open = [](const std::string& parameter, const std::string& values) {
    const StudyRuns runs = runs_of("[[vary]]\nparameter = '" + parameter + "'\nvalues = [" + values + "]\n");
    const auto part = std::find_if(runs.quantities().begin(), runs.quantities().end(),
                                   [](const RowPart& q) { return q.name == "open_needs"; });
    std::vector<std::uint64_t> bits;
    for (const RunResult& one : runs.solve(std::vector<std::size_t>{0, 1}, [] { return true; })) {
      bits.push_back(static_cast<std::uint64_t>(one.values.at(part->first)));
    }
    return bits;
  };
  const std::vector<std::uint64_t> drift = open("analysis.collapse_drift", "10, 1e-12");
  EXPECT_FALSE(has(drift.at(0), OpenNeed::drift));
  EXPECT_TRUE(has(drift.at(1), OpenNeed::drift));
  const std::vector<std::uint64_t> doubt = open("excitation.displacement_amplitude", "1, 1e4");
  EXPECT_FALSE(has(doubt.at(0), OpenNeed::doubt));
  EXPECT_TRUE(has(doubt.at(1), OpenNeed::doubt));
}

TEST_F(Runs, WidthsAlone) {
  const StudyRuns runs = runs_of("[[vary]]\nparameter = 'gap[0].width'\nfrom = 0\nto = 0.08\ncount = 9\n");
  EXPECT_TRUE(runs.design().has_groups());
  expect_same_as_alone(runs);
}

TEST_F(Runs, WidthsByPointAndList) {
  expect_same_as_alone(
      runs_of("[[vary]]\nparameter = 'gap[0].width'\nvalues = [[0.01, 0.02], [0.0, 0.03]]\nlabels = ['a', 'b']\n"));
}

TEST_F(Runs, ContactLawsAndTheirNumbers) {
  expect_same_as_alone(runs_of(R"(
[[vary]]
parameter = "gap[0].contact"
labels = ["linear", "Kelvin-Voigt", "Hertz", "restitution"]
values = [{ law = "linear", stiffness = 1e5 }, { law = "kelvin-voigt", stiffness = 2e5, restitution = 0.65 },
          { law = "hertz", stiffness = 1e6 }, { law = "restitution", restitution = 0.6 }]
[[vary]]
parameter = "gap[0].width"
values = [0.0, 0.02]
)"));
  expect_same_as_alone(runs_of("[[vary]]\nparameter = 'gap[0].contact.stiffness[1]'\nfactor = [0.5, 2]\n"));
}

TEST_F(Runs, EverythingElse) {
  expect_same_as_alone(runs_of(R"(
[[vary]]
parameter = "building['East'].stick.masses"
factor = [0.9, 1.1]
[[vary]]
parameter = "excitation.period"
values = [0.25, 0.35]
[[vary]]
parameter = "gap[0].width"
values = [0.005, 0.015]
[[vary]]
parameter = "analysis.solver"
values = ["exact", "adaptive"]
)"));
}

TEST_F(Runs, DelaysReckonedFromTheGapAreNotShared) {
  const StudyRuns runs = runs_of(R"(
[[vary]]
parameter = "excitation"
labels = ["wave"]
values = [{ kind = "harmonic", period = 0.3, displacement_amplitude = 1.0, wave_velocity = 1000 }]
[[vary]]
parameter = "building[0].width"
values = [300]
[[vary]]
parameter = "building[1].width"
name = "east_width"
values = [300]
[[vary]]
parameter = "gap[0].width"
name = "gap_width"
values = [0.05, 100]
)");
  EXPECT_FALSE(runs.design().has_groups());
}

TEST_F(Runs, Samples) {
  expect_same_as_alone(runs_of(R"(
[sampling]
method = "latin-hypercube"
count = 12
[[vary]]
parameter = "gap[0].width"
from = 0
to = 0.03
[[vary]]
parameter = "building['East'].stick.stiffnesses"
factor = true
distribution = { lognormal = { median = 1, cov = 0.2 } }
)"));
}

TEST_F(Runs, ValuesThatDoNotGoTogetherAreMarkedAndTheRestGoesOn) {
  // Each value is right beside the other's first one; the second ones together give a damping negative in mode 2.
  const StudyRuns mixed = runs_of(R"(
[[vary]]
parameter = "building[0].damping"
labels = ["a", "b"]
values = [{ rayleigh = { ratios = [0.05, 0.05], periods = [0.1, 0.3] } },
          { rayleigh = { ratios = [0.05, 0.005], periods = [0.2, 0.09] } }]
[[vary]]
parameter = "building[0].stick.stiffnesses"
factor = [0.02, 1]
)");
  const auto results = mixed.solve(std::vector<std::size_t>{0, 1, 2, 3}, [] { return true; });
  ASSERT_EQ(results.size(), 4U);
  int invalid = 0;
  for (const RunResult& result : results) {
    invalid += result.status == RunStatus::invalid ? 1 : 0;
    EXPECT_EQ(result.values.empty(), result.status != RunStatus::done);
    EXPECT_EQ(result.message.empty(), result.status == RunStatus::done);
  }
  EXPECT_EQ(invalid, 1);
  EXPECT_EQ(results[3].status, RunStatus::invalid);
}

TEST_F(Runs, NumbersThatFailAreMarked) {
  const StudyRuns runs = runs_of("[[vary]]\nparameter = 'excitation.displacement_amplitude'\nvalues = [1.0, 3e305]\n");
  const auto results = runs.solve(std::vector<std::size_t>{1, 0}, [] { return true; });
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].status, RunStatus::failed);
  EXPECT_NE(results[0].message.find("t = "), std::string::npos) << results[0].message;
  EXPECT_EQ(results[1].status, RunStatus::done);
}

TEST_F(Runs, StopWhenTold) {
  const StudyRuns runs = runs_of("[[vary]]\nparameter = 'gap[0].width'\nfrom = 0\nto = 0.4\ncount = 9\n");
  std::vector<std::size_t> order(9);
  std::iota(order.begin(), order.end(), 0U);
  int asked = 0;
  EXPECT_LT(runs.solve(order, [&] { return ++asked < 3; }).size(), 9U);
}

}  // namespace
}  // namespace bentur
