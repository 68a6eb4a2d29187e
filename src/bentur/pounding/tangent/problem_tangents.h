#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/solve/tangent/tangent.h"

namespace bentur {

/// A number that a problem depends on, by the problems with a little less and a little more of it.
struct ProblemVariation {
  double step = 0;  ///< what is taken away and added [the number's unit] > 0
  Problem below, above;
};

struct ProblemTangents {
  Status status = Status::done;  ///< of the run
  std::string message = {};      ///< why, unless done
  /// Why there are no derivatives of this problem; nothing: there are.
  std::optional<std::string> refused = {};
  /// Per variation, why there are none by it; nothing: there are, in the order of those that have none of this.
  std::vector<std::optional<std::string>> left_out = {};
  Tangents found = {};  ///< contacts are the points of the problem
};

/// Solves a problem exactly, and follows what happens with derivatives. The run is that of solve().
/// @throws InvalidParameter where a problem is not valid
[[nodiscard]] ProblemTangents tangents(const Problem& problem, const std::vector<ProblemVariation>& variations,
                                       const RunLimits& limits = {}, const std::function<bool(double)>& progress = {});

}  // namespace bentur
