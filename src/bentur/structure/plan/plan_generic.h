#pragma once

#include <optional>

#include "bentur/structure/known/generic.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {

/// A building in plan of which little is known: the cantilever of a row's along x, along y and against rotation.
struct GenericPlan {
  GenericBuilding along_x;                     ///< with its period along x; none that yields
  std::optional<double> period_y = {};         ///< [s] > 0; nothing: as along x
  double torsion_ratio = 1;                    ///< Ω_θ, uncoupled, over the lower lateral frequency [-] > 0
  PlanPoint eccentricity = PlanPoint::Zero();  ///< from the centre of all mass to the centre of rigidity [length]
};

/// Gives a plan, its footprint, centres of mass and inertias known, the storeys and floor masses of a generic building
/// and the cantilever that holds them (P-26).
/// @throws InvalidParameter as generic_model(), or when a number of the plan is out of its range.
void stand_generic(const GenericPlan& generic, Plan& plan);

}  // namespace bentur
