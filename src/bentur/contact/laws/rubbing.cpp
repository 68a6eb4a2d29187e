#include "bentur/contact/laws/rubbing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index own_numbers = 7;        // of a Phase: all that is not the law's memory
constexpr double at_its_end = 0x1p-30;  // of its terms: a rate of sliding that is zero

bool pushes(const Branch& branch) { return branch.base != 0.0 || branch.stiffness != 0.0 || branch.damping != 0.0; }

/// F_n.
double push_of(const Branch& normal, const CoupledMotion& motion) {
  return normal.base + normal.stiffness * motion.deformation(0) + normal.damping * motion.speed(0);
}

/// dF_n/dt.
double push_rate(const Branch& normal, const CoupledMotion& motion) {
  return normal.stiffness * motion.speed(0) + normal.damping * motion.acceleration(0);
}

/// A guard that says no more than δ ≥ 0 or −δ ≥ 0.
bool of_sign_alone(const Guard& guard) { return guard.constant == 0.0 && guard.speed == 0.0; }

/// Whether a branch with a dashpot ends before that could pull: where the force is zero, or with closing.
bool ends_before_it_pulls(const Branch& branch) {
  if (branch.damping == 0.0) return true;
  return std::any_of(branch.guards, branch.guards + branch.guard_count, [&](const Guard& guard) {
    if (!(guard.speed > 0.0)) return false;
    const double times = branch.damping / guard.speed;
    const bool of_force = branch.stiffness == times * guard.deformation && branch.base == times * guard.constant;
    return of_force || (guard.deformation == 0.0 && guard.constant == 0.0);
  });
}

}  // namespace

bool Rubbing::takes_friction(const ContactLaw& normal) {
  if (normal.restitution()) return false;
  const LawState closed = normal.next({}, 0, 0.0, 0.0, 1.0);
  const Branch branch = normal.branch(closed);
  if (!branch.linear || !ends_before_it_pulls(branch)) return false;
  for (std::size_t g = 0; g < branch.guard_count; ++g) {
    const Branch after = normal.branch(normal.next(closed, g, 1.0, 1.0, -1.0));
    if (after.bodies == Bodies::apart) continue;
    const bool creeps =
        !after.touching() && std::none_of(after.guards, after.guards + after.guard_count, of_sign_alone);
    if (creeps || !after.linear || !ends_before_it_pulls(after)) return false;
  }
  return true;
}

Rubbing::Rubbing(std::shared_ptr<const ContactLaw> normal, double friction, double tangential_stiffness)
    : normal_(std::move(normal)), friction_(friction), tangential_stiffness_(tangential_stiffness) {
  require_not_negative("friction", friction);
  if (!takes_friction(*normal_)) {
    throw InvalidParameter("friction", std::to_string(friction),
                           "goes with contact whose force has straight branches and never pulls");
  }
  require_positive("tangential_stiffness", tangential_stiffness);
}

bool Rubbing::same_as(const CoupledLaw& other) const {
  const auto* rubbing = dynamic_cast<const Rubbing*>(&other);
  return rubbing != nullptr && rubbing->friction_ == friction_ &&
         rubbing->tangential_stiffness_ == tangential_stiffness_ && normal_->name() == rubbing->normal_->name() &&
         normal_->parameters() == rubbing->normal_->parameters();
}

int Rubbing::sense_of(Friction friction) {
  return friction == Friction::slides_up ? 1 : friction == Friction::slides_down ? -1 : 0;
}

Rubbing::Friction Rubbing::sliding(double sense) { return sense > 0.0 ? Friction::slides_up : Friction::slides_down; }

CoupledState Rubbing::state_of(const Phase& phase) {
  const LawState& law = phase.normal;
  constexpr auto remembered = static_cast<Index>(std::tuple_size_v<decltype(LawState::memory)>);
  MatrixXd memory(2, (own_numbers + remembered + 1) / 2);
  double* to = memory.data();
  for (const double own :
       {static_cast<double>(phase.friction), phase.origin, phase.grows ? 1.0 : 0.0, static_cast<double>(phase.slid),
        static_cast<double>(phase.zeros), static_cast<double>(law.branch), law.closing_speed}) {
    *to++ = own;
  }
  std::copy(law.memory.begin(), law.memory.end(), to);
  return {law.since, memory};
}

Rubbing::Phase Rubbing::phase_of(const CoupledState& state) {
  const double* from = state.memory.data();
  Phase phase{.friction = static_cast<Friction>(static_cast<int>(from[0])),
              .origin = from[1],
              .grows = from[2] != 0.0,
              .slid = static_cast<int>(from[3]),
              .zeros = static_cast<int>(from[4]),
              .normal = {.branch = static_cast<int>(from[5]), .since = state.since, .closing_speed = from[6]}};
  std::copy_n(from + own_numbers, phase.normal.memory.size(), phase.normal.memory.begin());
  return phase;
}

LawState Rubbing::normal_state(const CoupledState& state) const { return phase_of(state).normal; }

CoupledState Rubbing::passed(const CoupledState& state, double time) const {
  Phase phase = phase_of(state);
  if (normal_->branch(phase.normal).bodies != Bodies::apart) phase = {.normal = {.since = time}};
  phase.friction = Friction::passed;
  return state_of(phase);
}

CoupledState Rubbing::returned(const CoupledState& state) const {
  Phase phase = phase_of(state);
  phase.friction = Friction::none;
  return state_of(phase);
}

int Rubbing::slides(const CoupledState& state) const { return sense_of(phase_of(state).friction); }

CoupledState Rubbing::begin(const VectorXd& /*deformation*/) const { return state_of({}); }

