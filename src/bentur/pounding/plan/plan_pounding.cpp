#include "bentur/pounding/plan/plan_pounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/pounding/checks/self_checks.h"
#include "bentur/pounding/internal/free_response_of.h"
#include "bentur/pounding/internal/levels.h"
#include "bentur/pounding/internal/summaries.h"
#include "bentur/pounding/plan/masses_elsewhere.h"
#include "bentur/pounding/plan/plan_meetings.h"
#include "bentur/structure/frame/infill.h"
#include "bentur/structure/plan/plan_body.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What yielding did in the storeys of a plane, whose elements begin at `member`, which is moved on past them.
BuildingPeaks::Yielding yielding_of(const PlanModel& model, const PlanModel::Plane& plane, const VectorXd& drift_ratio,
                                    const std::vector<ElementFound>& members, std::size_t& member) {
  BuildingPeaks::Yielding yielding;
  const Index storeys = model.floors();
  yielding.ductility.setConstant(storeys, not_known);
  yielding.residual_drift_ratio.setZero(storeys);
  yielding.hysteretic_energy.setZero(storeys);
  const std::size_t first = member;
  for (Index j = 0; j < storeys; ++j) {
    if (!plane.laws[j]) continue;
    const double height = model.storey_heights[j];
    yielding.ductility(j) = ductility(*plane.laws[j], drift_ratio(j) * height, members[member]);
    yielding.residual_drift_ratio(j) = members[member].residual / height;
    yielding.hysteretic_energy(j) = members[member].energy_lost;
    if (members[member].loss) take_loss(*members[member].loss, storeys, j, yielding);
    ++member;
  }
  return member == first ? BuildingPeaks::Yielding{} : yielding;
}

/// What bearings did, whose elements begin at `member`; x and y of one after the other in `moved` and `forces`. The
/// states of those that yield within a polygon begin at `state`, which is moved on past them.
PlanPeaks::Bearings bearings_of(const PlanModel& model, const VectorXd& moved, const VectorXd& forces,
                                const std::vector<ElementFound>& members, std::size_t member,
                                const std::vector<CoupledState>& states, std::size_t& state) {
  const Index count = std::ssize(model.bearings);
  const auto x = Eigen::seqN(0, count, 2), y = Eigen::seqN(1, count, 2);
  PlanPeaks::Bearings found{.x = moved(x), .y = moved(y), .force_x = forces(x), .force_y = forces(y)};
  found.residual_x = found.residual_y = found.hysteretic_energy = VectorXd::Zero(count);
  for (Index n = 0; n < count; ++n) {
    if (const auto& polygon = model.bearings[n].polygon) {
      const Yielded yielded = yielded_of(*polygon, states[state++]);
      found.residual_x(n) = yielded.residual.x();
      found.residual_y(n) = yielded.residual.y();
      found.hysteretic_energy(n) = yielded.energy;
    } else if (model.bearings[n].law) {
      const ElementFound &along_x = members[member], &along_y = members[member + 1];
      member += 2;
      found.residual_x(n) = along_x.residual;
      found.residual_y(n) = along_y.residual;
      found.hysteretic_energy(n) = along_x.energy_lost + along_y.energy_lost;
    }
  }
  return found;
}

/// What the hinges of the frames of a building did, whose states begin at `state`, which is moved on past them.
/// @param rotations empty where no hinge can fail
void take_frames(const PlanBuilding& building, const VectorXd& moments, const VectorXd& rotations,
                 const VectorXd& shears, const std::vector<CoupledState>& states, std::size_t& state,
                 PlanPeaks& peaks) {
  const PlanModel& model = building.model;
  Index hinge = 0, column = 0;
  auto element = building.coupled.begin();
  for (std::size_t p = 0; p < model.planes.size(); ++p) {
    const Hinges& hinges = model.planes[p].hinges;
    if (hinges.size() == 0) continue;
    BuildingPeaks& frame = peaks.planes[p].frame;
    const Index turning = std::ssize(hinges.places), breaking = std::ssize(hinges.columns);
    take_hinge_peaks(hinges, moments.segment(hinge, turning),
                     rotations.size() > 0 ? VectorXd(rotations.segment(hinge, turning)) : VectorXd(),
                     shears.segment(column, breaking), frame);
    take_hinges(hinges, model.storey_heights, *(element++)->law, states[state++], frame);
    peaks.planes[p].yielding.residual_drift_ratio = std::move(frame.yielding.residual_drift_ratio);
    frame.yielding = {};
    hinge += turning;
    column += breaking;
  }
}

