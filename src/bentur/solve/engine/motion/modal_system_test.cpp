#include "bentur/solve/engine/motion/modal_system.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

#include "tests/support/random_yielding.h"
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
void expect_bound(const ModalSystem& system, const ElementForces& forces) {
  MatrixXd a = system.omega_squared.asDiagonal(), b = system.two_sigma.asDiagonal();
  for (const Eigen::Index i : forces.pressing) {
    const ModalSystem::Relation& of = system.elements[i].relation;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(system.size), push = row;
    row.segment(of.left_begin, of.left_size) = of.left_row;
    row.segment(of.right_begin, of.right_size) = of.right_row;
    push.segment(of.left_begin, of.left_size) = of.left_push;
    push.segment(of.right_begin, of.right_size) = of.right_push;
    a -= forces.linear[i].stiffness * push * row.transpose();
    b -= forces.linear[i].damping * push * row.transpose();
  }
  const double rate = system.rate(forces);
  EXPECT_TRUE(std::isfinite(rate));
  EXPECT_GE(rate * rate * (1 + 1e-12), norm(a) + norm(b) * rate);
}

TEST(ModalSystem, RateBoundsTheSeriesWhateverTheSignOfStiffnessAndDamping) {
  const ModalSystem system(system_of(two_floors()));
  for (const double first : {-5e4, 0.0, 2e3, 8e4}) {
    for (const double second : {-7e4, -30.0, 4e4}) {
      ElementForces forces;
      forces.linear = {{0, first, 0.003 * second}, {0, second, 0.002 * first}};
      forces.pressing = {0, 1};
      expect_bound(system, forces);
    }
  }
}

TEST(ModalSystem, WhatSoftensWithinTheStiffnessThatIsThereDoesNotRaiseTheRate) {
  const ModalSystem system(system_of(two_floors()));
  ElementForces forces;
  forces.linear = {{0, -3, 0}, {0, -2, 0}};
  forces.pressing = {0, 1};
  EXPECT_EQ(system.rate(forces), system.rate({}));
  forces.linear[1].stiffness = 50;
  EXPECT_GT(system.rate(forces), system.rate({}));
}

// Against all pairs, one after the other: rows of two to four buildings with links and storeys that yield.
TEST(ModalSystem, ElementsOfOtherBodiesAreNotCoupled) {
  int coupled = 0, apart = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ModalSystem system(system_of(test::YieldingGenerator(seed).make().problem));
    for (Eigen::Index i = 0; i < std::ssize(system.elements); ++i) {
      Eigen::VectorXd pushed = Eigen::VectorXd::Zero(system.size);
      system.push(i, -1.0, pushed);
      for (Eigen::Index j = 0; j < std::ssize(system.elements); ++j) {
        const double expected = system.elements[j].relation.along(pushed);
        EXPECT_EQ(system.coupling(i, j), expected);
        ++(expected == 0.0 ? apart : coupled);
      }
    }
  }
  EXPECT_GT(coupled, 100);
  EXPECT_GT(apart, 100);
}

TEST(ModalSystem, GroundHasNoPartInTheSpeedOfTheBuildings) {
  Problem problem = two_floors();
  problem.kinematics = Kinematics::absolute;
  problem.initial_velocity[0] = Eigen::Vector2d(0.3, -0.2);
  problem.initial_velocity[1] = Eigen::Vector2d(1, 2);
  const ModalSystem system(system_of(problem));
  // Twice the kinetic energy: Σ m v².
  const double energy = 2 * 0.09 + 3 * 0.04 + 0.7 * (2 * 1 + 3 * 4);
  Eigen::VectorXd v = system.initial_v;
  EXPECT_NEAR(system.speed(v), std::sqrt(energy), 1e-14);
  for (const auto& block : system.blocks) v(block.begin + block.modes) = 1e3;
  EXPECT_NEAR(system.speed(v), std::sqrt(energy), 1e-14);
}

/// What is kept of many elements is what is kept of few.
TEST(Couplings, OfManyElementsAreThoseOfFew) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> value(-1, 1);
  const Eigen::Index count = engine::Couplings::most_whole + 10, few = 40;
  engine::Couplings many(count), whole(few);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    std::vector<std::pair<Eigen::Index, double>> row;
    for (Eigen::Index j = count - 1; j >= 0; --j) {
      if (value(draw) > -0.9) continue;
      expected(i, j) = value(draw);
      row.emplace_back(j, expected(i, j));
    }
    many.set_row(i, row);
    std::erase_if(row, [&](const auto& one) { return one.first >= few; });
    if (i < few) whole.set_row(i, row);
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      EXPECT_EQ(many(i, j), expected(i, j));
      if (i < few && j < few) {
        EXPECT_EQ(whole(i, j), expected(i, j));
      }
    }
  }
  EXPECT_EQ(many.among({5, 1, 300})(2, 0), expected(300, 5));
}

}  // namespace
}  // namespace bentur::engine
