#include "bentur/pounding/pounding.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "bentur/pounding/assemble.h"
#include "bentur/pounding/checks/self_checks.h"
#include "bentur/pounding/internal/levels.h"
#include "bentur/pounding/internal/same_but_gaps.h"
#include "bentur/pounding/internal/summaries.h"

namespace bentur {
namespace {

GroundMotion reversed(GroundMotion motion) {
  if (auto* sampled = std::get_if<SampledMotion>(&motion)) {
    for (double& value : sampled->acceleration) value = -value;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= -1;
  return motion;
}

/// Of points and watched floors alike.
template <typename Summary>
void take_reversed(const std::vector<Summary>& from, std::vector<Summary>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i].gap_needed_reversed = from.empty() ? std::nullopt : std::optional(from[i].gap_needed);
  }
}

/// What the reversed motion needs, where that is asked for and the free response has not told it; nothing where it
/// collapses or there is none.
void add_reversed(const Problem& problem, const Solver& solver, const SolveOptions& options, Response& response) {
  if (!options.both_ways) {
    take_reversed({}, response.points);
    take_reversed({}, response.watched);
  }
  const bool ended = response.status == Status::stopped || response.status == Status::failed;
  if (!options.both_ways || ended || is_mirrored(problem) || std::holds_alternative<NoMotion>(problem.motion)) return;
  Problem other = problem;
  other.motion = reversed(std::move(other.motion));
  const auto go_on = [&](double) { return !options.progress || options.progress(1.0); };
  const FreeResponse free(std::move(other), solver, go_on, options.most_steps);
  if (free.response().status != Status::done) return;
  take_reversed(free.response().points, response.points);
  take_reversed(free.response().watched, response.watched);
}

RunOptions run_options(const SolveOptions& options) {
  return {.output_step = options.output_step,
          .course = options.course,
          .most_steps = options.most_steps,
          .energy_audit = options.energy_audit,
          .progress = options.progress};
}

Problem valid(Problem problem) {
  validate(problem);
  return problem;
}

}  // namespace

bool is_mirrored(const Problem& problem) {
  const auto rests = [](const std::vector<Eigen::VectorXd>& initial) {
    return std::all_of(initial.begin(), initial.end(), [](const auto& x) { return x.isZero(0.0); });
  };
  const auto odd = [](const auto& law) { return law == nullptr || law->is_odd(); };
  const auto& buildings = problem.buildings;
  return !std::holds_alternative<NoMotion>(problem.motion) && rests(problem.initial_displacement) &&
         rests(problem.initial_velocity) &&
         std::all_of(problem.links.begin(), problem.links.end(), [&](const Link& link) { return odd(link.law); }) &&
         std::all_of(buildings.begin(), buildings.end(), [&](const Building& building) {
           return std::all_of(building.elements.begin(), building.elements.end(),
                              [](const BuildingElement& element) { return element.law->is_odd(); }) &&
                  std::all_of(building.coupled.begin(), building.coupled.end(),
                              [](const CoupledElement& element) { return element.law->is_odd(); });
         });
}

/// A free response, of a problem that is valid.
struct CheckedFree {
  Problem problem;
  Solver solver;
  FreeSolution free;
  Response response;  ///< as far as it goes without contact

  /// With the contacts of a problem that is valid, and this one but for gaps and laws.
  [[nodiscard]] Response solve(const Problem& other, const SolveOptions& options) const;
};

namespace {

CheckedFree free_of(Problem problem, const Solver& solver, const std::function<bool(double)>& progress, long most_steps,
                    bool levels) {
  Problem given = valid(std::move(problem));
  FreeSolution free(system_of(given, levels), solver, progress, most_steps);
  Response response = free_response(given, free.solution());
  if (levels) {
    const bool mirrored = response.status == Status::done && is_mirrored(given);
    report_levels(given, free.solution().watched_free, mirrored, response);
  }
  return {std::move(given), solver, std::move(free), std::move(response)};
}

}  // namespace

Response CheckedFree::solve(const Problem& other, const SolveOptions& options) const {
  const auto began = std::chrono::steady_clock::now();
  Response with = response;
  if (with.status != Status::done && with.status != Status::collapsed) return with;
  Solution solution = free.solve(contacts_of(other), run_options(options));
  const SelfMeasures measures = solution.checks;
  take_solution(other, std::move(solution), with);
  check_itself(other, solver, measures, with);
  with.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return with;
}

struct FreeResponse::Parts : CheckedFree {};

FreeResponse::FreeResponse(Problem problem, const Solver& solver, const std::function<bool(double)>& progress,
                           long most_steps, bool levels)
    : parts_(std::make_shared<Parts>(Parts{free_of(std::move(problem), solver, progress, most_steps, levels)})) {}

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
  constexpr double free_part = 0.25;  // of the work, for the progress shown
  SolveOptions rest = options;
  std::function<bool(double)> first;
  if (options.progress) {
    first = [&](double fraction) { return options.progress(free_part * fraction); };
    rest.progress = [&](double fraction) { return options.progress(free_part + (1.0 - free_part) * fraction); };
  }
  const bool levels = options.levels || options.both_ways;
  const CheckedFree free = free_of(problem, solver, first, options.most_steps, levels);
  Response response = free.solve(problem, rest);
  add_reversed(problem, solver, options, response);
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace bentur
