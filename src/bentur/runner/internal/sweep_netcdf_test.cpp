#include "bentur/runner/internal/sweep_netcdf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// The library stores messages in pieces of 1024 runs; a failure in one of them alone once kept all from being read.
TEST(SweepNetcdf, MessagesAreReadWhereverRunsFail) {
  constexpr std::size_t count = 3000, failed = 1500;
  const TemporaryFolder folder;
  const fs::path study_file = folder.path() / "study.toml";
  std::ofstream(study_file) << "case = '" << BENTUR_SOURCE_DIR << "/tests/bad_study/plain-case.toml'\n"
                            << "[[vary]]\nparameter = 'gap[0].width'\nfrom = 0.01\nto = 0.02\ncount = " << count;
  Diagnostics diagnostics;
  auto study = read_study(study_file, diagnostics);
  const auto memo = std::make_shared<CaseMemo>();
  auto facts = study ? check_study(*study, *memo, diagnostics) : std::nullopt;
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  const StudyRuns runs(std::move(study.value()), std::move(facts.value()), memo);
  const std::vector<double> row(row_size(runs.quantities()), 1.0);
  Journal journal = Journal::begin(folder.path() / "part", {"1", "", "", "", {}, count, row.size()});
  for (std::size_t run = 0; run < count; ++run) {
    journal.write(run == failed ? RunResult{run, RunStatus::failed, "made up", {}}
                                : RunResult{run, RunStatus::done, {}, row});
  }
  const SweepTotals totals = write_sweep_netcdf(folder.path() / "study.nc", runs, journal, "1");
  EXPECT_EQ(totals.first_failure, "run 1500: made up");
  const std::vector<std::string> messages = NetcdfReader(folder.path() / "study.nc").texts("message");
  ASSERT_EQ(messages.size(), count);
  for (std::size_t run = 0; run < count; ++run) EXPECT_EQ(messages[run], run == failed ? "made up" : "");
}

}  // namespace
}  // namespace bentur