/// What the infill of a plane did, whose elements begin at `member`, its panels and the columns beside them at `panel`
/// and `push` of the outputs: all are moved on past them.
BuildingPeaks::Infill infill_of(const PlanModel& model, const PlanModel::Plane& plane, const VectorXd& drift_ratio,
                                const VectorXd& across, const VectorXd& pushes,
                                const std::vector<ElementFound>& members, std::size_t& member, Index& panel,
                                Index& push) {
  const InfilledFrame frame{plane.infills, plane.hinges, model.first_storey(), model.storey_heights};
  std::vector<const ElementFound*> found;
  for (const InfillPanel& one : plane.infills) {
    found.push_back(std::isfinite(one.backbone.yield) ? &members[member++] : nullptr);
  }
  const Index panels = std::ssize(plane.infills), beside = std::ssize(struts_on_columns(plane.infills, plane.hinges));
  auto infill = infill_of(frame, found, across.segment(panel, panels), pushes.segment(push, beside), drift_ratio);
  panel += panels;
  push += beside;
  return infill;
}

PlanPeaks peaks_of(const PlanBuilding& building, const std::vector<OutputsFound>& outputs,
                   const std::vector<ElementFound>& members, const std::vector<CoupledState>& states,
                   std::size_t& state) {
  const Index n = building.model.floors();
  const auto peak = [&](PlanOutput kind) -> const VectorXd& { return outputs[static_cast<std::size_t>(kind)].peak; };
  const auto part = [&](PlanOutput kind, Index i) -> VectorXd { return peak(kind).segment(i * n, n); };
  PlanPeaks peaks;
  peaks.x = part(PlanOutput::movement, 0);
  peaks.y = part(PlanOutput::movement, 1);
  peaks.south = part(PlanOutput::movement, 2);
  peaks.north = part(PlanOutput::movement, 3);
  peaks.west = part(PlanOutput::movement, 4);
  peaks.east = part(PlanOutput::movement, 5);
  peaks.rotation = peak(PlanOutput::rotation);
  peaks.acceleration_x = part(PlanOutput::acceleration, 0);
  peaks.acceleration_y = part(PlanOutput::acceleration, 1);
  peaks.angular_acceleration = peak(PlanOutput::angular_acceleration);
  if (building.is_rigid()) return peaks;
  const Eigen::Map<const Eigen::Matrix3Xd> forces(peak(PlanOutput::storey_force).data(), 3, n);
  peaks.shear_x = forces.row(0);
  peaks.shear_y = forces.row(1);
  peaks.torque = forces.row(2);
  peaks.foundation = peak(PlanOutput::foundation);
  peaks.column_forces = peak(PlanOutput::column_force);
  std::size_t member = 0;
  Index panel = 0, push = 0;
  for (Index p = 0; p < std::ssize(building.model.planes); ++p) {
    PlanPeaks::Plane& plane = peaks.planes.emplace_back();
    plane.drift_ratio = part(PlanOutput::plane_drift, p);
    plane.shear = part(PlanOutput::plane_shear, p);
    plane.yielding = yielding_of(building.model, building.model.planes[p], plane.drift_ratio, members, member);
    plane.frame.infill =
        infill_of(building.model, building.model.planes[p], plane.drift_ratio, peak(PlanOutput::infill_force),
                  peak(PlanOutput::infill_push), members, member, panel, push);
    if (building.model.slab) {  // no plane is below it
      plane.drift_ratio(*building.model.slab) = plane.shear(*building.model.slab) = not_known;
      if (plane.yielding.residual_drift_ratio.size() > 0) {
        plane.yielding.residual_drift_ratio(*building.model.slab) = not_known;
      }
    }
  }
  take_frames(building, peak(PlanOutput::hinge_moment), peak(PlanOutput::hinge_rotation),
              peak(PlanOutput::breaking_shear), states, state, peaks);
  peaks.bearings = bearings_of(building.model, peak(PlanOutput::bearing_movement), peak(PlanOutput::bearing_force),
                               members, member, states, state);
  if (building.model.planes.empty()) {
    peaks.drift_south = part(PlanOutput::edge_drift, 0);
    peaks.drift_north = part(PlanOutput::edge_drift, 1);
    peaks.drift_west = part(PlanOutput::edge_drift, 2);
    peaks.drift_east = part(PlanOutput::edge_drift, 3);
    for (VectorXd* list : {&peaks.drift_south, &peaks.drift_north, &peaks.drift_west, &peaks.drift_east}) {
      list->head(building.model.first_storey()).setConstant(not_known);
    }
  }
  return peaks;
}

