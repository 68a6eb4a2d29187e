// Frames whose members yield at their ends, in motion: against oscillators that they are, and against themselves.
#include "bentur/elements/hinges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "bentur/structure/damping.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/support.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::hinged_frames {
namespace {

using std::numbers::pi;
using namespace bentur::test;

class HingedFrame : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem, double output_step = 0) const {
    return solved(problem, GetParam().solver, output_step);
  }
  [[nodiscard]] double within(double scale) const { return GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, HingedFrame, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

/// A portal of height 3 and width 5 with E = 1 and one mass; columns have k = 24 EI/h³ together where the beam is
/// stiff.
PlaneFrame portal(double mass, double stiffness, double beam_over_column) {
  const double inertia = stiffness * 27 / 24;
  PlaneFrame frame;
  frame.elastic_modulus = 1;
  frame.storey_heights = {3};
  frame.bay_widths = {5};
  frame.columns = {{.area = 1, .inertia = inertia}};
  frame.beams = {{.area = 1, .inertia = beam_over_column * inertia}};
  frame.floor_masses = {mass};
  frame.mass_matrix = MassMatrix::lumped;
  return frame;
}

/// A bilinear oscillator: four equal hinges at the ends of columns, V_y = 4 M_y/h.
PlaneFrame bilinear_portal(double mass, double stiffness, double yield_force, double hardening = 0) {
  PlaneFrame frame = portal(mass, stiffness, 1e9);
  frame.columns[0].moment_capacity = {yield_force * 3 / 4};
  frame.columns[0].hardening = hardening;
  return frame;
}

Building building_of(const PlaneFrame& frame, double zeta = 0) {
  return make_building("frame", plane_frame_model(frame), ModalDamping{{zeta}});
}

HingeLaw::Record record_of(const Response& response, const Building& building, Eigen::Index hinge) {
  const auto& law = dynamic_cast<const HingeLaw&>(*building.coupled[0].law);
  return law.record(response.coupled.at(0), hinge);
}

double lost(const Response& response, const Building& building) {
  double sum = 0;
  for (Eigen::Index h = 0; h < building.coupled[0].law->size(); ++h) sum += record_of(response, building, h).lost;
  return sum;
}

constexpr double of_beam = 2e-9;  // what a beam 10⁹ times as stiff as the columns still bends

TEST_P(HingedFrame, IsAnOscillatorThatYieldsAfterAPush) {
  const double k = 4 * pi * pi, yield_force = 0.5, yield = yield_force / k;
  for (const auto& [speed, ductility] : {std::pair{2.0, 2.5}, {3.0, 5.0}, {5.0, 13.0}}) {
    const Building building = building_of(bilinear_portal(1, k, yield_force));
    // Until it has come to rest, and not so long that it grazes the other line.
    Problem problem = alone(building, (std::asin(1 / speed) + std::sqrt(speed * speed - 1)) / (2 * pi) + 0.3);
    problem.initial_velocity[0](0) = speed * 2 * pi * yield;
    problem.motion = SampledMotion{0.25, std::vector<double>(8, 0.0)};
    const Response response = run(problem);
    const double slack = within(5 * ductility) + of_beam * ductility;
    EXPECT_NEAR(response.buildings[0].displacement(0) / yield, ductility, slack);
    EXPECT_NEAR(response.buildings[0].storey_shear(0) / yield_force, 1, slack);
    for (Eigen::Index h = 0; h < 4; ++h) {
      const HingeLaw::Record is = record_of(response, building, h);
      EXPECT_NEAR(std::abs(is.rotation) * 3 / yield, ductility - 1, slack);
      EXPECT_EQ(is.peak_rotation, std::abs(is.rotation));
      EXPECT_EQ(is.half_cycles, 1);
      EXPECT_NEAR(*is.first_yield, std::asin(1 / speed) / (2 * pi), slack);
    }
    EXPECT_NEAR(lost(response, building), 0.5 * std::pow(speed * 2 * pi * yield, 2) - 0.5 * yield_force * yield,
                slack * yield_force * yield);
  }
}

TEST_P(HingedFrame, GivesItsSpeedToTheAreaOfABackbone) {
  // Of the oscillator V falls from V_y over h θ_pc; ½ m v² is that area up to where it turns and what is elastic there.
  const double k = 4 * pi * pi, yield_force = 0.5, yield = yield_force / k, speed = 2.5 * 2 * pi * yield, height = 3;
  const double plastic = yield / height, softening = 6 * yield / height;
  PlaneFrame frame = bilinear_portal(1, k, yield_force);
  frame.columns[0].backbone = {.plastic = plastic, .softening = softening, .residual = 0.1};
  const Building building = building_of(frame);
  Problem problem = alone(building, 0.6);
  problem.initial_velocity[0](0) = speed;
  problem.motion = SampledMotion{0.3, std::vector<double>(4, 0.0)};
  const Response response = run(problem);
  for (const BuildingPeaks::Hinge& hinge : response.buildings[0].hinges) {
    const double theta = hinge.peak_rotation, left = 1 - (theta - plastic) / softening;
    ASSERT_GT(left, 0.2) << "softens still";
    ASSERT_LT(left, 0.9);
    const double area = yield_force * height * (plastic + (theta - plastic) * (1 + left) / 2);
    EXPECT_NEAR(area + std::pow(left * yield_force, 2) / (2 * k), 0.5 * speed * speed, within(1) + of_beam);
    EXPECT_NEAR(response.buildings[0].displacement(0), left * yield_force / k + height * theta, within(1) + of_beam);
    EXPECT_NEAR(hinge.strength_left.value(), left, within(10) + of_beam);
    EXPECT_GT(hinge.cap_time.value(), *hinge.first_yield);
    EXPECT_FALSE(hinge.failed_time);
    EXPECT_EQ(hinge.released_energy.value(), 0);
  }
}

TEST_P(HingedFrame, IsTheSameToTheBitWithACapOutOfReach) {
  const auto run_with = [&](double cap) {
    PlaneFrame frame = bilinear_portal(1, 4 * pi * pi, 0.5, 0.05);
    frame.columns[0].backbone.plastic = cap;
    const Building building = building_of(frame, 0.02);
    Problem problem = pair(building, building, {contact(0.001, 1e3)}, 4);
    problem.motion = SampledMotion{0.3, {0, 1, -2, 1.5, -1, 0}};
    return run(problem);
  };
  const Response plain = run_with(std::numeric_limits<double>::infinity()), other = run_with(0.07);
  EXPECT_EQ(plain.steps, other.steps);
  EXPECT_EQ(plain.impacts.size(), other.impacts.size());
  EXPECT_GT(plain.buildings[0].hinges[0].peak_rotation, 0);
  ASSERT_LT(plain.buildings[0].hinges[0].peak_rotation, 0.07);
  for (std::size_t h = 0; h < 4; ++h) {
    const BuildingPeaks::Hinge &one = plain.buildings[0].hinges[h], &same = other.buildings[0].hinges[h];
    EXPECT_EQ(one.peak_rotation, same.peak_rotation);
    EXPECT_EQ(one.dissipated_energy, same.dissipated_energy);
    EXPECT_FALSE(one.strength_left);
    EXPECT_EQ(same.strength_left, 1);
  }
  EXPECT_EQ(plain.buildings[0].displacement, other.buildings[0].displacement);
}

Problem under_a_triangle(double length, double eta, double hardening, double zeta) {
  const Building building = building_of(bilinear_portal(1, 4 * pi * pi, eta, hardening), zeta);
  Problem problem = pair(building, building, {contact(1e3, 1)}, 6);
  problem.motion = SampledMotion{length / 2, {0, -1, 0}};
  return problem;
}

TEST_P(HingedFrame, MeetsTriangularPulses) {
  struct Pulse {
    double length, eta, ductility;
  };
  for (const Pulse& pulse :
       {Pulse{1.2, 0.6, 8.0315276518569}, Pulse{0.3, 0.4, 2.9020939481575}, Pulse{2.0, 0.4, 56.133442220223}}) {
    const Response response = run(under_a_triangle(pulse.length, pulse.eta, 0, 0));
    const double yield = pulse.eta / (4 * pi * pi);
    for (const BuildingPeaks& peaks : response.buildings) {
      EXPECT_NEAR(peaks.displacement(0) / yield, pulse.ductility, within(50) + of_beam * pulse.ductility);
    }
  }
}

TEST_P(HingedFrame, MeetsTriangularPulsesWithHardeningAndDamping) {
  struct Pulse {
    double length, eta, hardening, zeta, ductility, offset, work;
  };
  const Pulse pulses[] = {
      {1.2, 0.6, 0.05, 0.05, 5.3393726573276, 4.0489976329142, 4.3982602976539},
      {0.6, 0.4, 0.10, 0.02, 6.0512575921971, 3.5475342397806, 5.8994828501522},
      {2.0, 0.4, 0.05, 0.05, 19.815452958371, 13.794835426627, 22.644266965609},
  };
  for (const Pulse& pulse : pulses) {
    const double yield = pulse.eta / (4 * pi * pi);
    const Problem problem = under_a_triangle(pulse.length, pulse.eta, pulse.hardening, pulse.zeta);
    const Response response = run(problem);
    const double slack = within(50) + 2 * of_beam * pulse.ductility;
    EXPECT_NEAR(response.buildings[0].displacement(0) / yield, pulse.ductility, slack);
    const double turned = record_of(response, problem.buildings[0], 0).rotation * 3 / yield;
    EXPECT_NEAR(std::abs(turned), (1 - pulse.hardening) * pulse.offset, slack);
    EXPECT_NEAR(lost(response, problem.buildings[0]) / (pulse.eta * yield), pulse.work, slack);
    EXPECT_EQ(record_of(response, problem.buildings[0], 0).half_cycles, 2) << "four events";
  }
}

TEST_P(HingedFrame, OfCantileversIsABilinearStick) {
  // Beams without stiffness: each column is a spring 3EI/h³, which yields at its foot and keeps 2r/(1 + r) of it.
  const double r = 0.06, k = 2 * 3.0 / 27, yield_force = 2 * 0.4 / 3;
  PlaneFrame frame = portal(1, 1, 1);
  frame.columns[0] = {.area = 1, .inertia = 1, .moment_capacity = {0.4}, .hardening = r};
  frame.beams[0].inertia = 1e-30;
  Building left = building_of(frame, 0.05);
  Building right = yielding_oscillator(1, k, yield_force, 2 * r / (1 + r), 0.05);
  Problem problem = pair(left, right, {contact(1e3, 1)}, 60);
  std::vector<double> record(600);
  for (std::size_t n = 0; n < record.size(); ++n) {
    record[n] = 1.2 * std::sin(0.9 * static_cast<double>(n % 77)) + 0.6 * std::sin(0.11 * static_cast<double>(n));
  }
  problem.motion = SampledMotion{0.1, record};
  const Response response = run(problem);
  EXPECT_GT(response.buildings[1].yielding.ductility(0), 1.5);
  EXPECT_NEAR(response.buildings[0].displacement(0), response.buildings[1].displacement(0), within(200));
  EXPECT_NEAR(response.buildings[0].storey_shear(0), response.buildings[1].storey_shear(0), within(200));
  EXPECT_NEAR(response.buildings[0].acceleration(0), response.buildings[1].acceleration(0), within(200));
}

/// Two bays and two storeys of different members, shaken for a while beside a wall.
Problem shaken_beside_a_wall(double capacity, double hardening, double gap) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {3.5, 3};
  frame.bay_widths = {5, 4};
  frame.columns = {{.area = 0.1, .inertia = 2e-3}, {.area = 0.1, .inertia = 1.5e-3}};
  frame.beams = {{.area = 0.1, .inertia = 3e-3}, {.area = 0.1, .inertia = 2e-3}};
  frame.columns[0].moment_capacity = {1.3 * capacity, 1.7 * capacity, 1.2 * capacity};
  frame.columns[1].moment_capacity = {0.8 * capacity, 1.1 * capacity, 0.85 * capacity};
  frame.beams[0].moment_capacity = {0.97 * capacity, 1.21 * capacity};
  frame.beams[1].moment_capacity = {0.71 * capacity};
  for (auto* list : {&frame.columns, &frame.beams}) {
    for (Section& section : *list) section.hardening = hardening;
  }
  frame.floor_masses = {60, 50};
  frame.mass_matrix = MassMatrix::lumped;
  Building building = make_building("frame", plane_frame_model(frame), RayleighDamping{{0.05, 0.05}, {0.4, 0.15}});
  Problem problem = pair(building, wall(), {contact(gap, 4e5, 0), contact(gap, 4e5, 1)}, 8);
  problem.buildings[1] = rigid_building("wall", {3.5, 6.5});
  problem.initial_displacement[1] = problem.initial_velocity[1] = Eigen::VectorXd::Zero(2);
  std::vector<double> record(400);
  for (std::size_t n = 0; n < record.size(); ++n) {
    const double t = 0.02 * static_cast<double>(n);
    record[n] = -6 * std::exp(-0.3 * t) * std::sin(13 * t) - 3 * std::sin(5.1 * t) * std::exp(-0.2 * t);
  }
  problem.motion = SampledMotion{0.02, record};
  return problem;
}

