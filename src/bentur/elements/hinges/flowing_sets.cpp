#include "bentur/elements/hinges/flowing_sets.h"

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double no_part = 1e-9;  // of a row over x: it does not depend on x

FlowingSet set_of(const HingeParameters& hinges, const std::vector<Index>& flowing, const std::vector<double>& slopes) {
  const Index count = hinges.hardening.size(), moving = std::ssize(flowing);
  FlowingSet set;
  MatrixXd q = hinges.stiffness(flowing, flowing);
  if (slopes.empty()) {
    q.diagonal() += hinges.hardening(flowing);
  } else {
    q.diagonal() += Eigen::Map<const VectorXd>(slopes.data(), moving);
  }
  set.inverse = Cholesky(q).solve(MatrixXd::Identity(moving, moving));
  set.seen.moving = flowing;
  set.seen.stiffness = -0.5 * (set.inverse + set.inverse.transpose());
  set.seen.own.resize(count);
  const MatrixXd coupling = hinges.stiffness(Eigen::all, flowing), rows = hinges.rows(flowing, Eigen::all);
  set.seen.over = -coupling * set.inverse;
  MatrixXd over_x = hinges.rows + set.seen.over * rows;
  for (Index h = 0; h < count; ++h) set.seen.own[h] = h;
  for (Index n = 0; n < moving; ++n) {
    set.seen.own[flowing[n]] = -1;
    set.seen.over.row(flowing[n]) = set.inverse.row(n);
    over_x.row(flowing[n]) = set.inverse.row(n) * rows;
  }
  set.still.resize(count);
  for (Index h = 0; h < count; ++h) {
    const double unit = set.seen.own[h] >= 0 ? 1.0 : hinges.stiffness(h, h) + hinges.hardening(h);
    const bool moves = unit * over_x.row(h).norm() > no_part * hinges.rows.row(h).norm();
    set.still[h] = moves ? 0 : 1;
  }
  set.movable = hinges.frame_stiffness.size() > 0 && moving > 0 &&
                free_shape(hinges.frame_stiffness, hinges.frame_rows, hinges.stiffness, flowing).has_value();
  return set;
}

}  // namespace

std::shared_ptr<const FlowingSet> FlowingSets::of(const HingeParameters& hinges, const std::vector<Index>& flowing,
                                                  const std::vector<double>& slopes) const {
  const Key key{flowing, slopes};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = sets_.find(key); found != sets_.end()) return found->second;
  }
  auto set = std::make_shared<const FlowingSet>(set_of(hinges, flowing, slopes));
  const Index size = set->seen.over.size() + 2 * set->inverse.size() + 2 * std::ssize(set->still);
  const std::lock_guard lock(mutex_);
  if (numbers_ + size > kept_) {
    sets_.clear();
    numbers_ = 0;
  }
  if (size <= kept_ && sets_.emplace(key, set).second) numbers_ += size;
  return set;
}

std::optional<VectorXd> free_shape(const MatrixXd& frame_stiffness, const MatrixXd& frame_rows,
                                   const MatrixXd& hinge_stiffness, const std::vector<Index>& flowing) {
  constexpr double singular = 1e-12;  // of the largest eigenvalue: a spin
  constexpr double spin_near = 1e-6;  // of the largest pivot
  const MatrixXd rows = frame_rows(flowing, Eigen::all);
  // Where no spin is near, and K − G_Aᵀ K_AA⁻¹ G_A − 10⁻⁹ K is positive definite, nothing is as soft as that.
  const Ldlt factors(hinge_stiffness(flowing, flowing));
  if (factors.is_definite(spin_near)) {
    const MatrixXd bends = (1.0 - FlowingSet::bends) * frame_stiffness - rows.transpose() * factors.solve(rows);
    if (is_positive_definite(bends)) return std::nullopt;
  }
  const SymmetricModes of_hinges = symmetric_modes(hinge_stiffness(flowing, flowing));
  const VectorXd& values = of_hinges.values;
  const VectorXd inverse = (values.array() > singular * values.maxCoeff()).select(values.cwiseInverse(), 0.0);
  const MatrixXd turned = of_hinges.vectors.transpose() * rows;
  const MatrixXd tangent = frame_stiffness - turned.transpose() * inverse.asDiagonal() * turned;
  const SymmetricModes shapes = generalised_modes(0.5 * (tangent + tangent.transpose()), frame_stiffness);
  if (!(shapes.values(0) < FlowingSet::bends)) return std::nullopt;
  return shapes.vectors.col(0);
}

}  // namespace bentur
