#pragma once

#include <memory>
#include <vector>

#include "bentur/elements/law_entry.h"

namespace bentur {

/// What bearings are to the building above: the stiffness they begin with, and their law where they yield.
struct Bearings {
  double stiffness = 0;                           ///< [force/length] > 0
  std::shared_ptr<const HystereticLaw> law = {};  ///< null: they are linear
  double strength = 0;                            ///< Q of that law [force]
};

/// Bearings that yield: (L-1) with k = stiffness + Q/Δ_y, r = stiffness/k, V_y = Q + stiffness Δ_y; linear where Q = 0.
///
/// @param stiffness after yielding; of linear bearings all of it [force/length] > 0
/// @param strength Q, the force where the yielding branch crosses Δ = 0 [force] ≥ 0
/// @param yield_displacement Δ_y [length] > 0 where Q > 0
/// @throws InvalidParameter when a value is outside its range.
[[nodiscard]] Bearings bilinear_bearings(double stiffness, double strength, double yield_displacement);

/// Laws of bearings. The first has its keys in [building.isolation] itself, each other one in a table there that has
/// its name.
[[nodiscard]] const std::vector<LawEntryOf<Bearings>>& bearing_laws();

}  // namespace bentur
