#include "bentur/pounding/tangent/problem_tangents.h"

#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/internal/after_motion.h"
#include "bentur/pounding/internal/free_parts.h"
#include "bentur/pounding/plan/plan_meetings.h"
#include "bentur/pounding/plan/plan_pounding.h"

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

/// Of what was found of a system's contacts that of the points of its problem, without seams. Where edges that close
/// one after the other never touch, a point needs less than its contact; of that there is no derivative.
void take_points(const PlanProblem& problem, const RunLimits& limits, Tangents& found) {
  std::size_t count = 0;
  for (const PlanGap& gap : problem.gaps) count += gap.contacts.size();
  found.needed.resize(count);
  found.peak_force.resize(count);
  if (!has_meetings(problem)) return;
  const PlanFreeResponse free(problem, ExactSolver{}, {}, limits);
  constexpr double same = 1e-9;
  for (std::size_t i = 0; i < count; ++i) {
    Derivative& needed = found.needed[i];
    const double value = free.response().points[i].gap_needed;
    if (std::abs(needed.value - value) > same * value) needed = {.value = value, .time = not_known, .by = {}};
  }
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
  if (any_problem::may_have_masses_elsewhere(problem)) {
    return {.refused = "what a gap needs is the most of many places of the masses (accidental_eccentricity)"};
  }
  ProblemTangents result = tangents_of(problem, variations, limits, progress);
  if (!result.refused && result.status == Status::done) take_points(problem, limits, result.found);
  return result;
}

}  // namespace bentur
