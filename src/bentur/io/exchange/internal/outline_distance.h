#pragma once

#include <vector>

#include "bentur/structure/plan/footprint.h"

namespace bentur {

/// The least distance of two areas [length], 0 where they meet. Each is what its corners go round, convex or not; one
/// corner is a place.
[[nodiscard]] double outline_distance(const std::vector<PlanPoint>& one, const std::vector<PlanPoint>& other);

/// That of the rectangles around them, which is no more.
[[nodiscard]] double distance_of_boxes(const std::vector<PlanPoint>& one, const std::vector<PlanPoint>& other);

}  // namespace bentur
