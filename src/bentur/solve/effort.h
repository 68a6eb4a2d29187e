#pragma once

#include <cstddef>
#include <string>

#include "bentur/solve/solver.h"

namespace bentur {

/// What a run takes, from the system and the algorithm alone and before any of it is done.
///
/// While apart, bodies fly over whole steps of the ground motion (T-3); a fast mode costs the logarithm of its
/// frequency. In contact, with full damping matrices and with an energy audit, steps are power series of rate · h ≤ 2.4
/// (T-2), so that the fastest motion there is sets the pace.
struct Effort {
  /// What moves fastest.
  struct Fastest {
    enum class By { mode, damping, contact, motion };
    double frequency = 0;  ///< [Hz]; of damping or a surface that comes back: rate/2π
    By by = By::mode;
    Eigen::Index building = 0;
    Eigen::Index mode = 0;   ///< of the building, from 0
    Eigen::Index point = 0;  ///< of contact
  };
  Fastest apart, in_contact;
  double steps = 0;             ///< [-] of the response, where nothing touches
  double steps_in_contact = 0;  ///< [1/s] while some do; of a nonlinear law an estimate
  double certain_steps = 0;     ///< [-] that are taken in any case: `steps`, and those of an energy audit
  double most_steps = 0;        ///< [-] were they in contact all the time, and with what is gone over again
  double samples = 0;           ///< [-] of every history
  double memory = 0;            ///< [byte] of the run and its histories
  double memory_of_steps = 0;   ///< [byte] of that, what is kept of the motion and of every step
  double seconds = 0;           ///< [s] of `most_steps`, on a processor of 2020: no more than its order of magnitude
  double growing_step = 0;  ///< [s] from which on steps of "runge-kutta" make the fastest mode grow; 0: another solver
};

[[nodiscard]] Effort effort(const System& system, const Solver& solver, const RunOptions& options);

}  // namespace bentur
