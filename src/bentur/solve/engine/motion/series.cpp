#include "bentur/solve/engine/motion/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bentur::engine {

using Eigen::Index;

Series::Series(const ModalSystem& system, std::vector<double> widths)
    : system_(&system), widths_(std::move(widths)), stiff_(system.size), damp_(system.size), force_(system.size) {}

int needed_degree(double rate_times_h) {
  // Longest products rate · h for which degrees 2, 3, … suffice, largest last; highest_degree serves series_reach.
  static const auto longest = [] {
    std::array<double, highest_degree + 1> products{};
    const double remainder = std::pow(series_reach, highest_degree + 1) / std::tgamma(highest_degree + 2.0);
    for (int n = 0; n <= highest_degree; ++n) {
      products[n] = std::pow(remainder * std::tgamma(n + 2.0), 1.0 / (n + 1.0));
    }
    return products;
  }();
  constexpr int lowest = 6;  // the fourth derivatives have to be there
  const auto found = std::lower_bound(longest.begin() + lowest, longest.end() - 1, rate_times_h);
  return static_cast<int>(found - longest.begin());
}

kernels::GroundSeries Series::ground(std::size_t b, const GroundInput& input, double h) const {
  const auto& block = system_->blocks[b];
  return {block.begin, block.padded_size, input.value * h * h, input.slope * h * h * h,
          (system_->nu * h) * (system_->nu * h)};
}

void Series::begin(Index first, Index count, const State& state, double h, double rate, Expansion& motion) {
  h_ = h;
  c_ = &motion.coefficients();
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

/// F = base + k δ + c δ̇ with δ = −g, coefficient k of the power series, times h².
void Series::add_contact(Index i, const ContactForces::Linear& linear, int k) {
  const auto& point = system_->points[i];
  double force = -linear.stiffness * (point.sense(c_->col(k).data()) + (k == 0 ? widths_[i] : 0.0)) * h_ * h_;
  if (k == 0) force += linear.base * h_ * h_;
  if (linear.damping != 0.0) force -= linear.damping * (k + 1.0) * point.sense(c_->col(k + 1).data()) * h_;
  system_->push(i, force, force_);
}

/// Changes c_{k+2} so that the openings of the resting points have no coefficient k + 2.
void Series::hold(const std::vector<Index>& resting, int k) {
  Eigen::VectorXd missing(std::ssize(resting));
  for (Index n = 0; n < missing.size(); ++n) {
    missing(n) = -system_->points[resting[n]].sense(c_->col(k + 2).data());
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

void Series::expand(const State& state, const std::vector<GroundInput>& inputs, double h, const ContactForces& forces,
                    Expansion& motion) {
  begin(0, system_->size, state, h, system_->rate(forces), motion);
  grounds_.clear();
  for (std::size_t b = 0; b < inputs.size(); ++b) grounds_.push_back(ground(b, inputs[b], h));
  if (!system_->classical || !forces.resting.empty()) {
    expand_term_by_term(0, system_->size, forces, motion);
    return;
  }
  pressing_.clear();
  for (const Index i : forces.pressing) {
    const auto& point = system_->points[i];
    const auto& linear = forces.linear[i];
    pressing_.push_back({point.left_begin, point.left_size, point.right_begin, point.right_size,
                         point.sense_left.data(), point.sense_right.data(), point.push_left.data(),
                         point.push_right.data(), widths_[i], linear.base * h * h, linear.stiffness * h * h,
                         linear.damping * h, motion.fill_opening(i).coefficients.data()});
  }
  kernels::expand(stiff_.data(), damp_.data(), system_->gamma.data(), grounds_, pressing_, motion.degree(),
                  system_->size, c_->data());
}

/// The same with full damping matrices and resting points.
void Series::expand_term_by_term(Index first, Index count, const ContactForces& forces, Expansion& motion) {
  resting_force_.resize(forces.resting.size());
  for (int k = 0; k + 2 <= motion.degree(); ++k) {
    for (kernels::GroundSeries& ground : grounds_) {
      const double a = ground.next(k);
      force_.segment(ground.begin, ground.size) = a * system_->gamma.segment(ground.begin, ground.size);
    }
    for (const Index i : forces.pressing) add_contact(i, forces.linear[i], k);
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
    motion.set_resting_force(forces.resting[n], resting_force_[n]);
  }
}

void Series::expand_block(std::size_t b, const State& state, const GroundInput& input, double h, Expansion& motion) {
  const auto& block = system_->blocks[b];
  begin(block.begin, block.padded_size, state, h, std::max(block.rate(), system_->nu), motion);
  grounds_.assign(1, ground(b, input, h));
  if (block.damping) {
    expand_term_by_term(block.begin, block.padded_size, {}, motion);
    return;
  }
  kernels::expand(stiff_.data(), damp_.data(), system_->gamma.data(), grounds_, {}, motion.degree(), system_->size,
                  c_->data());
}

}  // namespace bentur::engine
