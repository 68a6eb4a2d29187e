#pragma once

#include "bentur/excitation/ground_motion.h"

namespace bentur {

/// What engineers ask of a ground motion a(t) [length/s²]:
///
///   PGA = max |a|,   PGV = max |v|, v(t) = ∫₀ᵗ a dt,                                                        (1)
///   D₅₋₉₅ = t₉₅ − t₅, where ∫₀ᵗ a² dt reaches 5 % and 95 % of its end value [TrifunacBrady1975].        (2)
///
/// A sampled motion is linear between its samples, so (1) and (2) are exact for it; no baseline is corrected.
/// A harmonic motion of amplitude A and angular frequency ω has PGV = A ω and no D₅₋₉₅; no motion has zeros.
struct MotionMeasures {
  double pga = 0;                   ///< [length/s²]
  double pgv = 0;                   ///< [length/s]
  double significant_duration = 0;  ///< D₅₋₉₅ [s]; 0 where there is none
};

[[nodiscard]] MotionMeasures motion_measures(const GroundMotion& motion);

}  // namespace bentur
