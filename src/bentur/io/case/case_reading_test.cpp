// Cases that are right, and what is read from them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bentur/contact/laws.h"
#include "bentur/io/case/case_toml.h"
#include "tests/reference/shared_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path record_folder = fs::path(BENTUR_SOURCE_DIR) / "tests" / "bad_input";

Case read(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, record_folder / "reading.toml", diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  return c ? *c : Case{};
}

const std::string units_m = "[units]\nlength = \"m\"\nforce = \"kN\"\n";
const std::string stick_a =
    "[[building]]\nname = \"A\"\ndamping = 0.05\nstick = { storey_heights = [3.0, 3.0, 3.5], masses = [30, 28, 25], "
    "stiffnesses = [40e3, 35e3, 30e3] }\n";
const std::string stick_b =
    "[[building]]\nname = \"B\"\ndamping = 0.02\nstick = { storey_heights = [3.0, 3.5, 3.0], masses = [20, 20, 18], "
    "stiffnesses = [60e3, 50e3, 40e3] }\n";
const std::string gap =
    "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n";
const std::string harmonic = "[excitation]\nkind = \"harmonic\"\nperiod = 0.4\ndisplacement_amplitude = 0.05\n";
const std::string analysis = "[analysis]\nduration = 5\n";

std::string record_case(const std::string& units, const std::string& excitation) {
  return units + stick_a + stick_b + gap + "[excitation]\nkind = \"record\"\n" + excitation;
}

TEST(CaseReading, DefaultsOfEveryOptionalKey) {
  const Case c = read(stick_a + stick_b + gap + harmonic + analysis);
  EXPECT_EQ(c.title, "");
  EXPECT_EQ(c.units.length, "m");
  EXPECT_EQ(c.units.force, "N");
  EXPECT_DOUBLE_EQ(c.units.gravity, 9.80665);
  ASSERT_EQ(c.buildings.size(), 2U);
  EXPECT_FALSE(c.buildings[0].calibrate_period.has_value());
  EXPECT_EQ(c.buildings[0].base_elevation, 0);
  EXPECT_EQ(std::get<ModalDamping>(c.buildings[1].damping).ratios, std::vector<double>{0.02});
  EXPECT_EQ(c.excitation.delays, (std::vector<double>{0, 0}));
  EXPECT_EQ(c.excitation.kinematics, Kinematics::relative);
  EXPECT_EQ(std::get<HarmonicMotion>(c.excitation.motion).phase, HarmonicMotion::Phase::sine);
  EXPECT_TRUE(c.initial.displacements.empty());
  EXPECT_TRUE(std::holds_alternative<ExactSolver>(c.analysis.solver));
  EXPECT_EQ(c.analysis.output_step, 0.01);
  EXPECT_FALSE(c.analysis.energy_audit);
  EXPECT_EQ(c.analysis.duration, 5);
  EXPECT_NO_THROW((void)make_problem(c));
}

TEST(CaseReading, GravityFollowsTheUnitOfLengthUnlessGiven) {
  EXPECT_DOUBLE_EQ(read("[units]\nlength = \"cm\"\n" + stick_a + stick_b + gap + harmonic + analysis).units.gravity,
                   980.665);
  EXPECT_DOUBLE_EQ(read("[units]\nlength = \"ft\"\n" + stick_a + stick_b + gap + harmonic + analysis).units.gravity,
                   9.80665 / 0.3048);
  EXPECT_EQ(read("[units]\ngravity = 10\n" + stick_a + stick_b + gap + harmonic + analysis).units.gravity, 10);
}

TEST(CaseReading, ContactPointsStandWhereBothHaveAFloor) {
  // A has floors at 3, 6, 9.5 and B at 3, 6.5, 9.5.
  const Case c = read(stick_a + stick_b + gap + harmonic + analysis);
  ASSERT_EQ(c.gaps.size(), 1U);
  EXPECT_EQ(c.gaps[0].elevations, (std::vector<double>{3, 9.5}));
  EXPECT_EQ(c.gaps[0].widths, (std::vector<double>{0.02, 0.02}));
  EXPECT_EQ(c.gaps[0].contact.number("stiffness", 1), 3e5);
}

