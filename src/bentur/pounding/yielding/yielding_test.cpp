// Storeys that yield against responses that are known in closed form. Numbers that are not formulas were computed once
// with 40 digits, by the solutions of the linear pieces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bentur/contact/laws/restitution.h"
#include "bentur/elements/peak_oriented.h"
#include "bentur/structure/stick.h"
#include "bentur/structure/support.h"
#include "tests/support/free_masses.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::yielding_storey {
namespace {

using std::numbers::pi;
using namespace bentur::test;

class YieldingStorey : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem, double output_step = 0) const {
    return solved(problem, GetParam().solver, output_step);
  }
  /// Of a number of the size `scale`.
  [[nodiscard]] double within(double scale) const { return GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, YieldingStorey, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

constexpr double mass = 3, stiffness = 1200, omega = 20;
constexpr double yield_force = 60, yield = yield_force / stiffness;

TEST_P(YieldingStorey, StopsWhereItsSpeedHasBeenUsedUp) {
  // ½ m v² = ½ V_y Δ_y + V_y (Δ − Δ_y). Then it swings about its offset by Δ_y and touches the yield line once a
  // period, which is no yielding.
  for (const double v : {2.0, 3.0, 5.0}) {
    for (const double sense : {1.0, -1.0}) {
      Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force), 20);
      problem.initial_velocity[0](0) = sense * v * omega * yield;
      const double ductility = 0.5 * (1 + v * v);
      const Response response = run(problem);
      const BuildingPeaks& peaks = response.buildings[0];
      ASSERT_EQ(peaks.yielding.ductility.size(), 1);
      EXPECT_NEAR(peaks.yielding.ductility(0), ductility, within(ductility));
      EXPECT_NEAR(peaks.displacement(0), ductility * yield, within(ductility * yield));
      EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), sense * (ductility - 1) * yield, within(ductility * yield));
      EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), yield_force * (ductility - 1) * yield,
                  within(yield_force * ductility * yield));
      EXPECT_NEAR(peaks.storey_shear(0), yield_force, within(yield_force));
      EXPECT_NEAR(peaks.yielding_no_contact.ductility(0), ductility, within(ductility));
      EXPECT_EQ(response.buildings[1].yielding.ductility.size(), 0);
    }
  }
}

TEST_P(YieldingStorey, YieldsAtAnInstantOfTheRecord) {
  // As before; the record, which is still, has a sample at the instant of yielding.
  const double v = 3, instant = std::asin(1 / v) / omega;
  Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force), 2);
  problem.initial_velocity[0](0) = v * omega * yield;
  problem.motion = SampledMotion{instant, std::vector<double>(200, 0.0)};
  const Response response = run(problem);
  EXPECT_NEAR(response.buildings[0].yielding.ductility(0), 5, within(5));
  EXPECT_NEAR(response.buildings[0].yielding.residual_drift_ratio(0), 4 * yield, within(5 * yield));
}

TEST_P(YieldingStorey, MeetsASuddenSteadyLoad) {
  // [Biggs1964]: F Δ = V_y (Δ − ½ Δ_y).
  for (const double load : {0.55, 0.7, 0.9, 0.99}) {
    Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force), 12);
    problem.motion = SampledMotion{0.25, std::vector<double>(60, -load * yield_force / mass)};
    const double ductility = 0.5 / (1 - load);
    const Response response = run(problem);
    EXPECT_NEAR(response.buildings[0].yielding.ductility(0), ductility, within(10 * ductility)) << load;
    EXPECT_NEAR(response.buildings[0].yielding.residual_drift_ratio(0), (ductility - 1) * yield,
                within(10 * ductility * yield));
  }
}

/// Two alike and far apart, which yield at the same instants: T = 1 s, and a pulse of that length like a triangle.
Problem under_a_triangle(double length, double eta, double hardening, double zeta, double duration) {
  const double k = 4 * pi * pi;
  const Building building = yielding_oscillator(1, k, eta, hardening, zeta);
  Problem problem = pair(building, building, {contact(1e3, 1)}, duration);
  problem.motion = SampledMotion{length / 2, {0, -1, 0}};
  return problem;
}

