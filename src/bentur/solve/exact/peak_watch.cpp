#include "bentur/solve/exact/peak_watch.h"

namespace bentur::exact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Raises `peak` to the largest |p| on [0, end].
void raise_to_largest(Polynomial p, double end, double& peak) {
  double where = 0.0;
  raise_to_maximum(p, end, peak, where);
  for (double& coefficient : p) coefficient = -coefficient;
  raise_to_maximum(p, end, peak, where);
}

}  // namespace

PeakWatch::PeakWatch(const ModalSystem& system, Scope scope) : system_(&system), scope_(scope) {
  for (const auto& block : system.blocks) {
    const bool everything = scope == Scope::everything;
    const Index count = everything ? block.outputs.rows() : block.floors;
    Rows rows;
    rows.weights = block.outputs.topRows(count);
    rows.weights_abs = block.outputs_abs.topRows(count);
    rows.start = rows.end = rows.bound = rows.peak = VectorXd::Zero(count);
    rows.acceleration = VectorXd::Zero(everything ? block.floors : 0);
    rows_.push_back(std::move(rows));
  }
}

void PeakWatch::start(const State& state) {
  for (std::size_t b = 0; b < rows_.size(); ++b) {
    const auto& block = system_->blocks[b];
    rows_[b].peak = (rows_[b].weights * state.q.segment(block.begin, block.size)).cwiseAbs();
  }
}

bool PeakWatch::settled_by_bound(std::size_t b, const State& from, const State& to, const VectorXd& start_acceleration,
                                 const VectorXd& end_acceleration, const VectorXd& curvature,
                                 const VectorXd& acceleration_curvature, VectorXd& reach) {
  const auto& block = system_->blocks[b];
  Rows& rows = rows_[b];
  const auto part = [&block](const VectorXd& x) { return x.segment(block.begin, block.size); };
  rows.start.noalias() = rows.weights * part(from.q);
  rows.end.noalias() = rows.weights * part(to.q);
  rows.bound.noalias() = rows.weights_abs * part(curvature);
  rows.peak = rows.peak.cwiseMax(rows.end.cwiseAbs());
  const Index count = rows.peak.size();
  reach.resize(count + rows.acceleration.size());
  reach.head(count) = rows.bound + rows.start.cwiseAbs().cwiseMax(rows.end.cwiseAbs());
  for (Index f = 0; f < rows.acceleration.size(); ++f) {
    const auto row = block.acceleration.row(f);
    const double ends =
        std::max(std::abs(row.dot(part(start_acceleration))), std::abs(row.dot(part(end_acceleration))));
    rows.acceleration(f) = std::max(rows.acceleration(f), ends);
    reach(count + f) = ends + block.acceleration_abs.row(f).dot(part(acceleration_curvature));
  }
  return settled(b, reach);
}

bool PeakWatch::settled(std::size_t b, const VectorXd& reach) const {
  const Rows& rows = rows_[b];
  return (reach.head(rows.peak.size()).array() <= rows.peak.array()).all() &&
         (reach.tail(rows.acceleration.size()).array() <= rows.acceleration.array()).all();
}

void PeakWatch::scan(std::size_t b, const Series& series, double end, const State& from, const State& to) {
  const auto& block = system_->blocks[b];
  const auto curvature = series.curvature().segment(block.begin, block.size);
  Rows& rows = rows_[b];
  rows.start.noalias() = rows.weights * from.q.segment(block.begin, block.size);
  rows.end.noalias() = rows.weights * to.q.segment(block.begin, block.size);
  rows.bound.noalias() = rows.weights_abs * curvature;
  rows.peak = rows.peak.cwiseMax(rows.end.cwiseAbs());
  for (Index r = 0; r < rows.peak.size(); ++r) {
    const double ends = std::max(std::abs(rows.start(r)), std::abs(rows.end(r)));
    if (ends + rows.bound(r) * end * end / 8.0 > rows.peak(r)) raise_to_largest(series.output(b, r), end, rows.peak(r));
  }
  const double per_time = 1.0 / (series.h() * series.h());
  for (Index f = 0; f < rows.acceleration.size(); ++f) {
    if (block.acceleration_abs.row(f).dot(curvature) * per_time > rows.acceleration(f)) {
      raise_to_largest(series.acceleration(b, f), end, rows.acceleration(f));
    }
  }
}

void PeakWatch::report(std::size_t b, BuildingPeaks& peaks) const {
  const Index floors = system_->blocks[b].floors;
  const VectorXd& peak = rows_[b].peak;
  if (scope_ == Scope::displacement) {
    peaks.displacement_no_contact = peak.head(floors);
    return;
  }
  peaks.displacement = peak.head(floors);
  peaks.drift_ratio = peak.segment(floors, floors);
  peaks.storey_shear = peak.tail(floors);
  peaks.acceleration = rows_[b].acceleration;
}

}  // namespace bentur::exact
