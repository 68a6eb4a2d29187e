#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "bentur/solve/system.h"

namespace bentur::engine {

/// A component of the ground acceleration of one body over one segment: the solution of a'' = −ν²a with a(0) = value,
/// a'(0) = slope (ν = 0: linear). value [length/s²], slope [length/s³].
struct GroundInput {
  double value = 0;
  double slope = 0;

  [[nodiscard]] bool operator==(const GroundInput&) const = default;
  /// `dt` [s] later.
  [[nodiscard]] GroundInput later(double dt, double nu) const {
    if (nu == 0.0) return {value + slope * dt, slope};
    const double c = std::cos(nu * dt);
    const double s = std::sin(nu * dt);
    return {value * c + slope / nu * s, slope * c - value * nu * s};
  }
};

/// Times between which the ground acceleration of every body is smooth. The pattern of lengths repeats with the
/// record's step, the period of the grid, so there are at most as many lengths as bodies (plus one), whatever the
/// delays. Of records with different steps the period is the shortest time of which all are whole parts.
class TimeGrid {
 public:
  /// A motion without samples is cut into segments short against it only where `fine`.
  /// @throws InvalidParameter when that period has more than 64 steps of some record
  explicit TimeGrid(const System& system, bool fine = true);

  /// Number of different segment lengths; segment m has the length of kind m % kinds().
  [[nodiscard]] std::size_t kinds() const { return offsets_.size(); }
  [[nodiscard]] double length(std::size_t kind) const;  ///< [s]
  [[nodiscard]] double start(long segment) const;       ///< [s]
  /// Of the segment of a kind in a period.
  [[nodiscard]] double start(long period, std::size_t kind) const {
    return static_cast<double>(period) * period_ + offsets_[kind];
  }

  /// The first of the bodies under which the ground moves when it moves under this one.
  [[nodiscard]] std::size_t first_with(std::size_t body) const { return delays_[body].first; }
  /// Inputs of each body, one per component, from the start of the segment on.
  void input(long segment, std::vector<GroundInput>& inputs) const;
  void input(long period, std::size_t kind, std::vector<GroundInput>& inputs) const;

 private:
  struct Delay {
    long periods = 0;        ///< whole ones of the grid
    std::size_t offset = 0;  ///< index into offsets_
    std::size_t first = 0;   ///< body with the same
  };
  [[nodiscard]] GroundInput input_at(std::size_t component, long period, double within) const;

  const std::vector<GroundMotion>* motions_;
  double period_ = 0;            ///< [s] the record's step, or a fraction of the governing period
  std::vector<long> steps_;      ///< per component: of a record in the period; 1 of others
  std::vector<double> offsets_;  ///< [s] ascending, the first 0
  std::vector<Delay> delays_;    ///< per body
};

}  // namespace bentur::engine
