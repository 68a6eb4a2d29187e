#pragma once

#include <functional>
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
  RunLimits limits = {};  ///< of each response: without contact, with it, and the other way round
  /// Looks at both faces of each level in the free response as well (PointSummary::peak_left and the like): what rules
  /// for gaps combine.
  bool levels = false;
  /// And at what the ground motion times −1 needs (PointSummary::gap_needed_reversed).
  bool both_ways = false;
  /// Accounts for all energy (Response::energy); it never changes the solution.
  bool energy_audit = false;
  double energy_step = 0;  ///< [s] of the samples of energies, which are kept with histories; 0: as of those
  /// Called now and then with the fraction done [0, 1]; returning false stops the run (Status::stopped).
  std::function<bool(double)> progress = {};
};

/// Whether the free response to the ground motion times −1 is the free response times −1: the buildings start from rest
/// and every law of a storey, bearing or link is odd. What acts in one direction alone, as cables do, makes another
/// one.
[[nodiscard]] bool is_mirrored(const Problem& problem);

/// Whether `factor` times the ground motion and all gap widths give `factor` times the response, whatever widths and
/// laws the contact points have: the buildings are elastic, start from rest and bear no gravity loads, and links have
/// no length or force of their own.
[[nodiscard]] bool is_homogeneous(const Problem& problem);

/// Runs the free response (contact off) first, then the response with contact.
/// Numerical trouble is a status with time and reason, never an exception.
/// @throws InvalidParameter when the problem or the solver's parameter is not valid.
[[nodiscard]] Response solve(const Problem& problem, const Solver& solver = ExactSolver{},
                             const SolveOptions& options = {});

/// What a run takes (effort.h). @throws InvalidParameter as solve().
[[nodiscard]] Effort effort(const Problem& problem, const Solver& solver, const SolveOptions& options);

/// The response without contact and whatever else problems share that differ in gap widths and contact laws alone.
/// Immutable; may serve many threads.
class FreeResponse {
 public:
  /// @throws InvalidParameter as solve().
  /// @param levels as SolveOptions::levels; what the reversed motion needs comes with it where it follows from this
  /// response, as is_mirrored() says.
  explicit FreeResponse(Problem problem, const Solver& solver = ExactSolver{},
                        const std::function<bool(double)>& progress = {}, const RunLimits& limits = {},
                        bool levels = false);

  /// The response of the same buildings, motion, delays, initial state and duration with the gap widths and laws of
  /// `problem`, whose points must be at the same places. The same as solve() gives, to the bit.
  /// @throws InvalidParameter when anything else differs, or of a scaled() one a law is not homogeneous.
  [[nodiscard]] Response solve(const Problem& problem, const SolveOptions& options = {}) const;

  /// The free response of `problem`, whose ground motion is a number of times (> 0) this one's, and that differs in
  /// nothing else but widths and laws of contact: nothing is solved anew. What it gives agrees to round-off with what
  /// is solved. Nothing where the motions are not such, the solver is not exact, or is_homogeneous() says no.
  /// @throws InvalidParameter as the constructor, and when anything else differs.
  [[nodiscard]] std::optional<FreeResponse> scaled(Problem problem) const;

  /// The response without contact, whatever widths and laws the problem gave: status and message, the peaks of the
  /// buildings, and of points and watched floors what they need (`gap_needed` and, where asked for, what belongs to
  /// it); all else of them is zero. It lives as long as this object and its copies.
  [[nodiscard]] const Response& response() const;

 private:
  struct Parts;
  FreeResponse() = default;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace bentur