TEST(CaseReading, FloorsMeetAtTheMeanElevationWithinATolerance) {
  const auto with_base = [&](const std::string& base) {
    std::string b = stick_b;
    return b.replace(b.find("damping"), 0, "base_elevation = " + base + "\n");
  };
  // 1e-6 of 9.5 m is 9.5e-6 m.
  const auto with = [&](const std::string& keys) { return gap + keys + "\n"; };
  EXPECT_EQ(read(stick_a + with_base("9e-6") + gap + harmonic + analysis).gaps[0].elevations,
            (std::vector<double>{3, 9.5}));
  const std::vector<double> near = read(stick_a + with_base("0.002") + gap + harmonic + analysis).gaps[0].elevations;
  ASSERT_EQ(near.size(), 2U);
  EXPECT_DOUBLE_EQ(near[0], 3.001);
  EXPECT_DOUBLE_EQ(near[1], 9.501);
  Diagnostics diagnostics;
  EXPECT_FALSE(
      read_case_text(stick_a + with_base("1e-5") + with("level_tolerance = 0") + harmonic + analysis, "x", diagnostics)
          .has_value());
  const GapSpec wide = read(stick_a + stick_b + with("level_tolerance = 0.6") + harmonic + analysis).gaps[0];
  EXPECT_EQ(wide.elevations, (std::vector<double>{3, 6.25, 9.5}));
  EXPECT_EQ(wide.level_tolerance, 0.6);
  // Either floor's elevation names the pair.
  EXPECT_EQ(read(stick_a + stick_b + with("level_tolerance = 0.6\nelevations = [6.5]") + harmonic + analysis)
                .gaps[0]
                .elevations,
            std::vector<double>{6.25});
  // On a base 3 m up, B has floors at 6, 9.5, 12.5.
  EXPECT_EQ(read(stick_a + with_base("3") + gap + harmonic + analysis).gaps[0].elevations,
            (std::vector<double>{6, 9.5}));
}

TEST(CaseReading, GivenElevationsChoosePoints) {
  std::string chosen = gap;
  chosen.replace(chosen.find("width = 0.02"), 12, "width = [0.03]\nelevations = [9.5]");
  const Case c = read(stick_a + stick_b + chosen + harmonic + analysis);
  EXPECT_EQ(c.gaps[0].elevations, std::vector<double>{9.5});
  EXPECT_EQ(c.gaps[0].widths, std::vector<double>{0.03});
}

TEST(CaseReading, NoElevationsModelNoContact) {
  const std::string watched = "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\nelevations = []\n";
  const Case c = read(stick_a + stick_b + watched + harmonic + analysis);
  EXPECT_TRUE(c.gaps[0].elevations.empty());
  EXPECT_EQ(c.gaps[0].widths, std::vector<double>{0.02});
  const Problem problem = make_problem(c);
  EXPECT_TRUE(problem.points.empty());
  EXPECT_EQ(problem.watched.size(), 4U);  // 3 and 9.5 as pairs, 6 and 6.5 against columns
}

