#pragma once

#include <string>
#include <vector>

#include "bentur/model/story/internal/story_parts.h"

// What a report that is handed in says of what it rests on and of what nobody has looked at.
namespace bentur::story {

[[nodiscard]] std::string with_unit(double value, const std::string& unit);
[[nodiscard]] std::string level_text(const GapView& facts, Eigen::Index gap, double level);

/// That the numbers rest on.
[[nodiscard]] std::vector<Statement> assumptions_of(const Case& c, const Problem& problem);
[[nodiscard]] std::vector<Statement> assumptions_of(const PlanRun& run);

/// What the case leaves open. @param plan of buildings in plan, else null @param without_energy whether a run was not
/// audited
[[nodiscard]] std::vector<Statement> unchecked_of(const Case& c, const GapView& facts, bool needs_seismicity,
                                                  const PlanProblem* plan, bool without_energy);

}  // namespace bentur::story
