#include "bentur/runner/for_each_in_threads.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/design/study.h"

namespace bentur {
namespace {

TEST(ForEachInThreads, WorksOnEachNumberOnce) {
  for (const int threads : {1, 3, 50}) {
    std::vector<int> times(40, 0);
    for_each_in_threads(threads)(times.size(), [&](std::size_t i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(40, 1));
    for_each_in_threads(threads)(0, [](std::size_t) { ADD_FAILURE(); });
  }
}

TEST(ForEachInThreads, ThrowsWhatOneHasThrownWhenAllAreDone) {
  std::atomic<int> begun = 0, ended = 0;
  const auto work = [&](std::size_t i) {
    ++begun;
    if (i == 7) {
      ++ended;
      throw std::runtime_error("seven");
    }
    ++ended;
  };
  EXPECT_THROW(for_each_in_threads(4)(1000, work), std::runtime_error);
  EXPECT_EQ(begun, ended);
}

/// What is found of many values does not depend on how many threads try them, nor does the order in which it is told.
TEST(ForEachInThreads, FindsInAStudyWhatOneThreadFinds) {
  const auto found_by = [](const std::string& values, int threads, Diagnostics& diagnostics) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "study.toml";
    std::ofstream(file) << "case = '" << BENTUR_SOURCE_DIR
                        << "/tests/bad_study/plain-case.toml'\n[[vary]]\nparameter = 'building[0].damping'\nvalues = ["
                        << values << "]\n[[vary]]\nparameter = 'gap[0].width'\nvalues = [0.01, 0.02]\n";
    const auto study = read_study(file, diagnostics);
    CaseMemo memo;
    return check_study(study.value(), memo, diagnostics, for_each_in_threads(threads));
  };
  std::string right = "0.05", wrong = "0.05";
  for (int i = 1; i < 600; ++i) {
    const double damping = 0.05 + 1e-6 * i;
    right += fmt::format(", {}", damping);
    wrong += fmt::format(", {}", i % 290 == 0 ? -damping : damping);
  }
  Diagnostics none;
  const auto facts = found_by(right, 1, none), same = found_by(right, 4, none);
  ASSERT_TRUE(facts && same && none.ok());
  EXPECT_EQ(facts->records, same->records);
  std::vector<std::string> told[2];
  for (const int threads : {1, 4}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(found_by(wrong, threads, diagnostics).has_value());
    for (const Diagnostic& one : diagnostics.errors()) {
      told[threads == 4].push_back(fmt::format("{}: {}", one.position.column, one.message()));
    }
  }
  EXPECT_GE(told[0].size(), 2U);
  EXPECT_EQ(told[0], told[1]);
}

}  // namespace
}  // namespace bentur
