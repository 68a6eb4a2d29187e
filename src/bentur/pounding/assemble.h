#pragma once

#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/solve/system.h"

namespace bentur {

/// A valid problem as the solver takes it. @param levels both faces of each level are watched in the free response too
/// @throws InvalidParameter of a building known by its peaks alone
[[nodiscard]] System system_of(const Problem& problem, bool levels = false);

/// Index of the floor that a face is of a level, points first and watched floors after them; nothing of a column's.
[[nodiscard]] std::optional<Eigen::Index> face_floor(const Problem& problem, std::size_t level, int side);

}  // namespace bentur
