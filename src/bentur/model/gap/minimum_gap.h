#pragma once

#include <vector>

#include "bentur/core/units.h"
#include "bentur/model/gap/code_rules.h"
#include "bentur/model/gap/separation_rules.h"
#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"

namespace bentur {

/// The gap one contact point needs: simulated, and by the rules, from the peaks of the free response.
struct PointSeparation {
  int point = 0;                           ///< index into Problem::points
  double simulated = 0;                    ///< [length], PointSummary::minimum_gap_no_contact
  double abs = 0, srss = 0, ddc = 0;       ///< [length]
  std::vector<CodeSeparation> codes = {};  ///< one per rule of the case's [code], in its order
};

/// What the rules combine, wherever it comes from.
struct PeaksForRules {
  std::vector<Eigen::VectorXd> peaks;     ///< per building, of its floors [length]
  std::vector<Eigen::VectorXd> of_codes;  ///< those that rules of codes amplify, likewise
  std::vector<double> needed;             ///< per contact point [length], PointSeparation::simulated
};
/// One entry per contact point of the problem. `units` are those of the problem.
/// @throws InvalidParameter when sizes disagree, or a code rule lacks something.
[[nodiscard]] std::vector<PointSeparation> separations(const Problem& problem, const PeaksForRules& peaks,
                                                       const CodeSpec& code, const Units& units);

/// The same from the free response.
/// @throws InvalidParameter when the response is not that of the problem, or a code rule lacks something.
[[nodiscard]] std::vector<PointSeparation> separations(const Problem& problem, const Response& response,
                                                       const CodeSpec& code = {}, const Units& units = {});

/// Each number the largest of some points', 0 where there are none; `points`: indices into `separations`, one entry per
/// contact point of the problem. @throws std::out_of_range when there is no such entry.
[[nodiscard]] PointSeparation largest_of(const std::vector<PointSeparation>& separations,
                                         const std::vector<Eigen::Index>& points);

/// Whether each floor of the lower of two neighbours has a floor of the other at its elevation, within a millionth of
/// the taller one's height.
[[nodiscard]] bool floors_aligned(const Building& left, const Building& right);

}  // namespace bentur
