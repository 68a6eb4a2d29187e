#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bentur/solve/engine/motion/kernels/flights.h"
#include "bentur/solve/engine/motion/modal_system.h"

namespace bentur::engine {

/// Free flight over one whole segment of fixed length: every coordinate is an oscillator of its own, so its end state
/// is a fixed linear map of its start state and ground input, computed once per length. Needs diagonal damping.
///
/// Between the ends proven bounds rule events and peaks out without looking. With u = q − p, p the particular solution
/// for a linear input, S = √(u̇² + Ω²u²) never grows, so |q̈| ≤ κ S with κ = √(Ω² + D²), and |q| ≤ |p| + S/Ω; where no p
/// is used (slow coordinates, some harmonic input) S is at most its start value plus h max|γ a_g|, and
/// |q̈| ≤ κ S + max|γ a_g|. A constant load adds to p, or to γ a_g in these, which are sums over components.    (T-3)
class Flight {
 public:
  /// The flights of a length [s], its half, its quarter, … `halvings` times.
  [[nodiscard]] static std::vector<Flight> make(const ModalSystem& system, double length, int halvings);

  /// The same component of the acceleration with its bounds over the flight.
  [[nodiscard]] kernels::FlightInput input(const GroundInput& ground, double nu) const;

  /// One body; only its coordinates are looked at and written.
  ///   rise               how far q can leave its chord: |q̈| length²/8,
  ///   acceleration_rise  the same of q̈: |d⁴q/dt⁴| length²/8, or 2|q̈| if that is less,
  void advance(std::size_t block, const GroundInput* ground, const kernels::FlightArrays& arrays) const;

  /// How far q and q̈ of one body leave their cubics instead, where that is less; `arrays` has what advance() found.
  /// Between breakpoints of a linear input q̈ itself swings freely: with S = √(q⃛² + Ω²q̈²) at the start, of which κ S and
  /// (D(Dκ + Ω²) + Ω²κ) S bound the fourth derivatives of q and q̈, a cubic through values and slopes at both ends is
  /// left by length⁴/384 of these at most.                                                                      (T-8)
  void fit_cubics(std::size_t block, const GroundInput* ground, const kernels::CubicArrays& arrays) const;

  [[nodiscard]] double length() const { return length_; }  ///< [s]
  [[nodiscard]] const kernels::FlightMap& map() const { return map_; }

 private:
  Flight(const ModalSystem& system, double length);
  /// Of one body, per component.
  [[nodiscard]] std::array<kernels::FlightInput, most_components> inputs(const GroundInput* ground) const;

  const ModalSystem* system_;
  double length_ = 0;
  kernels::FlightMap map_;
};

/// The flights of one segment length of the grid and of its halves, quarters, …: number n is of length/2ⁿ.
using Flights = std::vector<Flight>;

/// The flights of every segment length of the grid down to a part short enough for one power series: by measurement
/// (bench/tuning.md), no further. Empty where a damping matrix is full.
using FlightTable = std::vector<Flights>;  // [kind][halvings]
[[nodiscard]] FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid);
/// The same of one length [s].
[[nodiscard]] Flights make_flights(const ModalSystem& system, double length);

}  // namespace bentur::engine
