#include "bentur/solve/engine/run/impulses.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <optional>
#include <random>

namespace bentur::engine {
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

TEST(Impulses, AreThoseFoundByTryingAllSets) {
  std::mt19937_64 random(42);
  std::normal_distribution<double> normal;
  int mixed = 0;
  for (int n = 0; n < 2000; ++n) {
    const Index size = 1 + n % 7;
    const MatrixXd a = random_spd(random, size);
    VectorXd b(size);
    for (double& x : b) x = normal(random);
    const VectorXd p = *impulses(a, b), wanted = by_trying_all(a, b);
    ASSERT_LE((p - wanted).norm(), 1e-9 * (1 + wanted.norm())) << n;  // condition up to 1e3
    const VectorXd y = a * p - b;
    for (Index i = 0; i < size; ++i) {
      ASSERT_GE(p(i), 0);
      ASSERT_GE(y(i), -1e-12 * b.norm());
      ASSERT_NEAR(p(i) * y(i), 0, 1e-11 * (1 + p.norm()) * b.norm());
    }
    const auto pushed = (p.array() > 0).count();
    mixed += pushed > 0 && pushed < size ? 1 : 0;
  }
  EXPECT_GT(mixed, 1000);
}

TEST(Impulses, OfOnePoint) {
  const MatrixXd a = MatrixXd::Constant(1, 1, 0.25);
  EXPECT_EQ((*impulses(a, VectorXd::Constant(1, 3)))(0), 12);
  EXPECT_EQ((*impulses(a, VectorXd::Constant(1, -3)))(0), 0);
  EXPECT_EQ((*impulses(a, VectorXd::Zero(1)))(0), 0);
}

/// Murty's pivoting goes through 2^n sets in the worst case; these (Murty 1978) are built to make least-index pivoting
/// do so, and it must still end.
TEST(Impulses, EndOnTheWorstCaseOfPivoting) {
  for (Index size = 2; size <= 10; ++size) {
    MatrixXd lower = MatrixXd::Zero(size, size);
    for (Index i = 0; i < size; ++i) {
      lower(i, i) = 1;
      for (Index j = 0; j < i; ++j) lower(i, j) = 2;
    }
    const MatrixXd a = lower * lower.transpose();
    const VectorXd b = VectorXd::Ones(size);
    const VectorXd p = *impulses(a, b), y = a * p - b;
    EXPECT_GE(p.minCoeff(), 0);
    EXPECT_GE(y.minCoeff(), -1e-9);
    EXPECT_NEAR(p.dot(y), 0, 1e-9);
  }
}

/// Points that do not know of each other are solved as each on its own.
TEST(Impulses, OfIndependentPoints) {
  VectorXd diagonal(4), b(4);
  diagonal << 1, 2, 4, 8;
  b << 1, -2, 4, 0;
  const VectorXd p = *impulses(MatrixXd(diagonal.asDiagonal()), b);
  EXPECT_EQ(p, VectorXd({{1, 0, 1, 0}}));
}

// Two points between the same floors, with two coefficients of restitution: no P parts both as fast as asked.
TEST(Impulses, EndWithoutAnAnswerWhereAIsSingular) {
  EXPECT_FALSE(impulses(MatrixXd::Constant(2, 2, 0.7), Eigen::Vector2d(1.5, 1.9)).has_value());
}

}  // namespace
}  // namespace bentur::engine
