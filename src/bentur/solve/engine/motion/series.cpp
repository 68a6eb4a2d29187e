#include "bentur/solve/engine/motion/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bentur::engine {

using Eigen::Index;

Series::Series(const ModalSystem& system, std::vector<double> offsets)
    : system_(&system), offsets_(std::move(offsets)), stiff_(system.size), damp_(system.size), force_(system.size) {}

int needed_degree(double rate_times_h) {
  // Longest products rate · h for which degrees 3, 7, … suffice, largest last; highest_degree serves series_reach.
  static const auto longest = [] {
    std::array<double, (highest_degree + 1) / 4> products{};
    const double remainder = std::pow(series_reach, highest_degree + 1) / std::tgamma(highest_degree + 2.0);
    for (std::size_t n = 0; n < products.size(); ++n) {
      const double terms = 4.0 * static_cast<double>(n + 1);
      products[n] = std::pow(remainder * std::tgamma(terms + 1.0), 1.0 / terms);
    }
    return products;
  }();
  int degree = 7;  // the fourth derivatives have to be there
  while (degree < highest_degree && longest[degree / 4] < rate_times_h) degree += 4;
  return degree;
}

/// Of one body more, whose first input is given.
void Series::note_ground(std::size_t b, const GroundInput* input, double h) {
  const auto& block = system_->blocks[b];
  for (Index c = 0; c < system_->components(); ++c, ++input) {
    const double phase = system_->nu[c] * h;
    kernels::GroundSeries& ground = c == 0 ? grounds_.emplace_back() : further_.emplace_back();
    ground.begin = block.begin;
    ground.size = block.moving_size;
    ground.even = input->value * h * h;
    ground.odd = input->slope * h * h * h;
    ground.nu_squared = phase * phase;
    ground.gamma = system_->gamma.col(c).data();
  }
}

/// Of some bodies, whose first input is given.
[[gnu::flatten]] void Series::note_grounds(std::size_t first, std::size_t end, const GroundInput* input, double h) {
  grounds_.clear();
  further_.clear();
  for (std::size_t b = first; b < end; ++b, input += system_->components()) note_ground(b, input, h);
}

void Series::begin(Index first, Index count, const State& state, double h, double rate, Expansion& motion) {
  h_ = h;
  c_ = &motion.moving_coefficients();
  motion.begin(first, count, h, needed_degree(rate * h));
  kernels::begin_series(count, {system_->omega_squared.data() + first, system_->two_sigma.data() + first},
                        state.q.data() + first, state.v.data() + first, h, system_->size, stiff_.data() + first,
                        damp_.data() + first, c_->data() + first);
}

void Series::add_full_damping(const ModalSystem::Block& block, int k) {
  auto force = force_.segment(block.begin, block.size);
  const auto speed = c_->col(k + 1).segment(block.begin, block.size);
  force.noalias() -= ((k + 1.0) * h_) * (*block.damping * speed);
  force += (k + 1.0) * damp_.segment(block.begin, block.size).cwiseProduct(speed);
}

/// h² times a load, of some coordinates.
const double* Series::scaled(const double* load, Index first, Index count) {
  if (load == nullptr) return nullptr;
  load_.resize(system_->size);
  for (Index j = first; j < first + count; ++j) load_[j] = h_ * h_ * load[j];
  return load_.data();
}

/// F = base + k δ + c δ̇, coefficient k of the power series, times h².
void Series::add_pressing(Index i, const ElementForces::Linear& linear, int k) {
  const ModalSystem::Relation& relation = system_->elements[i].relation;
  double force = linear.stiffness * (relation.along(c_->col(k).data()) + (k == 0 ? offsets_[i] : 0.0)) * h_ * h_;
  if (k == 0) force += linear.base * h_ * h_;
  if (linear.damping != 0.0) force += linear.damping * (k + 1.0) * relation.along(c_->col(k + 1).data()) * h_;
  system_->push(i, force, force_);
}

/// The same of several elements, whose deformations act on one another.
void Series::add_coupled(const ElementForces::Coupled& of, int k) {
  const Index count = std::ssize(of.at());
  along_.resize(count);
  const auto take = [&](int power) {
    for (Index n = 0; n < count; ++n) along_(n) = system_->elements[of.at()[n]].relation.along(c_->col(power).data());
  };
  take(k);
  pushes_.noalias() = of.stiffness() * along_;
  pushes_ *= h_ * h_;
  if (k == 0) pushes_ += h_ * h_ * of.base;
  if (of.damping().size() > 0) {
    take(k + 1);
    pushes_ += h_ * (k + 1.0) * (of.damping() * along_);
  }
  for (Index n = 0; n < count; ++n) system_->push(of.at()[n], pushes_(n), force_);
}

/// Changes c_{k+2} so that δ of the resting elements has no coefficient k + 2.
void Series::hold(const std::vector<Index>& resting, int k) {
  Eigen::VectorXd missing(std::ssize(resting));
  for (Index n = 0; n < missing.size(); ++n) {
    missing(n) = system_->elements[resting[n]].relation.along(c_->col(k + 2).data());
  }
  const Eigen::VectorXd forces = system_->forces_for(resting, missing);
  force_ = c_->col(k + 2);
  for (Index n = 0; n < forces.size(); ++n) {
    const double force = forces(n);
    system_->push(resting[n], force, force_);
    resting_force_[n][k] = force * (k + 2.0) * (k + 1.0) / (h_ * h_);
  }
  c_->col(k + 2) = force_;
}

