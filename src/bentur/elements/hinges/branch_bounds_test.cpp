// What ends a branch of hinges, held against moments worked out from what all of them have turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "bentur/elements/hinges.h"
#include "tests/support/driven.h"

namespace bentur::branch_bounds {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

HingeLaw drawn(std::mt19937& random, Index count) {
  std::normal_distribution<double> number(0, 1);
  std::uniform_real_distribution<double> strength(0.3, 1.0);
  const MatrixXd a = MatrixXd::NullaryExpr(count, count + 2, [&] { return number(random); });
  const auto strengths = [&] { return VectorXd(VectorXd::NullaryExpr(count, [&] { return strength(random); })); };
  HingeLaw::Parameters of{.stiffness = a * a.transpose(),
                          .hardening = 0.2 * strengths(),
                          .upper = strengths(),
                          .lower = strengths(),
                          .rows = MatrixXd::NullaryExpr(count, count, [&] { return number(random); })};
  of.upper(0) = std::numeric_limits<double>::infinity();
  return HingeLaw(std::move(of));
}

TEST(BranchesOfHinges, SayHowFarMomentsAreFromTheirLines) {
  std::mt19937 random(5);
  std::normal_distribution<double> number(0, 1);
  int resting = 0, flowing = 0, begun = 0;
  for (int course = 0; course < 60; ++course) {
    const Index count = 2 + course % 6;
    const HingeLaw law = drawn(random, count);
    VectorXd at = VectorXd::Zero(count);
    CoupledState state = law.begin(at);
    for (int leg = 0; leg < 5; ++leg) {
      const VectorXd to = VectorXd::NullaryExpr(count, [&] { return 1.5 * number(random); });
      state = test::driven(law, state, at, to);
      at = to;
      // As an event would find it that another motion goes on from.
      const VectorXd speed = VectorXd::NullaryExpr(count, [&] { return number(random); });
      const CoupledState now = law.settle(state, state.since, {at, speed, VectorXd::Zero(count), 1e-9});
      VectorXd theta(count);
      for (Index h = 0; h < count; ++h) theta(h) = law.record(now, h).rotation;
      const HingeLaw::Parameters& of = law.parameters();
      const VectorXd y = at - of.stiffness * theta - of.hardening.cwiseProduct(theta);
      const CoupledBranch branch = law.branch(now);
      std::vector<int> bounds(static_cast<std::size_t>(count), 0), rates = bounds;
      for (std::size_t g = 0; g < branch.guard_count(); ++g) {
        const CoupledGuard guard = branch.guard(g);
        if (std::isinf(guard.constant)) continue;
        if (guard.deformation < 0) {
          ++rates[static_cast<std::size_t>(guard.of)];
          continue;
        }
        ++bounds[static_cast<std::size_t>(guard.of)];
        const double line = guard.sense < 0 ? of.upper(guard.of) : of.lower(guard.of);
        const double left = guard.constant + guard.sense * branch.set->row(guard.deformation, count).dot(at);
        EXPECT_NEAR(left, line + guard.sense * y(guard.of), 1e-11 * (1 + guard.size)) << guard.of;
        EXPECT_GE(guard.size, line);
        begun += guard.zeros > 0 ? 1 : 0;
      }
      for (Index h = 0; h < count; ++h) {
        const auto n = static_cast<std::size_t>(h);
        const bool flows = law.record(now, h).flows != 0;
        EXPECT_EQ(rates[n], flows ? 1 : 0) << h;
        EXPECT_EQ(bounds[n], flows ? 0 : h == 0 ? 1 : 2) << h;
        (flows ? flowing : resting) += 1;
      }
    }
  }
  EXPECT_GT(resting, 500);
  EXPECT_GT(flowing, 100);
  EXPECT_GT(begun, 50);
}

/// What resting hinges hold goes on from event to event, by what begins and ceases to flow.
TEST(BranchesOfHinges, AreThoseWorkedOutAnew) {
  std::mt19937 random(6);
  std::normal_distribution<double> number(0, 1);
  int changed = 0;
  for (int course = 0; course < 10; ++course) {
    const Index count = 4 + course;
    const HingeLaw law = drawn(random, count);
    VectorXd at = VectorXd::Zero(count);
    CoupledState state = law.begin(at);
    for (int leg = 0; leg < 60; ++leg) {
      const VectorXd to = VectorXd::NullaryExpr(count, [&] { return 1.5 * number(random); });
      state = test::driven(law, state, at, to, [&](const CoupledState& now) {
        const CoupledBranch branch = law.branch(now), anew = law.branch({now.since, now.memory});
        ASSERT_EQ(branch.guard_count(), anew.guard_count());
        for (std::size_t g = 0; g < branch.guard_count(); ++g) {
          const CoupledGuard one = branch.guard(g), other = anew.guard(g);
          if (std::isinf(other.constant)) continue;
          changed += one.constant != other.constant ? 1 : 0;
          // 32 sums at most, each to the round-off of what it is a sum of.
          EXPECT_NEAR(one.constant, other.constant, 1e-14 * other.size);
          EXPECT_NEAR(one.size, other.size, 1e-14 * other.size);
        }
      });
      at = to;
    }
  }
  EXPECT_GT(changed, 100);  // or it would not be looked at
}

}  // namespace
}  // namespace bentur::branch_bounds
