#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "bentur/structure/support.h"

namespace bentur {

/// [building.isolation]: a slab on bearings, which have a law of elements/bearing_laws.h.
struct IsolationSpec {
  double mass = 0;     ///< of the slab [mass]
  double damping = 0;  ///< of a dashpot beside the bearings [force·s/length]
  std::string law = "bilinear";
  std::map<std::string, double, std::less<>> numbers = {};  ///< what the law has; defaults else
};

/// Bearings that carry `weight` [force] > 0.
/// @throws InvalidParameter when there is no such law or its values do not go together.
[[nodiscard]] Bearings bearings_of(const IsolationSpec& spec, double weight);

/// [building.soil], as given.
struct SoilSpec {
  Soil soil;  ///< with a half-space only mass and inertia are meant
  std::optional<HalfSpace> half_space;
};

/// Springs and dashpots, given or of the half-space.
[[nodiscard]] Soil soil_of(const SoilSpec& spec);

}  // namespace bentur
