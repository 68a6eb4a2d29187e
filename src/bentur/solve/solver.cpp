#include "bentur/solve/solver.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/hinges.h"
#include "bentur/solve/checks/self_checks.h"
#include "bentur/solve/engine/run/free_run.h"
#include "bentur/solve/engine/run/pounding_run.h"
#include "bentur/solve/engine/run/watch/levels.h"
#include "bentur/solve/engine/same_but_gaps.h"

namespace bentur {
namespace engine {
namespace {

constexpr double round_off_watched = 0x1p-40;  // of the displacements that an opening is the difference of

void validate(const Solver& solver) {
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver)) {
    if (!(adaptive->tolerance >= 1e-13 && adaptive->tolerance <= 1e-2)) {
      throw InvalidParameter("tolerance", fmt::format("{}", adaptive->tolerance), "must be in [1e-13, 1e-2]");
    }
  }
  if (const auto* fixed = std::get_if<RungeKuttaSolver>(&solver)) require_positive("step", fixed->step);
}

/// How large the displacements are whose difference a point's opening is: of both floors in the free response (of a
/// node in a column, of the largest floor's) and of the ground.
std::vector<double> largest_displacements(const Problem& problem, const std::vector<BuildingPeaks>& peaks,
                                          const Run& run) {
  const auto largest = [&](Eigen::Index b, Eigen::Index floor) {
    const Eigen::VectorXd& displacement = peaks[b].displacement_no_contact;
    return floor < displacement.size() ? displacement(floor) : displacement.maxCoeff();
  };
  std::vector<double> result;
  for (const ContactPoint& point : problem.points) {
    const Eigen::Index left = point.left;
    result.push_back(largest(left, point.left_floor) + largest(left + 1, point.right_floor) +
                     run.largest_ground_displacement(left) + run.largest_ground_displacement(left + 1));
  }
  return result;
}

/// Likewise of watched floors: of all floors of both neighbours.
std::vector<double> largest_displacements_watched(const Problem& problem, const std::vector<BuildingPeaks>& peaks,
                                                  const Run& run) {
  std::vector<double> result;
  for (const WatchedFloor& floor : problem.watched) {
    const Eigen::Index left = floor.left;
    result.push_back(peaks[left].displacement_no_contact.maxCoeff() +
                     peaks[left + 1].displacement_no_contact.maxCoeff() + run.largest_ground_displacement(left) +
                     run.largest_ground_displacement(left + 1));
  }
  return result;
}

/// What yielding did, as the run left it.
void summarise_yielding(const Problem& problem, Run& run, const ModalSystem& system,
                        BuildingPeaks::Yielding BuildingPeaks::*to, std::vector<BuildingPeaks>& buildings) {
  Eigen::Index element = system.storeys;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (!building.storeys_yield()) continue;
    const Eigen::Index floors = building.model.floors();
    BuildingPeaks::Yielding& yielding = buildings[b].*to;
    yielding.ductility.setConstant(floors, std::numeric_limits<double>::quiet_NaN());
    yielding.residual_drift_ratio.setZero(floors);
    if (building.model.has_slab) yielding.residual_drift_ratio(0) = std::numeric_limits<double>::quiet_NaN();
    yielding.hysteretic_energy.setZero(floors);
    for (const BuildingElement& yielded : building.elements) {
      const Eigen::Index f = yielded.storey;
      const double of_storey = building.model.storey_heights[f];
      const double height = of_storey > 0.0 ? of_storey : 1.0;  // a slab's drift is told as a length
      yielding.ductility(f) = buildings[b].drift_ratio(f) * height / yielded.law->yield_deformation();
      const double residual = run.elements().residual(element, run.state()) / height;
      yielding.residual_drift_ratio(f) = of_storey > 0.0 ? residual : std::numeric_limits<double>::quiet_NaN();
      yielding.hysteretic_energy(f) = run.elements().energy_lost(element, run.state());
      ++element;
    }
  }
}

