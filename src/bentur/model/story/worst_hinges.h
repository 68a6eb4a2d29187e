#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/pounding/response.h"

namespace bentur {

/// Hinges of a building that have yielded, those that turned furthest first. Of hinges alike but for round-off, as a
/// symmetric frame has them, the one with the smaller number stands first.
[[nodiscard]] std::vector<Eigen::Index> worst_hinges(const BuildingPeaks& peaks);

}  // namespace bentur
