#include "bentur/pounding/tangent/problem_tangents.h"

#include "bentur/core/errors.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/internal/after_motion.h"

namespace bentur {

ProblemTangents tangents(const Problem& problem, const std::vector<ProblemVariation>& variations,
                         const RunLimits& limits, const std::function<bool(double)>& progress) {
  validate(problem);
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
  for (const ProblemVariation& by : variations) {
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

}  // namespace bentur
