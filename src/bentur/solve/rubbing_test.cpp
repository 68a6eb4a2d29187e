// Corners of floors that turn, which strike a wall and rub along it: interfaces over rotations, and a law of two
// deformations that push on one another along one way only. Their closed forms by the solver, though no case asks for
// them yet.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/restitution_relations.h"
#include "bentur/solve/solver.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Penetration δ and slip s of a contact: F_n = k δ + c δ̇ (c while it closes alone); F_t that of a spring k_t, which
/// slides at ± μ F_n.
class RubbingContact final : public CoupledLaw {
 public:
  struct Parameters {
    double stiffness = 1, damping = 0, tangential = 1, friction = 0;
  };
  explicit RubbingContact(const Parameters& parameters) : p_(parameters) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "rubbing"; }
  [[nodiscard]] Index size() const noexcept override { return 2; }
  [[nodiscard]] bool same_as(const CoupledLaw& other) const override { return this == &other; }
  [[nodiscard]] CoupledState begin(const VectorXd& /*deformation*/) const override { return state_of({}, 0); }

  [[nodiscard]] CoupledBranch branch(const CoupledState& state) const override {
    const Phase at = phase_of(state);
    CoupledSet set;
    CoupledBranch result{nullptr, VectorXd::Zero(2), {}};
    const auto row = [&set](double of_penetration, double of_slip) {
      set.own.push_back(-1);
      set.over.conservativeResize(std::ssize(set.own), 2);
      set.over.row(set.over.rows() - 1) << of_penetration, of_slip;
      return set.over.rows() - 1;
    };
    if (at.friction == Friction::apart) {
      set.own = {0};
      set.over.resize(1, 0);
      result.guards.push_back({.sense = -1, .deformation = 0});
      result.set = std::make_shared<const CoupledSet>(std::move(set));
      return result;
    }
    const double k = p_.stiffness, c = at.closes ? p_.damping : 0.0, mu = p_.friction, kt = p_.tangential;
    set.moving = {0, 1};
    set.stiffness = MatrixXd::Zero(2, 2);
    set.damping = MatrixXd::Zero(2, 2);
    set.stiffness(0, 0) = k;
    set.damping(0, 0) = c;
    // Parting, and the change from closing to opening where there is a dashpot.
    const Index penetration = row(1, 0);
    result.guards.push_back({.deformation = penetration, .zeros = at.touches ? 1 : 0});
    if (p_.damping > 0.0) {
      result.guards.push_back({.sense = at.closes ? 1.0 : -1.0, .speed = penetration, .zeros = at.turns ? 1 : 0});
    }
    if (at.friction == Friction::sticks) {
      result.base(1) = -kt * at.origin;
      set.stiffness(1, 1) = kt;
      for (const int sense : {1, -1}) {
        const int zeros = at.slid == sense ? 2 : (at.touches && c == 0.0 ? 1 : 0);
        result.guards.push_back({.of = sense,
                                 .constant = sense * kt * at.origin,
                                 .size = kt * std::abs(at.origin),
                                 .deformation = row(mu * k, -sense * kt),
                                 .speed = row(mu * c, 0),
                                 .zeros = zeros});
      }
    } else {
      const double sense = at.friction == Friction::slides_up ? 1.0 : -1.0;
      set.stiffness(1, 0) = sense * mu * k;
      set.damping(1, 0) = sense * mu * c;
      result.guards.push_back({.speed = row(-mu * k / kt, sense)});
      if (c != 0.0) result.guards.back().acceleration = row(-mu * c / kt, 0);
    }
    result.set = std::make_shared<const CoupledSet>(std::move(set));
    return result;
  }

  [[nodiscard]] CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                  double time, const CoupledMotion& motion) const override {
    Phase at = phase_of(state);
    const bool was_apart = at.friction == Friction::apart;
    const CoupledGuard& failed = branch.guards[guard];
    at.touches = at.turns = false;
    at.slid = 0;
    const double slip = motion.deformation(1), slips = motion.speed(1), closes = motion.speed(0);
    const double k = p_.stiffness, mu = p_.friction, kt = p_.tangential;
    if (was_apart) {
      at = {.friction = Friction::sticks, .closes = true, .touches = true, .origin = slip};
      if (p_.damping == 0.0 && kt * std::abs(slips) > mu * k * closes) at.friction = sliding(slips);
    } else if (guard == 0) {
      at = {};
    } else if (p_.damping > 0.0 && guard == 1) {
      at.closes = !at.closes;
      at.turns = true;
    } else if (at.friction == Friction::sticks) {
      at.friction = sliding(static_cast<double>(failed.of));
    } else {
      at.slid = at.friction == Friction::slides_up ? 1 : -1;
      const double normal = k * motion.deformation(0) + (at.closes ? p_.damping : 0.0) * closes;
      at.origin = slip - at.slid * mu * normal / kt;
      at.friction = Friction::sticks;
    }
    return state_of(at, time);
  }
  [[nodiscard]] CoupledState settle(const CoupledState& state, double /*time*/,
                                    const CoupledMotion& /*motion*/) const override {
    return state;
  }
  [[nodiscard]] CoupledState at(const CoupledState& state, const VectorXd& /*deformation*/) const override {
    return state;
  }
  [[nodiscard]] double stored_energy(const CoupledState& state, const VectorXd& deformation) const override {
    const Phase at = phase_of(state);
    if (at.friction == Friction::apart) return 0.0;
    const double normal = p_.stiffness * deformation(0);
    const double along =
        at.friction == Friction::sticks ? p_.tangential * (deformation(1) - at.origin) : p_.friction * normal;
    return normal * deformation(0) / 2 + along * along / (2 * p_.tangential);
  }
  [[nodiscard]] double lost_energy(const CoupledState& /*state*/, const VectorXd& /*deformation*/) const override {
    return 0.0;
  }

 private:
  enum class Friction { apart, sticks, slides_up, slides_down };
  struct Phase {
    Friction friction = Friction::apart;
    bool closes = false;
    bool touches = false, turns = false;  ///< δ, δ̇ are zero where it begins
    int slid = 0;                         ///< +1, −1: it slid so before
    double origin = 0;                    ///< s where the spring has no force
  };
  static Friction sliding(double sense) { return sense > 0.0 ? Friction::slides_up : Friction::slides_down; }
  static CoupledState state_of(const Phase& at, double time) {
    MatrixXd memory(2, 3);
    memory << static_cast<double>(at.friction), at.closes, at.touches, at.turns, at.slid, at.origin;
    return {time, memory};
  }
  static Phase phase_of(const CoupledState& state) {
    const MatrixXd& m = state.memory;
    return {static_cast<Friction>(static_cast<int>(m(0, 0))),
            m(0, 1) != 0.0,
            m(0, 2) != 0.0,
            m(1, 0) != 0.0,
            static_cast<int>(m(1, 1)),
            m(1, 2)};
  }

  Parameters p_;
};

