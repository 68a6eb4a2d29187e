#pragma once

#include <string>

#include "session.h"

namespace bentur::cli {

/// A line for each building and each gap of a case in plan.
[[nodiscard]] std::string plan_lines(const Loaded& loaded, const Words& say);

void print_plan_modes(PlanProblem problem, bool by_jacobi, bool json, const Words& say);

}  // namespace bentur::cli
