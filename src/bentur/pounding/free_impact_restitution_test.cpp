// The restitution asked for is the restitution obtained, through the exact solver; and the drop tests of theory 3.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>

#include "bentur/contact/laws.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"
#include "tests/support/restitution_laws.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// The law, with the stiffness where it takes one.
std::shared_ptr<const ContactLaw> make(const Asked& asked, double stiffness, double restitution, double mass) {
  LawInput input{{{"restitution", restitution}}, asked.words, mass};
  const auto is_stiffness = [](const Key& key) { return key.name == "stiffness"; };
  if (std::any_of(asked.law->keys.begin(), asked.law->keys.end(), is_stiffness)) input.numbers["stiffness"] = stiffness;
  return asked.law->make(input);
}

class RestitutionThroughExact : public testing::TestWithParam<Asked> {};

TEST_P(RestitutionThroughExact, IsTheOneAskedFor) {
  // A contact is not deeper known than the round-off band of displacements: the shallowest here goes 2e-6 deep at
  // displacements of 0.01, of which the band is 2⁻⁴⁶ (6e-11 of that depth).
  constexpr double limit = 1e-9;
  for (const auto& [left, right] : {std::pair{2e5, 6e4}, {30.0, 5e3}}) {
    const double effective = left * right / (left + right);
    for (const double stiffness : {3e5, 2e9}) {
      for (const double e : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
        const auto law = make(GetParam(), stiffness, e, effective);
        for (const double speed : {0.02, 0.4937, 6.0}) {
          // The softest contact here, Hertz's at the lowest speed, lasts 2.94 δ_max/v₀, with damping a few times that.
          const double width = 0.01;
          const double depth = std::max(std::pow(5 * effective * speed * speed / (4 * stiffness), 0.4),
                                        speed * std::sqrt(effective / stiffness));
          const Problem problem = free_masses(left, right, width, speed, law, (width + 30 * depth) / speed);
          const Response response = solve(problem);
          ASSERT_EQ(response.impacts.size(), 1u) << e << " " << speed;
          const Impact& impact = response.impacts[0];
          ASSERT_FALSE(impact.open_ended) << e << " " << speed;
          EXPECT_NEAR(impact.closing_speed / speed, 1, 1e-13);
          EXPECT_NEAR(*impact.restitution(), e, limit) << left << " " << stiffness << " " << speed;
          const double energy = 0.5 * effective * speed * speed;
          EXPECT_NEAR(impact.energy_lost / energy, 1 - e * e, limit) << left << " " << e << " " << speed;
          EXPECT_NEAR(impact.impulse / (effective * speed), 1 + e, limit) << left << " " << e << " " << speed;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RestitutionThroughExact, testing::ValuesIn(laws_with_a_restitution()),
                         [](const auto& one) { return one.param.label; });

/// Theory 3: 1e5 kg at 0.4937 m/s against a rigid stop; the figures are those of another program, given to so many
/// digits as its step of 1e-4 s leaves.
struct Drop {
  std::string label, law;
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words;
  double restitution = 1, peak = 0, tension = 0;
};

void PrintTo(const Drop& drop, std::ostream* out) { *out << drop.label; }

class DropTest : public testing::TestWithParam<Drop> {};

TEST_P(DropTest, AgreesWithTheOtherProgram) {
  const Drop& drop = GetParam();
  const double mass = 1e5, speed = 0.4937;
  const auto law = find_law(drop.law)->make({drop.numbers, drop.words, mass});
  Problem problem = pair(oscillator(mass, 0), wall(), {contact(0.01, law)}, 0.5);
  problem.initial_velocity[0](0) = speed;
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{}), Solver(RungeKuttaSolver{1e-4})}) {
    const Response response = solve(problem, solver);
    ASSERT_EQ(response.impacts.size(), 1u);
    const Impact& impact = response.impacts[0];
    EXPECT_NEAR(*impact.restitution(), drop.restitution, 1e-3) << name(solver);
    EXPECT_NEAR(impact.peak_force / drop.peak, 1, 1e-3) << name(solver);
    if (drop.tension > 0) {
      // It is c e v₀, at the very end, where the force changes by k e v₀ a second: 1 % in a step of the other program.
      const double damping = 2 * drop.numbers.at("damping_ratio") * std::sqrt(drop.numbers.at("stiffness") * mass);
      EXPECT_NEAR(impact.peak_tension / (damping * impact.separation_speed), 1, 1e-9) << name(solver);
      EXPECT_NEAR(impact.peak_tension / drop.tension, 1, 1e-2) << name(solver);
    } else {
      EXPECT_EQ(impact.peak_tension, 0) << name(solver);
    }
  }
}

const double mass_and_spring_peak = 0.4937 * std::sqrt(1e8 * 1e5);  // v₀ √(k m), in closed form

INSTANTIATE_TEST_SUITE_P(
    , DropTest,
    testing::Values(
        Drop{"hertz_damp", "hertz-damp", {{"stiffness", 2e9}, {"damping_factor", 0.8615}}, {}, 0.6303, 2.330e6},
        Drop{"jankowski", "jankowski", {{"stiffness", 2e9}, {"damping_ratio", 0.3682}}, {}, 0.6499, 1.847e6},
        Drop{"kelvin_voigt",
             "kelvin-voigt",
             {{"stiffness", 1e8}, {"damping_ratio", 0.1359}},
             {{"release", "separation"}},
             0.650,
             1.331e6,
             0.275e6},
        Drop{"linear", "linear", {{"stiffness", 1e8}}, {}, 1, mass_and_spring_peak}),
    [](const auto& one) { return one.param.label; });

}  // namespace
}  // namespace bentur
