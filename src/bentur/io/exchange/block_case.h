#pragma once

#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/exchange/geojson.h"
#include "bentur/io/exchange/imported_case.h"

namespace bentur {

/// What is taken of a block of houses where its polygons do not say it. Of SI units: m, kN, t.
struct BlockRules {
  double snap = 0.1;                ///< overlaps and corners that turn inwards up to this are trimmed [m]
  bool hull = false;                ///< footprints that are not convex become their hulls
  double clearance = 0.5;           ///< whoever stands at most this far apart may touch [m]
  double storey_height = 3;         ///< [m]
  std::optional<int> storeys = {};  ///< of buildings that have neither storeys nor a height; nothing: an error
  double floor_mass = 1;            ///< per area of floor [t/m²]
  /// Of the first period C_t H^x, H in metres; of concrete moment frames by ASCE 7-16, table 12.8-2 [s].
  double period_coefficient = 0.0466, period_exponent = 0.9;
};

/// A case of buildings in plan, ready to run. Footprints are convex: where an outline is not, but for `snap`, it is an
/// error, or its hull with `hull`, whose mass, centre of mass and inertia stay those of the outline, as they do of one
/// with holes. Of two that overlap by no more than `snap` the later one is cut back, cut_back(); more is an error.
/// Storeys of a building are of one stiffness, along x and y alike, spread evenly over the floor's area, of which the
/// first period is as the rules say: k_θ = k r² with r² of the area (P-5). All of it is said in `taken`.
/// @return nothing when there is an error, all of which are in `diagnostics`
[[nodiscard]] std::optional<ImportedCase> make_block_case(const Houses& houses, const std::string& file,
                                                          const BlockRules& rules, Diagnostics& diagnostics);

}  // namespace bentur
