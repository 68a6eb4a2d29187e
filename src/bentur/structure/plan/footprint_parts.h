#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/structure/plan/footprint.h"

// Buildings that stand in several parts: what their floors join above the ground moves as one (docs/theory/plan.md).
namespace bentur {

/// A polygon with further parts beside it. @param parts rings of corners that break no rule, in either order, from the
/// footprint's corner [length]; they come after the courts
[[nodiscard]] Footprint with_parts(Footprint footprint, std::vector<std::vector<PlanPoint>> parts);

/// The rule that a part breaks, beside the others; nothing where it meets none and is within none.
/// @param ring of those of the footprint
[[nodiscard]] std::optional<std::string> fault_of_part(const Footprint& footprint, std::size_t ring);

}  // namespace bentur
