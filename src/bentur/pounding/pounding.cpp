#include "bentur/pounding/pounding.h"

#include "bentur/pounding/assemble.h"
#include "bentur/pounding/checks/self_checks.h"
#include "bentur/pounding/internal/free_response_of.h"
#include "bentur/pounding/internal/summaries.h"

namespace bentur {

template class FreeResponseOf<Problem, Response>;

Response solve(const Problem& problem, const Solver& solver, const SolveOptions& options) {
  return any_problem::solution_of<Response>(problem, solver, options);
}

Effort effort(const Problem& problem, const Solver& solver, const SolveOptions& options) {
  validate(problem);
  return effort(system_of(problem), solver, run_options(options));
}

}  // namespace bentur
