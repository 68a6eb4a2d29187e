// Walls, bearings, soil, gravity loads, modes and generic buildings in studies: what can vary.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/design/study_check.h"
#include "tests/support/column_case.h"
#include "tests/support/kinds_case.h"
#include "tests/support/study_of.h"

namespace bentur {
namespace {

TEST(KindsStudy, EveryNumberCanVary) {
  const std::pair<const char*, const char*> all[] = {
      {"building[1].isolation.mass", "60.0, 90.0"},
      {"building[1].isolation.friction_pendulum.coefficient", "0.03, 0.08"},
      {"building[\"Weak\"].soil.half_space.shear_wave_velocity", "100.0, 300.0"},
      {"building[2].soil.foundation.mass", "50.0, 200.0"},
      {"building[2].p_delta", "true, false"},
      {"building[3].modal.periods[1]", "0.1, 0.2"},
      {"building[4].generic.period", "0.4, 0.8"},
      {"building[4].generic.stiffness_ratio", "0.0, 4.0"},
      {"analysis.collapse_drift", "0.02, 0.1"}};
  for (const auto& [parameter, values] : all) {
    SCOPED_TRACE(parameter);
    const TemporaryFolder folder;
    Diagnostics diagnostics;
    const auto read = read_study(test::study_of(test::every_kind, folder.path(), parameter, values), diagnostics);
    CaseMemo memo;
    if (read) (void)check_study(*read, memo, diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  }
}

TEST(KindsStudy, ValuesThatMakeNoCaseAreTold) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto read = read_study(
      test::study_of(test::every_kind, folder.path(), "building[2].soil.half_space.poisson", "0.3, 0.6"), diagnostics);
  ASSERT_TRUE(read);
  CaseMemo memo;
  EXPECT_FALSE(check_study(*read, memo, diagnostics)) << "0.6 is no case";
}

TEST(KindsStudy, ColumnsMayBeStruckAtOtherElevations) {  // each run has its own nodes in the columns
  std::string frames = test::struck_columns;
  const std::string capacity = "column_capacity = { shear = [400.0, 300.0, 400.0, 500.0], moment = 350.0 }";
  ASSERT_NE(frames.find(capacity), std::string::npos);
  frames.replace(frames.find(capacity), capacity.size(), "column_capacity = { shear = 400.0, moment = 350.0 }");
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto read = read_study(test::study_of(frames.c_str(), folder.path(), "gap[0].elevations",
                                              "[3.0, 6.0], [3.0, 4.4]]\nlabels = ['own', 'both'"),
                               diagnostics);
  ASSERT_TRUE(read);
  CaseMemo memo;
  EXPECT_TRUE(check_study(*read, memo, diagnostics));
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
}

}  // namespace
}  // namespace bentur
