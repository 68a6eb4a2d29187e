#pragma once

#include <string>

#include "bentur/core/units.h"
#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"

namespace bentur {

/// `impacts.csv`: one row per impact by start, a header row with units, numbers to the last digit (RFC 4180, LF).
/// A restitution that is not known stays empty.
[[nodiscard]] std::string impacts_csv(const Units& units, const Problem& problem, const Response& response);

}  // namespace bentur
