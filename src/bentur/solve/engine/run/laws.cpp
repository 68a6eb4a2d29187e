#include "bentur/solve/engine/run/laws.h"

#include "bentur/elements/deformation_limit.h"

namespace bentur::engine {

using Eigen::Index;

std::vector<std::shared_ptr<const Law>> laws_of(const Problem& problem) {
  std::vector<std::shared_ptr<const Law>> laws;
  for (const ContactPoint& point : problem.points) laws.push_back(point.law);
  for (const Link& link : problem.links) laws.push_back(link.law);
  for (const Building& building : problem.buildings) {
    if (!building.has_gravity_loads) continue;
    for (Index f = building.model.has_slab ? 1 : 0; f < building.model.floors(); ++f) {
      laws.push_back(std::make_shared<DeformationLimit>(problem.collapse_drift * building.model.storey_heights[f]));
    }
  }
  for (const Building& building : problem.buildings) {
    for (const auto& law : building.storey_laws) {
      if (law) laws.push_back(law);
    }
  }
  return laws;
}

std::vector<double> offsets_of(const Problem& problem) {
  std::vector<double> offsets(laws_of(problem).size(), 0.0);
  for (std::size_t i = 0; i < problem.points.size(); ++i) offsets[i] = -problem.points[i].width;
  return offsets;
}

}  // namespace bentur::engine
