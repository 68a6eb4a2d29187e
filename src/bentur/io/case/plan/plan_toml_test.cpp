#include "bentur/io/case/case_toml.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/io/results/result_json.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

const std::string plan_text = R"(
title = "Two in plan"
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.1
points = 3
contact = { law = "kelvin-voigt", stiffness = 4e5, restitution = 0.5 }
[[building]]
name = "A"
damping = 0.05
base_elevation = 1.0
[building.plan]
corner = [0.0, 0.0]
size = [12.0, 18.0]
storey_heights = [3.5, 3.2]
masses = [200, 180]
centres_of_mass = [[6.2, 8.7], [6.0, 9.0]]
[[building.plane]]
name = "south wall"
along = "x"
at = 0.5
stiffnesses = [9e4, 7e4]
yield_forces = [900, inf]
hysteresis = "peak-oriented"
[[building.plane]]
along = "y"
at = 11
stiffnesses = 8e4
[building.rigidity]
centre = [6.5, 8.0]
x = 2e4
torsion = [3e5, 2e5]
[[building]]
name = "B"
damping = { modal = [0.05, 0.04, 0.03, 0.02, 0.02, 0.02] }
plan = { corner = [12.02, 4.0], size = [9.0, 20.0], storey_heights = [4.5, 3.2], masses = [100, 90] }
plane = [{ along = "x", at = 1, stiffnesses = 5e4 }, { angle = 75.0, through = [4, 10], stiffnesses = 6e4 },
         { along = "x", at = 18, stiffnesses = 5e4 }]
[[building]]
name = "W"
rigid = true
elevations = [4.5]
plan = { corner = [-1.0, 2.0], size = [0.95, 4.0] }
[[gap]]
between = ["B", "A"]
contact = { law = "linear", stiffness = [5e5, 3e5] }
[excitation]
kind = "harmonic"
period = 0.6
displacement_amplitude = 0.02
wave_velocity = 500
wave_angle = 90
angle = 30
[excitation.y]
kind = "harmonic"
period = 0.5
acceleration_amplitude = "0.1 g"
[initial]
velocities = { A = [[0.1, 0.0, 0.002], [0.2, 0.0, 0.004]] }
[analysis]
duration = 2
)";

struct Read {
  std::optional<Case> c;
  std::vector<std::string> errors;
};

Read read_text(const std::string& text) {
  Diagnostics diagnostics;
  Read read{read_case_text(text, "a.toml", diagnostics), {}};
  for (const Diagnostic& error : diagnostics.errors()) read.errors.push_back(error.message());
  return read;
}

/// With one piece of the text replaced, all of its errors.
std::vector<std::string> errors_with(const std::string& from, const std::string& to) {
  std::string text = plan_text;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return read_text(text.replace(at, from.size(), to)).errors;
}

using Errors = std::vector<std::string>;

