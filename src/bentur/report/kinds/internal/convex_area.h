#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// Adds the area of a convex polygon to a curve that is filled, behind what it has by now.
void add_area(Curve& curve, const std::vector<Eigen::Vector2d>& corners);

}  // namespace bentur
