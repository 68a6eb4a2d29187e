// Two struts of an infill panel: cycles over yield, cap and residual by hand, energy, random courses.
#include "bentur/elements/softening/strut_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "bentur/core/errors.h"
#include "tests/support/led_element.h"

namespace bentur::strut_pair {
namespace {

using test::LedElement;

// k = 100, yields at (2, 200), cap 300 at 4, then down by 50 a length to 60 at 8.8, gone at 12.
constexpr double stiffness = 100;
constexpr Backbone of_panel = {.yield = 200, .cap = 1.5, .plastic = 2, .softening = 6, .residual = 0.3, .ultimate = 12};

TEST(StrutPair, GoesOverYieldCapAndResidualAsByHand) {
  const StrutPair law(stiffness, of_panel);
  EXPECT_FALSE(law.loss({}, 0)->capped);
  LedElement element(law, 2);
  for (const auto& [deformation, force] : {std::pair{1.0, 100.0},
                                           {-1.5, -150.0},
                                           {2.0, 200.0},
                                           {3.0, 250.0},    // hardens by 50: 0.5 of its way to the cap
                                           {1.0, 50.0},     // unloaded along k from (3, 250): p = 0.5
                                           {0.3, 0.0},      // neither strut resists
                                           {-1.0, -100.0},  // the other one is whole
                                           {-2.5, -225.0},  // and yields: p = 0.25 of it
                                           {-0.1, 0.0},
                                           {0.4, 0.0},
                                           {2.0, 150.0},  // along k again
                                           {3.5, 275.0},  // beyond the turn, on its backbone
                                           {6.0, 200.0},  // 300 − 2 · 50
                                           {4.0, 0.0},    // p = 4
                                           {5.5, 150.0},
                                           {10.0, 60.0},  // residual from 8.8 on
                                           {9.6, 20.0},
                                           {10.5, 60.0},
                                           {0.0, 0.0},
                                           {-2.5, -225.0},  // the other one has kept its backbone
                                           {12.1, 0.0},     // crushed for good, both ways
                                           {-3.0, 0.0}}) {
    element.lead_to(deformation);
    EXPECT_NEAR(element.force(), force, 1e-10) << deformation;
  }
  const StrengthLoss loss = *law.loss(element.state(), -3);
  EXPECT_TRUE(loss.capped && loss.residual && loss.failed);
  EXPECT_EQ(loss.left, 0);
}

TEST(StrutPair, LosesTheAreaBelowItsBackboneOnceAndNothingBelowIt) {
  const StrutPair law(stiffness, of_panel);
  LedElement element(law, 2);
  element.lead_to(6);
  element.lead_to(4);
  const double once = 0.5 * 2 * 200 + 2 * 250 + 2 * 250 - 0.5 * 200 * 200 / stiffness;
  EXPECT_NEAR(element.hysteretic(), once, 1e-10 * once);
  EXPECT_NEAR(law.loss(element.state(), 4)->left, 200.0 / 300, 1e-12);
  for (int cycle = 0; cycle < 5; ++cycle) {
    for (const double point : {-1.9, 5.9}) element.lead_to(point);
  }
  element.lead_to(0);
  EXPECT_NEAR(element.hysteretic(), once, 1e-10 * once);
}

TEST(StrutPair, PushesOneWayAtATimeAndGivesBackNoMoreThanItTook) {
  const StrutPair law(stiffness, of_panel);
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(-11, 11);
    LedElement one(law, 2), mirrored(law, 2);
    double lost = 0;
    for (int turn = 0; turn < 20; ++turn) {
      const double point = anywhere(random) * (turn % 3 == 0 ? 0.3 : 1.0);
      one.lead_to(point);
      mirrored.lead_to(-point);
      ASSERT_EQ(one.force(), -mirrored.force()) << seed;
      ASSERT_GE(one.force() * point, -1e-9) << seed;
      ASSERT_GE(one.hysteretic(), lost - 1e-8) << seed;
      lost = one.hysteretic();
    }
  }
}

TEST(StrutPair, RefusesWhatIsNoBackbone) {
  EXPECT_THROW(StrutPair(0, of_panel), InvalidParameter);
  EXPECT_THROW(StrutPair(stiffness, {.yield = 200, .ultimate = 1.9}), InvalidParameter);
  EXPECT_THROW(StrutPair(stiffness, {.yield = 200, .cap = 1.2}), InvalidParameter);
  EXPECT_FALSE(StrutPair(stiffness, {.yield = 200}).loss({}, 0));
}

}  // namespace
}  // namespace bentur::strut_pair
