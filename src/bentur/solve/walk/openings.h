#pragma once

#include <vector>

#include "bentur/solve/motion/flight.h"

namespace bentur::engine {

/// How low the openings of all contact points can come in a free flight: first of all points between two buildings by
/// one sum, then point by point.
class Openings {
 public:
  explicit Openings(const ModalSystem& system);

  /// What is asked of the points: −(sense_i q) is to stay below `limits`. May be called again with higher ones.
  void limit(const std::vector<double>& limits);

  /// True when no point can have come to its limit in a flight between two states.
  [[nodiscard]] bool stay_open(const State& from, const State& to, const Flight::Bounds& bounds);

 private:
  /// The points between two neighbours.
  struct Pair {
    Eigen::Index begin = 0;        ///< first coordinate of the left building; those of the right one follow
    std::size_t first = 0, count;  ///< points
    kernels::PackedRows weights;   ///< points × coordinates: sense
    Eigen::VectorXd lumped;        ///< c_j = max_i |sense_ij|/limit_i: Σ c_j |q_j| < 1 keeps all points open  (T-4)
    Eigen::VectorXd lowest, beyond;
  };
  std::vector<Pair> pairs_;
  std::vector<double> limits_;
};

}  // namespace bentur::engine
