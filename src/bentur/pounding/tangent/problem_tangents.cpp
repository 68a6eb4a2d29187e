#include "bentur/pounding/tangent/problem_tangents.h"

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/internal/after_motion.h"

namespace bentur {
namespace {

template <class AnyProblem>
ProblemTangents tangents_of(const AnyProblem& problem, const std::vector<VariationOf<AnyProblem>>& variations,
                            const RunLimits& limits, const std::function<bool(double)>& progress) {
  ProblemTangents result;
  const FreeSolution free = free_solution(system_of(problem), ExactSolver{}, progress, limits, problem.goes_on);
  result.refused = why_no_tangents(free.system());
  if (result.refused) return result;
  Solution found = free.solution();
  if (found.status == Status::done) {
    found = free.solve(free.system().contacts, {.limits = limits, .changes = true, .progress = progress});
  }
  result.status = found.status;
  result.message = found.message;
  if (found.status != Status::done) return result;
  std::vector<Variation> taken;
  for (const VariationOf<AnyProblem>& by : variations) {
    Variation one{by.step, system_of(by.below), system_of(by.above)};
    result.left_out.push_back(why_no_tangents(free.system(), one));
    if (!result.left_out.back()) taken.push_back(std::move(one));
  }
  try {
    result.found = tangents(free, found, taken);
  } catch (const InvalidParameter& error) {
    result.refused = error.what();
  }
  return result;
}

}  // namespace

ProblemTangents tangents(const Problem& problem, const std::vector<VariationOf<Problem>>& variations,
                         const RunLimits& limits, const std::function<bool(double)>& progress) {
  validate(problem);
  return tangents_of(problem, variations, limits, progress);
}

ProblemTangents tangents(const PlanProblem& problem, const std::vector<VariationOf<PlanProblem>>& variations,
                         const RunLimits& limits, const std::function<bool(double)>& progress) {
  validate(problem);
  const bool moves_masses = std::any_of(problem.elsewhere.begin(), problem.elsewhere.end(),
                                        [](const std::vector<PlanBuilding>& places) { return !places.empty(); });
  if (moves_masses) {
    return {.refused = "what a gap needs is the most of many places of the masses (accidental_eccentricity)"};
  }
  return tangents_of(problem, variations, limits, progress);
}

}  // namespace bentur
