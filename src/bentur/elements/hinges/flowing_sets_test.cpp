// What is known of sets of hinges: Q⁻¹ by sweeps, whether Q has pivots next to zero, and that it is the same kept or
// not.
#include "bentur/elements/hinges/flowing_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace bentur::flowing_sets {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of `count` hinges by chance with K_hh = A Aᵀ, A of so many columns.
HingeParameters drawn(std::mt19937& random, Index count, Index columns) {
  std::normal_distribution<double> number(0, 1);
  const MatrixXd a = MatrixXd::NullaryExpr(count, columns, [&] { return number(random); });
  return {.stiffness = a * a.transpose(),
          .hardening = VectorXd::Zero(count),
          .upper = VectorXd::Ones(count),
          .lower = VectorXd::Ones(count),
          .rows = MatrixXd::NullaryExpr(count, 3, [&] { return number(random); })};
}

TEST(FlowingSets, HaveThePacesOfTheirStiffness) {
  std::mt19937 random(1);
  for (int drawn_cases = 0; drawn_cases < 200; ++drawn_cases) {
    const Index count = std::uniform_int_distribution(1, 12)(random);
    HingeParameters hinges = drawn(random, count, count + 3);
    hinges.hardening.setConstant(0.1);
    std::vector<Index> flowing;
    for (Index h = 0; h < count; ++h) {
      if (random() % 2 == 0) flowing.push_back(h);
    }
    const FlowingSets kept(FlowingSets::most_kept), forgetful(0);
    const auto paces = kept.paces_of(hinges, flowing);
    const Index size = std::ssize(flowing);
    MatrixXd q = hinges.stiffness(flowing, flowing);
    q.diagonal().array() += 0.1;
    const MatrixXd off = paces->inverse * q - MatrixXd::Identity(size, size);
    EXPECT_LE(off.norm(), 1e-11);  // Q has a condition below 10³: its least eigenvalue is 0.1 or more
    EXPECT_TRUE(paces->apart);
    const auto set = kept.of(hinges, flowing), again = kept.of(hinges, flowing), anew = forgetful.of(hinges, flowing);
    EXPECT_EQ(set, again);
    EXPECT_EQ(set->inverse, paces->inverse);
    EXPECT_EQ(anew->inverse, set->inverse);
    EXPECT_EQ(anew->seen.over, set->seen.over);
    EXPECT_EQ(forgetful.paces_of(hinges, flowing)->inverse, paces->inverse);
    EXPECT_EQ(kept.paces_of(hinges, flowing)->inverse, paces->inverse);
  }
}

TEST(FlowingSets, TellWhereSomeTurnTogetherWithoutResistance) {
  std::mt19937 random(2);
  for (int drawn_cases = 0; drawn_cases < 50; ++drawn_cases) {
    const HingeParameters hinges = drawn(random, 6, 4);  // without hardening two ways of turning are free
    const FlowingSets sets(FlowingSets::most_kept);
    EXPECT_FALSE(sets.paces_of(hinges, {0, 1, 2, 3, 4, 5})->apart);
    EXPECT_FALSE(sets.paces_of(hinges, {0, 1, 2, 4, 5})->apart);
  }
}

}  // namespace
}  // namespace bentur::flowing_sets
