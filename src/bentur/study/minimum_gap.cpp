#include "bentur/study/minimum_gap.h"

#include <cstddef>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

SeparationInput separation_input(const Building& building, const BuildingPeaks& peaks, int floor) {
  const double omega = building.modes.omega(0);
  return {.displacement = peaks.displacement_no_contact(floor),
          .period = 2 * std::numbers::pi / omega,
          .damping_ratio = building.modal_damping(0, 0) / (2 * omega)};
}

}  // namespace

std::vector<PointSeparation> separations(const Problem& problem, const Response& response) {
  if (response.buildings.size() != problem.buildings.size() || response.points.size() != problem.points.size()) {
    throw InvalidParameter("response", std::to_string(response.points.size()) + " points",
                           "must be the response of this problem");
  }
  std::vector<PointSeparation> result;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ContactPoint& point = problem.points[i];
    const auto left = static_cast<std::size_t>(point.left);
    const SeparationInput a = separation_input(problem.buildings[left], response.buildings[left], point.left_floor);
    const SeparationInput b =
        separation_input(problem.buildings[left + 1], response.buildings[left + 1], point.right_floor);
    result.push_back({.point = static_cast<int>(i),
                      .simulated = response.points[i].minimum_gap_no_contact,
                      .abs = separation_abs(a, b),
                      .srss = separation_srss(a, b),
                      .ddc = separation_ddc(a, b)});
  }
  return result;
}

}  // namespace bentur
