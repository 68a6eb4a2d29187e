// Links between buildings against closed forms, and against buildings that have the same springs of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "bentur/contact/laws/restitution.h"
#include "bentur/elements/link_laws.h"
#include "bentur/elements/peak_oriented.h"
#include "tests/support/free_masses.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::linked_buildings {
namespace {

using std::numbers::pi;
using namespace bentur::test;

class LinkedBuildings : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem, double output_step = 0) const {
    return solved(problem, GetParam().solver, output_step);
  }
  [[nodiscard]] double within(double scale) const { return GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, LinkedBuildings, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

Link link(std::shared_ptr<const Law> law, Eigen::Index left = 0, Eigen::Index right = 1) {
  Link result;
  result.left = left;
  result.right = right;
  result.elevation = 1;
  result.law = std::move(law);
  return result;
}

/// Two masses without springs, far apart, the left one moving, joined by a link.
Problem linked_masses(double left, double right, double speed, std::shared_ptr<const Law> law, double duration) {
  Problem problem = free_masses(left, right, 1e3, speed, std::make_shared<Linear>(1.0), duration);
  problem.links = {link(std::move(law))};
  return problem;
}

constexpr double left_mass = 2, right_mass = 5, reduced = left_mass * right_mass / (left_mass + right_mass);
constexpr double speed = 3;

/// The centre of mass goes on steadily: momentum, and x_left, x_right from their difference δ.
void expect_positions(const Response& response, Eigen::Index sample, double difference, double tolerance) {
  const double centre = left_mass * speed / (left_mass + right_mass) * response.histories.time[sample];
  EXPECT_NEAR(response.histories.displacement[0](0, sample),
              centre + right_mass / (left_mass + right_mass) * difference, tolerance);
  EXPECT_NEAR(response.histories.displacement[1](0, sample), centre - left_mass / (left_mass + right_mass) * difference,
              tolerance);
}

TEST_P(LinkedBuildings, SwingAgainstEachOtherOnASpring) {
  const double k = 700, omega = std::sqrt(k / reduced);
  const Response response =
      run(linked_masses(left_mass, right_mass, speed, std::make_shared<SpringDashpot>(k, 0), 2), 0.05);
  for (Eigen::Index i = 0; i < std::ssize(response.histories.time); ++i) {
    expect_positions(response, i, speed / omega * std::sin(omega * response.histories.time[i]), within(10 * speed));
  }
  ASSERT_EQ(response.links.size(), 1u);
  const LinkSummary& is = response.links[0];
  EXPECT_NEAR(is.peak_closing, speed / omega, within(speed));
  EXPECT_NEAR(is.peak_opening, speed / omega, within(speed));
  EXPECT_NEAR(is.peak_compression, k * speed / omega, within(k * speed));
  EXPECT_NEAR(is.peak_tension, k * speed / omega, within(k * speed));
  EXPECT_NEAR(is.energy_dissipated, 0, within(10 * speed * speed));
}

TEST_P(LinkedBuildings, ComeTogetherThroughADashpot) {
  const double c = 6, rate = c / reduced;
  const Response response =
      run(linked_masses(left_mass, right_mass, speed, std::make_shared<SpringDashpot>(0, c), 2), 0.05);
  for (Eigen::Index i = 0; i < std::ssize(response.histories.time); ++i) {
    expect_positions(response, i, -speed / rate * std::expm1(-rate * response.histories.time[i]), within(10 * speed));
  }
  const LinkSummary& is = response.links[0];
  EXPECT_NEAR(is.peak_compression, c * speed, within(c * speed));
  EXPECT_NEAR(is.peak_tension, 0, within(c * speed));
  EXPECT_NEAR(is.energy_dissipated, -0.5 * reduced * speed * speed * std::expm1(-2 * rate * 2),
              within(10 * speed * speed));
  const Eigen::Index last = response.energy->histories.damping.size() - 1;
  EXPECT_NEAR(response.energy->histories.damping(last), is.energy_dissipated, within(10 * speed * speed));
}

/// Masses that touch at the start part at once with the speed times the coefficient of restitution.
TEST_P(LinkedBuildings, CarryWhatTheyCarryBeforeTheFirstImpact) {
  const double c = 6, restitution = 0.3;
  Problem problem = free_masses(left_mass, right_mass, 0, speed, std::make_shared<Restitution>(restitution), 2);
  problem.links = {link(std::make_shared<SpringDashpot>(0, c))};
  const Response response = run(problem, 0.05);
  ASSERT_EQ(response.impacts.size(), 1u);
  const LinkSummary& is = response.links[0];
  EXPECT_NEAR(is.peak_compression, c * speed, within(c * speed));
  EXPECT_NEAR(is.peak_tension, c * restitution * speed, within(c * speed));
}

TEST_P(LinkedBuildings, SwingAgainstEachOtherOnADampedSpring) {
  const double k = 700, zeta = 0.1, omega = std::sqrt(k / reduced), damped = omega * std::sqrt(1 - zeta * zeta);
  const double c = 2 * zeta * omega * reduced;
  const Response response =
      run(linked_masses(left_mass, right_mass, speed, std::make_shared<SpringDashpot>(k, c), 2), 0.05);
  for (Eigen::Index i = 0; i < std::ssize(response.histories.time); ++i) {
    const double t = response.histories.time[i];
    expect_positions(response, i, speed / damped * std::exp(-zeta * omega * t) * std::sin(damped * t),
                     within(10 * speed));
  }
}

TEST_P(LinkedBuildings, AreHeldByACableOnceItIsTaut) {
  const double k = 900, slack = 0.3, omega = std::sqrt(k / reduced);
  const Response response = run(linked_masses(left_mass, right_mass, -speed, std::make_shared<Cable>(k, slack), 0.5));
  const LinkSummary& is = response.links[0];
  EXPECT_NEAR(is.peak_opening, slack + speed / omega, within(speed));
  EXPECT_NEAR(is.peak_tension, k * speed / omega, within(k * speed));
  EXPECT_EQ(is.peak_compression, 0) << "a cable never pushes";
  EXPECT_NEAR(is.energy_dissipated, 0, within(10 * speed * speed));
  const double back = 0.5 - slack / speed - pi / omega;  // slack again, at the speed it came with
  EXPECT_NEAR(is.peak_closing, speed * back - slack, within(10 * speed));
}

TEST_P(LinkedBuildings, StopALinkThatYields) {
  // ½ μ v² = F_y (D − ½ Δ_y), then it swings by Δ_y.
  const double k = 800, force = 12, dy = force / k, d = 0.5 * reduced * speed * speed / force + 0.5 * dy;
  for (const double sense : {1.0, -1.0}) {
    Problem problem = linked_masses(left_mass, right_mass, sense * speed, bilinear_law(k, force), 5);
    const Response response = run(problem, 0.5);
    const LinkSummary& is = response.links[0];
    EXPECT_NEAR(sense > 0 ? is.peak_closing : is.peak_opening, d, within(d));
    EXPECT_NEAR(is.peak_compression, force, within(force));
    EXPECT_NEAR(is.peak_tension, force, within(force));
    EXPECT_NEAR(is.energy_dissipated, force * (d - dy), within(10 * force * d));
    const Eigen::Index last = response.energy->histories.hysteretic.size() - 1;
    EXPECT_NEAR(response.energy->histories.hysteretic(last), force * (d - dy), within(10 * force * d));
    for (Eigen::Index i = 0; i < response.histories.displacement[0].cols(); ++i) {
      const double momentum =
          left_mass * response.histories.velocity[0](0, i) + right_mass * response.histories.velocity[1](0, i);
      EXPECT_NEAR(momentum, sense * left_mass * speed, within(100 * left_mass * speed));
    }
  }
}

SampledMotion shaking() {
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 120; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  return motion;
}

/// An oscillator between a wall on its left, to which it is linked, and one on its right that it runs into.
Problem between_walls(Building building, std::vector<Link> links) {
  Problem problem = pair(wall(), std::move(building), {contact(1e3, 1)}, 3);
  problem.buildings.push_back(wall());
  problem.points.push_back(contact(0.02, 2e5, 0, 1));
  problem.initial_displacement.clear();
  problem.initial_velocity.clear();
  problem.links = std::move(links);
  problem.motion = shaking();
  problem.delays = {1e3, 0, 1e3};
  return problem;
}

TEST_P(LinkedBuildings, AreTheSameAsBuildingsWithThatSpring) {
  // δ = x_wall − x: to the left as much as the storey to the right, and all laws here are the same both ways.
  const double m = 3, k = 1200, c = 5;
  const auto law = [&](int kind) -> std::shared_ptr<const HystereticLaw> {
    if (kind == 0) return bilinear_law(k, 8, 0.1);
    return std::make_shared<PeakOriented>(k, 8, 0.1, 0.4);
  };
  for (int kind = 0; kind < 3; ++kind) {
    const bool yields = kind < 2;
    const Building own = yields ? yielding_stick({{m, k, c, law(kind)}}) : yielding_stick({{m, k, c}});
    const std::shared_ptr<const Law> spring =
        yields ? std::shared_ptr<const Law>(law(kind)) : std::make_shared<SpringDashpot>(k, c);
    Building free = oscillator(m, 0);
    if (yields) free.modal_damping(0, 0) = c / m;
    const Response one = run(between_walls(own, {}));
    const Response other = run(between_walls(free, {link(spring)}));
    ASSERT_GT(one.impacts.size(), 1u);
    ASSERT_EQ(one.impacts.size(), other.impacts.size());
    for (std::size_t i = 0; i < one.impacts.size(); ++i) {
      EXPECT_NEAR(one.impacts[i].start, other.impacts[i].start, within(100));
      EXPECT_NEAR(one.impacts[i].impulse, other.impacts[i].impulse, within(1000 * one.impacts[i].impulse));
    }
    const double x = one.buildings[1].displacement(0);
    EXPECT_NEAR(other.buildings[1].displacement(0), x, within(100 * x));
    EXPECT_NEAR(other.buildings[1].displacement_no_contact(0), one.buildings[1].displacement_no_contact(0),
                within(100 * x));
    const LinkSummary& is = other.links[0];
    EXPECT_NEAR(std::max(is.peak_closing, is.peak_opening), x, within(100 * x));
    if (!yields) continue;
    const double shear = one.buildings[1].storey_shear(0), energy = one.buildings[1].yielding.hysteretic_energy(0);
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(std::max(is.peak_compression, is.peak_tension), shear, within(100 * shear));
    EXPECT_NEAR(is.energy_dissipated, energy, within(100 * energy));
  }
}

TEST_P(LinkedBuildings, NeedNotBeNeighbours) {
  // The outer two of three are joined; between them stands one that they never reach.
  const std::shared_ptr<const Law> law = bilinear_law(900, 6);
  Problem near = pair(oscillator(2, 800, 0.02), oscillator(3, 500, 0.05), {contact(1e3, 1)}, 3);
  near.links = {link(law)};
  near.motion = shaking();
  Problem far = near;
  far.buildings.insert(far.buildings.begin() + 1, oscillator(1, 400, 0.1));
  far.points = {contact(1e3, 1, 0, 0), contact(1e3, 1, 0, 1)};
  far.links[0].right = 2;
  far.delays.clear();
  far.initial_displacement.clear();
  far.initial_velocity.clear();
  const Response one = run(near), other = run(far);
  EXPECT_GT(one.links[0].energy_dissipated, 0);
  EXPECT_NEAR(one.links[0].energy_dissipated, other.links[0].energy_dissipated,
              within(10 * one.links[0].energy_dissipated));
  EXPECT_NEAR(one.links[0].peak_closing, other.links[0].peak_closing, within(10 * one.links[0].peak_closing));
  const auto peak = [](const Response& response, std::size_t b) { return response.buildings[b].displacement(0); };
  EXPECT_NEAR(peak(one, 0), peak(other, 0), within(10 * peak(one, 0)));
  EXPECT_NEAR(peak(one, 1), peak(other, 2), within(10 * peak(one, 1)));
}

TEST_P(LinkedBuildings, FeelTheGroundBetweenThemWhereItMovesDifferently) {
  // Rigid against their springs: absolute kinematics stretch a soft link by the difference of the ground's
  // displacement.
  Problem problem = pair(oscillator(1, 1e8, 0.5), oscillator(1, 1e8, 0.5), {contact(1e3, 1)}, 1);
  problem.links = {link(std::make_shared<SpringDashpot>(1.0, 0))};
  problem.kinematics = Kinematics::absolute;
  problem.motion = HarmonicMotion{0.5, 0.01, HarmonicMotion::Phase::cosine};
  problem.delays = {0, 0.25};
  // From rest u = A (cos ωt − 1); half a period later the other side begins, and u_left − u_right = 2 A cos ωt.
  const Response response = run(problem);
  EXPECT_NEAR(response.links[0].peak_closing, 0.02, 1e-5);
  EXPECT_NEAR(response.links[0].peak_opening, 0.02, 1e-5);
}

}  // namespace
}  // namespace bentur::linked_buildings