/// Guards of the law of F_n come first, in its order.
CoupledBranch Rubbing::branch(const CoupledState& state) const {
  const Phase at = phase_of(state);
  const Branch normal = normal_->branch(at.normal);
  CoupledSet set;
  CoupledBranch result{nullptr, VectorXd::Zero(2), {}};
  if (normal.bodies == Bodies::apart) {
    set.own = {0};
    set.over.resize(1, 0);
    result.guards.push_back({.sense = at.friction == Friction::passed ? 1.0 : -1.0, .deformation = 0});
    result.set = std::make_shared<const CoupledSet>(std::move(set));
    return result;
  }
  set.moving = {0, 1};
  set.stiffness = MatrixXd::Zero(2, 2);
  const auto row = [&set](double of_penetration, double of_slip) -> Index {
    if (of_penetration == 0.0 && of_slip == 0.0) return -1;
    set.own.push_back(-1);
    set.over.conservativeResize(std::ssize(set.own), 2);
    set.over.bottomRows(1) << of_penetration, of_slip;
    return set.over.rows() - 1;
  };
  for (std::size_t g = 0; g < normal.guard_count; ++g) {
    const Guard& guard = normal.guards[g];
    result.guards.push_back({.constant = guard.constant,
                             .size = std::abs(guard.constant),
                             .deformation = row(guard.deformation, 0),
                             .speed = row(guard.speed, 0)});
  }
  const double k = normal.stiffness, c = normal.damping, mu = friction_, kt = tangential_stiffness_;
  set.stiffness(0, 0) = k;
  if (c != 0.0) {
    set.damping = MatrixXd::Zero(2, 2);
    set.damping(0, 0) = c;
  }
  result.base(0) = normal.base;
  if (at.friction == Friction::sticks) {
    result.base(1) = -kt * at.origin;
    set.stiffness(1, 1) = kt;
    for (const int sense : {1, -1}) {
      result.guards.push_back({.of = sense,
                               .constant = mu * normal.base + sense * kt * at.origin,
                               .size = mu * std::abs(normal.base) + kt * std::abs(at.origin),
                               .deformation = row(mu * k, -sense * kt),
                               .speed = row(mu * c, 0),
                               .zeros = at.slid == sense ? at.zeros : (at.grows ? 1 : 0)});
    }
  } else if (const double sense = sense_of(at.friction); sense != 0.0) {
    result.base(1) = sense * mu * normal.base;
    set.stiffness(1, 0) = sense * mu * k;
    if (c != 0.0) set.damping(1, 0) = sense * mu * c;
    result.guards.push_back({.speed = row(-mu * k / kt, sense), .acceleration = row(-mu * c / kt, 0)});
  }
  result.set = std::make_shared<const CoupledSet>(std::move(set));
  return result;
}

/// A push begins (P-13).
void Rubbing::stick(Phase& phase, const Branch& normal, const CoupledMotion& motion) const {
  if (friction_ == 0.0) return;
  phase.origin = motion.deformation(1);
  phase.friction = Friction::sticks;
  const double speed = motion.speed(1);
  const double needed = friction_ * std::max(push_rate(normal, motion), 0.0);
  if (phase.grows && tangential_stiffness_ * std::abs(speed) > needed) phase.friction = sliding(speed);
}

/// A guard of the law of F_n has failed.
void Rubbing::change_normal(Phase& phase, const Branch& before, std::size_t guard, double time,
                            const CoupledMotion& motion) const {
  const double depth = of_sign_alone(before.guards[guard]) ? 0.0 : motion.deformation(0);
  phase.normal = normal_->next(phase.normal, guard, time, depth, motion.speed(0));
  const Branch after = normal_->branch(phase.normal);
  if (!pushes(after)) {
    phase.friction = Friction::none;
    phase.origin = 0.0;
  } else if (!pushes(before)) {
    // From zero, but that of a dashpot, or of what overlaps from the start.
    phase.grows = before.bodies != Bodies::apart || (after.damping == 0.0 && time > 0.0);
    stick(phase, after, motion);
  }
}

CoupledState Rubbing::next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard, double time,
                           const CoupledMotion& motion) const {
  Phase phase = phase_of(state);
  const Branch normal = normal_->branch(phase.normal);
  phase.grows = false;
  phase.slid = phase.zeros = 0;
  if (guard < normal.guard_count) {
    change_normal(phase, normal, guard, time, motion);
  } else if (phase.friction == Friction::sticks) {
    phase.friction = sliding(static_cast<double>(branch.guards[guard].of));
  } else {
    phase.slid = sense_of(phase.friction);
    phase.origin = motion.deformation(1) - phase.slid * friction_ * push_of(normal, motion) / tangential_stiffness_;
    phase.friction = Friction::sticks;
    // Its rate may have jumped below zero, with δ̈.
    const double slip = phase.slid * motion.speed(1);
    const double limit = friction_ * push_rate(normal, motion) / tangential_stiffness_;
    phase.zeros = std::abs(slip - limit) <= at_its_end * (std::abs(slip) + std::abs(limit)) ? 2 : 1;
  }
  return state_of(phase);
}

CoupledState Rubbing::settle(const CoupledState& state, double /*time*/, const CoupledMotion& /*motion*/) const {
  Phase phase = phase_of(state);
  phase.grows = false;
  phase.slid = phase.zeros = 0;
  return state_of(phase);
}

CoupledState Rubbing::at(const CoupledState& state, const VectorXd& /*deformation*/) const { return state; }

double Rubbing::stored_energy(const CoupledState& state, const VectorXd& deformation) const {
  return normal_->stored_energy(phase_of(state).normal, deformation(0));
}

double Rubbing::lost_energy(const CoupledState& /*state*/, const VectorXd& /*deformation*/) const { return 0.0; }

}  // namespace bentur
