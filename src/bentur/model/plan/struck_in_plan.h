#pragma once

#include <string>
#include <vector>

#include "bentur/model/case_spec.h"

// Columns of buildings in plan that a neighbour's floor strikes between floors (docs/theory/plan.md).
namespace bentur {

/// A frame that runs across a joint, so that a floor of the other building strikes its column there.
struct FrameAcross {
  std::size_t plane = 0;  ///< of the building
  bool left = false;      ///< its leftmost column is there, else its rightmost one
  double along = 0;       ///< where its line meets the joint's edge, on the stretch [length]
};
/// The frames of side `side` (0 L, 1 R) of a stretch that run across it, within 45° of its normal, in the order of
/// planes.
[[nodiscard]] std::vector<FrameAcross> frames_across(const BuildingSpec& building, const Stretch& stretch, int side);

/// A column of a building that is struck.
struct StruckInPlan {
  Eigen::Index floor_or_node = 0;  ///< of its node, counted after all floors
  double along = 0;                ///< on the stretch [length]
  double mass = 0;                 ///< of its node [mass]
  double shear_capacity = 0;       ///< of its section [force]; infinite: not given
  std::size_t storey = 0;          ///< of the frame, 0 the lowest
};
/// Those of side `side` that have a node at an elevation [length].
[[nodiscard]] std::vector<StruckInPlan> struck_columns(const BuildingSpec& building, const Stretch& stretch, int side,
                                                       double elevation);

}  // namespace bentur
