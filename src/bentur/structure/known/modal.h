#pragma once

#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// A building known by its modes: from another program, or from a vibration test.
struct ModalBuilding {
  std::vector<double> elevations;           ///< of the floors above the base [length], ascending, > 0
  std::vector<double> masses;               ///< of the floors [mass] > 0
  std::vector<double> periods;              ///< T of the modes that are known, ≤ floors [s] > 0, descending or not
  std::vector<std::vector<double>> shapes;  ///< one list a mode, floors bottom to top, any scale
};

/// Shapes made M-orthonormal in the symmetric way, Φ ← Φ (ΦᵀMΦ)^−½ after scaling each to unit modal mass; K = M Φ Ω² Φᵀ
/// M. With fewer modes than floors the building moves in these alone.                                            (L-4)
struct ModalModel {
  StructuralModel model;
  Modes modes;
  double largest_product = 0;       ///< the largest |φ_iᵀ M φ_j| of the shapes as given, scaled [-]
  std::vector<double> mass_shares;  ///< m_i Σ_j φ_ij² of each floor [-]: 1 where all modes are there
};
/// @throws InvalidParameter when sizes disagree, a value is outside its range, or two shapes are further from
/// orthogonal than 0.02: it names them.
[[nodiscard]] ModalModel modal_model(const ModalBuilding& building, double base_elevation = 0.0);

}  // namespace bentur