/// A rectangle of mass 50, 8 × 12, free to slide and turn: x, y and θ. One point of it, at `arm` from its middle, comes
/// against a wall to its right.
constexpr double mass = 50, inertia = 50 * (8.0 * 8 + 12 * 12) / 12;

struct After {
  Vector3d velocity;
  double friction_loss = 0;
};

/// The rectangle on its own, at rest where it is drawn, with velocities.
System rectangle(const Vector3d& velocity, double duration) {
  Body body;
  body.name = "rectangle";
  body.mass = Vector3d(mass, mass, inertia).asDiagonal();
  body.stiffness = 1e-12 * body.mass;
  body.modes = modes(body.mass, body.stiffness);
  body.modal_damping = MatrixXd::Zero(3, 3);
  body.load = VectorXd::Zero(3);
  body.outputs = {{.kind = OutputKind::displacement, .count = 3, .rows = MatrixXd::Identity(3, 3), .has_peak = true},
                  {.kind = OutputKind::velocity, .count = 3, .rates = MatrixXd::Identity(3, 3)}};
  System system;
  system.bodies = {body};
  system.motions = {NoMotion{}};
  system.initial_displacement = {Vector3d::Zero()};
  system.initial_velocity = {velocity};
  system.duration = duration;
  return system;
}

Solution solved(const System& system, const Solver& solver = ExactSolver{}) {
  const FreeSolution free(system, solver);
  EXPECT_EQ(free.solution().status, Status::done) << free.solution().message;
  Solution solution = free.solve(system.contacts, {.output_step = system.duration / 8, .energy_audit = true});
  EXPECT_EQ(solution.status, Status::done) << solution.message;
  return solution;
}

/// Velocities at the end.
Vector3d after(const Solution& solution) { return solution.outputs[0][1].history.rightCols(1); }

After strike(const RubbingContact::Parameters& law, const Eigen::Vector2d& arm, const Vector3d& velocity,
             const Solver& solver = ExactSolver{}) {
  MatrixXd rows(2, 3);
  rows << 1, 0, -arm.y(), 0, 1, arm.x();
  System system = rectangle(velocity, 20 * std::sqrt(mass / law.stiffness));
  system.bodies[0].coupled = {{rows, std::make_shared<RubbingContact>(law)}};
  const Solution solution = solved(system, solver);
  EXPECT_LT(solution.energy->relative_residual(), 1e-10);
  return {after(solution), solution.energy->histories.hysteretic.tail(1)(0)};
}

