// Rows of frames and links stood in plan, by their case files: symmetric floors, shaken along x. And what turns them.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

using Eigen::VectorXd;
using test::plan_run;

const std::string units = "units = { length = \"m\", force = \"kN\" }\n";
const std::string shaken =
    "[excitation]\nkind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 0.03\n[analysis]\nduration = 5\n";

Response row_response(const std::string& text) {
  Diagnostics diagnostics;
  const auto c = read_case_text(text, "row.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return solve(make_problem(*c));
}

void expect_alike(const VectorXd& plan, const VectorXd& row, const char* what) {
  ASSERT_EQ(plan.size(), row.size()) << what;
  EXPECT_LE((plan - row).cwiseAbs().maxCoeff(), 1e-9 * row.cwiseAbs().maxCoeff()) << what << "\n"
                                                                                  << plan << "\n"
                                                                                  << row;
}

/// Both ends of a stretch have half of each level's force.
void expect_row(const PlanRun& plan, const Response& row) {
  ASSERT_EQ(plan.response.status, Status::done) << plan.response.message;
  ASSERT_EQ(row.status, Status::done) << row.message;
  for (std::size_t b = 0; b < row.buildings.size(); ++b) {
    const PlanPeaks& found = plan.response.buildings[b];
    const BuildingPeaks& wanted = row.buildings[b];
    expect_alike(found.x, wanted.displacement, "displacement");
    expect_alike(plan.response.buildings_no_contact[b].x, wanted.displacement_no_contact, "free displacement");
    expect_alike(found.acceleration_x, wanted.acceleration, "acceleration");
    expect_alike(found.shear_x, wanted.storey_shear, "storey shear");
    EXPECT_LE(found.rotation.maxCoeff() * 14, 1e-9 * found.x.maxCoeff());
  }
  ASSERT_EQ(plan.response.points.size(), 2 * row.points.size());
  int impacts = 0;
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    const PointSummary &one = plan.response.points[2 * i], &other = plan.response.points[2 * i + 1];
    EXPECT_EQ(one.impacts, row.points[i].impacts);
    EXPECT_NEAR(one.impulse + other.impulse, row.points[i].impulse, 1e-9 * row.points[i].impulse);
    EXPECT_NEAR(one.peak_force + other.peak_force, row.points[i].peak_force, 1e-9 * row.points[i].peak_force);
    EXPECT_NEAR(one.gap_needed, row.points[i].gap_needed, 1e-9 * row.points[i].gap_needed);
    impacts += row.points[i].impacts;
  }
  EXPECT_GT(impacts, 0);
}

/// A frame of two bays whose members weigh nothing, with so many times their elastic modulus.
std::string frame_with(const std::string& modulus, const std::string& mass, const std::string& heights) {
  return "{ elastic_modulus = " + modulus + ", " + heights +
         "bay_widths = [5, 4], columns = [{ width = 0.4, depth = " + "0.4" + mass + " }, { width = 0.4, depth = 0.35" +
         mass + " }], beams = [{ area = 0.12, inertia = 0.0016" + mass + " }]";
}

/// frame_with() of half the modulus, seen from behind.
std::string turned_frame() {
  return "{ elastic_modulus = 2.5e7, bay_widths = [4, 5], columns = [{ width = 0.4, depth = 0.4 }, { width = 0.4, "
         "depth = 0.35 }], beams = [{ area = 0.12, inertia = 0.0016 }] }";
}

