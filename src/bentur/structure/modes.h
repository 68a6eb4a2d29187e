#pragma once

#include "bentur/structure/building.h"

namespace bentur {

/// Modes by Eigen's generalized self-adjoint solver, ω² to round-off of the largest one. A shape's sign makes its first
/// entry above 1e-9 of its largest positive. @throws std::runtime_error when M or K is not positive definite.
[[nodiscard]] Modes modes(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness);

/// Modes the monograph's way: Cholesky M = LLᵀ, A = L⁻¹KL⁻ᵀ, cyclic Jacobi rotations on A, φ = L⁻ᵀy, (2-8)…(2-13).
/// Same signs and errors.
[[nodiscard]] Modes modes_by_jacobi(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness);

/// A building, of a row or in plan, with its modes found so, where all of them are known.
template <class AnyBuilding>
void find_modes_by_jacobi(AnyBuilding& building) {
  if (building.is_rigid() || building.modes.omega.size() < building.model.dofs()) return;
  building.modes = modes_by_jacobi(building.model.mass, building.model.stiffness);
}

/// Smallest eigenvalue of a symmetric matrix, n × n with n > 0; only the lower half is read.
[[nodiscard]] double smallest_eigenvalue(const Eigen::MatrixXd& matrix);

struct ModalProperties {
  Eigen::VectorXd periods;                  ///< [s], 2π/ω
  Eigen::VectorXd participation;            ///< Γ = φᵀ load [mass^½]
  Eigen::VectorXd effective_mass_fraction;  ///< Γ²/ΣΓ² [-]; with m_g = 0 the sum is the moving mass rᵀMr
};
[[nodiscard]] ModalProperties modal_properties(const Modes& modes, const Eigen::VectorXd& load);
/// The same of a building, of which not all modes may be known: fractions are of all that moves, loadᵀ M⁻¹ load.
[[nodiscard]] ModalProperties modal_properties(const Building& building);

/// What K is to be multiplied by [-] so that the first period is `first_period` [s]. @throws InvalidParameter unless
/// that is finite and > 0.
[[nodiscard]] double calibration_factor(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                        double first_period);
/// Scales K so that the first period is `first_period` [s]. @throws InvalidParameter unless that is finite and > 0.
void calibrate_period(StructuralModel& model, double first_period);

}  // namespace bentur
