#include "bentur/model/plan/plan_dense_run.h"

#include <algorithm>
#include <optional>

#include "bentur/model/closer/dense_parts.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What members of the frame of a plane carry; nothing of springs, and where that is not known.
std::optional<MemberForces> forces_at(const Case& c, const PlanProblem& problem, const PlanFramePlace& place) {
  const Plan* const plan = std::get_if<Plan>(&c.buildings.at(place.building).structure);
  if (plan == nullptr || place.plane >= std::ssize(plan->planes) || !plan->planes[place.plane].frame) return {};
  PlaneFrame frame = as_plane(*plan->planes[place.plane].frame);
  if (!frame.nodes.empty()) return {};  // no history has how these sway
  frame.elastic_modulus *= plan->stiffness_factor.value_or(1);
  const Hinges& hinges = problem.buildings[place.building].model.planes.at(place.plane).hinges;
  if (!hinges.columns.empty() || !MemberForces::knows(frame, hinges.places)) return {};
  return MemberForces(frame, hinges.places);
}

/// All degrees of freedom of a building, dofs × samples.
MatrixXd dof_histories(const PlanHistories& histories, const PlanModel& model, Index building) {
  MatrixXd all = MatrixXd::Zero(model.dofs(), std::ssize(histories.time));  // of nodes nothing is kept
  for (Index f = 0; f < model.floors(); ++f) {
    all.row(3 * f) = histories.x[building].row(f);
    all.row(3 * f + 1) = histories.y[building].row(f);
    all.row(3 * f + 2) = histories.rotation[building].row(f);
  }
  if (const Index count = model.foundation_dofs()) {
    all.bottomRows(count) = histories.foundation[building].topRows(count);
  }
  return all;
}

/// How the floors of a frame sway along its line against its own base, and how its hinges turn.
struct FrameMoves {
  MatrixXd sways, turned;

  FrameMoves(const PlanHistories& histories, const PlanModel& model, const PlanFramePlace& place) {
    const PlanModel::Plane& plane = model.planes[place.plane];
    const Index storeys = model.floors() - model.first_storey();
    sways = plane.drifts.bottomRows(storeys) * dof_histories(histories, model, place.building);
    for (Index j = 1; j < storeys; ++j) sways.row(j) += sways.row(j - 1);
    turned.resize(0, sways.cols());
    if (const Index hinges = std::ssize(plane.hinges.places); hinges > 0) {
      turned = histories.hinge_rotation[place.building].middleRows(hinges_before(model, place.plane), hinges);
    }
  }

  /// The sample at which a storey drifts most for its height.
  [[nodiscard]] Index largest_drift(const std::vector<double>& heights) const {
    MatrixXd drifts = sways;
    for (Index j = drifts.rows() - 1; j > 0; --j) drifts.row(j) -= sways.row(j - 1);
    for (Index j = 0; j < drifts.rows(); ++j) drifts.row(j) /= heights[static_cast<std::size_t>(j)];
    Index storey = 0, column = 0;
    drifts.cwiseAbs().maxCoeff(&storey, &column);
    return column;
  }
};

/// The speed of a floor along a line, absolute but for what the ground had at the start.
VectorXd floor_speed(const PlanHistories& histories, const PlanProblem& problem, const FloorSpectra::Floor& floor) {
  const Index last = std::ssize(histories.time) - 1;
  const double step = histories.time[1] - histories.time[0];
  const VectorXd moved = (floor.along.x() * histories.x[floor.building].row(floor.floor) +
                          floor.along.y() * histories.y[floor.building].row(floor.floor))
                             .transpose();
  VectorXd speed(last + 1);
  for (Index i = 0; i <= last; ++i) {
    const Index before = std::max<Index>(i - 1, 0), after = std::min(i + 1, last);
    speed(i) = (moved(after) - moved(before)) / (static_cast<double>(after - before) * step);
  }
  const double delay = problem.delays.empty() ? 0 : problem.delays[static_cast<std::size_t>(floor.building)];
  for (std::size_t k = 0; k < problem.motions.size(); ++k) {
    const double part = problem.axes.col(static_cast<Index>(k)).dot(floor.along);
    if (part != 0) speed += part * ground_speed(problem.motions[k], histories.time, delay);
  }
  return speed;
}

/// Numbers of one sample.
double numbers_of(const PlanProblem& problem) {
  double numbers = 3 + 4 * static_cast<double>(contact_count(problem));
  for (const PlanBuilding& building : problem.buildings) {
    const PlanModel& model = building.model;
    numbers += 5 * static_cast<double>(model.dofs()) + 4 * static_cast<double>(model.bearings.size());
    for (const PlanModel::Plane& plane : model.planes) {
      numbers += 2 * static_cast<double>(model.floors() + std::ssize(plane.hinges.places));
    }
  }
  return numbers;
}

}  // namespace