TEST(CaseReading, SectionsOfAFrame) {
  const std::string frame = R"([[building]]
name = "A"
damping = { modal = [0.05, 0.04] }
calibrate_period = 0.3
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [4.0, 3.0]
bay_widths = [5, 5]
columns = [{ width = 0.3, depth = 0.4, density = 2.5 }]
beams = [{ area = 0.12, inertia = 0.0016, unit_weight = 24.0 }, { width = 0.3, depth = 0.5, mass = 1.5 }]
floor_masses = [10, 0]
mass_matrix = "lumped"
condensation = "dynamic"
base_coupling = false
)";
  const std::string b =
      "[[building]]\nname = \"B\"\ndamping = { mass_proportional = 0.03 }\nstick = { storey_heights = [4.0], masses = "
      "[20], stiffnesses = [6e4] }\n";
  const Case c = read("[units]\nforce = \"kN\"\ngravity = 10.0\n" + frame + b + gap + harmonic + analysis);
  const auto& f = std::get<PlaneFrame>(c.buildings[0].structure);
  ASSERT_EQ(f.columns.size(), 2U);
  ASSERT_EQ(f.beams.size(), 2U);
  EXPECT_DOUBLE_EQ(f.columns[0].area, 0.12);
  EXPECT_DOUBLE_EQ(f.columns[0].inertia, 0.3 * 0.4 * 0.4 * 0.4 / 12);  // depth is in the plane of the frame
  EXPECT_EQ(f.columns[0].mass, 0);
  EXPECT_DOUBLE_EQ(f.columns[0].line_mass, 2.5 * 0.12);
  EXPECT_DOUBLE_EQ(f.beams[0].line_mass, 24.0 / 10.0 * 0.12);  // unit weight over the case's gravity
  EXPECT_EQ(f.beams[1].mass, 1.5);
  EXPECT_EQ(f.beams[1].line_mass, 0);
  EXPECT_EQ(f.floor_masses, (std::vector<double>{10, 0}));
  EXPECT_EQ(f.mass_matrix, MassMatrix::lumped);
  EXPECT_EQ(f.condensation, Condensation::dynamic);
  EXPECT_FALSE(f.base_coupling);
  EXPECT_EQ(c.buildings[0].width, 10.0);
  EXPECT_EQ(c.buildings[0].calibrate_period, 0.3);
  EXPECT_EQ(std::get<ModalDamping>(c.buildings[0].damping).ratios, (std::vector<double>{0.05, 0.04}));
  EXPECT_EQ(std::get<MassProportionalDamping>(c.buildings[1].damping).ratio, 0.03);
}

/// The first stick with more keys, and what is said of its building.
std::string yielding_case(const std::string& keys, const std::string& of_building = "damping = 0.05\n",
                          const std::string& more = "") {
  return "[[building]]\nname = \"A\"\n" + of_building +
         "[building.stick]\nstorey_heights = [3.0, 3.0, 3.5]\nmasses = [30, 28, 25]\nstiffnesses = [40e3, 35e3, "
         "30e3]\n" +
         keys + stick_b + gap + more + harmonic + analysis;
}

TEST(CaseReading, StoreysThatYield) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Case c = read(yielding_case("yield_forces = [400, inf, 2e2]\nhardening = 0.05\n"));
  const auto& stick = std::get<Stick>(c.buildings[0].structure);
  EXPECT_EQ(stick.yield_forces, (std::vector<double>{400, infinity, 200}));
  EXPECT_EQ(stick.hardening, std::vector<double>{0.05});
  EXPECT_EQ(stick.hysteresis, "bilinear");
  EXPECT_FALSE(c.buildings[0].tangent_damping);
  EXPECT_TRUE(std::get<Stick>(c.buildings[1].structure).yield_forces.empty());
  const Problem problem = make_problem(c);
  EXPECT_NE(problem.buildings[0].storey_law(0), nullptr);
  EXPECT_EQ(problem.buildings[0].storey_law(1), nullptr);
  EXPECT_FALSE(problem.buildings[1].can_yield());
  const Case oriented =
      read(yielding_case("yield_forces = 300\nhardening = [0, 0.1, 0]\nhysteresis = \"peak-oriented\"\n"
                         "unloading_exponent = 1\n"));
  const auto& other = std::get<Stick>(oriented.buildings[0].structure);
  EXPECT_EQ(other.hysteresis, "peak-oriented");
  EXPECT_EQ(other.law_numbers.at("unloading_exponent"), 1);
  EXPECT_EQ(make_problem(oriented).buildings[0].storey_law(2)->name(), "peak-oriented");
  EXPECT_FALSE(make_problem(read(yielding_case("yield_forces = inf\n"))).buildings[0].can_yield());
}

