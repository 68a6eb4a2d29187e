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

}  // namespace

Eigen::MatrixXd dof_histories(const Histories& histories, const Problem& problem, Eigen::Index building) {
  const StructuralModel& model = problem.buildings[building].model;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(model.dofs(), std::ssize(histories.time));
  all.topRows(model.floors()) = histories.displacement[building];
  if (model.nodes() > 0) all.middleRows(model.floors(), model.nodes()) = histories.node_displacement[building];
  if (model.foundation) {
    all.row(model.foundation->sway) = histories.foundation[building].row(0);
    all.row(model.foundation->rocking) = histories.foundation[building].row(1);
  }
  return all;
}

std::optional<NearestFloor> nearest_floor(const Problem& problem, const Response& response) {
  const auto least = std::min_element(
      response.watched.begin(), response.watched.end(),
      [](const WatchedSummary& a, const WatchedSummary& b) { return a.least_opening < b.least_opening; });
  if (least == response.watched.end()) return std::nullopt;
  const WatchedFloor& floor = problem.watched[least - response.watched.begin()];
  NearestFloor nearest{.gap = floor.gap,
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
  if (histories.time.empty() || problem.kinematics == Kinematics::absolute ||
      !is_held(floor.left_row, problem.buildings[floor.left].model) ||
      !is_held(floor.right_row, problem.buildings[floor.right].model)) {
    return nearest;
  }
  const Eigen::VectorXd opening =
      floor.width - (dof_histories(histories, problem, floor.left).transpose() * floor.left_row -
                     dof_histories(histories, problem, floor.right).transpose() * floor.right_row)
                        .array();
  nearest.time = histories.time;
  nearest.opening.assign(opening.begin(), opening.end());
  return nearest;
}

}  // namespace bentur
