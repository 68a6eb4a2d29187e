#include "bentur/solve/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/walk/free_walk.h"
#include "bentur/solve/walk/pounding_walk.h"

namespace bentur {
namespace engine {
namespace {

constexpr double round_off_band = 0x1p-46;  // of the displacements at a point: depth below which nothing is a contact

void validate(const Solver& solver) {
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver)) {
    if (!(adaptive->tolerance >= 1e-13 && adaptive->tolerance <= 1e-2)) {
      throw InvalidParameter("tolerance", fmt::format("{}", adaptive->tolerance), "must be in [1e-13, 1e-2]");
    }
  }
  if (const auto* fixed = std::get_if<RungeKuttaSolver>(&solver)) require_positive("step", fixed->step);
}

/// Depth below which nothing counts as a contact, per point.
std::vector<double> tolerances(const Problem& problem, const std::vector<BuildingPeaks>& peaks, const Walk& walk) {
  std::vector<double> result;
  for (const ContactPoint& point : problem.points) {
    const auto left = static_cast<std::size_t>(point.left);
    const double scale = point.width + peaks[left].displacement_no_contact(point.left_floor) +
                         peaks[left + 1].displacement_no_contact(point.right_floor) +
                         walk.largest_ground_displacement(left) + walk.largest_ground_displacement(left + 1);
    result.push_back(round_off_band * scale);
  }
  return result;
}

void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points) {
  for (const Impact& impact : impacts) {
    PointSummary& point = points[static_cast<std::size_t>(impact.point)];
    ++point.impacts;
    point.contact_duration += impact.end - impact.start;
    point.impulse += impact.impulse;
    point.energy_lost += impact.energy_lost;
    point.peak_penetration = std::max(point.peak_penetration, impact.peak_penetration);
    point.peak_closing_speed = std::max(point.peak_closing_speed, impact.closing_speed);
    point.peak_tension = std::max(point.peak_tension, impact.peak_tension);
    if (impact.peak_force > point.peak_force) {
      point.peak_force = impact.peak_force;
      point.peak_force_time = impact.peak_force_time;
    }
  }
}

/// Status and message of a walk that did not get to its end.
void report_end(Response& response, Status status, const Walk& walk) {
  response.status = status;
  if (status == Status::stopped) response.message = "stopped on request";
  if (status == Status::failed) {
    response.message = walk.trouble();
  }
}

}  // namespace
}  // namespace engine

std::string_view name(const Solver& solver) {
  if (std::holds_alternative<AdaptiveSolver>(solver)) return "adaptive";
  if (std::holds_alternative<RungeKuttaSolver>(solver)) return "runge-kutta";
  return "exact";
}

Response solve(const Problem& problem, const Solver& solver, const SolveOptions& options) {
  validate(problem);
  engine::validate(solver);
  const auto began = std::chrono::steady_clock::now();
  const bool exact = std::holds_alternative<ExactSolver>(solver);
  const engine::ModalSystem system(problem);
  const engine::TimeGrid grid(problem, exact);
  const auto report = [&options](double fraction) { return !options.progress || options.progress(fraction); };

  Response response;
  response.buildings.resize(problem.buildings.size());
  response.points.resize(problem.points.size());

  engine::FlightTable flights = exact ? engine::make_flights(system, grid) : engine::FlightTable(grid.kinds());
  const engine::Walk::Ground ground{system, problem, solver, grid, flights};
  engine::FreeWalk free(ground);
  Status status = free.run([&](double fraction) { return report(0.25 * fraction); });
  for (std::size_t b = 0; b < response.buildings.size(); ++b) free.watch().report(b, response.buildings[b]);
  for (std::size_t i = 0; i < response.points.size(); ++i) response.points[i].minimum_gap_no_contact = free.needed()[i];
  if (status != Status::done) {
    engine::report_end(response, status, free);
    return response;
  }

  engine::PoundingWalk pounding(ground, engine::tolerances(problem, response.buildings, free), options);
  status = pounding.run([&](double fraction) { return report(0.25 + 0.75 * fraction); });
  engine::report_end(response, status, pounding);
  pounding.contacts().finish(problem.duration);
  for (std::size_t b = 0; b < response.buildings.size(); ++b) pounding.watch().report(b, response.buildings[b]);
  response.impacts = std::move(pounding.contacts().impacts());
  response.events = pounding.contacts().events();
  response.steps = pounding.steps();
  engine::summarise(response.impacts, response.points);
  pounding.sampler().finish();
  response.histories = std::move(pounding.sampler().histories());
  if (pounding.energy()) response.energy = pounding.energy()->finish();
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace bentur
