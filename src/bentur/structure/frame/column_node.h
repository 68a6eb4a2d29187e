#pragma once

namespace bentur {

/// A node in an outer column between two floors, where a neighbour's floor may strike it: a sway and a rotation of that
/// column alone.
struct ColumnNode {
  bool left = false;     ///< in the leftmost column line; else in the rightmost one
  double elevation = 0;  ///< above the base [length]
};

}  // namespace bentur
