#include "bentur/model/closer/dense_run.h"

#include <utility>

#include "bentur/model/closer/dense_parts.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// How far apart samples of both runs may be [s]; one is in memory at a time.
double step_of(const Problem& problem, double budget) {
  double numbers = 2 + 2 * static_cast<double>(problem.points.size());  // of one sample
  for (const Building& building : problem.buildings) {
    const StructuralModel& model = building.model;
    numbers += 6 * static_cast<double>(model.dofs()) + 2 * static_cast<double>(model.hinges.size()) +
               static_cast<double>(model.column_forces.rows());
  }
  return dense_step(problem.duration, numbers, budget);
}

/// The instant that is shown: of the hardest impact, else of the largest drift of a storey of the frame.
Index shown_column(const Response& response, const Histories& histories, const StructuralModel& model, Index building) {
  if (const Impact* const hardest = hardest_impact(response.impacts)) {
    return column_at(histories.time, hardest->peak_force > 0 ? hardest->peak_force_time : hardest->start);
  }
  Index storey = 0, column = 0;
  const Index storeys = model.floors() - model.first_storey();
  histories.drift_ratio[building].bottomRows(storeys).cwiseAbs().maxCoeff(&storey, &column);
  return column;
}

void take(const PlaneFrame& frame, const Problem& problem, const Response& response, const Histories& histories,
          bool touches, FrameForces& found) {
  const Building& building = problem.buildings[found.building];
  const MemberForces forces = forces_of(frame, building).value();
  const MatrixXd sways = frame_sways(histories, frame, problem, found.building);
  MatrixXd turned = histories.hinge_rotation[found.building];
  if (turned.rows() == 0) turned.resize(0, sways.cols());
  take_extremes(forces, sways, turned, touches, found);
  if (!touches) return;
  take_instant(forces, sways, turned, histories.time, shown_column(response, histories, building.model, found.building),
               found);
}

}  // namespace

DenseFindings dense_findings(const Problem& problem, const Response& response, const Solver& solver,
                             const std::vector<const PlaneFrame*>& frames, double budget) {
  DenseFindings findings;
  const double step = step_of(problem, budget);
  if (!is_dense(step) || (response.status != Status::done && response.status != Status::collapsed)) return findings;
  findings.floors.floors = spectrum_floors(problem, response);
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlaneFrame* frame = frames[static_cast<std::size_t>(b)];
    if (frame != nullptr && forces_of(*frame, problem.buildings[b])) findings.frames.push_back({.building = b});
  }
  std::vector<Eigen::VectorXd> omegas;
  for (const FloorSpectra::Floor& floor : findings.floors.floors) {
    omegas.push_back(problem.buildings[floor.building].modes.omega);
  }
  findings.floors.periods = dense_periods(omegas, step);
  for (const bool touches : {true, false}) {
    Problem as_it_is = problem;
    as_it_is.duration = response.duration > 0 ? response.duration : problem.duration;
    as_it_is.goes_on = false;
    as_it_is.watched.clear();
    if (!touches) as_it_is.points.clear();
    SolveOptions options;
    options.output_step = step;
    const bool is_other = touches || !response.impacts.empty();
    const Response dense = is_other ? solve(as_it_is, solver, options) : Response{};
    if (is_other && dense.histories.time.size() < 2) return {};
    for (FloorSpectra::Floor& floor : findings.floors.floors) {
      std::vector<double>& to = touches ? floor.with_contact : floor.without_contact;
      to = is_other ? floor_spectrum(dense.histories.time[1] - dense.histories.time[0],
                                     floor_speed(dense.histories, as_it_is, floor.building, floor.floor),
                                     findings.floors.periods, findings.floors.damping)
                    : floor.with_contact;
    }
    for (FrameForces& frame : findings.frames) {
      if (is_other) {
        take(*frames[static_cast<std::size_t>(frame.building)], as_it_is, response, dense.histories, touches, frame);
      } else {
        frame.most_without_contact = frame.most;
        frame.least_without_contact = frame.least;
      }
    }
  }
  return findings;
}

}  // namespace bentur
