#pragma once

#include <optional>

#include "bentur/structure/plan/footprint.h"

namespace bentur {

/// What two footprints have in common [length²].
[[nodiscard]] double common_area(const Footprint& one, const Footprint& other);

/// The largest part of what is left of `cut` without `kept`; nothing where none has an area.
[[nodiscard]] std::optional<Footprint> largest_rest(const Footprint& cut, const Footprint& kept);

}  // namespace bentur
