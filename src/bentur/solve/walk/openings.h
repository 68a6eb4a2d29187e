#pragma once

#include <vector>

#include "bentur/solve/motion/kernels/flights.h"
#include "bentur/solve/motion/modal_system.h"

namespace bentur::engine {

/// How low the openings of all contact points can come in an interval: by weights for one sum for all points between
/// two buildings (T-4), and point by point.
class Openings {
 public:
  /// Keeps the weights of that sum in `lumped`, as_left and as_right.
  Openings(const ModalSystem& system, kernels::Lumped& lumped);

  /// What is asked of the points: −(sense_i q) is to stay below `limits`. May be called again with higher ones.
  void limit(const std::vector<double>& limits);

  /// Looks at every point over an interval whose coordinates leave the chords between q and q_end by `rise` at most.
  void look(const double* q, const double* q_end, const double* rise);
  /// What was found: the lower of sense_i q at both ends, and how far below that it can be in between [length].
  [[nodiscard]] double lowest(std::size_t point) const { return lowest_[point]; }
  [[nodiscard]] double beyond(std::size_t point) const { return beyond_[point]; }
  [[nodiscard]] bool below(std::size_t point) const {
    const double left = limits_[point] + lowest_[point];
    return left > 0.0 && left > beyond_[point];
  }

 private:
  /// The points between two neighbours.
  struct Pair {
    std::size_t left = 0;          ///< building
    Eigen::Index begin = 0;        ///< first coordinate of the left building; those of the right one follow
    std::size_t first = 0, count;  ///< points
    kernels::PackedRows weights;   ///< points × coordinates: sense
    Eigen::VectorXd limits, lowest, beyond;
  };
  const ModalSystem* system_;
  kernels::Lumped* lumped_;
  std::vector<Pair> pairs_;
  std::vector<double> limits_, lowest_, beyond_;
};

}  // namespace bentur::engine
