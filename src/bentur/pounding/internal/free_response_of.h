#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "bentur/pounding/internal/free_parts.h"

// Problems of rows and of plans are solved alike: what free_parts.h has without contact, and with it.
namespace bentur {

namespace any_problem {

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

/// What the reversed motion needs, where that is asked for and the free response does not have it; nothing where that
/// is not known.
template <class AnyProblem, class AnyResponse, class Parts>
[[nodiscard]] std::optional<ReversedRun> reversed_free(const SolveOptions& options, const System& system,
                                                       ReversedFree<Parts, AnyProblem>& other, AnyResponse& response) {
  if (!options.both_ways) {
    take_reversed({}, response.points);
    take_reversed({}, response.watched);
  }
  if (!options.both_ways || !is_over(response.status) || !is_shaken(system)) return std::nullopt;
  ReversedRun reversed;
  const auto take_free = [&](const AnyResponse& found) {
    reversed.collapse_no_contact = found.collapse_no_contact;
    reversed.drifts = drifts_no_contact(found);
  };
  if (is_mirrored(system)) {
    take_free(response);
    return reversed;
  }
  const AnyResponse& found = other.parts().response;
  if (!is_over(found.status)) return std::nullopt;
  take_free(found);
  if (found.status == Status::done) {
    take_reversed(found.points, response.points);
    take_reversed(found.watched, response.watched);
  }
  return reversed;
}

/// The same, and what the reversed motion does where some gap of several closes, so that others are struck that move
/// otherwise than freely.
template <class AnyProblem, class AnyResponse, class Parts>
void add_reversed(const AnyProblem& problem, const SolveOptions& options, const System& system,
                  ReversedFree<Parts, AnyProblem>& other, AnyResponse& response) {
  std::optional<ReversedRun> reversed = reversed_free(options, system, other, response);
  if (!reversed) return;
  const bool others_close = gap_count(problem) > 1 && some_point_closes(response.points, gap_widths(problem));
  // Of what ends in collapse nothing is known without contact, but contact may come before.
  if (others_close || reversed->collapse_no_contact) {
    if (!is_over(other.parts().response.status)) return;
    SolveOptions rest;
    rest.limits = options.limits;
    if (options.progress) rest.progress = [&](double) { return options.progress(1.0); };
    const FreeSolution& free = other.parts().free;
    AnyResponse with = solved(other.parts(), other.problem(), free.system(), rest);
    if (!is_over(with.status)) return;
    // Nothing is asked of the motion reversed once more.
    take_meetings(other.problem(), free.system(), free, other.free(), rest.limits, with.points);
    reversed->has_contact = true;
    reversed->collapse = with.collapse;
    reversed->points = std::move(with.points);
    reversed->watched = std::move(with.watched);
  }
  response.reversed = std::move(reversed);
}

/// Raises what the response needs without contact to the most of all places where masses may stand; of a row they stand
/// where they are. @param options of what is asked: `levels`, and `both_ways` where the response has what the reversed
/// motion needs
template <class Parts, class AnyProblem, class AnyResponse>
void take_masses_elsewhere(const AnyProblem& problem, const Solver& solver, const SolveOptions& options,
                           AnyResponse& response) {
  if constexpr (requires { problem.elsewhere; }) {
    const auto goes_on = [&](double) { return !options.progress || options.progress(1.0); };
    int choice = 0;
    for (const auto& places : mass_choices(problem)) {
      if (!is_over(response.status)) return;
      ++choice;
      const AnyProblem moved = with_masses_at(problem, places);
      const Parts parts = parts_of<Parts, AnyResponse>(moved, solver, goes_on, options.limits, options.levels);
      AnyResponse free = parts.response;
      if (!is_over(free.status)) {
        response.status = free.status;
        response.message = free.message;
        return;
      }
      ReversedFree<Parts, AnyProblem> other(moved, solver, options.limits, goes_on);
      const System& system = parts.free.system();
      free.reversed = reversed_free(options, system, other, free);
      take_meetings(moved, system, parts.free, other.free(), options.limits, free.points);
      raise_needs(free, choice, response);
    }
  }
}

/// What a free response has: of the reversed motion what follows from it.
template <class Parts>
[[nodiscard]] SolveOptions free_options(const Parts& parts) {
  SolveOptions options;
  options.limits = parts.limits;
  options.levels = parts.levels;
  options.both_ways = parts.levels && is_mirrored(parts.free.system());
  return options;
}

/// With the needs of the problem itself, for response().
template <class Parts>
[[nodiscard]] Parts with_needs(Parts parts) {
  if (!has_meetings(parts.problem) && !may_have_masses_elsewhere(parts.problem)) return parts;
  auto needs = parts.response;
  const System& system = parts.free.system();
  if (has_meetings(parts.problem)) {
    ReversedFree<Parts, decltype(Parts::problem)> other(parts.problem, parts.solver, parts.limits);
    take_meetings(parts.problem, system, parts.free, other.free(), parts.limits, needs.points);
  }
  take_masses_elsewhere<Parts>(parts.problem, parts.solver, free_options(parts), needs);
  parts.with_widths = std::move(needs);
  return parts;
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
  rest = options;
  rest.levels = levels;
  take_masses_elsewhere<Parts>(problem, solver, rest, response);
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
  any_problem::take_masses_elsewhere<Parts>(problem, parts_->solver, any_problem::free_options(*parts_), response);
  return response;
}

}  // namespace bentur
