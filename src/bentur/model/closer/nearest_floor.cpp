#include "bentur/model/closer/nearest_floor.h"

#include <algorithm>

namespace bentur {
namespace {

/// Whether a row of a building hangs on nothing but what dof_histories() has.
bool is_held(const Eigen::VectorXd& row, const StructuralModel& model) {
  if (row.size() == 0 || row.size() != model.dofs()) return false;  // of results read back without their case
  Eigen::VectorXd others = row;
  others.head(model.floors() + model.nodes()).setZero();
  if (model.foundation) others(model.foundation->sway) = others(model.foundation->rocking) = 0;
  return others.isZero(0);
}

/// Whether the opening of a watched floor can be found of histories.
bool has_opening(const Problem& problem, const WatchedFloor& floor) {
  return problem.kinematics != Kinematics::absolute && is_held(floor.left_row, problem.buildings[floor.left].model) &&
         is_held(floor.right_row, problem.buildings[floor.right].model);
}

/// dof_histories() of so many samples from one on.
Eigen::MatrixXd dofs_over(const Histories& histories, const Problem& problem, Eigen::Index building, Eigen::Index from,
                          Eigen::Index samples) {
  const StructuralModel& model = problem.buildings[building].model;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(model.dofs(), samples);
  all.topRows(model.floors()) = histories.displacement[building].middleCols(from, samples);
  if (model.nodes() > 0) {
    all.middleRows(model.floors(), model.nodes()) = histories.node_displacement[building].middleCols(from, samples);
  }
  if (model.foundation) {
    all.row(model.foundation->sway) = histories.foundation[building].row(0).segment(from, samples);
    all.row(model.foundation->rocking) = histories.foundation[building].row(1).segment(from, samples);
  }
  return all;
}

}  // namespace

Eigen::MatrixXd dof_histories(const Histories& histories, const Problem& problem, Eigen::Index building) {
  return dofs_over(histories, problem, building, 0, std::ssize(histories.time));
}

std::vector<double> depths_inside(const Problem& problem, const Histories& histories, Eigen::Index sample) {
  std::vector<double> depths;
  for (const WatchedFloor& floor : problem.watched) {
    depths.push_back(0);
    if (!has_opening(problem, floor)) continue;
    const auto towards = [&](const Eigen::VectorXd& row, Eigen::Index building) {
      return row.dot(dofs_over(histories, problem, building, sample, 1).col(0));
    };
    const double opening = floor.width - (towards(floor.left_row, floor.left) - towards(floor.right_row, floor.right));
    depths.back() = std::max(0.0, -opening);
  }
  return depths;
}

std::optional<NearestFloor> nearest_floor(const Problem& problem, const Response& response) {
  const auto least = std::min_element(
      response.watched.begin(), response.watched.end(),
      [](const WatchedSummary& a, const WatchedSummary& b) { return a.least_opening < b.least_opening; });
  if (least == response.watched.end()) return std::nullopt;
  const Eigen::Index number = least - response.watched.begin();
  const WatchedFloor& floor = problem.watched[number];
  NearestFloor nearest{.watched = number,
                       .gap = floor.gap,
                       .left = floor.left,
                       .right = floor.right,
                       .floor_of = floor.floor_of,
                       .floor = floor.floor,
                       .faces_floor = floor.facing_floor.has_value(),
                       .elevation = floor.elevation,
                       .width = floor.width,
                       .least_opening = least->least_opening,
                       .least_time = least->least_time,
                       .closes = least->closes};
  const Histories& histories = response.course.time.empty() ? response.histories : response.course;
  if (histories.time.empty() || !has_opening(problem, floor)) return nearest;
  const Eigen::VectorXd opening =
      floor.width - (dof_histories(histories, problem, floor.left).transpose() * floor.left_row -
                     dof_histories(histories, problem, floor.right).transpose() * floor.right_row)
                        .array();
  nearest.time = histories.time;
  nearest.opening.assign(opening.begin(), opening.end());
  return nearest;
}

}  // namespace bentur
