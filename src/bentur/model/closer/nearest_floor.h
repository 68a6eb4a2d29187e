#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// The watched floor of a run that comes nearest to what it faces, where no contact is modelled.
struct NearestFloor {
  Eigen::Index watched = 0;                   ///< its number among Problem::watched
  Eigen::Index gap = 0, left = 0, right = 0;  ///< buildings on both sides
  Eigen::Index floor_of = 0, floor = 0;       ///< whose floor it is, and which
  bool faces_floor = false;                   ///< else a column between two floors
  double elevation = 0, width = 0;            ///< [length]
  double least_opening = 0;                   ///< < 0: so far inside what it faces [length]
  double least_time = 0;                      ///< when [s]
  bool closes = false;
  /// The opening there over time, of the exact course or else of samples; empty where the ground's displacement counts
  /// or rotations of joints that are no history.
  std::vector<double> time = {}, opening = {};

  [[nodiscard]] Eigen::Index faced() const { return floor_of == left ? right : left; }
};

/// Nothing without watched floors.
[[nodiscard]] std::optional<NearestFloor> nearest_floor(const Problem& problem, const Response& response);

/// How far each watched floor is inside what it faces at a sample of the histories, in their order; 0: it is not, or
/// its opening is not known over time. [length]
[[nodiscard]] std::vector<double> depths_inside(const Problem& problem, const Histories& histories,
                                                Eigen::Index sample);

/// Displacements of all degrees of freedom of a building that histories hold, dofs × samples: of floors, nodes and
/// foundation; zero of others. [length], of rocking [rad]
[[nodiscard]] Eigen::MatrixXd dof_histories(const Histories& histories, const Problem& problem, Eigen::Index building);

}  // namespace bentur
