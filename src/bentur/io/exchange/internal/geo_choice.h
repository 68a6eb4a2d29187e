#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/exchange/geojson.h"
#include "bentur/io/exchange/internal/geo_text.h"
#include "bentur/structure/plan/footprint.h"

// Which features of a GeoJSON text are houses that are wanted, before these are read.
namespace bentur {

/// As messages show it.
[[nodiscard]] std::string shown_geo(const GeoNode& node);

/// What a table has under a key; nothing where it has none, or null, or is no table.
[[nodiscard]] const GeoNode* geo_member(const GeoNode& node, const char* key);

/// A place of a ring, longitude and latitude or east and north.
[[nodiscard]] std::optional<PlanPoint> geo_place(const GeoNode& node);

/// Whether a place can be one: on the globe, or within 1e8 m.
[[nodiscard]] bool is_geo_place(const PlanPoint& at, bool metres);

/// From a middle, both as the file has them [m].
[[nodiscard]] PlanPoint geo_plan(const PlanPoint& at, const PlanPoint& middle, bool metres);

/// How a house is left out, at the end of an error.
[[nodiscard]] std::string without_it(const House& house);

/// A feature that is a polygon, not read yet.
struct GeoCandidate {
  House house;        ///< what messages call it
  std::string asked;  ///< its name in the file
  std::string id;     ///< in the file; empty: none
  const GeoNode* properties = nullptr;
  const GeoNode* coordinates = nullptr;
  bool is_multi = false;
  bool is_wanted = true;
  Diagnostics faults;  ///< of its name, which are errors only of a house that is wanted

  [[nodiscard]] bool is_called(const std::string& name) const {
    return name == house.name || name == asked || (!id.empty() && name == id);
  }
  /// Rings of each of its polygons.
  [[nodiscard]] std::vector<const GeoNode*> polygons() const;
  /// Of one of its polygons, from 1.
  [[nodiscard]] std::string name_of_part(std::size_t part) const;
};

/// Features that are polygons and wanted.
struct GeoChoice {
  bool is_made = true;                ///< else nobody knows who is wanted, and only that is reported
  std::vector<GeoCandidate> houses;   ///< they point into the features
  std::vector<std::string> left_out;  ///< who is, and why, in sentences
  std::vector<std::pair<std::string, const GeoFeature*>> unread;  ///< kinds of geometry
  std::set<std::string> names;                                    ///< of all that have one, wanted or not
};

/// Those that `options` ask for, each under a name that no other has. What is wrong about the options, and what is no
/// feature, is in `diagnostics`.
[[nodiscard]] GeoChoice choose_houses(const std::vector<GeoFeature>& features, const std::string& file,
                                      const GeoJsonOptions& options, Diagnostics& diagnostics);

}  // namespace bentur