std::vector<PlanPeaks> peaks_of(const PlanProblem& problem, const Solution& solution) {
  std::vector<PlanPeaks> peaks;
  std::size_t state = 0;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    peaks.push_back(peaks_of(problem.buildings[b], solution.outputs[b], solution.members[b], solution.coupled, state));
  }
  return peaks;
}

/// What the columns carry that are struck.
void summarise_columns(const PlanProblem& problem, const std::vector<PlanPeaks>& with,
                       const std::vector<PlanPeaks>& without, std::vector<PointSummary>& points) {
  std::size_t i = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) {
      PointSummary& point = points[i++];
      const auto struck = struck_column(problem, gap, contact);
      if (!struck) continue;
      point.column = column_peaks(with[struck->building].column_forces.segment<6>(6 * struck->node),
                                  without[struck->building].column_forces.segment<6>(6 * struck->node));
    }
  }
}

bool is_place(Index place) { return place >= 0; }

/// Impacts of a system's points as those of the problem's, by start, then point, then end.
std::vector<Impact> in_places(std::vector<Impact> impacts, const std::vector<Index>& places) {
  for (Impact& impact : impacts) impact.point = places[impact.point];
  std::sort(impacts.begin(), impacts.end(), [](const Impact& a, const Impact& b) {
    return std::tie(a.start, a.point, a.end) < std::tie(b.start, b.point, b.end);
  });
  return impacts;
}

void summarise_friction(const std::vector<Impact>& impacts, std::vector<PlanFriction>& points) {
  for (const Impact& impact : impacts) {
    PlanFriction& point = points[impact.point];
    point.peak_tangential_force = std::max(point.peak_tangential_force, impact.peak_tangential_force);
    point.tangential_impulse += impact.tangential_impulse;
    point.sliding += impact.sliding;
    point.friction_loss += impact.friction_loss;
  }
}

MatrixXd stacked(const MatrixXd& upper, const MatrixXd& lower) {
  MatrixXd both(upper.rows() + lower.rows(), upper.cols());
  both << upper, lower;
  return both;
}

/// Rows of some of a system's points, of which those that rub are the last, as those of the problem's; zero of others.
/// Of a block they are most of what a run keeps: handed over, they are there once.
MatrixXd in_places(MatrixXd&& given, const std::vector<Index>& places) {
  const MatrixXd rows = std::move(given);
  const Index count = std::ssize(places), first = count - rows.rows();  // those that rub are the last
  MatrixXd all = MatrixXd::Zero(count - std::count(places.begin(), places.end(), -1), rows.cols());
  for (Index i = 0; i < rows.rows(); ++i) {
    if (places[first + i] >= 0) all.row(places[first + i]) = rows.row(i);
  }
  return all;
}

