#pragma once

#include "bentur/structure/plan/plan.h"
#include "bentur/structure/support.h"

namespace bentur {

/// Of storeys what acts on the floors and nodes above them. @param rows of floors from the lowest up, then of nodes
/// @param node_storeys in which these are
[[nodiscard]] Eigen::MatrixXd sums_above(Eigen::MatrixXd rows, const std::vector<Eigen::Index>& node_storeys);

/// P-Δ (P-22): loads of the floors, from the lowest up, take from the stiffness of all storeys below them.
/// @throws InvalidParameter when loads are too few or many, below zero, or more than the building carries.
void soften(const std::vector<double>& loads, PlanModel& model);

/// Puts a building whose base does not move on soil (P-27), its modes and damping too.
/// @throws InvalidParameter when a value of the soil is out of its range or the building does not stand on it under its
/// gravity loads.
void put_on_soil(const PlanSoil& soil, PlanBuilding& building);

/// Puts it on bearings below a slab (P-29), which becomes its first floor.
/// @throws InvalidParameter when a value is out of its range, bearings do not hold the slab or the building does not
/// stand on them under its gravity loads.
void put_on_bearings(const PlanIsolation& isolation, PlanBuilding& building);

/// Springs and dashpots of a round footing, soil_of() and about the vertical k_t = 16 G r³/3, c_t = √(k_t J)/(1 + 2
/// B_t), B_t = J/(ρ r⁵), of the twist inertia J [RichartHallWoods1970]. Masses and inertias are those of `foundation`,
/// whose springs are not looked at. @throws InvalidParameter as soil_of().
[[nodiscard]] PlanSoil soil_in_plan(const HalfSpace& half_space, PlanSoil foundation);

}  // namespace bentur
