#include "bentur/io/results/plan/plan_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/io/results/internal/asked_json.h"
#include "bentur/io/results/internal/code_json.h"
#include "bentur/io/results/internal/gap_json.h"
#include "bentur/io/results/internal/hinges_json.h"
#include "bentur/io/results/judged_by_json.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/plan/plan_screening.h"
#include "bentur/model/story/story.h"
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

/// Every quantity of one owner at these places, by its pointer; of floors and planes a list.
void put_quantities(Json& json, Owner owner, const PlanRun& run, const std::vector<QuantityPlace>& places) {
  const bool is_list = owner == Owner::floor || owner == Owner::plane;
  for (const Quantity* const one : quantities_of(owner, true)) {
    Json list = Json::array();
    for (const double value : values_at(*one, run, places)) {
      const bool is_flag = one->source.number == QuantitySource::Number::yes_or_no;
      list.push_back(is_flag          ? Json(value != 0)
                     : is_whole(*one) ? Json(static_cast<long>(value))
                                      : or_null_if_unknown(value));
    }
    if (list.empty()) continue;
    const std::string pointer(one->pointer.empty() ? "/" + std::string(one->key) : one->pointer);
    json[Json::json_pointer(pointer)] = is_list ? std::move(list) : std::move(list.front());
  }
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

Json plan_statements_json(const PlanProblem& problem, const std::vector<Statement>& statements) {
  std::vector<std::string> names;
  for (const PlanBuilding& building : problem.buildings) names.push_back(building.name);
  return Json::parse(statements_json(names, statements));
}

Json plan_collapse_json(const PlanRun& run, const Collapse& collapse) {
  return {{"building", run.problem.buildings.at(static_cast<std::size_t>(collapse.building)).name},
          {"storey", run.problem.buildings[collapse.building].model.storey_number(collapse.storey)},
          {"time", collapse.time}};
}

Json excitations_json(const Case& c) {
  Json json = excitation_json(c.excitation);
  Json y = excitation_json(c.excitation_y);
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
  const auto row = row_of(run);
  Json buildings = Json::array(), gaps = Json::array(), impacts = Json::array();
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) buildings.push_back(plan_building_json(run, b));
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) gaps.push_back(plan_gap_json(run, *row, g));
  put_judgements(told_judgements(run), gaps);
  for (Index i = 0; i < std::ssize(run.response.impacts); ++i) impacts.push_back(plan_impact_json(run, i));
  Json json = {{"title", run.c.title},
               {"units", units_json(run.c.units)},
               {"version", version},
               {"case", source_json(run.c.source)},
               {"status", run.response.collapse ? "collapsed" : "completed"},
               {"solver", plan_solver_json(run)},
               {"excitation", excitations_json(run.c)},
               {"statements", plan_statements_json(run.problem, run_story(run).statements)},
               {"remarks", remarks_json(run.remarks)},
               {"discrepancies", discrepancies_json(run.response.discrepancies)},
               {"buildings", std::move(buildings)},
               {"gaps", std::move(gaps)},
               {"impacts", std::move(impacts)}};
  put_quantities(json, Owner::run, run, {QuantityPlace{}});
  json["judged_by"] = judged_by_json(run.response, drifts_no_contact(run));
  for (std::size_t i = 0; i < run.problem.links.size(); ++i) json["links"].push_back(plan_link_json(run, i));
  if (run.response.collapse) json["collapse"] = plan_collapse_json(run, *run.response.collapse);
  if (run.response.collapse_no_contact) {
    json["collapse_no_contact"] = plan_collapse_json(run, *run.response.collapse_no_contact);
  }
  return text_of(json);
}

std::string plan_gap_json(const PlanRun& run, std::string_view version) {
  const auto row = row_of(run);
  const std::vector<LevelSeparation> all = separations(row->problem, row->response, row->c.code, row->c.units);
  Json gaps = Json::array();
  for (Index gap = 0; gap < gap_count(row->problem); ++gap) {
    gaps.push_back(gap_json_of(row->c, row->problem, of_gap(all, gap),
                               displacement_scale(row->problem, row->response, gap),
                               row->response.collapse_no_contact.has_value(), gap,
                               plan_screening(run.c, run.problem, static_cast<std::size_t>(gap)), &run.problem));
  }
  put_judgements(told_judgements(run), gaps);
  return text_of({{"title", run.c.title},
                  {"units", units_json(run.c.units)},
                  {"version", version},
                  {"excitation", excitations_json(run.c)},
                  {"statements", plan_statements_json(run.problem, gap_story(run).statements)},
                  {"code_rules", code_rules_json(run.c.code)},
                  {"gaps", std::move(gaps)}});
}

std::string plan_height_rules_json(const Case& c, const PlanProblem& problem, std::string_view version) {
  const Problem row = row_of(problem);
  Json gaps = Json::array();
  for (Index gap = 0; gap < gap_count(row); ++gap) gaps.push_back(height_gap_json(c, row, gap));
  return text_of({{"title", c.title},
                  {"units", {{"length", c.units.length}, {"force", c.units.force}}},
                  {"version", version},
                  {"statements", plan_statements_json(problem, height_rules_story(c, problem).statements)},
                  {"code_rules", code_rules_json(c.code)},
                  {"gaps", std::move(gaps)}});
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
