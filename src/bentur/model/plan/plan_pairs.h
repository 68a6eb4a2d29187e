#pragma once

#include <vector>

#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// Not less than any edge of a building moves along a direction [length]; along x or y the most it does.
[[nodiscard]] double reach_of(const PlanPeaks& peaks, const PlanPoint& direction);

/// Two buildings that no gap has, and that could meet by how far both move: along every direction in which they are
/// apart.
struct PairWithoutContact {
  Eigen::Index first = 0, second = 0;
  double width = 0, reach = 0;  ///< of what is between them, and how far both move along it [length]
};
[[nodiscard]] std::vector<PairWithoutContact> pairs_without_contact(const PlanRun& run);

}  // namespace bentur
