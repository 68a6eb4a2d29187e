#include "bentur/solve/motion/series.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;

Series::Series(const ModalSystem& system)
    : system_(&system), stiff_(system.size), damp_(system.size), force_(system.size) {}

int needed_degree(double rate_times_h) {
  // Longest products rate · h for which degrees 2, 3, … suffice, largest last; highest_degree serves series_reach.
  static const auto longest = [] {
    std::array<double, highest_degree + 1> products{};
    const double remainder = std::pow(series_reach, highest_degree + 1) / std::tgamma(highest_degree + 2.0);
    for (int n = 0; n <= highest_degree; ++n) {
      products[static_cast<std::size_t>(n)] = std::pow(remainder * std::tgamma(n + 2.0), 1.0 / (n + 1.0));
    }
    return products;
  }();
  constexpr int lowest = 6;  // the fourth derivatives have to be there
  const auto found = std::lower_bound(longest.begin() + lowest, longest.end() - 1, rate_times_h);
  return static_cast<int>(found - longest.begin());
}

/// Coefficient k of a_g h², to be asked for k = 0, 1, 2, …
double Series::Ground::next(int k) {
  double& a = k % 2 == 0 ? even : odd;
  if (k >= 2) a *= -nu_squared / (k * (k - 1.0));
  return a;
}

Series::Ground Series::ground(const GroundInput& input, double h) const {
  return {(system_->nu * h) * (system_->nu * h), input.value * h * h, input.slope * h * h * h};
}

void Series::begin(Index first, Index count, const State& state, double h, double rate, Expansion& motion) {
  h_ = h;
  c_ = &motion.coefficients();
  motion.begin(first, count, h, needed_degree(rate * h));
  c_->col(0).segment(first, count) = state.q.segment(first, count);
  c_->col(1).segment(first, count) = h * state.v.segment(first, count);
  stiff_.segment(first, count) = (h * h) * system_->omega_squared.segment(first, count);
  damp_.segment(first, count) = h * system_->two_sigma.segment(first, count);
}

/// (T-2) for the coordinates from `first` on, given force_; full damping has been added to force_.
void Series::recur(Index first, Index count, int k) {
  const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
  const double step = k + 1.0;
  const double* c0 = c_->col(k).data() + first;
  const double* c1 = c_->col(k + 1).data() + first;
  const double* stiff = stiff_.data() + first;
  const double* damp = damp_.data() + first;
  const double* force = force_.data() + first;
  double* c2 = c_->col(k + 2).data() + first;
  for (Index j = 0; j < count; ++j) c2[j] = (force[j] - stiff[j] * c0[j] - step * damp[j] * c1[j]) * scale;
}

void Series::add_full_damping(const ModalSystem::Block& block, int k) {
  auto force = force_.segment(block.begin, block.size);
  const auto speed = c_->col(k + 1).segment(block.begin, block.size);
  force.noalias() -= ((k + 1.0) * h_) * (*block.damping * speed);
  force += (k + 1.0) * damp_.segment(block.begin, block.size).cwiseProduct(speed);
}

/// F = base + k δ + c δ̇ with δ = −g, coefficient k of the power series, times h².
void Series::add_contact(std::size_t i, const ContactForces::Linear& linear, int k) {
  const auto& point = system_->points[i];
  double force = -linear.stiffness * (point.sense(c_->col(k)) + (k == 0 ? point.width : 0.0)) * h_ * h_;
  if (k == 0) force += linear.base * h_ * h_;
  if (linear.damping != 0.0) force -= linear.damping * (k + 1.0) * point.sense(c_->col(k + 1)) * h_;
  system_->push(i, force, force_);
}

/// Changes c_{k+2} so that the openings of the resting points have no coefficient k + 2.
void Series::hold(const std::vector<std::size_t>& resting, int k) {
  Eigen::VectorXd missing(static_cast<Index>(resting.size()));
  for (std::size_t n = 0; n < resting.size(); ++n) {
    missing(static_cast<Index>(n)) = -system_->points[resting[n]].sense(c_->col(k + 2));
  }
  const Eigen::VectorXd forces = system_->forces_for(resting, missing);
  force_ = c_->col(k + 2);
  for (std::size_t n = 0; n < resting.size(); ++n) {
    const double force = forces(static_cast<Index>(n));
    system_->push(resting[n], force, force_);
    resting_force_[n][k] = force * (k + 2.0) * (k + 1.0) / (h_ * h_);
  }
  c_->col(k + 2) = force_;
}

void Series::expand(const State& state, const std::vector<GroundInput>& inputs, double h, const ContactForces& forces,
                    Expansion& motion) {
  begin(0, system_->size, state, h, system_->rate(forces), motion);
  grounds_.clear();
  for (const GroundInput& input : inputs) grounds_.push_back(ground(input, h));
  resting_force_.resize(forces.resting.size());
  for (int k = 0; k + 2 <= motion.degree(); ++k) {
    if (k < 2 || system_->nu > 0.0) {
      for (std::size_t b = 0; b < inputs.size(); ++b) {
        const double a = grounds_[b].next(k);
        const auto& block = system_->blocks[b];
        const double* gamma = system_->gamma.data();
        for (Index j = block.begin; j < block.begin + block.size; ++j) force_[j] = gamma[j] * a;
      }
    } else {
      force_.setZero();
    }
    for (const std::size_t i : forces.pressing) add_contact(i, forces.linear[i], k);
    if (!system_->classical) {
      for (const auto& block : system_->blocks) {
        if (block.damping) add_full_damping(block, k);
      }
    }
    recur(0, system_->size, k);
    if (!forces.resting.empty()) hold(forces.resting, k);
  }
  for (std::size_t n = 0; n < forces.resting.size(); ++n) {
    resting_force_[n].degree = motion.degree() - 2;
    motion.set_resting_force(forces.resting[n], resting_force_[n]);
  }
}

void Series::expand_block(std::size_t b, const State& state, const GroundInput& input, double h, Expansion& motion) {
  const auto& block = system_->blocks[b];
  begin(block.begin, block.size, state, h, std::max(block.rate(), system_->nu), motion);
  Ground acceleration = ground(input, h);
  for (int k = 0; k + 2 <= motion.degree(); ++k) {
    force_.segment(block.begin, block.size) = acceleration.next(k) * system_->gamma.segment(block.begin, block.size);
    if (block.damping) add_full_damping(block, k);
    recur(block.begin, block.size, k);
  }
}

}  // namespace bentur::engine