TEST_P(YieldingStorey, MeetsTriangularPulses) {
  struct Pulse {
    double length;
    double ductility[3];  // at V_y = 0.4, 0.6, 0.8 of the peak load
  };
  const Pulse pulses[] = {{0.3, {2.9020939481575, 1.562846140237, 1.0977984953509}},
                          {0.6, {8.2022889222241, 3.5945282126787, 2.1242106097448}},
                          {1.2, {24.342975873693, 8.0315276518569, 3.3824233674651}},
                          {2.0, {56.133442220223, 13.798205934714, 3.0314827566726}}};
  for (const Pulse& pulse : pulses) {
    for (int i = 0; i < 3; ++i) {
      const double eta = 0.4 + 0.2 * i, dy = eta / (4 * pi * pi), ductility = pulse.ductility[i];
      const Response response = run(under_a_triangle(pulse.length, eta, 0, 0, 6));
      for (const BuildingPeaks& peaks : response.buildings) {
        // The last digit of the table, and for each event a little more than a step's error.
        EXPECT_NEAR(peaks.yielding.ductility(0), ductility, within(5 * ductility)) << pulse.length << ' ' << eta;
        EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), (ductility - 1) * dy, within(5 * ductility * dy));
      }
    }
  }
}

TEST_P(YieldingStorey, MeetsTriangularPulsesWithHardeningAndDamping) {
  // Four events each. The slider's offset s is that of (1 − r) k alone: it comes to rest at (1 − r) s.
  struct Pulse {
    double length, eta, hardening, zeta, ductility, offset, work;
  };
  const Pulse pulses[] = {
      {1.2, 0.6, 0.05, 0.05, 5.3393726573276, 4.0489976329142, 4.3982602976539},
      {0.6, 0.4, 0.10, 0.02, 6.0512575921971, 3.5475342397806, 5.8994828501522},
      {2.0, 0.4, 0.05, 0.05, 19.815452958371, 13.794835426627, 22.644266965609},
  };
  for (const Pulse& pulse : pulses) {
    const double dy = pulse.eta / (4 * pi * pi);
    const Response response = run(under_a_triangle(pulse.length, pulse.eta, pulse.hardening, pulse.zeta, 6));
    const BuildingPeaks::Yielding& is = response.buildings[0].yielding;
    EXPECT_NEAR(is.ductility(0), pulse.ductility, within(5 * pulse.ductility));
    EXPECT_NEAR(is.residual_drift_ratio(0), (1 - pulse.hardening) * pulse.offset * dy,
                within(5 * pulse.ductility * dy));
    EXPECT_NEAR(is.hysteretic_energy(0), pulse.work * pulse.eta * dy, within(5 * pulse.work * pulse.eta * dy));
  }
}

/// Free decay against the friction Q from the turning point x₀ > 0: ½ K (x₀² − x₁²) = Q (x₀ + x₁ − 2 Δ_y).
double next_turn(double x, double friction, double spring, double dy) {
  const double b = friction / spring;
  return -b + std::sqrt(b * b + x * x - 2 * b * x + 4 * b * dy);
}

TEST_P(YieldingStorey, SlowsDownAgainstFriction) {
  // r k = K: a spring K and a slider Q beside it. From 10.5 Q/K towards −8.5, 6.5, −4.5, 2.5, −0.5 as k → ∞; the start
  // is beyond yield, so that its work counts. From a turning point x ≤ Δ_y on its side it does not reach the other
  // line.
  const double spring = 40, friction = 2, m = 1.3;
  for (const double k : {4e3, 4e6}) {
    const double r = spring / k, dy = friction / (1 - r) / k, start = 10.5 * friction / spring;
    double turn = start, slid = start - dy, side = 1;
    for (int i = 0; turn > dy; ++i) {
      const double next = next_turn(turn, friction, spring, dy);
      slid += turn + next - 2 * dy;
      turn = next;
      side = -side;
      if (i == 4) {
        EXPECT_NEAR(side * turn, -0.5 * friction / spring, 100 * dy);
      }
    }
    Problem problem = alone(yielding_oscillator(m, k, friction / (1 - r), r), 8 * pi * std::sqrt(m / spring));
    problem.initial_displacement[0](0) = start;
    const Response response = run(problem);
    const BuildingPeaks& peaks = response.buildings[0];
    const double loss = k / spring;  // of digits: V is a small difference of k x and k p
    EXPECT_NEAR(peaks.displacement(0), start, within(start));
    EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), side * ((1 - r) * turn - friction / k), within(loss * start))
        << k;
    EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), friction * slid, within(loss * friction * slid)) << k;
  }
}

