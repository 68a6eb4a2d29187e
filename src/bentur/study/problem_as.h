#pragma once

#include <type_traits>

#include "bentur/io/case/case_parts.h"

namespace bentur {

/// What a case that is right is solved as: Problem of a row, PlanProblem of one in plan.
template <class AnyProblem>
[[nodiscard]] AnyProblem problem_as(const ReadCase& read) {
  if constexpr (std::is_same_v<AnyProblem, PlanProblem>) {
    return *read.plan;
  } else {
    return read.problem();
  }
}

}  // namespace bentur
