#include "bentur/core/algebra/factors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bentur {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Entries that are small whole numbers: products of them are exact, quotients right to a rounding or two.
constexpr double round_off = 1e-15;

MatrixXd matrix_of_springs() {
  MatrixXd a(3, 3);
  a << 4, -2, 0, -2, 5, -3, 0, -3, 6;
  return a;
}

TEST(Cholesky, FactorsOfASmallMatrix) {
  MatrixXd a(2, 2), lower(2, 2);
  a << 4, 2, 2, 3;
  lower << 2, 0, 1, std::sqrt(2.0);
  const Cholesky factors(a);
  EXPECT_TRUE(factors.is_positive_definite());
  EXPECT_LE((factors.lower() - lower).norm(), round_off);
}

TEST(Cholesky, SolvesVectorsMatricesAndPartsOfThem) {
  const MatrixXd a = matrix_of_springs();
  const VectorXd x = VectorXd::LinSpaced(3, 1, 3);
  const Cholesky factors(a);
  EXPECT_LE((factors.solve(VectorXd(a * x)) - x).norm(), 10 * round_off);
  EXPECT_LE((factors.solve(a.leftCols(2)) - MatrixXd::Identity(3, 2)).norm(), 10 * round_off);
  // Of rows 1 and 2 alone: (4 −2; −2 5)⁻¹ (0, −1).
  const Eigen::Vector2d part(-2.0 / 16, -4.0 / 16);
  EXPECT_LE((Cholesky(a.topLeftCorner(2, 2)).solve((a * x).head(2)) - part).norm(), round_off);
}

TEST(Cholesky, WhatIsNotPositiveDefiniteIsKnown) {
  MatrixXd a = matrix_of_springs();
  EXPECT_TRUE(is_positive_definite(a));
  a(2, 2) = 2.25;  // det A = 4·(5·2.25 − 9) − 4·2.25 = 0
  EXPECT_FALSE(is_positive_definite(a - 1e-12 * MatrixXd::Identity(3, 3)));
  EXPECT_FALSE(Cholesky(a - MatrixXd::Identity(3, 3)).is_positive_definite());
}

TEST(Ldlt, PivotsTellWhetherItIsDefinite) {
  const Ldlt factors(matrix_of_springs());
  EXPECT_NEAR(factors.pivots().prod(), 4 * (5 * 6 - 9) - 4 * 6, 1e-13) << "its determinant";
  EXPECT_TRUE(factors.is_definite(1e-9));
  const VectorXd ones = VectorXd::Ones(3);
  EXPECT_FALSE(Ldlt(ones * ones.transpose()).is_definite(1e-9));
}

TEST(Ldlt, SolvesWhatIsIndefiniteToo) {
  MatrixXd a = matrix_of_springs();
  a(0, 0) = -4;
  const VectorXd x = VectorXd::LinSpaced(3, -1, 1);
  const Ldlt factors(a);
  EXPECT_LE((factors.solve(VectorXd(a * x)) - x).norm(), 10 * round_off);
  EXPECT_LE((factors.solve(a) - MatrixXd::Identity(3, 3)).norm(), 10 * round_off);
}

TEST(SolveGeneral, OfAMatrixThatIsNotSymmetric) {
  MatrixXd a(2, 2);
  a << 0, 2, 4, 1;
  EXPECT_LE((solve_general(a, a * MatrixXd::Ones(2, 3)) - MatrixXd::Ones(2, 3)).norm(), round_off);
}

TEST(LeastNorm, SharesEquallyWhatOneAloneCouldTake) {
  const MatrixXd a = MatrixXd::Ones(2, 3);
  const VectorXd b = VectorXd::Constant(2, 6);
  EXPECT_LE((least_norm_solution(a, b) - VectorXd::Constant(3, 2)).norm(), 10 * round_off);
  // What tells the columns apart by less than `apart` is no reason to share otherwise.
  MatrixXd nearly = a;
  nearly(1, 2) += 1e-13;
  EXPECT_LE((least_norm_solution(nearly, b, 1e-11) - VectorXd::Constant(3, 2)).norm(), 1e-11);
}

TEST(CombinationOf, RowsThatMakeARow) {
  MatrixXd rows(2, 4);
  rows << 1, 0, 2, -1, 0, 1, 1, 3;
  const VectorXd of = Eigen::Vector2d(3, -2);
  EXPECT_LE((combination_of(rows, of.transpose() * rows) - of).norm(), 10 * round_off);
  // Beside them: what is at right angles to all rows counts for nothing.
  const Eigen::RowVector4d aside(1, -3, 0, 1);
  EXPECT_LE((combination_of(rows, of.transpose() * rows + aside) - of).norm(), 10 * round_off);
}

}  // namespace
}  // namespace bentur
