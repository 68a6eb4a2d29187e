#pragma once

#include <vector>

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"
#include "bentur/study/separation_rules.h"

namespace bentur {

/// The gap one contact point needs: simulated, and by the rules, from the peaks of the free response.
struct PointSeparation {
  int point = 0;                      ///< index into Problem::points
  double simulated = 0;               ///< [length], PointSummary::minimum_gap_no_contact
  double abs = 0, srss = 0, ddc = 0;  ///< [length]
};

/// One entry per contact point of the problem.
[[nodiscard]] std::vector<PointSeparation> separations(const Problem& problem, const Response& response);

}  // namespace bentur
