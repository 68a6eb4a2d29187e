#pragma once

#include <functional>

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"

namespace bentur {

struct ExactOptions {
  /// Histories are sampled every output_step [s]; 0: none are kept. Sampling never changes the solution.
  double output_step = 0;
  /// Called now and then with the fraction done [0, 1]; returning false stops the run (Status::stopped).
  std::function<bool(double)> progress;
};

/// Event-driven exact solution of piecewise-linear pounding (docs/theory/exact-solver.md): no time step, every contact
/// deeper than 2⁻⁴⁶ of the displacements at its point is found, and peaks are extrema of the continuous response.
/// Runs the free response (contact off) first, then the response with contact.
/// Numerical trouble is a status with time and reason, never an exception.
/// @throws InvalidParameter when the problem is not valid.
[[nodiscard]] Response solve_exact(const Problem& problem, const ExactOptions& options = {});

}  // namespace bentur
