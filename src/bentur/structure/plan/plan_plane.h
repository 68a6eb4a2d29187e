#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "bentur/structure/building.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/plan/footprint.h"
#include "bentur/structure/stick.h"

// Frames and walls that hold the floors of a building in plan (docs/theory/plan.md).
namespace bentur {

/// A frame or a wall on a line in plan: one spring per storey along it (P-4).
struct PlanPlane {
  std::string name;
  PlanPoint through = PlanPoint::Zero();     ///< a point of the line, from the footprint's corner [length]
  PlanPoint direction = PlanPoint::UnitX();  ///< t, of length 1
  /// What its storeys are as those of a shear building: stiffnesses [force/length] ≥ 0, one of them > 0, and how they
  /// yield. Its heights and masses are not looked at.
  Stick storeys = {};
  /// Of a frame its stiffness against its sways along the line, those of all floors and then of its nodes, square
  /// [force/length] (P-23); the stiffnesses above are what its storeys have alone. Empty: springs of storeys.
  Eigen::MatrixXd sway_stiffness = {};
  Hinges hinges = {};                     ///< of a frame that yields or breaks, over these sways (P-30)
  std::vector<InfillPanel> infills = {};  ///< of a frame, which its stiffness has too
  std::vector<double> bays = {};          ///< of a frame its widths [length], left to right, of pictures alone
  /// Of a frame whose columns are struck between floors: what its nodes are, whose sways come after those of the floors
  /// in the lists above.
  struct Nodes {
    std::vector<Eigen::Index> storeys = {};  ///< in which they are, 0 the lowest
    std::vector<double> elevations = {};     ///< above the base [length]
    std::vector<double> masses = {};         ///< [mass]
    std::vector<double> from_floors = {};    ///< what they have of the mass of each floor [mass] ≥ 0
    Eigen::MatrixXd column_forces = {};      ///< StructuralModel::column_forces over the sways
    [[nodiscard]] Eigen::Index count() const { return std::ssize(storeys); }
  };
  Nodes nodes = {};
  std::shared_ptr<const PlaneFrame> frame = nullptr;  ///< that it was made of; null: springs, or not known
  [[nodiscard]] bool is_frame() const { return sway_stiffness.size() > 0; }
};

/// A frame as a plane has it, statically condensed: beams have no mass, columns have theirs where one is struck, and
/// floors weigh 1, which its stiffness does not depend on.
[[nodiscard]] PlaneFrame as_plane(PlaneFrame frame);

/// Makes a plane a frame: statically condensed onto the sways of its floors and of its nodes, with its hinges and
/// infill. Masses are looked at of columns that are struck alone. @throws InvalidParameter as plane_frame_model()
void stand_frame(const PlaneFrame& frame, PlanPlane& plane);

}  // namespace bentur
