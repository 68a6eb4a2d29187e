#include "bentur/structure/frame/frame_dofs.h"

#include <algorithm>

namespace bentur {

std::vector<ColumnEnd> ends_of_column(const PlaneFrame& frame, const FrameDofs& dofs, Eigen::Index floor,
                                      Eigen::Index line) {
  constexpr double least_distance = 0.01;  // of a node from a joint, of the storey height
  const std::vector<double> levels = floor_elevations(frame.storey_heights);
  std::vector<ColumnEnd> ends = {
      {dofs.sway(floor - 1), dofs.rotation(floor - 1, line), floor > 0 ? levels[floor - 1] : 0.0, -1}};
  const double height = frame.storey_heights[floor];
  for (Eigen::Index n = 0; n < dofs.nodes; ++n) {
    const ColumnNode& node = frame.nodes[n];
    if (line != (node.left ? 0 : dofs.lines - 1)) continue;
    const double above = node.elevation - ends.front().elevation;
    if (above <= least_distance * height || above >= (1 - least_distance) * height) continue;
    ends.push_back({dofs.floors + n, dofs.sways() + dofs.floors * dofs.lines + n, node.elevation, n});
  }
  std::sort(ends.begin() + 1, ends.end(),
            [](const ColumnEnd& a, const ColumnEnd& b) { return a.elevation < b.elevation; });
  ends.push_back({dofs.sway(floor), dofs.rotation(floor, line), levels[floor], -1});
  return ends;
}

}  // namespace bentur
