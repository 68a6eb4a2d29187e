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
  /// Corners in their order, in either direction, none twice in a row, to the millimetre [m].
  std::vector<PlanPoint> outline;
  std::vector<std::vector<PlanPoint>> holes;
  std::optional<int> storeys;
  std::optional<double> height;  ///< [m]
};

struct Houses {
  std::vector<House> all;             ///< in the order of the file, from its middle
  std::string middle;                 ///< where that is, in words
  std::vector<std::string> renamed;   ///< names that others had
  std::vector<std::string> left_out;  ///< who is, and why, in sentences
  std::vector<std::string> taken;     ///< what was read otherwise than it stands, in sentences
  std::vector<UnreadLines> unread;
};

/// Which houses of a file are read, and how.
struct GeoJsonOptions {
  bool metres = false;                    ///< coordinates are taken as they are, east and north [m]
  bool parts = false;                     ///< the parts of a MultiPolygon are houses of their own; else an error
  std::string levels = {};                ///< a property that has storeys, before the usual ones; empty: these alone
  std::string around = {};                ///< a name, an id or "LON,LAT", near which houses are kept; empty: all are
  double radius = 50;                     ///< how near [m]
  std::vector<std::string> without = {};  ///< names and ids of houses that are left out
  bool unread_as_none = false;            ///< storeys and heights that cannot be read are as if not given; else errors
};

/// The polygons of a FeatureCollection, of a Feature or of features one a line: `name`, else the feature's id;
/// `building:levels`, `levels`, `storeys` or `num_floors`, storeys_tag(); `height`, height_tag(); of the properties and
/// of `tags` among them. Longitudes and latitudes are projected about their middle, local_plan(). At most 1000 polygons
/// of at most 1000 corners, 2 km from end to end. Other geometries and properties are listed as unread.
/// @return nothing when there is an error, all of which are in `diagnostics`
[[nodiscard]] std::optional<Houses> read_geojson(const std::string& text, const std::string& name,
                                                 const GeoJsonOptions& options, Diagnostics& diagnostics);

}  // namespace bentur
