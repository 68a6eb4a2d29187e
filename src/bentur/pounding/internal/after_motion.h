#pragma once

#include <functional>
#include <vector>

#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

// What buildings do once their ground rests, of rows and plans alike (docs/theory/exact-solver.md, After the motion).
namespace bentur {

/// The free response; where it `goes_on`, past the duration of its system to the end of its records at the body that
/// they reach last, and until no gap can need more than it has needed so far, at most most_periods_after first periods
/// of the slowest body. FreeSolution::system() has the duration that it comes to. Where is_mirrored() says so −δ, the
/// first ones of System::watched_free, is what the reversed motion needs.
[[nodiscard]] FreeSolution free_solution(System system, const Solver& solver,
                                         const std::function<bool(double)>& progress, const RunLimits& limits,
                                         bool goes_on);

/// Whether all motions of a system end before it does, or with it.
[[nodiscard]] bool motion_ends(const System& system);

/// Puts into summaries what the vibration after a free response can still need, or what harmonic motion that goes on
/// can; infinite where the records of its system go on after it has ended, or nothing bounds the response to such
/// motion.
/// @param places of the system's contacts, those that rub last, among the points, −1: none of them; empty: they are
/// the points
void take_to_come(const FreeSolution& free, const std::vector<Eigen::Index>& places, std::vector<PointSummary>& points,
                  std::vector<WatchedSummary>& watched);

/// The same of the run with contact, in which others are struck. @param places likewise
void take_to_come_struck(const Solution& with, const std::vector<Eigen::Index>& places,
                         std::vector<PointSummary>& points, std::vector<WatchedSummary>& watched);

}  // namespace bentur