/// @param places of the system's points, places_of()
PlanHistories histories_of(const PlanProblem& problem, Solution& solution, const std::vector<Index>& places) {
  PlanHistories histories{.time = std::move(solution.samples.time),
                          .ground_acceleration = std::move(solution.samples.ground_acceleration)};
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Index n = problem.buildings[b].model.floors();
    const auto history = [&](PlanOutput kind) -> const MatrixXd& {
      return solution.outputs[b][static_cast<std::size_t>(kind)].history;
    };
    histories.x.emplace_back(history(PlanOutput::movement).topRows(n));
    histories.y.emplace_back(history(PlanOutput::movement).middleRows(n, n));
    histories.rotation.push_back(history(PlanOutput::rotation));
    histories.acceleration_x.emplace_back(history(PlanOutput::acceleration).topRows(n));
    histories.acceleration_y.emplace_back(history(PlanOutput::acceleration).bottomRows(n));
    MatrixXd& bearing = histories.bearing.emplace_back();
    if (problem.buildings[b].model.slab) {
      bearing = stacked(history(PlanOutput::bearing_movement), history(PlanOutput::bearing_force));
    }
    MatrixXd& foundation = histories.foundation.emplace_back();
    if (problem.buildings[b].model.soil) {
      foundation = stacked(history(PlanOutput::foundation), history(PlanOutput::foundation_force));
    }
    const bool moves = !problem.buildings[b].is_rigid();
    const MatrixXd none(0, std::ssize(histories.time));
    histories.hinge_moment.push_back(moves ? history(PlanOutput::hinge_moment) : none);
    histories.hinge_rotation.push_back(moves ? history(PlanOutput::hinge_rotation) : none);
    const PlanModel& model = problem.buildings[b].model;
    MatrixXd force = none, shortening = none;
    Index panel = 0, plane = 0;
    for (const PlanModel::Plane& one : model.planes) {
      const Index panels = std::ssize(one.infills);
      if (moves && panels > 0) {
        auto [of_plane, shortened] =
            infill_histories({one.infills, one.hinges, model.first_storey(), model.storey_heights},
                             history(PlanOutput::infill_force).middleRows(panel, panels),
                             history(PlanOutput::plane_drift).middleRows(plane * n, n));
        force = stacked(force, of_plane);
        shortening = stacked(shortening, shortened);
      }
      panel += panels;
      ++plane;
    }
    histories.infill_force.push_back(std::move(force));
    histories.infill_shortening.push_back(std::move(shortening));
  }
  histories.opening = in_places(std::move(solution.samples.opening), places);
  histories.force = in_places(std::move(solution.samples.force), places);
  histories.slip = in_places(std::move(solution.samples.slip), places);
  histories.force_along = in_places(std::move(solution.samples.force_along), places);
  return histories;
}

/// The exact course. @param places as of histories_of()
PlanHistories course_of(const PlanProblem& problem, Solution& solution, const std::vector<Index>& places) {
  PlanHistories course{.time = std::move(solution.course.time)};
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Index n = problem.buildings[b].model.floors();
    const auto of = [&](PlanOutput kind) -> const MatrixXd& {
      return solution.outputs[b][static_cast<std::size_t>(kind)].course;
    };
    course.x.emplace_back(of(PlanOutput::movement).topRows(n));
    course.y.emplace_back(of(PlanOutput::movement).middleRows(n, n));
    course.rotation.push_back(of(PlanOutput::rotation));
  }
  course.opening = in_places(std::move(solution.course.opening), places);
  course.force = in_places(std::move(solution.course.force), places);
  return course;
}

std::vector<double> watched_widths(const PlanProblem& problem) {
  std::vector<double> widths;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanWatched& watched : gap.watched) widths.push_back(gap.width_at(watched));
  }
  return widths;
}

}  // namespace

// What free_response_of.h asks of buildings in plan, as summaries.h has it of rows: by argument alone it finds nothing
// in an unnamed namespace.

std::span<GroundMotion> motions_in(PlanProblem& problem) { return problem.motions; }

std::size_t gap_count(const PlanProblem& problem) { return problem.gaps.size(); }

