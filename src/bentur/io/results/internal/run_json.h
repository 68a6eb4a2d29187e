#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/io/results/internal/code_json.h"
#include "bentur/io/results/internal/gap_json.h"
#include "bentur/io/results/judged_by_json.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/story.h"
#include "bentur/structure/known/modal.h"

// What results in JSON say of runs of rows and of plans alike.
namespace bentur {

/// Where quantities of a run are read from: of a row its view.
template <class Seen>
constexpr bool is_of_plan = std::is_same_v<Seen, PlanRun>;

/// The values of a quantity at places; empty where it is not reported there.
[[nodiscard]] inline std::vector<double> told_values(const Quantity& quantity, const RunView& run,
                                                     const std::vector<QuantityPlace>& places) {
  std::vector<double> values;
  if (!is_told_at_any(quantity, run, places)) return values;
  for (const QuantityPlace& at : places) values.push_back(value_of(quantity, run, at));
  return values;
}
[[nodiscard]] inline std::vector<double> told_values(const Quantity& quantity, const PlanRun& run,
                                                     const std::vector<QuantityPlace>& places) {
  return values_at(quantity, run, places);
}

/// Every quantity of one owner at these places, by its pointer, where nothing stands yet; of floors and planes a list.
template <class Seen>
void put_quantities(Json& json, Owner owner, const Seen& run, const std::vector<QuantityPlace>& places) {
  const bool is_list = owner == Owner::floor || owner == Owner::plane;
  for (const Quantity* const one : quantities_of(owner, is_of_plan<Seen>)) {
    const Json::json_pointer at(one->pointer.empty() ? "/" + std::string(one->key) : std::string(one->pointer));
    if (json.contains(at)) continue;
    Json list = Json::array();
    for (const double value : told_values(*one, run, places)) {
      const bool is_flag = is_of_plan<Seen> && one->source.number == QuantitySource::Number::yes_or_no;
      list.push_back(std::isnan(value) ? Json(nullptr)
                     : is_flag         ? Json(value != 0)
                     : is_whole(*one)  ? Json(static_cast<long>(value))
                                       : Json(value));
    }
    if (list.empty()) continue;
    json[at] = is_list ? std::move(list) : std::move(list.front());
  }
}

template <class AnyProblem>
[[nodiscard]] Json collapse_json(const AnyProblem& problem, const Collapse& collapse) {
  const auto& building = problem.buildings.at(static_cast<std::size_t>(collapse.building));
  return {
      {"building", building.name}, {"storey", building.model.storey_number(collapse.storey)}, {"time", collapse.time}};
}

[[nodiscard]] inline Json solver_json(const Solver& solver, const RunOutcome& response) {
  Json json = {{"name", name(solver)}};
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver)) json["tolerance"] = adaptive->tolerance;
  if (const auto* stepwise = std::get_if<RungeKuttaSolver>(&solver)) json["step"] = stepwise->step;
  json["steps"] = response.steps;
  json["wall_time"] = response.wall_time;
  json["peak_input_energy"] = response.energy ? Json(response.energy->peak_input) : Json(nullptr);
  return json;
}

/// How good the shapes are that were given, and what of the mass of each degree of freedom of the floors they move.
[[nodiscard]] inline Json modal_json(const KnownModes& known) {
  return {{"modes", known.modes.omega.size()},
          {"largest_product", known.largest_product},
          {"mass_shares", known.mass_shares}};
}

/// [excitation], of a case in plan with its angle and what is along y.
[[nodiscard]] inline Json excitation_json(const Case& c) {
  Json json = excitation_json(c.excitation);
  if (!c.is_in_plan() || c.excitation.spectrum) return json;  // which acts along both axes
  Json y = excitation_json(c.excitation_y);
  y.erase("delays");
  y.erase("kinematics");
  json["angle"] = c.angle;
  json["y"] = std::move(y);
  return json;
}