/// Contact points on the wall, `above` the middle of the rectangle, all by one law.
System against_wall(const std::shared_ptr<const Law>& law, const Vector3d& velocity, const std::vector<double>& above) {
  System system = rectangle(velocity, 0.5);
  for (const double y : above) system.contacts.push_back({{{0, Vector3d(1, 0, -y)}}, law, 0});
  return system;
}

/// A corner of the rectangle, 4 to the right of its middle and 6 below.
const Eigen::Vector2d corner(4, -6);
constexpr double corner_stiffness = 2e5;

TEST(RubbingTrial, CornerThatSlidesAllTheWay) {  // space-targets 3
  const RubbingContact::Parameters law{
      .stiffness = corner_stiffness, .tangential = 8.0 / 9 * corner_stiffness, .friction = 0.3};
  const After up = strike(law, corner, {-1.6, 4.4, 0.4});
  EXPECT_NEAR(up.velocity.x(), -2.0581497797357, 1e-10);
  EXPECT_NEAR(up.velocity.y(), 4.2625550660793, 1e-10);
  EXPECT_NEAR(up.velocity.z(), 0.20969162995595, 1e-10);
  EXPECT_NEAR(up.friction_loss, 38.145510295173, 1e-9);
  const After down = strike(law, corner, {-1.6, -7.6, 0.4});
  EXPECT_NEAR(down.velocity.x(), -2.2011560693642, 1e-10);
  EXPECT_NEAR(down.velocity.y(), -7.4196531791908, 1e-10);
  EXPECT_NEAR(down.velocity.z(), 0.23352601156069, 1e-10);
  EXPECT_NEAR(down.friction_loss, 56.293227304621, 1e-9);
}

/// The mass that a corner strikes with: 1/m_p = 1/m + y²/J.
constexpr double corner_mass = 1 / (1 / mass + 36 / inertia);

TEST(CornerTrial, RestitutionIsThatOfTheLaw) {  // space-targets 2
  struct One {
    double restitution, impulse, tolerance;  // of the impulse: integrated contacts read it off an interpolant
    std::shared_ptr<const Law> law;
  };
  constexpr double k = corner_stiffness, speed = 0.8;
  const double d = exact_damping_factor(0.6);
  for (const One& one :
       {One{1.0, 26, 1e-10, std::make_shared<Linear>(k)}, One{0.6, 20.8, 1e-10, std::make_shared<Restitution>(0.6)},
        One{0.35, 17.55, 1e-10, std::make_shared<Restitution>(0.35)},
        One{0.55, 20.15, 1e-10,
            std::make_shared<KelvinVoigt>(k, exact_separation_damping_ratio(0.55), corner_mass,
                                          KelvinVoigt::Release::separation)},
        One{0.6, 20.8, 1e-9, std::make_shared<HertzDamp>(10 * k, d)},
        One{0.6, 20.8, 1e-9, std::make_shared<Darmawan>(k, d / speed)}}) {
    const Solution solution = solved(against_wall(one.law, {-1.6, 0.3, 0.4}, {-6, -1}));
    ASSERT_EQ(solution.impacts.size(), 1U) << one.law->name();
    const Impact& impact = solution.impacts[0];
    EXPECT_EQ(impact.point, 0);
    EXPECT_NEAR(impact.closing_speed, speed, 1e-12);
    EXPECT_NEAR(impact.impulse, one.impulse, one.impulse * one.tolerance) << one.law->name();
    const Vector3d expected(-1.6 - one.impulse / mass, 0.3, 0.4 - 6 * one.impulse / inertia);
    EXPECT_LT((after(solution) - expected).cwiseAbs().maxCoeff(), 1e-10) << one.law->name();
    EXPECT_NEAR(*impact.restitution(), one.restitution, 1e-10) << one.law->name();
  }
}

TEST(CornerTrial, BothPointsAtOnce) {  // space-targets 2, (E-1)
  const Solution solution = solved(against_wall(std::make_shared<Restitution>(0.6), {0.8, 0.3, 0}, {-6, -1}));
  for (const Impact& impact : solution.impacts) {
    EXPECT_NEAR(impact.impulse, impact.point == 0 ? 0.0 : 60.509090909091, 1e-10);
  }
  EXPECT_NEAR(after(solution).x(), 0.8 - 60.509090909091 / mass, 1e-12);
  EXPECT_NEAR(after(solution).z(), -60.509090909091 / inertia, 1e-12);
}

