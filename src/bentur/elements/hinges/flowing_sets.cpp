#include "bentur/elements/hinges/flowing_sets.h"

#include <algorithm>
#include <functional>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double no_part = 1e-9;   // of a row over x: it does not depend on x
constexpr double no_pivot = 1e-9;  // of the largest one

FlowingPaces paces(const HingeParameters& hinges, const std::vector<Index>& flowing,
                   const std::vector<double>& slopes) {
  const Index moving = std::ssize(flowing);
  if (moving == 0) return {MatrixXd(0, 0)};
  MatrixXd q = hinges.stiffness(flowing, flowing);
  if (slopes.empty()) {
    q.diagonal() += hinges.hardening(flowing);
  } else {
    q.diagonal() += Eigen::Map<const VectorXd>(slopes.data(), moving);
  }
  // By sweeps: −Q⁻¹ when the last pivot has been gone through.
  double least = q(0, 0), most = least;
  for (Index k = 0; k < moving; ++k) {
    const double pivot = q(k, k);
    least = std::min(least, pivot);
    most = std::max(most, pivot);
    VectorXd column = q.col(k);
    column(k) = -1.0;
    q.col(k).setZero();
    q.row(k).setZero();
    for (Index j = 0; j < moving; ++j) q.col(j) -= column(j) / pivot * column;
  }
  return {-q, least > no_pivot * most};
}

FlowingSet set_of(const HingeParameters& hinges, const std::vector<Index>& flowing, const MatrixXd& inverse) {
  const Index count = hinges.hardening.size(), moving = std::ssize(flowing);
  FlowingSet set;
  set.inverse = inverse;
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
  set.sizes = set.seen.over.cwiseAbs();
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

std::size_t FlowingSets::Hash::operator()(const Key& key) const {
  std::size_t hash = key.second.size();
  const auto take = [&hash](std::size_t one) { hash = (hash ^ one) * 0x9e3779b97f4a7c15U + (hash >> 29U); };
  for (const Index h : key.first) take(static_cast<std::size_t>(h));
  for (const double slope : key.second) take(std::hash<double>{}(slope));
  return hash;
}

FlowingSets::Known FlowingSets::found(const Key& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = sets_.find(key);
  return found != sets_.end() ? found->second : Known{};
}

void FlowingSets::keep(const Key& key, const Known& known) const {
  Index size = known.paces->inverse.size();
  if (known.set) size += 2 * known.set->seen.over.size() + 2 * known.set->inverse.size() + std::ssize(known.set->still);
  const std::lock_guard lock(mutex_);
  if (numbers_ + size > kept_) {
    sets_.clear();
    numbers_ = 0;
  }
  if (size > kept_) return;
  sets_.insert_or_assign(key, known);
  numbers_ += size;
}

std::shared_ptr<const FlowingPaces> FlowingSets::paces_of(const HingeParameters& hinges,
                                                          const std::vector<Index>& flowing) const {
  const Key key{flowing, {}};
  if (const Known known = found(key); known.paces) return known.paces;
  const auto made = std::make_shared<const FlowingPaces>(paces(hinges, flowing, {}));
  keep(key, {made, nullptr});
  return made;
}

std::shared_ptr<const FlowingSet> FlowingSets::of(const HingeParameters& hinges, const std::vector<Index>& flowing,
                                                  const std::vector<double>& slopes) const {
  const Key key{flowing, slopes};
  Known known = found(key);
  if (known.set) return known.set;
  if (!known.paces) known.paces = std::make_shared<const FlowingPaces>(paces(hinges, flowing, slopes));
  known.set = std::make_shared<const FlowingSet>(set_of(hinges, flowing, known.paces->inverse));
  keep(key, known);
  return known.set;
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
