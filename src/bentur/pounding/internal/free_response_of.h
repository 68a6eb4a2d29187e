#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <utility>

#include "bentur/pounding/internal/reversed_motion.h"

// Problems of rows and of plans are solved alike: what free_parts.h has without contact, and with it.
namespace bentur {

namespace any_problem {

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
      ReversedMotion<Parts, AnyProblem> other(moved, solver, options.limits, goes_on);
      const System& system = parts.free.system();
      free.reversed = reversed_free(options, system, other, free);
      FreeTouches touches(system, parts.free, options.limits);
      bring_down_needs(moved, touches, other, free);
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
    ReversedMotion<Parts, decltype(Parts::problem)> other(parts.problem, parts.solver, parts.limits);
    FreeTouches touches(system, parts.free, parts.limits);
    bring_down_needs(parts.problem, touches, other, needs);
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
  std::atomic<bool> stops = false, is_beside = false;
  const auto ask = [&stops, &options] {
    if (options.progress && !options.progress(1.0)) stops = true;
  };
  ReversedMotion<Parts, AnyProblem> other(problem, solver, options.limits, [&](double) {
    if (!is_beside) ask();
    return !stops;
  });
  std::future<void> beside;
  if (options.beside && options.both_ways && is_over(parts.response.status) && is_shaken(system)) {
    is_beside = true;
    beside = options.beside([&parts, &other] { find_reversed(parts, other); });
  }
  AnyResponse response = solved(parts, problem, system, rest);
  if (!is_over(response.status)) stops = true;
  FreeTouches touches(system, parts.free, options.limits);
  if (beside.valid()) {
    if (has_meetings(problem) && !stops) static_cast<void>(touches.found());
    constexpr std::chrono::milliseconds between_looks(50);
    while (beside.wait_for(between_looks) == std::future_status::timeout) ask();
    beside.get();
  }
  is_beside = false;
  add_reversed(problem, options, system, other, response);
  bring_down_needs(problem, touches, other, response);
  if (stops && is_over(response.status)) {
    response.status = Status::stopped;
    response.message = "stopped on request";
  }
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
  any_problem::ReversedMotion<Parts, AnyProblem> other(problem, parts_->solver, options.limits);
  FreeTouches touches(system, parts_->free, options.limits);
  any_problem::bring_down_needs(problem, touches, other, response);
  any_problem::take_masses_elsewhere<Parts>(problem, parts_->solver, any_problem::free_options(*parts_), response);
  return response;
}

}  // namespace bentur
