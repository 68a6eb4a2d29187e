// Frames on soil that hardly gives way answer as on a fixed base.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/solve/solver.h"
#include "tests/support/column_case.h"

namespace bentur {
namespace {

/// Peaks of both frames, of their floors, storeys and struck columns, and of the contacts.
std::vector<Eigen::VectorXd> peaks_on(const std::optional<Soil>& soil, double width) {
  Diagnostics diagnostics;
  Case c = read_case_text(test::struck_columns, "case.toml", diagnostics).value();
  c.gaps[0].widths.assign(4, width);
  for (BuildingSpec& building : c.buildings) {
    if (soil) building.soil = SoilSpec{*soil, {}};
  }
  const Response response = solve(make_problem(c));
  std::vector<Eigen::VectorXd> peaks;
  for (const BuildingPeaks& building : response.buildings) {
    peaks.push_back(building.displacement);
    peaks.push_back(building.drift_ratio);
    peaks.push_back(building.acceleration);
    peaks.push_back(building.storey_shear);
    peaks.push_back(building.column_forces);
  }
  Eigen::VectorXd forces(4);
  for (std::size_t i = 0; i < 4; ++i) forces(static_cast<Eigen::Index>(i)) = response.points[i].peak_force;
  peaks.push_back(forces);
  return peaks;
}

/// The largest difference, of each list over its largest number.
double apart(const std::vector<Eigen::VectorXd>& a, const std::vector<Eigen::VectorXd>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double largest = b[i].cwiseAbs().maxCoeff();
    if (largest > 0) most = std::max(most, (a[i] - b[i]).cwiseAbs().maxCoeff() / largest);
  }
  return most;
}

// A foundation of mass m on a spring k yields to the ground's acceleration by the part ω₁² m/k of what the frame does,
// and round-off in ω₁² grows with k/m: neither can be below 1e-8 where the other is. So the soil is made ten times
// stiffer, and what remains of its yielding, which is linear in 1/k, is taken off.
TEST(StiffSoil, IsAFixedBase) {
  const Soil soft{.sway = {1e12, 0}, .rocking = {2e13, 0}, .mass = 1e4, .inertia = 2e5};
  Soil stiff = soft;
  stiff.sway.stiffness *= 10;
  stiff.rocking.stiffness *= 10;
  for (const double width : {10.0, 0.01}) {  // without contact and with it
    const std::vector<Eigen::VectorXd> fixed = peaks_on(std::nullopt, width);
    const std::vector<Eigen::VectorXd> one = peaks_on(soft, width);
    const std::vector<Eigen::VectorXd> ten = peaks_on(stiff, width);
    EXPECT_NEAR(apart(ten, fixed) / apart(one, fixed), 0.1, 0.02) << width;
    std::vector<Eigen::VectorXd> limit = ten;
    for (std::size_t i = 0; i < limit.size(); ++i) limit[i] += (ten[i] - one[i]) / 9;
    EXPECT_LE(apart(limit, fixed), 1e-8) << width;
    EXPECT_GT(apart(one, fixed), 1e-8) << "else this proves nothing";
  }
}

}  // namespace
}  // namespace bentur
