#include "bentur/model/restitution.h"

#include <algorithm>
#include <cstddef>

namespace bentur {

std::vector<PointRestitution> restitutions(const Problem& problem, const Response& response) {
  std::vector<PointRestitution> result(problem.points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!problem.points[i].law) continue;  // read from results alone
    for (const auto& [name, value] : problem.points[i].law->parameters()) {
      if (name == "restitution") result[i].asked = value;
    }
  }
  for (const Impact& impact : response.impacts) {
    PointRestitution& point = result.at(static_cast<std::size_t>(impact.point));
    if (const auto obtained = impact.restitution()) {
      point.smallest = std::min(point.smallest.value_or(*obtained), *obtained);
      point.largest = std::max(point.largest.value_or(*obtained), *obtained);
    }
  }
  return result;
}

}  // namespace bentur
