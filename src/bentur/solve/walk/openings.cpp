#include "bentur/solve/walk/openings.h"

#include <algorithm>
#include <limits>

namespace bentur::engine {

using Eigen::Index;

std::vector<Neighbours> neighbours(const ModalSystem& system) {
  std::vector<Neighbours> pairs;
  for (std::size_t i = 0; i < system.points.size(); ++i) {
    const auto& point = system.points[i];
    if (pairs.empty() || pairs.back().begin != point.left_begin) pairs.push_back({point.left_begin, i, 0, {}});
    ++pairs.back().count;
  }
  for (Neighbours& pair : pairs) {
    const auto& first = system.points[pair.first];
    pair.sense.resize(static_cast<Index>(pair.count), first.left_size + first.right_size);
    for (std::size_t n = 0; n < pair.count; ++n) {
      const auto& point = system.points[pair.first + n];
      pair.sense.row(static_cast<Index>(n)) << point.sense_left.transpose(), point.sense_right.transpose();
    }
  }
  return pairs;
}

Openings::Openings(const ModalSystem& system, const std::vector<double>& widths)
    : stride_(system.size), open_(system.points.size(), 0) {
  for (const Neighbours& points : neighbours(system)) {
    Pair pair{points, kernels::PackedRows(-points.sense, points.sense.cols()), {}, {}, {}, {}, {}, {}, {}};
    const Index rows = pair.weights.rows();
    pair.widths.setZero(rows);
    for (std::size_t n = 0; n < points.count; ++n) pair.widths(static_cast<Index>(n)) = widths[points.first + n];
    pair.lumped.resize(pair.weights.columns());
    kernels::lump(pair.weights, 0, pair.weights.columns(), pair.widths.data(), pair.lumped.data());
    for (auto* list : {&pair.peak, &pair.inverse}) list->setZero(rows);
    pair.values.resize(rows * (Trail::most + 1));
    for (auto* list : {&pair.shares, &pair.betweens}) list->resize(Trail::most + 1);
    pairs_.push_back(std::move(pair));
  }
}

Index Openings::stay_open(const Trail& trail, Index count) {
  const Index first = trail.legs();
  if (count == 1) return look(trail.q(first), trail.q(first + 1), trail.rise(first)) ? 1 : 0;
  for (Pair& pair : pairs_) {
    const Index begin = pair.points.begin;
    kernels::raise_peaks(kernels::Peaks::of_values, pair.weights, count + 1, trail.q(first) + begin, stride_,
                         pair.peak.data(), pair.values.data());
    kernels::largest_shares(pair.weights.rows(), count + 1, pair.values.data(), pair.widths.data(), pair.inverse.data(),
                            pair.shares.data());
    kernels::sums(count, trail.rise(first) + begin, stride_, pair.weights.columns(), pair.lumped.data(),
                  pair.betweens.data());
  }
  for (Index n = 0; n < count; ++n) {
    bool open = true;
    for (const Pair& pair : pairs_) {
      open = open && std::max(pair.shares(n), pair.shares(n + 1)) + pair.betweens(n) < 1.0;
    }
    if (!open && !look(trail.q(first + n), trail.q(first + n + 1), trail.rise(first + n))) return n;
  }
  return count;
}

bool Openings::look(const double* q, const double* q_end, const double* rise) {
  bool all_open = true;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (Pair& pair : pairs_) {
    const Index begin = pair.points.begin;
    pair.values.head(pair.weights.rows()).setConstant(unknown);
    (void)kernels::reach_of_rows(kernels::Peaks::of_values, pair.weights, q + begin, q_end + begin, rise + begin,
                                 pair.peak.data(), pair.values.data(), pair.values.data());
    for (std::size_t n = 0; n < pair.points.count; ++n) {
      const auto row = static_cast<Index>(n);
      const bool open = pair.values(row) < pair.widths(row);
      open_[pair.points.first + n] = open ? 1 : 0;
      all_open = all_open && open;
    }
  }
  return all_open;
}

}  // namespace bentur::engine
