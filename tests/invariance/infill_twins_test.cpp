// Frames with infill stood in plan.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "bentur/io/case/case_toml.h"
#include "tests/invariance/expect_twins.h"
#include "tests/invariance/plan_twin.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// Each of two frames has half of the row's infill. @return how many storeys have lost some of it
int expect_infill(const BuildingPeaks::Infill& plane, const BuildingPeaks::Infill& row, double tolerance) {
  expect_known_alike(2 * plane.force, row.force, tolerance);
  expect_known_alike(2 * plane.shear, row.shear, tolerance);
  expect_known_alike(plane.ductility, row.ductility, tolerance);
  expect_known_alike(plane.strength_left, row.strength_left, tolerance);
  expect_known_alike(2 * plane.energy, row.energy, tolerance);
  expect_known_alike(plane.failed_time, row.failed_time, tolerance);
  expect_known_alike(plane.column_demand, row.column_demand, tolerance);
  return static_cast<int>((row.strength_left.array() < 1).count());
}

/// A frame with infill in some storeys, whose hinges form and whose columns break or not, beside a stick.
std::string infilled_row(const std::string& infill, const std::string& columns, const std::string& base) {
  return "units = { length = \"m\", force = \"kN\" }\n"
         "[[building]]\nname = \"A\"\ndamping = { stiffness_proportional = 0.002 }\n" +
         base +
         "frame = { elastic_modulus = 25e6, mass_matrix = \"lumped\", storey_heights = [3.5, 3.2, 3.2], "
         "bay_widths = [5, 4], floor_masses = [50, 50, 40], columns = [{ width = 0.35, depth = 0.35, mass = 0.0" +
         columns + " }], beams = [{ width = 0.3, depth = 0.45, mass = 0.0 }], infill = " + infill +
         " }\n"
         "[[building]]\nname = \"B\"\ndamping = { stiffness_proportional = 0.002 }\n"
         "stick = { storey_heights = [3.5, 3.2, 3.2], masses = [60, 60, 50], stiffnesses = [30e3, 25e3, 20e3] }\n"
         "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.01\ncontact = { law = \"linear\", stiffness = 2e5 }\n"
         "[excitation]\nkind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 0.03\n"
         "[analysis]\nduration = 4\n";
}

TEST(PlanTwins, OfFramesWithInfill) {
  const std::string masonry = "{ thickness = 0.15, modulus = 3e6, strength = 1.5e3, sliding_strength = 120 }";
  const std::string by_numbers =
      "{ stiffness = 20e3, yield = 60, cap = 1.2, plastic_drift = 0.004, softening_drift = 0.006, residual = "
      "0.1, "
      "ultimate_drift = 0.02 }";
  const std::string columns[] = {"", ", moment_capacity = 90.0", ", shear_capacity = 70.0, residual_shear = 0.3"};
  const std::string infills[] = {"[{}, " + masonry + ", {}]", "[" + by_numbers + "]",
                                 "[" + masonry + ", {}, " + by_numbers + "]"};
  Eigen::Matrix2d quarter;
  quarter << 0, -1, 1, 0;
  int lost = 0, twins = 0;
  for (const std::string& infill : infills) {
    for (const std::string& column : columns) {
      Diagnostics diagnostics;
      const auto row = read_case_text(infilled_row(infill, column, ""), "row.toml", diagnostics);
      ASSERT_TRUE(row) << diagnostics.errors().front().text();
      const SolveOptions options{.output_step = 0.05, .levels = true, .energy_audit = true};
      const Response wanted = solve(make_problem(*row), ExactSolver{}, options);
      for (const Eigen::Matrix2d& map : {Eigen::Matrix2d(Eigen::Matrix2d::Identity()), quarter}) {
        SCOPED_TRACE(testing::Message() << infill << column << "\n" << map);
        const auto twin = twin_of(*row, 2, map);
        ASSERT_TRUE(twin);
        const PlanProblem problem = make_plan_problem(*twin);
        const PlanResponse plan = solve(problem, ExactSolver{}, options);
        expect_twins(problem, plan, wanted, 1e-8, map(0, 0) == 0);
        // What columns that break let go in an instant is large beside what has come in by then.
        EXPECT_LE(plan.energy->relative_residual(), column.find("shear_capacity") == column.npos ? 1e-12 : 1e-11);
        for (const std::size_t p : {0U, 1U}) {
          lost += expect_infill(plan.buildings[0].planes[p].frame.infill, wanted.buildings[0].infill, 1e-8);
        }
        const Eigen::Index panels = wanted.histories.infill_force[0].rows();  // of two frames, one after the other
        for (const auto& [of_plan, of_row, half] :
             {std::tuple(&plan.histories.infill_force, &wanted.histories.infill_force, 0.5),
              std::tuple(&plan.histories.infill_shortening, &wanted.histories.infill_shortening, 1.0)}) {
          ASSERT_EQ((*of_plan)[0].rows(), 2 * panels);
          const double largest = (*of_row)[0].cwiseAbs().maxCoeff();
          for (const Eigen::Index at : {Eigen::Index{0}, panels}) {
            EXPECT_LE(((*of_plan)[0].middleRows(at, panels) - half * (*of_row)[0]).cwiseAbs().maxCoeff(),
                      1e-7 * largest);
          }
        }
        ++twins;
      }
    }
  }
  EXPECT_EQ(twins, 18);
  EXPECT_GT(lost, 8);
  std::printf("%d twins, %d storeys that lost some of their infill\n", twins, lost);
}

}  // namespace
}  // namespace bentur
