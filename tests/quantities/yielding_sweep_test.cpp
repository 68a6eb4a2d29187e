// Storeys that yield and links in studies: what is kept of every run, and drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/studies/file_kinds.h"
#include "bentur/runner/sweep.h"
#include "tests/support/study_of.h"
#include "tests/support/yielding_case.h"

namespace bentur {
namespace {

TEST(YieldingSweep, KeepsWhatYieldsAndTheLinksAndDrawsThem) {
  const TemporaryFolder folder;
  SweepOptions options;
  options.output = folder.path() / "study.nc";
  options.threads = 1;
  Ranks alone;
  Diagnostics diagnostics;
  const auto report = sweep(test::study_of(test::yielding_case, folder.path(), "link[1].yield_force", "5e3, 2e4, 4e4"),
                            options, alone, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(report && report->finished && report->failed == 0) << report->first_failure;
  const NetcdfReader file(options.output);
  EXPECT_EQ(file.find("ductility_1"), nullptr);
  EXPECT_EQ(file.numbers("ductility_2").size(), 6U);  // runs × storeys
  EXPECT_EQ(file.numbers("link_peak_tension").size(), 12U);
  EXPECT_EQ(file.numbers("link_elevation"), (std::vector<double>{3, 6, 6, 6}));
  EXPECT_EQ(file.texts("link_left"), std::vector<std::string>(4, "Elastic"));
  EXPECT_EQ(file.at("link_energy_dissipated").units, "N m");
  EXPECT_EQ(file.at("varied").units, "N");
  for (const char* name : {"ductility_2", "hysteretic_energy_2", "ductility_no_contact_2", "link_peak_compression",
                           "link_peak_opening", "link_energy_dissipated"}) {
    for (const double value : file.numbers(name)) EXPECT_GE(value, -1e-9) << name;  // round-off of some N·m
  }
  const std::vector<double> ductility = file.numbers("ductility_2");
  EXPECT_GT(*std::max_element(ductility.begin(), ductility.end()), 1);
  for (const char* kind : {"ductility", "residual_drift_ratio", "hysteretic_energy_no_contact", "link_peak_tension",
                           "link_energy_dissipated"}) {
    const Figure figure = make_figure(file, kind);
    ASSERT_EQ(figure.panels.size(), 1U) << kind;  // of one building
    ASSERT_FALSE(figure.panels[0].curves.empty()) << kind;
    for (const Curve& curve : figure.panels[0].curves) {
      for (const double y : curve.y) EXPECT_GE(y, -1e-9) << kind;  // the sizes of residual drifts
    }
  }
}

// What yielding takes has a curve of its own, which ends at the sum over storeys.
TEST(YieldingRun, EnergyFigureShowsWhatYieldingTakes) {
  Diagnostics diagnostics;
  for (const char* const name : {"yielding-pair", "kelvin-voigt-pair"}) {
    Case c = read_case(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml", diagnostics).value();
    Problem problem = make_problem(c);
    SolveOptions options;
    options.output_step = 0.02;
    options.energy_audit = true;
    Response response = solve(problem, c.analysis.solver, options);
    const RunResults run = run_results(std::move(c), std::move(problem), response);
    const Figure figure = make_figure(run, "energy");
    const auto& curves = figure.panels.at(0).curves;
    const auto curve =
        std::find_if(curves.begin(), curves.end(), [](const Curve& one) { return one.label == "yielding"; });
    if (name != std::string("yielding-pair")) {
      EXPECT_EQ(curve, curves.end()) << "nothing yields";
      continue;
    }
    ASSERT_NE(curve, curves.end());
    double sum = 0;
    for (const BuildingPeaks& peaks : response.buildings) sum += peaks.yielding.hysteretic_energy.sum();
    ASSERT_GT(sum, 0);
    EXPECT_NEAR(curve->y.back() / (run.view().shown.force * sum), 1, 1e-9);  // two ways to the same integrals
  }
}

}  // namespace
}  // namespace bentur
