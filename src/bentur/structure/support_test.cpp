#include "bentur/structure/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"
#include "bentur/structure/sway.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double gravity = 9.80665;

Stick one_storey() { return {{3.5}, {40}, {9e3}}; }
Stick three_storeys() { return {{3.5, 3.0, 3.0}, {30, 28, 25}, {40e3, 36e3, 30e3}}; }

PlaneFrame small_frame() {
  const Section column = {.area = 0.16, .inertia = 0.4 * 0.4 * 0.4 * 0.4 / 12, .line_mass = 0.16 * 2.5};
  const Section beam = {.area = 0.15, .inertia = 0.3 * 0.5 * 0.5 * 0.5 / 12, .line_mass = 0.15 * 2.5};
  PlaneFrame frame;
  frame.elastic_modulus = 2.6e7;
  frame.storey_heights = {3.3, 3.0};
  frame.bay_widths = {5.0, 6.5};
  frame.columns = {column, column};
  frame.beams = {beam, beam};
  frame.floor_masses = {40, 34};
  return frame;
}

Building on(const Support& support, const StructuralModel& model, double ratio = 0.05) {
  return make_building("A", model, ModalDamping{{ratio}}, support);
}

double period_of(const Building& building) { return 2 * std::numbers::pi / building.first_omega(); }

std::string message_of(const Support& support, const StructuralModel& model) {
  try {
    (void)on(support, model);
  } catch (const InvalidParameter& error) {
    return error.what();
  }
  return "";
}

// Veletsos & Meek (1974): a structure on a foundation without mass.
TEST(Support, PeriodOfOneStoreyOnSoil) {
  const StructuralModel model = stick_model(one_storey());
  const double k = 9e3, h = 3.5, fixed = 2 * std::numbers::pi * std::sqrt(40 / k);
  for (const auto& [sway, rocking] : {std::pair(5e4, 8e5), std::pair(9e3, 1e5), std::pair(1e6, 4e4)}) {
    const Soil soil = {.sway = {sway, 0}, .rocking = {rocking, 0}, .mass = 1e-9, .inertia = 1e-9};
    const double expected = fixed * std::sqrt(1 + k / sway + k * h * h / rocking);
    EXPECT_NEAR(period_of(on({.soil = soil}, model)) / expected, 1, 1e-9);
  }
}

TEST(Support, OnVeryStiffSoilItIsAsOnAFixedBase) {
  for (const StructuralModel& model : {stick_model(three_storeys()), plane_frame_model(small_frame())}) {
    const Building fixed = make_building("A", model, ModalDamping{{0.05}});
    // As heavy as it is stiff: round-off in ω² is that of the fastest mode.
    const Soil soil = {.sway = {1e16, 0}, .rocking = {1e18, 0}, .mass = 1e10, .inertia = 1e12};
    const Building building = on({.soil = soil}, model);
    const Index n = fixed.modes.omega.size();
    ASSERT_EQ(building.modes.omega.size(), n + 2);
    EXPECT_TRUE(building.model.foundation);
    for (Index mode = 0; mode < n; ++mode) {
      EXPECT_NEAR(building.modes.omega(mode) / fixed.modes.omega(mode), 1, 1e-8) << mode;
      const double ratio = building.modal_damping(mode, mode) / (2 * building.modes.omega(mode));
      EXPECT_NEAR(ratio, 0.05, 1e-8) << mode;
      const VectorXd difference = building.modes.shapes.col(mode).head(n) - fixed.modes.shapes.col(mode);
      EXPECT_LE(difference.norm(), 1e-7 * fixed.modes.shapes.col(mode).norm()) << mode;
    }
  }
}

TEST(Support, SoilMovesTheStructureAsARigidBody) {
  // Sway and rocking alone strain nothing of the structure: drifts and shears are those of y = x − u − hθ.
  const StructuralModel model = stick_model(three_storeys(), 2.0);
  const Soil soil = {.sway = {5e4, 30}, .rocking = {8e5, 90}, .mass = 12, .inertia = 70};
  const Building building = on({.soil = soil}, model);
  VectorXd z(5);
  const double u = 0.02, theta = 0.003;
  z << u + 3.5 * theta, u + 6.5 * theta, u + 9.5 * theta, u, theta;
  EXPECT_LE((drift_rows(building.model) * z).norm(), 1e-15);
  EXPECT_LE((shear_rows(building.model) * z).norm(), 1e-10);
  const VectorXd force = building.model.stiffness * z;
  EXPECT_LE(force.head(3).norm(), 1e-9);
  EXPECT_NEAR(force(3), 5e4 * u, 1e-9);
  EXPECT_NEAR(force(4), 8e5 * theta, 1e-9);
  // All of it moves with the ground: the loads on floors and foundation are its masses.
  const VectorXd load = (VectorXd(5) << 30, 28, 25, 12, 0).finished();
  EXPECT_LE((building.model.load - load).norm(), 1e-12);
  // The column between floors too.
  for (const double above : {0.5, 3.5, 5.0, 9.5}) {
    EXPECT_NEAR(sway_at(building.model, 2.0 + above, Face::left).dot(z), u + above * theta, 1e-15) << above;
  }
  const Building frame = on({.soil = soil}, plane_frame_model(small_frame()));
  VectorXd rigid = VectorXd::Zero(frame.model.dofs());
  rigid << u + 3.3 * theta, u + 6.3 * theta, u, theta;
  for (const double above : {0.0, 0.5, 1.7, 3.3, 4.0, 6.3}) {
    EXPECT_NEAR(sway_at(frame.model, above, Face::right).dot(rigid), u + above * theta, 1e-15) << above;
  }
}

