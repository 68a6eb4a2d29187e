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
  for (const ElementForces::Coupled& of : forces.coupled) fill_coupled(of);
}

void Expansion::fill_coupled(const ElementForces::Coupled& of) {
  for (Index n = 0; n < std::ssize(of.at); ++n) {
    const Index to = system_->elements[of.at[n]].force;
    if (to < 0) continue;
    c_.row(to).head(degree_ + 1).setZero();
    c_(to, 0) = of.base(n);
    for (Index m = 0; m < std::ssize(of.at); ++m) {
      const Polynomial& delta = deformation(of.at[m]);
      for (int k = 0; k <= degree_; ++k) c_(to, k) += of.stiffness(n, m) * delta[k];
    }
  }
}

void Expansion::begin(Index first, Index count, double h, int degree) {
  first_ = first;
  count_ = count;
  h_ = h;
  degree_ = degree | 3;
}

void Expansion::set_resting_force(Index element, const Polynomial& force) { resting_force_[element] = force; }

bool Expansion::find_end(State& state, Eigen::VectorXd& acceleration) {
  return std::isfinite(
      kernels::end_of_step(count_, c_.data() + first_, c_.rows(), degree_, h_,
                           {state.q.data() + first_, state.v.data() + first_, acceleration.data() + first_},
                           rise_.data() + first_, acceleration_rise_.data() + first_));
}

void Expansion::evaluate(double s, State& state, Eigen::VectorXd* acceleration) const {
  kernels::evaluate(count_, c_.data() + first_, c_.rows(), degree_, s, h_,
                    {state.q.data() + first_, state.v.data() + first_,
                     acceleration == nullptr ? nullptr : acceleration->data() + first_});
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
