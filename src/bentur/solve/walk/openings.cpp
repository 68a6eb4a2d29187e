#include "bentur/solve/walk/openings.h"

#include <algorithm>

namespace bentur::engine {

using Eigen::Index;

Openings::Openings(const ModalSystem& system, kernels::Lumped& lumped)
    : system_(&system),
      lumped_(&lumped),
      limits_(system.points.size(), 0.0),
      lowest_(system.points.size(), 0.0),
      beyond_(system.points.size(), 0.0) {
  std::size_t left = 0;
  for (std::size_t i = 0; i < system.points.size(); ++i) {
    const auto& point = system.points[i];
    while (system.blocks[left].begin != point.left_begin) ++left;
    if (pairs_.empty() || pairs_.back().left != left) {
      Pair pair;
      pair.left = left;
      pair.begin = point.left_begin;
      pair.first = i;
      pair.count = 0;
      pairs_.push_back(std::move(pair));
    }
    ++pairs_.back().count;
  }
  for (Pair& pair : pairs_) {
    const auto& first = system.points[pair.first];
    Eigen::MatrixXd sense(static_cast<Index>(pair.count), first.left_size + first.right_size);
    for (std::size_t n = 0; n < pair.count; ++n) {
      const auto& point = system.points[pair.first + n];
      sense.row(static_cast<Index>(n)) << point.sense_left.transpose(), point.sense_right.transpose();
    }
    pair.weights = kernels::PackedRows(sense, sense.cols());
    for (auto* list : {&pair.limits, &pair.lowest, &pair.beyond}) list->setZero(pair.weights.rows());
  }
}

void Openings::limit(const std::vector<double>& limits) {
  limits_ = limits;
  for (Pair& pair : pairs_) {
    for (std::size_t n = 0; n < pair.count; ++n) pair.limits(static_cast<Index>(n)) = limits[pair.first + n];
    const Index left = system_->blocks[pair.left].room;
    const Index right = system_->blocks[pair.left + 1].room;
    kernels::lump(pair.weights, 0, left, pair.limits.data(), lumped_->as_left.data() + pair.begin);
    kernels::lump(pair.weights, left, right, pair.limits.data(), lumped_->as_right.data() + pair.begin + left);
  }
}

void Openings::look(const double* q, const double* q_end, const double* rise) {
  for (Pair& pair : pairs_) {
    const Index begin = pair.begin;
    kernels::lowest_of_rows(pair.weights, q + begin, q_end + begin, rise + begin, pair.lowest.data(),
                            pair.beyond.data());
    std::copy_n(pair.lowest.data(), pair.count, lowest_.begin() + static_cast<std::ptrdiff_t>(pair.first));
    std::copy_n(pair.beyond.data(), pair.count, beyond_.begin() + static_cast<std::ptrdiff_t>(pair.first));
  }
}

}  // namespace bentur::engine