TEST(PlanToml, ReadsAll) {
  const Read read = read_text(plan_text);
  ASSERT_TRUE(read.c) << ::testing::PrintToString(read.errors);
  const Case& c = *read.c;
  EXPECT_EQ(c.title, "Two in plan");
  ASSERT_EQ(c.buildings.size(), 3U);
  const Plan& plan = std::get<Plan>(c.buildings[0].structure);
  EXPECT_EQ(plan.footprint.size, PlanPoint(12, 18));
  EXPECT_EQ(plan.centres_of_mass[1], PlanPoint(6, 9));
  EXPECT_EQ(plan.planes[0].name, "south wall");
  EXPECT_EQ(plan.planes[1].name, "plane 2");
  EXPECT_EQ(plan.planes[1].direction, PlanPoint(0, 1));
  EXPECT_EQ(plan.planes[1].through, PlanPoint(11, 0));
  EXPECT_EQ(plan.planes[1].storeys.stiffnesses, (std::vector<double>{8e4, 8e4}));
  EXPECT_EQ(plan.planes[0].storeys.hysteresis, "peak-oriented");
  EXPECT_EQ(plan.rigidity->torsion, (std::vector<double>{3e5, 2e5}));
  EXPECT_TRUE(c.buildings[2].is_rigid());
  // The wall by its clearance, with the contact of all; A and B with their own. W has the lower coordinate.
  ASSERT_EQ(c.gaps.size(), 2U);
  EXPECT_EQ(c.gaps[0].left, 0);
  EXPECT_EQ(c.gaps[0].right, 1);
  EXPECT_EQ(c.gaps[0].contact.law, "linear");
  EXPECT_EQ(c.gaps[0].points, 3);
  EXPECT_EQ(c.gaps[0].levels.size(), 2U);
  EXPECT_EQ(c.gaps[1].left, 2);
  EXPECT_EQ(c.gaps[1].right, 0);
  EXPECT_NEAR(c.gaps[1].stretch.width, 0.05, 1e-15);
  EXPECT_EQ(c.gaps[1].contact.law, "kelvin-voigt");
  EXPECT_EQ(c.angle, 30);
  // Middles of footprints at y = 9, 14 and 4; the wave goes along y.
  EXPECT_NEAR(c.excitation.delays[0], 5.0 / 500, 1e-15);
  EXPECT_NEAR(c.excitation.delays[1], 10.0 / 500, 1e-15);
  EXPECT_EQ(c.excitation.delays[2], 0);
  EXPECT_EQ(c.initial.velocities[0], (std::vector<double>{0.1, 0.0, 0.002, 0.2, 0.0, 0.004}));
  EXPECT_EQ(c.initial.velocities[1], std::vector<double>(6, 0.0));

  const PlanProblem problem = make_plan_problem(c);
  EXPECT_NEAR(problem.axes(0, 0), std::sqrt(3) / 2, 1e-15);
  // Shares of a law: of all that has force in it, and of the mass by which a damping ratio acts (P-9).
  const PlanContact& end = problem.gaps[0].contacts[3];
  EXPECT_EQ(end.elevation, 4.5 + 3.2);
  EXPECT_EQ(end.law->parameters()[0].second, 3e5 * 0.25);
  double damping = 0, whole = 0;
  for (const PlanContact& contact : problem.gaps[1].contacts) damping += contact.law->branch({.branch = 1}).damping;
  const ContactSpec& spec = c.gaps[1].contact;
  whole = make_contact_law(spec, contact_input(spec, 0, 200))->branch({.branch = 1}).damping;
  EXPECT_NEAR(damping, whole, 1e-12 * whole);
  const PlanResponse response = solve(problem);
  EXPECT_EQ(response.status, Status::done) << response.message;
  EXPECT_NE(summary_json({c, problem, response}, "test").find("\"peak_storey_torque\""), std::string::npos);
}

/// A polygon whose corner stands before a wall, and the same in the common plan's coordinates.
TEST(PlanToml, AccidentalEccentricityMovesCentresOfMassAlone) {
  const auto with = [](const std::string& was, const std::string& is) {
    std::string text = plan_text;
    text.replace(text.find(was), was.size(), is);
    return text;
  };
  const std::string centres = "centres_of_mass = [[6.2, 8.7], [6.0, 9.0]]";
  const auto building = [](const std::string& text) {
    return make_plan_problem(*read_text(text).c).buildings[0].model;
  };
  const PlanModel moved = building(with(centres, centres + "\naccidental_eccentricity = [-0.05, 0.1]"));
  const PlanModel given = building(with(centres, "centres_of_mass = [[5.6, 10.5], [5.4, 10.8]]"));
  EXPECT_LT((moved.stiffness - given.stiffness).norm(), 1e-12 * given.stiffness.norm());
  EXPECT_GT((moved.stiffness - building(plan_text).stiffness).norm(), 1e-3 * given.stiffness.norm());
  EXPECT_EQ(moved.mass, given.mass);
}

/// A number so that it is read again as it is.
std::string exact(double value) { return fmt::format("{:.17g}", value); }

