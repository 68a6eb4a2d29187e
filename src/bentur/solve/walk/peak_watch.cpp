#include "bentur/solve/walk/peak_watch.h"

#include <algorithm>

namespace bentur::engine {
namespace {

using Eigen::Array4d;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

double largest_ratio(const ArrayXd& reach, const ArrayXd& peak) {
  constexpr double tiny = 1e-300;  // over a peak of zero every reach is an excess
  return reach.size() == 0 ? 0.0 : (reach / (peak + tiny)).maxCoeff();
}

}  // namespace

PeakWatch::Rows::Rows(const MatrixXd& quantities) {
  const Index padded = (quantities.rows() + 3) / 4 * 4;
  weights = MatrixXd::Zero(padded, quantities.cols());
  weights.topRows(quantities.rows()) = quantities;
  peak = ArrayXd::Zero(padded);
}

/// Four quantities at a time: their values at both ends and how far the bound lets them go beyond.
bool PeakWatch::Rows::take(const double* start, const double* end, const double* rise, ArrayXd& reach) {
  const Index rows = weights.rows();
  const Index columns = weights.cols();
  reach.resize(rows);
  bool settled = true;
  for (Index r = 0; r < rows; r += 4) {
    Array4d at_start = Array4d::Zero();
    Array4d at_end = Array4d::Zero();
    Array4d beyond = Array4d::Zero();
    const double* weight = weights.data() + r;
    for (Index j = 0; j < columns; ++j, weight += rows) {
      const Array4d w = Eigen::Map<const Array4d>(weight);
      at_start += w * start[j];
      at_end += w * end[j];
      beyond += w.abs() * rise[j];
    }
    const Array4d ends = at_start.abs().max(at_end.abs());
    const Array4d highest = peak.segment<4>(r).max(ends);
    peak.segment<4>(r) = highest;
    reach.segment<4>(r) = ends + beyond;
    settled = settled && (ends + beyond <= highest).all();
  }
  return settled;
}

PeakWatch::PeakWatch(const ModalSystem& system, Scope scope) : system_(&system), scope_(scope) {
  for (const auto& block : system.blocks) {
    const bool everything = scope == Scope::everything;
    positions_.emplace_back(block.outputs.topRows(everything ? block.outputs.rows() : block.floors));
    accelerations_.emplace_back(block.acceleration.topRows(everything ? block.floors : 0));
  }
}

void PeakWatch::start(const State& state) {
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    const auto& block = system_->blocks[b];
    positions_[b].peak = (positions_[b].weights * state.q.segment(block.begin, block.size)).array().abs();
  }
}

bool PeakWatch::settled_by_bound(std::size_t b, const Interval& interval, Reach& reach) {
  const Index begin = system_->blocks[b].begin;
  const bool positions = positions_[b].take(interval.from.q.data() + begin, interval.to.q.data() + begin,
                                            interval.rise.data() + begin, reach.positions);
  const bool accelerations =
      accelerations_[b].take(interval.start_acceleration.data() + begin, interval.end_acceleration.data() + begin,
                             interval.acceleration_rise.data() + begin, reach.accelerations);
  return positions && accelerations;
}

double PeakWatch::excess(std::size_t b, const Reach& reach) const {
  return std::max(largest_ratio(reach.positions, positions_[b].peak),
                  largest_ratio(reach.accelerations, accelerations_[b].peak));
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
