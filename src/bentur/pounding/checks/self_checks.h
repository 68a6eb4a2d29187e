#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

namespace bentur {

struct PlanProblem;
struct PlanResponse;

/// A list of peaks of a building, every entry of which is a number but where `is_null` says that there is none.
struct CheckedPeaks {
  const char* what;
  const std::string& building;
  const Eigen::VectorXd& values;
  std::function<bool(Eigen::Index)> is_null = {};  ///< empty: nowhere
};

/// Peaks of displacements of a building with contact and without it [length].
struct ComparedPeaks {
  const std::string& building;
  const Eigen::VectorXd &with, &without;
};

/// What is checked of a response beside its outcome, of a row and of buildings in plan alike.
struct CheckedRun {
  std::function<std::string(std::size_t)> place;  ///< where a point is
  std::vector<double> widths = {};                ///< w, per point [length]
  std::vector<double> moves = {};  ///< per point, how far its two buildings move at most without contact [length]
  /// Whether a point is touched as soon as it closes; of outlines that turn inwards others have to be closed as well.
  bool touches_where_closed = true;
  std::vector<CheckedPeaks> peaks = {};
  std::vector<ComparedPeaks> compared = {};
  std::string fault = {};      ///< what has been found wrong with it already; empty: nothing
  bool is_integrated = false;  ///< whether some contact's force is, by steps of a tolerance of their own
};

/// Compares numbers of a response that were reached by different ways, and those that every solution has twice. A run
/// that has failed is not looked at.
void check_run(const CheckedRun& run, const SelfMeasures& measures, const Solver& solver, RunOutcome& outcome);

/// How far a hinge was from its place at rest, at the end or in any sample, beyond its peak rotation: as a part of the
/// largest peak rotation [-]. @param rotation samples of θ, a row per hinge [rad]; empty: none
[[nodiscard]] double beyond_peak_rotations(const std::vector<BuildingPeaks::Hinge>& hinges,
                                           const Eigen::Ref<const Eigen::MatrixXd>& rotation);

/// Whether the force of a law is integrated while it is in contact.
[[nodiscard]] bool is_integrated(const Law& law);

/// check_run() of a row, and its histories (docs/verification.md, What every run checks).
/// One that contradicts itself has failed: status and message say so. What is further apart than round-off, but no
/// further than the solver explains, is noted in its discrepancies.
void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response);
/// The same of buildings in plan, but for their histories. plan/plan_self_checks.cpp
void check_itself(const PlanProblem& problem, const Solver& solver, const SelfMeasures& measures,
                  PlanResponse& response);

}  // namespace bentur
