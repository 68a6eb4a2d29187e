#include "bentur/solve/motion/expansion.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {
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

Expansion::Expansion(const ModalSystem& system)
    : system_(&system),
      c_(Eigen::MatrixXd::Zero(system.size, highest_degree + 1)),
      curvature_(Eigen::VectorXd::Zero(system.size)),
      fourth_(Eigen::VectorXd::Zero(system.size)),
      resting_force_(system.points.size()) {}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  h_ = h;
  degree_ = degree;
}

void Expansion::set_resting_force(std::size_t point, const Polynomial& force) { resting_force_[point] = force; }

void Expansion::bound() {
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

void Expansion::evaluate(double s, State& state) const {
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

Polynomial Expansion::opening(std::size_t i) const {
  const auto& point = system_->points[i];
  Polynomial p;
  p.degree = degree_;
  for (int k = 0; k <= degree_; ++k) p[k] = point.sense(c_.col(k));
  p[0] += point.width;
  return p;
}

Polynomial Expansion::output(std::size_t b, Index row) const {
  const auto& block = system_->blocks[b];
  return combine(block.outputs.row(row), c_, block.begin, block.size, degree_);
}

Polynomial Expansion::acceleration(std::size_t b, Index floor) const {
  const auto& block = system_->blocks[b];
  Polynomial p = combine(block.acceleration.row(floor), c_, block.begin, block.size, degree_);
  p.degree = degree_ - 2;
  for (int k = 0; k <= p.degree; ++k) p[k] = p[k + 2] * ((k + 2.0) * (k + 1.0)) / (h_ * h_);
  return p;
}

}  // namespace bentur::engine
