#include "bentur/io/results/result_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/io/results/internal/hinges_json.h"
#include "bentur/io/results/internal/run_json.h"
#include "bentur/io/results/rules_json.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_screening.h"
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

Json impedance_json(const Impedance& under) { return {{"stiffness", under.stiffness}, {"damping", under.damping}}; }

/// Springs and dashpots of the soil, given or derived.
Json soil_json(const PlanSoil& soil) {
  Json json = {{"sway_x", impedance_json(soil.sway_x)},
               {"sway_y", impedance_json(soil.sway_y)},
               {"rocking_x", impedance_json(soil.rocking_x)},
               {"rocking_y", impedance_json(soil.rocking_y)},
               {"twist", soil.twist ? impedance_json(*soil.twist) : Json("rigid")},
               {"foundation", {{"mass", soil.mass}, {"inertia_x", soil.inertia_x}, {"inertia_y", soil.inertia_y}}}};
  if (soil.twist) json["foundation"]["twist_inertia"] = soil.twist_inertia;
  return json;
}

/// What the hinges did of those planes of a building that are frames with some, by their numbers.
void put_frames(Json& planes, const PlanRun& run, Index b) {
  const std::vector<PlanFramePlace> places = frames_that_yield(run.problem);
  if (std::none_of(places.begin(), places.end(), [&](const PlanFramePlace& one) { return one.building == b; })) return;
  const RunResults frames = frames_of(run);
  const RunView view = frames.view();
  for (Index f = 0; f < std::ssize(places); ++f) {
    if (places[f].building != b) continue;
    Json& plane = planes[places[f].plane];
    const double energy = value_of(quantity_named("hinge_energy", Owner::building), view, {f});
    if (!std::isnan(energy)) plane["hinge_energy"] = energy;
    put_hinges(plane, view, f);
  }
}

Json isolation_json(const PlanRun& run, Index b) {
  const PlanModel& model = run.problem.buildings[b].model;
  const Index slab = 3 * *model.slab;
  Json bearings = Json::array();
  for (const QuantityPlace& place : bearings_of(run.problem, b)) {
    const PlanModel::Bearing& bearing = model.bearings[place.plane];
    const double stiffness = bearing.shears.row(0).norm() / bearing.drifts.row(0).norm();
    Json json = {{"at", {bearing.at.x(), bearing.at.y()}}, {"initial_stiffness", stiffness}};
    if (bearing.law) json["yield_displacement"] = bearing.law->yield_deformation();
    if (bearing.polygon) json["yield_sides"] = 2 * bearing.polygon->directions.rows();
    put_quantities(json, Owner::bearing, run, {place});
    bearings.push_back(std::move(json));
  }
  return {
      {"mass", model.mass(slab, slab)}, {"inertia", model.mass(slab + 2, slab + 2)}, {"bearings", std::move(bearings)}};
}

Json plan_building_json(const PlanRun& run, std::size_t b) {
  const PlanBuilding& building = run.problem.buildings[b];
  const auto item = static_cast<Index>(b);
  Json json = {{"name", building.name}, {"elevations", building.model.elevations}};
  json["periods"] = Json::array();
  if (!building.is_rigid()) {
    json["periods"] = numbers_or_null(modal_properties(building.modes, building.model.load.col(0)).periods);
  }
  put_quantities(json, Owner::floor, run, floors_of(run.problem, item));
  if (building.is_rigid()) return json;
  if (building.model.known) json["modal"] = modal_json(*building.model.known);
  if (building.model.stiffness_factor) json["stiffness_factor"] = *building.model.stiffness_factor;
  if (const auto& soil = building.model.soil) json["soil"] = soil_json(*soil);
  put_quantities(json, Owner::building, run, {{item}});
  if (building.model.slab) json["isolation"] = isolation_json(run, item);
  json["planes"] = Json::array();
  for (Index p = 0; p < std::ssize(building.model.planes); ++p) {
    Json plane = {{"name", building.model.planes[p].name}};
    put_quantities(plane, Owner::plane, run, floors_of(run.problem, item, p));
    json["planes"].push_back(std::move(plane));
  }
  put_frames(json["planes"], run, item);
  return json;
}

/// "x" or "y", or of others the components.
Json direction_json(const PlanPoint& direction) {
  if (direction == PlanPoint::UnitX()) return "x";
  if (direction == PlanPoint::UnitY()) return "y";
  return {direction.x(), direction.y()};
}

