#include "bentur/solve/walk/openings.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;

Openings::Openings(const ModalSystem& system) : limits_(system.points.size(), 0.0) {
  for (std::size_t i = 0; i < system.points.size(); ++i) {
    const auto& point = system.points[i];
    if (pairs_.empty() || pairs_.back().begin != point.left_begin) {
      Pair pair;
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
    pair.lowest.resize(pair.weights.rows());
    pair.beyond.resize(pair.weights.rows());
  }
  limit(limits_);
}

void Openings::limit(const std::vector<double>& limits) {
  limits_ = limits;
  for (Pair& pair : pairs_) {
    pair.lumped.setZero(pair.weights.columns());
    for (std::size_t n = 0; n < pair.count; ++n) {
      const double rate = 1.0 / limits[pair.first + n];
      for (Index j = 0; j < pair.lumped.size(); ++j) {
        const double weight = std::abs(pair.weights(static_cast<Index>(n), j));
        if (weight != 0.0) pair.lumped(j) = std::max(pair.lumped(j), weight * rate);
      }
    }
  }
}

bool Openings::stay_open(const State& from, const State& to, const Flight::Bounds& bounds) {
  for (Pair& pair : pairs_) {
    const Index begin = pair.begin;
    if (kernels::dot(pair.lumped.size(), pair.lumped.data(), bounds.position.data() + begin) < 1.0) continue;
    kernels::lowest_of_rows(pair.weights, from.q.data() + begin, to.q.data() + begin, bounds.rise.data() + begin,
                            pair.lowest.data(), pair.beyond.data());
    for (std::size_t n = 0; n < pair.count; ++n) {
      const auto row = static_cast<Index>(n);
      const double lowest = limits_[pair.first + n] + pair.lowest(row);
      if (!(lowest > 0.0 && lowest > pair.beyond(row))) return false;
    }
  }
  return true;
}

}  // namespace bentur::engine
