// Columns that break in shear: portals by hand before and after, the energy set free, storeys that nothing holds.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bentur/structure/damping.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/support.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::breaking_columns {
namespace {

using namespace bentur::test;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double modulus = 1, inertia = 2, height = 3, width = 5, beam_inertia = 3, mass = 1.5;

class BreakingColumns : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem) const { return solved(problem, GetParam().solver); }
  [[nodiscard]] double within(double scale) const { return GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, BreakingColumns, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

PlaneFrame portal(std::vector<double> shear_capacity, double residual) {
  PlaneFrame frame;
  frame.elastic_modulus = modulus;
  frame.storey_heights = {height};
  frame.bay_widths = {width};
  frame.columns = {{.area = 1, .inertia = inertia}};
  frame.columns[0].shear_capacity = std::move(shear_capacity);
  frame.columns[0].residual_shear = residual;
  frame.beams = {{.area = 1, .inertia = beam_inertia}};
  frame.floor_masses = {mass};
  frame.mass_matrix = MassMatrix::lumped;
  return frame;
}

Building building_of(const PlaneFrame& frame, const Support& support = {}) {
  return make_building("frame", plane_frame_model(frame), ModalDamping{{0}}, support);
}

Problem pushed(const Building& building, double speed, double duration) {
  Problem problem = alone(building, duration);
  problem.initial_velocity[0](0) = speed;
  problem.motion = SampledMotion{duration, {0.0, 0.0}};
  return problem;
}

/// The portal by hand: x, and the rotations of both joints, which bear no moment of their own. Of a column whose shear
/// is given nothing but EI/h (φ_top − φ_foot) is left as an elastic moment, the same along all of it.
struct ByHand {
  double stiffness = 0;  ///< of the sway, of what is elastic
  double pushed = 0;     ///< force on the floor by a shear of 1 in the left column, whose moments turn the joints
};

ByHand portal_with(bool left_is_whole) {
  const double c = modulus * inertia / height, b = modulus * beam_inertia / width;
  Eigen::Matrix2d joints;
  joints << (left_is_whole ? 4 * c : c) + 4 * b, 2 * b, 2 * b, 4 * c + 4 * b;
  const Eigen::Vector2d coupling(left_is_whole ? -6 * c / height : 0, -6 * c / height);
  const double sway = (left_is_whole ? 2 : 1) * 12 * c / (height * height);
  const Eigen::Vector2d turned = joints.inverse() * coupling;
  // A shear S of the left column goes with moments −S h/2 at its ends: S on the floor, −S h/2 on the joint.
  return {sway - coupling.dot(turned), 1 + turned(0) * height / 2};
}

TEST_P(BreakingColumns, LeaveThePortalToTheOther) {
  const double capacity = 0.3, speed = 1.2;
  const double whole = portal_with(true).stiffness;
  const double at_break = 2 * capacity / whole;  // both bear the same
  const double speed_then = std::sqrt(speed * speed - whole * at_break * at_break / mass);
  const Building building = building_of(portal({capacity, infinite}, 0));
  const double left = portal_with(false).stiffness;
  const Response response = run(pushed(building, speed, 8));
  const BuildingPeaks& peaks = response.buildings[0];
  ASSERT_EQ(peaks.columns.size(), 1U);
  const BuildingPeaks::Breaking& column = peaks.columns[0];
  const double most = std::sqrt(at_break * at_break + mass * speed_then * speed_then / left);
  const double omega = std::sqrt(whole / mass);
  EXPECT_NEAR(column.break_time.value(), std::asin(omega * at_break / speed) / omega, within(1));
  EXPECT_NEAR(column.peak_shear, capacity, within(1));
  EXPECT_NEAR(peaks.displacement(0), most, within(20));
  EXPECT_NEAR(peaks.storey_shear(0), std::max(2 * capacity, left * most), within(20));
  const double released = 0.5 * (whole - left) * at_break * at_break;
  EXPECT_NEAR(column.released_energy, released, within(1) * released);
  EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), 0, within(1)) << "it stands up again";
  EXPECT_FALSE(peaks.mechanism);
}

TEST_P(BreakingColumns, KeepTheirShare) {
  const double capacity = 0.3, speed = 1.2, share = 0.4;
  const double whole = portal_with(true).stiffness;
  const double at_break = 2 * capacity / whole;
  const double speed_then = std::sqrt(speed * speed - whole * at_break * at_break / mass);
  const auto [left, push] = portal_with(false);
  const double kept = share * capacity * push;
  // Up to where it turns: ½ k x² + kept x gains what the mass had.
  const double gained = 0.5 * left * at_break * at_break + kept * at_break + 0.5 * mass * speed_then * speed_then;
  const double most = (std::sqrt(kept * kept + 2 * left * gained) - kept) / left;
  const Building building = building_of(portal({capacity, infinite}, share));
  const Response response = run(pushed(building, speed, 3.2));
  EXPECT_NEAR(response.buildings[0].displacement(0), most, within(50));
  // The force on the floor falls from whole · x to left · x + kept, and the energy by half of the sum times the slip.
  const BuildingPeaks::Breaking& column = response.buildings[0].columns[0];
  const double slip = (1 - share) * capacity / building.model.hinges.stiffness(0, 0);
  const double released = 0.5 * (1 + share) * capacity * slip;
  EXPECT_NEAR(column.released_energy, released, within(1) * released);
  const double dropped = whole * at_break - (left * at_break + kept);
  EXPECT_NEAR(dropped, building.model.hinges.rows(0, 0) * slip, within(10));
}