TEST(Support, HalfSpace) {
  // Numbers by hand: ν = 1/3, ρ = 2, v = 100, r = 3, I_f = 50.
  const Soil soil = soil_of({.shear_wave_velocity = 100, .density = 2, .poisson = 1.0 / 3, .radius = 3}, 7, 50);
  const double shear_modulus = 2e4;
  EXPECT_NEAR(soil.sway.stiffness / (8 * shear_modulus * 3 / (5.0 / 3)), 1, 1e-14);
  EXPECT_NEAR(soil.sway.damping / (4.6 * 2 * 100 * 9 / (5.0 / 3)), 1, 1e-14);
  EXPECT_NEAR(soil.rocking.stiffness / (8 * shear_modulus * 27 / 2), 1, 1e-14);
  const double inertia_ratio = 3 * (2.0 / 3) * 50 / (8 * 2 * 243.0);
  EXPECT_NEAR(soil.rocking.damping / (0.8 * 81 * 200 / ((2.0 / 3) * (1 + inertia_ratio))), 1, 1e-14);
  EXPECT_EQ(soil.mass, 7);
  EXPECT_EQ(soil.inertia, 50);
  for (const double poisson : {-0.01, 0.51, std::nan("")}) {
    EXPECT_THROW((void)soil_of({100, 2, poisson, 3}, 7, 50), InvalidParameter) << poisson;
  }
}

TEST(Support, PeriodOfAFrictionPendulum) {
  // What stands on it is as good as rigid; after sliding the stiffness is W/R.
  const StructuralModel model = stick_model({{3, 3}, {90, 80}, {9e10, 8e10}});
  const double weight = gravity * mass_above_bearings(model, 100);
  EXPECT_DOUBLE_EQ(weight, gravity * 270);
  const LawInput input = {.numbers = {{"coefficient", 0.06}, {"radius", 2.0}, {"yield_displacement", 0.0008}},
                          .weight = weight};
  const Isolation isolation = {.mass = 100, .bearings = *find_entry(bearing_laws(), "friction_pendulum")->make(input)};
  // Beyond yield: a linear bearing of the stiffness after it.
  const Isolation sliding = {.mass = 100, .bearings = bilinear_bearings(weight / 2, 0, 0)};
  const Building building = on({.isolation = sliding}, model);
  EXPECT_NEAR(period_of(building) / (2 * std::numbers::pi * std::sqrt(2.0 / gravity)), 1, 1e-7);
  EXPECT_TRUE(building.elements.empty());
  // The law: initial stiffness W/R + Q/Δ_y, on the line V = Q + (W/R) Δ.
  const Building yielding = on({.isolation = isolation}, model);
  ASSERT_EQ(yielding.elements.size(), 1U);
  EXPECT_EQ(yielding.storey_law(1), nullptr);
  const auto* law = yielding.storey_law(0);
  ASSERT_NE(law, nullptr);
  EXPECT_DOUBLE_EQ(law->yield_deformation(), 0.0008);
  EXPECT_NEAR(shear_rows(yielding.model)(0, 0), weight / 2 + 0.06 * weight / 0.0008, 1e-9 * weight / 0.0008);
}

TEST(Support, SlabIsTheFirstFloor) {
  const StructuralModel model = stick_model(three_storeys(), 1.5);
  const Isolation isolation = {.mass = 35, .bearings = bilinear_bearings(400, 0, 0), .damping = 6};
  const Building building = on({.isolation = isolation}, model);
  EXPECT_EQ(building.model.slab, 0);
  EXPECT_EQ(building.model.elevations, (std::vector<double>{1.5, 5.0, 8.0, 11.0}));
  EXPECT_EQ(building.model.storey_heights, (std::vector<double>{0, 3.5, 3.0, 3.0}));
  EXPECT_EQ(building.model.floor_masses, (std::vector<double>{35, 30, 28, 25}));
  EXPECT_LE((building.model.load - Eigen::Vector4d(35, 30, 28, 25)).norm(), 1e-12);
  const Stick same = {{1, 3.5, 3.0, 3.0}, {35, 30, 28, 25}, {400, 40e3, 36e3, 30e3}};
  EXPECT_LE((building.model.stiffness - stick_model(same).stiffness).norm(), 1e-9);
  // Damping of what stands above acts on what moves relative to the slab: none where all moves as one.
  const Eigen::MatrixXd to = building.model.mass * building.modes.shapes;
  const Eigen::MatrixXd damping = to * building.modal_damping * to.transpose();
  EXPECT_LE((damping * VectorXd::Ones(4) - 6 * VectorXd::Unit(4, 0)).norm(), 1e-8);
  // A frame's feet join the slab.
  const StructuralModel frame = plane_frame_model(small_frame());
  const Building isolated = on({.isolation = isolation}, frame);
  const double feet = isolated.model.floor_masses[0] - 35;
  EXPECT_NEAR(feet, 3 * 0.16 * 2.5 * 3.3 / 2, 1e-9);
  EXPECT_NEAR(isolated.model.load.sum(), mass_above_bearings(frame, 35), 1e-9);
}

