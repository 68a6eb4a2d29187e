// Buildings in plan on bearings: rows stood in plan, and random ones that turn.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/story/story.h"
#include "tests/invariance/portal.h"
#include "tests/support/plan_run.h"

namespace bentur::plan_bearings {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::plan_run;
using test::portal;

const std::string units = "units = { length = \"m\", force = \"kN\" }\n";
const std::string shaken =
    "[excitation]\nkind = \"harmonic\"\nperiod = 0.9\ndisplacement_amplitude = 0.08\n[analysis]\nduration = 6\n";
const std::string contact = "contact = { law = \"kelvin-voigt\", stiffness = 3e5, restitution = 0.6 }\n";

void expect_alike(const VectorXd& plan, const VectorXd& row, const char* what) {
  ASSERT_EQ(plan.size(), row.size()) << what;
  EXPECT_LE((plan - row).cwiseAbs().maxCoeff(), 1e-9 * row.cwiseAbs().maxCoeff()) << what << "\n"
                                                                                  << plan << "\n\n"
                                                                                  << row;
}

/// All bearings of a row, and one of four of its twin.
struct Laws {
  std::string all, one;
};

/// A on bearings between a moat's wall and B, which stands on firm ground.
TEST(PlanBearings, FourAreTheRowsBearings) {
  for (const Laws& law :
       {Laws{"stiffness = 3000, damping = 40", "stiffness = 750, damping = 10"},
        Laws{"stiffness = 3000, characteristic_strength = 60, yield_displacement = 0.01",
             "stiffness = 750, characteristic_strength = 15, yield_displacement = 0.01"},
        Laws{"friction_pendulum = { coefficient = 0.05, radius = 1.2, yield_displacement = 0.001 }",
             "friction_pendulum = { coefficient = 0.05, radius = 1.2, yield_displacement = 0.001 }"}}) {
    SCOPED_TRACE(law.all);
    const std::string a = "[[building]]\nname = \"A\"\ndamping = 0.04\np_delta = true\n",
                      b = "[[building]]\nname = \"B\"\ndamping = 0.05\n",
                      wall = "[[building]]\nname = \"W\"\nrigid = true\nelevations = [0]\n";
    Diagnostics d;
    const auto c = read_case_text(
        units + wall + a + "stick = { storey_heights = [3.5, 3.2], masses = [40, 30], stiffnesses = [12e3, 9e3] }\n" +
            "isolation = { mass = 35, " + law.all + " }\n" + b +
            "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n" +
            "[[gap]]\nbetween = [\"W\", \"A\"]\nwidth = 0.07\n" + contact +
            "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.05\n" + contact + shaken,
        "row.toml", d);
    ASSERT_TRUE(c) << d.errors().front().text();
    const Problem row_problem = make_problem(*c);
    const Response row = solve(row_problem);
    for (const bool turned : {false, true}) {
      SCOPED_TRACE(turned);
      const auto pair = [&](double x, double y) {
        return turned ? fmt::format("[{}, {}]", y, x) : fmt::format("[{}, {}]", x, y);
      };
      const auto held = [&](const std::string& k) {
        return fmt::format("rigidity = {{ centre = {}, {} = {}, {} = 1e7, torsion = 1e9 }}\n", pair(5, 7),
                           turned ? "y" : "x", k, turned ? "x" : "y");
      };
      const PlanRun p = plan_run(
          units + "[plan]\nclearance = 0.1\n" + contact + wall + "plan = { corner = " + pair(-0.57, 0) +
          ", size = " + pair(0.5, 14) + " }\n" + a + "plan = { corner = [0, 0], size = " + pair(10, 14) +
          ", storey_heights = [3.5, 3.2], masses = [40, 30] }\n" + held("[12e3, 9e3]") +
          "isolation = { mass = 35, bearing = [{ at = [" + pair(1, 2) + ", " + pair(9, 2) + ", " + pair(1, 12) + ", " +
          pair(9, 12) + "], " + law.one + " }] }\n" + b + "plan = { corner = " + pair(10.05, 0) +
          ", size = " + pair(10, 14) + ", storey_heights = [3.5, 3.2], masses = [20, 18] }\n" + held("[30e3, 25e3]") +
          (turned ? test::with(shaken, "[analysis]", "angle = 90.0\n[analysis]") : shaken));
      ASSERT_EQ(p.response.status, Status::done) << p.response.message;
      EXPECT_LE(p.response.energy->relative_residual(), 1e-11);
      EXPECT_EQ(p.problem.buildings[1].modes.omega.size(), 9);
      int impacts = 0;
      for (const PointSummary& point : row.points) impacts += point.impacts;
      EXPECT_GT(impacts, 2);
      EXPECT_GT(row.points[0].impacts, 0);  // the slab meets the wall
      EXPECT_EQ(static_cast<int>(p.response.impacts.size()), 2 * impacts);
      for (std::size_t i = 1; i < 3; ++i) {
        const PlanPeaks& f = p.response.buildings[i];
        expect_alike(turned ? f.y : f.x, row.buildings[i].displacement, "displacement");
        expect_alike(turned ? f.acceleration_y : f.acceleration_x, row.buildings[i].acceleration, "acceleration");
        expect_alike(turned ? f.shear_y : f.shear_x, row.buildings[i].storey_shear, "shear");
        EXPECT_LE(14 * f.rotation.maxCoeff(), 1e-9 * (turned ? f.y : f.x).maxCoeff());
      }
      const PlanPeaks::Bearings& found = p.response.buildings[1].bearings;
      expect_alike(turned ? found.y : found.x, VectorXd::Constant(4, row.buildings[1].displacement(0)), "bearings");
      expect_alike(4 * (turned ? found.force_y : found.force_x),
                   VectorXd::Constant(4, row.buildings[1].storey_shear(0)), "forces of bearings");
      if (row_problem.buildings[1].storeys_yield()) {
        const double lost = row.buildings[1].yielding.hysteretic_energy(0);
        EXPECT_GT(lost, 0);
        EXPECT_NEAR(found.hysteretic_energy.sum(), lost, 1e-9 * lost);
      }
    }
  }
}

/// A row's frame with hinges on bearings, stood as two of half of it.
TEST(PlanBearings, FramesWithHingesAreTheRows) {
  const std::string b = "[[building]]\nname = \"B\"\ndamping = 0.05\n",
                    half = "frame = " + portal("1.5e7", 25, 20, "") + " }\n";
  for (const std::string gravity : {"", "p_delta = true\n"}) {
    SCOPED_TRACE(gravity);
    const std::string a = "[[building]]\nname = \"A\"\ndamping = 0.04\n" + gravity;
    Diagnostics d;
    const auto c = read_case_text(
        units + a + "frame = " + portal("3e7", 50, 40, "storey_heights = [3.5, 3.2], ") +
            ", floor_masses = [40, 30], mass_matrix = \"lumped\" }\nisolation = { mass = 35, stiffness = 3000, "
            "characteristic_strength = 60, yield_displacement = 0.01 }\n" +
            b + "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n" +
            "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.05\n" + contact + shaken,
        "row.toml", d);
    ASSERT_TRUE(c) << d.errors().front().text();
    const Response row = solve(make_problem(*c));
    const PlanRun p =
        plan_run(units + "[plan]\nclearance = 0.1\n" + contact + a +
                 "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [40, 30] }\n" +
                 "isolation = { mass = 35, bearing = [{ at = [[1, 2], [9, 2], [1, 12], [9, 12]], stiffness = 750, "
                 "characteristic_strength = 15, yield_displacement = 0.01, yield_sides = 8 }] }\n" +
                 "[[building.plane]]\nalong = \"x\"\nat = 1\n" + half + "[[building.plane]]\nalong = \"x\"\nat = 13\n" +
                 half + "[[building.plane]]\nalong = \"y\"\nat = 5\nstiffnesses = 1e7\n" + b +
                 "plan = { corner = [10.05, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [20, 18] }\n"
                 "rigidity = { centre = [5, 7], x = [30e3, 25e3], y = 1e7, torsion = 1e9 }\n" +
                 shaken);
    ASSERT_EQ(p.response.status, Status::done) << p.response.message;
    EXPECT_LE(p.response.energy->relative_residual(), 1e-11);
    EXPECT_GT(p.response.impacts.size(), 4U);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_alike(p.response.buildings[i].x, row.buildings[i].displacement, "displacement");
      expect_alike(p.response.buildings[i].shear_x, row.buildings[i].storey_shear, "shear");
    }
    const PlanPeaks& found = p.response.buildings[0];
    const BuildingPeaks& wanted = row.buildings[0];
    const double lost = wanted.yielding.hysteretic_energy(0);
    EXPECT_NEAR(found.bearings.hysteretic_energy.sum(), lost, 1e-9 * lost);
    const Story story = run_story(p);
    const auto yields = std::find_if(story.statements.begin(), story.statements.end(),
                                     [](const Statement& one) { return one.kind == "bearings_yield"; });
    ASSERT_NE(yields, story.statements.end());
    EXPECT_NEAR(std::get<double>(yields->values[1].value), wanted.yielding.ductility(0), 1e-8);
    const std::vector<BuildingPeaks::Hinge>& hinges = found.planes[0].frame.hinges;
    ASSERT_EQ(hinges.size(), wanted.hinges.size());
    double turned = 0;
    for (std::size_t h = 0; h < hinges.size(); ++h) {
      EXPECT_NEAR(hinges[h].peak_rotation, wanted.hinges[h].peak_rotation, 1e-10) << h;
      EXPECT_NEAR(hinges[h].peak_moment, 0.5 * wanted.hinges[h].peak_moment, 1e-9 * wanted.hinges[h].peak_moment) << h;
      turned = std::max(turned, wanted.hinges[h].peak_rotation);
    }
    EXPECT_GT(turned, 1e-3);
    const StructuralModel told = frames_of(p).problem.buildings[0].model;  // by which hinges are drawn and told
    EXPECT_EQ(told.elevations[told.hinges.places[0].level - 1 + told.first_storey()], 3.5);
    const VectorXd shear = found.planes[0].shear + found.planes[1].shear;
    expect_alike(shear.tail(2), wanted.storey_shear.tail(2), "shear of planes");
  }
}

