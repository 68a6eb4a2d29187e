#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// ζ [-] ≥ 0, one per mode or one for all.
struct ModalDamping {
  std::vector<double> ratios;
};

/// C = αM + βK through two ratios [-] ≥ 0 at two periods [s] > 0: ζ = α/(2ω) + βω/2.
struct RayleighDamping {
  std::vector<double> ratios, periods;
};

/// C = αM with α = 2 ζ₁ ω₁ (2-25); ζ₁ [-] ≥ 0.
struct MassProportionalDamping {
  double ratio = 0;
};

/// C = βK with β = 2 ζ₁/ω₁; ζ₁ [-] ≥ 0.
struct StiffnessProportionalDamping {
  double ratio = 0;
};

/// C [force·s/length], dofs × dofs.
struct MatrixDamping {
  Eigen::MatrixXd matrix;
};

using Damping =
    std::variant<ModalDamping, RayleighDamping, MassProportionalDamping, StiffnessProportionalDamping, MatrixDamping>;

/// β [s] of the damping's stiffness part, of a building whose first mode has ω₁ [rad/s]; nothing where its kind has
/// none. Rayleigh damping can have one below zero.
[[nodiscard]] std::optional<double> stiffness_part(const Damping& damping, double first_omega);

/// Φᵀ C Φ [1/s]. Off-diagonal terms of a given matrix below 1e-12 of its largest are set to zero (classical damping).
/// @throws InvalidParameter when the number of ratios is neither one nor that of the modes, a matrix has the wrong
/// size, or a value is outside its range: ratios < 0, periods ≤ 0 or equal, α and β that give some mode a negative
/// ratio.
[[nodiscard]] Eigen::MatrixXd modal_damping(const Damping& damping, const Modes& modes);

/// Puts a building together: modes by the library solver, then damping.
[[nodiscard]] Building make_building(std::string name, StructuralModel model, const Damping& damping);

}  // namespace bentur