/// Of one building.
void summarise_hinges(const Building& building, const HingeLaw& law, const CoupledState& state, BuildingPeaks& peaks) {
  constexpr double still = 1e-6;  // of the largest drift of a mechanism: a storey that has no part in it
  const Hinges& hinges = building.model.hinges;
  Eigen::VectorXd theta(law.size());
  for (Eigen::Index h = 0; h < law.size(); ++h) {
    const HingeLaw::Record record = law.record(state, h);
    BuildingPeaks::Hinge& hinge = peaks.hinges[h];
    theta(h) = record.rotation;
    hinge.peak_rotation = record.peak_rotation;
    hinge.residual_rotation = record.rotation;
    hinge.dissipated_energy = record.lost + hinges.at_rest(h) * record.rotation;
    hinge.first_yield = record.first_yield;
    hinge.half_cycles = record.half_cycles;
  }
  const Eigen::VectorXd left = hinges.frame_stiffness.llt().solve(hinges.frame_rows.transpose() * theta);
  const Eigen::Index storeys = hinges.frame_drifts.rows();
  const Eigen::Index first = building.model.floors() - storeys;  // above a slab
  Eigen::VectorXd& residual = peaks.yielding.residual_drift_ratio;
  residual.setConstant(building.model.floors(), std::numeric_limits<double>::quiet_NaN());
  residual.tail(storeys) = hinges.frame_drifts * left;
  for (Eigen::Index j = first; j < residual.size(); ++j) residual(j) /= building.model.storey_heights[j];
  peaks.mechanism.reset();
  const std::optional<HingeLaw::Mechanism> mechanism = law.mechanism(state);
  if (!mechanism) return;
  const auto shape = free_shape(hinges.frame_stiffness, hinges.frame_rows, hinges.stiffness, mechanism->hinges);
  const Eigen::VectorXd drifts = (hinges.frame_drifts * *shape).cwiseAbs();
  peaks.mechanism = BuildingPeaks::Mechanism{.time = mechanism->time, .storeys = {}};
  for (Eigen::Index j = 0; j < storeys; ++j) {
    if (drifts(j) > still * drifts.maxCoeff()) peaks.mechanism->storeys.push_back(first + j);
  }
}

/// What hinges did, as the run left it; the watch has told of their moments.
void summarise_hinges(const Problem& problem, Run& run, std::vector<BuildingPeaks>& buildings) {
  const std::vector<CoupledState> states = run.elements().coupled(run.state());
  std::size_t element = 0;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    for (const CoupledElement& coupled : building.coupled) {
      const CoupledState& state = states[element++];
      const auto* law = dynamic_cast<const HingeLaw*>(coupled.law.get());
      if (law != nullptr) summarise_hinges(building, *law, state, buildings[b]);
    }
  }
}

/// Slabs have no storey, and nothing holds or strains what moves with the ground.
void leave_out_what_is_not_there(const Problem& problem, std::vector<BuildingPeaks>& buildings) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (building.model.has_slab) buildings[b].drift_ratio(0) = nothing;
    if (!building.is_rigid()) continue;
    buildings[b].drift_ratio.setConstant(nothing);
    buildings[b].storey_shear.setConstant(nothing);
  }
}

/// What the columns bear that are struck, of what their buildings' pieces did.
void summarise_columns(const Problem& problem, const std::vector<BuildingPeaks>& buildings,
                       std::vector<PointSummary>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<StruckColumn> struck = struck_column(problem, problem.points[i]);
    if (!struck) continue;
    const BuildingPeaks& peaks = buildings[struck->building];
    const Eigen::Vector<double, 6> with = peaks.column_forces.segment<6>(6 * struck->node);
    const Eigen::Vector<double, 6> without = peaks.column_forces_no_contact.segment<6>(6 * struck->node);
    points[i].column = ColumnPeaks{.shear = with.head<2>().maxCoeff(),
                                   .moment = with.tail<4>().maxCoeff(),
                                   .shear_no_contact = without.head<2>().maxCoeff(),
                                   .moment_no_contact = without.tail<4>().maxCoeff(),
                                   .shear_below = with(0),
                                   .shear_above = with(1),
                                   .moment_bottom = with(2),
                                   .moment_node = std::max(with(3), with(4)),
                                   .moment_top = with(5)};
  }
}

