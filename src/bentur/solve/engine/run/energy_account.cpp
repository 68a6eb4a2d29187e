#include "bentur/solve/engine/run/energy_account.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "bentur/solve/engine/run/sampler.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Gauss = boost::math::quadrature::gauss<double, 15>;

}  // namespace

EnergyAccount::EnergyAccount(const ModalSystem& system, const Problem& problem, double output_step)
    : system_(&system),
      step_(output_step),
      is_mode_(Eigen::VectorXd::Ones(system.size)),
      state_{system.initial_q, system.initial_v} {
  for (const auto& block : system.blocks) is_mode_(block.begin + block.size - 1) = 0.0;
  if (output_step > 0.0) count_ = sample_count(problem.duration, output_step);
  EnergyHistories& curves = audit_.histories;
  for (auto* curve : {&curves.input, &curves.kinetic, &curves.strain, &curves.damping, &curves.contact_stored,
                      &curves.contact_lost}) {
    curve->setZero(count_);
  }
  sums_.input = kinetic(state_) + strain(state_);
  audit_.peak_input = sums_.input;
}

double EnergyAccount::kinetic(const State& state) const { return 0.5 * is_mode_.cwiseProduct(state.v).squaredNorm(); }

double EnergyAccount::strain(const State& state) const {
  return 0.5 * system_->omega_squared.cwiseProduct(state.q).dot(state.q);
}

double EnergyAccount::ground_speed(Index i, const State& state) const {
  const auto& point = system_->points[i];
  return (point.sense_left - point.push_left).dot(state.v.segment(point.left_begin, point.left_size)) +
         (point.sense_right - point.push_right).dot(state.v.segment(point.right_begin, point.right_size));
}

void EnergyAccount::integrate(const Expansion& motion, double from, double to, const std::vector<GroundInput>& inputs,
                              const Contacts& contacts) {
  if (!(to > from)) return;
  const auto add = [&](double s, double weight) {
    motion.evaluate(s, state_);
    inputs_ = inputs;
    system_->advance(inputs_, s * motion.h());
    for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
      const auto& block = system_->blocks[b];
      const Index modes = block.size - 1;
      const auto speed = state_.v.segment(block.begin, modes);
      sums_.input += weight * inputs_[b].value * system_->gamma.segment(block.begin, modes).dot(speed);
      sums_.damping +=
          weight * (block.damping ? speed.dot(block.damping->topLeftCorner(modes, modes) * speed)
                                  : speed.dot(system_->two_sigma.segment(block.begin, modes).cwiseProduct(speed)));
    }
    if (contacts.forces().none()) return;
    contacts.forces_at(state_, inputs_, forces_);
    for (Index i = 0; i < std::ssize(system_->points); ++i) {
      const double force = forces_(i);
      if (force == 0.0) continue;
      sums_.contact -= weight * force * system_->points[i].sense(state_.v);
      sums_.input -= weight * force * ground_speed(i, state_);
    }
  };
  const double half = 0.5 * (to - from);
  const double mid = 0.5 * (from + to);
  const auto& abscissa = Gauss::abscissa();  // of [0, 1], the middle first
  const auto& weights = Gauss::weights();
  for (std::size_t n = 0; n < abscissa.size(); ++n) {
    const double weight = weights[n] * half * motion.h();
    add(mid + half * abscissa[n], weight);
    if (abscissa[n] != 0.0) add(mid - half * abscissa[n], weight);
  }
}

void EnergyAccount::take(const Expansion& motion, double time, double end, const std::vector<GroundInput>& inputs,
                         const Contacts& contacts) {
  double from = 0.0;
  for (;;) {
    const double sample = static_cast<double>(taken_) * step_;
    if (taken_ >= count_ || sample > time + end * motion.h() + sample_slack * step_) break;
    const double s = std::clamp((sample - time) / motion.h(), from, end);
    integrate(motion, from, s, inputs, contacts);
    motion.evaluate(s, state_);
    look(state_, contacts, true);
    from = s;
  }
  integrate(motion, from, end, inputs, contacts);
  motion.evaluate(end, state_);
  look(state_, contacts, false);
}

void EnergyAccount::take_jumps(const Contacts& contacts, const State& state) {
  for (const Contacts::Jump& jump : contacts.jumps()) {
    sums_.contact += jump.energy_lost;
    sums_.input -= jump.impulse * ground_speed(jump.point, state);
  }
}

void EnergyAccount::look(const State& state, const Contacts& contacts, bool sample) {
  const double moving = kinetic(state);
  const double bent = strain(state);
  audit_.peak_input = std::max(audit_.peak_input, std::abs(sums_.input));
  audit_.residual = std::max(audit_.residual, std::abs(sums_.input - moving - bent - sums_.damping - sums_.contact));
  if (!sample) return;
  const double stored = contacts.stored_energy(state);
  EnergyHistories& curves = audit_.histories;
  curves.input(taken_) = sums_.input;
  curves.kinetic(taken_) = moving;
  curves.strain(taken_) = bent;
  curves.damping(taken_) = sums_.damping;
  curves.contact_stored(taken_) = stored;
  curves.contact_lost(taken_) = sums_.contact - stored;
  ++taken_;
}

EnergyAudit EnergyAccount::finish() {
  EnergyHistories& curves = audit_.histories;
  for (auto* curve : {&curves.input, &curves.kinetic, &curves.strain, &curves.damping, &curves.contact_stored,
                      &curves.contact_lost}) {
    curve->conservativeResize(taken_);
  }
  return std::move(audit_);
}

}  // namespace bentur::engine