TEST(CaseReading, DampingOfTheInitialOrOfTheTangentStiffness) {
  const std::string form = "damping = { stiffness_proportional = 0.03 }\n";
  const std::string forces = "yield_forces = 300\n";
  const Case initial = read(yielding_case(forces, form + "damping_stiffness = \"initial\"\n"));
  EXPECT_EQ(std::get<StiffnessProportionalDamping>(initial.buildings[0].damping).ratio, 0.03);
  EXPECT_EQ(make_problem(initial).buildings[0].tangent_damping, 0);
  const Case tangent = read(yielding_case(forces, form + "damping_stiffness = \"tangent\"\n"));
  const Building building = make_problem(tangent).buildings[0];
  EXPECT_DOUBLE_EQ(building.tangent_damping, 2 * 0.03 / building.modes.omega(0));
  const Case rayleigh = read(yielding_case(forces,
                                           "damping = { rayleigh = { ratios = [0.05, 0.05], periods = [0.4, 0.1] } }\n"
                                           "damping_stiffness = \"tangent\"\n"));
  EXPECT_NEAR(make_problem(rayleigh).buildings[0].tangent_damping, 0.1 / (2 * std::numbers::pi / 0.08), 1e-17);
}

TEST(CaseReading, Links) {
  const std::string names = "[[link]]\nbetween = [\"A\", \"B\"]\n";
  const Case c =
      read(stick_a + stick_b + gap + names +
           "elevations = [3.0, 6.2]\nlevel_tolerance = 0.5\nlaw = \"spring-dashpot\"\ndamping = [0, 20]\n" +
           "stiffness = [5, 0]\n" + names + "elevations = [3]\nlaw = \"cable\"\nstiffness = 100\n" + names +
           "elevations = [9.5]\nlaw = \"yielding\"\nstiffness = 100\nyield_force = 4\n" + harmonic + analysis);
  ASSERT_EQ(c.links.size(), 3U);
  EXPECT_EQ(c.links[0].left, 0U);
  EXPECT_EQ(c.links[0].right, 1U);
  EXPECT_EQ(c.links[0].elevations, (std::vector<double>{3, 6.25}));  // floors at 6.0 and 6.5
  EXPECT_EQ(c.links[0].number("damping", 1), 20);
  EXPECT_EQ(c.links[1].law, "cable");
  EXPECT_EQ(c.links[1].number("slack", 0), 0);
  EXPECT_EQ(c.links[2].number("hardening", 0), 0);
  const Problem problem = make_problem(c);
  ASSERT_EQ(problem.links.size(), 4U);
  EXPECT_EQ(problem.links[1].left_floor, 1);
  EXPECT_EQ(problem.links[1].right_floor, 1);
  EXPECT_EQ(problem.links[3].left_floor, 2);
}

// 5 and 4 kN/m² on a strip of 6 m over bays of 4 and 7 m, and 2 t on either floor.
TEST(CaseReading, FloorLoadsAreMassesOfTheirStrip) {
  const auto frame = [](const std::string& masses) {
    return "[[building]]\nname = \"A\"\ndamping = 0.05\n[building.frame]\nelastic_modulus = 2.5e7\nstorey_heights = "
           "[4.0, 3.0]\nbay_widths = [4, 7]\ncolumns = [{ width = 0.3, depth = 0.4, density = 2.5 }]\nbeams = [{ width "
           "= 0.3, depth = 0.5, unit_weight = 24 }]\n" +
           masses;
  };
  const std::string b =
      "[[building]]\nname = \"B\"\ndamping = 0.05\nstick = { storey_heights = [4.0], masses = [20], stiffnesses = "
      "[6e4] "
      "}\n";
  const auto masses = [&](const std::string& given) {
    const Case c = read("[units]\nforce = \"kN\"\ngravity = 10.0\n" + frame(given) + b + gap + harmonic + analysis);
    return std::get<PlaneFrame>(c.buildings[0].structure).floor_masses;
  };
  EXPECT_EQ(masses(""), (std::vector<double>{0, 0}));
  EXPECT_EQ(masses("floor_masses = 3\n"), (std::vector<double>{3, 3}));
  EXPECT_EQ(masses("floor_masses = 2\nfloor_load = { pressure = [5, 4], width = 6 }\n"),
            (std::vector<double>{2 + 33.0, 2 + 26.4}));
  EXPECT_EQ(masses("floor_load = { pressure = 5, width = [6, 3] }\n"), (std::vector<double>{33.0, 16.5}));
}

