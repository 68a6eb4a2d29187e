#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

using GeoNode = nlohmann::json;

/// A feature of a GeoJSON text, whatever it holds.
struct GeoFeature {
  GeoNode node;
  SourcePosition position;
};

/// The features of a GeoJSON text, in their order.
struct GeoText {
  std::vector<GeoFeature> features;
  GeoNode crs;  ///< of the collection; null where there is none
};

/// Of a FeatureCollection, of one Feature (RFC 7946), or of features one after the other, a line each, with or without
/// the record separators of RFC 8142.
/// @return nothing when it is none of them, as `diagnostics` says
[[nodiscard]] std::optional<GeoText> read_geo_text(const std::string& text, const std::string& file,
                                                   Diagnostics& diagnostics);

}  // namespace bentur