TEST(PlanToml, ACalibratedBuildingIsOneOfOtherStiffness) {
  const std::string name = "name = \"Walled\"\n";
  const std::string hinged = test::hinged_pair();
  const double own = 2 * std::numbers::pi / test::plan_run(hinged).problem.buildings[0].modes.omega(0);
  const PlanRun calibrated =
      test::plan_run(test::with(hinged, name, name + "calibrate_period = " + exact(1.2 * own) + "\n"));
  const PlanBuilding& building = calibrated.problem.buildings[0];
  EXPECT_NEAR(2 * std::numbers::pi / building.modes.omega(0), 1.2 * own, 1e-12 * own);
  const double factor = building.model.stiffness_factor.value();
  EXPECT_NEAR(factor, 1 / 1.44, 1e-12);
  // The same by its numbers: what members and storeys bear is as it was.
  std::string by_hand = test::with(hinged, "elastic_modulus = 3e7", "elastic_modulus = " + exact(3e7 * factor));
  const auto end = [&] { return by_hand.find("name = \"Frame\""); };
  for (std::size_t at = 0; (at = by_hand.find("stiffnesses = [", at)) < end(); ++at) {
    at += std::string("stiffnesses = [").size();
    const std::size_t close = by_hand.find(']', at);
    std::string scaled;
    std::istringstream given(by_hand.substr(at, close - at));
    for (std::string one; std::getline(given, one, ',');) {
      scaled += (scaled.empty() ? "" : ", ") + exact(std::stod(one) * factor);
    }
    by_hand.replace(at, close - at, scaled);
  }
  const PlanRun other = test::plan_run(by_hand);
  ASSERT_EQ(calibrated.response.status, Status::done) << calibrated.response.message;
  ASSERT_GT(calibrated.response.impacts.size(), 0U);
  ASSERT_EQ(calibrated.response.impacts.size(), other.response.impacts.size());
  for (std::size_t i = 0; i < other.response.points.size(); ++i) {
    const PointSummary &mine = calibrated.response.points[i], &theirs = other.response.points[i];
    EXPECT_NEAR(mine.gap_needed, theirs.gap_needed, 1e-9 * theirs.gap_needed);
    EXPECT_NEAR(mine.peak_force, theirs.peak_force, 1e-8 * theirs.peak_force);
  }
  for (std::size_t p = 0; p < other.response.buildings[0].planes.size(); ++p) {
    const auto &mine = calibrated.response.buildings[0].planes[p], &theirs = other.response.buildings[0].planes[p];
    EXPECT_LT((mine.shear - theirs.shear).norm(), 1e-8 * theirs.shear.norm());
    ASSERT_EQ(mine.frame.hinges.size(), theirs.frame.hinges.size());
    for (std::size_t h = 0; h < theirs.frame.hinges.size(); ++h) {
      EXPECT_NEAR(mine.frame.hinges[h].peak_moment, theirs.frame.hinges[h].peak_moment,
                  1e-8 * (1 + theirs.frame.hinges[h].peak_moment));
    }
  }
}

TEST(PlanToml, ReadsPolygons) {
  std::string text = plan_text;
  const auto put = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  put("size = [12.0, 18.0]", "polygon = [[0, 4], [0, 18], [12, 18], [12, 0], [6, 0]]");  // clockwise
  const Read read = read_text(text);
  ASSERT_TRUE(read.c) << ::testing::PrintToString(read.errors);
  const Footprint& footprint = read.c->buildings[0].footprint();
  EXPECT_EQ(footprint.polygon.size(), 5U);
  EXPECT_EQ(footprint.size, PlanPoint(12, 18));
  EXPECT_EQ(footprint.polygon.front(), PlanPoint(6, 0));
}

