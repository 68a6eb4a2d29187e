#pragma once

#include "bentur/structure/plan/plan.h"

// What plan_model() and rigid_plan_building() refuse.
namespace bentur {

/// @throws InvalidParameter where its corner, its size or its rings are wrong
void check_footprint(const Footprint& footprint);

/// @throws InvalidParameter as plan_model()
void check_plan(const Plan& plan);

}  // namespace bentur
