#pragma once

#include <vector>

#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/run/bounded_outputs.h"

namespace bentur::engine {

/// The gaps between two neighbours: how far their points come together.
struct Gaps {
  Eigen::Index first = 0, count = 0;  ///< points
  Eigen::Index begin = 0;             ///< first coordinate of the left building; those of the right one follow
  BoundedOutputs closing;             ///< −(sense_i q)
  Eigen::VectorXd reach;              ///< of these, in the interval last looked at

  /// Looks at an interval whose coordinates leave the chords between q and q_end by `rise` at most, lists of all
  /// coordinates. Whether no reach exceeds its peak so far.
  bool look(const double* q, const double* q_end, const double* rise);
};
/// Of points that are ordered by their left buildings.
[[nodiscard]] std::vector<Gaps> gaps_between(const std::vector<ModalSystem::Point>& points);

/// Proves that gaps stay open: of many flights by one sum for all points between two buildings (T-4), or point by
/// point.
class GapMonitor {
 public:
  /// `widths`: of the gap at each point [length].
  GapMonitor(const ModalSystem& system, std::vector<double> widths);

  /// How many of `count` flights after the last step of a buffer come before the first in which a gap may close.
  [[nodiscard]] Eigen::Index stay_open(const StepBuffer& buffer, Eigen::Index count);

  /// Looks at every point over such an interval. Whether all gaps stay open.
  bool look(const double* q, const double* q_end, const double* rise);
  /// Whether one of them does, as was found then.
  [[nodiscard]] bool stays_open(Eigen::Index point) const { return open_[point] != 0; }

 private:
  std::vector<double> widths_;
  std::vector<Gaps> gaps_;  ///< limited by the widths
  Eigen::Index stride_;
  std::vector<char> open_;
};

}  // namespace bentur::engine