/// Storeys that yield above bearings that yield: damping follows the stiffness of those alone.
TEST(PlanBearings, DampingThatFollowsStiffnessIsTheRows) {
  const std::string a = "[[building]]\nname = \"A\"\ndamping = { stiffness_proportional = 0.03 }\n"
                        "damping_stiffness = \"tangent\"\n",
                    b = "[[building]]\nname = \"B\"\ndamping = 0.05\n",
                    plane =
                        "[[building.plane]]\nalong = \"x\"\nstiffnesses = [6e3, 4.5e3]\nyield_forces = [70, 40]\n"
                        "hardening = 0.05\nat = ";
  Diagnostics d;
  const auto c = read_case_text(
      units + a +
          "stick = { storey_heights = [3.5, 3.2], masses = [40, 30], stiffnesses = [12e3, 9e3], yield_forces = "
          "[140, 80], hardening = 0.05 }\nisolation = { mass = 35, stiffness = 3000, characteristic_strength = 60, "
          "yield_displacement = 0.01 }\n" +
          b +
          "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n[[gap]]\nbetween = "
          "[\"A\", \"B\"]\nwidth = 0.05\n" +
          contact + shaken,
      "row.toml", d);
  ASSERT_TRUE(c) << d.errors().front().text();
  const Response row = solve(make_problem(*c));
  const BuildingPeaks& wanted = row.buildings[0];
  ASSERT_GT(wanted.yielding.ductility(0), 2);
  ASSERT_GT(wanted.yielding.ductility(1), 1.1);
  const PlanRun p = plan_run(
      units + "[plan]\nclearance = 0.1\n" + contact + a +
      "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [40, 30] }\n" + plane + "1\n" +
      plane + "13\n[[building.plane]]\nalong = \"y\"\nat = 5\nstiffnesses = 1e7\n" +
      "[building.isolation]\nmass = 35\nbearing = [{ at = [[1, 2], [9, 2], [1, 12], [9, 12]], stiffness = 750, "
      "characteristic_strength = 15, yield_displacement = 0.01 }]\n" +
      b +
      "plan = { corner = [10.05, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [20, 18] }\n"
      "rigidity = { centre = [5, 7], x = [30e3, 25e3], y = 1e7, torsion = 1e9 }\n" +
      shaken);
  ASSERT_EQ(p.response.status, Status::done) << p.response.message;
  EXPECT_LE(p.response.energy->relative_residual(), 1e-11);
  expect_alike(p.response.buildings[0].x, wanted.displacement, "displacement");
  expect_alike(p.response.buildings[0].shear_x, wanted.storey_shear, "shear");
  EXPECT_NEAR(p.response.buildings[0].planes[0].yielding.ductility(1), wanted.yielding.ductility(1), 1e-8);
}

