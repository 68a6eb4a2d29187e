#pragma once

#include "bentur/model/internal/quantity_sources.h"

// Those that runs of buildings in plan alone have.
namespace bentur::sources {

/// A free peak below this is round-off, and has no amplification.
struct RoundOff {
  double displacement = 0;  ///< of the largest free peak of the case, rotations times half the longest side [length]
  double rotation = 0;      ///< that over this half [rad]
};

using PlanBuildings = std::vector<PlanPeaks> PlanResponse::*;
using PlanList = Eigen::VectorXd PlanPeaks::*;

/// Over the floors of a building.
[[nodiscard]] QuantitySource plan_floors(PlanList list, PlanBuildings of = &PlanResponse::buildings);
[[nodiscard]] QuantitySource plan_amplification(PlanList list, double RoundOff::*least);
/// Over that without contact; none where contact makes something of nothing, round-off included, also that of what
/// moves along the other axis. @param across the same peaks along that axis
[[nodiscard]] QuantitySource plan_ratio(PlanList list, PlanList across);
/// The largest shear of the lowest storey over the weight of the building.
[[nodiscard]] QuantitySource plan_base_shear(PlanList list);
[[nodiscard]] QuantitySource edge_drift(PlanBuildings of = &PlanResponse::buildings);
/// Over the storeys of a plane.
[[nodiscard]] QuantitySource of_plane(Eigen::VectorXd PlanPeaks::Plane::*list,
                                      PlanBuildings of = &PlanResponse::buildings);
/// Of the infill of a frame.
[[nodiscard]] QuantitySource plan_infill(Eigen::VectorXd BuildingPeaks::Infill::*list);
[[nodiscard]] QuantitySource plan_yielding(Eigen::VectorXd BuildingPeaks::Yielding::*list,
                                           PlanBuildings of = &PlanResponse::buildings);
/// Of the foundation of a building, in the order of PlanPeaks::foundation.
[[nodiscard]] QuantitySource plan_foundation(Eigen::Index entry);
/// @param yields of those that can yield alone
[[nodiscard]] QuantitySource of_bearings(Eigen::VectorXd PlanPeaks::Bearings::*list, bool yields = false);
/// Of the ground along x, 0, or y.
[[nodiscard]] QuantitySource of_ground(Eigen::Index axis);
/// Of points, and of impacts, that rub.
[[nodiscard]] QuantitySource of_friction(double PlanFriction::*member);
[[nodiscard]] QuantitySource impact_friction();

}  // namespace bentur::sources
