#include "bentur/solve/engine/run/coupled_elements.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double soon_part = 1e-7;       // of 1/ω of the fastest mode: an instant after an event
constexpr double begins_band = 0x1p-40;  // of a guard's coefficients, where it has been divided by powers of time

/// The deformation that is all a guard depends on.
Index only_one(const CoupledGuard& guard) {
  if (guard.speed.size() > 0 || guard.acceleration.size() > 0 || guard.deformation.size() == 0) return -1;
  Index found = -1;
  for (Index n = 0; n < guard.deformation.size(); ++n) {
    if (guard.deformation(n) == 0.0) continue;
    if (found >= 0) return -1;
    found = n;
  }
  return found;
}

/// What guards that depend on one deformation alone say of each.
std::vector<Branch> branches_of(const CoupledBranch& branch, Index count) {
  std::vector<Branch> branches(count);
  for (const CoupledGuard& guard : branch.guards) {
    const Index n = only_one(guard);
    if (n < 0 || branches[n].guard_count == Branch::most_guards) continue;
    branches[n] = branches[n].guarded_by({{.constant = guard.constant, .deformation = guard.deformation(n)}});
  }
  return branches;
}

double sum_of(const VectorXd& factors, const VectorXd& values) {
  return factors.size() > 0 ? factors.dot(values) : 0.0;
}

}  // namespace

std::vector<Branch> CoupledElements::first_branches(const ModalSystem& system) {
  std::vector<Branch> all;
  for (const ModalSystem::Coupled& of : system.coupled) {
    const CoupledState rest = of.law->begin(VectorXd::Zero(of.count));
    for (const Branch& branch : branches_of(of.law->branch(rest), of.count)) all.push_back(branch);
  }
  return all;
}

CoupledElements::CoupledElements(const ModalSystem& system, const std::vector<double>& offsets, const State& state)
    : system_(&system), offsets_(offsets), now_(system.coupled.size()) {
  double fastest = 0.0;
  for (const ModalSystem::Block& block : system.blocks) fastest = std::max(fastest, block.omega_max);
  soon_ = fastest > 0.0 ? soon_part / fastest : 0.0;
  for (const ModalSystem::Coupled& of : system.coupled) {
    std::vector<Index>& at = all_.emplace_back(of.count);
    std::iota(at.begin(), at.end(), of.first);
    states_.push_back(of.law->begin(deformation(all_.size() - 1, state)));
  }
}

void CoupledElements::watch(GuardMonitor& monitor) {
  monitor_ = &monitor;
  for (std::size_t e = 0; e < states_.size(); ++e) enter(e);
}

/// Works out the branch of a state.
void CoupledElements::enter(std::size_t e) {
  const ModalSystem::Coupled& of = system_->coupled[e];
  Now& now = now_[e];
  now.branch = of.law->branch(states_[e]);
  now.begins = true;
  now.only.clear();
  now.at.clear();
  for (const Index n : now.branch.moving) now.at.push_back(of.first + n);
  now.may_fly = now.branch.moving.empty();
  const std::vector<Branch> branches = branches_of(now.branch, of.count);
  std::vector<char> watched(of.count, 0);
  for (Index n = 0; n < of.count; ++n) watched[n] = monitor_->enter(of.first + n, branches[n]) ? 1 : 0;
  for (const CoupledGuard& guard : now.branch.guards) {
    const Index only = only_one(guard);
    now.only.push_back(only >= 0 && watched[only] != 0 ? only : -1);
    now.may_fly = now.may_fly && now.only.back() >= 0;
  }
}

VectorXd CoupledElements::deformation(std::size_t e, const State& state) const {
  return system_->deformations(all_[e], offsets_, state.q);
}

CoupledMotion CoupledElements::motion_of(std::size_t e, const State& state, const VectorXd& acceleration) const {
  return {deformation(e, state), system_->speeds(all_[e], state.v), system_->speeds(all_[e], acceleration), soon_};
}

bool CoupledElements::gather(ElementForces& forces, State& state) const {
  forces.coupled.clear();
  bool may_fly = true;
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const Now& now = now_[e];
    const Index first = system_->coupled[e].first;
    may_fly = may_fly && now.may_fly;
    for (Index n = 0; n < system_->coupled[e].count; ++n) {
      const ModalSystem::Element& element = system_->elements[first + n];
      forces.linear[first + n] = {.base = now.branch.base(n)};
      if (element.force < 0) continue;
      state.q(element.force) = now.branch.base(n);
      state.v(element.force) = 0.0;
    }
    std::vector<char> moves(system_->coupled[e].count, 0);
    for (const Index n : now.branch.moving) moves[n] = 1;
    for (std::size_t n = 0; n < moves.size(); ++n) {
      if (moves[n] == 0 && now.branch.base(static_cast<Index>(n)) != 0.0) {
        forces.constant.push_back(first + static_cast<Index>(n));
      }
    }
    if (now.at.empty()) continue;
    forces.coupled.push_back({now.at, now.branch.base(now.branch.moving), now.branch.stiffness, now.branch.damping});
    system_->fill_forces(forces.coupled.back(), offsets_, state);
  }
  return may_fly;
}

void CoupledElements::add_forces(const State& state, VectorXd& forces) const {
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const Now& now = now_[e];
    forces.segment(system_->coupled[e].first, system_->coupled[e].count) = now.branch.base;
    if (now.at.empty()) continue;
    const CoupledBranch& branch = now.branch;
    forces(now.at) += branch.stiffness * system_->deformations(now.at, offsets_, state.q);
    if (branch.damping.size() > 0) forces(now.at) += branch.damping * system_->speeds(now.at, state.v);
  }
}

