#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur::story {

/// What the storeys of a building did, of a row all of them; in plan those of each plane, and of a building without
/// planes its edges. Lists may be empty. The response must outlive it.
struct Storeys {
  std::string name;  ///< of the building, or of the plane of it
  Eigen::VectorXd drift, drift_alone;
  const BuildingPeaks::Yielding *yielding, *yielding_alone;
  const BuildingPeaks* frame;                   ///< whose hinges and columns they have
  double base_shear = 0, base_shear_alone = 0;  ///< of the whole building; 0 of a plane [force]
};
[[nodiscard]] std::vector<Storeys> storeys_of(const Problem& problem, const Response& response, Eigen::Index building);
[[nodiscard]] std::vector<Storeys> storeys_of(const PlanProblem& problem, const PlanResponse& response,
                                              Eigen::Index building);

/// The contact points of a gap, among those of all gaps.
[[nodiscard]] std::vector<Eigen::Index> points_from_top(const Problem& problem, std::size_t gap);
[[nodiscard]] std::vector<Eigen::Index> points_from_top(const PlanProblem& problem, std::size_t gap);

}  // namespace bentur::story
