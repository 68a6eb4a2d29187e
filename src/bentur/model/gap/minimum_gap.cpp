#include "bentur/model/gap/minimum_gap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

SeparationInput separation_input(const Building& building, double displacement) {
  if (building.is_rigid()) return {.displacement = 0, .period = 1, .damping_ratio = 0};  // whatever its period
  const double omega = building.first_omega();
  return {.displacement = displacement,
          .period = 2 * std::numbers::pi / omega,
          .damping_ratio = building.modal_damping(0, 0) / (2 * omega)};
}

double height_of(const StructuralModel& model) {
  return std::accumulate(model.storey_heights.begin(), model.storey_heights.end(), 0.0);
}

CodeSide code_side(const Building& building, double displacement, Eigen::Index floor) {
  const auto& storeys = building.model.storey_heights;
  return {.displacement = displacement,
          .level = std::accumulate(storeys.begin(), storeys.begin() + floor + 1, 0.0),
          .height = height_of(building.model)};
}

}  // namespace

bool floors_aligned(const Building& left, const Building& right) {
  const std::vector<double>& a = left.model.elevations;
  const std::vector<double>& b = right.model.elevations;
  const std::vector<double>& lower = a.back() <= b.back() ? a : b;
  const std::vector<double>& other = a.back() <= b.back() ? b : a;
  const double tolerance = 1e-6 * std::max(height_of(left.model), height_of(right.model));
  const auto matched = [&](double floor) {
    return std::any_of(other.begin(), other.end(), [&](double x) { return std::abs(x - floor) <= tolerance; });
  };
  const auto below = static_cast<std::size_t>(
      std::count_if(other.begin(), other.end(), [&](double x) { return x <= lower.back() + tolerance; }));
  return below == lower.size() && std::all_of(lower.begin(), lower.end(), matched);
}

std::vector<PointSeparation> separations(const Problem& problem, const PeaksForRules& peaks, const CodeSpec& code,
                                         const Units& units) {
  const std::size_t buildings = problem.buildings.size();
  if (peaks.peaks.size() != buildings || peaks.of_codes.size() != buildings ||
      peaks.needed.size() != problem.points.size()) {
    throw InvalidParameter("peaks", std::to_string(peaks.needed.size()) + " points", "must be those of this problem");
  }
  std::vector<PointSeparation> result;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ContactPoint& point = problem.points[i];
    const auto left = static_cast<std::size_t>(point.left);
    const Building& left_building = problem.buildings[left];
    const Building& right_building = problem.buildings[left + 1];
    // Of a node in a column the rules look at the floor above.
    const Eigen::Index left_floor = left_building.model.floor_at_or_above(point.left_floor);
    const Eigen::Index right_floor = right_building.model.floor_at_or_above(point.right_floor);
    const SeparationInput a = separation_input(left_building, peaks.peaks[left](left_floor));
    const SeparationInput b = separation_input(right_building, peaks.peaks[left + 1](right_floor));
    result.push_back({.point = static_cast<int>(i),
                      .simulated = peaks.needed[i],
                      .abs = separation_abs(a, b),
                      .srss = separation_srss(a, b),
                      .ddc = separation_ddc(a, b),
                      .codes = {}});
    if (code.rules.empty()) continue;
    const CodePair pair{.left = code_side(left_building, peaks.of_codes[left](left_floor), left_floor),
                        .right = code_side(right_building, peaks.of_codes[left + 1](right_floor), right_floor),
                        .left_building = left,
                        .floors_aligned = code.floors_aligned ? code.floors_aligned->at(left)
                                                              : floors_aligned(left_building, right_building),
                        .same_owner = code.same_owner.empty() || code.same_owner.at(left),
                        .metre = 1 / metres(units.length)};
    for (const CodeRuleSpec& rule : code.rules) result.back().codes.push_back(code_separation(pair, rule));
  }
  return result;
}

std::vector<PointSeparation> separations(const Problem& problem, const Response& response, const CodeSpec& code,
                                         const Units& units) {
  if (response.buildings.size() != problem.buildings.size() || response.points.size() != problem.points.size()) {
    throw InvalidParameter("response", std::to_string(response.points.size()) + " points",
                           "must be the response of this problem");
  }
  PeaksForRules peaks;
  for (const BuildingPeaks& building : response.buildings) peaks.peaks.push_back(building.displacement_no_contact);
  for (const PointSummary& point : response.points) peaks.needed.push_back(point.minimum_gap_no_contact);
  peaks.of_codes = peaks.peaks;
  return separations(problem, peaks, code, units);
}

PointSeparation largest_of(const std::vector<PointSeparation>& separations, const std::vector<Eigen::Index>& points) {
  PointSeparation largest;
  for (const Eigen::Index i : points) {
    const PointSeparation& separation = separations.at(i);
    largest.simulated = std::max(largest.simulated, separation.simulated);
    largest.abs = std::max(largest.abs, separation.abs);
    largest.srss = std::max(largest.srss, separation.srss);
    largest.ddc = std::max(largest.ddc, separation.ddc);
    if (largest.codes.empty()) largest.codes = separation.codes;
    for (std::size_t k = 0; k < separation.codes.size(); ++k) {
      CodeSeparation& code = largest.codes[k];
      code.gap = std::max(code.gap, separation.codes[k].gap);
      code.to_left = std::max(code.to_left, separation.codes[k].to_left);
      code.to_right = std::max(code.to_right, separation.codes[k].to_right);
    }
  }
  return largest;
}

}  // namespace bentur
