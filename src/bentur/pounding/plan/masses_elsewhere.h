#pragma once

#include <cstddef>
#include <vector>

#include "bentur/pounding/plan/plan_pounding.h"
#include "bentur/pounding/plan/plan_problem.h"

// Masses that may stand elsewhere than expected (docs/theory/plan.md, Accidental eccentricity): what free_response_of.h
// asks of it.
namespace bentur {

/// Per building the place of its masses: of PlanProblem::elsewhere, −1 where they are expected.
using MassPlaces = std::vector<int>;

/// Choices of places, all but those where they are expected, so that every two buildings with a gap or a link between
/// them go through every choice of both: 24 of a pair, and of as many buildings as neighbours have no more than six
/// columns of an orthogonal array. Empty: no masses are elsewhere.
[[nodiscard]] std::vector<MassPlaces> mass_choices(const PlanProblem& problem);

/// The problem with its masses there, and nowhere else.
[[nodiscard]] PlanProblem with_masses_at(const PlanProblem& problem, const MassPlaces& places);

/// Raises what the response needs without contact to what it needs with masses elsewhere, given as `other`: of points
/// and watched floors, each way of the motion that both know; largest drifts, and the first collapse.
/// @param choice of mass_choices(), counted from 1
void raise_needs(const PlanResponse& other, int choice, PlanResponse& response);

}  // namespace bentur
