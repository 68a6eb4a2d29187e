#pragma once

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

namespace bentur {

/// Compares numbers of a response that were reached by different ways (docs/verification.md, What every run checks).
/// One that contradicts itself has failed: status and message say so. What is further apart than round-off, but no
/// further than the solver explains, is noted in its discrepancies.
void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response);

}  // namespace bentur
