#pragma once

#include <vector>

#include "bentur/structure/plan/plan.h"

// Where the masses of a plan stand.
namespace bentur {

/// Of a plan whose lists have the right lengths, of one floor: its centre of mass, from the footprint's corner
/// [length], and its inertia about that [mass·length²].
[[nodiscard]] PlanPoint centre_of_mass(const Plan& plan, Eigen::Index floor);
[[nodiscard]] double inertia_of(const Plan& plan, Eigen::Index floor);

/// The same with all centres of mass moved by parts of the size along x and y; what holds the floors stays.
[[nodiscard]] Plan with_masses_moved(Plan plan, const PlanPoint& parts);
/// The four that plan.eccentricity_both_ways asks for: to the right and to the left along x, up and down along y.
[[nodiscard]] std::vector<Plan> with_masses_elsewhere(const Plan& plan);

}  // namespace bentur
