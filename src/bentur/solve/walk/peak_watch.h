#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/motion/expansion.h"
#include "bentur/solve/motion/flight.h"
#include "bentur/solve/response.h"

namespace bentur::engine {

/// Keeps the extrema of every reported quantity of every building. Peaks are those of the continuous response: an
/// interval is looked into unless its ends and a proven bound of its curvature show that it cannot raise a peak.
class PeakWatch {
 public:
  static constexpr int most_parts = 8;  ///< of a step

  enum class Scope { displacement, everything };
  PeakWatch(const ModalSystem& system, Scope scope);

  [[nodiscard]] Scope scope() const { return scope_; }

  /// Takes the start of the run in.
  void start(const State& state);

  /// One building between two instants, an entry per coordinate of it.
  struct Interval {
    const double *start, *end;                            ///< q
    const double *start_acceleration, *end_acceleration;  ///< q̈; not looked at in the narrower scope
    const double* rise;                                   ///< bound of |q̈| times length²/8
    const double* acceleration_rise;                      ///< bound of |d⁴q/dt⁴| times length²/8
  };

  /// How far each quantity of one building can have gone in an interval at most. What is known of an interval holds for
  /// its parts: only quantities with a reach above their peak are looked at again.
  struct Reach {
    Eigen::ArrayXd positions;      ///< displacement [, drift ratio, storey shear], as Block::outputs
    Eigen::ArrayXd accelerations;  ///< absolute accelerations of the floors
  };
  /// Of an interval of which nothing is known.
  void forget(std::size_t block, Reach& reach) const;
  /// To and from plain numbers.
  static void append(const Reach& reach, std::vector<double>& to);
  void read(std::size_t block, const double* from, Reach& reach) const;

  /// What is still to be looked at.
  struct Open {
    bool positions = true, accelerations = true;
  };

  /// What of a free flight one sum alone does not settle: Σ c_j |q_j| ≤ 1 with c_j = max_r |w_rj|/peak_r holds every
  /// row r of weights w below its peak.                                                                         (T-4)
  [[nodiscard]] Open open_at_once(std::size_t block, const Flight::Bounds& bounds);

  /// Takes both ends in, and returns whether the reach of the interval stays below the peaks so far. Accelerations are
  /// looked at only where they are open; the reach of what is not open is zero.
  [[nodiscard]] bool settled_by_bound(std::size_t block, const Interval& interval, Open open, Reach& reach);

  /// Takes `parts` + 1 ≤ most_parts + 1 places of [0, end] of the expanded step in, whose bounds are known, and returns
  /// whether the reach between them stays below the peaks so far.
  [[nodiscard]] bool settled_by_samples(std::size_t block, const Expansion& motion, double end, int parts,
                                        Reach& reach);

  /// Whether a reach stays below the peaks so far.
  [[nodiscard]] bool settled(std::size_t block, const Reach& reach) const;

  /// Searches the whole expanded step of one building for what its reach leaves open.
  void scan(std::size_t block, const Expansion& motion, const Reach& reach);

  /// Copies what was kept into the response of one building (displacement only, in its narrower scope).
  void report(std::size_t block, BuildingPeaks& peaks) const;

 private:
  /// Quantities linear in the coordinates of one building, and their largest absolute values so far.
  struct Rows {
    kernels::PackedRows weights;
    Eigen::ArrayXd peak;
    Eigen::VectorXd lumped;  ///< c of (T-4), of peaks not above those so far
    int misses = 0;          ///< since it was made

    Rows(const Eigen::MatrixXd& quantities, Eigen::Index room);
    [[nodiscard]] bool below(const double* bounds);
    void lump();
    [[nodiscard]] bool take(const double* start, const double* end, const double* rise, Eigen::ArrayXd& reach);
    [[nodiscard]] bool take_samples(int count, const double* samples, const double* rise, Eigen::ArrayXd& reach);
  };

  const ModalSystem* system_;
  std::vector<Rows> positions_, accelerations_;  ///< per building
  Scope scope_;
  Eigen::VectorXd samples_, seconds_, rise_;  ///< room
};

}  // namespace bentur::engine
