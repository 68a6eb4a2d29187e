#pragma once

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"
#include "bentur/solve/solver.h"

namespace bentur {

/// How far numbers of a run are apart that are one, each as a part of the largest of them [-]; 0 where there was
/// nothing to compare.
struct SelfMeasures {
  double momentum = 0;  ///< over contacts: of the states before and after, and the impulses that are reported
  double opening = 0;   ///< of the bodies at instants at which they begin or cease to touch: from zero
  double forces = 0;    ///< at the end: inertia, damping, stiffness and contacts by the buildings' own matrices
};

/// Compares numbers of a response that were reached by different ways (docs/verification.md, What every run checks).
/// One that contradicts itself has failed: status and message say so. What is further apart than round-off, but no
/// further than the solver explains, is noted in its discrepancies.
void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response);

}  // namespace bentur
