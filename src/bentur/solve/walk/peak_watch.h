#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/motion/expansion.h"
#include "bentur/solve/response.h"

namespace bentur::engine {

/// Keeps the extrema of every reported quantity of every building. Peaks are those of the continuous response: an
/// interval is looked into unless its ends and a proven bound of its curvature show that it cannot raise a peak.
class PeakWatch {
 public:
  enum class Scope { displacement, everything };
  PeakWatch(const ModalSystem& system, Scope scope);

  [[nodiscard]] Scope scope() const { return scope_; }

  /// Takes the start of the run in.
  void start(const State& state);

  /// What may be known of one interval without looking into it.
  struct Interval {
    const State& from;  ///< at its ends
    const State& to;
    const Eigen::VectorXd& start_acceleration;  ///< q̈ at its ends
    const Eigen::VectorXd& end_acceleration;
    const Eigen::VectorXd& rise;               ///< bound of |q̈| times length²/8, per coordinate
    const Eigen::VectorXd& acceleration_rise;  ///< bound of |d⁴q/dt⁴| times length²/8
  };

  /// How far each quantity of one building can have gone in an interval at most.
  struct Reach {
    Eigen::ArrayXd positions;      ///< displacement [, drift ratio, storey shear], as Block::outputs
    Eigen::ArrayXd accelerations;  ///< absolute accelerations of the floors
  };

  /// Takes both ends in, and returns whether the reach of the interval stays below the peaks so far.
  [[nodiscard]] bool settled_by_bound(std::size_t block, const Interval& interval, Reach& reach);

  /// Largest ratio of a reach to the peak so far; up to 1 the interval is settled.
  [[nodiscard]] double excess(std::size_t block, const Reach& reach) const;

  /// Searches the whole expanded step of one building for what its reach leaves open.
  void scan(std::size_t block, const Expansion& motion, const Reach& reach);

  /// Copies what was kept into the response of one building (displacement only, in its narrower scope).
  void report(std::size_t block, BuildingPeaks& peaks) const;

 private:
  /// Quantities linear in the coordinates of one building, and their largest absolute values so far. The number of
  /// rows is made a multiple of four by rows of zeros, so that a processor takes four at a time.
  struct Rows {
    Eigen::MatrixXd weights;
    Eigen::ArrayXd peak;

    explicit Rows(const Eigen::MatrixXd& quantities);
    bool take(const double* start, const double* end, const double* rise, Eigen::ArrayXd& reach);
  };

  const ModalSystem* system_;
  std::vector<Rows> positions_, accelerations_;  ///< per building
  Scope scope_;
};

}  // namespace bentur::engine
