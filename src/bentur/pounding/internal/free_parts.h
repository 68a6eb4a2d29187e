#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "bentur/pounding/internal/after_motion.h"
#include "bentur/pounding/internal/progress_of_parts.h"
#include "bentur/pounding/internal/same_but_gaps.h"
#include "bentur/pounding/pounding.h"

// What problems of rows and of plans are solved by alike. Of either there are, by overloads:
//   validate, system_of, motions_in, gap_widths, gap_count, places_of, keeps_course, has_meetings: of a problem;
//   free_response, take_levels, take_meetings, take_solution: a solution as a response;
//   check_itself, drifts_no_contact: of a response;
//   mass_choices, with_masses_at, raise_needs: of a problem that has `elsewhere`.
namespace bentur {

template <class AnyProblem, class AnyResponse>
struct FreeResponseOf<AnyProblem, AnyResponse>::Parts {
  AnyProblem problem;  // valid
  Solver solver;
  FreeSolution free;
  RunLimits limits;
  bool levels;
  AnyResponse response;                         // as far as it goes without contact
  std::optional<AnyResponse> with_widths = {};  // the same where needs hang on widths or on where masses stand
};

namespace any_problem {

template <class AnyProblem>
[[nodiscard]] bool may_have_masses_elsewhere(const AnyProblem& problem) {
  if constexpr (requires { problem.elsewhere; }) return !problem.elsewhere.empty();
  return false;
}

[[nodiscard]] inline bool is_over(Status status) { return status == Status::done || status == Status::collapsed; }

template <class AnyProblem>
[[nodiscard]] AnyProblem valid(AnyProblem problem) {
  validate(problem);
  return problem;
}

/// What the free solution says.
template <class AnyResponse, class AnyProblem>
[[nodiscard]] AnyResponse told(const AnyProblem& problem, const FreeSolution& free, bool levels) {
  AnyResponse response = free_response(problem, free.solution());
  response.duration = free.system().duration;
  take_to_come(free, places_of(problem), response.points, response.watched);
  const bool mirrored = free.solution().status == Status::done && is_mirrored(free.system());
  if (levels) take_levels(problem, free.solution(), mirrored, response);
  return response;
}

template <class Parts, class AnyResponse, class AnyProblem>
[[nodiscard]] Parts parts_of(AnyProblem given, const Solver& solver, const std::function<bool(double)>& progress,
                             const RunLimits& limits, bool levels) {
  AnyProblem problem = valid(std::move(given));
  FreeSolution free = free_solution(system_of(problem, levels), solver, progress, limits, problem.goes_on);
  AnyResponse response = told<AnyResponse>(problem, free, levels);
  return {std::move(problem), solver, std::move(free), limits, levels, std::move(response)};
}

}  // namespace any_problem

}  // namespace bentur
