#include "bench/peers/floor_peaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bentur::bench {

FloorPeaks::FloorPeaks(const Problem& problem) {
  for (const Building& building : problem.buildings) {
    const Eigen::Index floors = building.model.floors(), count = building.modes.omega.size();
    const Eigen::MatrixXd displacement = building.modes.shapes.topRows(floors);
    const Eigen::MatrixXd force = (building.model.stiffness * building.modes.shapes).topRows(floors);
    Eigen::MatrixXd all(3 * floors, count);
    all.topRows(floors) = displacement;
    for (Eigen::Index i = 0; i < floors; ++i) {
      const double height = building.model.storey_heights[i];
      all.row(floors + i) = displacement.row(i) / height;
      if (i > 0) all.row(floors + i) -= displacement.row(i - 1) / height;
      all.row(2 * floors + i) = force.bottomRows(floors - i).colwise().sum();
    }
    of_displacement_.emplace_back(all * building.modes.omega.cwiseInverse().asDiagonal());
    of_speed_.push_back(std::move(all));
    for (auto* list : {&values_, &rates_, &new_values_, &new_rates_, &peaks_}) {
      list->emplace_back(Eigen::VectorXd::Zero(3 * floors));
    }
    modes_ += count;
  }
}

void FloorPeaks::look(double time, const double* y) {
  const double step = time - time_;
  std::size_t first = 0;
  for (std::size_t b = 0; b < of_speed_.size(); ++b) {
    const Eigen::Index count = of_speed_[b].cols();
    new_values_[b].noalias() = of_displacement_[b] * Eigen::Map<const Eigen::VectorXd>(y + first, count);
    new_rates_[b].noalias() = of_speed_[b] * Eigen::Map<const Eigen::VectorXd>(y + modes_ + first, count);
    peaks_[b] = peaks_[b].cwiseMax(new_values_[b].cwiseAbs());
    for (Eigen::Index i = 0; i < peaks_[b].size(); ++i) {
      const double r0 = rates_[b](i) * step, r1 = new_rates_[b](i) * step;
      if (!(r0 * r1 < 0)) continue;
      // v0 + r0 s + (3 d − 2 r0 − r1) s² + (r0 + r1 − 2 d) s³ turns where its derivative is zero, once.
      const double v0 = values_[b](i), d = new_values_[b](i) - v0;
      const double square = 3 * d - 2 * r0 - r1, cube = r0 + r1 - 2 * d;
      const double root = std::sqrt(std::max(0.0, square * square - 3 * cube * r0));
      const double s = std::clamp(r0 / (-square + (r0 > 0 ? root : -root)), 0.0, 1.0);
      peaks_[b](i) = std::max(peaks_[b](i), std::abs(v0 + s * (r0 + s * (square + s * cube))));
    }
    std::swap(values_[b], new_values_[b]);
    std::swap(rates_[b], new_rates_[b]);
    first += count;
  }
  time_ = time;
}

}  // namespace bentur::bench