TEST(Support, GravityLoadsSoftenOneStorey) {
  const StructuralModel model = stick_model(one_storey());
  const double load = 40 * gravity;
  const Building building = on({.gravity = GravityLoads{{load}}}, model);
  EXPECT_NEAR(building.first_omega() * building.first_omega(), 9e3 / 40 - gravity / 3.5, 1e-10);
  EXPECT_TRUE(building.has_gravity_loads);
  EXPECT_DOUBLE_EQ(shear_rows(building.model)(0, 0), 9e3) << "shears are those of the springs alone";
  EXPECT_NEAR(building.modal_damping(0, 0), 2 * 0.05 * building.first_omega(), 1e-12);
}

TEST(Support, GravityLoadsBeyondCriticalNameTheStorey) {
  const StructuralModel model = stick_model(three_storeys());
  const double weakest = 36e3 * 3.0;  // of the second storey, which bears the upper two loads
  EXPECT_EQ(message_of({.gravity = GravityLoads{{0, 0.5 * weakest, 0.49 * weakest}}}, model), "");
  const std::string message = message_of({.gravity = GravityLoads{{0, 0.9 * weakest, 0.2 * weakest}}}, model);
  EXPECT_NE(message.find("storey 2"), std::string::npos) << message;
  EXPECT_NE(message.find("gravity_loads"), std::string::npos) << message;
  EXPECT_NE(message_of({.gravity = GravityLoads{{1, 2}}}, model), "") << "one per floor";
  EXPECT_NE(message_of({.gravity = GravityLoads{{1, 2, -3}}}, model), "");
}

TEST(Support, OnSoilGravityActsOnTotalSways) {
  // A rigid storey on a hinge of stiffness k_r: ω² (m h² + I_f) = k_r − m g h.
  const StructuralModel model = stick_model({{4}, {10}, {1e9}});
  const Soil soil = {.sway = {1e9, 0}, .rocking = {5e3, 0}, .mass = 1, .inertia = 2};
  const Building building = on({.gravity = GravityLoads{{10 * gravity}}, .soil = soil}, model);
  const double omega = building.first_omega();
  EXPECT_NEAR(omega * omega, (5e3 - 10 * gravity * 4) / (10 * 16 + 2), 1e-4);
}

TEST(Support, ImpossibleOnesAreRefused) {
  const StructuralModel model = stick_model(one_storey());
  const Isolation isolation = {.mass = 35, .bearings = bilinear_bearings(400, 0, 0)};
  const Soil soil = {.sway = {1e5, 0}, .rocking = {1e6, 0}, .mass = 1, .inertia = 1};
  EXPECT_NE(message_of({.isolation = isolation, .soil = soil}, model), "");
  for (const Isolation& wrong : {Isolation{.mass = 0, .bearings = isolation.bearings}, Isolation{.mass = 35},
                                 Isolation{.mass = 35, .bearings = isolation.bearings, .damping = -1}}) {
    EXPECT_NE(message_of({.isolation = wrong}, model), "");
  }
  EXPECT_THROW((void)bilinear_bearings(0, 0, 0), InvalidParameter);
  EXPECT_THROW((void)bilinear_bearings(400, -1, 0), InvalidParameter);
  EXPECT_THROW((void)bilinear_bearings(400, 5, 0), InvalidParameter);
  for (double Soil::*value : {&Soil::mass, &Soil::inertia}) {
    Soil wrong = soil;
    wrong.*value = 0;
    EXPECT_NE(message_of({.soil = wrong}, model), "");
  }
}

TEST(RigidBuilding, HasFloorsAndNoModes) {
  const Building wall = rigid_building("Wall", {-1.0, 0.0, 2.5});
  EXPECT_TRUE(wall.is_rigid());
  EXPECT_EQ(wall.first_omega(), 0);
  EXPECT_EQ(wall.model.floors(), 3);
  EXPECT_TRUE(std::isinf(wall.model.floor_masses[0]));
  EXPECT_EQ(base_of(wall.model), -1.0);
  EXPECT_FALSE(wall.can_yield());
  EXPECT_THROW((void)rigid_building("Wall", {}), InvalidParameter);
  EXPECT_THROW((void)rigid_building("Wall", {1, 1}), InvalidParameter);
}

}  // namespace
}  // namespace bentur
