#include "bentur/elements/hinges/flowing_sets.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "bentur/core/algebra/symmetric.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double no_part = 1e-9;   // of a row over x: it does not depend on x
constexpr double no_pivot = 1e-9;  // of the largest one

/// to −= factor · of, without what Eigen looks at first, which is more than that of so few.
void take_from(double* to, double factor, const double* of, Index size) {
  for (Index i = 0; i < size; ++i) to[i] -= factor * of[i];
}

/// Squares of the norms of a matrix's rows.
VectorXd squares_of_rows(const MatrixXd& a) {
  VectorXd sum = VectorXd::Zero(a.rows());
  for (Index j = 0; j < a.cols(); ++j) sum += a.col(j).cwiseAbs2();
  return sum;
}

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
  VectorXd column(moving);
  for (Index k = 0; k < moving; ++k) {
    const double pivot = q(k, k);
    least = std::min(least, pivot);
    most = std::max(most, pivot);
    column = q.col(k);
    column(k) = -1.0;
    q.col(k).setZero();
    q.row(k).setZero();
    for (Index j = 0; j < moving; ++j) take_from(q.col(j).data(), column(j) / pivot, column.data(), moving);
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
  set.seen.over.noalias() = -coupling * set.inverse;
  MatrixXd over_x = hinges.rows;
  over_x.noalias() += set.seen.over * rows;
  for (Index h = 0; h < count; ++h) set.seen.own[h] = h;
  for (Index n = 0; n < moving; ++n) {
    set.seen.own[flowing[n]] = -1;
    set.seen.over.row(flowing[n]) = set.inverse.row(n);
    over_x.row(flowing[n]) = set.inverse.row(n) * rows;
  }
  set.still.resize(count);
  const VectorXd now = squares_of_rows(over_x), alone = squares_of_rows(hinges.rows);
  for (Index h = 0; h < count; ++h) {
    const double unit = set.seen.own[h] >= 0 ? 1.0 : hinges.stiffness(h, h) + hinges.hardening(h);
    const bool moves = unit * unit * now(h) > no_part * no_part * alone(h);
    set.still[h] = moves ? 0 : 1;
  }
  set.movable = hinges.frame_stiffness.size() > 0 && moving > 0 &&
                free_shape(hinges.frame_stiffness, hinges.frame_rows, hinges.stiffness, flowing).has_value();
  return set;
}

}  // namespace

std::size_t FlowingSets::Hash::operator()(const Sought& key) const {
  std::size_t hash = key.second.size();
  const auto take = [&hash](std::size_t one) { hash = (hash ^ one) * 0x9e3779b97f4a7c15U + (hash >> 29U); };
  for (const Index h : key.first) take(static_cast<std::size_t>(h));
  for (const double slope : key.second) take(std::hash<double>{}(slope));
  return hash;
}

FlowingSets::Known FlowingSets::found(const Sought& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = sets_.find(key);
  return found != sets_.end() ? found->second : Known{};
}

void FlowingSets::keep(const Sought& key, const Known& known) const {
  Index size = known.paces->inverse.size();
  if (known.set) size += known.set->seen.over.size() + 2 * known.set->inverse.size() + std::ssize(known.set->still);
  const std::lock_guard lock(mutex_);
  if (numbers_ + size > kept_) {
    sets_.clear();
    numbers_ = 0;
  }
  if (size > kept_) return;
  sets_.insert_or_assign(Key(key.first, key.second), known);
  numbers_ += size;
}

std::shared_ptr<const FlowingPaces> FlowingSets::paces_of(const HingeParameters& hinges,
                                                          const std::vector<Index>& flowing) const {
  static const std::vector<double> no_slopes;
  const Sought key{flowing, no_slopes};
  if (const Known known = found(key); known.paces) return known.paces;
  const auto made = std::make_shared<const FlowingPaces>(paces(hinges, flowing, {}));
  keep(key, {made, nullptr});
  return made;
}

std::shared_ptr<const FlowingSet> FlowingSets::of(const HingeParameters& hinges, const std::vector<Index>& flowing,
                                                  const std::vector<double>& slopes) const {
  const Sought key{flowing, slopes};
  Known known = found(key);
  if (known.set) return known.set;
  if (!known.paces) known.paces = std::make_shared<const FlowingPaces>(paces(hinges, flowing, slopes));
  known.set = std::make_shared<const FlowingSet>(set_of(hinges, flowing, known.paces->inverse));
  keep(key, known);
  return known.set;
}

namespace {

/// Whether K_AA has no spin near and K − G_Aᵀ K_AA⁻¹ G_A − 10⁻⁹ K is positive definite, so that nothing is as soft as
/// that: by the pivots of [K_AA, G_A; G_Aᵀ, (1 − 10⁻⁹) K].
bool plainly_bends(const MatrixXd& frame_stiffness, const MatrixXd& frame_rows, const MatrixXd& hinge_stiffness,
                   const std::vector<Index>& flowing) {
  constexpr double spin_near = 1e-6;  // of the largest pivot
  const Index hinges = std::ssize(flowing), dofs = frame_stiffness.rows(), size = hinges + dofs;
  MatrixXd a(size, size);  // below the diagonal
  a.topLeftCorner(hinges, hinges) = hinge_stiffness(flowing, flowing);
  for (Index n = 0; n < hinges; ++n) a.col(n).tail(dofs) = frame_rows.row(flowing[n]);
  a.bottomRightCorner(dofs, dofs) = (1.0 - FlowingSet::bends) * frame_stiffness;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (Index k = 0; k < size; ++k) {
    const double* column = a.col(k).data();
    const double pivot = column[k];
    if (!(pivot > 0.0)) return false;
    least = k < hinges ? std::min(least, pivot) : least;
    most = k < hinges ? std::max(most, pivot) : most;
    for (Index j = k + 1; j < size; ++j) take_from(a.col(j).data() + j, column[j] / pivot, column + j, size - j);
  }
  return least > spin_near * most;
}

}  // namespace

std::optional<VectorXd> free_shape(const MatrixXd& frame_stiffness, const MatrixXd& frame_rows,
                                   const MatrixXd& hinge_stiffness, const std::vector<Index>& flowing) {
  constexpr double singular = 1e-12;  // of the largest eigenvalue: a spin
  if (plainly_bends(frame_stiffness, frame_rows, hinge_stiffness, flowing)) return std::nullopt;
  const MatrixXd rows = frame_rows(flowing, Eigen::all);
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
