#include "bentur/elements/complementarity.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_spd(std::mt19937_64& random, Index size) {
  std::normal_distribution<double> normal;
  MatrixXd root(size, size);
  for (double& x : root.reshaped()) x = normal(random);
  return root * root.transpose() + 0.05 * MatrixXd::Identity(size, size);
}

/// Tries every set of pushed points; one alone solves the problem unless b is on a boundary between two.
VectorXd by_trying_all(const MatrixXd& a, const VectorXd& b) {
  const Index count = b.size();
  VectorXd best;
  double best_violation = 1e300;
  for (unsigned set = 0; set < 1u << count; ++set) {
    std::vector<Index> pushed;
    for (Index i = 0; i < count; ++i) {
      if ((set >> i & 1u) != 0) pushed.push_back(i);
    }
    VectorXd p = VectorXd::Zero(count);
    if (!pushed.empty()) p(pushed) = MatrixXd(a(pushed, pushed)).fullPivLu().solve(VectorXd(b(pushed)));
    const VectorXd y = a * p - b;
    double violation = std::max(0.0, -p.minCoeff());
    for (Index i = 0; i < count; ++i) {
      if ((set >> i & 1u) == 0) violation = std::max(violation, -y(i));
    }
    if (violation < best_violation) best_violation = violation, best = p;
  }
  EXPECT_LT(best_violation, 1e-12);
  return best;
}

TEST(Complementarity, IsWhatIsFoundByTryingAllSets) {
  std::mt19937_64 random(42);
  std::normal_distribution<double> normal;
  int mixed = 0;
  for (int n = 0; n < 2000; ++n) {
    const Index size = 1 + n % 7;
    const MatrixXd a = random_spd(random, size);
    VectorXd b(size);
    for (double& x : b) x = normal(random);
    const VectorXd p = *complementary(a, b), wanted = by_trying_all(a, b);
    ASSERT_LE((p - wanted).norm(), 1e-9 * (1 + wanted.norm())) << n;  // condition up to 1e3
    const VectorXd y = a * p - b;
    for (Index i = 0; i < size; ++i) {
      ASSERT_GE(p(i), 0);
      ASSERT_GE(y(i), -1e-12 * b.norm());
      ASSERT_NEAR(p(i) * y(i), 0, 1e-11 * (1 + p.norm()) * b.norm());
    }
    std::vector<Index> guess;
    for (Index i = 0; i < size; ++i) {
      if (normal(random) > 0) guess.push_back(i);
    }
    ASSERT_EQ(*complementary(a, b, guess), p) << "whatever it begins with";
    const auto pushed = (p.array() > 0).count();
    mixed += pushed > 0 && pushed < size ? 1 : 0;
  }
  EXPECT_GT(mixed, 1000);
}

TEST(Complementarity, OfOne) {
  const MatrixXd a = MatrixXd::Constant(1, 1, 0.25);
  EXPECT_EQ((*complementary(a, VectorXd::Constant(1, 3)))(0), 12);
  EXPECT_EQ((*complementary(a, VectorXd::Constant(1, -3)))(0), 0);
  EXPECT_EQ((*complementary(a, VectorXd::Zero(1)))(0), 0);
  // To the bit as factors find it: of a pair the other of which neither pushes nor is pushed.
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 1000; ++n) {
    const double stiffness = std::exp(5 * normal(random)), wanted = normal(random);
    const MatrixXd pair = VectorXd{{stiffness, 1.0}}.asDiagonal();
    EXPECT_EQ(complementary(MatrixXd{{stiffness}}, VectorXd{{wanted}}).value()(0),
              complementary(pair, VectorXd{{wanted, -1.0}}).value()(0));
  }
}

/// Built to make least-index pivoting go through 2^n sets (Murty 1978): that is no reason not to end.
TEST(Complementarity, EndsOnTheWorstCaseOfPivoting) {
  for (Index size = 2; size <= 10; ++size) {
    MatrixXd lower = MatrixXd::Zero(size, size);
    for (Index i = 0; i < size; ++i) {
      lower(i, i) = 1;
      for (Index j = 0; j < i; ++j) lower(i, j) = 2;
    }
    const MatrixXd a = lower * lower.transpose();
    const VectorXd b = VectorXd::Ones(size);
    const VectorXd p = *complementary(a, b), y = a * p - b;
    EXPECT_GE(p.minCoeff(), 0);
    EXPECT_GE(y.minCoeff(), -1e-9);
    EXPECT_NEAR(p.dot(y), 0, 1e-9);
  }
}

