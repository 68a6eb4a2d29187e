// What a run measures of its contacts notices an impulse, a state or a stiffness that is not the one it went by.
#include "bentur/solve/engine/run/account/balance.h"

#include <gtest/gtest.h>

#include "bentur/solve/engine/run/pounding_run.h"
#include "tests/support/random_yielding.h"
#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

using namespace bentur::test;

/// A pair that pounds, and the parts of a run of it.
struct Parts {
  explicit Parts(Problem p) : problem(std::move(p)) {
    run.to_end({});
    run.elements().finish(problem.duration);
  }
  static Elements::Scales scales_of(const Problem& problem) {
    return {std::vector<double>(problem.points.size(), 0.1), std::vector<double>(problem.points.size(), 1.0)};
  }
  Problem problem;
  Solver solver = ExactSolver{};
  System given = system_of(problem);
  ModalSystem system{given};
  Elements::Laws laws = laws_of(given, system, given.contacts);
  TimeGrid grid{given, true};
  FlightPlan plan{system, grid, problem.duration, true};
  PoundingRun run{{system, given, laws, solver, grid, plan}, scales_of(problem), 0, {}};
};

Problem pounding() {
  Problem problem = pair(oscillator(1e5, 3e7, 0.03), oscillator(2e5, 1e7, 0.03), {contact(0.002, 1e8)}, 2);
  problem.motion = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.02};
  return problem;
}

TEST(Balance, OfForcesNoticesAnotherMatrix) {
  Parts parts(pounding());
  const auto imbalance = [&parts] {
    return force_imbalance(parts.given, parts.system, parts.run.state(), parts.run.inputs(), parts.run.elements());
  };
  EXPECT_LT(imbalance(), 1e-14);
  parts.given.bodies[1].stiffness *= 1.001;
  EXPECT_GT(imbalance(), 1e-4);
}

TEST(Balance, OfMomentumNoticesAnotherImpulseOrState) {
  Parts parts(pounding());
  ASSERT_GT(parts.run.elements().impacts().size(), 2U);
  EXPECT_GT(parts.run.momentum().worst(), 0.0) << "it has looked";
  EXPECT_LT(parts.run.momentum().worst(), 1e-12);
  // One step of free flight, taken for one of contact: nothing is missing until an impact or a speed is added.
  const State start = parts.run.state();
  Expansion motion(parts.system, parts.laws.offsets);
  Series series(parts.system, parts.laws.offsets);
  ElementForces forces;
  forces.linear.resize(parts.system.elements.size());
  forces.rate = parts.system.rate({});
  const double h = 0.1 / forces.rate;
  State end = start;
  State from = start;
  const std::vector<GroundInput> inputs = parts.run.inputs();
  series.expand(from, inputs, h, forces, motion);
  motion.evaluate(1.0, end);
  Elements elements(parts.system, parts.laws, 0, Parts::scales_of(parts.problem), 1e-12, from);
  const auto worst = [&](const auto& damage) {
    MomentumBalance balance(parts.system);
    State after = end;
    balance.take(motion, 1.0, start, elements, true);
    damage(after);
    balance.changed(after, elements);
    elements.impacts().clear();
    return balance.worst();
  };
  EXPECT_LT(worst([](State&) {}), 1e-13);
  EXPECT_GT(worst([](State& after) { after.v *= 1.001; }), 1e-5);
  EXPECT_GT(worst([&](State&) { elements.impacts().push_back({.impulse = 1e3}); }), 1e-5);
}

TEST(Balance, HoldsForEveryKindOfElement) {
  int looked = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Parts parts(YieldingGenerator(seed).make().problem);
    ASSERT_TRUE(parts.run.trouble().empty()) << seed;
    EXPECT_LT(parts.run.momentum().worst(), 1e-7) << seed;
    looked += parts.run.momentum().worst() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(looked, 40);
}

}  // namespace
}  // namespace bentur::engine
