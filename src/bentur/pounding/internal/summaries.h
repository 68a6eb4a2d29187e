#pragma once

#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// What the response without contact says of buildings, points and watched floors.
[[nodiscard]] Response free_response(const Problem& problem, const Solution& free);

/// Puts what storey `storey` of so many has lost of its strength among what yielding did.
void take_loss(const StrengthLoss& loss, Eigen::Index storeys, Eigen::Index storey, BuildingPeaks::Yielding& yielding);

/// What links did, the joints of a system.
[[nodiscard]] std::vector<LinkSummary> links_of(const Solution& solution);

/// Adds impacts to the totals of their points.
void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points);

/// How near watched floors came. @param widths what they are apart at rest [length], one each
void summarise(const Solution& solution, const std::vector<double>& widths, std::vector<WatchedSummary>& watched);

/// Puts a solution with contact into the response that free_response() made.
void take_solution(const Problem& problem, Solution&& solution, Response& response);

}  // namespace bentur
