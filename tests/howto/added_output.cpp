// The quantity of docs/howto/add_output.md and the building of docs/howto/add_building.md: added by themselves, without
// a line of the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "docs/howto/base_moment.h"
#include "docs/howto/tank.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using namespace bentur::test;

constexpr auto own = static_cast<OutputKind>(100);

/// Two floors, 1 and 2 above the base, that come against a stiff neighbour.
Problem pounding_pair() {
  Eigen::Matrix2d stiffness;
  stiffness << 900, -400, -400, 400;
  const Eigen::Matrix2d mass = Eigen::Vector2d(2, 3).asDiagonal();
  const Eigen::Matrix2d damping = 0.001 * stiffness;
  Problem problem = pair(matrix_building(mass, stiffness, damping), matrix_building(mass, 4 * stiffness, damping),
                         {contact(0.002, 1e5, 1)}, 6);
  problem.motion = HarmonicMotion{.period = 0.7, .displacement_amplitude = 0.01};
  return problem;
}

class AddedOutput : public testing::TestWithParam<Solver> {};

INSTANTIATE_TEST_SUITE_P(, AddedOutput, testing::Values(Solver{ExactSolver{}}, Solver{AdaptiveSolver{1e-11}}),
                         [](const auto& one) { return std::string(name(one.param)); });

TEST_P(AddedOutput, IsTheMomentOfTheForcesOnTheFloors) {
  const Problem problem = pounding_pair();
  System system = system_of(problem);
  system.bodies[0].outputs.push_back(base_moment(problem.buildings[0], own));
  const FreeSolution free(system, GetParam());
  const Solution solution = free.solve(system.contacts, {.output_step = 0.0005});
  ASSERT_EQ(solution.status, Status::done) << solution.message;
  ASSERT_GT(solution.impacts.size(), 2U);
  const Eigen::MatrixXd& x = solution.outputs[0][0].history;
  const Eigen::RowVectorXd expected = Eigen::RowVector2d(1, 2) * problem.buildings[0].model.stiffness * x;
  const OutputsFound& moment = solution.outputs[0].back();
  const double largest = expected.cwiseAbs().maxCoeff();
  EXPECT_LT((moment.history.row(0) - expected).cwiseAbs().maxCoeff(), 1e-12 * largest);
  EXPECT_GE(moment.peak(0), largest * (1 - 1e-12));
  EXPECT_NEAR(moment.peak(0), largest, 1e-4 * largest);
  EXPECT_NE(moment.peak(0), free.solution().outputs[0].back().peak(0)) << "contact changes it";
}

TEST_P(AddedOutput, OfOneFloorIsItsShearTimesItsHeight) {
  Problem problem = pair(oscillator(2, 300, 0.02), wall(), {contact(0.001, 1e4)}, 4);
  problem.motion = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.01};
  problem.buildings[0].model.elevations = problem.buildings[0].model.storey_heights = {3.5};
  System system = system_of(problem);
  system.bodies[0].outputs.push_back(base_moment(problem.buildings[0], own));
  const Solution solution = FreeSolution(system, GetParam()).solve(system.contacts);
  const double shear = solution.outputs[0][static_cast<std::size_t>(OutputKind::storey_shear)].peak(0);
  EXPECT_NEAR(solution.outputs[0].back().peak(0), 3.5 * shear, 1e-12 * shear);
}

constexpr Tank tower{
    .height = 12, .impulsive_mass = 90, .convective_mass = 40, .tower_stiffness = 9e3, .sloshing_stiffness = 200};

TEST(AddedBuilding, HasTheModesOfTwoMasses) {
  const Building building = make_building("tower", tank_model(tower), ModalDamping{{0.05, 0.005}});
  // det(K − ω² M) = 0: m_i m_c ω⁴ − (m_i k_w + m_c (k_t + k_w)) ω² + k_t k_w = 0.
  const double a = 90.0 * 40, b = 90 * 200 + 40 * (9e3 + 200), c = 9e3 * 200;
  for (const double sign : {-1.0, 1.0}) {
    const double squared = (b + sign * std::sqrt(b * b - 4 * a * c)) / (2 * a);
    EXPECT_NEAR(building.modes.omega(sign < 0 ? 0 : 1), std::sqrt(squared), 1e-12 * std::sqrt(squared));
  }
}

TEST(AddedBuilding, WithoutMuchWaterIsAnOscillator) {
  Tank dry = tower;
  dry.convective_mass = 1e-9;
  dry.sloshing_stiffness = 1e-9;
  const Building building = make_building("tower", tank_model(dry), ModalDamping{{0.05}});
  EXPECT_NEAR(building.modes.omega(1), std::sqrt(9e3 / 90), 1e-9);
}

TEST(AddedBuilding, PoundsLikeAnyOther) {
  Problem problem = pair(make_building("tower", tank_model(tower), ModalDamping{{0.005, 0.05}}),
                         oscillator(300, 9e4, 0.05), {contact(0.01, 1e6)}, 8);
  problem.buildings[1].model.elevations = problem.buildings[1].model.storey_heights = {12.0};
  problem.motion = HarmonicMotion{.period = 0.8, .displacement_amplitude = 0.02};
  const Response response = solve(problem, ExactSolver{}, {.energy_audit = true});
  ASSERT_EQ(response.status, Status::done) << response.message;
  EXPECT_GT(response.impacts.size(), 2U);
  EXPECT_LT(response.energy->relative_residual(), 1e-11);
  // The tower alone holds the tank: its shear is its stiffness times the sway.
  EXPECT_NEAR(response.buildings[0].storey_shear(0), 9e3 * response.buildings[0].displacement(0),
              1e-9 * response.buildings[0].storey_shear(0));
}

TEST(AddedBuilding, RefusesParametersOutsideTheirRanges) {
  Tank tank = tower;
  tank.tower_stiffness = 0;
  EXPECT_THROW((void)tank_model(tank), InvalidParameter);
}

}  // namespace
}  // namespace bentur
