#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/problem.h"
#include "bentur/solve/tangent/tangent.h"

namespace bentur {

/// A number that a problem depends on, by the problems with a little less and a little more of it: of buildings in a
/// row, or in plan.
template <class AnyProblem>
struct VariationOf {
  double step = 0;  ///< what is taken away and added [the number's unit] > 0
  AnyProblem below, above;
};

struct ProblemTangents {
  Status status = Status::done;  ///< of the run
  std::string message = {};      ///< why, unless done
  /// Why there are no derivatives of this problem; nothing: there are.
  std::optional<std::string> refused = {};
  /// Per variation, why there are none by it; nothing: there are, in the order of those that have none of this.
  std::vector<std::optional<std::string>> left_out = {};
  /// Contacts are the points of the problem, in plan those of all gaps; of displacements in plan the first ones are
  /// those of the centres of mass along x, and as many after them along y.
  Tangents found = {};
};

/// Solves a problem exactly, and follows what happens with derivatives. The run is that of solve().
/// @throws InvalidParameter where a problem is not valid
[[nodiscard]] ProblemTangents tangents(const Problem& problem, const std::vector<VariationOf<Problem>>& variations,
                                       const RunLimits& limits = {}, const std::function<bool(double)>& progress = {});
[[nodiscard]] ProblemTangents tangents(const PlanProblem& problem,
                                       const std::vector<VariationOf<PlanProblem>>& variations,
                                       const RunLimits& limits = {}, const std::function<bool(double)>& progress = {});

}  // namespace bentur