struct Random {
  std::mt19937 engine;
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine); }
};

/// Two eccentric buildings, A on bearings anywhere of three kinds, shaken both ways; `quarter`: turned by 90°.
std::string eccentric(unsigned seed, bool quarter, const std::string& solver) {
  Random random{std::mt19937(seed)};
  const auto any = [&](double from, double to) { return random.any(from, to); };
  const int sides = seed % 2 == 0 ? 12 : 4;
  const double w = any(9, 13), h = any(10, 15), gap = any(0.02, 0.05), shift = any(-4, 4), other = any(9, 14);
  const auto local = [&](double width, double height, double x, double y) {
    (void)width;
    return quarter ? fmt::format("[{:.17g}, {:.17g}]", height - y, x) : fmt::format("[{:.17g}, {:.17g}]", x, y);
  };
  const auto plan = [&](double x, double y, double width, double height, const std::string& masses) {
    const std::string corner =
        quarter ? fmt::format("[{:.17g}, {:.17g}]", -y - height, x) : fmt::format("[{:.17g}, {:.17g}]", x, y);
    const std::string size =
        quarter ? fmt::format("[{:.17g}, {:.17g}]", height, width) : fmt::format("[{:.17g}, {:.17g}]", width, height);
    return "plan = { corner = " + corner + ", size = " + size + ", storey_heights = [3.5, 3.2], masses = " + masses +
           ", centres_of_mass = " + local(width, height, any(0.4, 0.6) * width, any(0.4, 0.6) * height) + " }\n";
  };
  const auto rigidity = [&](double width, double height) {
    const double x = any(2e4, 6e4), y = any(2e4, 6e4), torsion = any(8e5, 3e6);
    return fmt::format("rigidity = {{ centre = {}, x = {:.17g}, y = {:.17g}, torsion = {:.17g} }}\n",
                       local(width, height, any(0.4, 0.6) * width, any(0.4, 0.6) * height), quarter ? y : x,
                       quarter ? x : y, torsion);
  };
  std::string text = units + "[plan]\nclearance = 0.06\n" + contact + "[[building]]\nname = \"A\"\ndamping = 0.03\n" +
                     "gravity_loads = [1200, 900]\n";
  text += plan(0, 0, w, h, "[60, 45]") + rigidity(w, h);
  text += "isolation = { mass = 50, centre = " + local(w, h, any(0.45, 0.55) * w, any(0.45, 0.55) * h) +
          ", bearing = [\n{ at = [" + local(w, h, any(0, 3), any(0, 3)) + ", " + local(w, h, any(w - 3, w), any(0, 3)) +
          "], stiffness = " + std::to_string(any(400, 900)) +
          ", characteristic_strength = " + std::to_string(any(5, 20)) +
          ", yield_displacement = 0.008, yield_sides = " + std::to_string(sides) +
          " },\n{ at = " + local(w, h, any(0, 3), any(h - 3, h)) +
          ", friction_pendulum = { coefficient = 0.04, radius = 1.5, yield_displacement = 0.002 }, yield_sides = " +
          std::to_string(sides) + " },\n{ at = " + local(w, h, any(w - 3, w), any(h - 3, h)) +
          ", stiffness = " + std::to_string(any(400, 1500)) + ", damping = 30 }] }\n";
  text += "[[building]]\nname = \"B\"\ndamping = 0.05\n" + plan(w + gap, shift, 10, other, "[80, 70]") +
          rigidity(10, other);
  return text +
         fmt::format(
             "[excitation]\nkind = \"harmonic\"\nperiod = {}\ndisplacement_amplitude = {}\nangle = {}\n"
             "[excitation.y]\nkind = \"harmonic\"\nperiod = {}\ndisplacement_amplitude = {}\n"
             "[analysis]\nduration = 4\n",
             any(0.6, 1.2), any(0.04, 0.08), quarter ? 90 : 0, any(0.5, 1), any(0.02, 0.05)) +
         solver;
}

