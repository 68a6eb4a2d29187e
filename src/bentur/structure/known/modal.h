#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// Modes as another program or a vibration test has them.
struct GivenModes {
  std::vector<double> periods;              ///< T, as many as are known [s] > 0, descending or not
  std::vector<std::vector<double>> shapes;  ///< one list a mode, degree of freedom after degree of freedom, any scale
};

/// Shapes made M-orthonormal in the symmetric way, Φ ← Φ (ΦᵀMΦ)^−½ after scaling each to unit modal mass; K = M Φ Ω² Φᵀ
/// M. With fewer modes than degrees of freedom the building moves in these alone.                               (L-4)
struct KnownModes {
  Modes modes;
  Eigen::MatrixXd stiffness;
  double largest_product = 0;       ///< the largest |φ_iᵀ M φ_j| of the shapes as given, scaled [-]
  std::vector<double> mass_shares;  ///< m_i Σ_j φ_ij² of each degree of freedom [-]: 1 where all modes are there
};
/// @param mass of each degree of freedom > 0 @throws InvalidParameter when sizes disagree, a value is outside its
/// range, or two shapes are further from orthogonal than 0.02: it names them.
[[nodiscard]] KnownModes known_modes(const GivenModes& given, const Eigen::VectorXd& mass);

/// A building in a row that is known by its modes, from another program or from a vibration test: at most one a floor,
/// shapes from the lowest floor up.
struct ModalBuilding {
  std::vector<double> elevations;  ///< of the floors above the base [length], ascending, > 0
  std::vector<double> masses;      ///< of the floors [mass] > 0
  GivenModes modes;
};

struct ModalModel {
  StructuralModel model;
  KnownModes known;
};
/// @throws InvalidParameter as known_modes(), and when elevations or masses are outside their range.
[[nodiscard]] ModalModel modal_model(const ModalBuilding& building, double base_elevation = 0.0);

}  // namespace bentur