TEST(PlanToml, SaysEveryErrorOfBuildings) {
  EXPECT_EQ(errors_with("plan = { corner = [12.02, 4.0]", "plan = { corner = [11.0, 4.0]"),
            (Errors{"building[\"B\"] overlaps \"A\": their footprints have 1 by 14 at (11, 4) in common"}));
  EXPECT_EQ(errors_with(
                "plan = { corner = [12.02, 4.0], size = [9.0, 20.0], storey_heights = [4.5, 3.2], masses = [100, 90] }",
                "stick = { storey_heights = [4.5, 3.2], masses = [100, 90], stiffnesses = [1, 1] }"),
            (Errors{"building[\"B\"].plan is missing (buildings stand in plan, all of them or none)",
                    "building[\"B\"].stick does not go with buildings in plan"}));
  EXPECT_EQ(errors_with("centres_of_mass = [[6.2, 8.7], [6.0, 9.0]]", "centres_of_mass = [[6.2, 8.7], [12.1, 9.0]]"),
            (Errors{"building[\"A\"].plan.centres_of_mass[1] is outside the footprint of 12 by 18"}));
  EXPECT_EQ(errors_with(
                "plane = [{ along = \"x\", at = 1, stiffnesses = 5e4 }, { angle = 75.0, through = [4, 10], stiffnesses "
                "= 6e4 },\n"
                "         { along = \"x\", at = 18, stiffnesses = 5e4 }]",
                "plane = [{ along = \"x\", at = 1, stiffnesses = 5e4 }, { along = \"x\", at = 9, stiffnesses = 5e4 }]"),
            (Errors{"building[\"B\"] has nothing that holds storey 1 along y",
                    "building[\"B\"] has nothing that holds storey 2 along y"}));
  EXPECT_EQ(errors_with("at = 0.5\n", ""),
            (Errors{"building[\"A\"].plane[\"south wall\"].at is missing (where along is given)"}));
  EXPECT_EQ(errors_with("along = \"x\"\nat = 0.5", "angle = 3\nat = 1"),
            (Errors{"building[\"A\"].plane[\"south wall\"].through is missing (where angle is given)",
                    "building[\"A\"].plane[\"south wall\"].at goes with along, which is not given"}));
  EXPECT_EQ(errors_with("0.02, 0.02, 0.02]", "0.02]"),
            (Errors{"building[\"B\"].damping.modal has 4 entries, expected 6 (one per mode)"}));
  EXPECT_EQ(errors_with("elevations = [4.5]\n", "elevations = [4.5]\ndamping = 0.1\n"),
            (Errors{"building[\"W\"].damping is not for a rigid building, which moves with the ground"}));
  EXPECT_EQ(errors_with("base_elevation = 1.0", "base_elevation = 1.0\np_delta = true"), Errors{});
  EXPECT_EQ(errors_with("base_elevation = 1.0", "base_elevation = 1.0\ngravity_loads = [1]"),
            (Errors{"building[\"A\"].gravity_loads has 1 entry, expected 2 (one per floor)"}));
  EXPECT_EQ(errors_with("base_elevation = 1.0", "base_elevation = 1.0\np_delta = true\ngravity_loads = [1, 1]"),
            (Errors{"building[\"A\"].p_delta and gravity_loads exclude one another: give one of them"}));
}

TEST(PlanToml, SaysEveryErrorOfPairs) {
  EXPECT_EQ(errors_with("between = [\"B\", \"A\"]", "between = [\"B\", \"B\"]"),
            (Errors{"gap[0].between must be two buildings"}));
  EXPECT_EQ(errors_with("stiffness = [5e5, 3e5] }", "stiffness = [5e5, 3e5] }\nwidth = 0.02"),
            (Errors{"gap[0].width is not for buildings in plan: their footprints say how far they are apart"}));
  EXPECT_EQ(errors_with("points = 3", "points = 51"),
            (Errors{"plan.points = 51, must be a whole number from 2 to 50"}));
  EXPECT_EQ(errors_with("{ law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5 }",
                        "{ law = \"restitution\", restitution = 0.5 }"),
            (Errors{"plan.points must be 2 with law = \"restitution\", not 3"}));
  EXPECT_EQ(errors_with("contact = { law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5 }\n", ""),
            (Errors{"plan needs a contact for \"W\" and \"A\": give plan.contact, or a [[gap]] between them"}));
  EXPECT_EQ(
      errors_with("stiffness = 4e5, restitution", "stiffness = [4e5, 1], restitution"),
      (Errors{"plan.contact.stiffness is a list, must be one for all pairs: a [[gap]] has lists, over its levels"}));
  EXPECT_EQ(
      errors_with("elevations = [4.5]", "elevations = [6.0]"),
      (Errors{"plan.clearance brings together \"A\" and \"W\", which have no floors at one elevation: give a [[gap]] "
              "between them with level_tolerance, or with elevations = [] where no contact is modelled"}));
}

