// Hinges that lose strength, with what drives them held at every step: against backbones by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/elements/hinges.h"
#include "bentur/elements/hinges/rate_problem.h"
#include "tests/support/driven.h"

namespace bentur::hinge_backbones {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::driven;

constexpr double stiffness = 100, hardening = 2, capacity = 10, plastic = 0.05, softening = 0.2;
constexpr double at_cap = capacity + hardening * plastic;

HingeParameters one(double residual, double ultimate = std::numeric_limits<double>::infinity()) {
  HingeParameters of{.stiffness = MatrixXd::Constant(1, 1, stiffness),
                     .hardening = VectorXd::Constant(1, hardening),
                     .upper = VectorXd::Constant(1, capacity),
                     .lower = VectorXd::Constant(1, capacity),
                     .rows = MatrixXd::Identity(1, 1)};
  of.backbones = {{capacity, capacity, 0, plastic, softening, residual, ultimate}};
  return of;
}

double moment(const HingeLaw& law, const CoupledState& state, const VectorXd& deformation, Index h) {
  VectorXd theta(law.size());
  for (Index n = 0; n < law.size(); ++n) theta(n) = law.record(state, n).rotation;
  return deformation(h) - law.parameters().stiffness.row(h).dot(theta);
}

double by_hand(double theta, double residual, double ultimate) {
  if (theta >= ultimate) return 0;
  if (theta <= plastic) return capacity + hardening * theta;
  return std::max(residual * capacity, at_cap * (1 - (theta - plastic) / softening));
}

TEST(HingeBackbone, IsFollowedToWhereNothingIsLeft) {
  for (const double residual : {0.3, 0.0}) {
    const HingeLaw law(one(residual, residual > 0 ? 0.4 : std::numeric_limits<double>::infinity()));
    const double ultimate = residual > 0 ? 0.4 : plastic + softening;
    for (const double side : {1.0, -1.0}) {
      double before = 0;
      CoupledState state = law.begin(VectorXd::Zero(1));
      for (double delta = 5; delta < 60; delta += 0.7) {
        const VectorXd to = VectorXd::Constant(1, side * delta);
        state = driven(law, state, VectorXd::Constant(1, side * before), to);
        before = delta;
        const HingeLaw::Record is = law.record(state, 0);
        const double m = side * moment(law, state, to, 0);
        if (is.rotation != 0) {
          EXPECT_NEAR(m, by_hand(std::abs(is.rotation), residual, ultimate), 1e-9) << delta;
        }
        EXPECT_NEAR(moment(law, law.begin(to), to, 0), side * m, 1e-9) << "in one go, " << delta;
        EXPECT_EQ(is.failed.has_value(), std::abs(is.rotation) >= ultimate * (1 - 1e-9)) << delta;
      }
      const HingeLaw::Record is = law.record(state, 0);
      EXPECT_EQ(is.strength_left, 0);
      EXPECT_TRUE(law.is_free(state, 0));
      // The area below the backbone, and what was left of elastic energy when it failed.
      const double level = residual * capacity, softens = softening * (1 - level / at_cap);
      const double area = (capacity + at_cap) / 2 * plastic + (at_cap + level) / 2 * softens +
                          (residual > 0 ? level * (ultimate - plastic - softens) : 0);
      EXPECT_NEAR(is.lost, area + level * level / (2 * stiffness), 1e-9);
      EXPECT_NEAR(is.released, level * level / (2 * stiffness), 1e-9);
    }
  }
}

TEST(HingeBackbone, LosesBothCapacitiesByTheSameShare) {
  const HingeLaw law(one(0.3));
  const auto at = [](double delta) { return VectorXd::Constant(1, delta).eval(); };
  const double theta = 0.15, left = 1 - (theta - plastic) / softening;
  CoupledState state = driven(law, law.begin(at(0)), at(0), at(at_cap * left + stiffness * theta));
  EXPECT_NEAR(law.record(state, 0).rotation, theta, 1e-12);
  EXPECT_NEAR(law.record(state, 0).strength_left, left, 1e-12);
  const double other = capacity - hardening * plastic;  // less by hardening, where it came to its cap
  const double back = 0.05, reached = stiffness * back - left * other;
  state = driven(law, state, at(at_cap * left + stiffness * theta), at(reached));
  EXPECT_NEAR(law.record(state, 0).rotation, back, 1e-12) << "no slope below the largest rotation";
  EXPECT_NEAR(moment(law, state, at(reached), 0), -left * other, 1e-9);
  const double beyond = -0.18, less = 1 - (-beyond - plastic) / softening;
  const double further = stiffness * beyond - less * other;
  state = driven(law, state, at(reached), at(further));
  EXPECT_NEAR(law.record(state, 0).rotation, beyond, 1e-12) << "beyond it, on the other side";
  EXPECT_NEAR(law.record(state, 0).strength_left, less, 1e-12);
}

HingeParameters two(double coupling) {
  HingeParameters of{.stiffness = Eigen::Matrix2d{{stiffness, coupling}, {coupling, stiffness}},
                     .hardening = VectorXd::Zero(2),
                     .upper = VectorXd::Constant(2, capacity),
                     .lower = VectorXd::Constant(2, capacity),
                     .rows = MatrixXd::Identity(2, 2)};
  of.backbones = {{}, {capacity, capacity, 0, 0.02, 0.125, 0.2}};  // a slope of −80, of the 64 that both leave
  return of;
}

TEST(HingeBackbone, SnapsWhereTheOthersDoNotHoldIt) {
  // Both flow alike, M = 10 = δ − 40 θ, until the second comes to its cap; δ is held while its line falls from 10 to 2.
  const HingeLaw law(two(-60));
  const VectorXd zero = VectorXd::Zero(2), at = VectorXd::Constant(2, capacity + 40 * 0.02 + 1e-12);
  const CoupledState before = driven(law, law.begin(zero), zero, VectorXd::Constant(2, 10.7));
  EXPECT_EQ(law.record(before, 1).strength_left, 1);
  const CoupledState state = driven(law, before, VectorXd::Constant(2, 10.7), at);
  const HingeLaw::Record is = law.record(state, 1), other = law.record(state, 0);
  const double turns = 8.0 / 64, with_it = 0.6 * turns;
  EXPECT_TRUE(is.snapped);
  EXPECT_NEAR(is.strength_left, 0.2, 1e-12);
  EXPECT_NEAR(is.rotation, 0.02 + turns, 1e-9);
  EXPECT_NEAR(other.rotation, 0.02 + with_it, 1e-9);
  EXPECT_NEAR(moment(law, state, at, 0), 10, 1e-9);
  EXPECT_NEAR(moment(law, state, at, 1), 2, 1e-9);
  EXPECT_NEAR(is.released, 6 * turns, 1e-9);
  // What the elastic members gave up, less what the first hinge took.
  const auto stored = [&](double one, double second) {
    const Eigen::Vector2d theta(one, second);
    return -at.dot(theta) + 0.5 * theta.dot(law.parameters().stiffness * theta);
  };
  EXPECT_NEAR(is.released, stored(0.02, 0.02) - stored(0.02 + with_it, 0.02 + turns) - 10 * with_it, 1e-9);
  EXPECT_FALSE(other.snapped);
}

TEST(HingeBackbone, SoftensAloneWhereAnotherCanUnload) {
  const HingeLaw law(two(60));
  const VectorXd zero = VectorXd::Zero(2), at = VectorXd::Constant(2, capacity + 160 * 0.02 + 0.4);
  const CoupledState state = driven(law, law.begin(zero), zero, at);
  EXPECT_FALSE(law.record(state, 1).snapped);
  EXPECT_NEAR(law.record(state, 0).rotation, 0.02, 1e-12);
  EXPECT_NEAR(law.record(state, 1).rotation, 0.02 + 0.4 / 20, 1e-9);
  EXPECT_NEAR(moment(law, state, at, 1), 10 - 80 * 0.02, 1e-9);
}

HingeLaw worn_law(double wear, double exponent) {
  HingeParameters of = one(0.3);
  of.backbones[0].wear = wear;
  of.backbones[0].wear_exponent = exponent;
  return HingeLaw(of);
}

TEST(HingeBackbone, WearsByThreeCyclesAsByHand) {
  for (const double exponent : {1.0, 1.5}) {
    for (const bool pauses : {false, true}) {
      const double most = 10 * capacity * plastic;  // γ M_y θ_c
      const HingeLaw law = worn_law(10, exponent);
      CoupledState state = law.begin(VectorXd::Zero(1));
      VectorXd at = VectorXd::Zero(1);
      const auto to = [&](double delta) {
        const VectorXd next = VectorXd::Constant(1, delta);
        state = driven(law, state, at, next);
        at = next;
      };
      double left[2] = {1, 1}, lost = 0, theta = 0;
      for (int half = 0; half < 6; ++half) {
        const double s = half % 2 == 0 ? 1 : -1, goes_to = s * 0.03;
        const double bears = left[half % 2] * capacity, loses = bears * std::abs(goes_to - theta);
        if (pauses) {  // and goes on from there: the excursion is one
          const double middle = theta + 0.4 * (goes_to - theta), there = s * bears + (stiffness + hardening) * middle;
          to(there);
          to(there - s * 4);
        }
        to(s * bears + (stiffness + hardening) * goes_to);
        theta = goes_to;
        lost += loses;
        EXPECT_NEAR(law.record(state, 0).rotation, theta, 1e-12) << half;
        EXPECT_NEAR(moment(law, state, at, 0), s * bears + hardening * theta, 1e-11) << half;
        EXPECT_NEAR(law.record(state, 0).lost, lost, 1e-12) << half;
        left[1 - half % 2] *= 1 - std::pow(loses / (most - lost), exponent);
      }
      EXPECT_FALSE(law.record(state, 0).cap);
      // Beyond the cap what is left of both sides goes on from there: C⁺ w⁺, C⁻ w⁻.
      const double above = left[0] * capacity, far = 0.1, share = 1 - (far - plastic) / softening;
      const double lost_before = lost, peak = above + hardening * plastic, there = share * peak + stiffness * far;
      to(there);
      lost += above * (plastic - theta) + hardening * plastic * plastic / 2 + (1 + share) / 2 * peak * (far - plastic);
      EXPECT_NEAR(law.record(state, 0).lost, lost, 1e-12);
      EXPECT_NEAR(moment(law, state, at, 0), share * peak, 1e-11);
      const double before = left[1], since = lost - lost_before;
      to(there - 0.5);
      left[1] *= 1 - std::pow(since / (most - lost), exponent);
      EXPECT_NEAR(law.record(state, 0).strength_left, share * std::min(left[0], left[1]), 1e-12);
      const double below = left[1] / before * (before * capacity - hardening * plastic);
      to(-share * below + stiffness * 0.05);
      EXPECT_NEAR(moment(law, state, at, 0), -share * below, 1e-11);
      EXPECT_NEAR(law.record(state, 0).rotation, 0.05, 1e-12);
    }
  }
}

TEST(HingeBackbone, FailsWhereItTurnsWithAllThatItCanLoseUsedUp) {
  for (const double side : {1.0, -1.0}) {
    const HingeLaw law = worn_law(0.5, 1);
    const VectorXd zero = VectorXd::Zero(1);
    const double theta = 0.02, bears = capacity + hardening * theta;
    const VectorXd far = VectorXd::Constant(1, side * (bears + stiffness * theta));
    const CoupledState there = driven(law, law.begin(zero), zero, far);
    EXPECT_FALSE(law.record(there, 0).failed) << "not while it flows";
    const CoupledState state = driven(law, there, far, 0.9 * far);
    const HingeLaw::Record is = law.record(state, 0);
    EXPECT_TRUE(is.failed);
    EXPECT_FALSE(is.cap);
    EXPECT_EQ(is.strength_left, 0);
    EXPECT_NEAR(moment(law, state, 0.9 * far, 0), 0, 1e-12);
    EXPECT_NEAR(is.released, bears * bears / (2 * stiffness), 1e-12);
    EXPECT_NEAR(is.lost, capacity * theta + hardening * theta * theta / 2 + is.released, 1e-12);
  }
}

TEST(HingeBackbone, OfNoWearIsAsItWas) {
  const HingeLaw law(one(0.3)), long_lived = worn_law(1e18, 1);
  VectorXd at = VectorXd::Zero(1);
  CoupledState state = law.begin(at), other = long_lived.begin(at);
  for (const double delta : {14.0, -20.0, 30.0, -18.0, 25.0}) {
    const VectorXd to = VectorXd::Constant(1, delta);
    state = driven(law, state, at, to);
    other = driven(long_lived, other, at, to);
    at = to;
    EXPECT_EQ(law.record(state, 0).rotation, long_lived.record(other, 0).rotation) << delta;
    EXPECT_EQ(law.record(state, 0).lost, long_lived.record(other, 0).lost) << delta;
  }
}

TEST(HingeBackbone, RefusesWhatCannotBeFollowed) {
  for (const auto& [key, change] : {std::pair<std::string, HingeBackbone>{"softening", {10, 10, 0, 0.05, 0.1}},
                                    {"residual", {10, 10, 0, 0.05, 0.2, 1}},
                                    {"plastic", {10, 10, 0, 6, 20}},
                                    {"ultimate", {10, 10, 0, 0.05, 0.2, 0, 0.04}},
                                    {"wear", {10, 10, 0, 0.05, 0.2, 0, 1, 0}},
                                    {"wear_exponent", {10, 10, 0, 0.05, 0.2, 0, 1, 5, 2.5}}}) {
    HingeParameters of = one(0.3);
    of.backbones = {change};
    try {
      HingeLaw law(of);
      FAIL() << key;
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.parameter(), "backbones[0]." + key);
    }
  }
}

TEST(RateProblem, IsThatOfComplementarityWhereNothingSoftens) {
  const MatrixXd a = Eigen::Matrix3d{{4, -1, 1}, {-1, 3, 0.5}, {1, 0.5, 2}};
  const VectorXd b = Eigen::Vector3d(1, 2, -1);
  const RateSolution found = least_rate(a, b, 0, a.diagonal());
  ASSERT_FALSE(found.unbounded);
  const VectorXd w = a * found.pace - b;
  for (Index i = 0; i < 3; ++i) {
    EXPECT_GE(found.pace(i), 0);
    EXPECT_GE(w(i), -1e-12);
    EXPECT_NEAR(w(i) * found.pace(i), 0, 1e-12);
  }
}

}  // namespace
}  // namespace bentur::hinge_backbones
