#pragma once

#include <vector>

namespace bentur {

struct Points {
  std::vector<double> x = {}, y = {};
  std::vector<double> top = {};  ///< of an area the upper edge, y being the lower one
};

/// What of a curve can be seen at a resolution of `columns`: of the points in each column of equal width the first, the
/// lowest, the highest and the last, in their order. No extremum is lost or moved, but by round-off. Curves of up to 4
/// · columns points, and those whose x does not ascend, come back as they are; NaN stays, once per column.
[[nodiscard]] Points thinned(const std::vector<double>& x, const std::vector<double>& y, int columns);

/// The envelope of a line, its lowest and its highest value in each column of equal width; nothing where it does not go
/// up and down so often that it would fill the area between them, or where its x does not ascend.
[[nodiscard]] Points envelope(const std::vector<double>& x, const std::vector<double>& y, int columns);

}  // namespace bentur