/// Points that do not know of each other are solved as each on its own.
TEST(Complementarity, OfThoseThatDoNotKnowOfEachOther) {
  VectorXd diagonal(4), b(4);
  diagonal << 1, 2, 4, 8;
  b << 1, -2, 4, 0;
  const VectorXd p = *complementary(MatrixXd(diagonal.asDiagonal()), b);
  EXPECT_EQ(p, VectorXd({{1, 0, 1, 0}}));
}

// Two points between the same floors, with two coefficients of restitution: the livelier one parts both.
TEST(Complementarity, OfThoseThatMoveAlike) {
  const Eigen::VectorXd p = *complementary(MatrixXd::Constant(2, 2, 0.7), Eigen::Vector2d(1.5, 1.9));
  EXPECT_EQ(p(0), 0);
  EXPECT_DOUBLE_EQ(p(1), 1.9 / 0.7);
}

/// A = R Rᵀ of more rows than columns, with b = R x: p is not unique, A p is.
TEST(Complementarity, OfASingularMatrix) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int mixed = 0;
  for (int n = 0; n < 2000; ++n) {
    const Index size = 2 + n % 9;
    MatrixXd root(size, 1 + n % (size - 1));
    for (double& x : root.reshaped()) x = normal(random);
    if (n % 3 == 0) root.row(0) = -root.row(1);  // as two ends at a joint
    VectorXd x(root.cols());
    for (double& entry : x) entry = normal(random);
    const MatrixXd a = root * root.transpose();
    const VectorXd b = root * x;
    const auto found = complementary(a, b);
    ASSERT_TRUE(found) << n;
    const VectorXd y = a * *found - b;
    const double size_of_b = b.cwiseAbs().maxCoeff();
    ASSERT_GE(found->minCoeff(), 0) << n;
    ASSERT_GE(y.minCoeff(), -1e-9 * size_of_b) << n;
    ASSERT_NEAR(found->dot(y), 0, 1e-9 * size_of_b * (1 + found->norm())) << n;
    const auto pushed = (found->array() > 0).count();
    ASSERT_LE(pushed, root.cols()) << n;
    mixed += pushed > 0 && pushed < size ? 1 : 0;
  }
  EXPECT_GT(mixed, 1000);
}

TEST(Complementarity, LeastNormIsThatOfAllSetsThatMayPush) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  int shared = 0;
  for (int n = 0; n < 500; ++n) {
    const Index size = 2 + n % 5;
    MatrixXd root(size, 1 + n % (size - 1));
    for (double& x : root.reshaped()) x = normal(random);
    if (n % 2 == 0) root.row(0) = root.row(1);
    VectorXd x(root.cols());
    for (double& entry : x) entry = normal(random);
    const MatrixXd a = root * root.transpose();
    const VectorXd b = root * x, any = *complementary(a, b), p = least_norm(a, b, any);
    const double size_of_b = b.cwiseAbs().maxCoeff();
    ASSERT_GE(p.minCoeff(), 0) << n;
    ASSERT_LE((a * (p - any)).cwiseAbs().maxCoeff(), 1e-9 * size_of_b) << n;
    ASSERT_NEAR(p.dot(a * p - b), 0, 1e-9 * size_of_b * (1 + p.norm())) << n;
    // Whatever pushes, with the least that gives the same A p.
    double least = any.norm();
    for (int set = 1; set < 1 << size; ++set) {
      std::vector<Index> of;
      for (Index i = 0; i < size; ++i) {
        if ((set >> i & 1) != 0 && (a * any - b)(i) < 1e-9 * size_of_b) of.push_back(i);
      }
      if (of.empty()) continue;
      const MatrixXd columns = a(Eigen::all, of);
      const VectorXd with = columns.completeOrthogonalDecomposition().solve(a * any);
      if (with.minCoeff() < -1e-9 || (columns * with - a * any).norm() > 1e-9 * size_of_b) continue;
      least = std::min(least, with.norm());
    }
    ASSERT_NEAR(p.norm(), least, 1e-7 * (1 + least)) << n;
    shared += (p.array() > 1e-9).count() > (any.array() > 1e-9).count() ? 1 : 0;
  }
  EXPECT_GT(shared, 100);
}

TEST(Complementarity, LeastNormIsWhatIsFoundWhereThatIsAlone) {
  const MatrixXd a{{2, 1}, {1, 3}};
  const Eigen::Vector2d b(1, 2);
  const VectorXd p = *complementary(a, b);
  EXPECT_EQ(least_norm(a, b, p), p);
}

}  // namespace
}  // namespace bentur
