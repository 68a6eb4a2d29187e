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

/// Of its gaps alone: what is needed and what rules ask, with a table of levels and of rules for each.
[[nodiscard]] Story plan_gap_story(const PlanRun& run);

/// What rules of [code] ask of the gaps from heights alone, before anything is computed.
[[nodiscard]] Story plan_height_rules_story(const PlanCase& c, const PlanProblem& problem);

/// Where a gap falls short the most of what the motion without contact needs, and what that motion times −1 needs
/// there, where the case asks for it and it is known.
[[nodiscard]] std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap);

/// The gaps of a problem by name, in their order.
[[nodiscard]] std::vector<std::string> gap_names(const PlanProblem& problem);

}  // namespace bentur
