#pragma once

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>
#include <vector>

#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/motion/polynomial.h"

namespace bentur::engine {

/// Coordinates of one body over [0, end] of a step of `h` [s]: coefficients of one power of s after the other,
/// `stride` apart.
struct Curves {
  const double* c;
  Eigen::Index stride;
  int degree;
  double h, end;
};

/// One for each four coordinates, within the object for those of ordinary systems.
using FlagsOfFours = boost::container::small_vector<char, 64>;

/// Powers of s of all coordinates, coordinates × powers, and per four coordinates whether forces among them may have
/// powers beyond the first two that are not zero.
struct Coefficients {
  Eigen::MatrixXd values;
  FlagsOfFours used;
};

/// The motion over one step as a polynomial in s = (time − start)/h ∈ [0, 1]. Every solver makes its next step known in
/// this form, and everything else (events, impacts, peaks, histories, energy) reads it.
class Expansion {
 public:
  /// `offsets`: of each element's δ [length].
  Expansion(const ModalSystem& system, std::vector<double> offsets);

  // For those who fill it.
  /// Makes it one of `h` [s] and of the given degree or the next that makes the number of powers a multiple of four,
  /// for `count` coordinates from `first` on. All these powers are to be filled.
  void begin(Eigen::Index first, Eigen::Index count, double h, int degree);
  /// Coefficients: coordinates × powers of s.
  [[nodiscard]] Eigen::MatrixXd& coefficients();
  /// The same for those who fill what moves alone, and say of some bodies that their forces are constant.
  [[nodiscard]] Eigen::MatrixXd& moving_coefficients();
  void hold_forces(std::size_t first, std::size_t end);
  /// δ of an element, for a solver that finds it on the way.
  [[nodiscard]] Polynomial& fill_deformation(Eigen::Index element);
  /// Force of a resting element [force].
  void set_resting_force(Eigen::Index element, const Polynomial& force);
  /// Makes the force coordinates of elements that press what their forces are.
  void fill_forces(const ElementForces& forces);
  /// Works out the state and q̈ at the end, and how far coordinates leave their chords between s = 0 and 1 (T-5), of
  /// those that were filled. False where that is not finite.
  bool find_end(State& state, Eigen::VectorXd& acceleration);

  // For those who read it.
  [[nodiscard]] double h() const { return h_; }
  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] const Eigen::MatrixXd& coefficients() const { return c_; }
  /// Gives its coefficients away, for others of that size: what is asked of it before begin() is no more than rises.
  void give_coefficients(Coefficients& to) {
    c_.swap(to.values);
    used_.swap(to.used);
  }
  [[nodiscard]] Curves curves(const ModalSystem::Block& block, double end = 1.0) const {
    return {c_.data() + block.begin, c_.rows(), degree_, h_, end};
  }
  /// Position, speed and, where it is asked for, q̈ at s; only the coordinates that were filled are written.
  void evaluate(double s, State& state, Eigen::VectorXd* acceleration = nullptr) const;
  [[nodiscard]] const Polynomial& deformation(Eigen::Index element) const;  ///< δ(s) of (T-1) [length]
  [[nodiscard]] const Polynomial& resting_force(Eigen::Index element) const { return resting_force_[element]; }
  /// How far each coordinate, and its acceleration q̈, leaves its chord between s = 0 and 1 at most: find_end() has
  /// found that. Between 0 and some s it is s² times as far at most.
  [[nodiscard]] const Eigen::VectorXd& rise() const { return rise_; }
  [[nodiscard]] const Eigen::VectorXd& acceleration_rise() const { return acceleration_rise_; }
  /// How far each speed q̇ leaves its chord at most: where accelerations lie within a range, by a quarter of the step
  /// times that. To be called after find_end().
  void find_speed_rise(Eigen::VectorXd& result) const;

 private:
  void fill_coupled(const ElementForces::Coupled& of);
  void note_moving(Eigen::Index force) {
    const std::size_t of = static_cast<std::size_t>(force) / 4;
    moving_[of] = used_[of] = 1;
  }
  template <class Take>
  void in_ranges(const Take& take) const;

  const ModalSystem* system_;
  std::vector<double> offsets_;
  double h_ = 0;
  int degree_ = highest_degree;
  Eigen::Index first_ = 0, count_ = 0;  ///< coordinates that were filled
  Eigen::MatrixXd c_;                   ///< coordinates × (highest_degree + 1)
  Eigen::VectorXd rise_, acceleration_rise_, end_acceleration_;
  Eigen::VectorXd none_, largest_, values_;  ///< scratch: of forces
  FlagsOfFours used_;                        ///< as Coefficients
  std::vector<char> moving_;                 ///< per four coordinates: whether one is a force that is no constant
  std::vector<Polynomial> resting_force_;
  mutable std::vector<Polynomial> deformations_;  ///< those asked for
  mutable std::vector<char> deformation_known_;
};

}  // namespace bentur::engine