double apart(const VectorXd& one, const VectorXd& other) {
  return (one - other).cwiseAbs().maxCoeff() / one.cwiseAbs().maxCoeff();
}

TEST(PlanBearings, RandomOnesByBothSolversEnergyAndTurned) {
  int impacts = 0;
  double turns = 0, lost = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const PlanRun exact = plan_run(eccentric(seed, false, ""));
    const PlanRun adaptive = plan_run(eccentric(seed, false, "solver = \"adaptive\"\ntolerance = 1e-12\n"));
    const PlanRun turned = plan_run(eccentric(seed, true, ""));
    ASSERT_EQ(exact.response.status, Status::done) << exact.response.message;
    ASSERT_EQ(adaptive.response.status, Status::done) << adaptive.response.message;
    EXPECT_LE(exact.response.energy->relative_residual(), 1e-12);
    EXPECT_TRUE(exact.response.discrepancies.empty());
    ASSERT_EQ(exact.response.impacts.size(), adaptive.response.impacts.size());
    ASSERT_EQ(exact.response.impacts.size(), turned.response.impacts.size());
    impacts += static_cast<int>(exact.response.impacts.size());
    const PlanPeaks &a = exact.response.buildings[0], &b = adaptive.response.buildings[0],
                    &c = turned.response.buildings[0];
    ASSERT_EQ(a.bearings.x.size(), 4);
    EXPECT_LE(apart(a.x, b.x), 1e-8);
    EXPECT_LE(apart(a.rotation, b.rotation), 1e-8);
    EXPECT_LE(apart(a.shear_y, b.shear_y), 1e-8);
    EXPECT_LE(apart(a.torque, b.torque), 1e-8);
    EXPECT_LE(apart(a.bearings.force_x, b.bearings.force_x), 1e-8);
    EXPECT_LE(apart(a.bearings.y, b.bearings.y), 1e-8);
    EXPECT_LE(apart(a.bearings.hysteretic_energy, b.bearings.hysteretic_energy), 1e-8);
    EXPECT_LE(apart(a.x, c.y), 1e-9);
    EXPECT_LE(apart(a.rotation, c.rotation), 1e-9);
    EXPECT_LE(apart(a.torque, c.torque), 1e-9);
    EXPECT_LE(apart(a.bearings.x, c.bearings.y), 1e-9);
    EXPECT_LE(apart(a.bearings.force_y, c.bearings.force_x), 1e-9);
    EXPECT_LE(apart(a.bearings.residual_x, c.bearings.residual_y), 1e-8);
    turns = std::max(turns, a.rotation(0));
    lost = std::max(lost, a.bearings.hysteretic_energy.sum());
    // Histories reach the peaks, and the four forces are the storey's.
    const Eigen::MatrixXd& all = exact.response.histories.bearing[0];
    ASSERT_EQ(all.rows(), 16);
    for (Index n = 0; n < 4; ++n) {
      const double largest = all.row(2 * n).cwiseAbs().maxCoeff();
      EXPECT_LE(largest, a.bearings.x(n) * (1 + 1e-9));
      EXPECT_GE(largest, 0.98 * a.bearings.x(n));
    }
    const VectorXd sum = all.row(8) + all.row(10) + all.row(12) + all.row(14);
    EXPECT_LE(sum.cwiseAbs().maxCoeff(), a.shear_x(0) * (1 + 1e-9));
    EXPECT_GE(sum.cwiseAbs().maxCoeff(), 0.98 * a.shear_x(0));
  }
  std::printf("6 plans on bearings, %d impacts, turned by up to %.3g rad, %.3g dissipated\n", impacts, turns, lost);
  EXPECT_GT(impacts, 12);
  EXPECT_GT(turns, 1e-3);
  EXPECT_GT(lost, 1);
}

}  // namespace
}  // namespace bentur::plan_bearings
