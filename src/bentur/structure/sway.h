#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// The face of a building that looks at a neighbour.
enum class Face { left, right };

/// Where an elevation is: in the storey below floor `upper`, at the part `s` of it from below, 1 at the floor.
struct StoreyPlace {
  Eigen::Index upper = 0;
  double s = 1;
};

/// @param elevations of the floors and `heights` of the storeys below them [length], from the lowest up
/// @throws InvalidParameter unless the elevation is between base and top, to a millionth of the height.
[[nodiscard]] StoreyPlace storey_place(const std::vector<double>& elevations, const std::vector<double>& heights,
                                       double elevation);

/// Sway of the outermost column at an elevation, as a row over the dofs [-, or length on a rotation that was kept]. Of
/// a frame the cubic with the sways and the joint rotations at the ends of that storey's column (the shape functions of
/// a prismatic member without load along it, to which element stiffness (2-48) belongs; recovered rotations where they
/// were condensed); of other models the straight line between floors. The base does neither sway nor rotate.
/// @throws InvalidParameter unless the elevation is between base and top, to a millionth of the height.
[[nodiscard]] Eigen::VectorXd sway_at(const StructuralModel& model, double elevation, Face face);

/// Elevation of the base [length].
[[nodiscard]] double base_of(const StructuralModel& model);

}  // namespace bentur
