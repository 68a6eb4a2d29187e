#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bentur/pounding/response.h"
#include "bentur/solve/system.h"

// What is watched in the free response where two neighbours face one another, for rules.
namespace bentur {

/// −δ of each level, contacts first and watched interfaces after them, and the sways of faces that are no floors, x and
/// −x, relative to the own base. @param is_floor of a level and its left (0) or right (1) face
[[nodiscard]] std::vector<Interface> level_interfaces(const std::vector<Interface>& levels,
                                                      const std::function<bool(std::size_t level, int side)>& is_floor);

/// Puts how far they went into summaries of the same levels. @param reversed whether −δ is what the reversed motion
/// needs @param peak_of the free peak [length] of the floor that a face is; nothing of one that is none
void report_levels(const std::vector<Reach>& reaches, bool reversed,
                   const std::function<std::optional<double>(std::size_t level, int side)>& peak_of,
                   std::vector<PointSummary>& points, std::vector<WatchedSummary>& watched);

}  // namespace bentur
