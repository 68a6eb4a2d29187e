#pragma once

#include <string>
#include <vector>

#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"

namespace bentur {

/// What is said, without words, as a list in JSON (docs/result-json.md). `problem` names the buildings.
[[nodiscard]] std::string statements_json(const Problem& problem, const std::vector<Statement>& statements);
/// The same by the buildings' names.
[[nodiscard]] std::string statements_json(const std::vector<std::string>& names,
                                          const std::vector<Statement>& statements);
/// What is judged of a gap, with every reason: its kind, the way of the motion, the level, its numbers. One JSON
/// object.
[[nodiscard]] std::string judgement_json(const ToldJudgement& told);

}  // namespace bentur
