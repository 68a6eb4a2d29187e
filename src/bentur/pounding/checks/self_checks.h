#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

namespace bentur {

/// What is said of a run that has looked at itself.
struct Verdict {
  Status& status;
  std::string& message;
  std::vector<Discrepancy>& discrepancies;
};

/// Compares numbers that every solution has twice, whatever it is of. @param integrated whether some contact's force is
/// integrated, by steps of a tolerance of their own
void check_measures(const SelfMeasures& measures, const std::optional<EnergyAudit>& energy, const Solver& solver,
                    bool integrated, const Verdict& verdict);

/// How far a hinge was from its place at rest, at the end or in any sample, beyond its peak rotation: as a part of the
/// largest peak rotation [-]. @param rotation samples of θ, a row per hinge [rad]; empty: none
[[nodiscard]] double beyond_peak_rotations(const std::vector<BuildingPeaks::Hinge>& hinges,
                                           const Eigen::Ref<const Eigen::MatrixXd>& rotation);

/// Whether the force of a law is integrated while it is in contact.
[[nodiscard]] bool is_integrated(const Law& law);

/// Compares numbers of a response that were reached by different ways (docs/verification.md, What every run checks).
/// One that contradicts itself has failed: status and message say so. What is further apart than round-off, but no
/// further than the solver explains, is noted in its discrepancies.
void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response);

}  // namespace bentur