void Series::expand(const State& state, const std::vector<GroundInput>& inputs, double h, const ElementForces& forces,
                    Expansion& motion) {
  begin(0, system_->size, state, h, forces.rate, motion);
  note_grounds(0, system_->blocks.size(), inputs.data(), h);
  const double* load = scaled(forces.load_or_null(), 0, system_->size);
  const bool damped = std::any_of(forces.coupled.begin(), forces.coupled.end(),
                                  [](const ElementForces::Coupled& of) { return of.damping().size() > 0; });
  if (!system_->classical || !forces.resting.empty() || damped) {
    expand_term_by_term(0, system_->size, load, forces, motion);
  } else {
    note_pressing(forces.pressing, forces.linear, h, motion);
    tied_.clear();
    for (const ElementForces::Coupled& of : forces.coupled) {
      const ElementForces::Coupled::Modal& modal = *of.modal;
      tied_.push_back({modal.begin, modal.push.rows(), modal.push.cols(),
                       modal.tied.size() > 0 ? modal.tied.data() : nullptr, modal.pull.data(), modal.push.data(),
                       of.steady.data(), h * h});
    }
    // First, as what ties bodies looks at what lies between them.
    motion.hold_forces(0, system_->blocks.size());
    kernels::expand({stiff_.data(), damp_.data(), system_->gamma.data(), load, further_}, grounds_, pressing_, tied_,
                    motion.degree(), system_->size, c_->data());
  }
  motion.fill_forces(forces);
}

void Series::note_pressing(const std::vector<Index>& pressing, const std::vector<ElementForces::Linear>& linear,
                           double h, Expansion& motion) {
  pressing_.clear();
  for (const Index i : pressing) {
    const ModalSystem::Relation& of = system_->elements[i].relation;
    pressing_.push_back({of.left_begin, of.left_size, of.right_begin, of.right_size, of.left_row.data(),
                         of.right_row.data(), of.left_push.data(), of.right_push.data(), offsets_[i],
                         linear[i].base * h * h, linear[i].stiffness * h * h, linear[i].damping * h,
                         motion.fill_deformation(i).coefficients.data()});
  }
}

void Series::expand_some(const std::vector<Index>& bodies, const State& state, const std::vector<GroundInput>& inputs,
                         double h, double rate, const std::vector<Index>& pressing,
                         const std::vector<ElementForces::Linear>& linear, Expansion& motion) {
  grounds_.clear();
  further_.clear();
  for (const Index b : bodies) {
    begin(system_->blocks[b].begin, system_->blocks[b].padded_size, state, h, rate, motion);
    note_ground(static_cast<std::size_t>(b), inputs.data() + b * system_->components(), h);
  }
  note_pressing(pressing, linear, h, motion);
  kernels::expand({stiff_.data(), damp_.data(), system_->gamma.data(), nullptr, further_}, grounds_, pressing_, {},
                  motion.degree(), system_->size, c_->data());
}

/// The same with full damping matrices and resting points.
void Series::expand_term_by_term(Index first, Index count, const double* load, const ElementForces& forces,
                                 Expansion& motion) {
  resting_force_.resize(forces.resting.size());
  for (int k = 0; k + 2 <= motion.degree(); ++k) {
    force_.segment(first, count).setZero();
    for (kernels::GroundSeries& ground : grounds_) {
      const double a = ground.next(k);
      force_.segment(ground.begin, ground.size) = a * system_->gamma.col(0).segment(ground.begin, ground.size);
    }
    for (kernels::GroundSeries& ground : further_) {
      const Eigen::Map<const Eigen::VectorXd> gamma(ground.gamma + ground.begin, ground.size);
      force_.segment(ground.begin, ground.size) += ground.next(k) * gamma;
    }
    if (k == 0 && load != nullptr) {
      for (Index j = first; j < first + count; ++j) force_(j) += load[j];
    }
    for (const Index i : forces.pressing) add_pressing(i, forces.linear[i], k);
    for (const ElementForces::Coupled& of : forces.coupled) add_coupled(of, k);
    for (const auto& block : system_->blocks) {
      if (block.damping && block.begin >= first && block.begin < first + count) add_full_damping(block, k);
    }
    c_->col(k + 2).segment(first, count) =
        (force_.segment(first, count) - stiff_.segment(first, count).cwiseProduct(c_->col(k).segment(first, count)) -
         (k + 1.0) * damp_.segment(first, count).cwiseProduct(c_->col(k + 1).segment(first, count))) /
        ((k + 2.0) * (k + 1.0));
    if (!forces.resting.empty()) hold(forces.resting, k);
  }
  for (std::size_t n = 0; n < forces.resting.size(); ++n) {
    resting_force_[n].degree = motion.degree() - 2;
    resting_force_[n][motion.degree() - 1] = resting_force_[n][motion.degree()] = 0.0;
    motion.set_resting_force(forces.resting[n], resting_force_[n]);
  }
}

void Series::expand_block(std::size_t b, const State& state, const GroundInput* input, double h, double rate,
                          Expansion& motion) {
  const auto& block = system_->blocks[b];
  begin(block.begin, block.padded_size, state, h, rate, motion);
  note_grounds(b, b + 1, input, h);
  const double* load = scaled(system_->load_of(b, state.q.data(), force_), block.begin, block.padded_size);
  if (block.damping) {
    expand_term_by_term(block.begin, block.padded_size, load, {}, motion);
    return;
  }
  kernels::expand({stiff_.data(), damp_.data(), system_->gamma.data(), load, further_}, grounds_, {}, {},
                  motion.degree(), system_->size, c_->data());
  motion.hold_forces(b, b + 1);
}

}  // namespace bentur::engine
