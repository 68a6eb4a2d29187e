#pragma once

#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// A shear building: one mass and one lateral spring per storey.
struct Stick {
  std::vector<double> storey_heights;  ///< [length], bottom to top
  std::vector<double> masses;          ///< [mass]
  std::vector<double> stiffnesses;     ///< [force/length] of each storey
};

/// One sway per floor: M diagonal, K tridiagonal, load = the masses. `base_elevation` as assemble_plane_frame().
/// @throws InvalidParameter when list lengths disagree, or a value is not finite and > 0 (`base_elevation`: not
/// finite).
[[nodiscard]] StructuralModel stick_model(const Stick& stick, double base_elevation = 0.0);

}  // namespace bentur
