#include "bentur/pounding/pounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/checks/self_checks.h"
#include "bentur/pounding/internal/after_motion.h"
#include "bentur/pounding/internal/asked.h"
#include "bentur/pounding/internal/levels.h"
#include "bentur/pounding/internal/problem_checks.h"
#include "bentur/pounding/internal/progress_of_parts.h"
#include "bentur/pounding/internal/same_but_gaps.h"
#include "bentur/pounding/internal/summaries.h"

namespace bentur {
namespace {

/// What the reversed motion needs, where that is asked for and the free response has not told it, and what it does
/// where gaps of a row close.
void add_reversed(const Problem& problem, const Solver& solver, const SolveOptions& options, Response& response) {
  if (!options.both_ways) {
    take_reversed({}, response.points);
    take_reversed({}, response.watched);
  }
  const bool ended = response.status == Status::stopped || response.status == Status::failed;
  if (!options.both_ways || ended || std::holds_alternative<NoMotion>(problem.motion)) return;
  Problem other = problem;
  other.motion = reversed(std::move(other.motion));
  std::optional<FreeResponse> free;
  const auto solve_free = [&] {
    const auto go_on = [&](double) { return !options.progress || options.progress(1.0); };
    if (!free) free.emplace(other, solver, go_on, options.limits);
    return free->response().status == Status::done || free->response().status == Status::collapsed;
  };
  ReversedRun reversed;
  const auto take_free = [&](const Response& found) {
    reversed.collapse_no_contact = found.collapse_no_contact;
    for (const BuildingPeaks& one : found.buildings)
      reversed.drifts.push_back(largest_drift(one.drift_ratio_no_contact));
  };
  if (is_mirrored(problem)) {
    take_free(response);
  } else {
    if (!solve_free()) return;
    const Response& found = free->response();
    take_free(found);
    if (found.status == Status::done) {
      take_reversed(found.points, response.points);
      take_reversed(found.watched, response.watched);
    }
  }
  const auto width_at = [&](std::size_t i) { return problem.points[i].width; };
  // Where a gap of several closes others are struck that move otherwise than freely.
  if (problem.buildings.size() > 2 && some_point_closes(response.points, width_at)) {
    if (!solve_free()) return;
    SolveOptions rest;
    rest.limits = options.limits;
    if (options.progress) rest.progress = [&](double) { return options.progress(1.0); };
    Response with = free->solve(other, rest);
    if (with.status != Status::done && with.status != Status::collapsed) return;
    reversed.has_contact = true;
    reversed.collapse = with.collapse;
    reversed.points = std::move(with.points);
    reversed.watched = std::move(with.watched);
  }
  response.reversed = std::move(reversed);
}

/// How many times one motion is another, > 0; nothing where it is not.
std::optional<double> times(const GroundMotion& motion, const GroundMotion& other) {
  constexpr double round_off = 1e-14;  // of the largest acceleration
  const auto* sampled = std::get_if<SampledMotion>(&motion);
  const auto* from = std::get_if<SampledMotion>(&other);
  if (sampled == nullptr || from == nullptr || sampled->time_step != from->time_step) return std::nullopt;
  const std::vector<double>&a = sampled->acceleration, &b = from->acceleration;
  const double peak = peak_acceleration(motion), factor = peak / peak_acceleration(other);
  if (a.size() != b.size() || !(factor > 0.0) || !std::isfinite(factor)) return std::nullopt;
  const bool alike = std::equal(a.begin(), a.end(), b.begin(),
                                [&](double x, double y) { return std::abs(x - factor * y) <= round_off * peak; });
  return alike ? std::optional(factor) : std::nullopt;
}

bool starts_from_rest(const Problem& problem) {
  return rests(problem.initial_displacement) && rests(problem.initial_velocity);
}

Problem valid(Problem problem) {
  validate(problem);
  return problem;
}

}  // namespace

bool is_mirrored(const Problem& problem) {
  const auto odd = [](const auto& law) { return law == nullptr || law->is_odd(); };
  const auto& buildings = problem.buildings;
  return !std::holds_alternative<NoMotion>(problem.motion) && starts_from_rest(problem) &&
         std::all_of(problem.links.begin(), problem.links.end(), [&](const Link& link) { return odd(link.law); }) &&
         std::all_of(buildings.begin(), buildings.end(), [&](const Building& building) {
           return std::all_of(building.elements.begin(), building.elements.end(),
                              [](const BuildingElement& element) { return element.law->is_odd(); }) &&
                  std::all_of(building.coupled.begin(), building.coupled.end(),
                              [](const CoupledElement& element) { return element.law->is_odd(); });
         });
}

bool is_homogeneous(const Problem& problem) {
  return starts_from_rest(problem) &&
         std::all_of(problem.links.begin(), problem.links.end(),
                     [](const Link& link) { return link.law != nullptr && link.law->is_homogeneous(); }) &&
         std::none_of(problem.buildings.begin(), problem.buildings.end(),
                      [](const Building& building) { return building.can_yield() || building.has_gravity_loads; });
}

/// A free response, of a problem that is valid.
struct CheckedFree {
  Problem problem;
  Solver solver;
  FreeSolution free;
  double factor;      ///< the problem's motion is so many times that of `free`
  Response response;  ///< as far as it goes without contact

