#include "bentur/files/ida_reading.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/runner/internal/sweep_netcdf.h"
#include "bentur/study/fragility/fragility_report.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path tests = fs::path(BENTUR_SOURCE_DIR) / "tests";

TEST(EventRule, IsAQuantityComparedWithANumber) {
  std::string error;
  const auto rule = parse_event(" peak_force >= 2.5e3 ", error);
  ASSERT_TRUE(rule.has_value());
  EXPECT_EQ(rule->quantity, "peak_force");
  EXPECT_TRUE(rule->holds(2500));
  EXPECT_FALSE(rule->holds(2499));
  EXPECT_FALSE(rule->holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(parse_event("x > 1", error)->holds(1));
  EXPECT_TRUE(parse_event("x<1", error)->holds(0.5));
  EXPECT_TRUE(parse_event("x <= -1", error)->holds(-1));
  for (const char* text : {"", "impacts", "impacts >", "> 1", "impacts = 1", "impacts > one", "impacts > 1 kN",
                           "impacts >> 1", "impacts > nan", "impacts > inf", "impacts > 1 > 0"}) {
    EXPECT_FALSE(parse_event(text, error).has_value()) << text;
    EXPECT_FALSE(error.empty());
  }
}

/// Results of no simulation: numbers made up, so that what is read can be compared with them.
class MadeUp : public testing::Test {
 protected:
  static constexpr std::size_t records = 2, widths = 3, levels = 4;

  /// Runs are record × width × level. `ida` empty: a sweep.
  [[nodiscard]] fs::path written(
      const std::string& ida = "[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = [0.1, 0.2, 0.4, 0.8]\n",
      const std::string& parameter = "gap[0].width", const std::string& of_files = "") const {
    const fs::path& folder = folder_.path();
    std::ofstream(folder / "bentur-made-up.toml")
        << "case = '" << case_.string() << "'\n"
        << ida << "[[vary]]\nparameter = 'excitation.file'\nname = 'record'\nfiles = ['"
        << (tests / "bad_input/good.AT2").string() << "', {file = '"
        << (tests / "bad_input/good-two-column.txt").string() << "', unit = 'm/s2'}]\n"
        << of_files << "[[vary]]\nparameter = '" << parameter << "'\nvalues = [0.02, 0.01, 0.03]\n";
    Diagnostics diagnostics;
    auto study = read_study(folder / "bentur-made-up.toml", diagnostics);
    const auto memo = std::make_shared<CaseMemo>();
    auto facts = study ? check_study(*study, *memo, diagnostics) : std::nullopt;
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    const StudyRuns runs(std::move(study.value()), std::move(facts.value()), memo);
    const JournalOrigin origin{"1", "", "", "", {}, runs.design().runs(), row_size(runs.quantities())};
    const fs::path part = folder / "bentur-made-up.part", file = folder / "bentur-made-up.nc";
    fs::remove(part);
    Journal journal = Journal::begin(part, origin);
    for (std::size_t run = 0; run < runs.design().runs(); ++run) journal.write(made_up(runs, run));
    (void)write_sweep_netcdf(file, runs, journal, "1");
    fs::remove(part);
    return file;
  }

  /// The highest floor of the right building drifts, and the middle of three points is hit, as the run's number says.
  static RunResult made_up(const StudyRuns& runs, std::size_t run) {
    RunResult result{run, RunStatus::done, {}, std::vector<double>(row_size(runs.quantities()), 0.0)};
    if (run == numbers_failed) return {run, RunStatus::failed, "made up", {}};
    if (run == no_case) return {run, RunStatus::invalid, "made up", {}};
    for (const RowPart& quantity : runs.quantities()) {
      if (quantity.name == "open_needs") result.values[quantity.first] = run == drifted ? 2 : run == doubted ? 4 : 0;
      if (quantity.name == "collapsed") result.values[quantity.first] = run == collapsed ? 1 : 0;
      if (quantity.name == "peak_force") result.values[quantity.first + 1] = force(run);
      if (quantity.name == "residual_drift_ratio_1")
        result.values[quantity.first] = force(run) * (run % 2 == 0 ? 1 : -1);
      if (quantity.name == "peak_drift_ratio_2") result.values[quantity.first + quantity.count - 1] = force(run) / 1000;
    }
    return result;
  }
  static constexpr std::size_t numbers_failed = 14, no_case = 5, collapsed = 7;  // 14 and 7: of small forces
  static constexpr std::size_t drifted = 4, doubted = 0;  // as far as collapse; also of small forces
  /// What collapses or cannot be computed is beyond any threshold.
  static Outcome outcome(std::size_t run) {
    if (run == no_case) return Outcome::failed;
    return run == numbers_failed || run == collapsed || run == drifted || force(run) > 11.5 ? Outcome::event
                                                                                            : Outcome::no_event;
  }
  static double force(std::size_t run) { return static_cast<double>(run * 7 % 24); }

  static std::string error_of(const fs::path& file, const FragilityRequest& request) {
    Diagnostics diagnostics;
    auto results = read_ida_results(file, request.event, diagnostics);
    if (!results) return diagnostics.errors().front().message();
    std::string error;
    EXPECT_FALSE(fragility_report(std::move(*results), request, error).has_value());
    return error;
  }

  TemporaryFolder folder_;
  fs::path case_ = tests / "bad_study/plain-case.toml";
};

TEST_F(MadeUp, EachOutcomeIsFoundWhereItBelongs) {
  const fs::path file = written();
  for (const auto& [event, scale] : {std::pair("peak_force > 11.5", 1.0), std::pair("drift > 0.0115", 1e-3),
                                     std::pair("peak_drift_ratio_2 > 0.0115", 1e-3)}) {
    std::string error;
    Diagnostics diagnostics;
    const auto results = read_ida_results(file, event, diagnostics);
    ASSERT_TRUE(results.has_value());
    const OutcomeTable& table = results->table;
    EXPECT_EQ(results->open.runs, 2);
    EXPECT_EQ(results->open.in, (std::vector<long>{0, 1, 1, 0}));
    EXPECT_EQ(table.levels, (std::vector<double>{0.1, 0.2, 0.4, 0.8}));
    ASSERT_EQ(table.cases, widths);
    ASSERT_EQ(table.records, records);
    for (std::size_t record = 0; record < records; ++record) {
      for (std::size_t width = 0; width < widths; ++width) {
        for (std::size_t level = 0; level < levels; ++level) {
          const std::size_t run = (record * widths + width) * levels + level;
          const Outcome expected = outcome(run);
          EXPECT_EQ(table.at(width, record, level), expected) << event << ", run " << run;
        }
      }
    }
    EXPECT_EQ(results->quantity_units, scale == 1 ? "kN" : "1");
    EXPECT_EQ(results->units, "gravity");
    EXPECT_EQ(results->study_unit, "g");
    EXPECT_EQ(results->intensity, "peak ground acceleration");
    ASSERT_EQ(results->axes.size(), 1U);
    ASSERT_EQ(results->axes[0].coordinates.size(), 1U);
    EXPECT_EQ(results->axes[0].coordinates[0].name, "width");
    EXPECT_EQ(results->axes[0].coordinates[0].units, "m");
    EXPECT_TRUE(results->axes[0].coordinates[0].is_gap_width());
    EXPECT_EQ(results->places(2), std::vector<std::size_t>{2});
  }
}

// Which way a building leans does not matter: what can have either sign is compared by its size.
TEST_F(MadeUp, AResidualDriftCountsBothWays) {
  std::ifstream stream(case_);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::size_t at = text.find("stiffnesses = ");
  ASSERT_NE(at, std::string::npos);
  text.insert(at, "yield_forces = 1e3, ");
  case_ = folder_.path() / "yields.toml";
  std::ofstream(case_) << text;
  const fs::path file = written();
  Diagnostics diagnostics;
  const auto results = read_ida_results(file, "residual_drift_ratio > 11.5", diagnostics);
  ASSERT_TRUE(results.has_value());
  const OutcomeTable& table = results->table;
  for (std::size_t record = 0; record < records; ++record) {
    for (std::size_t width = 0; width < widths; ++width) {
      for (std::size_t level = 0; level < levels; ++level) {
        const std::size_t run = (record * widths + width) * levels + level;
        const Outcome expected = outcome(run);
        EXPECT_EQ(table.at(width, record, level), expected) << "run " << run;
      }
    }
  }
  EXPECT_TRUE(is_compared_by_size(NetcdfReader(file), "residual_drift_ratio_1"));
  EXPECT_FALSE(is_compared_by_size(NetcdfReader(file), "ductility_1"));
}

TEST_F(MadeUp, ErrorsSayWhatToDo) {
  const fs::path file = written();
  EXPECT_NE(error_of(file, {.event = "impact > 0"}).find("did you mean \"impacts\"?"), std::string::npos);
  EXPECT_NE(error_of(file, {.event = "width > 0"}).find("has no quantity"), std::string::npos);
  EXPECT_NE(error_of(file, {.event = "status > 0"}).find("has no quantity"), std::string::npos);
  EXPECT_NE(error_of(file, {.event = "impacts"}).find("must be a quantity"), std::string::npos);
  EXPECT_NE(error_of(file, {.at = 0.9, .probabilities = {0.1}}).find("must be from 0.1 to 0.8"), std::string::npos);
  EXPECT_NE(error_of(file, {.at = 0.2, .probabilities = {0.1}, .along = "widht"}).find("did you mean \"width\"?"),
            std::string::npos);
  EXPECT_NE(error_of(tests / "bad_input/good.AT2", {}).find("NetCDF"), std::string::npos);
  EXPECT_NE(error_of(tests / "none.nc", {}).find("no such file"), std::string::npos);
}

TEST_F(MadeUp, RecordsBothWaysRoundAndNormalised) {
  const fs::path file = written("[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = [0.1, 0.2]\npolarity = 'both'\n",
                                "gap[0].width", "normalisation = [2, 0.5]\n");
  std::string error;
  Diagnostics diagnostics;
  const auto results = read_ida_results(file, "peak_force > 11.5", diagnostics);
  ASSERT_TRUE(results.has_value());
  EXPECT_EQ(results->table.records, 2 * records);
  EXPECT_EQ(results->table.together, 2U);
  EXPECT_EQ(results->table.cases, widths);
  EXPECT_EQ(results->intensity, "peak ground acceleration, median of the normalised records");
  // Runs are record × width × polarity × level; in the table the two polarities of a record stand together.
  for (std::size_t record = 0; record < records; ++record) {
    for (std::size_t polarity = 0; polarity < 2; ++polarity) {
      const std::size_t run = (record * widths * 2 + polarity) * 2;  // first width, first level
      EXPECT_EQ(results->table.at(0, record * 2 + polarity, 0), outcome(run));
    }
  }
  const NetcdfReader reader(file);
  EXPECT_EQ(reader.numbers("normalisation"), (std::vector<double>{2, 0.5}));
  const std::vector<double> intensity = reader.numbers("record_intensity");  // record × polarity
  ASSERT_EQ(intensity.size(), 4U);
  EXPECT_EQ(intensity[0], intensity[1]);
  const double median = (2 * intensity[0] + 0.5 * intensity[2]) / 2;
  const std::vector<double> factors = reader.numbers("scale_factor");  // × level
  ASSERT_EQ(factors.size(), 8U);
  EXPECT_DOUBLE_EQ(factors[1], 2 * 0.2 / median);
  EXPECT_DOUBLE_EQ(factors[6], 0.5 * 0.1 / median);
}

TEST_F(MadeUp, ASweepIsNotAnAnalysisOfIntensities) {
  EXPECT_NE(error_of(written(""), {}).find("those of bentur ida"), std::string::npos);
}

TEST_F(MadeUp, AGapNeedsWidthsThatVary) {
  const fs::path file =
      written("[ida]\nintensity = 'pga'\nunit = 'm/s2'\nlevels = [0.1, 0.2]\n", "building[0].damping");
  EXPECT_NE(error_of(file, {.at = 0.2, .probabilities = {0.1}}).find("has no gap width"), std::string::npos);
}

TEST_F(MadeUp, GapsAreSoughtInTheOrderOfTheWidths) {
  Diagnostics diagnostics;
  const FragilityRequest request{.event = "peak_force > 11.5", .at = 0.4, .probabilities = {0.5, 0.999}};
  std::string error;
  const auto report = fragility_report(read_ida_results(written(), request.event, diagnostics).value(), request, error);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->gap_name, "width");
  ASSERT_EQ(report->gaps.size(), 2U);
  const std::string json = fragility_json(*report, request, "1");
  EXPECT_NE(json.find("\"kind\""), std::string::npos);
  EXPECT_EQ(json.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace bentur
