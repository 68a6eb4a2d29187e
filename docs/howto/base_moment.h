#pragma once

#include "bentur/structure/body.h"

namespace bentur {

/// The overturning moment at the base of a building [force·length], as an output with a peak: Σ h (K x) of its floors,
/// h their heights above the base. `kind`: one that the body does not have yet.
[[nodiscard]] inline Outputs base_moment(const Building& building, OutputKind kind) {
  const StructuralModel& model = building.model;
  const double base = model.elevations.front() - model.storey_heights.front();
  Eigen::RowVectorXd heights = Eigen::RowVectorXd::Zero(model.dofs());
  for (Eigen::Index f = 0; f < model.floors(); ++f) heights(f) = model.elevations[f] - base;
  return {.kind = kind, .count = 1, .rows = heights * model.stiffness, .has_peak = true};
}

}  // namespace bentur