  /// With the contacts of a problem that is valid, and this one but for gaps and laws.
  [[nodiscard]] Response solve(const Problem& other, const SolveOptions& options) const;
};

namespace {

CheckedFree free_of(Problem problem, const Solver& solver, const std::function<bool(double)>& progress,
                    const RunLimits& limits, bool levels) {
  Problem given = valid(std::move(problem));
  const bool mirrored = is_mirrored(given);
  FreeSolution free = free_solution(system_of(given, levels), solver, progress, limits, given.goes_on, mirrored);
  Response response = free_response(given, free.solution());
  response.duration = free.system().duration;
  take_to_come(free.system(), free.solution(), {}, mirrored, response.points, response.watched);
  if (levels) {
    const bool known = mirrored && response.status == Status::done;
    const auto peak_of = [&](std::size_t level, int side) -> std::optional<double> {
      const std::optional<Eigen::Index> floor = face_floor(given, level, side);
      if (!floor) return std::nullopt;
      const Eigen::Index left =
          level < given.points.size() ? given.points[level].left : given.watched[level - given.points.size()].left;
      return response.buildings[left + side].displacement_no_contact(*floor);
    };
    report_levels(free.solution().watched_free, known, peak_of, response.points, response.watched);
  }
  return {std::move(given), solver, std::move(free), 1.0, std::move(response)};
}

}  // namespace

Response CheckedFree::solve(const Problem& other, const SolveOptions& options) const {
  const auto began = std::chrono::steady_clock::now();
  Response with = response;
  if (with.status != Status::done && with.status != Status::collapsed) return with;
  std::vector<Contact> contacts = contacts_of(other);
  for (std::size_t i = 0; factor != 1.0 && i < contacts.size(); ++i) {
    if (!contacts[i].law->is_homogeneous()) {
      throw InvalidParameter(fmt::format("points[{}].law", i), std::string(contacts[i].law->name()),
                             "must be homogeneous where a free response is scaled");
    }
    contacts[i].width /= factor;
  }
  Solution solution = free.solve(contacts, run_options(options));
  if (factor != 1.0) solution = scaled(std::move(solution), factor);
  const SelfMeasures measures = solution.checks;
  take_to_come_struck(solution, {}, with.points, with.watched);
  take_solution(other, std::move(solution), with);
  check_itself(other, solver, measures, with);
  with.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return with;
}

struct FreeResponse::Parts : CheckedFree {};

FreeResponse::FreeResponse(Problem problem, const Solver& solver, const std::function<bool(double)>& progress,
                           const RunLimits& limits, bool levels)
    : parts_(std::make_shared<Parts>(Parts{free_of(std::move(problem), solver, progress, limits, levels)})) {}

std::optional<FreeResponse> FreeResponse::scaled(Problem problem) const {
  Problem given = valid(std::move(problem));
  const std::optional<double> factor = times(given.motion, parts_->problem.motion);
  if (!factor || !std::holds_alternative<ExactSolver>(parts_->solver) || !is_homogeneous(given) ||
      parts_->response.status != Status::done) {
    return std::nullopt;
  }
  GroundMotion motion = std::exchange(given.motion, parts_->problem.motion);
  require_same_but_gaps(parts_->problem, given);
  given.motion = std::move(motion);
  const double of_free = *factor * parts_->factor;
  const Solution scaled = bentur::scaled(parts_->free.solution(), of_free);
  Response response = free_response(given, scaled);
  response.duration = parts_->response.duration;
  take_to_come(parts_->free.system(), scaled, {}, is_mirrored(given), response.points, response.watched);
  FreeResponse free;
  free.parts_ =
      std::make_shared<Parts>(Parts{{std::move(given), parts_->solver, parts_->free, of_free, std::move(response)}});
  return free;
}

const Response& FreeResponse::response() const { return parts_->response; }

Response FreeResponse::solve(const Problem& problem, const SolveOptions& options) const {
  validate(problem);
  require_same_but_gaps(parts_->problem, problem);
  return parts_->solve(problem, options);
}

Effort effort(const Problem& problem, const Solver& solver, const SolveOptions& options) {
  return effort(system_of(valid(problem)), solver, run_options(options));
}

Response solve(const Problem& problem, const Solver& solver, const SolveOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  const ProgressOfParts progress(options.progress);
  SolveOptions rest = options;
  rest.progress = progress.rest;
  const bool levels = options.levels || options.both_ways;
  const CheckedFree free = free_of(problem, solver, progress.free, options.limits, levels);
  Response response = free.solve(problem, rest);
  add_reversed(problem, solver, options, response);
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace bentur