/// What keeps the gaps needed from being known.
template <class Seen>
[[nodiscard]] Json open_needs_json(const Seen& run) {
  Json list = Json::array();
  const auto bits = static_cast<std::uint64_t>(
      value_of(quantity_named("open_needs", Owner::run, is_of_plan<Seen>), run, QuantityPlace{}));
  for (std::size_t i = 0; i < open_need_keys().size(); ++i) {
    if ((bits >> i & 1U) != 0) list.push_back(open_need_keys()[i]);
  }
  return list;
}

template <class AnyProblem>
[[nodiscard]] Json told_json(const AnyProblem& problem, const std::vector<Statement>& statements) {
  std::vector<std::string> names;
  for (const auto& building : problem.buildings) names.push_back(building.name);
  return Json::parse(statements_json(names, statements));
}

/// The summary of a run but for its quantities.
/// @param seen where quantities are read from
template <class Run, class Seen>
[[nodiscard]] Json summary_of(const Run& run, const Seen& seen, std::string_view version, Json buildings, Json gaps) {
  put_judgements(told_judgements(run), gaps);
  Json json = {{"title", run.c.title},
               {"units", units_json(run.c.units)},
               {"version", version},
               {"case", source_json(run.c.source)},
               {"status", run.response.collapse ? "collapsed" : "completed"},
               {"solver", solver_json(run.c.analysis.solver, run.response)},
               {"excitation", excitation_json(run.c)},
               {"statements", told_json(run.problem, run_story(run).statements)},
               {"remarks", remarks_json(run.remarks)},
               {"buildings", std::move(buildings)},
               {"gaps", std::move(gaps)},
               {"judged_by", judged_by_json(run.response, drifts_no_contact(run.response))}};
  if (const auto& collapse = run.response.collapse) json["collapse"] = collapse_json(run.problem, *collapse);
  if (const auto& collapse = run.response.collapse_no_contact) {
    json["collapse_no_contact"] = collapse_json(run.problem, *collapse);
  }
  json["open_needs"] = open_needs_json(seen);  // of studies a bit each
  put_quantities(json, Owner::run, seen, {QuantityPlace{}});
  Json kinds = Json::array();  // of studies a bit each
  for (const Remark& one : run.remarks) {
    if (std::find(kinds.begin(), kinds.end(), one.key) == kinds.end()) kinds.push_back(one.key);
  }
  json["remark_counts"]["kinds"] = std::move(kinds);
  return json;
}

/// What gaps need and rules ask. @param row the run, or row_of() it @param screened of each gap
template <class Run>
[[nodiscard]] std::string gaps_json(const Run& run, const RunResults& row, std::string_view version,
                                    const std::vector<std::vector<ScreeningFinding>>& screened,
                                    const PlanProblem* plan = nullptr) {
  const std::vector<LevelSeparation> all = separations(row.problem, row.response, row.c.code, row.c.units);
  const bool falls = falls_without_contact(row.problem, row.response);
  Json gaps = Json::array();
  for (Eigen::Index gap = 0; gap < gap_count(row.problem); ++gap) {
    std::vector<LevelSeparation> levels = of_gap(all, gap);
    const double scale = displacement_scale(row.problem, row.response, gap);
    const std::vector<RuleFinding> findings =
        rule_findings(row.problem, levels, row.c.code, scale, falls, plan != nullptr);
    if (row.response.collapse_no_contact) forget_needs(levels);
    gaps.push_back(gap_json_of(row.c, row.problem, levels, findings, gap, screened.at(gap), plan));
  }
  put_judgements(told_judgements(run), gaps);
  return text_of({{"title", run.c.title},
                  {"units", units_json(run.c.units)},
                  {"version", version},
                  {"excitation", excitation_json(run.c)},
                  {"statements", told_json(run.problem, gap_story(run).statements)},
                  {"code_rules", code_rules_json(run.c.code)},
                  {"gaps", std::move(gaps)}});
}

}  // namespace bentur