TEST_P(BreakingColumns, ThatAllBreakLeaveTheFloorToItsMass) {
  const double capacity = 0.3, speed = 1.2, duration = 2;
  const double whole = portal_with(true).stiffness;
  const double at_break = 2 * capacity / whole;
  const double omega = std::sqrt(whole / mass);
  const double speed_then = std::sqrt(speed * speed - omega * omega * at_break * at_break);
  const double time = std::asin(omega * at_break / speed) / omega;
  const Response response = run(pushed(building_of(portal({capacity}, 0)), speed, duration));
  const BuildingPeaks& peaks = response.buildings[0];
  EXPECT_NEAR(peaks.displacement(0), at_break + speed_then * (duration - time), within(20));
  ASSERT_TRUE(peaks.mechanism);
  EXPECT_NEAR(peaks.mechanism->time, time, within(1));
  EXPECT_EQ(peaks.mechanism->storeys, std::vector<Eigen::Index>{0});
  EXPECT_TRUE(std::isnan(peaks.yielding.residual_drift_ratio(0))) << "nothing says where it comes to rest";
  for (const BuildingPeaks::Breaking& column : peaks.columns) {
    EXPECT_NEAR(column.released_energy, 0.25 * whole * at_break * at_break, within(1));
  }
}

TEST_P(BreakingColumns, BreakOneAfterAnother) {
  // What the weaker one bore breaks the other; the third bears all in the end.
  PlaneFrame frame = portal({0.3, 0.32, infinite}, 0);
  frame.bay_widths = {width, width};
  const Response response = run(pushed(building_of(frame), 1.2, 6));
  const auto& columns = response.buildings[0].columns;
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_TRUE(columns[0].break_time && columns[1].break_time);
  EXPECT_FALSE(response.buildings[0].mechanism);
  EXPECT_LT(response.energy->relative_residual(), within(1e3));
}

TEST_P(BreakingColumns, UnderGravityFallOver) {
  Support support;
  support.gravity = GravityLoads{{0.05}};
  const Problem problem = pushed(building_of(portal({0.3}, 0), support), 1.2, 60);
  const Response response = solve(problem, GetParam().solver);
  ASSERT_EQ(response.status, Status::collapsed) << response.message;
  ASSERT_TRUE(response.collapse);
  EXPECT_EQ(response.collapse->storey, 0);
  EXPECT_TRUE(std::isfinite(response.buildings[0].displacement(0)));
}

TEST_P(BreakingColumns, BeyondReachChangeNothing) {
  for (const double moment : {infinite, 0.4}) {
    PlaneFrame strong = portal({1e9}, 0.3), bare = portal({}, 0);
    strong.columns[0].moment_capacity = bare.columns[0].moment_capacity = {moment};
    const Response one = run(pushed(building_of(strong), 1.2, 6));
    const Response other = run(pushed(building_of(bare), 1.2, 6));
    // Sums over more coordinates, all zero but those that the other has, are taken in another order.
    const double slack = 1e-13 * other.buildings[0].displacement(0);
    EXPECT_NEAR(one.buildings[0].displacement(0), other.buildings[0].displacement(0), slack);
    EXPECT_NEAR(one.buildings[0].storey_shear(0), other.buildings[0].storey_shear(0), slack * 10);
    ASSERT_EQ(one.buildings[0].hinges.size(), other.buildings[0].hinges.size());
    for (const BuildingPeaks::Breaking& column : one.buildings[0].columns) {
      EXPECT_FALSE(column.break_time);
      EXPECT_EQ(column.released_energy, 0);
    }
  }
}

TEST_P(BreakingColumns, BeyondReachFromTheStart) {
  // Held at twice what breaks the left column, and let go: it is broken from the first instant on.
  const double capacity = 0.3, whole = portal_with(true).stiffness, left = portal_with(false).stiffness;
  Problem problem = pushed(building_of(portal({capacity, infinite}, 0)), 0, 8);
  const double start = problem.initial_displacement[0](0) = 4 * capacity / whole;
  const Response response = run(problem);
  const BuildingPeaks::Breaking& column = response.buildings[0].columns[0];
  EXPECT_EQ(column.break_time, 0);
  EXPECT_NEAR(response.buildings[0].displacement(0), start, within(10));
  EXPECT_NEAR(response.buildings[0].storey_shear(0), left * start, within(10));
}

TEST_P(BreakingColumns, ThatAreStruckBreakPieceByPiece) {
  // The piece above bears the push at the node alone, when the piece below has gone.
  PlaneFrame frame = portal({0.4, infinite}, 0);
  frame.nodes = {{.left = true, .elevation = 1.2}};
  frame.columns[0].mass = 0.2;
  const Building building = building_of(frame);
  Problem problem = pushed(building, 0, 3);
  problem.initial_velocity[0](1) = 3.5;
  const Response response = run(problem);
  const auto& columns = response.buildings[0].columns;
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(building.model.hinges.columns[0].piece, 1);
  EXPECT_EQ(building.model.hinges.columns[1].piece, 2);
  ASSERT_TRUE(columns[0].break_time && columns[1].break_time);
  EXPECT_LT(*columns[0].break_time, *columns[1].break_time);
  EXPECT_NEAR(response.buildings[0].column_forces(0), columns[0].peak_shear, within(1));
  ASSERT_TRUE(response.buildings[0].mechanism) << "the node";
  EXPECT_TRUE(response.buildings[0].mechanism->storeys.empty()) << "the other column holds the storey";
  EXPECT_LT(response.energy->relative_residual(), within(1e3));
}

}  // namespace
}  // namespace bentur::breaking_columns
