#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// What is reported of a body.
enum class OutputKind {
  displacement,      ///< of floors, relative to the own base [length]
  drift_ratio,       ///< of storeys [-], of a slab its drift [length]
  storey_shear,      ///< [force]
  column_force,      ///< StructuralModel::column_forces [force, force·length]
  hinge_moment,      ///< M + M₀ [force·length]
  foundation,        ///< sway [length] and rocking [rad]
  velocity,          ///< of floors, relative to the own base [length/s]
  acceleration,      ///< of floors, absolute [length/s²]
  node,              ///< displacement of nodes in struck columns [length]
  hinge_rotation,    ///< [rad]
  breaking_shear,    ///< Q + Q₀ of columns that break [force]
  infill_force,      ///< of panels of infill, across: k δ while they are whole [force]
  foundation_force,  ///< force [force] and moment [force·length] of the springs and dashpots below
  infill_push,       ///< Q + Q₀ + F of struts_on_columns() [force]
};

/// The outputs of one kind, a row each, in the order of the places where they are: floors or storeys from the lowest
/// up, hinges, … Each is  at_rest + rows · x + rates · ẋ + forces · F  with the forces F of the body's elements, or
/// absolute · ẍ + ground · a_g. What is not needed is empty.
struct Outputs {
  OutputKind kind = OutputKind::displacement;
  Eigen::Index count = 0;
  Eigen::MatrixXd rows = {}, rates = {}, absolute = {};  ///< count × dofs
  Eigen::MatrixXd forces = {};                           ///< count × elements, coupled ones last
  /// Of each component of the ground's motion in what is `absolute`, count × components [-]; empty: the first one.
  Eigen::MatrixXd ground = {};
  Eigen::VectorXd at_rest = {};
  /// Peaks of the continuous response are found; only of what has no `rates`, and `rows` or `absolute` alone.
  bool has_peak = false;
  /// How the exact course keeps them: not at all; at its instants; so that straight lines between its instants are near
  /// them.
  enum class Course { none, along, followed };
  Course course = Course::none;
};

/// A building as the solver sees it: matrices over degrees of freedom, what of it yields, and what is reported.
struct Body {
  std::string name;
  Modes modes;
  Eigen::MatrixXd modal_damping;    ///< Φᵀ C Φ [1/s]
  Eigen::MatrixXd mass, stiffness;  ///< M [mass], K [force/length]
  Eigen::MatrixXd load;             ///< p = −load · a_g, dofs × components of the ground's motion [mass]
  std::vector<BuildingElement> elements = {};
  std::vector<CoupledElement> coupled = {};
  double tangent_damping = 0;         ///< as Building's [s]
  std::vector<Outputs> outputs = {};  ///< one entry per kind, in its order; others may follow

  [[nodiscard]] Eigen::Index dofs() const { return mass.rows(); }
  [[nodiscard]] bool is_rigid() const { return modes.omega.size() == 0; }
};

[[nodiscard]] Body body_of(const Building& building);

}  // namespace bentur
