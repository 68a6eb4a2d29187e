#include "bentur/solve/engine/walk/watched_rows.h"

#include "bentur/solve/engine/motion/trail.h"

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

WatchedRows::WatchedRows(const Eigen::MatrixXd& weights, Index columns, kernels::Peaks of)
    : of_(of),
      weights_(weights, columns),
      lumped_(VectorXd::Zero(columns)),
      shares_(Trail::most + 1),
      betweens_(Trail::most) {
  peak.setZero(weights_.rows());
  inverse_.setZero(weights_.rows());
  values_.resize(weights_.rows() * (Trail::most + 1));
}

void WatchedRows::limit(const VectorXd& limits) {
  inverse_ = limits.cwiseInverse();
  kernels::lump(weights_, limits.data(), lumped_.data());
}

void WatchedRows::raise(Index legs, const double* x, const double* rise, Index apart) {
  take_ends(legs, x, apart);
  limit(peak);
  measure(legs, rise, apart);
}

void WatchedRows::compare(Index legs, const double* x, const double* rise, Index apart) {
  take_ends(legs, x, apart);
  measure(legs, rise, apart);
}

void WatchedRows::take_ends(Index legs, const double* x, Index apart) {
  ends_ = legs + 1;
  kernels::raise_peaks(of_, weights_, ends_, x, apart, peak.data(), values_.data());
}

void WatchedRows::measure(Index legs, const double* rise, Index apart) {
  kernels::largest_shares(size(), ends_, values_.data(), inverse_.data(), shares_.data());
  kernels::sums(legs, rise, apart, weights_.columns(), lumped_.data(), betweens_.data());
}

void WatchedRows::open_fours(Index leg, double* before) const {
  const double* at = values_.data() + 4 * leg;
  kernels::open_groups(size(), at, at + 4, ends_, peak.data(), 1.0 - betweens_(leg), before);
}

}  // namespace bentur::engine
