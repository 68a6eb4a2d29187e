#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bentur {

/// What a hinge carries as it turns further and further (H-17): M_y and Hθ up to the cap, down towards zero, what it
/// keeps for good, nothing.
struct HingeBackbone {
  /// Moments at yielding of either sense, that at rest included [force·length] > 0, and what is borne at rest.
  double clockwise = 0, anticlockwise = 0, at_rest = 0;
  double plastic = std::numeric_limits<double>::infinity();    ///< θ_c [rad] > 0, from yielding to the cap
  double softening = std::numeric_limits<double>::infinity();  ///< θ_pc [rad] > 0, from the cap to no moment
  double residual = 0;                                         ///< of the moment at yielding [-], in [0, 1)
  double ultimate = std::numeric_limits<double>::infinity();  ///< θ_u [rad] > θ_c, at which nothing is borne any more
  /// What repetition wears out: γ of the energy γ M_y θ_c that can be lost [-] > 0, infinite: nothing; c [-], 1 … 2.
  /// (H-21)
  double wear = std::numeric_limits<double>::infinity(), wear_exponent = 1;
  [[nodiscard]] bool loses_strength() const { return std::isfinite(plastic); }
  [[nodiscard]] bool wears() const { return loses_strength() && std::isfinite(wear); }
  /// γ M_y θ_c with the lesser M_y [force·length].
  [[nodiscard]] double can_lose() const { return wear * plastic * std::min(clockwise, anticlockwise); }
  [[nodiscard]] bool operator==(const HingeBackbone&) const = default;
};

}  // namespace bentur