TEST_P(HingedFrame, OutOfReachIsTheElasticFrame) {
  const Problem hinged = shaken_beside_a_wall(1e9, 0, 0.03);
  Problem elastic = hinged;
  elastic.buildings[0].coupled.clear();
  elastic.buildings[0].model.hinges = {};
  const Response one = run(hinged);
  const Response other = run(elastic);
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.buildings[0].displacement, other.buildings[0].displacement);
  EXPECT_EQ(one.buildings[0].acceleration, other.buildings[0].acceleration);
  EXPECT_EQ(one.buildings[0].storey_shear, other.buildings[0].storey_shear);
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  ASSERT_GT(one.impacts.size(), 0U);
  for (std::size_t n = 0; n < one.impacts.size(); ++n) {
    EXPECT_EQ(one.impacts[n].impulse, other.impacts[n].impulse);
  }
}

TEST_P(HingedFrame, ThatYieldsBesideAWallKeepsItsEnergy) {
  for (const double hardening : {0.0, 0.03}) {
    const Problem problem = shaken_beside_a_wall(100, hardening, 0.01);
    const Response response = run(problem);
    EXPECT_GT(response.impacts.size(), 2U);
    EXPECT_GT(lost(response, problem.buildings[0]), 1.0);
    ASSERT_TRUE(response.energy);
    EXPECT_LT(response.energy->relative_residual(),
              std::holds_alternative<ExactSolver>(GetParam().solver) ? 1e-12 : 1e-9);
  }
}

