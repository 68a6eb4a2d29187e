#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/structure/frame/plane_frame.h"

namespace bentur {

/// The panels that fill the bays of a frame, from the lowest storey up, bay by bay. A panel is what columns and beams
/// leave of the storey and the bay, a depth √(12 I/A) taken of each section, half of it on either side; the lowest
/// storey has no beam at its foot. With its height h, length L, diagonal r and tan θ = h/L
///   a = 0.175 (λ₁ h_col)^−0.4 r,  λ₁ = (E_me t sin 2θ / (4 E I_col h))^¼,                                (I-2)
/// the width of the strut of FEMA 356, eq. 7-14, h_col the storey height, and across
///   k = E_me a t cos²θ / r,  V = min(a t f'_m cos θ, f_v t L),                                            (I-3)
/// the strut's crushing and sliding along a bed joint.
/// @throws InvalidParameter when a value is outside its range or columns and beams leave no room for a panel.
[[nodiscard]] std::vector<InfillPanel> infill_panels(const PlaneFrame& frame);

/// What panels add to K of the floors' sways, floors × floors [force/length].
[[nodiscard]] Eigen::MatrixXd infill_stiffness(const std::vector<InfillPanel>& panels, Eigen::Index floors);

/// A column that breaks, or the lowest or highest piece of one that is struck, beside a panel whose struts push on it.
struct StrutOnColumn {
  Eigen::Index panel = 0, column = 0;  ///< of a list of panels, of Hinges::columns
};
[[nodiscard]] std::vector<StrutOnColumn> struts_on_columns(const std::vector<InfillPanel>& panels,
                                                           const Hinges& hinges);

}  // namespace bentur