TEST(PlanParts, TwoEqualFramesAreTheRowsFrame) {
  const std::string row =
      units + "[[building]]\nname = \"A\"\ndamping = 0.04\nframe = " +
      frame_with("5e7", ", mass = 0", "storey_heights = [3.5, 3.2], ") +
      ", floor_masses = [40, 30], mass_matrix = \"lumped\" }\n"
      "[[building]]\nname = \"B\"\ndamping = 0.05\n"
      "stick = { storey_heights = [3.5, 3.2], masses = [20, 18], stiffnesses = [30e3, 25e3] }\n"
      "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.005\ncontact = { law = \"linear\", stiffness = 3e5 }\n" +
      shaken;
  const std::string frame = frame_with("2.5e7", "", "") + " }";
  const std::string plan =
      units +
      "[plan]\nclearance = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
      "[[building]]\nname = \"A\"\ndamping = 0.04\n"
      "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [40, 30] }\n"
      "[[building.plane]]\nalong = \"x\"\nat = 1\nframe = " +
      frame + "\n[[building.plane]]\nalong = \"x\"\nat = 13\nframe = " + frame +
      "\n[[building.plane]]\nalong = \"y\"\nat = 5\nstiffnesses = 1e7\n"
      "[[building]]\nname = \"B\"\ndamping = 0.05\n"
      "plan = { corner = [10.005, 0], size = [10, 14], storey_heights = [3.5, 3.2], masses = [20, 18] }\n"
      "rigidity = { centre = [5, 7], x = [30e3, 25e3], y = 1e7, torsion = 1e9 }\n" +
      shaken;
  const PlanRun found = plan_run(plan);
  Diagnostics diagnostics;
  const auto c = read_case_text(row, "row.toml", diagnostics);
  ASSERT_TRUE(c) << diagnostics.errors().front().text();
  const Building wanted = make_building(c->buildings[0]);
  const VectorXd& omega = found.problem.buildings[0].modes.omega;
  EXPECT_NEAR(omega(0), wanted.modes.omega(0), 1e-12 * omega(0));
  expect_row(found, row_response(row));
  // The frames bear it all, each half.
  const PlanPeaks& peaks = found.response.buildings[0];
  for (const std::size_t p : {0U, 1U}) expect_alike(2 * peaks.planes[p].shear, peaks.shear_x, "half the shear");
}

/// Beams of both, in plan each frame with half of the modulus: E A/(L/2) adds up. The bays are not alike, so that the
/// one at the gap counts; frames that stand along it do not.
TEST(PlanParts, AxialStiffnessIsThatOfTheRowsBeams) {
  for (const bool mirrored : {false, true}) {
    SCOPED_TRACE(mirrored);
    const std::string masses[] = {"[40, 30]", "[20, 18]"};
    const std::string row_frame = frame_with("5e7", ", mass = 0", "storey_heights = [3.5, 3.2], ");
    const auto building = [&](int b) {
      return "[[building]]\nname = \"" + std::string(b == 0 ? "A" : "B") + "\"\ndamping = 0.04\nframe = " + row_frame +
             ", floor_masses = " + masses[b] + ", mass_matrix = \"lumped\" }\n";
    };
    const std::string contact = "contact = { law = \"kelvin-voigt\", stiffness = \"axial\", restitution = 0.65 }\n";
    const std::string row =
        units + building(0) + building(1) + "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.005\n" + contact + shaken;
    const std::string frame = frame_with("2.5e7", "", "") + " }";
    const auto placed = [&](const std::string& at) {
      // Seen from its end the frame goes the other way: the line is turned by 180°, and so are its bays.
      return "[[building.plane]]\n" +
             (mirrored ? "angle = 180\nthrough = [0, " + at + "]" : "along = \"x\"\nat = " + at) +
             "\nframe = " + (mirrored ? turned_frame() : frame) + "\n";
    };
    const auto in_plan = [&](int b) {
      return "[[building]]\nname = \"" + std::string(b == 0 ? "A" : "B") + "\"\ndamping = 0.04\nplan = { corner = [" +
             (b == 0 ? "0" : "9.005") + ", 0], size = [9, 14], storey_heights = [3.5, 3.2], masses = " + masses[b] +
             " }\n" + placed("1") + placed("13") + "[[building.plane]]\nalong = \"y\"\nat = 4.5\nframe = " + frame +
             "\n";
    };
    const PlanRun found = plan_run(units + "[plan]\nclearance = 0.02\n" + contact + in_plan(0) + in_plan(1) + shaken);
    expect_row(found, row_response(row));
  }
}

