#pragma once

#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/story.h"

// What small displacements leave out of a run of buildings in plan.
namespace bentur::story {

/// ½θ² times the arm, which is left out of every opening (docs/theory/plan.md), where it counts.
void tell_rotations(const PlanRun& run, std::vector<Statement>& statements);

/// A struck corner that may have come to the end of the edge it stands before, beyond which another one lies: of edges
/// that are not parallel.
void tell_ends_of_edges(const PlanRun& run, std::vector<Statement>& statements);

}  // namespace bentur::story
