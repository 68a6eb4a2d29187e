#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/structure/frame/plane_frame.h"

namespace bentur {

/// The degrees of freedom of assemble_plane_frame(), by what they are of. Floor −1 is the base, which does not move.
struct FrameDofs {
  static constexpr Eigen::Index fixed = -1;  ///< what does not move
  Eigen::Index floors = 0, lines = 0, nodes = 0;

  explicit FrameDofs(const PlaneFrame& frame)
      : floors(std::ssize(frame.storey_heights)),
        lines(std::ssize(frame.bay_widths) + 1),
        nodes(std::ssize(frame.nodes)) {}
  [[nodiscard]] Eigen::Index sways() const { return floors + nodes; }
  [[nodiscard]] Eigen::Index count() const { return sways() + floors * lines + nodes; }
  [[nodiscard]] Eigen::Index sway(Eigen::Index floor) const { return floor < 0 ? fixed : floor; }
  [[nodiscard]] Eigen::Index rotation(Eigen::Index floor, Eigen::Index line) const {
    return floor < 0 ? fixed : sways() + floor * lines + line;
  }
};

/// One end of a piece of a column.
struct ColumnEnd {
  Eigen::Index sway, rotation;
  double elevation;   ///< above the base [length]
  Eigen::Index node;  ///< −1: a joint or the base
};

/// Of the column below a floor, from bottom to top: the joint or the base, nodes in it, the joint above.
[[nodiscard]] std::vector<ColumnEnd> ends_of_column(const PlaneFrame& frame, const FrameDofs& dofs, Eigen::Index floor,
                                                    Eigen::Index line);

}  // namespace bentur
