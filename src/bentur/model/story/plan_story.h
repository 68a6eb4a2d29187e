#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_case.h"
#include "bentur/model/story/story.h"

namespace bentur {

/// Of a run of buildings in plan: who collides where and how hard, the gap needed both ways round, what contact does to
/// the buildings, planes that yield, the ground motion as applied, what the model leaves out. Gaps of statements are
/// those of the problem.
[[nodiscard]] Story plan_story(const PlanRun& run);

/// Where the motion without contact needs the most of a gap, or, `reversed`, that motion times −1; nothing where that
/// is not known, and, of a gap whose floors are not all watched, where it is no more than is given: it may be too
/// little. `watched` is not set.
[[nodiscard]] std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap, bool reversed);

/// The gaps of a problem by name, in their order.
[[nodiscard]] std::vector<std::string> gap_names(const PlanProblem& problem);

}  // namespace bentur
