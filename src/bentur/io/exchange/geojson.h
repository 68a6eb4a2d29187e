#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/exchange/imported_case.h"
#include "bentur/structure/plan/footprint.h"

// Footprints of buildings as GeoJSON has them (RFC 7946).
namespace bentur {

/// A building of which a file says what it covers, and perhaps how high it is.
struct House {
  std::string name;         ///< different from the others'
  SourcePosition position;  ///< of its feature
  std::string key;          ///< what messages call it, `features[3] ("Mill")`
  /// Corners in their order, either way round, none twice in a row, to the millimetre [m].
  std::vector<PlanPoint> outline;
  std::vector<std::vector<PlanPoint>> holes;
  std::optional<int> storeys;
  std::optional<double> height;  ///< [m]
};

struct Houses {
  std::vector<House> all;            ///< in the order of the file, from its middle
  std::string middle;                ///< where that is, in words
  std::vector<std::string> renamed;  ///< names that others had
  std::vector<UnreadLines> unread;
};

/// The polygons of a FeatureCollection: `name`, else the feature's id; `building:levels`, `levels` or `storeys`;
/// `height` in metres. Longitudes and latitudes are projected about their middle, local_plan(). At most 200 polygons of
/// at most 1000 corners, 2 km from end to end. Other geometries and properties are listed as unread.
/// @param metres coordinates are taken as they are, east and north [m]
/// @return nothing when there is an error, all of which are in `diagnostics`
[[nodiscard]] std::optional<Houses> read_geojson(const std::string& text, const std::string& name, bool metres,
                                                 Diagnostics& diagnostics);

}  // namespace bentur
