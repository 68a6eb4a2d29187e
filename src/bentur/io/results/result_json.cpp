#include "bentur/io/results/result_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "bentur/io/results/internal/hinges_json.h"
#include "bentur/io/results/internal/run_json.h"
#include "bentur/model/plan/plan_screening.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

Json list(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

/// Where a hinge is, as the case counts.
Json place_json(const HingePlace& place) {
  if (place.of_beam) {
    return {{"member", "beam"}, {"floor", place.level}, {"bay", place.number}, {"end", word_of(place.end)}};
  }
  return {{"member", "column"}, {"storey", place.level}, {"line", place.number}, {"end", word_of(place.end)}};
}

/// What the columns of a frame did that can break in shear.
void put_breaking_columns(Json& json, const RunView& run, Eigen::Index b) {
  const std::vector<BreakingColumn>& columns = run.problem.buildings[b].model.hinges.columns;
  if (columns.empty()) return;
  json["breaking_columns"] = Json::array();
  for (const QuantityPlace& at : breaking_columns_of(run.problem, b)) {
    const BreakingColumn& place = columns[at.floor];
    Json column = {{"storey", place.storey}, {"line", place.line}};
    if (place.piece > 0) column["piece"] = place.piece;
    column["shear_capacity"] = place.capacity;
    put_quantities(column, Owner::column, run, {at});
    json["breaking_columns"].push_back(std::move(column));
  }
}

/// Springs and dashpots of the soil, given and derived.
Json soil_json(const SoilSpec& spec) {
  const Soil soil = soil_of(spec);
  Json json = {{"sway", {{"stiffness", soil.sway.stiffness}, {"damping", soil.sway.damping}}},
               {"rocking", {{"stiffness", soil.rocking.stiffness}, {"damping", soil.rocking.damping}}},
               {"foundation", {{"mass", soil.mass}, {"inertia", soil.inertia}}}};
  if (const auto& half_space = spec.half_space) {
    json["half_space"] = {{"shear_wave_velocity", half_space->shear_wave_velocity},
                          {"density", half_space->density},
                          {"poisson", half_space->poisson},
                          {"radius", half_space->radius}};
  }
  return json;
}

Json building_json(const RunView& run, const Case& c, Eigen::Index b) {
  const Building& building = run.problem.buildings[b];
  Json json = {{"name", building.name},
               {"elevations", building.model.elevations},
               {"periods", list(modal_properties(building.modes, building.model.load).periods)}};
  if (building.model.stiffness_factor) json["stiffness_factor"] = *building.model.stiffness_factor;
  if (b < std::ssize(c.buildings)) {
    const BuildingSpec& spec = c.buildings[b];
    if (spec.soil) json["soil"] = soil_json(*spec.soil);
    if (const auto* modal = std::get_if<ModalBuilding>(&spec.structure)) {
      json["modal"] = modal_json(modal_model(*modal, spec.base_elevation).known);
    }
  }
  put_quantities(json, Owner::building, run, {{b}});
  put_quantities(json, Owner::floor, run, floors_of(run.problem, b));
  if (!building.model.hinges.places.empty() || !building.model.hinges.columns.empty()) put_hinges(json, run, b);
  return json;
}

Json point_json(const RunView& run, Eigen::Index i, const ContactSpec& contact) {
  const ContactPoint& point = run.problem.points[i];
  Json json = {{"elevation", point.elevation}, {"width", point.width}};
  json["restitution"] = {{"asked", or_null(run.restitutions[i].asked)}};
  if (const auto struck = struck_column(run.problem, point)) {
    json["struck"] = run.problem.buildings[struck->building].name;
  }
  put_quantities(json, Owner::point, run, {{i}});
  if (run.response.collapse_no_contact) json["gap_needed"] = nullptr;
  json["contact"] = contact_json(*point.law, contact);
  return json;
}

/// The links of each [[link]] table of the case.
Json links_json(const RunView& run, const Case& c) {
  Json tables = Json::array();
  for (const std::vector<Eigen::Index>& of_table : links_by_spec(c.links)) {
    Json points = Json::array();
    Json names;
    for (const Eigen::Index i : of_table) {
      const Link& link = run.problem.links.at(static_cast<std::size_t>(i));
      Json json = {{"elevation", link.elevation}};
      put_quantities(json, Owner::link, run, {{i}});
      json["link"] = {{"law", c.links[tables.size()].law}};
      for (const auto& [name, value] : link.law->parameters()) json["link"][std::string(name)] = value;
      points.push_back(json);
      names = {run.problem.buildings[link.left].name, run.problem.buildings[link.right].name};
    }
    tables.push_back({{"between", names}, {"points", points}});
  }
  return tables;
}

}  // namespace

