#pragma once

#include <vector>

#include "bentur/solve/motion/trail.h"

namespace bentur::engine {

/// The contact points between two neighbours.
struct Neighbours {
  Eigen::Index begin = 0;            ///< first coordinate of the left building; those of the right one follow
  std::size_t first = 0, count = 0;  ///< points
  Eigen::MatrixXd sense;             ///< points × coordinates of both
};
[[nodiscard]] std::vector<Neighbours> neighbours(const ModalSystem& system);

/// Proves that gaps stay open: of many flights by one sum for all points between two buildings (T-4), or point by
/// point.
class Openings {
 public:
  /// `widths`: of the gap at each point [length].
  Openings(const ModalSystem& system, const std::vector<double>& widths);

  /// How many of `count` flights after the last leg of a trail come before the first in which a gap may close.
  [[nodiscard]] Eigen::Index stay_open(const Trail& trail, Eigen::Index count);

  /// Looks at every point over an interval whose coordinates leave the chords between q and q_end by `rise` at most.
  /// Whether all gaps stay open.
  bool look(const double* q, const double* q_end, const double* rise);
  /// Whether one of them does, as was found then.
  [[nodiscard]] bool stays_open(std::size_t point) const { return open_[point] != 0; }

 private:
  struct Pair {
    Neighbours points;
    kernels::PackedRows weights;  ///< −sense
    Eigen::VectorXd widths;
    Eigen::VectorXd lumped;                 ///< c of (T-4)
    Eigen::VectorXd peak, inverse, values;  ///< room
    Eigen::VectorXd shares, betweens;       ///< of flights
  };
  std::vector<Pair> pairs_;
  Eigen::Index stride_;
  std::vector<char> open_;
};

}  // namespace bentur::engine
