#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "bentur/pounding/checks/self_checks.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is left of a drift has no end where nothing holds a storey of a frame any more.
bool holds_for_good(const BuildingPeaks& frame) {
  const auto loses = [](const BuildingPeaks::Hinge& hinge) { return hinge.strength_left.has_value(); };
  return frame.columns.empty() && std::none_of(frame.hinges.begin(), frame.hinges.end(), loses);
}

void add_peaks(const std::string& building, const PlanPeaks& peaks, std::vector<CheckedPeaks>& all) {
  const PlanPeaks::Bearings& bearings = peaks.bearings;
  const auto add = [&](const char* what, std::initializer_list<const VectorXd*> lists,
                       const std::function<bool(Index)>& is_null = {}) {
    for (const VectorXd* const list : lists) all.push_back({what, building, *list, is_null});
  };
  const bool on_bearings = bearings.x.size() > 0;
  const auto below_slab = [on_bearings](Index i) { return on_bearings && i == 0; };  // where no plane is
  add("movement of bearing", {&bearings.x, &bearings.y, &bearings.residual_x, &bearings.residual_y});
  add("force of bearing", {&bearings.force_x, &bearings.force_y, &bearings.hysteretic_energy});
  add("displacement", {&peaks.x, &peaks.y, &peaks.south, &peaks.north, &peaks.west, &peaks.east});
  add("rotation", {&peaks.rotation});
  add("acceleration", {&peaks.acceleration_x, &peaks.acceleration_y, &peaks.angular_acceleration});
  add("storey shear", {&peaks.shear_x, &peaks.shear_y, &peaks.torque});
  add("movement of the foundation", {&peaks.foundation});
  add("column force", {&peaks.column_forces});
  add("drift ratio", {&peaks.drift_south, &peaks.drift_north, &peaks.drift_west, &peaks.drift_east}, below_slab);
  for (const PlanPeaks::Plane& plane : peaks.planes) {
    add("drift ratio", {&plane.drift_ratio}, below_slab);
    add("shear of a plane", {&plane.shear}, below_slab);
    add("hysteretic energy", {&plane.yielding.hysteretic_energy});
    if (holds_for_good(plane.frame)) add("residual drift", {&plane.yielding.residual_drift_ratio}, below_slab);
  }
}

/// How far hinges were beyond their peak rotations, as beyond_peak_rotations() has it.
double beyond_peaks(const PlanResponse& response) {
  double beyond = 0.0;
  const auto& rotations = response.histories.hinge_rotation;
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    Index first = 0;
    for (const PlanPeaks::Plane& plane : response.buildings[b].planes) {
      const Index count = std::ssize(plane.frame.hinges);
      const Eigen::MatrixXd samples = rotations.empty() ? Eigen::MatrixXd() : rotations[b].middleRows(first, count);
      beyond = std::max(beyond, beyond_peak_rotations(plane.frame.hinges, samples));
      first += count;
    }
  }
  return beyond;
}

}  // namespace

void check_itself(const PlanProblem& problem, const Solver& solver, const SelfMeasures& measures,
                  PlanResponse& response) {
  if (response.status != Status::done && response.status != Status::collapsed) return;
  std::vector<const PlanContact*> contacts;
  std::vector<std::size_t> gaps;
  std::vector<double> moves;  // per building
  CheckedRun run{.place = [&](std::size_t i) {
    return fmt::format("level {:.6g} of {}", contacts[i]->elevation, gap_name(problem, problem.gaps[gaps[i]]));
  }};
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    const std::string& name = problem.buildings[b].name;
    const PlanPeaks &with = response.buildings[b], &without = response.buildings_no_contact[b];
    for (const PlanPeaks* const peaks : {&with, &without}) add_peaks(name, *peaks, run.peaks);
    for (const auto edge : {&PlanPeaks::south, &PlanPeaks::north, &PlanPeaks::west, &PlanPeaks::east}) {
      run.compared.push_back({name, with.*edge, without.*edge});
    }
    moves.push_back(without.edge_displacement().maxCoeff());
  }
  for (std::size_t g = 0; g < problem.gaps.size(); ++g) {
    const PlanGap& gap = problem.gaps[g];
    for (const PlanContact& contact : gap.contacts) {
      contacts.push_back(&contact);
      gaps.push_back(g);
      run.widths.push_back(gap.width_at(contact));
      run.moves.push_back(moves[gap.left] + moves[gap.right]);
      run.touches_where_closed = run.touches_where_closed && contact.family < 0;
      run.is_integrated = run.is_integrated || is_integrated(*contact.law);
    }
  }
  if (!std::all_of(response.friction.begin(), response.friction.end(), [](const PlanFriction& one) {
        return std::isfinite(one.peak_tangential_force + one.tangential_impulse + one.sliding + one.friction_loss);
      })) {
    run.fault = "a number of friction is not finite";
  }
  SelfMeasures all = measures;
  all.peaks = std::max(all.peaks, beyond_peaks(response));
  check_run(run, all, solver, response);
}

}  // namespace bentur
