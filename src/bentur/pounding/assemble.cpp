#include "bentur/pounding/assemble.h"

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/elements/deformation_limit.h"
#include "bentur/pounding/internal/levels.h"

namespace bentur {
namespace {

using Eigen::Index;

/// What counts of the ground's displacement.
Eigen::VectorXd of_ground(const Problem& problem, double factor) {
  return Eigen::VectorXd::Constant(1, problem.kinematics == Kinematics::absolute ? factor : 0.0);
}

/// A degree of freedom of a building: of a floor, or after the floors of a node in a column.
BodyRow dof_of(const Problem& problem, Index building, Index dof, double sign) {
  const StructuralModel& model = problem.buildings[building].model;
  return {building, sign * Eigen::VectorXd::Unit(model.dofs(), dof), of_ground(problem, sign),
          dof < model.floors() ? dof : -1};
}

Interface between(const Problem& problem, Index left, Index left_dof, Index right, Index right_dof) {
  return {dof_of(problem, left, left_dof, 1.0), dof_of(problem, right, right_dof, -1.0)};
}

Interface watched(const Problem& problem, const WatchedFloor& floor) {
  return {{floor.left, floor.left_row, of_ground(problem, 1.0)},
          {floor.right, -floor.right_row, of_ground(problem, -1.0)}};
}

/// Storeys that have collapsed where their drift passes a limit: those of buildings that gravity pulls down.
std::vector<Element> drift_limits(const Problem& problem) {
  std::vector<Element> limits;
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const Building& building = problem.buildings[b];
    if (!building.has_gravity_loads) continue;
    const Eigen::MatrixXd drifts = drift_rows(building.model);
    for (Index f = building.model.first_storey(); f < building.model.floors(); ++f) {
      const double most = problem.collapse_drift * building.model.storey_heights[f];
      Element& limit = limits.emplace_back();
      limit.at.left = {b, drifts.row(f)};
      limit.law = std::make_shared<DeformationLimit>(most);
    }
  }
  return limits;
}

/// Nothing can be solved of a building known by its peaks alone.
void require_all_move(const Problem& problem) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    if (!problem.buildings[b].given) continue;
    throw InvalidParameter(fmt::format("buildings[{}].given", b), problem.buildings[b].name,
                           "is known by its peak displacements alone: nothing can be solved of it");
  }
}

}  // namespace

std::optional<Index> face_floor(const Problem& problem, std::size_t level, int side) {
  const std::size_t points = problem.points.size();
  return level < points ? face_floor(problem, problem.points[level], side)
                        : face_floor(problem.watched[level - points], side);
}

System system_of(const Problem& problem, bool levels) {
  require_all_move(problem);
  System system;
  for (const Building& building : problem.buildings) system.bodies.push_back(body_of(building));
  for (const ContactPoint& point : problem.points) {
    system.contacts.push_back(
        {between(problem, point.left, point.left_floor, point.right, point.right_floor), point.law, point.width});
  }
  for (const Link& link : problem.links) {
    Element& joint = system.joints.emplace_back();
    joint.at = between(problem, link.left, link.left_floor, link.right, link.right_floor);
    joint.law = link.law;
  }
  system.limits = drift_limits(problem);
  for (const WatchedFloor& floor : problem.watched) system.watched.push_back(watched(problem, floor));
  if (levels) {
    std::vector<Interface> faces;
    for (const Contact& contact : system.contacts) faces.push_back(contact.at);
    faces.insert(faces.end(), system.watched.begin(), system.watched.end());
    system.watched_free = level_interfaces(
        faces, [&](std::size_t level, int side) { return face_floor(problem, level, side).has_value(); });
  }
  system.motions.push_back(problem.motion);  // of a list in braces there would be two copies
  system.delays = problem.delays;
  system.initial_displacement = problem.initial_displacement;
  system.initial_velocity = problem.initial_velocity;
  system.duration = problem.duration;
  return system;
}

}  // namespace bentur