TEST(HingedFrames, GiveTheSameBySeriesAndByRungeKuttaPairs) {
  for (const double hardening : {0.0, 0.03}) {
    for (const double gap : {0.01, 10.0}) {
      const Problem problem = shaken_beside_a_wall(100, hardening, gap);
      const Response exact = solved(problem, ExactSolver{});
      const Response adaptive = solved(problem, AdaptiveSolver{1e-12});
      EXPECT_EQ(exact.impacts.size(), adaptive.impacts.size());
      const auto difference = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
        return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
      };
      EXPECT_LT(difference(exact.buildings[0].displacement, adaptive.buildings[0].displacement), 1e-8);
      EXPECT_LT(difference(exact.buildings[0].storey_shear, adaptive.buildings[0].storey_shear), 1e-8);
      for (Eigen::Index h = 0; h < problem.buildings[0].coupled[0].law->size(); ++h) {
        const HingeLaw::Record one = record_of(exact, problem.buildings[0], h);
        const HingeLaw::Record other = record_of(adaptive, problem.buildings[0], h);
        EXPECT_NEAR(one.peak_rotation, other.peak_rotation, 1e-9) << h;
        EXPECT_EQ(one.first_yield.has_value(), other.first_yield.has_value()) << h;
      }
    }
  }
}

