#pragma once

#include <cmath>
#include <limits>

namespace bentur {

/// What a hinge bears as it turns further and further (H-17): M_y and Hθ up to the cap, down towards zero, what it
/// keeps for good, nothing.
struct HingeBackbone {
  /// Moments at yielding of either sense, that at rest included [force·length] > 0, and what is borne at rest.
  double clockwise = 0, anticlockwise = 0, at_rest = 0;
  double plastic = std::numeric_limits<double>::infinity();    ///< θ_c [rad] > 0, from yielding to the cap
  double softening = std::numeric_limits<double>::infinity();  ///< θ_pc [rad] > 0, from the cap to no moment
  double residual = 0;                                         ///< of the moment at yielding [-], in [0, 1)
  double ultimate = std::numeric_limits<double>::infinity();  ///< θ_u [rad] > θ_c, at which nothing is borne any more
  [[nodiscard]] bool loses_strength() const { return std::isfinite(plastic); }
  [[nodiscard]] bool operator==(const HingeBackbone&) const = default;
};

}  // namespace bentur
