#pragma once

#include "bench/peers/equations.h"
#include "bench/peers/floor_peaks.h"

namespace bentur::bench {

// Each integrates from rest at t = 0 to the end, from one breakpoint of the ground motion to the next, locates every
// instant of contact and of largest force, and starts anew where a contact begins or ends. What was found is in the
// equations. `tolerance` is the relative one [-]; the absolute one is the same times the scale of the state.
// @throws std::runtime_error when the integrator gives up.

/// SUNDIALS CVODE [Hindmarsh2005]: Adams's formulas of variable order and step with fixed-point iteration, as there is
/// little damping to be stiff by.
void integrate_with_cvode(Equations& equations, double tolerance);

enum class Arkode { dormand_prince_5, fehlberg_8 };
/// SUNDIALS ARKODE's explicit Runge-Kutta module with one of its embedded pairs.
void integrate_with_arkode(Equations& equations, double tolerance, Arkode method);

/// Boost.Odeint's dense-output Dormand-Prince pair of order 5(4); events on its interpolant by TOMS 748. With
/// `peaks`, each step is shown to them.
void integrate_with_odeint(Equations& equations, double tolerance, FloorPeaks* peaks = nullptr);

}  // namespace bentur::bench
