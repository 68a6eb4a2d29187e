// Corners of floors that turn, which strike a wall or one another and rub along: closed forms, both solvers, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <utility>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/core/errors.h"
#include "tests/support/free_rectangle.h"

namespace bentur {
namespace {

using namespace bentur::test;

struct Rubs {
  std::shared_ptr<const ContactLaw> normal;
  double friction = 0, tangential = 1;
};

/// A contact of a point of body 0 and one of body 1 (none: a wall of that body's own), whose arms from the middles are
/// given.
RubbingContact rubbing(const Rubs& law, const Eigen::Vector2d& arm, Index other = -1,
                       const Eigen::Vector2d& other_arm = {0, 0}) {
  const auto side = [](Index body, double sign, const Eigen::Vector2d& at) {
    return std::pair{BodyRow{body, sign * Vector3d(1, 0, -at.y())}, BodyRow{body, sign * Vector3d(0, 1, at.x())}};
  };
  const auto [across, along] = side(0, 1, arm);
  RubbingContact contact{{across}, {along}, std::make_shared<Rubbing>(law.normal, law.friction, law.tangential), 0};
  if (other >= 0) std::tie(contact.at.right, contact.along.right) = side(other, -1, other_arm);
  return contact;
}

/// Moves with the ground.
Body wall() {
  Body body;
  body.name = "wall";
  body.mass = body.stiffness = MatrixXd::Zero(3, 3);
  body.modes.shapes.resize(3, 0);
  body.load = VectorXd::Zero(3);
  body.outputs = {{.kind = OutputKind::displacement, .count = 3, .rows = MatrixXd::Identity(3, 3), .has_peak = true}};
  return body;
}

struct After {
  Vector3d velocity;
  Impact impact;
};

/// One impact of a point of the rectangle, with a wall of its own and with one that is a rigid body.
After strike(const Rubs& law, const Eigen::Vector2d& arm, const Vector3d& velocity,
             const Solver& solver = ExactSolver{}) {
  const double stiffness = law.normal->branch(law.normal->next({}, 0, 0, 0, 1)).stiffness;
  After result;
  for (const bool rigid : {true, false}) {
    System system = rectangle(velocity, 20 * std::sqrt(plate_mass / stiffness));
    if (rigid) {
      system.bodies.push_back(wall());
      for (auto* list : {&system.initial_displacement, &system.initial_velocity}) list->emplace_back(Vector3d::Zero());
    }
    system.rubbing = {rubbing(law, arm, rigid ? 1 : -1)};
    const Solution solution = solved(system, solver);
    EXPECT_LT(solution.energy->relative_residual(), std::holds_alternative<ExactSolver>(solver) ? 1e-12 : 1e-9);
    EXPECT_EQ(solution.impacts.size(), 1U);
    if (solution.impacts.empty()) return result;
    const After now{after(solution), solution.impacts[0]};
    EXPECT_NEAR(now.impact.tangential_impulse, plate_mass * (velocity - now.velocity).y(), 1e-9);
    EXPECT_NEAR(solution.energy->histories.contact_lost.tail(1)(0), now.impact.energy_lost + now.impact.friction_loss,
                1e-9);
    if (!rigid) {
      EXPECT_LT((now.velocity - result.velocity).cwiseAbs().maxCoeff(), 1e-12);
    }
    result = now;
  }
  return result;
}

TEST(Rubbing, CornerThatSlidesAllTheWay) {  // space-targets 3
  const Rubs law{std::make_shared<Linear>(corner_stiffness), 0.3, 8.0 / 9 * corner_stiffness};
  struct One {
    Vector3d before, after;
    double across, along, loss;
  };
  for (const One& one : {One{{-1.6, 4.4, 0.4},
                             {-2.0581497797357, 4.2625550660793, 0.20969162995595},
                             22.907488986784,
                             6.8722466960352,
                             38.145510295173},
                         One{{-1.6, -7.6, 0.4},
                             {-2.2011560693642, -7.4196531791908, 0.23352601156069},
                             30.057803468208,
                             -9.0173410404624,
                             56.293227304621}}) {
    const After after = strike(law, corner, one.before);
    EXPECT_LT((after.velocity - one.after).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(after.impact.impulse, one.across, 1e-10 * one.across);
    EXPECT_NEAR(after.impact.tangential_impulse, one.along, 1e-10 * one.across);
    EXPECT_NEAR(after.impact.friction_loss, one.loss, 1e-10 * one.loss);
    EXPECT_NEAR(after.impact.energy_lost, 0, 1e-10 * one.loss);
    EXPECT_NEAR(after.impact.peak_tangential_force, 0.3 * after.impact.peak_force, 1e-9 * after.impact.peak_force);
  }
}

TEST(Rubbing, WithoutFrictionIsTheImpactOfTheMassAtTheCorner) {  // space-targets 2
  const After none =
      strike({std::make_shared<Linear>(corner_stiffness), 0, corner_stiffness}, corner, {-1.6, 0.3, 0.4});
  EXPECT_LT((none.velocity - Vector3d(-2.12, 0.3, 0.22)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(none.impact.sliding, 0);
  const After little =
      strike({std::make_shared<Linear>(corner_stiffness), 1e-9, corner_stiffness}, corner, {-1.6, 0.3, 0.4});
  EXPECT_LT((little.velocity - none.velocity).cwiseAbs().maxCoeff(), 1e-8);
}

struct Central {
  double friction, ratio, along, after;
};

TEST(Rubbing, CentralImpactsStickAndSlide) {  // space-targets 4
  constexpr double k = 4e5;
  for (const Central& one :
       {Central{0.5, 1.0, 0.3, -0.3}, Central{0.3, 0.9, 0.5, 0.02}, Central{0.25, 2.7, 0.2, -0.098500106257919},
        Central{0.1, 0.6, 0.05, -0.032541855029654}, Central{0.6, 12.0, 0.9, -0.055660809913147}}) {
    const After after = strike({std::make_shared<Linear>(k), one.friction, one.ratio * k}, {0, 0}, {0.8, one.along, 0});
    EXPECT_NEAR(after.velocity.x(), -0.8, 1e-10);
    EXPECT_NEAR(after.velocity.y(), one.after, 1e-10) << one.friction;
    const bool sticks = one.after == -one.along;
    EXPECT_EQ(after.impact.sliding == 0, sticks);
    EXPECT_NEAR(after.impact.friction_loss, 0.5 * plate_mass * (one.along * one.along - one.after * one.after), 1e-10);
  }
}

TEST(Rubbing, WithADashpotWhileItCloses) {  // space-targets 4, kelvin-voigt-approach
  constexpr double k = 4e5;
  struct Damped {
    double ratio, after;
    Central central;
  };
  for (const Damped& one : {Damped{0.3, -0.53723764746302, {0.3, 0.9, 0.5, 0.1308025134135}},
                            Damped{0.2, -0.60490794147065, {0.25, 2.7, 0.2, -0.077289292169077}},
                            Damped{0.4, -0.48234550987054, {0.6, 12.0, 0.9, 0.13753549712122}}}) {
    const Rubs law{std::make_shared<KelvinVoigtApproach>(k, one.ratio, plate_mass), one.central.friction,
                   one.central.ratio * k};
    const After after = strike(law, {0, 0}, {0.8, one.central.along, 0});
    EXPECT_NEAR(after.velocity.x(), one.after, 1e-10);
    EXPECT_NEAR(after.velocity.y(), one.central.after, 1e-10) << one.ratio;
  }
}

TEST(Rubbing, ComesToRouthsAsTheTangentialSpringGrowsStiff) {  // space-targets 4, (P-20)
  constexpr double k = 4e5;
  double bound = 4.65e-2;
  for (const double ratio : {1e2, 1e4, 1e6}) {
    const After after = strike({std::make_shared<Linear>(k), 0.6, ratio * k}, {0, 0}, {0.8, 0.2, 0});
    EXPECT_LT(std::abs(after.velocity.y()) / 0.2, bound) << ratio;
    bound = ratio == 1e2 ? 1.25e-4 : 4.4e-6;
  }
}

/// Every law that takes friction, at a corner.
std::vector<std::shared_ptr<const ContactLaw>> laws_with_friction() {
  return {std::make_shared<Linear>(corner_stiffness), std::make_shared<Bilinear>(corner_stiffness, 5e4, 0.002),
          std::make_shared<KelvinVoigt>(corner_stiffness, 0.2, plate_mass, KelvinVoigt::Release::zero_force),
          std::make_shared<KelvinVoigtApproach>(corner_stiffness, 0.2, plate_mass)};
}

TEST(Rubbing, BodyThatSlidesLosesWhatFrictionTakesOfItsImpulse) {  // μ(1 + e) v_n, exactly
  for (const auto& normal : laws_with_friction()) {
    // Where a dashpot makes the force jump the spring along has to be drawn first.
    const bool jumps = normal->branch(normal->next({}, 0, 0, 0, 1)).damping > 0;
    for (const double along : {3.0, -3.0}) {
      const After after = strike({normal, 0.3, jumps ? 2e14 : 1.8e5}, {0, 0}, {0.8, along, 0});
      const double lost = 0.3 * (1 + *after.impact.restitution()) * 0.8;
      EXPECT_NEAR(std::abs(along) - std::abs(after.velocity.y()), lost, 1e-11) << normal->name();
      EXPECT_EQ(after.velocity.z(), 0);
    }
  }
}

TEST(Rubbing, BodyAtRestOnTheLimitStays) {
  constexpr double push = 2, friction = 0.4;
  const auto slid = [](double part) {
    System system = rectangle(Vector3d::Zero(), 12);
    Body& body = system.bodies[0];
    body.load = MatrixXd::Zero(3, 2);
    body.load.topRows(2).diagonal().setConstant(plate_mass);
    body.modal_damping = 200 * MatrixXd::Identity(3, 3);
    SampledMotion along{5, {0, -part * friction * push, -part * friction * push, -part * friction * push}};
    system.motions = {SampledMotion{5, {-push, -push, -push, -push}}, along};
    system.initial_displacement = {Vector3d(plate_mass * push / corner_stiffness, 0, 0)};
    system.rubbing = {rubbing({std::make_shared<Linear>(corner_stiffness), friction, corner_stiffness}, {0, 0})};
    const Solution solution = solved(system);
    EXPECT_EQ(solution.impacts.size(), 1U);
    EXPECT_TRUE(solution.impacts.at(0).open_ended);
    return std::pair{solution.impacts.at(0).sliding, solution.samples.slip(0, solution.samples.slip.cols() - 1)};
  };
  // Pulled up to the limit by a force that grows steadily; damping lets it lag, by 0.1 % of the limit and less.
  const auto [path, slip] = slid(0.999);
  EXPECT_EQ(path, 0);
  EXPECT_NEAR(slip, 0.999 * friction * push * plate_mass / corner_stiffness, 1e-9);
  EXPECT_NEAR(slid(1.01).first, 0.01 * friction * push / 200 * 7, 0.01 * 3e-4);  // damped: at a speed of a/200
}

TEST(Rubbing, LawsThatPullOrHaveNoBranchesTakeNone) {
  EXPECT_NO_THROW(Rubbing(std::make_shared<Linear>(1), 0.3, 1));
  for (const std::shared_ptr<const ContactLaw>& law : std::vector<std::shared_ptr<const ContactLaw>>{
           std::make_shared<KelvinVoigt>(1, 0.2, 1, KelvinVoigt::Release::separation),
           std::make_shared<KelvinVoigt>(1, 0.2, 1, KelvinVoigt::Release::creep), std::make_shared<Restitution>(0.6),
           std::make_shared<HertzDamp>(1, 1), std::make_shared<Darmawan>(1, 1)}) {
    EXPECT_THROW(Rubbing(law, 0.3, 1), InvalidParameter) << law->name();
  }
  for (const auto& law : laws_with_friction()) {
    EXPECT_THROW(Rubbing(law, -0.1, 1), InvalidParameter);
    EXPECT_THROW(Rubbing(law, 0.1, 0), InvalidParameter);
    EXPECT_THROW(Rubbing(law, 0.1, std::numeric_limits<double>::infinity()), InvalidParameter);
  }
}

TEST(Rubbing, RandomCornersOfTwoBodiesByBothSolvers) {
  std::mt19937 random(11);
  const auto any = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int slid = 0, several = 0;
  for (int n = 0; n < 120; ++n) {
    const auto laws = laws_with_friction();
    const Rubs law{laws[n % laws.size()], any(0.02, 1.0), std::exp(any(-1.5, 3)) * corner_stiffness};
    System system = rectangle({any(0.5, 2), any(-2, 2), any(-0.2, 0.2)}, 1.0);
    system.bodies.push_back(system.bodies[0]);
    system.initial_displacement.emplace_back(Vector3d::Zero());
    system.initial_velocity.emplace_back(Vector3d(any(-2, -0.5), any(-2, 2), any(-0.2, 0.2)));
    for (int point = 0; point < 1 + n % 2; ++point) {
      system.rubbing.push_back(rubbing(law, {any(1, 4), any(-6, 6)}, 1, {any(-4, -1), any(-6, 6)}));
      system.rubbing.back().width = point == 0 ? 0.0 : any(0, 1e-3);
    }
    const Solution exact = solved(system), adaptive = solved(system, AdaptiveSolver{1e-12});
    EXPECT_LT(exact.energy->relative_residual(), 1e-12) << n;
    ASSERT_EQ(exact.impacts.size(), adaptive.impacts.size()) << n;
    several += exact.impacts.size() > 1 ? 1 : 0;
    for (std::size_t i = 0; i < exact.impacts.size(); ++i) {
      const Impact &one = exact.impacts[i], &other = adaptive.impacts[i];
      EXPECT_NEAR(one.impulse, other.impulse, 1e-8 * one.impulse) << n;
      EXPECT_NEAR(one.tangential_impulse, other.tangential_impulse, 1e-8 * one.impulse) << n;
      EXPECT_NEAR(one.sliding, other.sliding, 1e-8) << n;
      EXPECT_NEAR(one.friction_loss, other.friction_loss, 1e-7 * plate_mass) << n;
      EXPECT_GE(one.sliding, 0) << n;
      EXPECT_GE(one.friction_loss, -1e-11 * plate_mass) << n;
      EXPECT_LE(one.peak_tangential_force, law.friction * one.peak_force * (1 + 1e-9)) << n;
      slid += one.sliding > 0 ? 1 : 0;
    }
    EXPECT_LT((after(exact) - after(adaptive)).cwiseAbs().maxCoeff(), 1e-8) << n;
    const EnergyHistories& energy = exact.energy->histories;
    EXPECT_GE(energy.contact_stored.minCoeff(), -1e-12 * exact.energy->peak_input) << n;
    EXPECT_GE(energy.contact_lost.minCoeff(), -1e-11 * exact.energy->peak_input) << n;
  }
  EXPECT_GT(slid, 60);
  EXPECT_GT(several, 20);
}

/// Two floors that turn, side by side, on eccentric springs; corners of theirs face one another at two points. The
/// ground shakes both ways.
System shaken_pair(unsigned seed, const Rubs& law) {
  std::mt19937 random(seed);
  const auto any = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  System system;
  for (int b = 0; b < 2; ++b) {
    Body body;
    const double turns = plate_inertia * any(0.6, 1.5);
    body.mass = Vector3d(plate_mass, plate_mass, turns).asDiagonal();
    body.stiffness = Vector3d(any(2e3, 9e3), any(2e3, 9e3), any(1e5, 4e5)).asDiagonal();
    body.stiffness(0, 2) = body.stiffness(2, 0) = any(-6e3, 6e3);
    body.modes = modes(body.mass, body.stiffness);
    body.modal_damping = (0.08 * body.modes.omega).asDiagonal();
    body.load = MatrixXd::Zero(3, 2);
    body.load.topRows(2).diagonal().setConstant(plate_mass);
    body.outputs = {{.kind = OutputKind::displacement, .count = 3, .rows = MatrixXd::Identity(3, 3), .has_peak = true}};
    system.bodies.push_back(body);
  }
  for (int c = 0; c < 2; ++c) {
    SampledMotion motion{0.02, {0}};
    for (int n = 1; n < 200; ++n) motion.acceleration.push_back(any(-6, 6));
    system.motions.emplace_back(motion);
  }
  if (seed % 2 == 0) system.delays = {0, 0.0137};
  for (const double y : {-6.0, any(-2, 6)}) {
    RubbingContact contact = rubbing(law, {4, y}, 1, {-4, y});
    contact.width = 0.004;
    if (seed % 2 == 0) {  // absolute kinematics
      contact.at.left.ground = Eigen::Vector2d(1, 0);
      contact.at.right.ground = Eigen::Vector2d(-1, 0);
      contact.along.left.ground = Eigen::Vector2d(0, 1);
      contact.along.right.ground = Eigen::Vector2d(0, -1);
    }
    system.rubbing.push_back(contact);
  }
  system.duration = 3;
  return system;
}

TEST(Rubbing, ShakenPairsByBothSolvers) {
  std::size_t impacts = 0;
  double slid = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const auto laws = laws_with_friction();
    const System system = shaken_pair(seed, {laws[seed % laws.size()], 0.1 + 0.04 * seed, 0.9 * corner_stiffness});
    const Solution exact = solved(system), adaptive = solved(system, AdaptiveSolver{1e-12});
    EXPECT_LT(exact.energy->relative_residual(), 1e-12) << seed;
    EXPECT_LT(exact.checks.forces, 1e-10) << seed;
    ASSERT_EQ(exact.impacts.size(), adaptive.impacts.size()) << seed;
    impacts += exact.impacts.size();
    for (std::size_t b = 0; b < 2; ++b) {
      const VectorXd &one = exact.outputs[b][0].peak, &other = adaptive.outputs[b][0].peak;
      EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-6 * one.maxCoeff()) << seed;
    }
    for (std::size_t i = 0; i < exact.impacts.size(); ++i) {
      const Impact &one = exact.impacts[i], &other = adaptive.impacts[i];
      EXPECT_EQ(one.point, other.point) << seed;
      EXPECT_NEAR(one.impulse, other.impulse, 1e-6 * (1 + one.impulse)) << seed;
      EXPECT_NEAR(one.tangential_impulse, other.tangential_impulse, 1e-6 * (1 + one.impulse)) << seed;
    }
    double lost = 0;
    for (const Impact& impact : exact.impacts) {
      EXPECT_GE(impact.friction_loss, -1e-12 * exact.energy->peak_input) << seed;
      slid += impact.sliding;
      lost += impact.friction_loss + impact.energy_lost;
    }
    EXPECT_NEAR(exact.energy->histories.contact_lost.tail(1)(0), lost, 1e-10 * exact.energy->peak_input) << seed;
    // Neither samples nor the account change anything, nor the way there before the first contact.
    const FreeSolution free(system, ExactSolver{});
    const Solution bare = free.solve(system.contacts);
    ASSERT_EQ(bare.impacts.size(), exact.impacts.size());
    for (std::size_t i = 0; i < bare.impacts.size(); ++i) EXPECT_EQ(bare.impacts[i].impulse, exact.impacts[i].impulse);
    EXPECT_TRUE(free.solution().impacts.empty());
    const std::vector<double>& needed = free.solution().needed;
    ASSERT_EQ(needed.size(), 2U);
    EXPECT_EQ(std::max(needed[0], needed[1]) > 0.004, !exact.impacts.empty()) << seed;
  }
  EXPECT_GT(impacts, 200U);
  EXPECT_GT(slid, 0.1);
}

TEST(Rubbing, WithoutFrictionIsTheContactOfItsLaw) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const auto laws = laws_with_friction();
    System system = shaken_pair(seed, {laws[seed % laws.size()], 0, corner_stiffness});
    const Solution rubs = solved(system);
    for (const RubbingContact& contact : system.rubbing) {
      system.contacts.push_back({contact.at, laws[seed % laws.size()], contact.width});
    }
    system.rubbing.clear();
    const Solution meets = solved(system);
    ASSERT_EQ(rubs.impacts.size(), meets.impacts.size()) << seed;
    for (std::size_t i = 0; i < meets.impacts.size(); ++i) {
      const Impact &one = rubs.impacts[i], &other = meets.impacts[i];
      EXPECT_EQ(one.point, other.point);
      EXPECT_NEAR(one.start, other.start, 1e-9);
      EXPECT_NEAR(one.end, other.end, 1e-9);
      EXPECT_NEAR(one.closing_speed, other.closing_speed, 1e-9);
      EXPECT_NEAR(one.peak_force, other.peak_force, 1e-9 * other.peak_force);
      EXPECT_NEAR(one.impulse, other.impulse, 1e-8 * other.impulse) << seed;
      EXPECT_NEAR(one.energy_lost, other.energy_lost, 1e-9 * meets.energy->peak_input);
      EXPECT_EQ(one.tangential_impulse, 0);
    }
    for (std::size_t b = 0; b < 2; ++b) {
      const VectorXd& one = rubs.outputs[b][0].peak;
      EXPECT_LT((one - meets.outputs[b][0].peak).cwiseAbs().maxCoeff(), 1e-9 * one.maxCoeff()) << seed;
    }
    EXPECT_EQ(rubs.needed, meets.needed);
  }
}

/// Both ends of a symmetric stretch touch within round-off of one another.
TEST(Rubbing, SymmetricPairsNeitherTurnNorFeelABlowThatTurnsThem) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const auto laws = laws_with_friction();
    const Rubs law{laws[seed % laws.size()], 0.05 + 0.04 * seed, 0.9 * corner_stiffness};
    System system = shaken_pair(seed, law);
    for (Body& body : system.bodies) {
      body.stiffness(0, 2) = body.stiffness(2, 0) = 0;
      body.modes = modes(body.mass, body.stiffness);
      body.outputs.push_back({.kind = OutputKind::acceleration,
                              .count = 3,
                              .absolute = MatrixXd::Identity(3, 3),
                              .ground = MatrixXd::Zero(3, 2),
                              .has_peak = true});
    }
    system.rubbing = {rubbing(law, {0, -6}, 1, {0, -6}), rubbing(law, {0, 6}, 1, {0, 6})};
    const Solution exact = solved(system);
    EXPECT_GT(exact.impacts.size(), 2U) << seed;
    EXPECT_EQ(exact.impacts.size() % 2, 0U) << seed;
    for (const std::vector<OutputsFound>& of : exact.outputs) {
      for (const OutputsFound& found : of) EXPECT_LT(found.peak(2), 1e-12 * found.peak(0)) << seed;
    }
  }
}

}  // namespace
}  // namespace bentur
