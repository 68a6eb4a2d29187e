#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/exact/series.h"
#include "bentur/solve/response.h"

namespace bentur::exact {

/// Keeps the extrema of every reported quantity of every building. Peaks are those of the continuous response: an
/// interval is looked into unless its ends and a proven bound of its curvature show that it cannot raise a peak.
class PeakWatch {
 public:
  enum class Scope { displacement, everything };
  PeakWatch(const ModalSystem& system, Scope scope);

  /// Takes the start of the run in.
  void start(const State& state);

  /// For a segment of free flight from `from` to `to`: takes both ends in and puts into `reach` what the quantities of
  /// the building can have reached in between at most (rows of Block::outputs, then accelerations), given bounds of |q̈|
  /// and |d⁴q/dt⁴| times length²/8 per coordinate. Returns whether that stays below the peaks so far.
  [[nodiscard]] bool settled_by_bound(std::size_t block, const State& from, const State& to,
                                      const Eigen::VectorXd& start_acceleration,
                                      const Eigen::VectorXd& end_acceleration, const Eigen::VectorXd& curvature,
                                      const Eigen::VectorXd& acceleration_curvature, Eigen::VectorXd& reach);

  /// Whether a segment that could reach `reach` at most cannot raise a peak any more.
  [[nodiscard]] bool settled(std::size_t block, const Eigen::VectorXd& reach) const;

  /// Searches [0, end] of the expanded step of one building; `from` and `to` are the states at 0 and `end`.
  void scan(std::size_t block, const Series& series, double end, const State& from, const State& to);

  /// Copies what was kept into the response of one building (displacement only, in its narrower scope).
  void report(std::size_t block, BuildingPeaks& peaks) const;

 private:
  struct Rows {
    Eigen::MatrixXd weights, weights_abs;  ///< rows × coordinates of the building
    Eigen::VectorXd start, end, bound;     ///< room: values at the ends of the interval
    Eigen::VectorXd peak;                  ///< largest absolute values so far
    Eigen::VectorXd acceleration;          ///< largest absolute accelerations so far, floors (or none)
  };

  const ModalSystem* system_;
  Scope scope_;
  std::vector<Rows> rows_;  ///< displacement [, drift, shear]
};

}  // namespace bentur::exact
