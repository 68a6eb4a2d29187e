#pragma once

#include <gtest/gtest.h>

#include "bentur/solve/solver.h"
#include "bentur/structure/modes.h"

namespace bentur::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A rectangle of mass 50, 8 × 12, free to slide and turn: x, y and θ. One point of it, at `arm` from its middle, comes
/// against a wall to its right.
inline constexpr double plate_mass = 50, plate_inertia = 50 * (8.0 * 8 + 12 * 12) / 12;

/// The rectangle on its own, at rest where it is drawn, with velocities.
inline System rectangle(const Vector3d& velocity, double duration) {
  Body body;
  body.name = "rectangle";
  body.mass = Vector3d(plate_mass, plate_mass, plate_inertia).asDiagonal();
  body.stiffness = 1e-12 * body.mass;
  body.modes = modes(body.mass, body.stiffness);
  body.modal_damping = MatrixXd::Zero(3, 3);
  body.load = VectorXd::Zero(3);
  body.outputs = {{.kind = OutputKind::displacement, .count = 3, .rows = MatrixXd::Identity(3, 3), .has_peak = true},
                  {.kind = OutputKind::velocity, .count = 3, .rates = MatrixXd::Identity(3, 3)}};
  System system;
  system.bodies = {body};
  system.motions = {NoMotion{}};
  system.initial_displacement = {Vector3d::Zero()};
  system.initial_velocity = {velocity};
  system.duration = duration;
  return system;
}

inline Solution solved(const System& system, const Solver& solver = ExactSolver{}) {
  const FreeSolution free(system, solver);
  EXPECT_EQ(free.solution().status, Status::done) << free.solution().message;
  Solution solution = free.solve(system.contacts, {.output_step = system.duration / 8, .energy_audit = true});
  EXPECT_EQ(solution.status, Status::done) << solution.message;
  return solution;
}

/// Velocities at the end.
inline Vector3d after(const Solution& solution) { return solution.outputs[0][1].history.rightCols(1); }

/// A corner of the rectangle, 4 to the right of its middle and 6 below.
inline const Eigen::Vector2d corner(4, -6);
inline constexpr double corner_stiffness = 2e5;

}  // namespace bentur::test
