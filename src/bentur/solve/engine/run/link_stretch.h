#pragma once

#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/motion/polynomial.h"

namespace bentur::engine {

/// F = base + stiffness δ + damping δ̇ over an expanded step of `h` [s].
[[nodiscard]] Polynomial force_of(const ElementForces::Linear& linear, const Polynomial& deformation, double h);

/// What an element with a linear force does over [0, end] of an expanded step of `h` [s].
struct LinkStretch {
  double damped = 0;        ///< that its dashpot takes in [force·length]
  double peak_force = 0;    ///< max F [force] ≥ 0
  double peak_tension = 0;  ///< max −F [force] ≥ 0
};
[[nodiscard]] LinkStretch link_stretch(const ElementForces::Linear& force, const Polynomial& deformation, double h,
                                       double end);

}  // namespace bentur::engine