TEST(CaseReading, MatricesWithADiagonalOrAFullMass) {
  const auto building = [](const std::string& mass) {
    return "[[building]]\nname = \"A\"\n[building.matrices]\nelevations = [3.0, 6.0]\nmass = " + mass +
           "\nstiffness = [[70, -30], [-30, 30]]\ndamping = [[0, 0], [0, 0]]\n";
  };
  const Case diagonal = read(building("[2, 3]") + stick_b + gap + harmonic + analysis);
  const Case full = read(building("[[2, 0], [0, 3.0]]") + stick_b + gap + harmonic + analysis);
  Eigen::Matrix2d mass;
  mass << 2, 0, 0, 3;
  EXPECT_EQ(std::get<MatricesSpec>(diagonal.buildings[0].structure).mass, mass);
  EXPECT_EQ(std::get<MatricesSpec>(full.buildings[0].structure).mass, mass);
  EXPECT_EQ(std::get<MatrixDamping>(full.buildings[0].damping).matrix, Eigen::Matrix2d::Zero());
}

TEST(CaseReading, HarmonicAmplitudesOfAccelerationAndDisplacement) {
  const std::string excitation =
      "[excitation]\nkind = \"harmonic\"\nperiod = 0.5\nacceleration_amplitude = 2.0\nphase = \"cosine\"\n";
  const auto motion = std::get<HarmonicMotion>(read(stick_a + stick_b + gap + excitation + analysis).excitation.motion);
  const double omega = 2 * std::numbers::pi / 0.5;
  EXPECT_DOUBLE_EQ(motion.displacement_amplitude * omega * omega, 2.0);
  EXPECT_EQ(motion.phase, HarmonicMotion::Phase::cosine);
}

TEST(CaseReading, WaveVelocityDelaysByTheDistanceOfCentres) {
  const auto widened = [](std::string building, const std::string& width) {
    return building.replace(building.find("damping"), 0, "width = " + width + "\n");
  };
  std::string widths = gap;
  widths.replace(widths.find("0.02"), 4, "[0.5, 0.2]");
  const std::string c_building =
      "[[building]]\nname = \"C\"\nwidth = 6\ndamping = 0.0\nstick = { storey_heights = [3.0], masses = [20], "
      "stiffnesses = [6e4] }\n";
  const std::string second =
      "[[gap]]\nbetween = [\"B\", \"C\"]\nwidth = 0.3\ncontact = { law = \"linear\", stiffness = 3e5 }\n";
  const Case c = read(widened(stick_a, "10") + widened(stick_b, "8") + c_building + widths + second + harmonic +
                      "wave_velocity = 100\n" + analysis);
  ASSERT_EQ(c.excitation.delays.size(), 3U);
  EXPECT_EQ(c.excitation.delays[0], 0);
  EXPECT_NEAR(c.excitation.delays[1], (5 + 0.2 + 4) / 100, 1e-15);  // round-off of sums of a few metres over 100 m/s
  EXPECT_NEAR(c.excitation.delays[2], (5 + 0.2 + 8 + 0.3 + 3) / 100, 1e-15);
}

