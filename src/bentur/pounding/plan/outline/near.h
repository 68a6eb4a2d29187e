#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bentur/structure/plan/footprint.h"

namespace bentur {

/// Of footprints all pairs whose joint_between() may have a width of at most `reach` ≥ 0 [length], and all that
/// overlap: the earlier one first, in their order. Some that are further apart may be among them.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pairs_near(const std::vector<Footprint>& footprints,
                                                                          double reach);

}  // namespace bentur
