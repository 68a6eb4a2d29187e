#include "bentur/structure/sway.h"

#include <algorithm>
#include <cstddef>

#include "bentur/core/errors.h"

namespace bentur {

double base_of(const StructuralModel& model) { return model.elevations.front() - model.storey_heights.front(); }

StoreyPlace storey_place(const std::vector<double>& elevations, const std::vector<double>& heights, double elevation) {
  const double base = elevations.front() - heights.front();
  const double top = elevations.back();
  const double slack = 1e-6 * (top - base);
  if (!(elevation >= base - slack && elevation <= top + slack)) {
    throw InvalidParameter("elevation", std::to_string(elevation), "must be between the base and the top");
  }
  const auto above = std::lower_bound(elevations.begin(), elevations.end() - 1, elevation);
  const Eigen::Index upper = above - elevations.begin();
  const double length = heights[upper];
  return {upper, length > 0 ? std::clamp(1 - (*above - elevation) / length, 0.0, 1.0) : 1.0};  // a slab has none
}

Eigen::VectorXd sway_at(const StructuralModel& model, double elevation, Face face) {
  const auto [upper, s] = storey_place(model.elevations, model.storey_heights, elevation);
  const double length = model.storey_heights[upper];
  Eigen::VectorXd row = Eigen::VectorXd::Zero(model.dofs());
  const Eigen::MatrixXd& joints = face == Face::left ? model.left_joints : model.right_joints;
  if (joints.size() == 0) {
    row(upper) += s;
    if (upper > 0) row(upper - 1) += 1 - s;
    if (upper == 0 && model.foundation) row(model.foundation->sway) += 1 - s;
    return row;
  }
  // y = N₁ y₁ + N₂ L θ₁ + N₃ y₂ + N₄ L θ₂, from the bottom up with y to the right: θ = dy/dx is clockwise.
  row(upper) += s * s * (3 - 2 * s);
  row += s * s * (s - 1) * length * joints.row(upper).transpose();
  if (upper > 0) {
    row(upper - 1) += 1 - s * s * (3 - 2 * s);
    row += s * (1 - s) * (1 - s) * length * joints.row(upper - 1).transpose();
  }
  if (model.foundation) {  // joints turn relative to it
    if (upper == 0) row(model.foundation->sway) += 1 - s * s * (3 - 2 * s);
    row(model.foundation->rocking) += s * (1 - s) * (1 - 2 * s) * length;
  }
  return row;
}

}  // namespace bentur