TEST_P(YieldingStorey, CountsAStartBeyondYieldAsLoadedOneWay) {
  for (const double r : {0.0, 0.2}) {
    for (const double sense : {1.0, -1.0}) {
      const double start = 3 * yield, shear = yield_force * (1 + 2 * r);
      Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force, r), 3);
      problem.initial_displacement[0](0) = sense * start;
      const Response response = run(problem, 0.5);
      const BuildingPeaks& peaks = response.buildings[0];
      EXPECT_NEAR(peaks.displacement(0), start, within(start));
      EXPECT_NEAR(peaks.storey_shear(0), shear, within(shear));
      EXPECT_NEAR(response.energy->histories.hysteretic(0), yield_force * (1 - r) * 2 * yield,
                  within(10 * yield_force * yield));
      const double loading = yield_force * yield * (0.5 + 2 + 2 * r);
      EXPECT_NEAR(response.energy->histories.input(0), loading, within(10 * loading));
      if (r > 0) continue;  // it yields on the way back
      EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), sense * 2 * yield, within(10 * start));
      EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), yield_force * 2 * yield, within(10 * yield_force * yield));
    }
  }
}

TEST_P(YieldingStorey, StartsOnTheYieldLineAtRest) {
  // Exactly at Δ_y: it touches the line and yields nothing, with both hystereses.
  Problem problem = alone(yielding_oscillator(mass, stiffness, yield_force), 10);
  problem.initial_displacement[0](0) = yield;
  for (int kind = 0; kind < 2; ++kind) {
    if (kind == 1)
      problem.buildings[0].elements[0].law = std::make_shared<PeakOriented>(stiffness, yield_force, 0, 0.4);
    const Response response = run(problem);
    EXPECT_NEAR(response.buildings[0].yielding.ductility(0), 1, within(10));
    EXPECT_NEAR(response.buildings[0].yielding.residual_drift_ratio(0), 0, within(100 * yield));
    EXPECT_NEAR(response.buildings[0].yielding.hysteretic_energy(0), 0, within(100 * yield_force * yield));
  }
}

TEST_P(YieldingStorey, YieldsAtTheInstantOfContact) {
  // It reaches Δ_y and a free mass at once, with the speed u. In contact δ̈ = −k_c δ/μ − V_y/m₁, from δ̇ = u:
  // a spring pressed by the steady force V_y μ/m₁ from the other side.
  const double other = 1, spring = 5e4, v = 4 * omega * yield;
  const double u = std::sqrt(v * v - omega * omega * yield * yield);
  const double reduced = mass * other / (mass + other), rate = std::sqrt(spring / reduced);
  const double d = yield_force * reduced / (mass * spring);  // δ = −d + …
  const double peak = spring * (std::hypot(d, u / rate) - d), length = 2 * (pi / 2 - std::atan2(d * rate, u)) / rate;
  Problem problem = pair(yielding_oscillator(mass, stiffness, yield_force), oscillator(other, 0),
                         {contact(yield, spring)}, std::asin(0.25) / omega + 1.2 * length);
  problem.initial_velocity[0](0) = v;
  const Response response = run(problem);
  ASSERT_EQ(response.impacts.size(), 1u);
  const Impact& impact = response.impacts[0];
  EXPECT_NEAR(impact.start, std::asin(0.25) / omega, within(1));
  EXPECT_NEAR(impact.closing_speed, u, within(10 * u));
  EXPECT_NEAR(impact.peak_force, peak, within(10 * peak));
  EXPECT_NEAR(impact.end - impact.start, length, within(10));
  EXPECT_NEAR(impact.separation_speed, u, within(10 * u));  // the steady force does no work over the whole contact
  EXPECT_NEAR(response.buildings[0].storey_shear(0), yield_force, within(yield_force));
}

TEST_P(YieldingStorey, UnloadsThroughAnImpulse) {
  // It yields, meets a wall that turns its speed u into −e u, and yields the other way; then it swings by Δ_y about
  // where it has come to, and each time just touches the yield line.
  const double v = 4 * omega * yield, width = 2.5 * yield, e = 0.6;
  const double u = std::sqrt(v * v - omega * omega * yield * yield - 2 * yield_force * (width - yield) / mass);
  const double back = mass * e * e * u * u / (2 * yield_force);  // slip the other way
  const double residual = width - yield - back;
  Problem problem = pair(yielding_oscillator(mass, stiffness, yield_force), wall(),
                         {contact(width, std::make_shared<Restitution>(e))}, 4);
  problem.initial_velocity[0](0) = v;
  const Response response = run(problem);
  ASSERT_EQ(response.impacts.size(), 1u);
  EXPECT_NEAR(response.impacts[0].closing_speed, u, within(10 * u));
  const BuildingPeaks& peaks = response.buildings[0];
  EXPECT_NEAR(peaks.yielding.residual_drift_ratio(0), residual, within(10 * width));
  EXPECT_NEAR(peaks.yielding.hysteretic_energy(0), yield_force * (width - yield + back),
              within(10 * yield_force * width));
  EXPECT_NEAR(peaks.storey_shear(0), yield_force, within(yield_force));
  const double free_ductility = 0.5 * (1 + 16);
  EXPECT_NEAR(peaks.yielding_no_contact.ductility(0), free_ductility, within(free_ductility));
}

