#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "bentur/contact/law.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/structure/building.h"

namespace bentur {

/// A place where two neighbouring buildings can touch: building `left` and building `left + 1`, at one elevation.
/// Opening g = width + x_right − x_left (T-1).
struct ContactPoint {
  int left = 0;        ///< index of the left building
  int left_floor = 0;  ///< floor index of the left building (0 the lowest)
  int right_floor = 0;
  double elevation = 0;  ///< [length]
  double width = 0;      ///< w [length] ≥ 0
  std::shared_ptr<const ContactLaw> law;
};

enum class Kinematics { relative, absolute };

/// Everything a solver needs, in consistent units. It reads no file and knows no key.
struct Problem {
  std::vector<Building> buildings;   ///< left to right
  std::vector<ContactPoint> points;  ///< ordered by left building, then elevation
  GroundMotion motion;
  std::vector<double> delays;  ///< τ_b [s] ≥ 0, one per building
  Kinematics kinematics = Kinematics::relative;
  std::vector<Eigen::VectorXd> initial_displacement;  ///< per building, dofs [length, rad]; empty: at rest
  std::vector<Eigen::VectorXd> initial_velocity;      ///< per building, dofs [length/s, rad/s]; empty: at rest
  double duration = 0;                                ///< [s] > 0
};

/// w of every point [length].
[[nodiscard]] std::vector<double> gap_widths(const Problem& problem);

/// Whether two floors `width` apart [length] that are displaced by `left` and `right` [length] reach into one another,
/// by more than round-off.
[[nodiscard]] bool overlap(double width, double left, double right);

/// @throws InvalidParameter when sizes disagree or a value is outside its range.
void validate(const Problem& problem);

}  // namespace bentur
