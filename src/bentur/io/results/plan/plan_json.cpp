#include "bentur/io/results/plan/plan_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/io/results/internal/asked_json.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

Json numbers_or_null(const VectorXd& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(or_null_if_unknown(value));
  return json;
}

/// Peaks over those without contact; null where those are round-off.
Json amplification(const VectorXd& with, const VectorXd& without, double least) {
  Json json = Json::array();
  for (Index i = 0; i < with.size(); ++i) {
    json.push_back(without(i) > least ? Json(with(i) / without(i)) : Json(nullptr));
  }
  return json;
}

/// Below these a free peak is round-off, and has no amplification.
struct RoundOff {
  double displacement = 0;  ///< of the largest free peak of the case, rotations times half the longest side [length]
  double rotation = 0;      ///< that over this half [rad]
};

RoundOff round_off_of(const PlanRun& run) {
  constexpr double round_off = 1e-9;
  double largest = 0, side = 0;
  for (const PlanBuilding& building : run.problem.buildings) {
    side = std::max(side, building.model.footprint.size.maxCoeff());
  }
  for (const PlanPeaks& free : run.response.buildings_no_contact) {
    largest = std::max({largest, free.x.maxCoeff(), free.y.maxCoeff(), 0.5 * side * free.rotation.maxCoeff()});
  }
  return {round_off * largest, round_off * largest / (0.5 * side)};
}

Json planes_json(const PlanModel& model, const PlanPeaks& peaks) {
  Json planes = Json::array();
  for (std::size_t p = 0; p < peaks.planes.size(); ++p) {
    const PlanPeaks::Plane& plane = peaks.planes[p];
    Json json = {{"name", model.planes[p].name},
                 {"peak_drift_ratio", numbers_or_null(plane.drift_ratio)},
                 {"peak_shear", numbers_or_null(plane.shear)}};
    if (plane.yielding.ductility.size() > 0) {
      json["ductility"] = numbers_or_null(plane.yielding.ductility);
      json["residual_drift_ratio"] = numbers_or_null(plane.yielding.residual_drift_ratio);
      json["hysteretic_energy"] = numbers_or_null(plane.yielding.hysteretic_energy);
    }
    planes.push_back(std::move(json));
  }
  return planes;
}

Json plan_building_json(const PlanRun& run, std::size_t b, const RoundOff& least) {
  const PlanBuilding& building = run.problem.buildings[b];
  const PlanPeaks& with = run.response.buildings[b];
  const PlanPeaks& free = run.response.buildings_no_contact[b];
  Json json = {{"name", building.name}, {"elevations", building.model.elevations}};
  if (building.is_rigid()) {
    json["peak_displacement_x"] = numbers_or_null(with.x);
    json["peak_displacement_y"] = numbers_or_null(with.y);
    json["peak_acceleration_x"] = numbers_or_null(with.acceleration_x);
    json["peak_acceleration_y"] = numbers_or_null(with.acceleration_y);
    return json;
  }
  json["periods"] = numbers_or_null(modal_properties(building.modes, building.model.load.col(0)).periods);
  json["peak_displacement_x"] = numbers_or_null(with.x);
  json["peak_displacement_x_no_contact"] = numbers_or_null(free.x);
  json["amplification_x"] = amplification(with.x, free.x, least.displacement);
  json["peak_displacement_y"] = numbers_or_null(with.y);
  json["peak_displacement_y_no_contact"] = numbers_or_null(free.y);
  json["amplification_y"] = amplification(with.y, free.y, least.displacement);
  json["peak_rotation"] = numbers_or_null(with.rotation);
  json["peak_rotation_no_contact"] = numbers_or_null(free.rotation);
  json["amplification_rotation"] = amplification(with.rotation, free.rotation, least.rotation);
  json["peak_edge_displacement"] = {{"south", numbers_or_null(with.south)},
                                    {"north", numbers_or_null(with.north)},
                                    {"west", numbers_or_null(with.west)},
                                    {"east", numbers_or_null(with.east)}};
  json["peak_acceleration_x"] = numbers_or_null(with.acceleration_x);
  json["peak_acceleration_y"] = numbers_or_null(with.acceleration_y);
  json["peak_angular_acceleration"] = numbers_or_null(with.angular_acceleration);
  json["peak_storey_shear_x"] = numbers_or_null(with.shear_x);
  json["peak_storey_shear_y"] = numbers_or_null(with.shear_y);
  json["peak_storey_torque"] = numbers_or_null(with.torque);
  json["planes"] = planes_json(building.model, with);
  return json;
}

