#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/motion/course.h"
#include "bentur/solve/motion/expansion.h"
#include "bentur/solve/response.h"

namespace bentur::engine {

/// Keeps the extrema of every reported quantity of every building. Peaks are those of the continuous response: an
/// interval is looked into unless its ends and a proven bound of its curvature show that it cannot raise a peak.
///
/// The quantities of a building are its displacements, drift ratios, storey shears (as Block::outputs) and, after them,
/// its absolute accelerations. Their reach in an interval is how far they can have gone at most. What is known of an
/// interval holds for its parts: only quantities with a reach above their peak are looked at again.
class PeakWatch {
 public:
  static constexpr int most_parts = 8;  ///< of a step

  /// Keeps the weights of (T-4) in `lumped`, positions and accelerations.
  PeakWatch(const ModalSystem& system, kernels::Lumped& lumped);

  /// Takes the start of the run in.
  void start(const State& state);

  /// Peaks of all buildings, one after the other.
  [[nodiscard]] Eigen::VectorXd peaks() const;
  /// Goes on with such ones.
  void resume(const Eigen::VectorXd& peaks);

  /// Number of entries in a list of reaches.
  [[nodiscard]] Eigen::Index quantities(std::size_t block) const;
  /// Reaches in an interval of which nothing is known.
  [[nodiscard]] const double* unknown() const { return unknown_.data(); }

  /// What is still to be looked at.
  struct Open {
    bool positions = true, accelerations = true;
    [[nodiscard]] bool none() const { return !positions && !accelerations; }
  };
  /// Takes the ends of all legs in.
  void raise(std::size_t block, const Course& course);
  /// What is open of a leg of the course last taken in: nothing, where the values at its ends, as parts of their peaks,
  /// and one sum over what the coordinates rise in between are not above 1 together (T-5). `before` becomes zero for
  /// quantities that are not open, unknown for others.
  [[nodiscard]] Open open(std::size_t block, const Course& course, Eigen::Index leg, double* before);
  /// What the sums of an interval leave open.                                                                   (T-4)
  [[nodiscard]] Open open(std::size_t block, const kernels::Sums& sums);

  /// One building between two instants, an entry per coordinate of it.
  struct Interval {
    const double *start, *end;                            ///< q
    const double *start_acceleration, *end_acceleration;  ///< q̈
    const double* rise;                                   ///< bound of |q̈| times length²/8
    const double* acceleration_rise;                      ///< bound of |d⁴q/dt⁴| times length²/8
  };
  /// Takes both ends in, and returns whether the reach of the interval stays below the peaks so far. What is not open
  /// is not looked at; its reach is zero. `before`: reach of a whole that this is a part of; may be `reach` itself.
  [[nodiscard]] bool settled_by_bound(std::size_t block, const Interval& interval, Open open, const double* before,
                                      double* reach);

  /// Takes `parts` + 1 ≤ most_parts + 1 places of [0, end] of the expanded step in, whose bounds are known, and returns
  /// whether the reach between them stays below the peaks so far.
  [[nodiscard]] bool settled_by_samples(std::size_t block, const Expansion& motion, double end, int parts,
                                        const double* before, double* reach);

  /// Number of quantities whose reach does not stay below their peaks so far.
  [[nodiscard]] Eigen::Index open(std::size_t block, const double* reach) const;

  /// Searches the whole expanded step of one building for what its reach leaves open.
  void scan(std::size_t block, const Expansion& motion, const double* reach);

  /// Copies what was kept into the response of one building.
  void report(std::size_t block, BuildingPeaks& peaks) const;

 private:
  /// Quantities linear in the coordinates of one building, and their largest absolute values so far.
  struct Rows {
    kernels::PackedRows weights;
    Eigen::VectorXd peak;
    double* lumped;  ///< c of (T-4), of peaks not above those so far
    int misses = 0;  ///< since it was made

    Rows(const Eigen::MatrixXd& quantities, Eigen::Index room, double* lumped);
    void lump();
    [[nodiscard]] bool open(double sum);
  };

  const ModalSystem* system_;
  std::vector<Rows> positions_, accelerations_;  ///< per building
  std::vector<double> unknown_;
  Eigen::VectorXd samples_, seconds_, rise_;  ///< room
  /// Values at the ends of all legs, and the largest of each end as a part of its peak.
  struct Ends {
    Eigen::VectorXd values, shares;
  };
  struct {
    Eigen::MatrixXd second_derivatives;  ///< q̈ of the coordinates at the ends, one column each
    Ends positions, accelerations;
  } course_;  ///< of one building
};

}  // namespace bentur::engine