double CoupledElements::band(std::size_t e, const CoupledGuard& guard, const State& state, const Bands& bands) const {
  double result = bands.part * std::max(std::abs(guard.constant), guard.size);
  const Index first = system_->coupled[e].first;
  for (Index n = 0; n < guard.deformation.size(); ++n) {
    result += std::abs(guard.deformation(n)) * bands.displacement[first + n];
  }
  for (Index n = 0; n < guard.speed.size(); ++n) {
    if (guard.speed(n) == 0.0) continue;
    result += bands.part * std::abs(guard.speed(n)) * system_->elements[first + n].relation.along_abs(state.v);
  }
  return result;
}

std::optional<CoupledElements::Event> CoupledElements::next_event(const Expansion& motion, const State& from,
                                                                  const Bands& bands,
                                                                  const GuardMonitor& monitor) const {
  std::optional<Event> found;
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const Now& now = now_[e];
    const Index first = system_->coupled[e].first;
    for (std::size_t g = 0; g < now.branch.guards.size(); ++g) {
      const CoupledGuard& guard = now.branch.guards[g];
      const int zeros = now.begins ? guard.zeros : 0;
      if (zeros == 0 && now.only[g] >= 0 && monitor.stays(first + now.only[g])) continue;
      Polynomial p;
      p.degree = motion.degree();
      double size = 0.0;
      const auto add = [&](int k, double term) {
        p[k] += term;
        size += std::abs(term);
      };
      for (Index n = 0; n < guard.deformation.size(); ++n) {
        if (guard.deformation(n) == 0.0) continue;
        const Polynomial& delta = motion.deformation(first + n);
        for (int k = 0; k <= p.degree; ++k) add(k, guard.deformation(n) * delta[k]);
      }
      for (Index n = 0; n < guard.speed.size(); ++n) {
        if (guard.speed(n) == 0.0) continue;
        const Polynomial& delta = motion.deformation(first + n);
        for (int k = 0; k < p.degree; ++k) add(k, guard.speed(n) * (k + 1.0) * delta[k + 1] / motion.h());
      }
      for (Index n = 0; n < guard.acceleration.size(); ++n) {
        if (guard.acceleration(n) == 0.0) continue;
        const Polynomial bent = second_derivative(motion.deformation(first + n), 1.0 / (motion.h() * motion.h()));
        for (int k = 0; k <= bent.degree; ++k) add(k, guard.acceleration(n) * bent[k]);
      }
      double slack = band(e, guard, from, bands);
      if (guard.acceleration.size() > 0) slack += bands.part * size;
      std::optional<double> s;
      if (zeros > 0) {
        for (int k = 0; k <= p.degree; ++k) p[k] = k + zeros <= p.degree ? p[k + zeros] : 0.0;
        s = first_negative(p, 1.0, begins_band * size + slack);
      } else {
        p[0] += guard.constant;
        const bool at_zero = p[0] + slack < 0.0 && p[0] + slack >= -bands.start_slack * slack;
        s = first_negative(p, 1.0, at_zero ? -p[0] : slack);
      }
      if (s && (!found || *s < found->s)) found = Event{e, g, *s};
    }
  }
  return found;
}

std::optional<CoupledElements::Event> CoupledElements::due(const State& state, const VectorXd& acceleration,
                                                           const Bands& bands) const {
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const VectorXd delta = deformation(e, state);
    const VectorXd speed = system_->speeds(all_[e], state.v);
    const VectorXd bent = system_->speeds(all_[e], acceleration);
    for (std::size_t g = 0; g < now_[e].branch.guards.size(); ++g) {
      const CoupledGuard& guard = now_[e].branch.guards[g];
      const double value = guard.constant + sum_of(guard.deformation, delta) + sum_of(guard.speed, speed) +
                           sum_of(guard.acceleration, bent);
      if (value < -band(e, guard, state, bands)) return Event{e, g, 1.0};
    }
  }
  return std::nullopt;
}

void CoupledElements::go_on() {
  for (Now& now : now_) now.begins = false;
}

void CoupledElements::change(const Event& event, double time, const State& state, const VectorXd& acceleration) {
  const std::size_t e = event.element;
  states_[e] = system_->coupled[e].law->next(states_[e], event.guard, time, motion_of(e, state, acceleration));
  enter(e);
}

void CoupledElements::settle(double time, const State& state, const VectorXd& acceleration) {
  for (std::size_t e = 0; e < states_.size(); ++e) {
    states_[e] = system_->coupled[e].law->settle(states_[e], time, motion_of(e, state, acceleration));
    enter(e);
  }
}

void CoupledElements::resume(const std::vector<CoupledState>& states) {
  states_ = states;
  for (std::size_t e = 0; e < states_.size(); ++e) enter(e);
  go_on();  // their branches began before
}

std::vector<CoupledState> CoupledElements::states_at(const State& state) const {
  std::vector<CoupledState> result;
  for (std::size_t e = 0; e < states_.size(); ++e) {
    result.push_back(system_->coupled[e].law->at(states_[e], deformation(e, state)));
  }
  return result;
}

double CoupledElements::stored_energy(const State& state) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < states_.size(); ++e) {
    sum += system_->coupled[e].law->stored_energy(states_[e], deformation(e, state));
  }
  return sum;
}

double CoupledElements::lost_energy(const State& state) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < states_.size(); ++e) {
    sum += system_->coupled[e].law->lost_energy(states_[e], deformation(e, state));
  }
  return sum;
}

}  // namespace bentur::engine
