#include "bentur/solve/engine/run/laws.h"

#include "bentur/elements/deformation_limit.h"

namespace bentur::engine {

std::vector<std::shared_ptr<const Law>> laws_of(const Problem& problem, const ModalSystem& system) {
  std::vector<std::shared_ptr<const Law>> laws;
  for (const ContactPoint& point : problem.points) laws.push_back(point.law);
  for (const Link& link : problem.links) laws.push_back(link.law);
  for (const ModalSystem::DriftLimit& limit : system.limits) {
    const double height = problem.buildings[limit.building].model.storey_heights[limit.storey];
    laws.push_back(std::make_shared<DeformationLimit>(problem.collapse_drift * height));
  }
  for (const Building& building : problem.buildings) {
    for (const BuildingElement& element : building.elements) laws.push_back(element.law);
  }
  return laws;
}

std::vector<double> offsets_of(const Problem& problem, const ModalSystem& system) {
  std::vector<double> offsets(system.elements.size(), 0.0);
  for (std::size_t i = 0; i < problem.points.size(); ++i) offsets[i] = -problem.points[i].width;
  return offsets;
}

}  // namespace bentur::engine
