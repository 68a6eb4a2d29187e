#pragma once

#include <cstddef>
#include <filesystem>

#include "bentur/pounding/plan/plan_problem.h"

namespace bentur::bench {

/// Houses in plan that twist, in rows of so many columns, `clear` [m] apart, under 10 s of the record in both
/// directions.
PlanProblem houses(int count, int columns, double clear, int storeys, const std::filesystem::path& record);

struct PlanTime {
  double minimum = 0;  ///< of one solution [s]
  std::size_t impacts = 0;
};
/// @throws std::runtime_error where a run fails.
PlanTime time_of_plan(const PlanProblem& problem);

}  // namespace bentur::bench
