#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "bentur/pounding/internal/after_motion.h"
#include "bentur/pounding/internal/asked.h"
#include "bentur/pounding/internal/progress_of_parts.h"
#include "bentur/pounding/internal/same_but_gaps.h"
#include "bentur/pounding/pounding.h"

// What problems of rows and of plans are solved by alike. Of either there are, by overloads:
//   validate, system_of, motions_in, gap_widths, gap_count, places_of, keeps_course, has_meetings: of a problem;
//   free_response, take_levels, take_meetings, take_solution: a solution as a response;
//   check_itself, drifts_no_contact: of a response.
namespace bentur {

template <class AnyProblem, class AnyResponse>
struct FreeResponseOf<AnyProblem, AnyResponse>::Parts {
  AnyProblem problem;  // valid
  Solver solver;
  FreeSolution free;
  RunLimits limits;
  bool levels;
  AnyResponse response;                         // as far as it goes without contact
  std::optional<AnyResponse> with_widths = {};  // the same where needs hang on the widths of the problem
};

namespace any_problem {

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

/// A problem under the motion reversed, made where it is first asked for, as its response without contact is.
template <class Parts, class AnyProblem>
class ReversedFree {
 public:
  /// @param problem lives as long as this
  ReversedFree(const AnyProblem& problem, const Solver& solver, const RunLimits& limits,
               std::function<bool(double)> progress = {})
      : given_(problem), solver_(solver), limits_(limits), progress_(std::move(progress)) {}

  [[nodiscard]] const AnyProblem& problem() {
    if (!problem_) {
      problem_ = given_;
      for (GroundMotion& motion : motions_in(*problem_)) motion = reversed(std::move(motion));
    }
    return *problem_;
  }
  [[nodiscard]] const Parts& parts() {
    using AnyResponse = decltype(Parts::response);
    if (!parts_) parts_.emplace(parts_of<Parts, AnyResponse>(problem(), solver_, progress_, limits_, false));
    return *parts_;
  }
  /// For take_meetings().
  [[nodiscard]] std::function<FreeSolution()> free() {
    return [this] { return parts().free; };
  }

