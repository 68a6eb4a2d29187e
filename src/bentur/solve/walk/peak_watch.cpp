#include "bentur/solve/walk/peak_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bentur::engine {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr int misses_before_lump = 8;  // lumping costs about as much as a look at all rows

}  // namespace

PeakWatch::Rows::Rows(const MatrixXd& quantities, Index room)
    : weights(quantities, room), peak(ArrayXd::Zero(weights.rows())), lumped(Eigen::VectorXd::Zero(room)) {
  lump();
}

void PeakWatch::Rows::lump() {
  misses = 0;
  lumped.setZero();
  for (Index r = 0; r < weights.rows(); ++r) {
    const double rate = 1.0 / peak(r);
    for (Index j = 0; j < weights.columns(); ++j) {
      if (weights(r, j) != 0.0) lumped(j) = std::max(lumped(j), std::abs(weights(r, j)) * rate);
    }
  }
}

bool PeakWatch::Rows::below(const double* bounds) {
  if (misses >= misses_before_lump) lump();
  if (kernels::dot(lumped.size(), lumped.data(), bounds) <= 1.0) return true;
  ++misses;
  return false;
}

bool PeakWatch::Rows::take(const double* start, const double* end, const double* rise, ArrayXd& reach) {
  return kernels::reach_of_rows(weights, start, end, rise, peak.data(), reach.data());
}

/// Takes count + 1 samples in; the reach is what is left between them.
bool PeakWatch::Rows::take_samples(int count, const double* samples, const double* rise, ArrayXd& reach) {
  return kernels::reach_of_samples(weights, count + 1, samples, rise, peak.data(), reach.data());
}

PeakWatch::PeakWatch(const ModalSystem& system, Scope scope) : system_(&system), scope_(scope) {
  Index most = 0;
  for (const auto& block : system.blocks) {
    const bool everything = scope == Scope::everything;
    positions_.emplace_back(block.outputs.topRows(everything ? block.outputs.rows() : block.floors), block.room);
    accelerations_.emplace_back(block.acceleration.topRows(everything ? block.floors : 0), block.room);
    most = std::max(most, block.room);
  }
  samples_.resize(most * (most_parts + 1));
  seconds_.resize(most * (most_parts + 1));
  rise_.resize(most);
}

void PeakWatch::forget(std::size_t b, Reach& reach) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  reach.positions.setConstant(positions_[b].weights.rows(), unknown);
  reach.accelerations.setConstant(accelerations_[b].weights.rows(), unknown);
}

void PeakWatch::append(const Reach& reach, std::vector<double>& to) {
  to.insert(to.end(), reach.positions.begin(), reach.positions.end());
  to.insert(to.end(), reach.accelerations.begin(), reach.accelerations.end());
}

void PeakWatch::read(std::size_t b, const double* from, Reach& reach) const {
  const Index positions = positions_[b].weights.rows();
  reach.positions = Eigen::Map<const ArrayXd>(from, positions);
  reach.accelerations = Eigen::Map<const ArrayXd>(from + positions, accelerations_[b].weights.rows());
}

void PeakWatch::start(const State& state) {
  Reach reach;
  rise_.setZero();
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    forget(b, reach);
    const double* q = state.q.data() + system_->blocks[b].begin;
    (void)positions_[b].take(q, q, rise_.data(), reach.positions);
  }
}

PeakWatch::Open PeakWatch::open_at_once(std::size_t b, const Flight::Bounds& bounds) {
  const Index begin = system_->blocks[b].begin;
  return {!positions_[b].below(bounds.position.data() + begin),
          scope_ == Scope::everything && !accelerations_[b].below(bounds.acceleration.data() + begin)};
}

bool PeakWatch::settled_by_bound(std::size_t b, const Interval& at, Open open, Reach& reach) {
  const auto look = [](Rows& rows, bool is_open, const double* start, const double* end, const double* rise,
                       ArrayXd& rows_reach) {
    if (is_open) return rows.take(start, end, rise, rows_reach);
    rows_reach.setZero(rows.weights.rows());
    return true;
  };
  const bool positions = look(positions_[b], open.positions, at.start, at.end, at.rise, reach.positions);
  const bool accelerations = look(accelerations_[b], open.accelerations, at.start_acceleration, at.end_acceleration,
                                  at.acceleration_rise, reach.accelerations);
  return positions && accelerations;
}

bool PeakWatch::settled_by_samples(std::size_t b, const Expansion& motion, double end, int parts, Reach& reach) {
  const auto& block = system_->blocks[b];
  const Index n = block.room;
  const MatrixXd& c = motion.coefficients();
  kernels::sample(n, c.data() + block.begin, c.rows(), motion.degree(), parts, end, samples_.data(), seconds_.data());
  const double chord = end * end / (8.0 * parts * parts);
  rise_.head(n) = chord * motion.curvature().segment(block.begin, n);
  const bool positions = positions_[b].take_samples(parts, samples_.data(), rise_.data(), reach.positions);
  if (scope_ == Scope::displacement) return positions;
  const double rate = 1.0 / (motion.h() * motion.h());
  seconds_.head(n * (parts + 1)) *= rate;
  rise_.head(n) = chord * rate * motion.fourth_derivative().segment(block.begin, n);
  const bool accelerations = accelerations_[b].take_samples(parts, seconds_.data(), rise_.data(), reach.accelerations);
  return positions && accelerations;
}

bool PeakWatch::settled(std::size_t b, const Reach& reach) const {
  return (reach.positions <= positions_[b].peak).all() && (reach.accelerations <= accelerations_[b].peak).all();
}

void PeakWatch::scan(std::size_t b, const Expansion& motion, const Reach& reach) {
  for (Index r = 0; r < reach.positions.size(); ++r) {
    double& peak = positions_[b].peak(r);
    if (reach.positions(r) > peak) raise_to_largest(motion.output(b, r), peak);
  }
  for (Index f = 0; f < reach.accelerations.size(); ++f) {
    double& peak = accelerations_[b].peak(f);
    if (reach.accelerations(f) > peak) raise_to_largest(motion.acceleration(b, f), peak);
  }
}

void PeakWatch::report(std::size_t b, BuildingPeaks& peaks) const {
  const Index floors = system_->blocks[b].floors;
  const ArrayXd& peak = positions_[b].peak;
  if (scope_ == Scope::displacement) {
    peaks.displacement_no_contact = peak.head(floors);
    return;
  }
  peaks.displacement = peak.head(floors);
  peaks.drift_ratio = peak.segment(floors, floors);
  peaks.storey_shear = peak.segment(2 * floors, floors);
  peaks.acceleration = accelerations_[b].peak.head(floors);
}

}  // namespace bentur::engine