TEST(CaseReading, InitialStatesByNameZeroForTheOthers) {
  const Case c = read(stick_a + stick_b + gap +
                      "[excitation]\nkind = \"none\"\n[initial]\nvelocities = { B = [0, 0.1, 0.2] }\n" + analysis);
  EXPECT_TRUE(c.initial.displacements.empty());
  ASSERT_EQ(c.initial.velocities.size(), 2U);
  EXPECT_EQ(c.initial.velocities[0], (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(c.initial.velocities[1], (std::vector<double>{0, 0.1, 0.2}));
}

TEST(CaseReading, RecordInItsUnitAndTheCasesUnits) {
  // The AT2 file peaks at 0.06 g; a case in cm has g = 980.665 cm/s².
  const Case c = read(record_case("[units]\nlength = \"cm\"\n", "file = \"good.AT2\"\n"));
  const auto& motion = std::get<SampledMotion>(c.excitation.motion);
  ASSERT_TRUE(c.excitation.record.has_value());
  const RecordEcho& echo = *c.excitation.record;
  EXPECT_EQ(echo.file, "good.AT2");
  EXPECT_EQ(echo.format, "peer-at2");
  EXPECT_EQ(echo.unit, "g");
  EXPECT_EQ(echo.count, 6);
  EXPECT_DOUBLE_EQ(echo.time_step, 0.01);
  EXPECT_DOUBLE_EQ(echo.duration, 0.05);
  EXPECT_DOUBLE_EQ(echo.pga_read, 0.06);
  EXPECT_DOUBLE_EQ(echo.pga, 0.06 * 980.665);
  EXPECT_DOUBLE_EQ(motion.acceleration.back(), -0.06 * 980.665);
  EXPECT_DOUBLE_EQ(c.analysis.duration, 0.05);  // the record's length
}

TEST(CaseReading, RecordScaledToAPeakOrByAFactor) {
  const Case peak = read(record_case(units_m, "file = \"good.AT2\"\npga = 3.0\n"));
  EXPECT_DOUBLE_EQ(peak_acceleration(peak.excitation.motion), 3.0);
  EXPECT_DOUBLE_EQ(peak.excitation.record->pga, 3.0);
  const Case factor = read(record_case(units_m, "file = \"good-two-column.txt\"\nunit = \"cm/s2\"\nscale = -2\n"));
  // 0.03 cm/s² times −2, in m/s².
  EXPECT_NEAR(std::get<SampledMotion>(factor.excitation.motion).acceleration.at(2), -0.0006, 1e-18);
  const Case feet = read(record_case(units_m, "file = \"good-one-column.txt\"\nunit = \"ft/s2\"\ntime_step = 0.005\n"));
  EXPECT_NEAR(feet.excitation.record->pga, 0.03 * 0.3048, 1e-17);
  EXPECT_DOUBLE_EQ(feet.excitation.record->duration, 0.01);
  const Case column = read(record_case(units_m, "file = \"good-three-columns.txt\"\nunit = \"m/s2\"\ncolumn = 3\n"));
  EXPECT_EQ(std::get<SampledMotion>(column.excitation.motion).acceleration, (std::vector<double>{0.02, 0.01, 0.0}));
}

TEST(CaseReading, AccelerationsWithTheirUnit) {
  const auto pga_of = [](const std::string& units, const std::string& value) {
    return read(record_case(units, "file = \"good.AT2\"\npga = " + value + "\n")).excitation.record.value();
  };
  const std::string cm = "[units]\nlength = \"cm\"\n";
  EXPECT_DOUBLE_EQ(pga_of(units_m, "\"0.35 g\"").pga, 0.35 * 9.80665);
  EXPECT_DOUBLE_EQ(pga_of(cm, "\" 3.5e-1g \"").pga, 0.35 * 980.665);
  EXPECT_DOUBLE_EQ(pga_of(cm + "gravity = 1000\n", "\"0.35 g\"").pga, 350);  // the case's own, as of records
  EXPECT_DOUBLE_EQ(pga_of(cm, "\"3.4 m/s2\"").pga, 340);
  EXPECT_DOUBLE_EQ(pga_of(units_m, "\"340 gal\"").pga, 3.4);
  EXPECT_DOUBLE_EQ(pga_of(units_m, "\"340 Gal\"").pga, 3.4);
  EXPECT_DOUBLE_EQ(pga_of(units_m, "\"100 in/s2\"").pga, 2.54);
  EXPECT_FALSE(pga_of(units_m, "\"0.35 g\"").pga_without_unit.has_value());
  EXPECT_EQ(pga_of(units_m, "0.35").pga_without_unit, 0.35);
  const Case c = read(stick_a + stick_b + gap + "[excitation]\nkind = \"harmonic\"\nperiod = 0.4\n" +
                      "acceleration_amplitude = \"0.2 g\"\n" + analysis);
  EXPECT_NEAR(peak_acceleration(c.excitation.motion), 0.2 * c.units.gravity, 1e-14);
}

TEST(CaseReading, EveryReferenceCaseIsRead) {
  const fs::path folder = test::shared_folder() / "reference";
  if (!fs::exists(folder)) GTEST_SKIP() << "the folder shared/reference is not beside the sources";
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++cases;
    Diagnostics diagnostics;
    const auto c = read_case(entry.path(), diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
    ASSERT_TRUE(c.has_value());
    EXPECT_NO_THROW((void)make_problem(*c));
  }
  EXPECT_GE(cases, 19);
}

std::string with_contact(const std::string& contact) {
  std::string changed = gap;
  const std::size_t at = changed.find("{ law");
  return stick_a + stick_b + changed.replace(at, changed.rfind('}') - at, "{ " + contact) + harmonic + analysis;
}

/// A number that a key can have beside those of the others.
std::string number_for(const Key& key) {
  if (key.name == "locking_strain") return "[0.9, 0.8]";    // above the crushing strain
  if (key.name == "locked_stiffness") return "[3.0, 4.0]";  // at least the stiffness before
  return key.range == Range::restitution ? "0.65" : "[0.5, 0.4]";
}

// With every one of the keys that exclude one another, with every word of every choice: whatever the registry offers
// can be said in a case.
TEST(CaseReading, EveryLawOfTheRegistryInEveryWay) {
  int ways = 0;
  for (const LawEntry& law : contact_laws()) {
    std::string required = fmt::format("law = \"{}\"", law.name);
    std::vector<std::string_view> one_of;
    for (const Key& key : law.keys) {
      if (key.need == Need::one_of) {
        one_of.push_back(key.name);
      } else {
        required += fmt::format(", {} = {}", key.name, number_for(key));
      }
    }
    if (one_of.empty()) one_of.emplace_back();
    for (const std::string_view chosen : one_of) {
      std::vector<std::string> texts = {required + (chosen.empty() ? "" : fmt::format(", {} = 0.3", chosen))};
      for (const Key& choice : law.choices) {
        if (!choice.with.empty() && choice.with != chosen) continue;
        for (const std::string_view word : choice.words) {
          texts.push_back(fmt::format("{}, {} = \"{}\"", texts.front(), choice.name, word));
        }
      }
      for (const std::string& text : texts) {
        SCOPED_TRACE(text);
        ++ways;
        const Case c = read(with_contact(text));
        ASSERT_EQ(c.gaps.size(), 1U);
        EXPECT_EQ(c.gaps[0].contact.law, law.name);
        EXPECT_EQ(make_problem(c).points.at(1).law->name(), law.name);
      }
    }
  }
  EXPECT_GE(ways, 25);
}

TEST(CaseReading, NumbersAndWordsOfAContact) {
  const Case c =
      read(with_contact("law = \"kelvin-voigt\", stiffness = 3e5, restitution = [0.5, 0.6], release = \"creep\""));
  const ContactSpec& contact = c.gaps[0].contact;
  EXPECT_EQ(contact.number("stiffness", 1), 3e5);
  EXPECT_EQ(contact.number("restitution", 0), 0.5);
  EXPECT_EQ(contact.number("restitution", 1), 0.6);
  EXPECT_EQ(contact.choices().at("release"), "creep");
  EXPECT_EQ(contact.choices().at("calibration"), "exact");
}

TEST(CaseReading, SolversWithTheirNumbers) {
  const auto solver = [](const std::string& lines) {
    return read(stick_a + stick_b + gap + harmonic + analysis + lines).analysis.solver;
  };
  EXPECT_EQ(std::get<AdaptiveSolver>(solver("solver = \"adaptive\"\n")).tolerance, 1e-9);
  EXPECT_EQ(std::get<AdaptiveSolver>(solver("solver = \"adaptive\"\ntolerance = 1e-13\n")).tolerance, 1e-13);
  EXPECT_EQ(std::get<AdaptiveSolver>(solver("solver = \"adaptive\"\ntolerance = 1e-2\n")).tolerance, 1e-2);
  EXPECT_EQ(std::get<RungeKuttaSolver>(solver("solver = \"runge-kutta\"\n")).step, 0.006);
  EXPECT_EQ(std::get<RungeKuttaSolver>(solver("solver = \"runge-kutta\"\nstep = 0.001\n")).step, 0.001);
  EXPECT_TRUE(read(stick_a + stick_b + gap + harmonic + analysis + "energy_audit = true\n").analysis.energy_audit);
}

// 1/K = 1/K₁ + 1/K₂, K = 2EA/L: with E A/L = 10 on either side 10; a second stiffness of 10 goes, more does not.
TEST(CaseReading, AxialStiffnessCountsWhereValuesMustGoTogether) {
  const auto frame = [](const std::string& name) {
    return "[[building]]\nname = \"" + name +
           "\"\ndamping = 0.05\n[building.frame]\nelastic_modulus = 100.0\nstorey_heights = [3.0]\nbay_widths = [1.0]\n"
           "columns = [{ area = 0.1, inertia = 0.01, mass = 1.0 }]\nbeams = [{ area = 0.1, inertia = 0.01, mass = 1.0 "
           "}]\n";
  };
  const auto with_second = [&](const std::string& second) {
    Diagnostics diagnostics;
    (void)read_case_text(
        frame("A") + frame("B") +
            "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"bilinear\", stiffness = "
            "\"axial\", second_stiffness = " +
            second + ", yield_penetration = 0.001 }\n" + harmonic + analysis,
        "x", diagnostics);
    return diagnostics.ok() ? std::string() : diagnostics.errors().front().message();
  };
  EXPECT_EQ(with_second("9.99"), "");
  EXPECT_EQ(with_second("10.01").substr(0, 48), "gap[0].contact.second_stiffness = 10.01, must be");
}

TEST(CaseReading, MonographCase) {
  const fs::path file = test::shared_folder() / "reference" / "m12-el-centro-gap-02.toml";
  if (!fs::exists(file)) GTEST_SKIP() << "the folder shared/reference is not beside the sources";
  Diagnostics diagnostics;
  const auto c = read_case(file, diagnostics);
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(c->title, "Monograph M1-2, El Centro, gap 0.2 cm");
  EXPECT_EQ(c->units.gravity, 980.0);
  const auto& frame = std::get<PlaneFrame>(c->buildings[0].structure);
  EXPECT_EQ(frame.columns.size(), 3U);
  EXPECT_DOUBLE_EQ(frame.beams[0].inertia, 9.0 * 12 * 12 * 12 / 12);
  EXPECT_EQ(c->gaps[0].elevations, (std::vector<double>{100, 200, 300}));
  EXPECT_EQ(c->excitation.delays, (std::vector<double>{0, 0.1}));
  EXPECT_NEAR(c->excitation.record->pga_read, 0.34874, 5e-6);  // the five digits its description gives
  EXPECT_DOUBLE_EQ(c->excitation.record->pga, 341.7);
  EXPECT_NEAR(c->excitation.record->time_step, 0.02, 1e-12);
}

}  // namespace
}  // namespace bentur
