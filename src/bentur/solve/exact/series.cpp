#include "bentur/solve/exact/series.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bentur::exact {
namespace {

using Eigen::Index;

template <class Row>
Polynomial combine(const Row& row, const Eigen::MatrixXd& c, Index begin, Index size, int degree) {
  Polynomial p;
  p.degree = degree;
  for (int k = 0; k <= degree; ++k) p[k] = row.dot(c.col(k).segment(begin, size));
  return p;
}

}  // namespace

Series::Series(const ModalSystem& system)
    : system_(&system),
      c_(Eigen::MatrixXd::Zero(system.size, highest_degree + 1)),
      stiff_(system.size),
      damp_(system.size),
      force_(system.size),
      curvature_(Eigen::VectorXd::Zero(system.size)),
      fourth_(Eigen::VectorXd::Zero(system.size)) {}

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

void Series::begin(Index first, Index count, const State& state, double h, double rate) {
  h_ = h;
  degree_ = needed_degree(rate * h);
  first_ = first;
  count_ = count;
  c_.col(0).segment(first, count) = state.q.segment(first, count);
  c_.col(1).segment(first, count) = h * state.v.segment(first, count);
  stiff_.segment(first, count) = (h * h) * system_->omega_squared.segment(first, count);
  damp_.segment(first, count) = h * system_->two_sigma.segment(first, count);
}

/// (T-2) for the coordinates from `first` on, given force_; full damping has been added to force_.
void Series::recur(Index first, Index count, int k) {
  const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
  const double step = k + 1.0;
  const double* c0 = c_.col(k).data() + first;
  const double* c1 = c_.col(k + 1).data() + first;
  const double* stiff = stiff_.data() + first;
  const double* damp = damp_.data() + first;
  const double* force = force_.data() + first;
  double* c2 = c_.col(k + 2).data() + first;
  for (Index j = 0; j < count; ++j) c2[j] = (force[j] - stiff[j] * c0[j] - step * damp[j] * c1[j]) * scale;
}

void Series::add_full_damping(const ModalSystem::Block& block, int k) {
  auto force = force_.segment(block.begin, block.size);
  force.noalias() -= ((k + 1.0) * h_) * (*block.damping * c_.col(k + 1).segment(block.begin, block.size));
  force +=
      (k + 1.0) * damp_.segment(block.begin, block.size).cwiseProduct(c_.col(k + 1).segment(block.begin, block.size));
}

void Series::add_contact(const ModalSystem::Point& point, int k) {
  const double opening = point.sense(c_.col(k)) + (k == 0 ? point.width : 0.0);
  const double force = -point.stiffness * opening * h_ * h_;
  force_.segment(point.left_begin, point.left_size) += force * point.push_left;
  force_.segment(point.right_begin, point.right_size) += force * point.push_right;
}

void Series::expand(const State& state, const std::vector<GroundInput>& inputs, double h,
                    const std::vector<char>& closed) {
  begin(0, system_->size, state, h, system_->rate(closed));
  const double nu2 = (system_->nu * h) * (system_->nu * h);
  const double* gamma = system_->gamma.data();
  for (int k = 0; k + 2 <= degree_; ++k) {
    if (k < 2 || nu2 > 0.0) {
      for (std::size_t b = 0; b < inputs.size(); ++b) {
        double a = k % 2 == 0 ? inputs[b].value : inputs[b].slope * h;
        for (int m = k; m >= 2; m -= 2) a *= -nu2 / (m * (m - 1.0));
        const auto& block = system_->blocks[b];
        for (Index j = block.begin; j < block.begin + block.size; ++j) force_[j] = gamma[j] * (a * h * h);
      }
    } else {
      force_.setZero();
    }
    for (std::size_t i = 0; i < closed.size(); ++i) {
      if (closed[i]) add_contact(system_->points[i], k);
    }
    if (!system_->classical) {
      for (const auto& block : system_->blocks) {
        if (block.damping) add_full_damping(block, k);
      }
    }
    recur(0, system_->size, k);
  }
}

void Series::expand_block(std::size_t b, const State& state, const GroundInput& input, double h) {
  const auto& block = system_->blocks[b];
  begin(block.begin, block.size, state, h, std::max(block.rate(), system_->nu));
  const double nu2 = (system_->nu * h) * (system_->nu * h);
  double even = input.value * h * h;
  double odd = input.slope * h * h * h;
  for (int k = 0; k + 2 <= degree_; ++k) {
    double& a = k % 2 == 0 ? even : odd;
    if (k >= 2) a *= -nu2 / (k * (k - 1.0));
    force_.segment(block.begin, block.size) = a * system_->gamma.segment(block.begin, block.size);
    if (block.damping) add_full_damping(block, k);
    recur(block.begin, block.size, k);
  }
}

void Series::bound() {
  double* second = curvature_.data() + first_;
  double* fourth = fourth_.data() + first_;
  std::fill_n(second, count_, 0.0);
  std::fill_n(fourth, count_, 0.0);
  for (int k = 2; k <= degree_; ++k) {
    const double two = k * (k - 1.0);
    const double four = two * (k - 2.0) * (k - 3.0);
    const double* c = c_.col(k).data() + first_;
    for (Index j = 0; j < count_; ++j) {
      second[j] += two * std::abs(c[j]);
      fourth[j] += four * std::abs(c[j]);
    }
  }
}

void Series::evaluate(double s, State& state) const {
  double* q = state.q.data() + first_;
  double* v = state.v.data() + first_;
  std::fill_n(q, count_, 0.0);
  std::fill_n(v, count_, 0.0);
  for (int k = degree_; k >= 1; --k) {
    const double* c = c_.col(k).data() + first_;
    for (Index j = 0; j < count_; ++j) {
      q[j] = q[j] * s + c[j];
      v[j] = v[j] * s + k * c[j];
    }
  }
  const double* c = c_.col(0).data() + first_;
  for (Index j = 0; j < count_; ++j) {
    q[j] = q[j] * s + c[j];
    v[j] /= h_;
  }
}

Polynomial Series::opening(std::size_t i) const {
  const auto& point = system_->points[i];
  Polynomial p;
  p.degree = degree_;
  for (int k = 0; k <= degree_; ++k) p[k] = point.sense(c_.col(k));
  p[0] += point.width;
  return p;
}

Polynomial Series::output(std::size_t b, Index row) const {
  const auto& block = system_->blocks[b];
  return combine(block.outputs.row(row), c_, block.begin, block.size, degree_);
}

Polynomial Series::acceleration(std::size_t b, Index floor) const {
  const auto& block = system_->blocks[b];
  Polynomial p = combine(block.acceleration.row(floor), c_, block.begin, block.size, degree_);
  p.degree = degree_ - 2;
  for (int k = 0; k <= p.degree; ++k) p[k] = p[k + 2] * ((k + 2.0) * (k + 1.0)) / (h_ * h_);
  return p;
}

}  // namespace bentur::exact