bool keeps_course(const PlanProblem& problem) { return problem.buildings.size() <= PlanResponse::most_followed; }

std::vector<double> gap_widths(const PlanProblem& problem) {
  std::vector<double> widths;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) {
      widths.push_back(gap.is_of_pair(contact) ? gap.width_at(contact) : std::numeric_limits<double>::infinity());
    }
  }
  return widths;
}

PlanResponse free_response(const PlanProblem& problem, const Solution& free) {
  PlanResponse response;
  take_end(free, response);
  response.collapse = response.collapse_no_contact = collapse_of(problem, free);
  response.buildings = response.buildings_no_contact = peaks_of(problem, free);
  const std::vector<Index> places = places_of(problem);
  const auto points = static_cast<std::size_t>(std::count_if(places.begin(), places.end(), is_place));
  response.points.resize(points);
  response.friction.resize(points);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_place(places[i])) response.points[places[i]].gap_needed = free.needed[i];
  }
  for (const Reach& reach : free.watched) response.watched.push_back({.gap_needed = reach.reach});
  summarise_columns(problem, response.buildings, response.buildings_no_contact, response.points);
  for (Index i = 0; i < 2; ++i) {
    response.peak_ground_acceleration(i) =
        peak_acceleration(problem.motions, {problem.axes(i, 0), problem.axes(i, 1)}).value_or(not_known);
  }
  return response;
}

void take_levels(const PlanProblem& problem, const Solution& free, bool reversed, PlanResponse& response) {
  const auto no_floor = [](std::size_t, int) -> std::optional<double> { return std::nullopt; };
  const std::vector<Index> places = places_of(problem);
  std::vector<PointSummary> in_system(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_place(places[i])) in_system[i] = response.points[places[i]];
  }
  report_levels(free.watched_free, reversed, no_floor, in_system, response.watched);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_place(places[i])) response.points[places[i]] = in_system[i];
  }
}

std::vector<LargestDrift> drifts_no_contact(const PlanResponse& response) {
  std::vector<LargestDrift> drifts;
  for (const PlanPeaks& one : response.buildings_no_contact) drifts.push_back(one.largest_drift());
  for (std::size_t b = 0; b < std::min(drifts.size(), response.drifts_elsewhere.size()); ++b) {
    const LargestDrift& other = response.drifts_elsewhere[b];
    if (other.ratio > drifts[b].ratio) drifts[b] = other;
  }
  return drifts;
}

void take_solution(const PlanProblem& problem, Solution&& solution, PlanResponse& response) {
  const std::vector<Index> places = places_of(problem);
  take_end(solution, response);
  response.collapse = collapse_of(problem, solution);
  response.events = solution.events;
  response.buildings = peaks_of(problem, solution);
  summarise(solution, watched_widths(problem), response.watched);
  if (!solution.samples.time.empty()) response.histories = histories_of(problem, solution, places);
  if (!solution.course.time.empty()) response.course = course_of(problem, solution, places);
  response.impacts = in_places(std::move(solution.impacts), places);
  summarise(response.impacts, response.points);
  summarise_friction(response.impacts, response.friction);
  summarise_columns(problem, response.buildings, response.buildings_no_contact, response.points);
  response.energy = std::move(solution.energy);
}

LargestDrift PlanPeaks::largest_drift() const {
  LargestDrift largest = bentur::largest_drift(edge_drift_ratio());
  for (const Plane& plane : planes) {
    if (const LargestDrift of = bentur::largest_drift(plane.drift_ratio); of.ratio > largest.ratio) largest = of;
  }
  return largest;
}

template class FreeResponseOf<PlanProblem, PlanResponse>;

PlanResponse solve(const PlanProblem& problem, const Solver& solver, const SolveOptions& options) {
  return any_problem::solution_of<PlanResponse>(problem, solver, options);
}

Effort effort(const PlanProblem& problem, const Solver& solver, const SolveOptions& options) {
  validate(problem);
  return effort(system_of(problem, options.levels || options.both_ways), solver, run_options(options));
}

}  // namespace bentur