std::vector<PlanFramePlace> frames_with_members(const Case& c, const PlanProblem& problem) {
  std::vector<PlanFramePlace> places;
  for (Index b = 0; b < std::min(std::ssize(problem.buildings), std::ssize(c.buildings)); ++b) {
    for (Index p = 0; p < std::ssize(problem.buildings[b].model.planes); ++p) {
      if (forces_at(c, problem, {b, p})) places.push_back({b, p});
    }
  }
  return places;
}

std::vector<FloorSpectra::Floor> spectrum_floors(const PlanProblem& problem, const PlanResponse& response) {
  constexpr std::size_t most = 6;
  std::vector<FloorSpectra::Floor> floors;
  const auto add = [&](Index building, Index floor, const PlanPoint& along) {
    if (problem.buildings[building].is_rigid()) return;
    const auto same = [&](const FloorSpectra::Floor& one) { return one.building == building && one.floor == floor; };
    if (std::any_of(floors.begin(), floors.end(), same)) return;
    floors.push_back({.building = building, .floor = floor, .along = along});
  };
  const auto roof = [&](Index building) { return problem.buildings[building].model.floors() - 1; };
  const Impact* const hardest = hardest_impact(response.impacts);
  if (hardest == nullptr) {
    const bool second = peak_acceleration(problem.motions[1]) > peak_acceleration(problem.motions[0]);
    const PlanPoint along = problem.axes.col(second ? 1 : 0);
    for (Index b = 0; b < std::ssize(problem.buildings) && floors.size() < most; ++b) add(b, roof(b), along);
    return floors;
  }
  const PlanContactPlace place = contact_at(problem, hardest->point);
  const PlanGap& gap = problem.gaps[place.gap];
  const PlanPoint across = gap.at(*place.contact).normal;
  for (const int side : {0, 1}) {
    const Index building = side == 0 ? gap.left : gap.right;
    add(building, roof(building), across);
    add(building, floor_at(problem, gap, *place.contact, side), across);
  }
  return floors;
}

DenseFindings dense_findings(const PlanRun& run, double budget) {
  DenseFindings findings;
  const PlanResponse& response = run.response;
  const double step = dense_step(run.problem.duration, numbers_of(run.problem), budget);
  if (!is_dense(step) || (response.status != Status::done && response.status != Status::collapsed)) return findings;
  FloorSpectra& floors = findings.floors;
  floors.floors = spectrum_floors(run.problem, response);
  const std::vector<PlanFramePlace> places = frames_with_members(run.c, run.problem);
  for (Index n = 0; n < std::ssize(places); ++n) findings.frames.push_back({.building = n});
  std::vector<VectorXd> omegas;
  for (const FloorSpectra::Floor& floor : floors.floors) {
    omegas.push_back(run.problem.buildings[floor.building].modes.omega);
  }
  floors.periods = dense_periods(omegas, step);
  const Impact* const hardest = hardest_impact(response.impacts);
  for (const bool touches : {true, false}) {
    if (!touches && hardest == nullptr) {  // both are one
      for (FloorSpectra::Floor& floor : floors.floors) floor.without_contact = floor.with_contact;
      for (FrameForces& frame : findings.frames) {
        frame.most_without_contact = frame.most;
        frame.least_without_contact = frame.least;
      }
      continue;
    }
    PlanProblem as_it_is = run.problem;
    as_it_is.duration = response.duration > 0 ? response.duration : run.problem.duration;
    as_it_is.goes_on = false;
    as_it_is.elsewhere.clear();
    for (PlanGap& gap : as_it_is.gaps) gap.watched.clear();
    if (!touches) as_it_is.gaps.clear();
    SolveOptions options;
    options.output_step = step;
    const PlanHistories dense = solve(as_it_is, run.c.analysis.solver, options).histories;
    if (dense.time.size() < 2) return {};
    for (FloorSpectra::Floor& floor : floors.floors) {
      (touches ? floor.with_contact : floor.without_contact) = floor_spectrum(
          dense.time[1] - dense.time[0], floor_speed(dense, as_it_is, floor), floors.periods, floors.damping);
    }
    for (FrameForces& frame : findings.frames) {
      const PlanFramePlace& place = places[static_cast<std::size_t>(frame.building)];
      const PlanModel& model = as_it_is.buildings[place.building].model;
      const MemberForces forces = forces_at(run.c, as_it_is, place).value();
      const FrameMoves moves(dense, model, place);
      take_extremes(forces, moves.sways, moves.turned, touches, frame);
      if (!touches) continue;
      const std::vector<double> heights(model.storey_heights.begin() + model.first_storey(),
                                        model.storey_heights.end());
      const double at = hardest == nullptr ? 0 : hardest->peak_force > 0 ? hardest->peak_force_time : hardest->start;
      const Index column = hardest == nullptr ? moves.largest_drift(heights) : column_at(dense.time, at);
      take_instant(forces, moves.sways, moves.turned, dense.time, column, frame);
    }
  }
  return findings;
}

}  // namespace bentur
