// Storeys that yield and links in studies: what can vary.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/design/study_check.h"
#include "tests/support/study_of.h"
#include "tests/support/yielding_case.h"

namespace bentur {
namespace {

TEST(YieldingStudy, EveryNumberCanVary) {
  const std::pair<const char*, const char*> all[] = {{"building[1].stick.yield_forces", "3e4, [5e4, inf]"},
                                                     {"building[\"Yields\"].stick.yield_forces[1]", "3e4, 5e4"},
                                                     {"building[1].stick.hardening", "0.0, 0.1"},
                                                     {"building[1].stick.unloading_exponent", "0.0, 1.0"},
                                                     {"building[1].stick.hysteresis", "\"peak-oriented\""},
                                                     {"building[1].damping.stiffness_proportional", "0.01, 0.05"},
                                                     {"building[1].damping_stiffness", "\"initial\", \"tangent\""},
                                                     {"building[1].calibrate_period", "0.3, 0.5"},
                                                     {"link[0].stiffness", "0.0, [1e5, 2e5]"},
                                                     {"link[0].damping[1]", "0.0, 5e3"},
                                                     {"link[1].yield_force", "5e3, 2e4"},
                                                     {"link[1].hardening", "0.0, 0.5"},
                                                     {"link[2].slack", "0.0, 0.02"},
                                                     {"link[2].stiffness", "1e5, 1e7"}};
  for (const auto& [parameter, values] : all) {
    SCOPED_TRACE(parameter);
    const std::string labels = std::string(values).find('[') != std::string::npos ? "labels = ['a', 'b']\n" : "";
    const TemporaryFolder folder;
    const std::filesystem::path file = test::study_of(test::yielding_case, folder.path(), parameter, values);
    std::ofstream(file, std::ios::app) << labels;
    Diagnostics diagnostics;
    const auto read = read_study(file, diagnostics);
    CaseMemo memo;
    if (read) (void)check_study(*read, memo, diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  }
}

TEST(YieldingStudy, WhichBuildingsCanYieldIsTheSameInAllRuns) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto read = read_study(
      test::study_of(test::yielding_case, folder.path(), "building[1].stick.yield_forces[0]", "inf, 4e4"), diagnostics);
  ASSERT_TRUE(read);
  CaseMemo memo;
  EXPECT_TRUE(check_study(*read, memo, diagnostics));  // its other storey yields in both
  const auto elastic = read_study(
      test::study_of(test::yielding_case, folder.path(), "building[1].stick.yield_forces", "4e4, inf"), diagnostics);
  ASSERT_TRUE(elastic);
  Diagnostics refused;
  EXPECT_FALSE(check_study(*elastic, memo, refused));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.errors().front().message().find("which buildings can yield"), std::string::npos);
}

}  // namespace
}  // namespace bentur
