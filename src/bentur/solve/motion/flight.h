#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/motion/modal_system.h"

namespace bentur::engine {

/// Free flight over one whole segment of fixed length: every coordinate is an oscillator of its own, so its end state
/// is a fixed linear map of its start state and ground input, computed once per length. Needs diagonal damping.
///
/// Between the ends a proven bound rules events out without looking. With u = q − p, p the particular solution for a
/// linear input, S = √(u̇² + Ω²u²) never grows, so |q̈| ≤ √(Ω² + D²) S; where no p is used (slow coordinates, harmonic
/// input) S is at most its start value plus h max|γ a_g| and |q̈| ≤ √(Ω² + D²) S + max|γ a_g|.           (T-3)
class Flight {
 public:
  Flight(const ModalSystem& system, double length);

  /// The end state; `from` and `to` must differ.
  void advance(const State& from, const std::vector<GroundInput>& inputs, State& to);

  [[nodiscard]] double length() const { return length_; }  ///< [s]

  /// How far a coordinate can leave its chord in the segment last advanced over: a bound of |q̈| …
  [[nodiscard]] const Eigen::VectorXd& rise() const { return rise_; }
  /// the same for q̈: a bound of |d⁴q/dt⁴| times length²/8, or of twice |q̈| if that is less.
  [[nodiscard]] const Eigen::VectorXd& acceleration_rise() const { return acceleration_rise_; }

 private:
  void fill_inputs(const std::vector<GroundInput>& inputs);

  const ModalSystem* system_;
  double length_ = 0;
  Eigen::ArrayXd qq_, qv_, vq_, vv_;  ///< end position and speed from start position and speed
  Eigen::ArrayXd qa_, qb_, va_, vb_;  ///< … and from γ·value and γ·slope
  Eigen::ArrayXd shift_;              ///< 1 where the particular solution is used, else 0
  Eigen::ArrayXd p_value_, p_slope_, p_rate_;  ///< particular solution: p = p_value·γa₀ + p_slope·γa₁, ṗ = p_rate·γa₁
  Eigen::ArrayXd second_, second_force_, fourth_, fourth_force_, fourth_slope_;  ///< (T-3) and its second derivative
  Eigen::ArrayXd value_, slope_, start_energy_, force_, force_slope_;
  Eigen::VectorXd rise_, acceleration_rise_;
};

}  // namespace bentur::engine
