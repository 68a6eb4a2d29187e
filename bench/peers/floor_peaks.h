#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bentur/pounding/problem.h"

namespace bentur::bench {

/// Peak displacement, drift and storey shear of every floor, as whoever integrates (1) of equations.h step by step
/// would find them: at each step's end their values and rates, and where a rate has changed its sign the maximum of the
/// cubic through both ends. Accelerations, which `exact` finds too, are left out.
class FloorPeaks {
 public:
  explicit FloorPeaks(const Problem& problem);

  /// The state y at `time` [s], which ends a step.
  void look(double time, const double* y);

  /// Largest displacement, drift ratio and shear so far, floor by floor, building by building.
  [[nodiscard]] const std::vector<Eigen::VectorXd>& peaks() const { return peaks_; }

 private:
  std::size_t modes_ = 0;
  double time_ = 0;
  std::vector<Eigen::MatrixXd> of_displacement_, of_speed_;  // quantities of a building from its part of y₁ and y₂
  std::vector<Eigen::VectorXd> values_, rates_, new_values_, new_rates_, peaks_;
};

}  // namespace bentur::bench
