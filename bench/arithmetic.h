#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bentur/pounding/pounding.h"

namespace bentur::bench {

/// Floating-point operations that the solution of a problem takes by docs/theory/exact-solver.md, one for each addition
/// and each multiplication, without the search for events, cut steps and everything that is no arithmetic: a floor, not
/// a forecast. With M steps of the record in the run, N of the records of all buildings together (more than M where
/// delays are no multiples of its step), n modes in all, n_b modes and f_b floors of building b, n_p modes of the two
/// buildings at point p, S steps of the power series, K = 26 terms:
///
///   free response      M (24 n + Σ_b 16 f_b n_b),                                                           (1)
///   with contact       N (24 n + Σ_b 16 f_b n_b + Σ_p 4 n_p) + S (K (8 n + 4 n̄) + Σ_p 2 (K + 1) n_p).      (2)
///
/// 24: a mode's step, two rows of four (14), and the energy that bounds it (10). 16: displacement, drift, acceleration
/// and shear of each floor, value and bound. 4: an opening, value and bound. 8: (T-2) without forces, and 4 n̄ for one
/// closed point, opening and push, with n̄ the mean of n_p. S is the number of steps of the response less N.
struct Arithmetic {
  long free_steps = 0, contact_steps = 0;    ///< M and S
  double free_flops = 0, contact_flops = 0;  ///< (1) and (2)
};

[[nodiscard]] Arithmetic arithmetic_of(const Problem& problem, const Response& response);

/// Additions and multiplications that one core does in a second on numbers in registers, by instruction set: the
/// baseline of x86-64 (SSE2: two numbers, product and sum apart) and, where the processor has them, AVX2 with FMA.
[[nodiscard]] std::vector<std::pair<std::string, double>> arithmetic_rates();

}  // namespace bentur::bench
