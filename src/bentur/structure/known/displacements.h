#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// A building of which peak displacements are known, as another program has found them: for gaps alone, nothing is
/// solved of it.
struct DisplacementsSpec {
  std::vector<double> elevations;     ///< of the floors above the base [length], ascending, > 0
  std::vector<double> displacements;  ///< u, one per floor [length] ≥ 0
  double amplification = 1;           ///< what makes them those expected [-] > 0
  std::optional<double> period = {};  ///< T₁ [s] > 0, for DDC
  double damping_ratio = 0;           ///< ζ₁ [-] ≥ 0, of a period that is given
};

/// Floors at these elevations, which do not move by themselves, with their peaks. Between floors peaks are taken in
/// proportion, and below the lowest from none at the base.
/// @throws InvalidParameter when sizes disagree or a value is outside its range.
[[nodiscard]] Building known_by_displacements(std::string name, const DisplacementsSpec& given,
                                              double base_elevation = 0);

}  // namespace bentur
