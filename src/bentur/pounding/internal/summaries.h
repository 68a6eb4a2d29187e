#pragma once

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// What the response without contact says of buildings, points and watched floors.
[[nodiscard]] Response free_response(const Problem& problem, const Solution& free);

/// Puts a solution with contact into the response that free_response() made.
void take_solution(const Problem& problem, Solution&& solution, Response& response);

}  // namespace bentur
