#pragma once

#include "bentur/structure/plan/footprint.h"

namespace bentur {

/// A place by WGS 84, as GeoJSON has it [degrees].
struct GeographicPlace {
  double longitude = 0, latitude = 0;
};

/// East and north of `middle` [m], y along the meridian by its radius of curvature M at the middle's latitude φ₀, x
/// along its parallel, of radius N cos φ₀ [Snyder1987, (4-18) for M, (4-20) for N]: the equirectangular projection
/// of the ellipsoid. Lengths near the middle are true but for a part of y tan φ₀/N along x.
[[nodiscard]] PlanPoint local_plan(const GeographicPlace& at, const GeographicPlace& middle);

}  // namespace bentur
