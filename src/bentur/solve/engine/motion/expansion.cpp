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
      curved_(Eigen::VectorXd::Zero(system.size)),
      resting_force_(system.elements.size()),
      deformations_(system.elements.size()),
      deformation_known_(system.elements.size(), 0) {}

Eigen::MatrixXd& Expansion::coefficients() {
  std::fill(deformation_known_.begin(), deformation_known_.end(), 0);
  return c_;
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
    const Polynomial& delta = deformation(i);
    const double stiffness = forces.linear[i].stiffness;
    c_(at, 0) = forces.linear[i].base + stiffness * delta[0];
    for (int k = 1; k <= degree_; ++k) c_(at, k) = stiffness * delta[k];
  }
}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  place_ = 0.0;
  h_ = h;
  degree_ = degree;
}

void Expansion::set_resting_force(Index element, const Polynomial& force) { resting_force_[element] = force; }

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
