#include "bentur/structure/frame/condensation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

void check(const StructuralModel& model, Eigen::Index primary) {
  if (primary < 1 || primary < model.floors() || primary > model.dofs()) {
    throw InvalidParameter("primary", std::to_string(primary),
                           "must be in [" + std::to_string(std::max<Eigen::Index>(1, model.floors())) + ", " +
                               std::to_string(model.dofs()) + "]");
  }
}

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& a) { return 0.5 * (a + a.transpose()); }

// T = [1; bottom], "bottom" the secondary displacements for unit primary ones.
Eigen::MatrixXd transformation(const Eigen::MatrixXd& bottom) {
  Eigen::MatrixXd t(bottom.cols() + bottom.rows(), bottom.cols());
  t << Eigen::MatrixXd::Identity(bottom.cols(), bottom.cols()), bottom;
  return t;
}

// The model with M̄ = TᵀMT and load TᵀP; the caller sets K̄.
StructuralModel with_mass_and_load(const StructuralModel& model, const Eigen::MatrixXd& t) {
  StructuralModel reduced;
  reduced.elevations = model.elevations;
  reduced.storey_heights = model.storey_heights;
  reduced.floor_masses = model.floor_masses;
  if (model.left_joints.size() > 0) {
    reduced.left_joints = model.left_joints * t;
    reduced.right_joints = model.right_joints * t;
  }
  reduced.node_elevations = model.node_elevations;
  reduced.node_masses = model.node_masses;
  if (model.column_forces.size() > 0) reduced.column_forces = model.column_forces * t;
  reduced.infills = model.infills;
  reduced.hinges = model.hinges;
  if (model.hinges.size() > 0) reduced.hinges.rows = model.hinges.rows * t;
  reduced.rigid_body = model.rigid_body;
  if (model.rigid_body.rocking.size() > 0) reduced.rigid_body.rocking = t.transpose() * model.rigid_body.rocking;
  reduced.mass = symmetric_part(t.transpose() * model.mass * t);
  reduced.load = t.transpose() * model.load;
  return reduced;
}

// (2-51)…(2-59) at a given ω² [rad²/s²].
StructuralModel reduce_at(const StructuralModel& model, Eigen::Index primary, double omega_squared) {
  const Eigen::Index secondary = model.dofs() - primary;
  const Eigen::MatrixXd d = model.stiffness - omega_squared * model.mass;
  const Eigen::MatrixXd bottom =
      -solve_general(d.bottomRightCorner(secondary, secondary), d.bottomLeftCorner(secondary, primary));
  StructuralModel reduced = with_mass_and_load(model, transformation(bottom));
  // D̄ = D_pp + D_ps T_s, K̄ = D̄ + ω² M̄.
  const Eigen::MatrixXd d_bar = d.topLeftCorner(primary, primary) + d.topRightCorner(primary, secondary) * bottom;
  reduced.stiffness = symmetric_part(d_bar + omega_squared * reduced.mass);
  return reduced;
}

}  // namespace

StructuralModel condense_statically(const StructuralModel& model, Eigen::Index primary) {
  check(model, primary);
  const Eigen::Index secondary = model.dofs() - primary;
  if (secondary == 0) return model;
  const Cholesky cholesky(model.stiffness.bottomRightCorner(secondary, secondary));
  if (!cholesky.is_positive_definite()) {
    throw std::runtime_error("static condensation: the stiffness of what is condensed is not positive definite");
  }
  const Eigen::MatrixXd bottom = -cholesky.solve(model.stiffness.bottomLeftCorner(secondary, primary));
  StructuralModel reduced = with_mass_and_load(model, transformation(bottom));
  reduced.stiffness = symmetric_part(model.stiffness.topLeftCorner(primary, primary) +
                                     model.stiffness.topRightCorner(primary, secondary) * bottom);
  if (model.hinges.size() > 0) {  // what turns while the primary ones are held (H-2)
    const Eigen::MatrixXd of_secondary = model.hinges.rows.rightCols(secondary);
    const Eigen::MatrixXd turned = cholesky.solve(of_secondary.transpose());
    reduced.hinges.stiffness -= symmetric_part(of_secondary * turned);
    if (model.column_forces.size() > 0) {
      reduced.hinges.column_forces += model.column_forces.rightCols(secondary) * turned;
    }
  }
  return reduced;
}

StructuralModel condense_dynamically(const StructuralModel& model, Eigen::Index primary) {
  check(model, primary);
  if (primary == model.dofs()) return model;

  // From ω² = 0, the static reduction. The reduced ω² is a Rayleigh quotient, so its error is squared in each pass and
  // some six passes suffice. Where round-off keeps it from settling to 1e-13 (a stiff frame's lowest mode), the pass at
  // which it stops improving is taken, provided that it has settled to 1e-9.
  constexpr int most_passes = 50;
  double omega_squared = 0;
  double last_change = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most_passes; ++pass) {
    StructuralModel reduced = reduce_at(model, primary, omega_squared);
    const double omega = modes(reduced.mass, reduced.stiffness).omega(0);
    const double next = omega * omega;
    const double change = std::abs(next - omega_squared) / next;
    if (change <= 1e-13 || (change <= 1e-9 && change >= last_change)) return reduced;
    last_change = change;
    omega_squared = next;
  }
  throw std::runtime_error("dynamic condensation: the frequency of mode 0 did not settle");
}

}  // namespace bentur
