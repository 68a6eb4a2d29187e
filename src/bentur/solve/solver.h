#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "bentur/solve/solution.h"
#include "bentur/solve/system.h"

namespace bentur {

/// Event-driven exact solution (docs/theory/exact-solver.md): no time step. Between events of laws with straight
/// branches the solution is known; a nonlinear contact is integrated by an embedded Runge-Kutta pair while it lasts.
struct ExactSolver {};

/// One embedded Runge-Kutta pair for everything, with event location (docs/theory/runge-kutta.md).
struct AdaptiveSolver {
  double tolerance = 1e-9;  ///< relative, of one step [-], in [1e-13, 1e-2]
};

/// The monograph's fourth-order scheme (3.4): `step` in free flight, a third of it in contact, contact instants by
/// bisection.
struct RungeKuttaSolver {
  double step = 0.006;  ///< [s] > 0
};

using Solver = std::variant<ExactSolver, AdaptiveSolver, RungeKuttaSolver>;

/// As a case names it: "exact", "adaptive", "runge-kutta".
[[nodiscard]] std::string_view name(const Solver& solver);
/// @throws InvalidParameter when its parameter is not valid.
void validate(const Solver& solver);

/// What one run along a motion may take; more is a failure that says so. 0: no limit. See effort.h.
struct RunLimits {
  long steps = 0;      ///< those taken again for samples and peaks included
  long events = 0;     ///< of contacts
  double seconds = 0;  ///< [s] of wall time
};

struct RunOptions {
  /// Histories are sampled every output_step [s]; 0: none are kept. Sampling never changes the solution.
  double output_step = 0;
  /// Keeps the exact course too (Solution::course); it never changes the solution.
  bool course = false;
  RunLimits limits = {};
  /// Accounts for all energy (Solution::energy); it never changes the solution.
  bool energy_audit = false;
  double energy_step = 0;  ///< [s] of the samples of energies, which are kept with histories; 0: as of those
  /// Keeps what elements did at each event (Solution::changes), for tangent/tangent.h.
  bool changes = false;
  /// Called now and then with the fraction done [0, 1]; returning false stops the run (Status::stopped).
  std::function<bool(double)> progress = {};
};

namespace engine {
struct FreeParts;
}

/// The response of a system without its contacts, and whatever else runs share that differ in widths and laws of
/// contacts alone. Immutable; may serve many threads.
class FreeSolution {
 public:
  /// Numerical trouble is a status with time and reason, never an exception.
  /// @throws InvalidParameter when the solver's parameter is not valid, when there are too many steps, when loads and
  ///   motions do not fit together, or where contacts rub that "runge-kutta" is to solve.
  FreeSolution(System system, const Solver& solver, const std::function<bool(double)>& progress = {},
               const RunLimits& limits = {});

  /// The free solution where the ground moves by these motions, which are all so many times (> 0) those of the system:
  /// nothing is solved anew. What it gives agrees to round-off with what is solved. Nothing where they are not, the
  /// solver is not exact, this one has not got to its end, or is_homogeneous() says no.
  [[nodiscard]] std::optional<FreeSolution> scaled(const std::vector<GroundMotion>& motions) const;

  [[nodiscard]] const System& system() const;
  /// The response without contact, whatever widths and laws the contacts have. It lives as long as this object and its
  /// copies.
  [[nodiscard]] const Solution& solution() const;
  /// The response with these contacts, which are at the places of the system's. Of a free response that did not get to
  /// its end it is that one. @throws InvalidParameter where it is scaled() and a law of a contact is not homogeneous
  [[nodiscard]] Solution solve(const std::vector<Contact>& contacts, const RunOptions& options = {}) const {
    return solve(contacts, system().rubbing, options);
  }
  [[nodiscard]] Solution solve(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing,
                               const RunOptions& options) const;

  /// Whether solve() takes the laws of these contacts: of a scaled() one homogeneous ones alone.
  [[nodiscard]] bool takes(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing) const;

 private:
  struct Scaled;
  std::shared_ptr<const engine::FreeParts> parts_;
  std::shared_ptr<const Scaled> scaled_;  // null: it is that of the parts
};

}  // namespace bentur
