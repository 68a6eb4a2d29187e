#include "bentur/solve/engine/motion/expansion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {

using Eigen::Index;

Expansion::Expansion(const ModalSystem& system, std::vector<double> offsets)
    : system_(&system),
      offsets_(std::move(offsets)),
      c_(Eigen::MatrixXd::Zero(system.size, highest_degree + 1)),
      rise_(Eigen::VectorXd::Zero(system.size)),
      acceleration_rise_(Eigen::VectorXd::Zero(system.size)),
      used_(static_cast<std::size_t>(system.size) / 4, 0),
      moving_(used_.begin(), used_.end()),
      resting_force_(system.elements.size()),
      deformations_(system.elements.size()),
      deformation_known_(system.elements.size(), 0) {}

Eigen::MatrixXd& Expansion::coefficients() {
  std::fill(used_.begin(), used_.end(), 1);
  return moving_coefficients();
}

Eigen::MatrixXd& Expansion::moving_coefficients() {
  std::fill(deformation_known_.begin(), deformation_known_.end(), 0);
  return c_;
}

void Expansion::hold_forces(std::size_t first, std::size_t end) {
  constexpr Index four = 4;
  for (std::size_t b = first; b < end; ++b) {
    const ModalSystem::Block& block = system_->blocks[b];
    for (Index j = block.begin + block.moving_size; j < block.begin + block.padded_size; j += four) {
      char& used = used_[static_cast<std::size_t>(j / four)];
      for (Index k = 2; used != 0 && k <= highest_degree; ++k) c_.block<four, 1>(j, k).setZero();
      used = 0;
    }
  }
}

Polynomial& Expansion::fill_deformation(Index element) {
  deformation_known_[element] = 1;
  deformations_[element].degree = degree_;
  return deformations_[element];
}

void Expansion::fill_forces(const ElementForces& forces) {
  for (const Index i : forces.pressing) {
    const Index at = system_->elements[i].force;
    if (at < 0) continue;
    note_moving(at);
    const Polynomial& delta = deformation(i);
    const double stiffness = forces.linear[i].stiffness;
    c_(at, 0) = forces.linear[i].base + stiffness * delta[0];
    for (int k = 1; k <= degree_; ++k) c_(at, k) = stiffness * delta[k];
  }
  for (const ElementForces::Coupled& of : forces.coupled) fill_coupled(of);
}

void Expansion::fill_coupled(const ElementForces::Coupled& of) {
  if (system_->elements[of.at().front()].force < 0) return;
  // All powers of four forces, one power after the other, and then of the next four.
  const kernels::PackedRows& pull = of.modal->packed_pull;
  const Index powers = degree_ + 1;
  if (const Index needed = pull.rows() * (highest_degree + 1); values_.size() < needed) {
    values_.resize(needed);
    none_.setZero(pull.rows());
    largest_.setZero(pull.rows());
  }
  kernels::raise_peaks(kernels::Peaks::of_values, pull, none_.data(), powers, c_.data() + of.modal->begin, c_.rows(),
                       largest_.data(), values_.data());
  for (Index n = 0; n < std::ssize(of.at()); ++n) {
    const Index to = system_->elements[of.at()[n]].force;
    note_moving(to);
    const double* from = values_.data() + n / 4 * 4 * powers + n % 4;
    double* force = c_.data() + to;
    force[0] = from[0] + of.base(n);
    for (Index k = 1; k < powers; ++k) force[k * c_.rows()] = from[4 * k];
  }
}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  h_ = h;
  degree_ = degree | 3;
  std::fill(moving_.begin(), moving_.end(), 0);
}

void Expansion::set_resting_force(Index element, const Polynomial& force) { resting_force_[element] = force; }

/// Hands on all coordinates that were filled, in fours that are all constant or not, those alike that stand side by
/// side together.
template <class Take>
void Expansion::in_ranges(const Take& take) const {
  constexpr Index four = 4;
  Index from = first_, to = first_;
  bool moves = true;
  const auto add = [&](Index end, bool as) {
    if (as != moves && to > from) take(from, to - from, moves);
    if (as != moves) from = to;
    moves = as;
    to = end;
  };
  for (const ModalSystem::Block& block : system_->blocks) {
    if (block.begin < first_ || block.begin >= first_ + count_) continue;
    add(block.begin + block.moving_size, true);
    for (Index j = to; j < block.begin + block.padded_size; j += four) {
      add(j + four, moving_[static_cast<std::size_t>(j / four)] != 0);
    }
  }
  if (to > from) take(from, to - from, moves);
}

bool Expansion::find_end(State& state, Eigen::VectorXd& acceleration) {
  double sum = 0.0;
  in_ranges([&](Index at, Index count, bool moves) {
    if (moves) {
      sum += kernels::end_of_step(count, c_.data() + at, c_.rows(), degree_, h_,
                                  {state.q.data() + at, state.v.data() + at, acceleration.data() + at},
                                  rise_.data() + at, acceleration_rise_.data() + at);
      return;
    }
    std::copy_n(c_.data() + at, count, state.q.data() + at);
    for (Eigen::VectorXd* of : {&state.v, &acceleration, &rise_, &acceleration_rise_}) {
      std::fill_n(of->data() + at, count, 0.0);
    }
  });
  if (!system_->coupled.empty()) end_acceleration_ = acceleration;
  return std::isfinite(sum);
}

void Expansion::evaluate(double s, State& state, Eigen::VectorXd* acceleration) const {
  in_ranges([&](Index at, Index count, bool moves) {
    double* bent = acceleration == nullptr ? nullptr : acceleration->data() + at;
    if (moves) {
      kernels::evaluate(count, c_.data() + at, c_.rows(), degree_, s, h_,
                        {state.q.data() + at, state.v.data() + at, bent});
      return;
    }
    std::copy_n(c_.data() + at, count, state.q.data() + at);
    std::fill_n(state.v.data() + at, count, 0.0);
    if (bent != nullptr) std::fill_n(bent, count, 0.0);
  });
}

void Expansion::find_speed_rise(Eigen::VectorXd& result) const {
  const double rate = 2.0 / (h_ * h_);
  result.resize(c_.rows());
  in_ranges([&](Index at, Index count, bool moves) {
    const auto part = [&](const auto& of) { return of.segment(at, count); };
    if (moves) {
      const auto apart = (part(end_acceleration_) - rate * part(c_.col(2))).cwiseAbs();
      result.segment(at, count) = 0.25 * h_ * (apart + 2.0 * part(acceleration_rise_));
    } else {
      result.segment(at, count).setZero();
    }
  });
}

const Polynomial& Expansion::deformation(Index i) const {
  Polynomial& p = deformations_[i];
  if (deformation_known_[i] != 0) return p;
  deformation_known_[i] = 1;
  const ModalSystem::Relation& relation = system_->elements[i].relation;
  p.degree = degree_;
  kernels::row_series({relation.right_size, relation.right_row.data(), c_.data() + relation.right_begin},
                      {relation.left_size, relation.left_row.data(), c_.data() + relation.left_begin}, c_.rows(),
                      degree_, p.coefficients.data());
  p[0] += offsets_[i];
  return p;
}

}  // namespace bentur::engine
