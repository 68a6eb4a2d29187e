#include "bentur/study/case.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "bentur/contact/axial_stiffness.h"
#include "bentur/contact/linear.h"
#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

StructuralModel matrices_model(const MatricesSpec& spec, double base_elevation) {
  const auto floors = static_cast<Eigen::Index>(spec.elevations.size());
  if (floors == 0 || spec.mass.rows() != floors || spec.mass.cols() != floors || spec.stiffness.rows() != floors ||
      spec.stiffness.cols() != floors) {
    throw InvalidParameter("matrices", std::to_string(floors) + " elevations",
                           "mass and stiffness must have one row and column per elevation");
  }
  StructuralModel model;
  double below = 0;
  for (const double elevation : spec.elevations) {
    if (!(elevation > below)) {
      throw InvalidParameter("elevations", std::to_string(elevation), "must ascend from above the base");
    }
    model.elevations.push_back(base_elevation + elevation);
    model.storey_heights.push_back(elevation - below);
    below = elevation;
  }
  model.mass = spec.mass;
  model.stiffness = spec.stiffness;
  model.load = spec.mass.rowwise().sum();
  return model;
}

/// The floor at an elevation, within a millionth of the building's height.
int floor_at(const Building& building, double elevation) {
  const std::vector<double>& floors = building.model.elevations;
  double height = 0;
  for (const double storey : building.model.storey_heights) {
    height += storey;
  }
  for (std::size_t i = 0; i < floors.size(); ++i) {
    if (std::abs(floors[i] - elevation) <= 1e-6 * height) {
      return static_cast<int>(i);
    }
  }
  throw InvalidParameter("elevations", std::to_string(elevation), "\"" + building.name + "\" has no floor there");
}

/// Half of the beam next to the gap, (3-4): the rightmost bay of a left building, the leftmost bay of a right one.
double beam_end_stiffness(const BuildingSpec& spec, int floor, bool left_of_gap) {
  const auto* frame = std::get_if<PlaneFrame>(&spec.structure);
  if (frame == nullptr) {
    throw InvalidParameter("stiffness", "axial", "needs a frame; \"" + spec.name + "\" is none");
  }
  const double bay = left_of_gap ? frame->bay_widths.back() : frame->bay_widths.front();
  return half_beam_stiffness(frame->elastic_modulus, frame->beams.at(static_cast<std::size_t>(floor)).area, bay);
}

double contact_stiffness(const Case& c, std::size_t gap, std::size_t index, const ContactPoint& point) {
  const ContactSpec& contact = c.gaps[gap].contact;
  if (contact.axial) {
    return series_stiffness(beam_end_stiffness(c.buildings[gap], point.left_floor, true),
                            beam_end_stiffness(c.buildings[gap + 1], point.right_floor, false));
  }
  if (contact.stiffness.size() == 1) {
    return contact.stiffness.front();
  }
  if (index >= contact.stiffness.size()) {
    throw InvalidParameter("stiffness", std::to_string(contact.stiffness.size()) + " values",
                           "must be one value or one per contact point");
  }
  return contact.stiffness[index];
}

/// Contact points of the gap to the right of building `gap`.
std::vector<ContactPoint> contact_points(const Case& c, std::size_t gap, const std::vector<Building>& buildings) {
  const GapSpec& spec = c.gaps[gap];
  if (spec.contact.law != "linear") {
    throw InvalidParameter("law", spec.contact.law, "must be \"linear\"");
  }
  if (spec.elevations.empty() || spec.widths.size() != spec.elevations.size()) {
    throw InvalidParameter("widths", std::to_string(spec.widths.size()) + " values",
                           "must be one per contact point, of which a gap has at least one");
  }
  std::vector<ContactPoint> points;
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    ContactPoint point;
    point.left = static_cast<int>(gap);
    point.left_floor = floor_at(buildings[gap], spec.elevations[i]);
    point.right_floor = floor_at(buildings[gap + 1], spec.elevations[i]);
    point.elevation = spec.elevations[i];
    point.width = spec.widths[i];
    point.law = std::make_shared<Linear>(contact_stiffness(c, gap, i, point));
    points.push_back(point);
  }
  return points;
}

/// All degrees of freedom from the floors' values; joint rotations θ = −K_ss⁻¹ K_sp x, free of moment.
Eigen::VectorXd from_floors(const StructuralModel& model, const std::vector<double>& values) {
  const Eigen::Index floors = model.floors();
  const Eigen::Index rotations = model.dofs() - floors;
  if (static_cast<Eigen::Index>(values.size()) != floors) {
    throw InvalidParameter("initial", std::to_string(values.size()) + " values", "must be one per floor");
  }
  Eigen::VectorXd all(model.dofs());
  all.head(floors) = Eigen::Map<const Eigen::VectorXd>(values.data(), floors);
  if (rotations > 0) {
    all.tail(rotations) = -model.stiffness.bottomRightCorner(rotations, rotations)
                               .ldlt()
                               .solve(model.stiffness.bottomLeftCorner(rotations, floors) * all.head(floors));
  }
  return all;
}

std::vector<Eigen::VectorXd> initial_state(const std::vector<std::vector<double>>& given,
                                           const std::vector<Building>& buildings) {
  if (given.empty()) {
    return {};
  }
  if (given.size() != buildings.size()) {
    throw InvalidParameter("initial", std::to_string(given.size()) + " lists", "must be one per building");
  }
  std::vector<Eigen::VectorXd> state;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    state.push_back(given[b].empty() ? Eigen::VectorXd::Zero(buildings[b].model.dofs())
                                     : from_floors(buildings[b].model, given[b]));
  }
  return state;
}

}  // namespace

StructuralModel structural_model(const BuildingSpec& spec) {
  StructuralModel model;
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) {
    model = plane_frame_model(*frame, spec.base_elevation);
  } else if (const auto* stick = std::get_if<Stick>(&spec.structure)) {
    model = stick_model(*stick, spec.base_elevation);
  } else {
    model = matrices_model(std::get<MatricesSpec>(spec.structure), spec.base_elevation);
  }
  if (spec.calibrate_period) {
    calibrate_period(model, *spec.calibrate_period);
  }
  return model;
}

Building make_building(const BuildingSpec& spec) {
  return make_building(spec.name, structural_model(spec), spec.damping);
}

Problem make_problem(const Case& c) {
  if (c.buildings.size() < 2 || c.gaps.size() + 1 != c.buildings.size()) {
    throw InvalidParameter("gaps", std::to_string(c.gaps.size()),
                           "must be one between each pair of neighbours, of two buildings or more");
  }
  Problem problem;
  for (const BuildingSpec& spec : c.buildings) {
    problem.buildings.push_back(make_building(spec));
  }
  for (std::size_t gap = 0; gap < c.gaps.size(); ++gap) {
    for (ContactPoint& point : contact_points(c, gap, problem.buildings)) {
      problem.points.push_back(std::move(point));
    }
  }
  problem.motion = c.excitation.motion;
  problem.delays = c.excitation.delays;
  problem.kinematics = c.excitation.kinematics;
  problem.initial_displacement = initial_state(c.initial.displacements, problem.buildings);
  problem.initial_velocity = initial_state(c.initial.velocities, problem.buildings);
  problem.duration = c.analysis.duration;
  validate(problem);
  return problem;
}

}  // namespace bentur