Building frame_by_chance(std::mt19937& random) {
  const auto number = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.bay_widths = {number(4, 6), number(4, 6)};
  for (int storey = 0; storey < 3; ++storey) {
    frame.storey_heights.push_back(3);
    const double hardening = number(0.01, 0.1);
    frame.columns.push_back({.area = 0.1, .inertia = number(1e-3, 3e-3), .hardening = hardening});
    frame.columns.back().moment_capacity = {number(60, 140)};
    frame.beams.push_back({.area = 0.1, .inertia = number(1e-3, 4e-3), .hardening = hardening});
    frame.beams.back().moment_capacity = {number(60, 140)};
    frame.floor_masses.push_back(number(20, 60));
  }
  return make_building("frame", plane_frame_model(frame), MassProportionalDamping{0.05});
}

/// Of each nothing is looked for again when a hinge of the other changes; beside a wall steps are cut at its own
/// changes alone.
TEST(HingedFrames, FarApartMoveAsEachDoesAlone) {
  constexpr double agreed = 1e-9;  // of the largest: round-off of other steps, after up to some hundred events
  int yielded = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::array frames{frame_by_chance(random), frame_by_chance(random)};
    SampledMotion motion{0.02, {}};
    const double one = std::uniform_real_distribution(4.0, 14.0)(random), other = 1.7 * one;
    for (int n = 0; n < 300; ++n) {
      const double t = 0.02 * n;
      motion.acceleration.push_back(6 * (std::sin(one * t) + 0.6 * std::sin(other * t + 1)) * std::exp(-0.2 * t));
    }
    const auto run = [&](const Building& left, const Building& right) {
      Problem problem = pair(left, right, {contact(10, 1e5)}, 6);
      problem.motion = motion;
      return solve(problem);
    };
    const Response both = run(frames[0], frames[1]);
    ASSERT_EQ(both.status, Status::done) << both.message;
    for (std::size_t b = 0; b < 2; ++b) {
      const Response alone = run(frames[b], rigid_building("wall", {3, 6, 9}));
      const BuildingPeaks &found = both.buildings[b], &expected = alone.buildings[0];
      const double moved = expected.displacement.maxCoeff();
      EXPECT_LE((found.displacement - expected.displacement).cwiseAbs().maxCoeff(), agreed * moved);
      ASSERT_EQ(found.hinges.size(), expected.hinges.size());
      double turned = 0, lost = 0;
      for (const BuildingPeaks::Hinge& hinge : expected.hinges) {
        turned = std::max(turned, hinge.peak_rotation);
        lost = std::max(lost, hinge.dissipated_energy);
      }
      for (std::size_t h = 0; h < found.hinges.size(); ++h) {
        EXPECT_NEAR(found.hinges[h].residual_rotation, expected.hinges[h].residual_rotation, agreed * turned);
        EXPECT_NEAR(found.hinges[h].dissipated_energy, expected.hinges[h].dissipated_energy, agreed * lost);
        EXPECT_EQ(found.hinges[h].half_cycles, expected.hinges[h].half_cycles);
        yielded += found.hinges[h].half_cycles;
      }
    }
  }
  EXPECT_GT(yielded, 1000);
}

}  // namespace
}  // namespace bentur::hinged_frames
