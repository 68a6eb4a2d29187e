#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/pounding/internal/asked.h"
#include "bentur/pounding/internal/free_parts.h"
#include "bentur/pounding/plan/free_touches.h"

// What problems of rows and of plans do with contact, as given and under the motion reversed.
namespace bentur::any_problem {

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

/// A problem under the motion reversed, and its responses without contact and with it, each made where it is first
/// asked for.
template <class Parts, class AnyProblem>
class ReversedMotion {
 public:
  using AnyResponse = decltype(Parts::response);

  /// @param problem lives as long as this, and `solver`
  /// @param progress as SolveOptions::progress
  ReversedMotion(const AnyProblem& problem, const Solver& solver, const RunLimits& limits,
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
    if (!parts_) parts_.emplace(parts_of<Parts, AnyResponse>(problem(), solver_, progress_, limits_, false));
    return *parts_;
  }
  [[nodiscard]] FreeTouches& touches() {
    if (!touches_) touches_.emplace(parts().free.system(), parts().free, limits_);
    return *touches_;
  }
  /// Of which nothing is asked of the motion reversed once more; nothing where it does not get to its end.
  [[nodiscard]] const std::optional<AnyResponse>& with_contact() {
    if (!with_contact_) with_contact_.emplace(found_with_contact());
    return *with_contact_;
  }

 private:
  [[nodiscard]] std::optional<AnyResponse> found_with_contact() {
    if (!is_over(parts().response.status)) return std::nullopt;
    SolveOptions options;
    options.limits = limits_;
    options.progress = progress_;
    const FreeSolution& free = parts().free;
    AnyResponse with = solved(parts(), problem(), free.system(), options);
    if (!is_over(with.status)) return std::nullopt;
    take_meetings(
        problem(), touches(), [this]() -> FreeTouches& { return touches(); }, with.points);
    return with;
  }

  const AnyProblem& given_;
  const Solver& solver_;
  RunLimits limits_;
  std::function<bool(double)> progress_;
  std::optional<AnyProblem> problem_;
  std::optional<Parts> parts_;
  std::optional<FreeTouches> touches_;
  std::optional<std::optional<AnyResponse>> with_contact_;
};

/// Brings needs down where bodies touch only while several places are closed, and never are.
template <class Parts, class AnyProblem, class AnyResponse>
void bring_down_needs(const AnyProblem& problem, FreeTouches& given, ReversedMotion<Parts, AnyProblem>& other,
                      AnyResponse& response) {
  take_meetings(
      problem, given, [&other]() -> FreeTouches& { return other.touches(); }, response.points);
}

/// What the reversed motion needs, where that is asked for and the free response does not have it; nothing where that
/// is not known.
template <class AnyProblem, class AnyResponse, class Parts>
[[nodiscard]] std::optional<ReversedRun> reversed_free(const SolveOptions& options, const System& system,
                                                       ReversedMotion<Parts, AnyProblem>& other,
                                                       AnyResponse& response) {
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
                  ReversedMotion<Parts, AnyProblem>& other, AnyResponse& response) {
  std::optional<ReversedRun> reversed = reversed_free(options, system, other, response);
  if (!reversed) return;
  const bool others_close = gap_count(problem) > 1 && some_point_closes(response.points, gap_widths(problem));
  // Of what ends in collapse nothing is known without contact, but contact may come before.
  if (others_close || reversed->collapse_no_contact) {
    const std::optional<AnyResponse>& with = other.with_contact();
    if (!with) return;
    reversed->has_contact = true;
    reversed->collapse = with->collapse;
    reversed->points = with->points;
    reversed->watched = with->watched;
  }
  response.reversed = std::move(reversed);
}

/// Finds ahead what add_reversed() will ask of the reversed motion.
template <class Parts, class AnyProblem>
void find_reversed(const Parts& parts, ReversedMotion<Parts, AnyProblem>& other) {
  const std::vector<double> widths = gap_widths(parts.problem);
  bool closes = some_need_exceeds(parts.response.points, widths);
  if (!is_mirrored(parts.free.system())) {
    closes = some_need_exceeds(other.parts().response.points, widths) || closes;
  }
  if (closes && gap_count(parts.problem) > 1) static_cast<void>(other.with_contact());
  if (has_meetings(parts.problem)) static_cast<void>(other.touches().found());
}

}  // namespace bentur::any_problem
