// Rows of sticks on soil stood in plan, along x and, turned, along y.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "tests/invariance/portal.h"
#include "tests/support/plan_run.h"

namespace bentur::plan_soils {
namespace {

using Eigen::VectorXd;
using test::plan_run;
using test::portal;

const std::string units = "units = { length = \"m\", force = \"kN\" }\n";
const std::string shaken =
    "[excitation]\nkind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 0.03\n[analysis]\nduration = 5\n";
const std::string soil =
    "sway = { stiffness = 6e4, damping = 200 }, rocking = { stiffness = 2e6, damping = 3e3 }, "
    "foundation = { mass = 30, inertia = 250 }";
const std::string contact = "contact = { law = \"kelvin-voigt\", stiffness = 3e5, restitution = 0.6 }\n";
const std::string gap = "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.005\n" + contact;

void expect_alike(const VectorXd& plan, const VectorXd& row, const char* what) {
  ASSERT_EQ(plan.size(), row.size()) << what;
  EXPECT_LE((plan - row).cwiseAbs().maxCoeff(), 1e-9 * row.cwiseAbs().maxCoeff()) << what;
}

/// What the foundation of A does at samples: within its peaks, near them, and by its springs and dashpots.
void expect_histories(const PlanResponse& response, bool turned) {
  ASSERT_EQ(response.histories.foundation.size(), 2U);
  EXPECT_EQ(response.histories.foundation[1].rows(), 0);
  const Eigen::MatrixXd& all = response.histories.foundation[0];
  ASSERT_EQ(all.rows(), 10);
  for (const Eigen::Index i : {turned ? 1 : 0, turned ? 3 : 2}) {
    const double peak = response.buildings[0].foundation(i), largest = all.row(i).cwiseAbs().maxCoeff();
    EXPECT_LE(largest, peak * (1 + 1e-9));
    EXPECT_GE(largest, 0.95 * peak);
    const double stiffness = i < 2 ? 6e4 : 2e6, damping = i < 2 ? 200 : 3e3, step = response.histories.time[1];
    double apart = 0;
    for (Eigen::Index k = 1; k + 1 < all.cols(); ++k) {
      const double speed = (all(i, k + 1) - all(i, k - 1)) / (2 * step);  // to the second order of the step
      apart = std::max(apart, std::abs(stiffness * all(i, k) + damping * speed - all(5 + i, k)));
    }
    EXPECT_LE(apart, 0.02 * all.row(5 + i).cwiseAbs().maxCoeff());
  }
}

TEST(PlanSoils, ATwinIsTheRow) {
  for (const std::string gravity : {"", "p_delta = true\n"}) {
    const std::string a = "[[building]]\nname = \"A\"\ndamping = 0.04\n" + gravity,
                      b = "[[building]]\nname = \"B\"\ndamping = 0.05\n";
    Diagnostics d;
    const auto c = read_case_text(
        units + a + "stick = { storey_heights = [3.5, 3.2], masses = [40, 30], stiffnesses = [12e3, 9e3] }\nsoil = { " +
            soil + " }\n" + b +
            "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n" + gap + shaken,
        "row.toml", d);
    ASSERT_TRUE(c) << d.errors().front().text();
    const Response row = solve(make_problem(*c));
    for (const bool turned : {false, true}) {
      const std::string size = turned ? "[14, 10]" : "[10, 14]", centre = turned ? "[7, 5]" : "[5, 7]";
      const auto held = [&](const std::string& k) {
        return "rigidity = { centre = " + centre + (turned ? ", y = " : ", x = ") + k + (turned ? ", x" : ", y") +
               " = 1e7, torsion = 1e9 }\n";
      };
      const PlanRun p =
          plan_run(units + "[plan]\nclearance = 0.02\n" + contact + a + "plan = { corner = [0, 0], size = " + size +
                   ", storey_heights = [3.5, 3.2], masses = [40, 30] }\n" + held("[12e3, 9e3]") + "soil = { " + soil +
                   ", twist = { stiffness = 3e6, damping = 100 } }\n" + b +
                   "plan = { corner = " + (turned ? "[0, 10.005]" : "[10.005, 0]") + ", size = " + size +
                   ", storey_heights = [3.5, 3.2], masses = [20, 18] }\n" + held("[30e3, 25e3]") +
                   (turned ? test::with(shaken, "[analysis]", "angle = 90.0\n[analysis]") : shaken));
      ASSERT_EQ(p.response.status, Status::done) << p.response.message;
      EXPECT_LE(p.response.energy->relative_residual(), 1e-11);
      for (std::size_t i = 0; i < 2; ++i) {
        const PlanPeaks& f = p.response.buildings[i];
        expect_alike(turned ? f.y : f.x, row.buildings[i].displacement, "displacement");
        expect_alike(turned ? f.acceleration_y : f.acceleration_x, row.buildings[i].acceleration, "acceleration");
        expect_alike(turned ? f.shear_y : f.shear_x, row.buildings[i].storey_shear, "shear");
      }
      const VectorXd& base = p.response.buildings[0].foundation;
      ASSERT_EQ(base.size(), 5);
      EXPECT_NEAR(base(turned ? 1 : 0), row.buildings[0].foundation(0), 1e-9 * row.buildings[0].foundation(0));
      EXPECT_NEAR(base(turned ? 3 : 2), row.buildings[0].foundation(1), 1e-9 * row.buildings[0].foundation(1));
      expect_histories(p.response, turned);
    }
  }
}

/// Two planes with half of the row's frame each, whose hinges follow a base that sways and rocks.
TEST(PlanSoils, FramesWithHingesAreTheRows) {
  for (const std::string gravity : {"", "p_delta = true\n"}) {
    const std::string a = "[[building]]\nname = \"A\"\ndamping = 0.04\n" + gravity,
                      b = "[[building]]\nname = \"B\"\ndamping = 0.05\n";
    Diagnostics d;
    const auto c = read_case_text(
        units + a + "frame = " + portal("3e7", 90, 70, "storey_heights = [3.5, 3.2], ") +
            ", floor_masses = [40, 30], mass_matrix = \"lumped\" }\nsoil = { " + soil + " }\n" + b +
            "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n" + gap + shaken,
        "row.toml", d);
    ASSERT_TRUE(c) << d.errors().front().text();
    const Response row = solve(make_problem(*c));
    const std::string half = portal("1.5e7", 45, 35, "") + " }\n";
    const PlanRun p = plan_run(
        units + "[plan]\nclearance = 0.02\n" + contact + a +
        "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [40, 30] }\nsoil = { " +
        soil + ", twist = { stiffness = 3e6, damping = 100 } }\n" +
        "[[building.plane]]\nalong = \"x\"\nat = 1\nframe = " + half +
        "[[building.plane]]\nalong = \"x\"\nat = 13\nframe = " + half +
        "[[building.plane]]\nalong = \"y\"\nat = 5\nstiffnesses = 1e7\n" + b +
        "plan = { corner = [10.005, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [20, 18] }\n"
        "rigidity = { centre = [5, 7], x = [30e3, 25e3], y = 1e7, torsion = 1e9 }\n" +
        shaken);
    ASSERT_EQ(p.response.status, Status::done) << p.response.message;
    EXPECT_LE(p.response.energy->relative_residual(), 1e-11);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_alike(p.response.buildings[i].x, row.buildings[i].displacement, "displacement");
      expect_alike(p.response.buildings[i].shear_x, row.buildings[i].storey_shear, "shear");
    }
    const VectorXd& base = p.response.buildings[0].foundation;
    EXPECT_NEAR(base(0), row.buildings[0].foundation(0), 1e-9 * row.buildings[0].foundation(0));
    EXPECT_NEAR(base(2), row.buildings[0].foundation(1), 1e-9 * row.buildings[0].foundation(1));
    const std::vector<BuildingPeaks::Hinge>&found = p.response.buildings[0].planes[0].frame.hinges,
          &wanted = row.buildings[0].hinges;
    ASSERT_EQ(found.size(), wanted.size());
    double turned = 0;
    for (std::size_t h = 0; h < found.size(); ++h) {
      EXPECT_NEAR(found[h].peak_rotation, wanted[h].peak_rotation, 1e-10) << h;
      turned = std::max(turned, wanted[h].peak_rotation);
    }
    EXPECT_GT(turned, 1e-3);
  }
}

}  // namespace
}  // namespace bentur::plan_soils
