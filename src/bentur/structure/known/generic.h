#pragma once

#include <optional>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// A building of which little is known: a cantilever of flexural and shear stiffness [MirandaTaghavi2005], lumped at
/// its floors.
struct GenericBuilding {
  std::vector<double> storey_heights;  ///< [length] > 0, bottom to top
  std::vector<double> floor_masses;    ///< [mass] > 0
  double period = 0;                   ///< T₁ [s] > 0; 0: as period_formula says
  /// T₁ = coefficient · H^exponent of the height H in metres, and what a metre is in the unit of lengths.
  struct PeriodFormula {
    double coefficient = 0, exponent = 0;
    double metre = 1;  ///< [length]
  };
  std::optional<PeriodFormula> period_formula = {};
  double stiffness_ratio = 0;  ///< α = H √(GA/EI) [-] ≥ 0: 0 pure bending, 30 and more pure shear
  /// Share of the weight that yields the base; its shear springs yield in proportion to their shear in the first mode.
  std::optional<double> yield_base_shear = {};
  double hardening = 0;  ///< r of the shear springs [-]
};

/// K of a prismatic cantilever beam (rotations condensed) of bending stiffness EI, and of a chain of shear springs
/// GA/h_j with α² = GA H²/EI, scaled so that the first period is T₁.
/// @throws InvalidParameter when sizes disagree or a value is outside its range.
[[nodiscard]] StructuralModel generic_model(const GenericBuilding& building, double base_elevation = 0.0);

/// Of its storeys; empty unless it yields. @param gravity [length/s²]
/// @throws InvalidParameter when α < 30, where shear springs alone do not hold the building.
[[nodiscard]] std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const GenericBuilding& building,
                                                                            const StructuralModel& model,
                                                                            double gravity);

}  // namespace bentur
