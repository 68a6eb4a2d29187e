#pragma once

#include <cstddef>
#include <string>

#include "bentur/model/run_results.h"

namespace bentur {

// What a page that is no report, the studio, has from those of reports.

/// Impacts that a page lists; where there are more, it says so.
constexpr std::size_t most_impacts = 1500;

/// What motion.js draws, with its words in that language: the buildings in motion and the first impacts, by start.
/// The response must have histories.
/// @throws InvalidParameter for an unknown language.
[[nodiscard]] std::string motion_json(const RunResults& results, const std::string& language);

}  // namespace bentur