void put_hinges(Json& json, const RunView& run, Eigen::Index b) {
  const Hinges& hinges = run.problem.buildings[b].model.hinges;
  const BuildingPeaks& peaks = run.response.buildings[b];
  json["mechanism"] = nullptr;
  if (peaks.mechanism) {
    json["mechanism"] = {{"time", peaks.mechanism->time}, {"storeys", Json::array()}};
    for (const Eigen::Index storey : peaks.mechanism->storeys) {
      json["mechanism"]["storeys"].push_back(run.problem.buildings[b].model.storey_number(storey));
    }
  }
  put_breaking_columns(json, run, b);
  if (hinges.places.empty()) return;
  json["hinge_order"] = hinge_order(peaks, run.problem.duration);
  json["hinges"] = Json::array();
  for (const QuantityPlace& at : hinges_of(run.problem, b)) {
    Json hinge = place_json(hinges.places[at.floor]);
    put_quantities(hinge, Owner::hinge, run, {at});
    const bool known = hinges.clockwise.size() > at.floor;  // not from histories.nc
    if (known && std::isinf(hinges.clockwise(at.floor)) && std::isinf(hinges.anticlockwise(at.floor))) {
      hinge["never_flows"] = true;
    }
    if (hinges.rotation_limits.rows() > at.floor && !std::isnan(hinges.rotation_limits(at.floor, 0))) {
      hinge["rotation_demand"] =
          list(peaks.hinges[at.floor].peak_rotation * hinges.rotation_limits.row(at.floor).cwiseInverse().transpose());
    }
    json["hinges"].push_back(std::move(hinge));
  }
}

std::string summary_json(const RunResults& results, std::string_view version) {
  const RunView run = results.view();
  const Case& c = results.c;
  Json buildings = Json::array();
  for (Eigen::Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    buildings.push_back(building_json(run, c, b));
  }
  Json gaps = Json::array();
  for (const Gap& gap : gaps_of(run.problem)) {
    Json points = Json::array();
    for (const Eigen::Index i : gap.points) points.push_back(point_json(run, i, c.gaps.at(gap.number).contact));
    Json json = {{"between", between_json(run.problem, gap.number)}};
    put_quantities(json, Owner::gap, run, {{gap.number}});
    json["unmodelled_contact"] = unmodelled_list(run.problem, run.response, gap.number, c.units.length);
    json["points"] = points;
    json["watched_floors"] = watched_list(run.problem, run.response, gap);
    gaps.push_back(json);
  }
  Json json = summary_of(results, run, version, std::move(buildings), std::move(gaps));
  if (!c.links.empty()) json["links"] = links_json(run, c);
  return text_of(json);
}

std::string modes_json(const Problem& problem, const Units& units) {
  Json all = Json::array();
  for (const Building& building : problem.buildings) {
    const ModalProperties properties = modal_properties(building);
    Json shapes = Json::array();
    for (Eigen::Index mode = 0; mode < building.modes.shapes.cols(); ++mode) {
      shapes.push_back(list(building.modes.shapes.col(mode)));
    }
    const Proportions found = proportions(building, units, nullptr);
    const auto known = [&](double value) { return building.is_rigid() ? Json(nullptr) : Json(value); };
    all.push_back({{"name", building.name},
                   {"periods", list(properties.periods)},
                   {"weight", known(found.weight)},
                   {"period_per_storey", known(found.period_per_storey)},
                   {"participation", list(properties.participation)},
                   {"effective_mass_fraction", list(properties.effective_mass_fraction)},
                   {"shapes", shapes}});
  }
  return text_of({{"buildings", all}});
}

std::string gap_json(const RunResults& results, std::string_view version) {
  std::vector<std::vector<ScreeningFinding>> screened;
  for (Eigen::Index gap = 0; gap < gap_count(results.problem); ++gap) {
    screened.push_back(screening(results.problem, gap, results.c.screening, results.c.units));
  }
  return gaps_json(results, results, version, screened);
}

namespace {

Eigen::VectorXd periods_of(const Modes& modes) { return 2 * std::numbers::pi * modes.omega.cwiseInverse(); }

}  // namespace

std::string spectral_gap_json(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                              std::string_view version) {
  Json buildings = Json::array(), gaps = Json::array();
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const SpectralModes& modes = spectral.modes.at(b);
    const SpectralPeaks& peaks = spectral.peaks.at(b);
    buildings.push_back({{"name", building.name},
                         {"elevations", building.model.elevations},
                         {"periods", list(periods_of(building.modes))},
                         {"damping_ratios", list(modes.damping)},
                         {"spectral_displacement", list(modes.displacement)},
                         {"peak_displacement_srss", list(peaks.srss)},
                         {"peak_displacement_cqc", list(peaks.cqc)}});
    if (spectral.plan) {
      buildings.back()["peak_displacement_y_srss"] = list(peaks.srss_y);
      buildings.back()["peak_displacement_y_cqc"] = list(peaks.cqc_y);
    }
    if (const auto& given = building.given) {
      buildings.back()["given"] = {{"displacements", list(given->displacement)},
                                   {"amplification", given->amplification},
                                   {"period", or_null(given->period)}};
    }
  }
  for (const Gap& gap : gaps_of(problem)) {
    const std::vector<LevelSeparation> levels = of_gap(spectral.levels, gap.number);
    const std::vector<RuleFinding> findings =
        rule_findings(problem, levels, c.code, 0, false, spectral.plan != nullptr);
    gaps.push_back(gap_json_of(c, problem, levels, findings, gap.number,
                               spectral.plan ? plan_screening(c, *spectral.plan, static_cast<std::size_t>(gap.number))
                                             : screening(problem, gap.number, c.screening, c.units)));
  }
  put_judgements(told_judgements(c, problem, spectral), gaps);
  return text_of(
      {{"title", c.title},
       {"units", units_json(c.units)},
       {"version", version},
       {"excitation", excitation_json(c)},
       {"statements", Json::parse(statements_json(problem, spectral_story(c, problem, spectral).statements))},
       {"code_rules", code_rules_json(c.code)},
       {"buildings", buildings},
       {"gaps", gaps}});
}

}  // namespace bentur
