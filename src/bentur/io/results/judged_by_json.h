#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "bentur/pounding/response.h"

// What gaps are judged by and a summary has nowhere else, of rows and plans alike (docs/result-files.md).
namespace bentur {

/// @param drifts largest one of each building without contact
[[nodiscard]] nlohmann::ordered_json judged_by_json(const RunOutcome& outcome, const std::vector<LargestDrift>& drifts);

/// Takes it into what is read back, whose points and watched floors are there. @throws nlohmann's exceptions where
/// something is missing @return the largest drifts without contact
std::vector<LargestDrift> take_judged_by(const nlohmann::json& json, RunOutcome& outcome);

}  // namespace bentur
