#include "bentur/model/case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

/// The monograph's models: `beam_widths` bottom to top, beams and columns of the given depths, in cm and kgf.
PlaneFrame monograph_frame(double beam_depth, std::vector<double> bays = {100}) {
  PlaneFrame frame;
  frame.elastic_modulus = 2.1e5;
  frame.storey_heights = {100, 100, 100};
  frame.bay_widths = std::move(bays);
  const Section column{.area = 100, .inertia = 1e4 / 12, .mass = 0.024};
  frame.columns = {column, column, column};
  for (const double width : {9.0, 8.0, 8.0}) {
    frame.beams.push_back({.area = width * beam_depth, .inertia = width * std::pow(beam_depth, 3) / 12, .mass = 0.2});
  }
  frame.floor_masses = {0, 0, 0};
  return frame;
}

BuildingSpec spec_of(std::string name, decltype(BuildingSpec::structure) structure) {
  BuildingSpec spec;
  spec.name = std::move(name);
  spec.structure = std::move(structure);
  spec.damping = ModalDamping{{0.05}};
  return spec;
}

Stick two_storeys() { return {.storey_heights = {3, 3}, .masses = {20e3, 20e3}, .stiffnesses = {2e7, 2e7}}; }

/// What the law of a contact point works with.
double parameter(const ContactPoint& point, std::string_view name) {
  for (const auto& [key, value] : point.law->parameters()) {
    if (key == name) return value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Two monograph frames that meet at all three floors.
Case frame_pair() {
  Case c;
  c.buildings = {spec_of("Model 1", monograph_frame(12)), spec_of("Model 2", monograph_frame(10))};
  GapSpec gap;
  gap.widths = {0.2, 0.3, 0.4};
  gap.elevations = {100, 200, 300};
  gap.contact.axial = true;
  c.gaps = {gap};
  c.excitation.motion = NoMotion{};
  c.excitation.delays = {0, 0.1};
  c.analysis.duration = 1;
  return c;
}

// (3-4) by hand: E·2A/L of 9×12 and 9×10 at floor 1, in series 206181.82 kgf/cm; 8×12 and 8×10 above, 183272.73.
TEST(MakeProblem, AxialStiffnessIsThatOfTheBeamsNextToTheGap) {
  const Problem problem = make_problem(frame_pair());
  ASSERT_EQ(problem.points.size(), 3U);
  EXPECT_NEAR(parameter(problem.points[0], "stiffness"), 206181.818, 1e-3);
  EXPECT_NEAR(parameter(problem.points[1], "stiffness"), 183272.727, 1e-3);
  EXPECT_NEAR(parameter(problem.points[2], "stiffness"), 183272.727, 1e-3);
}

TEST(MakeProblem, AxialStiffnessTakesTheRightmostBayOnTheLeftAndTheLeftmostOnTheRight) {
  Case c = frame_pair();
  c.buildings[0].structure = monograph_frame(12, {50, 100});  // the bay at the gap is 100
  c.buildings[1].structure = monograph_frame(10, {100, 25});
  EXPECT_NEAR(parameter(make_problem(c).points[0], "stiffness"), 206181.818, 1e-3);
  c.buildings[0].structure = monograph_frame(12, {100, 50});  // half the length, twice the stiffness of that half
  const double k1 = 2.1e5 * 108 / 25;
  const double k2 = 2.1e5 * 90 / 50;
  EXPECT_NEAR(parameter(make_problem(c).points[0], "stiffness"), 1 / (1 / k1 + 1 / k2), 1e-6);
}

TEST(MakeProblem, PlacesPointsAtTheFloorsOfEachBuilding) {
  Case c = frame_pair();
  c.buildings[1].base_elevation = 100;  // floors at 200, 300, 400
  c.gaps[0].widths = {0.3, 0.4};
  c.gaps[0].elevations = {200, 300};
  const Problem problem = make_problem(c);
  ASSERT_EQ(problem.points.size(), 2U);
  EXPECT_EQ(problem.points[0].left_floor, 1);
  EXPECT_EQ(problem.points[0].right_floor, 0);
  EXPECT_EQ(problem.points[1].left_floor, 2);
  EXPECT_EQ(problem.points[1].right_floor, 1);
  EXPECT_EQ(problem.points[1].width, 0.4);
  EXPECT_EQ(problem.delays, (std::vector<double>{0, 0.1}));
}

TEST(MakeProblem, OneStiffnessServesAllPointsAndAListOneEach) {
  Case c = frame_pair();
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers["stiffness"] = {5e4};
  EXPECT_EQ(parameter(make_problem(c).points[2], "stiffness"), 5e4);
  c.gaps[0].contact.numbers["stiffness"] = {5e4, 6e4, 7e4};
  EXPECT_EQ(parameter(make_problem(c).points[2], "stiffness"), 7e4);
}

TEST(MakeProblem, RefusesWhatDoesNotFitTogether) {
  Case c = frame_pair();
  c.gaps[0].elevations[1] = 150;
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // no floor there
  c = frame_pair();
  c.gaps[0].widths.pop_back();
  EXPECT_THROW((void)make_problem(c), InvalidParameter);
  c = frame_pair();
  c.gaps.clear();
  EXPECT_THROW((void)make_problem(c), InvalidParameter);
  c = frame_pair();
  c.buildings[1] =
      spec_of("Stick", Stick{.storey_heights = {100, 100, 100}, .masses = {1, 1, 1}, .stiffnesses = {1, 1, 1}});
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // axial needs frames
  c = frame_pair();
  c.initial.displacements = {{0.1, 0.2}, {}};
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // two values for three floors
  c = frame_pair();
  c.gaps[0].contact.law = "rubber";
  EXPECT_THROW((void)make_problem(c), InvalidParameter);
  c = frame_pair();
  c.gaps[0].contact = {.law = "darmawan", .axial = true};
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // no alpha
  c.gaps[0].contact = {.law = "kelvin-voigt", .axial = true};
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // none of restitution, damping_ratio, damping
  c.gaps[0].contact.numbers = {{"restitution", {0.5}}, {"damping_ratio", {0.5}}};
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // two of them
  c.gaps[0].contact = {.law = "bilinear",
                       .numbers = {{"stiffness", {1e5}}, {"second_stiffness", {2e5}}, {"yield_penetration", {0.1}}}};
  EXPECT_THROW((void)make_problem(c), InvalidParameter);  // stiffer beyond yielding
}

TEST(MakeProblem, StoreysThatYieldAndDampingThatFollowsThem) {
  BuildingSpec spec = spec_of("A", two_storeys());
  EXPECT_FALSE(make_building(spec).can_yield());
  std::get<Stick>(spec.structure).yield_forces = {1e3, 2e3};
  spec.calibrate_period = 0.75;
  spec.damping = StiffnessProportionalDamping{0.04};
  const Building building = make_building(spec);
  ASSERT_TRUE(building.can_yield());
  EXPECT_NEAR(building.storey_law(1)->initial_stiffness() / building.model.stiffness(1, 1), 1, 5e-16);
  EXPECT_EQ(building.tangent_damping, 0);
  spec.tangent_damping = true;
  EXPECT_NEAR(make_building(spec).tangent_damping, 0.04 * 0.75 / std::numbers::pi, 1e-16);  // β = 2ζ₁/ω₁ = ζ₁T₁/π
  spec.damping = MassProportionalDamping{0.04};
  EXPECT_THROW((void)make_building(spec), InvalidParameter);
  spec.damping = RayleighDamping{{0.05, 0.001}, {0.4, 0.1}};  // β < 0
  EXPECT_THROW((void)make_building(spec), InvalidParameter);
}

TEST(MakeProblem, LinksAreAtTheFloorsOfTheirBuildings) {
  Case c = frame_pair();
  c.buildings[1].base_elevation = 100;  // floors at 200, 300, 400
  c.gaps[0].widths = {0.3, 0.4};
  c.gaps[0].elevations = {200, 300};
  c.links = {{.elevations = {300}, .law = "cable", .numbers = {{"stiffness", {50}}}},
             {.elevations = {200, 300},
              .law = "yielding",
              .numbers = {{"stiffness", {1000}}, {"yield_force", {30, 40}}, {"hardening", {0.1}}}}};
  const Problem problem = make_problem(c);
  ASSERT_EQ(problem.links.size(), 3U);
  EXPECT_EQ(problem.links[0].left_floor, 2);
  EXPECT_EQ(problem.links[0].right_floor, 1);
  EXPECT_EQ(problem.links[0].elevation, 300);
  EXPECT_EQ(problem.links[0].law->parameters(), (LawParameters{{"stiffness", 50}, {"slack", 0}}));
  EXPECT_EQ(problem.links[1].left_floor, 1);
  EXPECT_EQ(problem.links[1].right_floor, 0);
  const LawParameters expected = {{"stiffness", 1000}, {"yield_force", 40}, {"hardening", 0.1}};
  EXPECT_EQ(problem.links[2].law->parameters(), expected);
}

TEST(MakeProblem, LinksThatCannotBeAreRefused) {
  const auto refused = [](const LinkSpec& link) {
    Case c = frame_pair();
    c.links = {link};
    EXPECT_THROW((void)make_problem(c), InvalidParameter);
  };
  const LinkSpec good = {.elevations = {200}, .numbers = {{"stiffness", {50}}}};
  LinkSpec bad = good;
  bad.right = 2;  // there is no such building
  refused(bad);
  bad.left = bad.right = 1;
  refused(bad);
  bad = good;
  bad.elevations = {250};
  refused(bad);
  bad = good;
  bad.law = "rope";
  refused(bad);
  bad = good;
  bad.numbers = {};
  refused(bad);  // neither stiffness nor damping
  bad.law = "cable";
  refused(bad);
  bad = good;
  bad.elevations = {100, 200, 300};
  bad.numbers = {{"stiffness", {50, 60}}};
  refused(bad);
  Case c = frame_pair();
  c.links = {good};
  EXPECT_EQ(make_problem(c).links.size(), 1U);
}

// m_e = m₁m₂/(m₁ + m₂) of the two floors that meet: with c = 2ξ√(k m_e) = 40 and k = 100, ξ = 2/√m_e.
TEST(MakeProblem, EffectiveMassIsThatOfTheTwoFloorsOfThePoint) {
  Case c;
  MatricesSpec matrices;
  matrices.elevations = {3, 6};
  matrices.mass = (Eigen::Matrix2d() << 30, 2, 2, 20).finished();  // row sums 32 and 22
  matrices.stiffness = (Eigen::Matrix2d() << 300, -100, -100, 90).finished();
  c.buildings = {spec_of("A", matrices),
                 spec_of("B", Stick{.storey_heights = {3, 3}, .masses = {16, 11}, .stiffnesses = {100, 100}})};
  GapSpec gap;
  gap.widths = {0.1, 0.1};
  gap.elevations = {3, 6};
  gap.contact = {.law = "kelvin-voigt", .numbers = {{"stiffness", {100}}, {"damping", {40}}}};
  c.gaps = {gap};
  c.excitation.delays = {0, 0};
  c.analysis.duration = 1;
  const Problem problem = make_problem(c);
  EXPECT_DOUBLE_EQ(parameter(problem.points[0], "damping_ratio"), 2 / std::sqrt(32.0 * 16 / 48));
  EXPECT_DOUBLE_EQ(parameter(problem.points[1], "damping_ratio"), 2 / std::sqrt(22.0 * 11 / 33));
}

// The annex's floor is 5e-5 off: within a millionth of the tower's 100, not of its own 3.
TEST(MakeProblem, FloorsAreLevelWithinAMillionthOfTheTallerBuilding) {
  Case c;
  c.buildings = {spec_of("Tower", Stick{.storey_heights = {3, 97}, .masses = {1, 1}, .stiffnesses = {1, 1}}),
                 spec_of("Annex", Stick{.storey_heights = {3.00005}, .masses = {1}, .stiffnesses = {1}})};
  GapSpec gap;
  gap.widths = {0.1};
  gap.elevations = {3};
  gap.contact.numbers["stiffness"] = {1};
  c.gaps = {gap};
  c.excitation.delays = {0, 0};
  c.analysis.duration = 1;
  c.gaps[0].level_tolerance = 0;
  EXPECT_EQ(make_problem(c).points.at(0).right_floor, 0);
  c.buildings[1].base_elevation = 1e-4;
  EXPECT_THROW((void)make_problem(c), InvalidParameter);
}

TEST(MakeProblem, EachPointHasItsNumbersAndTheChoicesTheirDefaults) {
  Case c = frame_pair();
  c.gaps[0].contact = {.law = "kelvin-voigt-approach",
                       .axial = true,
                       .numbers = {{"restitution", {0.5, 0.6, 0.7}}},
                       .words = {{"calibration", "published"}}};
  // ξ = (1 − e²)/(e(e(π − 2) + 2)), the published calibration.
  const auto published = [](double e) { return (1 - e * e) / (e * (e * (std::numbers::pi - 2) + 2)); };
  const Problem chosen = make_problem(c);
  EXPECT_NEAR(parameter(chosen.points[0], "damping_ratio"), published(0.5), 1e-15);
  EXPECT_NEAR(parameter(chosen.points[2], "damping_ratio"), published(0.7), 1e-15);
  EXPECT_NEAR(parameter(chosen.points[2], "stiffness"), 183272.727, 1e-3);
  c.gaps[0].contact.words.clear();  // exact
  EXPECT_GT(std::abs(parameter(make_problem(c).points[0], "damping_ratio") - published(0.5)), 1e-3);
}

TEST(ContactSpec, KnowsTheChoicesThatApply) {
  using Words = std::map<std::string, std::string, std::less<>>;
  ContactSpec contact{.law = "kelvin-voigt", .numbers = {{"stiffness", {1}}, {"damping", {1}}}};
  EXPECT_EQ(contact.choices(), (Words{{"release", "zero-force"}}));  // no restitution to calibrate for
  contact.numbers = {{"stiffness", {1, 2}}, {"restitution", {0.5}}};
  contact.words = {{"release", "creep"}};
  EXPECT_EQ(contact.choices(), (Words{{"calibration", "exact"}, {"release", "creep"}}));
  EXPECT_EQ(contact.number("restitution", 1), 0.5);
  EXPECT_EQ(contact.number("stiffness", 1), 2);
  EXPECT_EQ(contact.number("damping", 0), std::nullopt);
  EXPECT_THROW((void)contact.number("stiffness", 2), InvalidParameter);
}

// Rotations free of moment: the rotation rows of K u vanish, to round-off of the terms that cancel.
TEST(MakeProblem, InitialRotationsAreStaticallyCompatible) {
  Case c = frame_pair();
  auto& frame = std::get<PlaneFrame>(c.buildings[0].structure);
  frame.condensation = Condensation::none;
  c.initial.displacements = {{0.1, 0.2, 0.4}, {}};
  c.initial.velocities = {{}, {1, 2, 3}};
  const Problem problem = make_problem(c);
  const StructuralModel& model = problem.buildings[0].model;
  ASSERT_EQ(model.dofs(), 3 + 3 * 2);
  const Eigen::VectorXd& u = problem.initial_displacement[0];
  EXPECT_EQ(u(2), 0.4);
  EXPECT_GT(u.tail(6).cwiseAbs().maxCoeff(), 1e-4);
  const Eigen::VectorXd moments = (model.stiffness * u).tail(6);
  const double scale = (model.stiffness.cwiseAbs() * u.cwiseAbs()).maxCoeff();
  EXPECT_LT(moments.cwiseAbs().maxCoeff(), 1e-13 * scale);
  EXPECT_EQ(problem.initial_displacement[1], Eigen::VectorXd::Zero(3));
  EXPECT_EQ(problem.initial_velocity[1](2), 3);
}

TEST(StructuralModel, MatricesStandAboveTheirBase) {
  MatricesSpec matrices;
  matrices.elevations = {4, 7};
  matrices.mass = (Eigen::Matrix2d() << 52, 1.5, 1.5, 44).finished();
  matrices.stiffness = (Eigen::Matrix2d() << 300, -100, -100, 90).finished();
  BuildingSpec spec = spec_of("Imported", matrices);
  spec.base_elevation = 2;
  const StructuralModel model = structural_model(spec);
  EXPECT_EQ(model.elevations, (std::vector<double>{6, 9}));
  EXPECT_EQ(model.storey_heights, (std::vector<double>{4, 3}));
  EXPECT_EQ(model.load, Eigen::Vector2d(53.5, 45.5));  // M r
  EXPECT_EQ(model.floor_masses, (std::vector<double>{53.5, 45.5}));
  matrices.elevations = {4, 4};
  EXPECT_THROW((void)structural_model(spec_of("Flat", matrices)), InvalidParameter);
}

TEST(StructuralModel, CalibrationSetsTheFirstPeriodAndKeepsTheRatios) {
  BuildingSpec spec = spec_of("Stick", two_storeys());
  const Building plain = make_building(spec);
  spec.calibrate_period = 0.75;
  const Building calibrated = make_building(spec);
  EXPECT_NEAR(2 * std::numbers::pi / calibrated.modes.omega(0), 0.75, 1e-14);
  EXPECT_NEAR(calibrated.modes.omega(1) / calibrated.modes.omega(0), plain.modes.omega(1) / plain.modes.omega(0),
              1e-12);
}

// Rules by hand from peaks that are given: 3 and 4 at the contact level, two undamped periods (ρ = 0).
TEST(Separations, UseTheFreePeaksAtTheContactLevel) {
  Case c;
  c.buildings = {spec_of("A", two_storeys()), spec_of("B", two_storeys())};
  c.buildings[1].calibrate_period = 1.0;
  c.buildings[0].damping = ModalDamping{{0.0}};
  c.buildings[1].damping = ModalDamping{{0.0}};
  GapSpec gap;
  gap.widths = {0.1};
  gap.elevations = {3};
  gap.contact.numbers["stiffness"] = {1e8};
  c.gaps = {gap};
  c.excitation.motion = NoMotion{};
  c.excitation.delays = {0, 0};
  c.analysis.duration = 1;
  const Problem problem = make_problem(c);
  Response response;
  response.buildings.resize(2);
  response.buildings[0].displacement_no_contact = Eigen::Vector2d(3, 30);
  response.buildings[1].displacement_no_contact = Eigen::Vector2d(4, 40);
  response.points.resize(1);
  response.points[0].gap_needed = 2.5;
  response.watched.resize(problem.watched.size());
  const std::vector<LevelSeparation> result = separations(problem, response);
  ASSERT_EQ(result.size(), 1 + problem.watched.size());
  EXPECT_EQ(result[0].gap_needed, 2.5);
  EXPECT_DOUBLE_EQ(result[0].abs, 7);
  EXPECT_DOUBLE_EQ(result[0].srss, 5);
  EXPECT_DOUBLE_EQ(result[0].ddc, 5);
  response.points.clear();
  EXPECT_THROW((void)separations(problem, response), InvalidParameter);
}

// ζ₁ must be read back from Φᵀ C Φ: with 5 % and 2 % at 1 s and 0.5 s ρ = 0.00709.
TEST(Separations, ReadPeriodAndDampingOfTheFirstMode) {
  Case c;
  c.buildings = {spec_of("A", two_storeys()), spec_of("B", two_storeys())};
  c.buildings[0].calibrate_period = 1.0;
  c.buildings[1].calibrate_period = 0.5;
  c.buildings[1].damping = ModalDamping{{0.02}};
  GapSpec gap;
  gap.widths = {0.1, 0.1};
  gap.elevations = {3, 6};
  gap.contact.numbers["stiffness"] = {1e8};
  c.gaps = {gap};
  c.excitation.motion = NoMotion{};
  c.excitation.delays = {0, 0};
  c.analysis.duration = 1;
  Response response;
  response.buildings.resize(2);
  response.buildings[0].displacement_no_contact = Eigen::Vector2d(0.5, 1);
  response.buildings[1].displacement_no_contact = Eigen::Vector2d(0.5, 1);
  response.points.resize(2);
  const double ddc = separations(make_problem(c), response)[1].ddc;
  EXPECT_NEAR(1 - ddc * ddc / 2, 0.00709, 0.5e-5);
}

}  // namespace
}  // namespace bentur
