#pragma once

#include "bentur/structure/building.h"

namespace bentur {

/// Static (Guyan) condensation of all degrees of freedom behind the first `primary` ones:
/// T = [1; −K_ss⁻¹ K_sp], M̄ = TᵀMT, K̄ = TᵀKT, load TᵀP (monograph 2.6).
/// @throws InvalidParameter when `primary` is outside [floors, dofs]; std::runtime_error when K_ss is not positive
/// definite.
[[nodiscard]] StructuralModel condense_statically(const StructuralModel& model, Eigen::Index primary);

/// Dynamic (Paz) condensation, (2-51)…(2-59): T = [1; −(K_ss − ω²M_ss)⁻¹ (K_sp − ω²M_sp)], M̄ = TᵀMT, K̄ = D̄ + ω²M̄,
/// ω² iterated until the reduced problem's lowest mode returns it to 1e-13, or to its own round-off where that is
/// larger (tall frames), so that this mode is exact.
/// @throws InvalidParameter when `primary` is outside [floors, dofs]; std::runtime_error when the iteration does not
/// settle.
[[nodiscard]] StructuralModel condense_dynamically(const StructuralModel& model, Eigen::Index primary);

}  // namespace bentur
