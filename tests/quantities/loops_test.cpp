// What links and foundations on soil do over time: told in files of results and read again.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/results/run_variables.h"
#include "tests/support/drawn_run.h"
#include "tests/support/kinds_case.h"

namespace bentur {
namespace {

using Eigen::Index;

/// F = k x + c ẋ of a row of samples that are close together, up to what differences of them leave of ẋ.
void expect_spring_and_dashpot(const Impedance& of, const Eigen::RowVectorXd& x, const Eigen::RowVectorXd& force,
                               double step) {
  const double largest = force.cwiseAbs().maxCoeff();
  ASSERT_GT(largest, 0);
  for (Index n = 1; n + 1 < x.size(); ++n) {
    const double speed = (x(n + 1) - x(n - 1)) / (2 * step);
    EXPECT_NEAR(force(n), of.stiffness * x(n) + of.damping * speed, 2e-3 * largest) << n;
  }
}

double step_of(const RunResults& run) { return run.response.histories.time.at(1); }

TEST(Loops, ALinkOfSpringAndDashpot) {
  const RunResults run = test::drawn_run(test::linked, 5e-4);
  const Histories& histories = run.response.histories;
  ASSERT_EQ(histories.link_force.rows(), 2);
  expect_spring_and_dashpot({.stiffness = 1e6, .damping = 1e4}, histories.link_deformation.row(1),
                            histories.link_force.row(1), step_of(run));
  const Eigen::RowVectorXd approach = histories.displacement[0].row(0) - histories.displacement[1].row(0);
  EXPECT_LT((histories.link_deformation.row(1) - approach).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Loops, TheSoilUnderAFoundation) {
  const RunResults run = test::drawn_run(test::every_kind, 5e-4);
  const Eigen::MatrixXd& foundation = run.response.histories.foundation.at(2);
  ASSERT_EQ(foundation.rows(), 4);
  EXPECT_EQ(run.response.histories.foundation[1].rows(), 0) << "it stands on bearings";
  const StructuralModel& model = run.problem.buildings[2].model;
  const HalfSpace half_space{.shear_wave_velocity = 200, .density = 1.9, .poisson = 0.33, .radius = 6};
  const Soil soil = soil_of(half_space, 100, 900);
  EXPECT_EQ(model.foundation->under_sway.stiffness, soil.sway.stiffness);
  expect_spring_and_dashpot(soil.sway, foundation.row(0), foundation.row(2), step_of(run));
  expect_spring_and_dashpot(soil.rocking, foundation.row(1), foundation.row(3), step_of(run));
}

/// Equal to the bit; of what is not there no file tells how long it would be.
bool same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.size() == 0 || b.size() == 0) return a.size() == b.size();
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

TEST(Loops, AreReadBackFromTheHistories) {
  for (const char* const text : {test::linked, test::every_kind}) {
    const RunResults run = test::drawn_run(text);
    const NetcdfReader file(histories_netcdf(run, "1"), "histories.nc");
    EXPECT_EQ(file.has("link_force"), !run.problem.links.empty());
    const RunResults read = read_run(file);
    for (const auto part : {&Response::histories, &Response::course}) {
      const Histories &given = run.response.*part, &found = read.response.*part;
      EXPECT_TRUE(same(found.link_deformation, given.link_deformation));
      EXPECT_TRUE(same(found.link_force, given.link_force));
      for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
        EXPECT_TRUE(same(found.foundation.at(b), given.foundation.at(b)));
      }
    }
  }
}

}  // namespace
}  // namespace bentur
