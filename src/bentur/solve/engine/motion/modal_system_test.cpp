#include "bentur/solve/engine/motion/modal_system.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd stiffness_matrix() {
  MatrixXd stiffness(2, 2);
  stiffness << 900, -400, -400, 400;
  return stiffness;
}

/// Two buildings of two floors that meet at both.
Problem two_floors() {
  const MatrixXd mass = Eigen::Vector2d(2, 3).asDiagonal(), damping = 0.01 * stiffness_matrix();
  return test::pair(test::matrix_building(mass, stiffness_matrix(), damping),
                    test::matrix_building(0.7 * mass, stiffness_matrix(), damping),
                    {test::contact(1, 1, 0), test::contact(1, 1, 1)}, 1);
}

double norm(const MatrixXd& matrix) { return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues()(0); }

/// A bound of the norm of A, of q̈ = −A q − B q̇, where r² ≥ ‖A‖ + ‖B‖ r.
void expect_bound(const ModalSystem& system, const ContactForces& forces) {
  MatrixXd a = system.omega_squared.asDiagonal(), b = system.two_sigma.asDiagonal();
  for (const std::size_t i : forces.pressing) {
    const ModalSystem::Point& point = system.points[i];
    Eigen::VectorXd sense = Eigen::VectorXd::Zero(system.size), push = sense;
    sense.segment(point.left_begin, point.left_size) = point.sense_left;
    sense.segment(point.right_begin, point.right_size) = point.sense_right;
    push.segment(point.left_begin, point.left_size) = point.push_left;
    push.segment(point.right_begin, point.right_size) = point.push_right;
    a += forces.linear[i].stiffness * push * sense.transpose();
    b += forces.linear[i].damping * push * sense.transpose();
  }
  const double rate = system.rate(forces);
  EXPECT_TRUE(std::isfinite(rate));
  EXPECT_GE(rate * rate * (1 + 1e-12), norm(a) + norm(b) * rate);
}

TEST(ModalSystem, RateBoundsTheSeriesWhateverTheSignOfContactStiffnessAndDamping) {
  const ModalSystem system(two_floors());
  for (const double first : {-5e4, 0.0, 2e3, 8e4}) {
    for (const double second : {-7e4, -30.0, 4e4}) {
      ContactForces forces;
      forces.linear = {{0, first, 0.003 * second}, {0, second, 0.002 * first}};
      forces.pressing = {0, 1};
      expect_bound(system, forces);
      ContactForces positive = forces;
      for (auto& linear : positive.linear) {
        linear = {0, std::abs(linear.stiffness), std::abs(linear.damping)};
      }
      EXPECT_EQ(system.rate(forces), system.rate(positive));
    }
  }
}

TEST(ModalSystem, GroundHasNoPartInTheSpeedOfTheBuildings) {
  Problem problem = two_floors();
  problem.kinematics = Kinematics::absolute;
  problem.initial_velocity[0] = Eigen::Vector2d(0.3, -0.2);
  problem.initial_velocity[1] = Eigen::Vector2d(1, 2);
  const ModalSystem system(problem);
  // Twice the kinetic energy: Σ m v².
  const double energy = 2 * 0.09 + 3 * 0.04 + 0.7 * (2 * 1 + 3 * 4);
  Eigen::VectorXd v = system.initial_v;
  EXPECT_NEAR(system.speed(v), std::sqrt(energy), 1e-14);
  for (const auto& block : system.blocks) v(block.begin + block.size - 1) = 1e3;
  EXPECT_NEAR(system.speed(v), std::sqrt(energy), 1e-14);
}

}  // namespace
}  // namespace bentur::engine
