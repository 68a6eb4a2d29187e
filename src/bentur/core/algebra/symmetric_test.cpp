#include "bentur/core/algebra/symmetric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Norms here are of the order 1: the solvers' errors are a few roundings of the largest entry.
constexpr double accuracy = 1e-14;

/// 2 on the diagonal, −1 beside it: λ = 2 − 2 cos(k π/(n + 1)).
MatrixXd chain(Index n) {
  MatrixXd a = 2 * MatrixXd::Identity(n, n);
  a.diagonal(1).setConstant(-1);
  a.diagonal(-1).setConstant(-1);
  return a;
}

double of_chain(Index n, Index k) {
  return 2 - 2 * std::cos(static_cast<double>(k) * std::numbers::pi / static_cast<double>(n + 1));
}

TEST(SymmetricModes, OfAChainOfSprings) {
  const MatrixXd a = chain(7);
  const SymmetricModes found = symmetric_modes(a);
  ASSERT_TRUE(found.converged);
  for (Index k = 0; k < 7; ++k) EXPECT_NEAR(found.values(k), of_chain(7, k + 1), accuracy) << k;
  EXPECT_LE((found.vectors.transpose() * found.vectors - MatrixXd::Identity(7, 7)).norm(), accuracy);
  EXPECT_LE((a * found.vectors - found.vectors * found.values.asDiagonal()).norm(), accuracy);
  EXPECT_LE((symmetric_values(a) - found.values).norm(), accuracy);
}

TEST(SymmetricModes, OfThreeByThree) {
  const Eigen::Matrix3d a = chain(3);
  const SymmetricModes found = symmetric_modes_of_3(a);
  EXPECT_LE((found.values - symmetric_modes(MatrixXd(a)).values).norm(), accuracy);
  EXPECT_LE((a * found.vectors - found.vectors * found.values.asDiagonal()).norm(), accuracy);
}

TEST(SymmetricModes, TheLowerTriangleIsRead) {
  MatrixXd a = chain(4);
  a.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
  EXPECT_NEAR(symmetric_values(a)(0), of_chain(4, 1), accuracy);
}

TEST(SymmetricModes, InverseSquareRoot) {
  const MatrixXd a = chain(5), root = inverse_square_root(a);
  EXPECT_LE((root * a * root - MatrixXd::Identity(5, 5)).norm(), 10 * accuracy);
  EXPECT_LE((root - root.transpose()).norm(), accuracy);
}

TEST(GeneralisedModes, MassesThatAreAllTwoHalveTheValues) {
  const MatrixXd a = chain(6), b = 2 * MatrixXd::Identity(6, 6);
  const SymmetricModes found = generalised_modes(a, b);
  ASSERT_TRUE(found.converged);
  for (Index k = 0; k < 6; ++k) EXPECT_NEAR(found.values(k), of_chain(6, k + 1) / 2, accuracy) << k;
  EXPECT_LE((found.vectors.transpose() * b * found.vectors - MatrixXd::Identity(6, 6)).norm(), accuracy);
  EXPECT_LE((generalised_values(a, b) - found.values).norm(), accuracy);
}

TEST(GeneralisedModes, OfAMatrixThatIsNotDiagonal) {
  const MatrixXd a = chain(4), b = chain(4) * chain(4);
  const SymmetricModes found = generalised_modes(a, b);
  // A v = λ A² v: λ = 1/λ_A, the largest λ_A first.
  for (Index k = 0; k < 4; ++k) EXPECT_NEAR(found.values(k), 1 / of_chain(4, 4 - k), 10 * accuracy) << k;
}

}  // namespace
}  // namespace bentur
