#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "bentur/solve/engine/motion/kernels/rows.h"

namespace bentur::engine {

/// Quantities linear in some coordinates (or in their accelerations), and their largest values so far: of their sizes,
/// or of themselves. An offset may be added to each. Quantities come in fours; rows of zeros fill the last four up.
class BoundedOutputs {
 public:
  /// `weights`: quantities × coordinates, filled up with zeros to `columns`.
  BoundedOutputs(const Eigen::MatrixXd& weights, Eigen::Index columns, kernels::Peaks of);

  [[nodiscard]] Eigen::Index size() const { return peak.size(); }
  [[nodiscard]] const kernels::PackedRows& weights() const { return weights_; }

  /// Takes in the coordinates at the ends of `steps` steps, StepBuffer::most at most, and how far they leave their
  /// chords in between; each list `stride` after the one before. What follows then learns of limits, which raise()
  /// makes the peaks and compare() leaves as they are.
  void raise(Eigen::Index steps, const double* x, const double* rise, Eigen::Index stride);
  void compare(Eigen::Index steps, const double* x, const double* rise, Eigen::Index stride);
  void limit(const Eigen::VectorXd& limits);
  /// Only the values at the ends, which raise the peaks.
  void take_ends(Eigen::Index steps, const double* x, Eigen::Index stride);

  [[nodiscard]] Eigen::Index steps() const { return ends_ - 1; }
  // Of these; not finite where a quantity that moves has a limit of zero, as one that has not moved yet:
  /// No quantity goes further than by this part of its limit beyond its values at the ends.
  [[nodiscard]] double between(Eigen::Index step) const { return betweens_(step); }
  /// No quantity goes further than to this part of its limit (T-4).
  [[nodiscard]] double share(Eigen::Index step) const {
    return std::max(shares_(step), shares_(step + 1)) + betweens_(step);
  }
  /// Whether that does not prove that no limit is exceeded.
  [[nodiscard]] bool unsettled(Eigen::Index step) const { return !(share(step) <= 1.0); }
  /// How far a quantity leaves its chord where coordinates leave theirs by `rise`: what between() says of all of them.
  [[nodiscard]] double rise(Eigen::Index quantity, const double* rise) const;
  /// `before` becomes zero for the fours that stay below their peaks, infinite for others.
  void mark_unsettled(Eigen::Index step, double* before) const;
  /// The larger of both values of a quantity (of their sizes).
  [[nodiscard]] double larger_value(Eigen::Index quantity, Eigen::Index step) const {
    const double* at = values_.data() + place(quantity, step);
    return std::max(at[0], at[4]);
  }
  /// What four quantities from a multiple of four on (their sizes) were at all ends, one after the other: that of step
  /// n is n + 1.
  [[nodiscard]] const double* values(Eigen::Index quantity) const { return values_.data() + place(quantity, 0); }
  /// between() of all steps.
  [[nodiscard]] const double* betweens() const { return betweens_.data(); }

  /// Takes two vectors in, and returns whether the reach of all quantities between them stays below their peaks.
  /// Fours whose reach `before` in a whole that this is a part of was below are not looked at. `before` may be `reach`.
  [[nodiscard]] bool settled(const double* start, const double* end, const double* rise, const double* before,
                             double* reach) {
    return kernels::reach_of_rows(of_, weights_, offset.data(), start, end, rise, peak.data(), before, reach);
  }

  /// The same of two ends with cubics in between.
  [[nodiscard]] bool settled(const kernels::CubicCurves& curves, const double* before, double* reach) {
    return kernels::reach_of_cubics(of_, weights_, offset.data(), curves, peak.data(), before, reach);
  }

  Eigen::VectorXd peak;
  Eigen::VectorXd offset;  ///< of each quantity: what it is where all coordinates are zero

 private:
  /// Of that value.
  [[nodiscard]] Eigen::Index place(Eigen::Index quantity, Eigen::Index end) const {
    return quantity / 4 * 4 * ends_ + 4 * end + quantity % 4;
  }
  void measure(Eigen::Index steps, const double* rise, Eigen::Index stride);
  [[nodiscard]] bool part_columns(const double* x, Eigen::Index stride);

  kernels::Peaks of_;
  kernels::PackedRows weights_;
  Eigen::VectorXd lumped_;   ///< c of (T-4)
  Eigen::VectorXd inverse_;  ///< of the limits
  Eigen::VectorXd values_, shares_, betweens_;
  Eigen::Index ends_ = 0;
  std::vector<char> moves_, stays_;  ///< scratch: per column
  Eigen::VectorXd base_, none_;      ///< scratch: what columns that stay come to
};

}  // namespace bentur::engine
