#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/effort.h"
#include "bentur/solve/solver.h"

namespace bentur {

struct SolveOptions {
  /// Histories are sampled every output_step [s]; 0: none are kept. Sampling never changes the solution.
  double output_step = 0;
  /// Keeps the exact course too (Response::course); it never changes the solution.
  bool course = false;
  RunLimits limits = {};  ///< of each response: without contact, with it, and reversed
  /// Looks at both faces of each level in the free response as well (PointSummary::peak_left and the like): what rules
  /// for gaps combine.
  bool levels = false;
  /// And at what the ground motion times −1 needs (PointSummary::gap_needed_reversed).
  bool both_ways = false;
  /// Accounts for all energy (Response::energy); it never changes the solution.
  bool energy_audit = false;
  double energy_step = 0;  ///< [s] of the samples of energies, which are kept with histories; 0: as of those
  /// Starts work in a thread of its own, as in_a_thread() of core/in_a_thread.h does: with it the reversed motion is
  /// solved beside the run with contact, where both are asked for. Every number is the same.
  std::function<std::future<void>(std::function<void()>)> beside = {};
  /// Called now and then with the fraction done [0, 1], by the thread that calls; returning false stops the run
  /// (Status::stopped).
  std::function<bool(double)> progress = {};
};

/// Runs the free response (contact off) first, then the response with contact.
/// Numerical trouble is a status with time and reason, never an exception.
/// @throws InvalidParameter when the problem or the solver's parameter is not valid.
[[nodiscard]] Response solve(const Problem& problem, const Solver& solver = ExactSolver{},
                             const SolveOptions& options = {});

/// What a run takes (effort.h). @throws InvalidParameter as solve().
[[nodiscard]] Effort effort(const Problem& problem, const Solver& solver, const SolveOptions& options);

/// The response without contact and whatever else problems share that differ in gap widths and contact laws alone: of
/// buildings in a row, or in plan (plan/plan_pounding.h). Immutable; may serve many threads.
template <class AnyProblem, class AnyResponse>
class FreeResponseOf {
 public:
  struct Parts;

  /// @throws InvalidParameter as solve().
  /// @param levels as SolveOptions::levels; what the reversed motion needs comes with it where it follows from this
  /// response, as is_mirrored() of its system says.
  explicit FreeResponseOf(AnyProblem problem, const Solver& solver = ExactSolver{},
                          const std::function<bool(double)>& progress = {}, const RunLimits& limits = {},
                          bool levels = false);

  /// The response of the same buildings, motion, delays, initial state and duration with the gap widths and laws of
  /// `problem`, whose points must be at the same places. The same as solve() gives, to the bit.
  /// @throws InvalidParameter when anything else differs, or of a scaled() one a law is not homogeneous.
  [[nodiscard]] AnyResponse solve(const AnyProblem& problem, const SolveOptions& options = {}) const;

  /// Whether solve() takes `problem`. @throws InvalidParameter where it is not valid
  [[nodiscard]] bool serves(const AnyProblem& problem) const;

  /// The free response of `problem`, whose ground motion is a number of times (> 0) this one's, and that differs in
  /// nothing else but widths and laws of contact: nothing is solved anew. What it gives agrees to round-off with what
  /// is solved. Nothing where that is not so, the solver is not exact, or is_homogeneous() of the system says no.
  /// @throws InvalidParameter as the constructor.
  [[nodiscard]] std::optional<FreeResponseOf> scaled(AnyProblem problem) const;

  /// The response without contact, whatever widths and laws the problem gave, but for what is needed where buildings
  /// touch only while several places are closed (PlanContact::family), which hangs on the widths: status and message,
  /// the peaks of the buildings, and of points and watched floors what they need (`gap_needed` and, where asked for,
  /// what belongs to it); all else of them is zero. It lives as long as this object and its copies.
  [[nodiscard]] const AnyResponse& response() const;

 private:
  FreeResponseOf() = default;
  std::shared_ptr<const Parts> parts_;
};

using FreeResponse = FreeResponseOf<Problem, Response>;
extern template class FreeResponseOf<Problem, Response>;

}  // namespace bentur
