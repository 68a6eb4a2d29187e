#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/motion/modal_system.h"

namespace bentur::engine {

/// Free flight over one whole segment of fixed length: every coordinate is an oscillator of its own, so its end state
/// is a fixed linear map of its start state and ground input, computed once per length. Needs diagonal damping.
///
/// Between the ends proven bounds rule events and peaks out without looking. With u = q − p, p the particular solution
/// for a linear input, S = √(u̇² + Ω²u²) never grows, so |q̈| ≤ κ S with κ = √(Ω² + D²), and |q| ≤ |p| + S/Ω; where no p
/// is used (slow coordinates, harmonic input) S is at most its start value plus h max|γ a_g|, and
/// |q̈| ≤ κ S + max|γ a_g|.                                                                                 (T-3)
class Flight {
 public:
  /// Bounds over one flight, an entry per coordinate.
  using Bounds = kernels::FlightBounds;
  [[nodiscard]] static Bounds make_bounds(Eigen::Index size);

  /// The flights of a length [s], its half, its quarter, … `halvings` times.
  [[nodiscard]] static std::vector<Flight> make(const ModalSystem& system, double length, int halvings);

  /// The end state; `from` and `to` must differ. Bounds:
  ///   rise               how far q can leave its chord: |q̈| length²/8,
  ///   acceleration_rise  the same of q̈: |d⁴q/dt⁴| length²/8, or 2|q̈| if that is less,
  ///   position           |q|,
  ///   acceleration       |q̈|.
  void advance(const State& from, const std::vector<GroundInput>& inputs, State& to, Bounds& bounds) const;

  /// The same of one building, by where its coordinates begin in each.
  void advance_block(std::size_t block, const double* q, const double* v, const GroundInput& input, double* q_end,
                     double* v_end, Bounds& bounds) const;

  [[nodiscard]] double length() const { return length_; }  ///< [s]

 private:
  Flight(const ModalSystem& system, double length);

  const ModalSystem* system_;
  double length_ = 0;
  kernels::FlightMap map_;
};

}  // namespace bentur::engine