TEST(CornerTrial, DampingRatioOfTheStretchAtACorner) {  // space-targets 2, (P-10)
  constexpr double stretch = 2 * corner_stiffness, ratio = 0.2;
  const double at_corner = ratio * std::sqrt(0.5 * mass / corner_mass);
  struct One {
    double corner, flat;
    std::shared_ptr<const Law> of_corner, of_stretch;
  };
  using enum KelvinVoigt::Release;
  for (const One& one : {One{0.50860135752094, 0.57174002758478,
                             std::make_shared<KelvinVoigt>(stretch / 2, at_corner, corner_mass, zero_force),
                             std::make_shared<KelvinVoigt>(stretch, ratio, mass, zero_force)},
                         One{0.71316292494839, 0.75613492683831,
                             std::make_shared<KelvinVoigtApproach>(stretch / 2, at_corner, corner_mass),
                             std::make_shared<KelvinVoigtApproach>(stretch, ratio, mass)}}) {
    const Solution corner = solved(against_wall(one.of_corner, {-1.6, 0.3, 0.4}, {-6, -1}));
    EXPECT_NEAR(*corner.impacts.at(0).restitution(), one.corner, 1e-10) << one.of_corner->name();
    const Solution flat = solved(against_wall(one.of_stretch, {0.8, 0, 0}, {0}));
    EXPECT_NEAR(*flat.impacts.at(0).restitution(), one.flat, 1e-10) << one.of_stretch->name();
  }
}

TEST(RubbingTrial, WithoutFrictionIsTheImpactOfTheMassAtTheCorner) {  // space-targets 2
  const After after = strike({.stiffness = corner_stiffness, .tangential = corner_stiffness}, corner, {-1.6, 0.3, 0.4});
  EXPECT_NEAR(after.velocity.x(), -2.12, 1e-10);
  EXPECT_NEAR(after.velocity.y(), 0.3, 1e-10);
  EXPECT_NEAR(after.velocity.z(), 0.22, 1e-10);
}

struct Central {
  double friction, ratio, along, after;
};

TEST(RubbingTrial, CentralImpactsStickAndSlide) {  // space-targets 4
  constexpr double k = 4e5;
  for (const Central& one :
       {Central{0.5, 1.0, 0.3, -0.3}, Central{0.3, 0.9, 0.5, 0.02}, Central{0.25, 2.7, 0.2, -0.098500106257919},
        Central{0.1, 0.6, 0.05, -0.032541855029654}, Central{0.6, 12.0, 0.9, -0.055660809913147}}) {
    const After after =
        strike({.stiffness = k, .tangential = one.ratio * k, .friction = one.friction}, {0, 0}, {0.8, one.along, 0});
    EXPECT_NEAR(after.velocity.x(), -0.8, 1e-10);
    EXPECT_NEAR(after.velocity.y(), one.after, 1e-10) << one.friction;
  }
}

TEST(RubbingTrial, WithADashpotWhileItCloses) {  // space-targets 4, kelvin-voigt-approach
  constexpr double k = 4e5;
  struct Damped {
    double ratio, after;
    Central central;
  };
  for (const Damped& one : {Damped{0.3, -0.53723764746302, {0.3, 0.9, 0.5, 0.1308025134135}},
                            Damped{0.2, -0.60490794147065, {0.25, 2.7, 0.2, -0.077289292169077}},
                            Damped{0.4, -0.48234550987054, {0.6, 12.0, 0.9, 0.13753549712122}}}) {
    const double damping = 2 * one.ratio * std::sqrt(k * mass);
    const After after = strike(
        {.stiffness = k, .damping = damping, .tangential = one.central.ratio * k, .friction = one.central.friction},
        {0, 0}, {0.8, one.central.along, 0});
    EXPECT_NEAR(after.velocity.x(), one.after, 1e-10);
    EXPECT_NEAR(after.velocity.y(), one.central.after, 1e-10) << one.ratio;
  }
}

TEST(RubbingTrial, ComesToRouthsAsTheTangentialSpringGrowsStiff) {  // space-targets 4, (P-20)
  constexpr double k = 4e5;
  double bound = 4.65e-2;
  for (const double ratio : {1e2, 1e4, 1e6}) {
    const After after = strike({.stiffness = k, .tangential = ratio * k, .friction = 0.6}, {0, 0}, {0.8, 0.2, 0});
    EXPECT_LT(std::abs(after.velocity.y()) / 0.2, bound) << ratio;
    bound = ratio == 1e2 ? 1.25e-4 : 4.4e-6;
  }
}

TEST(RubbingTrial, ByAdaptiveStepsToo) {
  const RubbingContact::Parameters law{.stiffness = 4e5, .tangential = 1.08e6, .friction = 0.25};
  const After exact = strike(law, {0, 0}, {0.8, 0.2, 0});
  const After adaptive = strike(law, {0, 0}, {0.8, 0.2, 0}, AdaptiveSolver{.tolerance = 1e-12});
  EXPECT_NEAR((adaptive.velocity - exact.velocity).cwiseAbs().maxCoeff(), 0, 1e-9);
}

}  // namespace
}  // namespace bentur