TEST_P(YieldingStorey, FollowsThePeakOrientedRules) {
  // Free motion without damping, turning points from the energy: to Δ₁ on the backbone, back along k_u to Δ₀, and on
  // towards −(Δ_y, V_y).
  const double r = 0.1, a = 0.2, speed = 1.5, v = speed * omega * yield;
  const auto v_of = [&](double mu) { return yield_force * (1 - r + r * mu); };
  // ½ m v² = ½ V_y Δ_y + V_y s + ½ r k s², s = Δ₁ − Δ_y.
  const double rest = 0.5 * mass * v * v - 0.5 * yield_force * yield, rk = r * stiffness;
  const double slip = (-yield_force + std::sqrt(yield_force * yield_force + 2 * rk * rest)) / rk;
  const double mu = 1 + slip / yield, back = std::max(stiffness * std::pow(mu, -a), v_of(mu) / (mu * yield));
  const double zero = mu * yield - v_of(mu) / back, given = 0.5 * v_of(mu) * v_of(mu) / back;
  // On the way to −Δ_y it takes ½ V_y (Δ₀ + Δ_y) > what it has: it turns at V = −√(2 s given), s the slope.
  const double slope = yield_force / (zero + yield), turn = std::sqrt(2 * given / slope);
  ASSERT_LT(slope * turn, yield_force);
  // Below, k_u is k: at −Δ_y, the extreme of that side.
  const double second_zero = zero - turn + slope * turn / stiffness;
  const double quarters = pi * std::sqrt(mass / back) / 2 + pi * std::sqrt(mass / slope) / 2;
  const double first = std::asin(1 / speed) / omega;
  const double u = std::sqrt(v * v - omega * omega * yield * yield), plastic_omega = omega * std::sqrt(r);
  const double second = std::atan2(u * plastic_omega, yield_force / mass) / plastic_omega;
  // The end: within the unloading below.
  Problem problem =
      alone(yielding_oscillator(mass, stiffness, yield_force, r), first + second + quarters + 0.2 * pi / omega);
  problem.buildings[0].elements[0].law = std::make_shared<PeakOriented>(stiffness, yield_force, r, a);
  problem.initial_velocity[0](0) = v;
  const Response response = run(problem);
  const BuildingPeaks::Yielding& is = response.buildings[0].yielding;
  EXPECT_NEAR(is.ductility(0), mu, within(10 * mu));
  EXPECT_NEAR(is.residual_drift_ratio(0), second_zero, within(10 * mu * yield));
  const double work = 0.5 * mass * v * v, kept = 0.5 * slope * slope * turn * turn / stiffness;
  EXPECT_NEAR(is.hysteretic_energy(0), work - kept, within(10 * work));
}

/// Damping that follows the stiffness of storeys does so of the structure's alone: bearings below have no part of it to
/// lose. Where no storey comes to yield nothing follows anything.
TEST(YieldingBearings, LoseNoDampingThatTheyNeverHad) {
  const auto run = [](double tangent) {
    const StructuralModel model =
        stick_model({.storey_heights = {3, 3}, .masses = {20, 15}, .stiffnesses = {9e3, 7e3}});
    const Support support{.isolation = Isolation{.mass = 25, .bearings = bilinear_bearings(400, 30, 0.005)}};
    Building building = make_building("A", model, StiffnessProportionalDamping{0.004}, support,
                                      {bilinear_law(9e3, 1e6), bilinear_law(7e3, 1e6)});
    building.tangent_damping = tangent;
    Problem problem = alone(std::move(building), 8);
    problem.motion = HarmonicMotion{.period = 0.7, .displacement_amplitude = 0.05};
    return solve(problem);
  };
  const Response follows = run(0.004), stays = run(0);
  const BuildingPeaks &a = follows.buildings[0], &b = stays.buildings[0];
  ASSERT_GT(b.yielding.ductility(0), 5);
  ASSERT_LT(b.yielding.ductility(1), 1);
  EXPECT_EQ(a.displacement, b.displacement);
  EXPECT_EQ(a.storey_shear, b.storey_shear);
  EXPECT_EQ(a.yielding.hysteretic_energy, b.yielding.hysteretic_energy);
}

}  // namespace
}  // namespace bentur::yielding_storey