/// Planes that soften and pinch, each with half of what the row's storeys have.
TEST(PlanParts, TwoEqualPlanesLoseTheStrengthOfTheRows) {
  for (const std::string hysteresis : {"bilinear", "peak-oriented", "pinching"}) {
    SCOPED_TRACE(hysteresis);
    const auto backbone = [&](const std::string& yield) {
      return "{ yield = " + yield + ", cap = 1.1, plastic_drift = 0.01, softening_drift = 0.05, residual = 0.2, " +
             "strength_wear = 30, hysteresis = \"" + hysteresis + "\" }";
    };
    const std::string other = "[[building]]\nname = \"B\"\ndamping = 0.05\n";
    const Response row = row_response(
        units +
        "[[building]]\nname = \"A\"\ndamping = 0.04\n"
        "stick = { storey_heights = [3, 3], masses = [30, 25], stiffnesses = [24e3, 18e3], backbone = " +
        backbone("[160, 130]") + " }\n" + other +
        "stick = { storey_heights = [3, 3], masses = [20, 18], stiffnesses = [60e3, 50e3] }\n"
        "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.005\ncontact = { law = \"linear\", stiffness = 3e5 }\n" +
        shaken);
    const std::string plane = "stiffnesses = [12e3, 9e3]\nbackbone = " + backbone("[80, 65]") + "\n";
    const PlanRun plan =
        plan_run(units +
                 "[plan]\nclearance = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
                 "[[building]]\nname = \"A\"\ndamping = 0.04\n"
                 "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3, 3], masses = [30, 25] }\n"
                 "[[building.plane]]\nalong = \"x\"\nat = 1\n" +
                 plane + "[[building.plane]]\nalong = \"x\"\nat = 13\n" + plane +
                 "[[building.plane]]\nalong = \"y\"\nat = 5\nstiffnesses = 1e7\n" + other +
                 "plan = { corner = [10.005, 0], size = [10, 14], storey_heights = [3, 3], masses = [20, 18] }\n"
                 "rigidity = { centre = [5, 7], x = [60e3, 50e3], y = 1e7, torsion = 1e9 }\n" +
                 shaken);
    expect_row(plan, row);
    EXPECT_LE(plan.response.energy->relative_residual(), 1e-11);
    const BuildingPeaks::Yielding& wanted = row.buildings[0].yielding;
    EXPECT_LT(wanted.strength_left.minCoeff(), 0.9);
    for (const std::size_t p : {0U, 1U}) {
      const BuildingPeaks::Yielding& found = plan.response.buildings[0].planes[p].yielding;
      expect_alike(found.strength_left, wanted.strength_left, "strength left");
      expect_alike(found.ductility, wanted.ductility, "ductility");
      expect_alike(2 * found.hysteretic_energy, wanted.hysteretic_energy, "energy");
      for (Eigen::Index j = 0; j < 2; ++j) {
        const double at = wanted.capped_time(j);
        EXPECT_EQ(std::isnan(found.capped_time(j)), std::isnan(at));
        EXPECT_FALSE(std::abs(found.capped_time(j) - at) > 1e-9);
      }
    }
  }
}

