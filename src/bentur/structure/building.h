#pragma once

#include <Eigen/Core>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "bentur/elements/law.h"

namespace bentur {

/// Mass, stiffness and effective earthquake load of a structure before damping and modes (theory:
/// docs/theory/structure.md). Degrees of freedom: one sway per floor first (bottom to top), then any joint rotations
/// that were kept. p(t) = −load · a_g(t); load = Tᵀ(M r + m_g) (docs/theory/structure.md, Load and Condensation).
struct StructuralModel {
  std::vector<double> elevations;      ///< [length] of the floors above the ground datum, bottom to top; size floors
  std::vector<double> storey_heights;  ///< [length], bottom to top; size floors
  Eigen::MatrixXd mass;                ///< M [mass], symmetric positive definite, dofs × dofs
  Eigen::MatrixXd stiffness;           ///< K [force/length], symmetric positive definite, dofs × dofs
  Eigen::VectorXd load;                ///< M r + m_g [mass], dofs
  /// [mass] of each floor as a rigid body that is hit, for m_e of contact laws: a frame's lumped floor masses whatever
  /// its mass matrix, else the row sums of M; size floors.
  std::vector<double> floor_masses;
  /// θ of a frame's joints, clockwise, as rows over the dofs [1/length, or 1 on a rotation that was kept]: of its
  /// leftmost and its rightmost column line, floors × dofs each; both empty where there are no joints.
  Eigen::MatrixXd left_joints, right_joints;
  [[nodiscard]] Eigen::Index floors() const { return std::ssize(elevations); }
  [[nodiscard]] Eigen::Index dofs() const { return mass.rows(); }
};

/// Undamped modes: K φ = ω² M φ, ΦᵀMΦ = 1, first non-zero entry of each shape positive, ω ascending.
struct Modes {
  Eigen::VectorXd omega;   ///< [rad/s]
  Eigen::MatrixXd shapes;  ///< Φ [mass^-1/2], one mode a column
};

/// A building as the rest of the program sees it.
struct Building {
  std::string name;
  StructuralModel model;
  Modes modes;
  Eigen::MatrixXd modal_damping;  ///< Φᵀ C Φ [1/s], modes × modes; diagonal 2ζω for classical damping
  /// Per storey, of its drift Δ_j = x_j − x_{j−1} [length]; none: it stays elastic. Empty: all do. Its initial stiffness
  /// is part of K, and is the whole of the storey's.
  std::vector<std::shared_ptr<const HystereticLaw>> storey_laws = {};
  /// β of C = αM + βK where the dashpot of a storey that yields is to follow its stiffness: β k_tangent. 0: it does not.
  double tangent_damping = 0;

  /// The law of storey `storey` (0 the lowest); none: it stays elastic.
  [[nodiscard]] const HystereticLaw* storey_law(Eigen::Index storey) const {
    return storey_laws.empty() ? nullptr : storey_laws.at(storey).get();
  }
  [[nodiscard]] bool can_yield() const;
};

}  // namespace bentur
