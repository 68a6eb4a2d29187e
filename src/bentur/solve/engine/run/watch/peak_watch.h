#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/run/watch/bounded_outputs.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// Keeps the extrema of those outputs of every body that have peaks. Peaks are those of the continuous response: an
/// interval is looked into unless its ends and a proven bound of its curvature show that it cannot raise a peak.
///
/// The quantities of a body are its outputs of positions and, after them, those of accelerations. Their reach in an
/// interval is how far they can have gone at most. What is known of an interval holds for its parts: only quantities
/// with a reach above their peak are looked at again.
class PeakWatch {
 public:
  static constexpr int most_parts = 8;  ///< of a step

  explicit PeakWatch(const ModalSystem& system);

  /// Peaks of all bodies, one after the other.
  [[nodiscard]] Eigen::VectorXd peaks() const;
  /// Goes on with such ones.
  void resume(const Eigen::VectorXd& peaks);

  /// Number of entries in a list of reaches.
  [[nodiscard]] Eigen::Index quantities(std::size_t block) const;
  /// Reaches in an interval of which nothing is known.
  [[nodiscard]] const double* unknown() const { return unknown_.data(); }

  /// Takes in all instants of a buffer.
  void raise(std::size_t block, const StepBuffer& buffer);
  /// The first step of that buffer, from `step` on, that may exceed a peak (T-4); as many as there are where none does.
  /// `before` becomes zero for quantities that do not in that step, unknown for others.
  [[nodiscard]] Eigen::Index next_unsettled(std::size_t block, Eigen::Index step, double* before) const;

  /// One body between two instants, an entry per coordinate of it.
  struct Interval {
    const double *start, *end;                            ///< q
    const double *start_acceleration, *end_acceleration;  ///< q̈
    const double *rise, *acceleration_rise;               ///< how far q and q̈ leave their chords in between
  };
  /// Takes both ends in, and returns whether the reach of the interval stays below the peaks so far. `before`: reach of
  /// a whole that this is a part of; may be `reach` itself.
  [[nodiscard]] bool settled_by_bound(std::size_t block, const Interval& interval, const double* before, double* reach);

  /// The same by cubics, an entry per coordinate: of q, and of q̈.
  [[nodiscard]] bool settled_by_cubics(std::size_t block, const kernels::CubicCurves& positions,
                                       const kernels::CubicCurves& accelerations, const double* before, double* reach);

  /// Takes `parts` + 1 ≤ most_parts + 1 places of a step in, and returns whether the reach between them stays below the
  /// peaks so far.
  [[nodiscard]] bool settled_by_samples(std::size_t block, const Curves& step, int parts, const double* before,
                                        double* reach);

  /// Number of quantities whose reach does not stay below their peaks so far.
  [[nodiscard]] Eigen::Index count_unsettled(std::size_t block, const double* reach) const;

  /// Searches a whole step for what its reach leaves unsettled.
  void scan(std::size_t block, const Curves& step, const double* reach);

  /// Copies what was kept into the outputs of one body, which has an entry for each.
  void report(std::size_t block, std::vector<OutputsFound>& outputs) const;

 private:
  const ModalSystem* system_;
  std::vector<BoundedOutputs> positions_, accelerations_;  ///< per body
  std::vector<double> unknown_;
  Eigen::VectorXd samples_, seconds_, rise_, second_rise_;  ///< scratch
};

}  // namespace bentur::engine