/// Cantilevers that bend and shear, along x, and with x and y in each other's place along y.
TEST(PlanParts, GenericBuildingsAreTheRows) {
  const auto generic = [](const std::string& system, const std::string& more) {
    return "generic = { storeys = 3, storey_height = [3.5, 3.2, 3.2], floor_mass = [40, 40, 30], " + system + more +
           " }\n";
  };
  const std::string soft = "system = \"wall\", period = 0.6",
                    stiff =
                        "stiffness_ratio = 30, period_formula = { "
                        "coefficient = 0.0466, exponent = 0.9 }",
                    contact = "contact = { law = \"linear\", stiffness = 3e5 }\n";
  const std::string a = "[[building]]\nname = \"A\"\ndamping = 0.04\np_delta = true\n",
                    b = "[[building]]\nname = \"B\"\ndamping = 0.05\n";
  const Response row = row_response(units + a + generic(soft, "") + b + generic(stiff, "") +
                                    "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.005\n" + contact + shaken);
  const std::string along_x = units + "[plan]\nclearance = 0.02\n" + contact + a +
                              "plan = { corner = [0, 0], size = [10, 14] }\n" +
                              generic(soft, ", period_y = 0.4, torsion_ratio = 1.3") + b +
                              "plan = { corner = [10.005, 0], size = [10, 14] }\n" + generic(stiff, "") + shaken;
  const PlanRun found = plan_run(along_x);
  expect_row(found, row);
  EXPECT_LE(found.response.energy->relative_residual(), 1e-11);
  // Turned by 90 degrees: B is above A.
  const PlanRun turned =
      plan_run(units + "[plan]\nclearance = 0.02\n" + contact + a + "plan = { corner = [0, 0], size = [14, 10] }\n" +
               generic("system = \"wall\", period = 0.4", ", period_y = 0.6, torsion_ratio = 1.3") + b +
               "plan = { corner = [0, 10.005], size = [14, 10] }\n" + generic(stiff, "") +
               test::with(shaken, "[analysis]", "angle = 90.0\n[analysis]"));
  ASSERT_EQ(turned.response.status, Status::done) << turned.response.message;
  for (std::size_t i = 0; i < row.buildings.size(); ++i) {
    expect_alike(turned.response.buildings[i].y, row.buildings[i].displacement, "displacement along y");
    expect_alike(turned.response.buildings[i].acceleration_y, row.buildings[i].acceleration, "acceleration along y");
    expect_alike(turned.response.buildings[i].shear_y, row.buildings[i].storey_shear, "storey shear along y");
  }
}

std::string pair_in_plan(const std::string& link) {
  return units +
         "[plan]\nclearance = 0.03\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
         "[[building]]\nname = \"A\"\ndamping = 0.04\n"
         "plan = { corner = [0, 0], size = [10, 14], storey_heights = [3, 3], masses = [30, 25] }\n"
         "rigidity = { centre = [5, 7], x = [12e3, 9e3], y = 1e7, torsion = 1e9 }\n"
         "[[building]]\nname = \"B\"\ndamping = 0.05\n"
         "plan = { corner = [10.02, 0], size = [10, 14], storey_heights = [3, 3], masses = [20, 18] }\n"
         "rigidity = { centre = [5, 7], x = [60e3, 50e3], y = 1e7, torsion = 1e9 }\n" +
         link + shaken;
}

TEST(PlanParts, LinksAreTheRows) {
  for (const std::string law : {"law = \"spring-dashpot\"\nstiffness = [3000, 2000]\ndamping = [20, 40]\n",
                                "law = \"yielding\"\nstiffness = 9e3\nyield_force = [25, 30]\nhardening = 0.1\n",
                                "law = \"cable\"\nstiffness = 5e3\nslack = 0.004\n"}) {
    SCOPED_TRACE(law);
    const std::string link = "[[link]]\nbetween = [\"A\", \"B\"]\nelevations = [3, 6]\n" + law;
    const Response row = row_response(
        units +
        "[[building]]\nname = \"A\"\ndamping = 0.04\n"
        "stick = { storey_heights = [3, 3], masses = [30, 25], stiffnesses = [12e3, 9e3] }\n"
        "[[building]]\nname = \"B\"\ndamping = 0.05\n"
        "stick = { storey_heights = [3, 3], masses = [20, 18], stiffnesses = [60e3, 50e3] }\n"
        "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n" +
        link + shaken);
    const PlanRun plan = plan_run(pair_in_plan(link + "at = 7\n"));
    expect_row(plan, row);
    EXPECT_LE(plan.response.energy->relative_residual(), 1e-11);
    ASSERT_EQ(plan.response.links.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const LinkSummary &found = plan.response.links[i], &wanted = row.links[i];
      const double force = wanted.peak_compression + wanted.peak_tension,
                   way = wanted.peak_closing + wanted.peak_opening;
      EXPECT_GT(force, 0);
      EXPECT_NEAR(found.peak_compression, wanted.peak_compression, 1e-9 * force);
      EXPECT_NEAR(found.peak_tension, wanted.peak_tension, 1e-9 * force);
      EXPECT_NEAR(found.peak_closing, wanted.peak_closing, 1e-9 * way);
      EXPECT_NEAR(found.peak_opening, wanted.peak_opening, 1e-9 * way);
      EXPECT_NEAR(found.energy_dissipated, wanted.energy_dissipated, 1e-9 * (wanted.energy_dissipated + force * way));
    }
    // Told from the other side it is the same link.
    const PlanRun other =
        plan_run(pair_in_plan("[[link]]\nbetween = [\"B\", \"A\"]\nelevations = [3, 6]\nat = 7\n" + law));
    EXPECT_EQ(other.response.links[1].peak_tension, plan.response.links[1].peak_tension);
  }
}