void summarise_links(Run& run, const ModalSystem& system, std::vector<LinkSummary>& links) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Eigen::Index element = system.switched + static_cast<Eigen::Index>(i);
    const Elements::Account& account = run.elements().account(element);
    links[i] = {account.peak_force, account.peak_tension, run.links().nearest()[i].reach,
                run.links().nearest()[links.size() + i].reach, run.elements().energy_lost(element, run.state())};
  }
}

/// The least openings of watched floors; `scales` as largest_displacements_watched() gives.
void summarise_watched(const Problem& problem, const std::vector<SpanWatch::Nearest>& nearest,
                       const std::vector<double>& scales, std::vector<WatchedSummary>& watched) {
  for (std::size_t i = 0; i < watched.size(); ++i) {
    const double width = problem.watched[i].width;
    watched[i].least_opening = width - nearest[i].reach;
    watched[i].least_time = nearest[i].time;
    watched[i].closes = watched[i].least_opening < -round_off_watched * (width + scales[i]);
  }
}

void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points) {
  for (const Impact& impact : impacts) {
    PointSummary& point = points[impact.point];
    ++point.impacts;
    if (impact.slow_start) ++point.slow_starts;
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

/// How far from zero openings were where they are zero, as a part of the displacements there [-].
double worst_opening(const Problem& problem, const Elements& elements, const std::vector<double>& scales,
                     const std::vector<BuildingPeaks>& peaks) {
  double worst = 0.0;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Eigen::Index left = problem.points[i].left;
    const double moved = peaks[left].displacement.maxCoeff() + peaks[left + 1].displacement.maxCoeff();
    const double opening = elements.worst_opening(static_cast<Eigen::Index>(i));
    if (opening > 0.0) worst = std::max(worst, opening / (scales[i] + moved));
  }
  return worst;
}

Problem without_widths(Problem problem) {
  for (ContactPoint& point : problem.points) point.width = 0.0;
  for (WatchedFloor& floor : problem.watched) floor.width = 0.0;
  return problem;
}

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

/// Status and message of a run that did not get to its end.
void report_end(Response& response, Status status, const Run& run) {
  response.status = status;
  if (status == Status::stopped) response.message = "stopped on request";
  if (status == Status::failed) response.message = run.trouble();
}

}  // namespace
}  // namespace engine

std::vector<std::vector<Eigen::Index>> hinge_order(const BuildingPeaks& peaks, double duration) {
  constexpr double at_once = 1e-9;  // of the duration
  std::vector<std::pair<double, Eigen::Index>> yields;
  for (Eigen::Index h = 0; h < std::ssize(peaks.hinges); ++h) {
    if (peaks.hinges[h].first_yield) yields.emplace_back(*peaks.hinges[h].first_yield, h);
  }
  std::sort(yields.begin(), yields.end());
  std::vector<std::vector<Eigen::Index>> groups;
  double latest = 0;
  for (const auto& [time, hinge] : yields) {
    if (groups.empty() || time - latest > at_once * duration) {
      groups.emplace_back();
      latest = time;
    }
    groups.back().push_back(hinge);
  }
  for (std::vector<Eigen::Index>& group : groups) std::sort(group.begin(), group.end());
  return groups;
}

std::string_view name(const Solver& solver) {
  if (std::holds_alternative<AdaptiveSolver>(solver)) return "adaptive";
  if (std::holds_alternative<RungeKuttaSolver>(solver)) return "runge-kutta";
  return "exact";
}

