#pragma once

#include <optional>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_case.h"
#include "bentur/model/run_results.h"

// A gap of buildings in plan as that of a row of two, for what is told of gaps of rows and plans alike.
namespace bentur {

/// L and R of a gap as a row, its contact points and what it watches those of the row. Known of the buildings are
/// names, levels, masses and, where they move, circular frequencies; of their damping nothing, as modes of floors that
/// turn are of no one direction.
[[nodiscard]] Problem pair_of(const PlanProblem& problem, std::size_t gap);
/// The same with [code] as it is for the two.
[[nodiscard]] RunResults pair_of(const PlanCase& c, const PlanProblem& problem, std::size_t gap);
/// The same with what the response says of points and watched floors, and of the buildings how far the edges of their
/// floors move across the gap without contact. @throws InvalidParameter unless it is of this problem.
[[nodiscard]] RunResults pair_of(const PlanRun& run, std::size_t gap);

/// Where a gap falls short the most of what the motion without contact needs, and what that motion times −1 needs
/// there, where the case asks for it and it is known.
[[nodiscard]] std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap);

/// Where a contact point (else what is watched) of a gap is, in the middle of it [length].
[[nodiscard]] PlanPoint place_of(const PlanGap& gap, bool is_point, Eigen::Index index);

}  // namespace bentur
