#pragma once

#include <cstddef>
#include <vector>

#include "bentur/solve/system.h"

namespace bentur::engine {

/// Ground acceleration of one body over one segment: the solution of a'' = −ν²a with a(0) = value, a'(0) = slope
/// (ν = 0: linear). value [length/s²], slope [length/s³].
struct GroundInput {
  double value = 0;
  double slope = 0;
};

/// Times between which the ground acceleration of every body is smooth. The pattern of lengths repeats with the
/// record's step, the period of the grid, so there are at most as many lengths as bodies (plus one), whatever the
/// delays.
class TimeGrid {
 public:
  /// A motion without samples is cut into segments short against it only where `fine`.
  explicit TimeGrid(const System& system, bool fine = true);

  /// Number of different segment lengths; segment m has the length of kind m % kinds().
  [[nodiscard]] std::size_t kinds() const { return offsets_.size(); }
  [[nodiscard]] double length(std::size_t kind) const;  ///< [s]
  [[nodiscard]] double start(long segment) const;       ///< [s]
  /// Of the segment of a kind in a period.
  [[nodiscard]] double start(long period, std::size_t kind) const {
    return static_cast<double>(period) * period_ + offsets_[kind];
  }

  /// Input of each body from the start of the segment on.
  void input(long segment, std::vector<GroundInput>& inputs) const;
  void input(long period, std::size_t kind, std::vector<GroundInput>& inputs) const;

 private:
  struct Delay {
    long steps = 0;          ///< whole grid periods
    std::size_t offset = 0;  ///< index into offsets_
  };
  [[nodiscard]] GroundInput input_at(long period, double within) const;

  const GroundMotion* motion_;
  double period_ = 0;            ///< [s] the record's step, or a fraction of the governing period
  std::vector<double> offsets_;  ///< [s] ascending, the first 0
  std::vector<Delay> delays_;    ///< per body
};

}  // namespace bentur::engine