namespace engine {

/// The grid, whose plan is large where it has many segments. @throws InvalidParameter when there are too many.
const TimeGrid& affordable(const TimeGrid& grid, double duration, long most_steps) {
  double period = 0.0;
  for (std::size_t kind = 0; kind < grid.kinds(); ++kind) period += grid.length(kind);
  const double segments = duration / period * static_cast<double>(grid.kinds());
  if (most_steps > 0 && segments > static_cast<double>(most_steps)) {
    throw InvalidParameter("most_steps", fmt::format("{}", most_steps),
                           fmt::format("must be {:.3g} at least", segments));
  }
  return grid;
}

/// In the order in which each part is made of those before. Gaps have no width here: what is found serves all widths.
struct FreeParts {
  FreeParts(Problem p, const Solver& s, long most)
      : problem(without_widths(std::move(p))), solver(s), most_steps(most) {}
  FreeParts(const FreeParts&) = delete;  // its members point to one another
  FreeParts& operator=(const FreeParts&) = delete;

  Problem problem;
  Solver solver;
  long most_steps;
  bool exact = std::holds_alternative<ExactSolver>(solver);
  ModalSystem system{problem};
  TimeGrid grid{problem, exact};
  FlightPlan plan{system, affordable(grid, problem.duration, most_steps), problem.duration, exact};
  FreeResult result;
  Response response;  ///< as far as it goes without contact
  // Scales per point: of floors and ground together.
  std::vector<double> largest_displacement;  ///< [length]
  std::vector<double> largest_speed;         ///< [length/s]; where nothing moves there, that of the whole row
  std::vector<SpanWatch::Nearest> nearest;   ///< per watched floor
  std::vector<double> watched_scale;         ///< scale of round-off of each [length]
};

}  // namespace engine

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

FreeResponse::FreeResponse(Problem problem, const Solver& solver, const std::function<bool(double)>& progress,
                           long most_steps, bool levels) {
  validate(problem);
  engine::validate(solver);
  const auto parts = std::make_shared<engine::FreeParts>(std::move(problem), solver, most_steps);
  engine::FreeRun run(
      {parts->system, parts->problem, parts->solver, parts->grid, parts->plan, most_steps},
      levels ? engine::level_relations(parts->problem, parts->system) : std::vector<engine::ModalSystem::Relation>{});
  const Status status = run.to_end(progress);
  Response& response = parts->response;
  engine::report_end(response, status, run);
  response.buildings.resize(parts->problem.buildings.size());
  response.points.resize(parts->problem.points.size());
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    run.watch().report(b, response.buildings[b]);
    response.buildings[b].displacement_no_contact = response.buildings[b].displacement;
    response.buildings[b].column_forces_no_contact = response.buildings[b].column_forces;
  }
  engine::summarise_columns(parts->problem, response.buildings, response.points);
  for (std::size_t i = 0; i < response.points.size(); ++i) {
    response.points[i].gap_needed = run.idle().nearest()[i].reach;
  }
  response.steps = run.steps();
  for (const engine::SpanWatch::Nearest& nearest : run.floors().nearest()) {
    response.watched.push_back({.gap_needed = nearest.reach});
  }
  if (levels) {
    const bool mirrored = status == Status::done && is_mirrored(parts->problem);
    engine::report_levels(parts->problem, run.others().nearest(), mirrored, response);
  }
  engine::summarise_yielding(parts->problem, run, parts->system, &BuildingPeaks::yielding, response.buildings);
  engine::summarise_hinges(parts->problem, run, response.buildings);
  engine::leave_out_what_is_not_there(parts->problem, response.buildings);
  for (BuildingPeaks& peaks : response.buildings) {
    peaks.yielding_no_contact = peaks.yielding;
    peaks.acceleration_no_contact = peaks.acceleration;
    peaks.storey_shear_no_contact = peaks.storey_shear;
  }
  response.collapse = response.collapse_no_contact = run.collapse();
  response.coupled = run.elements().coupled(run.state());
  response.links.resize(parts->problem.links.size());
  engine::summarise_links(run, parts->system, response.links);
  parts->nearest = run.floors().nearest();
  parts->watched_scale = engine::largest_displacements_watched(parts->problem, response.buildings, run);
  parts->result = run.take_result();
  parts->largest_displacement = engine::largest_displacements(parts->problem, response.buildings, run);
  parts->largest_speed = parts->result.speeds;
  std::vector<double>& speeds = parts->largest_speed;
  const double fastest = speeds.empty() ? 0.0 : *std::max_element(speeds.begin(), speeds.end());
  std::replace(speeds.begin(), speeds.end(), 0.0, fastest);
  parts_ = parts;
}

