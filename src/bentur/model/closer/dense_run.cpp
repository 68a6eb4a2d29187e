#include "bentur/model/closer/dense_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/pounding/pounding.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double finest = 1.0 / 2000, coarsest = 1.0 / 200;  // [s]
constexpr double most_samples = 2e5;                         // of which spectra take a second a floor

/// How far apart samples of both runs may be [s]; one is in memory at a time.
double step_of(const Problem& problem, double budget) {
  double numbers = 2 + 2 * static_cast<double>(problem.points.size());  // of one sample
  for (const Building& building : problem.buildings) {
    const StructuralModel& model = building.model;
    numbers += 6 * static_cast<double>(model.dofs()) + 2 * static_cast<double>(model.hinges.size()) +
               static_cast<double>(model.column_forces.rows());
  }
  return std::max({finest, problem.duration / most_samples, problem.duration * numbers / budget});
}

Index column_at(const std::vector<double>& time, double at) {
  const auto next = std::lower_bound(time.begin(), time.end(), at);
  if (next == time.end()) return std::ssize(time) - 1;
  const bool is_before = next != time.begin() && at - *(next - 1) < *next - at;
  return next - time.begin() - (is_before ? 1 : 0);
}

/// Moments of one instant, or extremes of them, as stations × members.
MatrixXd by_member(const Eigen::VectorXd& moments) {
  constexpr Index stations = std::size(MemberForces::stations);
  return Eigen::Map<const MatrixXd>(moments.data(), stations, moments.size() / stations);
}

/// All three of some instants, one a column.
struct AllForces {
  MatrixXd moments, shears, axial;

  AllForces(const MemberForces& of, const MatrixXd& sways, const MatrixXd& turned)
      : moments(of.moments(sways, turned)), shears(of.shears(sways, turned)), axial(of.axial_forces(sways, turned)) {}
};

/// Raises extremes, the least ones with sign −1, to those of more instants.
void raise(FrameForces::Forces& extremes, const AllForces& more, double sign) {
  const auto take = [&](const MatrixXd& all, Eigen::VectorXd& so_far) {
    Eigen::VectorXd here = sign * (sign * all).rowwise().maxCoeff();
    so_far = so_far.size() == 0 ? here : Eigen::VectorXd(sign * (sign * so_far).cwiseMax(sign * here));
  };
  Eigen::VectorXd moments = extremes.moments.reshaped();
  take(more.moments, moments);
  extremes.moments = by_member(moments);
  take(more.shears, extremes.shears);
  take(more.axial, extremes.axial);
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
  constexpr Index block = 1000;  // instants in memory at a time
  for (Index from = 0; from < sways.cols(); from += block) {
    const Index count = std::min(block, sways.cols() - from);
    const AllForces all(forces, sways.middleCols(from, count), turned.middleCols(from, count));
    raise(touches ? found.most : found.most_without_contact, all, 1);
    raise(touches ? found.least : found.least_without_contact, all, -1);
  }
  if (!touches) return;
  const Index column = shown_column(response, histories, building.model, found.building);
  const AllForces then(forces, sways.col(column), turned.col(column));
  found.members = forces.members();
  found.time = histories.time[static_cast<std::size_t>(column)];
  found.instant = {by_member(then.moments), then.shears, then.axial};
}

}  // namespace

DenseFindings dense_findings(const Problem& problem, const Response& response, const Solver& solver,
                             const std::vector<const PlaneFrame*>& frames, double budget) {
  DenseFindings findings;
  const double step = step_of(problem, budget);
  if (step > coarsest || (response.status != Status::done && response.status != Status::collapsed)) return findings;
  findings.floors.floors = spectrum_floors(problem, response);
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlaneFrame* frame = frames[static_cast<std::size_t>(b)];
    if (frame != nullptr && forces_of(*frame, problem.buildings[b])) findings.frames.push_back({.building = b});
  }
  double longest = 2;  // or of a building, with room to be seen [s]
  for (const FloorSpectra::Floor& floor : findings.floors.floors) {
    const double omega = problem.buildings[floor.building].first_omega();
    if (omega > 0) longest = std::max(longest, 4 * std::numbers::pi / omega);
  }
  findings.floors.periods = spectrum_periods(problem, findings.floors.floors, 60 * step, longest);
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
      to = is_other ? floor_spectrum(dense.histories, as_it_is, floor.building, floor.floor, findings.floors.periods,
                                     findings.floors.damping)
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
