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
      resting_force_(system.points.size()),
      openings_(system.points.size()),
      opening_known_(system.points.size(), 0) {}

Eigen::MatrixXd& Expansion::coefficients() {
  std::fill(opening_known_.begin(), opening_known_.end(), 0);
  return c_;
}

Polynomial& Expansion::fill_opening(std::size_t point) {
  opening_known_[point] = 1;
  openings_[point].degree = degree_;
  return openings_[point];
}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  h_ = h;
  degree_ = degree;
}

void Expansion::set_resting_force(std::size_t point, const Polynomial& force) { resting_force_[point] = force; }

bool Expansion::bound() {
  const double all = kernels::bound(count_, c_.data() + first_, c_.rows(), degree_, curvature_.data() + first_,
                                    fourth_.data() + first_);
  return std::isfinite(all);
}

void Expansion::evaluate(double s, State& state) const {
  kernels::evaluate(count_, c_.data() + first_, c_.rows(), degree_, s, state.q.data() + first_,
                    state.v.data() + first_);
  const double rate = 1.0 / h_;
  double* v = state.v.data() + first_;
  for (Index j = 0; j < count_; ++j) v[j] *= rate;
}

const Polynomial& Expansion::opening(std::size_t i) const {
  Polynomial& p = openings_[i];
  if (opening_known_[i] != 0) return p;
  opening_known_[i] = 1;
  const auto& point = system_->points[i];
  p.degree = degree_;
  for (int k = 0; k <= degree_; ++k) p[k] = point.sense(c_.col(k).data());
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