TEST(PlanToml, SaysEveryErrorOfFriction) {
  const auto errors_of_gap = [](const std::string& more) {
    return errors_with("stiffness = [5e5, 3e5] }", "stiffness = [5e5, 3e5], " + more + " }");
  };
  EXPECT_EQ(errors_of_gap("friction = 0.3"), Errors{});
  EXPECT_EQ(errors_of_gap("friction = [0.3, 0], tangential_stiffness = [1e5, 2e5]"), Errors{});
  EXPECT_EQ(errors_of_gap("friction = [0.3, -0.1], tangential_stiffness = inf"),
            (Errors{"gap[0].contact.friction[1] = -0.1, must be >= 0",
                    "gap[0].contact.tangential_stiffness = inf, must be finite"}));
  EXPECT_EQ(errors_of_gap("friction = 0.3, tangential_stiffness = 0"),
            (Errors{"gap[0].contact.tangential_stiffness = 0, must be > 0"}));
  EXPECT_EQ(errors_of_gap("friction = 0, tangential_stiffness = 1e5"),
            (Errors{"gap[0].contact.tangential_stiffness goes with friction > 0"}));
  EXPECT_EQ(errors_of_gap("tangential_stiffness = 1e5"),
            (Errors{"gap[0].contact.tangential_stiffness goes with friction > 0"}));
  EXPECT_EQ(
      errors_with("law = \"linear\", stiffness = [5e5, 3e5] }",
                  "law = \"hertz\", stiffness = 5e5, friction = [0, 0.3] }"),
      (Errors{
          "gap[0].contact.friction[1] = 0.3, goes with contact whose force has straight branches and never pulls"}));
  EXPECT_EQ(
      errors_with("{ law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5 }",
                  "{ law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5, release = \"creep\", "
                  "friction = 0.3 }"),
      (Errors{"plan.contact.friction = 0.3, goes with contact whose force has straight branches and never pulls"}));
  // With an error of another key.
  EXPECT_EQ(
      errors_with("points = 3\ncontact = { law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5 }",
                  "points = 1\ncontact = { law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5, "
                  "friction = -1 }"),
      (Errors{"plan.points = 1, must be a whole number from 2 to 50", "plan.contact.friction = -1, must be >= 0"}));
}

TEST(PlanToml, FrictionHasTheShareOfItsPoint) {
  std::string text = plan_text;
  const std::string from = "stiffness = [5e5, 3e5] }";
  text.replace(text.find(from), from.size(), "stiffness = [5e5, 3e5], friction = [0, 0.3] }");
  const Read read = read_text(text);
  ASSERT_TRUE(read.c);
  const PlanProblem problem = make_plan_problem(*read.c);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(problem.gaps[0].contacts[i].rubbing, nullptr);
  for (std::size_t i = 0; i < 3; ++i) {
    const PlanContact& contact = problem.gaps[0].contacts[3 + i];
    ASSERT_NE(contact.rubbing, nullptr);
    EXPECT_EQ(contact.rubbing->friction(), 0.3);
    EXPECT_DOUBLE_EQ(contact.rubbing->tangential_stiffness(), 8.0 / 9.0 * 3e5 * (i == 1 ? 0.5 : 0.25));
  }
  for (const PlanContact& contact : problem.gaps[1].contacts) EXPECT_EQ(contact.rubbing, nullptr);
}

TEST(PlanToml, FrictionOfZeroIsNone) {
  std::string text = plan_text;
  const std::string from = "stiffness = [5e5, 3e5] }";
  text.replace(text.find(from), from.size(), "stiffness = [5e5, 3e5], friction = 0 }");
  const PlanResponse without = solve(make_plan_problem(*read_text(plan_text).c));
  const PlanResponse with = solve(make_plan_problem(*read_text(text).c));
  ASSERT_EQ(with.impacts.size(), without.impacts.size());
  for (std::size_t i = 0; i < with.impacts.size(); ++i) EXPECT_EQ(with.impacts[i].impulse, without.impacts[i].impulse);
  for (std::size_t b = 0; b < 2; ++b) EXPECT_EQ(with.buildings[b].rotation, without.buildings[b].rotation);
}