Json pair_json(const PlanPoint& at) { return {at.x(), at.y()}; }

Json plan_point_json(const PlanGap& gap, const PlanContact& contact, const PointSummary& point,
                     const PlanFriction& friction, const ContactSpec& spec) {
  Json json = {{"elevation", contact.elevation},
               {"at", pair_json(gap.stretch.middle(contact.along))},
               {"width", gap.stretch.width},
               {"gap_needed", point.gap_needed},
               {"gap_needed_reversed", or_null(point.gap_needed_reversed)},
               {"impacts", point.impacts},
               {"slow_starts", point.slow_starts},
               {"contact_duration", point.contact_duration},
               {"peak_force", point.peak_force},
               {"peak_force_time", or_null(point.peak_force_time)},
               {"peak_penetration", point.peak_penetration},
               {"peak_closing_speed", point.peak_closing_speed},
               {"impulse", point.impulse},
               {"energy_lost", point.energy_lost},
               {"peak_tension", point.peak_tension},
               {"contact", contact_json(*contact.law, spec)}};
  if (!contact.rubbing) return json;
  json["peak_tangential_force"] = friction.peak_tangential_force;
  json["tangential_impulse"] = friction.tangential_impulse;
  json["sliding"] = friction.sliding;
  json["friction_loss"] = friction.friction_loss;
  json["contact"]["friction"] = contact.rubbing->friction();
  json["contact"]["tangential_stiffness"] = contact.rubbing->tangential_stiffness();
  return json;
}

/// Floors between base and top of the other building that have no contact there, so that nothing is told of how near
/// they come to its columns.
Json not_watched_json(const PlanProblem& problem, const PlanGap& gap) {
  Json json = Json::array();
  for (const int side : {0, 1}) {
    const PlanBuilding& building = problem.buildings[side == 0 ? gap.left : gap.right];
    const PlanModel& other = problem.buildings[side == 0 ? gap.right : gap.left].model;
    const double base = other.elevations.front() - other.storey_heights.front();
    for (Index f = 0; f < building.model.floors(); ++f) {
      const double elevation = building.model.elevations[f];
      const bool touches = std::any_of(gap.contacts.begin(), gap.contacts.end(), [&](const PlanContact& contact) {
        return (side == 0 ? contact.left_floor : contact.right_floor) == f;
      });
      if (touches || elevation < base || elevation > other.elevations.back()) continue;
      json.push_back({{"floor_of", building.name}, {"elevation", elevation}});
    }
  }
  return json;
}

/// @param first the gap's first contact among those of all gaps
Json plan_gap_json(const PlanRun& run, std::size_t g, std::size_t first) {
  const PlanGap& gap = run.problem.gaps[g];
  Json points = Json::array();
  double needed = 0, reversed = 0;
  bool both_ways = run.c.analysis.both_ways;
  for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
    const PointSummary& point = run.response.points.at(first + i);
    needed = std::max(needed, point.gap_needed);
    reversed = std::max(reversed, point.gap_needed_reversed.value_or(0));
    both_ways = both_ways && point.gap_needed_reversed.has_value();
    points.push_back(
        plan_point_json(gap, gap.contacts[i], point, run.response.friction.at(first + i), run.c.gaps.at(g).contact));
    if (!run.c.analysis.both_ways) points.back()["gap_needed_reversed"] = nullptr;
  }
  return {{"between", {run.problem.buildings[gap.left].name, run.problem.buildings[gap.right].name}},
          {"normal", gap.stretch.across == 0 ? "x" : "y"},
          {"width", gap.stretch.width},
          {"stretch", {gap.stretch.from, gap.stretch.to}},
          {"gap_needed", needed},
          {"gap_needed_reversed", both_ways ? Json(reversed) : Json(nullptr)},
          {"not_watched", not_watched_json(run.problem, gap)},
          {"points", std::move(points)}};
}

/// A contact point by its place among those of all gaps.
std::pair<const PlanGap&, const PlanContact&> contact_at(const PlanProblem& problem, std::size_t point) {
  std::size_t g = 0;
  while (point >= problem.gaps.at(g).contacts.size()) point -= problem.gaps[g++].contacts.size();
  return {problem.gaps[g], problem.gaps[g].contacts[point]};
}

