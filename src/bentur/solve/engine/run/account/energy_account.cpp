#include "bentur/solve/engine/run/account/energy_account.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "bentur/solve/engine/run/sampler.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Gauss = boost::math::quadrature::gauss<double, 15>;

std::array<Eigen::VectorXd*, 7> all_curves(EnergyHistories& of) {
  return {&of.input, &of.kinetic, &of.strain, &of.damping, &of.hysteretic, &of.contact_stored, &of.contact_lost};
}

}  // namespace

EnergyAccount::EnergyAccount(const ModalSystem& system, double duration, double output_step, const State& start,
                             const Elements& elements)
    : system_(&system), step_(output_step), state_(start) {
  if (output_step > 0.0) count_ = sample_count(duration, output_step);
  for (auto* curve : all_curves(audit_.histories)) curve->setZero(count_);
  sums_.others = elements.initial_work();
  sums_.input = kinetic(state_) + strain(state_) + sums_.others;
  audit_.peak_input = std::abs(sums_.input);
}

double EnergyAccount::kinetic(const State& state) const {
  return 0.5 * system_->of_mode.cwiseProduct(state.v).squaredNorm();
}

double EnergyAccount::strain(const State& state) const {
  return 0.5 * system_->omega_squared.cwiseProduct(state.q).dot(state.q);
}

double EnergyAccount::ground_speed(Index i, const State& state) const {
  const ModalSystem::Relation& of = system_->elements[i].relation;
  return (of.left_row + of.left_push).dot(state.v.segment(of.left_begin, of.left_size)) +
         (of.right_row + of.right_push).dot(state.v.segment(of.right_begin, of.right_size));
}

void EnergyAccount::integrate(const Expansion& motion, double from, double to, const std::vector<GroundInput>& inputs,
                              const Elements& elements) {
  if (!(to > from)) return;
  const auto add = [&](double s, double weight) {
    motion.evaluate(s, state_);
    inputs_ = inputs;
    system_->advance(inputs_, s * motion.h());
    for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
      const auto& block = system_->blocks[b];
      const Index modes = block.modes;
      const auto speed = state_.v.segment(block.begin, modes);
      for (Index c = 0; c < system_->components(); ++c) {
        const double value = system_->of_body(inputs_, b)[c].value;
        sums_.input += weight * value * system_->gamma.col(c).segment(block.begin, modes).dot(speed);
      }
      sums_.damping +=
          weight * (block.damping ? speed.dot(block.damping->topLeftCorner(modes, modes) * speed)
                                  : speed.dot(system_->two_sigma.segment(block.begin, modes).cwiseProduct(speed)));
    }
    if (elements.forces().none()) return;
    elements.forces_at(state_, inputs_, forces_);
    for (Index i = 0; i < std::ssize(system_->elements); ++i) {
      const double force = forces_(i);
      if (force == 0.0) continue;
      double& taken = elements.two_bodies(i) ? sums_.contact : sums_.others;
      taken += weight * force * system_->elements[i].relation.along(state_.v);
      sums_.input += weight * force * ground_speed(i, state_);
    }
    sums_.dashpots += weight * elements.damping_power(state_);
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
                         const Elements& elements) {
  double from = 0.0;
  for (;;) {
    const double sample = static_cast<double>(taken_) * step_;
    if (taken_ >= count_ || sample > time + end * motion.h() + sample_slack * step_) break;
    const double s = std::clamp((sample - time) / motion.h(), from, end);
    integrate(motion, from, s, inputs, elements);
    motion.evaluate(s, state_);
    look(state_, elements, true);
    from = s;
  }
  integrate(motion, from, end, inputs, elements);
  motion.evaluate(end, state_);
  look(state_, elements, false);
}

void EnergyAccount::take_jumps(const Elements& elements, const State& state) {
  for (const Elements::Jump& jump : elements.jumps()) {
    sums_.contact += jump.energy_lost;
    sums_.input += jump.impulse * ground_speed(jump.element, state);
  }
}

void EnergyAccount::look(const State& state, const Elements& elements, bool sample) {
  const double moving = kinetic(state);
  const double bent = strain(state);
  audit_.peak_input = std::max(audit_.peak_input, std::abs(sums_.input));
  audit_.residual =
      std::max(audit_.residual, std::abs(sums_.input - moving - bent - sums_.damping - sums_.contact - sums_.others));
  if (!sample) return;
  const double stored = elements.stored_in_contacts(state);
  const double others = elements.stored_in_others(state);
  EnergyHistories& curves = audit_.histories;
  curves.time.push_back(static_cast<double>(taken_) * step_);
  curves.input(taken_) = sums_.input;
  curves.kinetic(taken_) = moving;
  curves.strain(taken_) = bent + others;
  curves.damping(taken_) = sums_.damping + sums_.dashpots;
  curves.hysteretic(taken_) = sums_.others - others - sums_.dashpots;
  curves.contact_stored(taken_) = stored;
  curves.contact_lost(taken_) = sums_.contact - stored;
  ++taken_;
}

EnergyAudit EnergyAccount::finish() {
  for (auto* curve : all_curves(audit_.histories)) curve->conservativeResize(taken_);
  return std::move(audit_);
}

}  // namespace bentur::engine