/// A free rectangle whose corner strikes a wall and slides along it all the way (P-18).
TEST(PlanToml, CornerSlidesAlongAWall) {
  struct Target {
    std::string velocity;
    double normal, along, loss;
  };
  for (const Target& target : {Target{"[-1.6, 4.4, 0.4]", 22.907488986784, 6.8722466960352, 38.145510295173},
                               Target{"[-1.6, -7.6, 0.4]", 30.057803468208, -9.0173410404624, 56.293227304621}}) {
    SCOPED_TRACE(target.velocity);
    const Read read = read_text(
        "[plan]\nclearance = 0\ncontact = { law = \"linear\", stiffness = 4e5, friction = 0.3 }\n"
        "[[building]]\nname = \"A\"\ndamping = 0\n"
        "plan = { corner = [0, 0], size = [8, 12], storey_heights = [3], masses = [50] }\n"
        "rigidity = { centre = [4, 6], x = 1e-9, y = 1e-9, torsion = 1e-9 }\n"
        "[[building]]\nname = \"W\"\nrigid = true\nelevations = [3]\n"
        "plan = { corner = [8, -3], size = [1, 8] }\n[excitation]\nkind = \"none\"\n"
        "[initial]\nvelocities = { A = [" +
        target.velocity + "] }\n[analysis]\nduration = 0.1\n");
    ASSERT_TRUE(read.c) << ::testing::PrintToString(read.errors);
    const PlanProblem problem = make_plan_problem(*read.c);
    const PlanResponse response = solve(problem, ExactSolver{}, {.energy_audit = true});
    ASSERT_EQ(response.status, Status::done) << response.message;
    EXPECT_LE(response.energy->relative_residual(), 1e-12);
    ASSERT_EQ(response.impacts.size(), 1U);
    EXPECT_EQ(response.impacts[0].point, 0);
    EXPECT_NEAR(response.points[0].impulse, target.normal, 1e-11 * target.normal);
    const PlanFriction& along = response.friction[0];
    EXPECT_NEAR(along.tangential_impulse, target.along, 1e-11 * std::abs(target.along));
    EXPECT_NEAR(along.friction_loss, target.loss, 1e-10 * target.loss);
    EXPECT_NEAR(along.peak_tangential_force, 0.3 * response.points[0].peak_force,
                1e-11 * response.points[0].peak_force);
    EXPECT_EQ(response.friction[1].friction_loss, 0);
    EXPECT_GT(along.sliding, 0);
    const std::string json = summary_json({*read.c, problem, response}, "test");
    EXPECT_NE(json.find("\"friction_loss\""), std::string::npos);
  }
}

TEST(PlanToml, SaysWhatIsWrongInTables) {
  std::string rubs = plan_text;
  for (const auto& [from, to] : {std::pair("law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.5",
                                           "law = \"linear\", stiffness = 4e5, friction = 0.3"),
                                 std::pair("[analysis]\n", "[analysis]\nsolver = \"runge-kutta\"\n")}) {
    rubs.replace(rubs.find(from), std::string_view(from).size(), to);
  }
  EXPECT_EQ(read_text(rubs).errors, Errors{});
  EXPECT_EQ(errors_with("A = [[0.1, 0.0, 0.002], [0.2, 0.0, 0.004]]",
                        "A = [[0.1, 0.0], [0.2, 0.0, 0.004]], W = [[0, 0, 0]], Q = []"),
            (Errors{"initial.velocities.A[0] has 2 entries, expected 3 (x, y and rotation)",
                    "initial.velocities.W is of a wall, which moves with the ground",
                    "initial.velocities.Q is for no building of the case, the buildings are A, B, W"}));
}

TEST(PlanToml, ARowHasNoPlan) {
  const auto errors_of_row = [](const std::string& more_of_gap, const std::string& more,
                                const std::string& more_of_contact = "") {
    Diagnostics found;
    (void)read_case_text(
        "[[building]]\nname = \"A\"\ndamping = 0\nstick = { storey_heights = [3], masses = [1], stiffnesses = [1] }\n"
        "[[building]]\nname = \"B\"\ndamping = 0\nstick = { storey_heights = [3], masses = [1], stiffnesses = [1] }\n"
        "[[gap]]\nbetween = [\"A\", \"B\"]\ncontact = { law = \"linear\", stiffness = 1" +
            more_of_contact + " }\n" + more_of_gap +
            "[excitation]\nkind = \"harmonic\"\nperiod = 1\ndisplacement_amplitude = 1\n" + more +
            "[analysis]\nduration = 1\n",
        "a.toml", found);
    Errors errors;
    for (const Diagnostic& error : found.errors()) errors.push_back(error.message());
    return errors;
  };
  EXPECT_EQ(errors_of_row("width = 1\n", ""), Errors{});
  EXPECT_EQ(errors_of_row("width = 1\n", "", ", friction = 0.3, tangential_stiffness = 1"),
            (Errors{"gap[0].contact.friction is of buildings in plan: give them [building.plan]",
                    "gap[0].contact.tangential_stiffness is of buildings in plan: give them [building.plan]"}));
  EXPECT_EQ(errors_of_row("points = 2\n", "angle = 3\n"),
            (Errors{"gap[0].width is missing", "gap[0].points is of buildings in plan: give them [building.plan]",
                    "excitation.angle is of buildings in plan: give them [building.plan]"}));
}

}  // namespace
}  // namespace bentur
