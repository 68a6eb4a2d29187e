#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/pounding/response.h"
#include "bentur/structure/building.h"

namespace bentur {

/// Hinges of a building that have yielded, those that turned furthest first. Of hinges alike but for round-off, as a
/// symmetric frame has them, the one with the smaller number stands first.
[[nodiscard]] std::vector<Eigen::Index> worst_hinges(const BuildingPeaks& peaks);

/// Joints of a frame at which all member ends have yielded without hardening, and whose capacities balance exactly, so
/// that all flow at once: their rotations are one of infinitely many solutions, which have the same displacements,
/// moments and energy. A list of hinges each.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> indeterminate_joints(const Hinges& hinges,
                                                                          const BuildingPeaks& peaks);

}  // namespace bentur
