#pragma once

#include <string>
#include <vector>

#include "bentur/pounding/plan/plan_problem.h"

namespace bentur {

/// Of all buildings, in their order.
[[nodiscard]] std::vector<std::string> building_names(const PlanProblem& problem);

/// What buildings are called where there is little room: their names without the words with which all of them begin,
/// "5.5" of House 5.5; where even these are long, or two are alike, their numbers from 1.
[[nodiscard]] std::vector<std::string> short_names(const std::vector<std::string>& names);

/// Whether short names are such parts of names, and no numbers in their place, which would have to be explained.
[[nodiscard]] bool are_parts_of(const std::vector<std::string>& in_short, const std::vector<std::string>& names);

}  // namespace bentur
