#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "bentur/model/case.h"
#include "bentur/model/gap/minimum_gap.h"

namespace bentur {

/// What is known of the rules of [code] themselves: a list in JSON (docs/result-files.md).
[[nodiscard]] nlohmann::ordered_json code_rules_json(const CodeSpec& code);

/// What rules ask at a level: a list in JSON with one entry per rule.
[[nodiscard]] nlohmann::ordered_json code_separation_json(const CodeSeparation& code);

/// What rules ask of a gap from heights alone.
[[nodiscard]] nlohmann::ordered_json height_gap_json(const Case& c, const Problem& problem, Eigen::Index gap);

/// Why a rule says nothing: "linked"; empty where it does.
[[nodiscard]] std::string_view silence_name(RuleFinding::Silence silence);

}  // namespace bentur