/// A floor of 8 m × 12 m, undamped, joined to a wall beside it at y = 10 by a spring along `axis`; its mass is 50 and
/// it begins to move with these speeds.
PlanRun tied_to_a_wall(const std::string& axis) {
  return plan_run(
      units +
          "[plan]\nclearance = 0.6\ncontact = { law = \"linear\", stiffness = 1e5 }\n[[building]]\nname = "
          "\"A\"\ndamping = 0\n"
          "plan = { corner = [0, 0], size = [8, 12], storey_heights = [3], masses = [50] }\n"
          "rigidity = { centre = [4, 6], x = 5e3, y = 7e3, torsion = 9e4 }\n"
          "[[building]]\nname = \"W\"\nrigid = true\nelevations = [3]\n"
          "plan = { corner = [8.5, 0], size = [1, 12] }\n"
          "[[link]]\nbetween = [\"A\", \"W\"]\nelevations = [3]\nlaw = \"spring-dashpot\"\nstiffness = 4e3\n"
          "at = 10\nalong = \"" +
          axis +
          "\"\n[excitation]\nkind = \"none\"\n[initial]\nvelocities = { A = [[0.5, 0.3, 0]] }\n"
          "[analysis]\nduration = 2\n",
      0.1);
}

TEST(PlanParts, AnEccentricLinkTurnsABuilding) {
  for (const std::string axis : {"x", "y"}) {
    SCOPED_TRACE(axis);
    const PlanRun run = tied_to_a_wall(axis);
    ASSERT_EQ(run.response.status, Status::done) << run.response.message;
    // By hand: the spring's deformation is u_x − 4 θ along x, u_y + 4 θ along y, at (8, 10) from the middle (4, 6).
    const Eigen::Vector3d row = axis == "x" ? Eigen::Vector3d(1, 0, -4) : Eigen::Vector3d(0, 1, 4);
    const Eigen::Matrix3d stiffness =
        Eigen::Matrix3d(Eigen::Vector3d(5e3, 7e3, 9e4).asDiagonal()) + 4e3 * row * row.transpose();
    const Eigen::Vector3d mass(50, 50, 50 * (64 + 144) / 12.0), root = mass.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(root.asDiagonal() * stiffness * root.asDiagonal());
    const Eigen::Matrix3d shapes = root.asDiagonal() * solved.eigenvectors();
    const Eigen::Vector3d omega = solved.eigenvalues().cwiseSqrt();
    const Eigen::Vector3d speed = shapes.transpose() * mass.asDiagonal() * Eigen::Vector3d(0.5, 0.3, 0);
    const PlanHistories& found = run.response.histories;
    double turned = 0;
    for (std::size_t i = 0; i < found.time.size(); ++i) {
      const double t = found.time[i];
      const Eigen::Vector3d at = shapes * ((omega * t).array().sin() / omega.array() * speed.array()).matrix();
      EXPECT_NEAR(found.x[0](0, i), at(0), 1e-11);
      EXPECT_NEAR(found.y[0](0, i), at(1), 1e-11);
      EXPECT_NEAR(found.rotation[0](0, i), at(2), 1e-12);
      turned = std::max(turned, std::abs(at(2)));
    }
    EXPECT_GT(turned, 0.005);
    EXPECT_GT(run.response.links[0].peak_compression, 0);
  }
}