const Response& FreeResponse::response() const { return parts_->response; }

Response FreeResponse::solve(const Problem& problem, const SolveOptions& options) const {
  validate(problem);
  require_same_but_gaps(parts_->problem, problem);
  const auto began = std::chrono::steady_clock::now();
  Response response = parts_->response;
  if (response.status != Status::done && response.status != Status::collapsed) return response;
  engine::Elements::Scales scales{parts_->largest_displacement, parts_->largest_speed};
  for (std::size_t i = 0; i < problem.points.size(); ++i) scales.displacement[i] += problem.points[i].width;
  // Of approximate solvers the state alone is not all there is to go on with.
  const long first_contact = parts_->exact ? engine::first_contact(parts_->result, gap_widths(problem)) : 0;
  const bool records = options.output_step > 0.0 || options.course || options.energy_audit;
  if (first_contact == std::numeric_limits<long>::max() && !records) {
    engine::summarise_watched(problem, parts_->nearest, parts_->watched_scale, response.watched);
    check_itself(problem, parts_->solver, {}, response);
    response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return response;
  }
  engine::PoundingRun run({parts_->system, problem, parts_->solver, parts_->grid, parts_->plan, options.most_steps},
                          scales, first_contact, options);
  if (options.course) {
    run.trace({parts_->system, problem, parts_->response.buildings, parts_->largest_displacement});
  }
  if (!records) {
    const auto& checkpoints = parts_->result.checkpoints;
    const auto later = std::find_if(checkpoints.begin(), checkpoints.end(),
                                    [&](const auto& checkpoint) { return checkpoint.segment > first_contact; });
    if (later != checkpoints.begin()) run.resume(*std::prev(later));
  }
  const Status status = run.to_end(options.progress);
  engine::report_end(response, status, run);
  response.collapse = run.collapse();
  run.elements().finish(run.collapse() ? run.collapse()->time : problem.duration);
  for (std::size_t b = 0; b < response.buildings.size(); ++b) run.watch().report(b, response.buildings[b]);
  response.coupled = run.elements().coupled(run.state());
  response.impacts = std::move(run.elements().impacts());
  response.events = run.elements().events();
  response.steps = run.steps();
  engine::summarise(response.impacts, response.points);
  engine::summarise_columns(problem, response.buildings, response.points);
  engine::summarise_watched(problem, run.floors().nearest(), parts_->watched_scale, response.watched);
  engine::summarise_yielding(problem, run, parts_->system, &BuildingPeaks::yielding, response.buildings);
  engine::summarise_hinges(problem, run, response.buildings);
  engine::leave_out_what_is_not_there(problem, response.buildings);
  engine::summarise_links(run, parts_->system, response.links);
  run.sampler().finish();
  response.histories = std::move(run.sampler().histories());
  if (run.tracer()) response.course = run.tracer()->finish();
  if (run.energy()) response.energy = run.energy()->finish();
  check_itself(
      problem, parts_->solver,
      {run.momentum().worst(), engine::worst_opening(problem, run.elements(), scales.displacement, response.buildings),
       engine::force_imbalance(problem, parts_->system, run.state(), run.inputs(), run.elements())},
      response);
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
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
  const FreeResponse free(problem, solver, first, options.most_steps, levels);
  Response response = free.solve(problem, rest);
  engine::add_reversed(problem, solver, options, response);
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace bentur