 private:
  const AnyProblem& given_;
  const Solver& solver_;
  RunLimits limits_;
  std::function<bool(double)> progress_;
  std::optional<AnyProblem> problem_;
  std::optional<Parts> parts_;
};

/// With the needs of the problem itself, for response().
template <class Parts>
[[nodiscard]] Parts with_needs(Parts parts) {
  if (!has_meetings(parts.problem)) return parts;
  ReversedFree<Parts, decltype(Parts::problem)> other(parts.problem, parts.solver, parts.limits);
  parts.with_widths = parts.response;
  take_meetings(parts.problem, parts.free.system(), parts.free, other.free(), parts.limits, parts.with_widths->points);
  return parts;
}

/// With the contacts of `other`, which its system has, and which is the parts' problem but for gaps and laws.
template <class Parts, class AnyProblem>
[[nodiscard]] auto solved(const Parts& parts, const AnyProblem& other, const System& system,
                          const SolveOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  auto with = parts.response;
  if (!is_over(with.status)) return with;
  RunOptions asked = run_options(options);
  asked.course = asked.course && keeps_course(other);
  Solution solution = parts.free.solve(system.contacts, system.rubbing, asked);
  const SelfMeasures measures = solution.checks;
  take_to_come_struck(solution, places_of(other), with.points, with.watched);
  take_solution(other, std::move(solution), with);
  check_itself(other, parts.solver, measures, with);
  with.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return with;
}

/// What the reversed motion needs, where that is asked for and the free response does not have it, and what it does
/// where some gap of several closes, so that others are struck that move otherwise than freely.
template <class AnyProblem, class AnyResponse, class Parts>
void add_reversed(const AnyProblem& problem, const SolveOptions& options, const System& system,
                  ReversedFree<Parts, AnyProblem>& other, AnyResponse& response) {
  if (!options.both_ways) {
    take_reversed({}, response.points);
    take_reversed({}, response.watched);
  }
  if (!options.both_ways || !is_over(response.status) || !is_shaken(system)) return;
  const auto is_solved = [&] { return is_over(other.parts().response.status); };
  ReversedRun reversed;
  const auto take_free = [&](const AnyResponse& found) {
    reversed.collapse_no_contact = found.collapse_no_contact;
    reversed.drifts = drifts_no_contact(found);
  };
  if (is_mirrored(system)) {
    take_free(response);
  } else {
    if (!is_solved()) return;
    const AnyResponse& found = other.parts().response;
    take_free(found);
    if (found.status == Status::done) {
      take_reversed(found.points, response.points);
      take_reversed(found.watched, response.watched);
    }
  }
  if (gap_count(problem) > 1 && some_point_closes(response.points, gap_widths(problem))) {
    if (!is_solved()) return;
    SolveOptions rest;
    rest.limits = options.limits;
    if (options.progress) rest.progress = [&](double) { return options.progress(1.0); };
    const FreeSolution& free = other.parts().free;
    AnyResponse with = solved(other.parts(), other.problem(), free.system(), rest);
    if (!is_over(with.status)) return;
    // Nothing is asked of the motion reversed once more.
    take_meetings(other.problem(), free.system(), free, other.free(), rest.limits, with.points);
    reversed.has_contact = true;
    reversed.collapse = with.collapse;
    reversed.points = std::move(with.points);
    reversed.watched = std::move(with.watched);
  }
  response.reversed = std::move(reversed);
}

/// As solve() of a problem is.
template <class AnyResponse, class AnyProblem>
[[nodiscard]] AnyResponse solution_of(const AnyProblem& problem, const Solver& solver, const SolveOptions& options) {
  using Parts = typename FreeResponseOf<AnyProblem, AnyResponse>::Parts;
  const auto began = std::chrono::steady_clock::now();
  const ProgressOfParts progress(options.progress);
  SolveOptions rest = options;
  rest.progress = progress.rest;
  const bool levels = options.levels || options.both_ways;
  const Parts parts = parts_of<Parts, AnyResponse>(problem, solver, progress.free, options.limits, levels);
  const System& system = parts.free.system();
  ReversedFree<Parts, AnyProblem> other(problem, solver, options.limits,
                                        [&](double) { return !options.progress || options.progress(1.0); });
  AnyResponse response = solved(parts, problem, system, rest);
  add_reversed(problem, options, system, other, response);
  take_meetings(problem, system, parts.free, other.free(), options.limits, response.points);
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace any_problem

template <class AnyProblem, class AnyResponse>
FreeResponseOf<AnyProblem, AnyResponse>::FreeResponseOf(AnyProblem problem, const Solver& solver,
                                                        const std::function<bool(double)>& progress,
                                                        const RunLimits& limits, bool levels)
    : parts_(std::make_shared<const Parts>(any_problem::with_needs(
          any_problem::parts_of<Parts, AnyResponse>(std::move(problem), solver, progress, limits, levels)))) {}

template <class AnyProblem, class AnyResponse>
std::optional<FreeResponseOf<AnyProblem, AnyResponse>> FreeResponseOf<AnyProblem, AnyResponse>::scaled(
    AnyProblem problem) const {
  AnyProblem given = any_problem::valid(std::move(problem));
  const System system = system_of(given);
  std::optional<FreeSolution> free = parts_->free.scaled(system.motions);
  if (!free || difference_but_gaps(parts_->problem, free->system(), given, system)) return std::nullopt;
  AnyResponse response = any_problem::told<AnyResponse>(given, *free, parts_->levels);
  FreeResponseOf result;
  result.parts_ = std::make_shared<const Parts>(any_problem::with_needs(
      Parts{std::move(given), parts_->solver, std::move(*free), parts_->limits, parts_->levels, std::move(response)}));
  return result;
}

template <class AnyProblem, class AnyResponse>
const AnyResponse& FreeResponseOf<AnyProblem, AnyResponse>::response() const {
  return parts_->with_widths ? *parts_->with_widths : parts_->response;
}

template <class AnyProblem, class AnyResponse>
bool FreeResponseOf<AnyProblem, AnyResponse>::serves(const AnyProblem& problem) const {
  validate(problem);
  const System system = system_of(problem);
  return parts_->free.takes(system.contacts, system.rubbing) &&
         !difference_but_gaps(parts_->problem, parts_->free.system(), problem, system);
}

template <class AnyProblem, class AnyResponse>
AnyResponse FreeResponseOf<AnyProblem, AnyResponse>::solve(const AnyProblem& problem,
                                                           const SolveOptions& options) const {
  validate(problem);
  const System system = system_of(problem);
  require_none(difference_but_gaps(parts_->problem, parts_->free.system(), problem, system));
  AnyResponse response = any_problem::solved(*parts_, problem, system, options);
  any_problem::ReversedFree<Parts, AnyProblem> other(problem, parts_->solver, options.limits);
  take_meetings(problem, system, parts_->free, other.free(), options.limits, response.points);
  return response;
}

}  // namespace bentur