/// The same floor and wall, turned by the angle whose cosine and sine are given, as polygons.
PlanRun tied_to_a_turned_wall(double c, double s, const std::string& along) {
  const auto turned = [&](double x, double y) {
    return fmt::format("[{:.17g}, {:.17g}]", c * x - s * y, s * x + c * y);
  };
  const auto polygon = [&](double from, double to) {
    return "polygon = [" + turned(from, 0) + ", " + turned(to, 0) + ", " + turned(to, 12) + ", " + turned(from, 12) +
           "]";
  };
  return plan_run(
      units + "[plan]\nclearance = 0.6\ncontact = { law = \"linear\", stiffness = 1e5 }\n" +
          "[[building]]\nname = \"A\"\ndamping = 0\nplan = { " + polygon(0, 8) +
          ", storey_heights = [3], masses = [50] }\nrigidity = { centre = " + turned(4, 6) +
          ", x = 5e3, y = 5e3, torsion = 9e4 }\n[[building]]\nname = \"W\"\nrigid = true\nelevations = [3]\nplan = { " +
          polygon(8.5, 9.5) +
          " }\n[[link]]\nbetween = [\"A\", \"W\"]\nelevations = [3]\nlaw = \"spring-dashpot\"\nstiffness = 4e3\n" +
          fmt::format("at = {:.17g}\n", s * 8.25 + c * 10) + along +
          "[excitation]\nkind = \"none\"\n[initial]\nvelocities = { A = [" +
          fmt::format("[{:.17g}, {:.17g}, 0]", 0.5 * c - 0.3 * s, 0.5 * s + 0.3 * c) +
          "] }\n[analysis]\nduration = 2\n",
      0.1);
}

TEST(PlanParts, ALinkAcrossObliqueEdgesIsThatOfTheTurnedPlan) {
  const PlanRun straight = tied_to_a_turned_wall(1, 0, ""), oblique = tied_to_a_turned_wall(0.8, 0.6, "");
  ASSERT_EQ(oblique.response.status, Status::done) << oblique.response.message;
  const PlanLink& link = oblique.problem.links.at(0);
  EXPECT_TRUE(link.stretch.is_oblique());
  EXPECT_NEAR((link.direction - PlanPoint(0.8, 0.6)).norm(), 0, 1e-14);
  EXPECT_NEAR((link.stretch.middle(link.along) - PlanPoint(0.6, 12.95)).norm(), 0, 1e-12);
  double turned = 0;
  for (std::size_t i = 0; i < straight.response.histories.time.size(); ++i) {
    const double wanted = straight.response.histories.rotation[0](0, i);
    EXPECT_NEAR(oblique.response.histories.rotation[0](0, i), wanted, 1e-12);
    turned = std::max(turned, std::abs(wanted));
  }
  EXPECT_GT(turned, 0.005);
  const LinkSummary &found = oblique.response.links.at(0), &wanted = straight.response.links.at(0);
  EXPECT_NEAR(found.peak_compression, wanted.peak_compression, 1e-11 * wanted.peak_compression);
  EXPECT_NEAR(found.peak_opening, wanted.peak_opening, 1e-11 * wanted.peak_opening);
  // Along an axis of the plan it is another link.
  const PlanRun along_x = tied_to_a_turned_wall(0.8, 0.6, "along = \"x\"\n");
  EXPECT_EQ(along_x.problem.links.at(0).direction, PlanPoint::UnitX());
  EXPECT_GT(std::abs(along_x.response.links.at(0).peak_compression - wanted.peak_compression), 1);
}

}  // namespace
}  // namespace bentur
