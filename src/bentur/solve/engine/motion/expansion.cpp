#include "bentur/solve/engine/motion/expansion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {

using Eigen::Index;

Expansion::Expansion(const ModalSystem& system, std::vector<double> widths)
    : system_(&system),
      widths_(std::move(widths)),
      c_(Eigen::MatrixXd::Zero(system.size, highest_degree + 1)),
      rise_(Eigen::VectorXd::Zero(system.size)),
      acceleration_rise_(Eigen::VectorXd::Zero(system.size)),
      curved_(Eigen::VectorXd::Zero(system.size)),
      resting_force_(system.points.size()),
      openings_(system.points.size()),
      opening_known_(system.points.size(), 0) {}

Eigen::MatrixXd& Expansion::coefficients() {
  std::fill(opening_known_.begin(), opening_known_.end(), 0);
  return c_;
}

Polynomial& Expansion::fill_opening(Index point) {
  opening_known_[point] = 1;
  openings_[point].degree = degree_;
  return openings_[point];
}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  place_ = 0.0;
  h_ = h;
  degree_ = degree;
}

void Expansion::set_resting_force(Index point, const Polynomial& force) { resting_force_[point] = force; }

bool Expansion::find_rises() {
  return std::isfinite(kernels::leave_chords(count_, c_.data() + first_, c_.rows(), degree_, 1.0, 1.0 / (h_ * h_),
                                             rise_.data() + first_, acceleration_rise_.data() + first_));
}

void Expansion::find_rises(double end, double* rise, double* acceleration_rise) const {
  (void)kernels::leave_chords(count_, c_.data() + first_, c_.rows(), degree_, end, 1.0 / (h_ * h_), rise + first_,
                              acceleration_rise + first_);
}

void Expansion::evaluate(double s, State& state) const {
  kernels::evaluate(count_, c_.data() + first_, c_.rows(), degree_, s, state.q.data() + first_, state.v.data() + first_,
                    curved_.data() + first_);
  place_ = s;
  const double rate = 1.0 / h_;
  double* v = state.v.data() + first_;
  for (Index j = 0; j < count_; ++j) v[j] *= rate;
}

const Polynomial& Expansion::opening(Index i) const {
  Polynomial& p = openings_[i];
  if (opening_known_[i] != 0) return p;
  opening_known_[i] = 1;
  const auto& point = system_->points[i];
  p.degree = degree_;
  kernels::opening_series({point.right_size, point.sense_right.data(), c_.data() + point.right_begin},
                          {point.left_size, point.sense_left.data(), c_.data() + point.left_begin}, c_.rows(), degree_,
                          p.coefficients.data());
  p[0] += widths_[i];
  return p;
}

}  // namespace bentur::engine