Json plan_impact_json(const PlanProblem& problem, const Impact& impact) {
  const auto& [gap, contact] = contact_at(problem, static_cast<std::size_t>(impact.point));
  const PlanPoint at = gap.stretch.middle(contact.along);
  Json json = {{"between", {problem.buildings[gap.left].name, problem.buildings[gap.right].name}},
               {"elevation", contact.elevation},
               {"x", at.x()},
               {"y", at.y()},
               {"start", impact.start},
               {"end", impact.end},
               {"open_ended", impact.open_ended},
               {"closing_speed", impact.closing_speed},
               {"separation_speed", impact.separation_speed},
               {"restitution", or_null(impact.restitution())},
               {"peak_force", impact.peak_force},
               {"peak_force_time", impact.peak_force_time},
               {"peak_penetration", impact.peak_penetration},
               {"impulse", impact.impulse},
               {"energy_lost", impact.energy_lost},
               {"peak_tension", impact.peak_tension}};
  if (contact.rubbing) json["tangential_impulse"] = impact.tangential_impulse;
  return json;
}

Json excitations_json(const PlanCase& c) {
  Json json = excitation_json(c.excitation[0]);
  Json y = excitation_json(c.excitation[1]);
  y.erase("delays");
  y.erase("kinematics");
  json["angle"] = c.angle;
  json["y"] = std::move(y);
  return json;
}

Json plan_solver_json(const PlanRun& run) {
  const std::optional<EnergyAudit>& energy = run.response.energy;
  Json json = {{"name", name(run.c.analysis.solver)}};
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&run.c.analysis.solver))
    json["tolerance"] = adaptive->tolerance;
  json["steps"] = run.response.steps;
  json["wall_time"] = run.response.wall_time;
  json["peak_input_energy"] = energy ? Json(energy->peak_input) : Json(nullptr);
  json["events"] = run.response.events;
  json["energy_residual"] = energy ? Json(energy->relative_residual()) : Json(nullptr);
  return json;
}

Json discrepancies_json(const std::vector<Discrepancy>& discrepancies) {
  Json json = Json::array();
  for (const Discrepancy& one : discrepancies) json.push_back({{"key", one.key}, {"size", one.size}});
  return json;
}

}  // namespace

std::string plan_summary_json(const PlanRun& run, std::string_view version) {
  Json buildings = Json::array(), gaps = Json::array(), impacts = Json::array();
  const RoundOff least = round_off_of(run);
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) buildings.push_back(plan_building_json(run, b, least));
  std::size_t first = 0;
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    gaps.push_back(plan_gap_json(run, g, first));
    first += run.problem.gaps[g].contacts.size();
  }
  for (const Impact& impact : run.response.impacts) impacts.push_back(plan_impact_json(run.problem, impact));
  return text_of({{"title", run.c.title},
                  {"units", units_json(run.c.units)},
                  {"version", version},
                  {"case", source_json(run.c.source)},
                  {"status", "completed"},
                  {"solver", plan_solver_json(run)},
                  {"excitation", excitations_json(run.c)},
                  {"discrepancies", discrepancies_json(run.response.discrepancies)},
                  {"buildings", std::move(buildings)},
                  {"gaps", std::move(gaps)},
                  {"impacts", std::move(impacts)}});
}

std::string plan_modes_json(const PlanProblem& problem) {
  Json all = Json::array();
  for (const PlanBuilding& building : problem.buildings) {
    Json shapes = Json::array();
    for (const auto& shape : building.modes.shapes.colwise()) shapes.push_back(numbers_or_null(shape));
    const ModalProperties x = modal_properties(building.modes, building.model.load.col(0));
    const ModalProperties y = modal_properties(building.modes, building.model.load.col(1));
    all.push_back({{"name", building.name},
                   {"periods", numbers_or_null(x.periods)},
                   {"participation_x", numbers_or_null(x.participation)},
                   {"participation_y", numbers_or_null(y.participation)},
                   {"effective_mass_fraction_x", numbers_or_null(x.effective_mass_fraction)},
                   {"effective_mass_fraction_y", numbers_or_null(y.effective_mass_fraction)},
                   {"shapes", std::move(shapes)}});
  }
  return text_of({{"buildings", std::move(all)}});
}

}  // namespace bentur
