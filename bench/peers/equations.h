#pragma once

#include <cstddef>
#include <vector>

#include "bentur/pounding/problem.h"

namespace bentur::bench {

/// The equations of motion of a problem with linear contact, as a general-purpose integrator likes them best: in modal
/// coordinates, so that a derivative costs a few operations a mode, and scaled so that one absolute tolerance serves
/// all.
///
///   y = (Ω q, q̇),   y₁' = Ω y₂,   y₂' = −Ω y₁ − D y₂ − Γ a_g(t − τ) + Σ_closed F_i s_i,   F_i = −k_i g_i,      (1)
///   g_i = w_i + s_iᵀ Ω⁻¹ y₁,
///
/// s_i the shapes at contact point i, of the right building with +, of the left one with −. Which points are closed is
/// part of the state: whoever integrates locates the instants and says so, and (1) is smooth in between. Between two
/// breakpoints of the ground motion a_g is linear.
class Equations {
 public:
  /// `length` [length] a displacement of the response, which sets the scales.
  /// @throws std::invalid_argument where the problem has another law than linear, coupled damping, absolute
  /// kinematics, harmonic motion, or does not start at rest.
  Equations(const Problem& problem, double length);

  [[nodiscard]] std::size_t size() const { return 2 * modes_; }  ///< of y
  [[nodiscard]] std::size_t points() const { return contacts_.size(); }
  [[nodiscard]] double scale() const { return scale_; }  ///< of y [mass^½ length/s]

  /// 0, the breakpoints of the ground motion as each building feels it, and the end [s].
  [[nodiscard]] const std::vector<double>& breakpoints() const { return breakpoints_; }
  /// Takes a_g of the interval that begins at breakpoint `interval`, on and beyond its ends.
  void enter(std::size_t interval) { interval_ = interval; }
  /// Whether a_g of any building jumps where `interval` begins.
  [[nodiscard]] bool jumps(std::size_t interval) const { return jumps_[interval]; }

  void derivative(double time, const double* y, double* rate);

  /// g_i, raised by a hundred millionth of a millionth of `length`, so that a gap of zero begins open [length].
  [[nodiscard]] double opening(std::size_t point, const double* y) const;
  [[nodiscard]] double opening_rate(std::size_t point, const double* y) const;  ///< ġ_i [length/s]
  [[nodiscard]] bool closed(std::size_t point) const { return closed_[point] != 0; }
  void set_closed(std::size_t point, bool closed) {
    if (closed && closed_[point] == 0) ++impacts_;
    closed_[point] = closed ? 1 : 0;
  }
  /// Counts the force of a closed point at y, where it has an extremum.
  void note_peak(std::size_t point, const double* y);

  /// All open, nothing noted: as at t = 0.
  void restart();

  [[nodiscard]] double peak_force() const { return peak_force_; }  ///< [force]
  [[nodiscard]] long impacts() const { return impacts_; }          ///< contacts begun
  [[nodiscard]] long evaluations() const { return evaluations_; }  ///< of the derivative

 private:
  struct Contact {
    std::size_t left = 0, right = 0,
                end = 0;                  // modes [left, right) of the left building, [right, end) of the right one
    double width = 0, stiffness = 0;      // w [length], k [force/length]
    std::vector<double> sense, flexible;  // s and s Ω⁻¹
  };
  struct Input {
    double start = 0, slope = 0;  // a_g at the interval's beginning [length/s²], and its slope
  };

  std::size_t modes_ = 0, buildings_ = 0;
  std::vector<std::size_t> first_;  // mode of each building, and the end
  std::vector<double> omega_, damping_, load_;
  std::vector<Contact> contacts_;
  std::vector<double> breakpoints_;
  std::vector<Input> inputs_;  // interval by interval, building by building
  std::vector<bool> jumps_;    // interval by interval
  std::size_t interval_ = 0;
  double scale_ = 0, shift_ = 0;
  std::vector<char> closed_;
  double peak_force_ = 0;
  long impacts_ = 0, evaluations_ = 0;
};

}  // namespace bentur::bench
