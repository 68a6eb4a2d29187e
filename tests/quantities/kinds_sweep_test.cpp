// Sweeps of a wall, of buildings on bearings and on soil, of one known by its modes and of one known by little.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/report/studies/file_kinds.h"
#include "bentur/runner/sweep.h"
#include "tests/support/kinds_case.h"
#include "tests/support/study_of.h"

namespace bentur {
namespace {

TEST(KindsSweep, TellsCollapseSwayAndRocking) {
  const TemporaryFolder folder;
  SweepOptions options;
  options.output = folder.path() / "study.nc";
  options.threads = 1;
  Ranks alone;
  Diagnostics diagnostics;
  const auto report =
      sweep(test::study_of(test::every_kind, folder.path(), "excitation.displacement_amplitude", "0.002, 0.02, 0.2"),
            options, alone, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(report && report->finished && report->failed == 0) << report->first_failure;
  const NetcdfReader file(options.output);
  EXPECT_EQ(file.numbers("collapsed").front(), 0);
  EXPECT_EQ(file.numbers("collapsed").back(), 1);
  EXPECT_EQ(file.find("peak_sway_2"), nullptr) << "on bearings";
  ASSERT_NE(file.find("peak_sway_3"), nullptr);
  EXPECT_EQ(file.at("peak_sway_3").units, "m");
  EXPECT_EQ(file.at("peak_rocking_3").units, "rad");
  const std::vector<double> sway = file.numbers("peak_sway_3"), rocking = file.numbers("peak_rocking_3");
  for (std::size_t run = 0; run < sway.size(); ++run) {
    EXPECT_GT(sway[run], 0);
    EXPECT_GT(rocking[run], 0);
  }
  EXPECT_GT(sway[1], sway[0]);
  EXPECT_TRUE(std::isnan(file.numbers("first_period_1").front())) << "a wall has none";
  EXPECT_TRUE(std::isnan(file.numbers("peak_drift_ratio_2").front())) << "nor a slab a drift";
  const std::vector<double> drift = file.numbers("peak_drift_ratio_3");
  EXPECT_NEAR(*std::max_element(drift.end() - 2, drift.end()), 0.03, 1e-9) << "where it ended";
  for (const char* kind : {"peak_sway", "peak_rocking", "collapsed"}) {
    const Figure figure = make_figure(file, kind);
    ASSERT_EQ(figure.panels.size(), 1U) << kind;
    EXPECT_FALSE(figure.panels[0].curves.empty()) << kind;
  }
}

}  // namespace
}  // namespace bentur
