#include "bentur/model/run_results.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

namespace bentur {

FigureData figure_data(const RunResults& run) { return figure_data(run, NoMotion{}, {}); }

FigureData figure_data(const RunResults& run, const GroundMotion& of_known, FigureData known) {
  const auto* motion = std::get_if<SampledMotion>(&run.problem.motion);
  const auto* other = std::get_if<SampledMotion>(&of_known);
  const bool is_same = motion != nullptr && other != nullptr && *other == *motion;
  FigureData data = is_same ? std::move(known) : FigureData{};
  data.close_up = close_up(run.problem, run.response, run.c.analysis.solver);
  data.nearest = run.figures.nearest;
  std::vector<const PlaneFrame*> frames(run.problem.buildings.size(), nullptr);
  for (std::size_t b = 0; b < std::min(frames.size(), run.c.buildings.size()); ++b) {
    frames[b] = std::get_if<PlaneFrame>(&run.c.buildings[b].structure);
  }
  DenseFindings dense = dense_findings(run.problem, run.response, run.c.analysis.solver, frames);
  data.floor_spectra = std::move(dense.floors);
  data.frames = std::move(dense.frames);
  if (motion == nullptr) return data;
  double longest = 5;  // or of a building, with room to be seen [s]
  for (const Building& building : run.problem.buildings) {
    if (building.first_omega() > 0) longest = std::max(longest, 4 * std::numbers::pi / building.first_omega());
  }
  std::vector<double> periods = logarithmic_periods(0.02, longest, 201);
  if (data.spectrum_periods != periods) {
    data.spectrum_periods = std::move(periods);
    data.spectrum = response_spectrum(*motion, data.spectrum_periods, data.spectrum_damping);
  }
  return data;
}

Eigen::MatrixXd sway_shapes(const Building& building) {
  Eigen::MatrixXd shapes = building.modes.shapes.topRows(building.model.floors());
  for (auto shape : shapes.colwise()) {
    if (const double largest = shape.cwiseAbs().maxCoeff(); largest > 0) shape /= largest;
  }
  return shapes;
}

bool some_building_yields(const Problem& problem, const Response& response) {
  return std::any_of(problem.buildings.begin(), problem.buildings.end(),
                     [](const Building& building) { return building.can_yield(); }) ||
         std::any_of(response.buildings.begin(), response.buildings.end(), [](const BuildingPeaks& peaks) {
           return peaks.yielding.ductility.size() > 0 || peaks.infill.force.size() > 0;
         });
}

double applied_pga(const Case& c) {
  return c.excitation.record ? c.excitation.record->pga : peak_acceleration(c.excitation.motion);
}

RunResults run_results(Case c, Problem problem, Response response) {
  if (response.duration > 0) problem.duration = response.duration;
  problem.goes_on = false;
  std::vector<Remark> found = remarks(c, problem, &response);
  FigureData figures{.nearest = nearest_floor(problem, response)};
  return {std::move(c), std::move(problem), std::move(response), std::move(found), std::move(figures)};
}

Proportions proportions(const Building& building, const Units& units, const BuildingPeaks* peaks) {
  Proportions result;
  if (building.is_rigid()) return result;
  for (const double mass : building.model.floor_masses) result.weight += mass * units.gravity;
  const auto storeys = static_cast<double>(building.model.floors() - building.model.first_storey());
  result.period_per_storey = 2 * std::numbers::pi / building.first_omega() / storeys;
  if (peaks != nullptr && result.weight > 0) result.base_shear_coefficient = peaks->storey_shear(0) / result.weight;
  return result;
}

}  // namespace bentur