/// @param index among the contacts of all gaps
Json plan_point_json(const PlanRun& run, Index index) {
  const PlanContactPlace place = contact_at(run.problem, index);
  const PlanContact& contact = *place.contact;
  Json json = {{"elevation", contact.elevation}, {"at", {place.at.x(), place.at.y()}}};
  if (contact.beside) json["normal"] = direction_json(contact.beside->normal);
  if (const auto struck = struck_column(run.problem, run.problem.gaps[place.gap], contact)) {
    json["struck"] = run.problem.buildings[struck->building].name;
  }
  put_quantities(json, Owner::point, run, {{index}});
  json["contact"] = contact_json(*contact.law, run.c.gaps.at(place.gap).contact);
  if (!contact.rubbing) return json;
  json["contact"]["friction"] = contact.rubbing->friction();
  json["contact"]["tangential_stiffness"] = contact.rubbing->tangential_stiffness();
  return json;
}

/// "x" or "y", or of edges that are not parallel to them its components.
Json normal_json(const Stretch& stretch) {
  if (stretch.is_oblique()) return {stretch.n.x(), stretch.n.y()};
  return stretch.across == 0 ? "x" : "y";
}

Json plan_gap_json(const PlanRun& run, const RunResults& row, std::size_t g) {
  const PlanGap& gap = run.problem.gaps[g];
  const auto number = static_cast<Index>(g);
  const Index first = first_contact(run.problem, g);
  Json points = Json::array();
  for (Index i = first; i < first + std::ssize(gap.contacts); ++i) points.push_back(plan_point_json(run, i));
  Json json = {{"between", between_json(row.problem, number)},
               {"normal", normal_json(gap.stretch)},
               {"width", gap.stretch.width},
               {"stretch", {gap.stretch.from, gap.stretch.to}}};
  put_quantities(json, Owner::gap, run, {{number}});
  json["unmodelled_contact"] = unmodelled_list(row.problem, row.response, number, run.c.units.length, &run.problem);
  json["points"] = std::move(points);
  json["watched_floors"] = watched_list(row.problem, row.response, gap_at(row.problem, number), &run.problem);
  return json;
}

Json pair_between_json(const PlanProblem& problem, const PlanGap& gap) {
  return {problem.buildings[gap.left].name, problem.buildings[gap.right].name};
}

Json plan_impact_json(const PlanRun& run, Index index) {
  const PlanContactPlace place = contact_at(run.problem, run.response.impacts[index].point);
  Json json = {{"between", pair_between_json(run.problem, run.problem.gaps[place.gap])},
               {"elevation", place.contact->elevation},
               {"x", place.at.x()},
               {"y", place.at.y()}};
  put_quantities(json, Owner::impact, run, {{index}});
  return json;
}

/// @param index among the links of the problem
Json plan_link_json(const PlanRun& run, std::size_t index) {
  const PlanLink& link = run.problem.links[index];
  Json json = {{"between", {run.problem.buildings[link.link.left].name, run.problem.buildings[link.link.right].name}},
               {"elevation", link.link.elevation},
               {"at", link.stretch.coordinate(link.along)},
               {"along", direction_json(link.direction)}};
  put_quantities(json, Owner::link, run, {{static_cast<Index>(index)}});
  json["link"] = {{"kind", link.link.kind}};
  for (const auto& [name, value] : link.link.law->parameters()) json["link"][std::string(name)] = value;
  return json;
}

}  // namespace

std::string summary_json(const PlanRun& run, std::string_view version) {
  const auto row = row_of(run);
  Json buildings = Json::array(), gaps = Json::array(), impacts = Json::array();
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) buildings.push_back(plan_building_json(run, b));
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) gaps.push_back(plan_gap_json(run, *row, g));
  for (Index i = 0; i < std::ssize(run.response.impacts); ++i) impacts.push_back(plan_impact_json(run, i));
  Json json = summary_of(run, run, version, std::move(buildings), std::move(gaps));
  json["discrepancies"] = Json::array();
  for (const Discrepancy& one : run.response.discrepancies) {
    json["discrepancies"].push_back({{"key", one.key}, {"size", one.size}});
  }
  json["impacts"] = std::move(impacts);
  for (std::size_t i = 0; i < run.problem.links.size(); ++i) json["links"].push_back(plan_link_json(run, i));
  return text_of(json);
}

std::string gap_json(const PlanRun& run, std::string_view version) {
  std::vector<std::vector<ScreeningFinding>> screened;
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) screened.push_back(plan_screening(run.c, run.problem, g));
  return gaps_json(run, *row_of(run), version, screened, &run.problem);
}

std::string height_rules_json(const Case& c, const PlanProblem& problem, std::string_view version) {
  return height_rules_json(c, row_of(problem), version);
}

std::string modes_json(const PlanProblem& problem, const Units& /*units*/) {
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
