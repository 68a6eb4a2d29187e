#include "bentur/io/results/internal/gap_json.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/io/results/internal/code_json.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_row.h"

namespace bentur {
namespace {

/// `at`: [x, y] in the middle of the gap; nothing of a row.
void put_place(const PlanProblem* plan, const Problem& row, bool is_point, Eigen::Index index, Json& json) {
  if (plan == nullptr) return;
  const PlanPoint at = place_of(*plan, row, is_point, index);
  json["at"] = {at.x(), at.y()};
}

/// Of one watched floor: where it is, and what it needs or does.
Json watched_json(const Problem& problem, Eigen::Index index, const PlanProblem* plan) {
  const WatchedFloor& floor = problem.watched[index];
  Json json = {{"floor_of", problem.buildings[floor.floor_of].name}, {"elevation", floor.elevation}};
  put_place(plan, problem, false, index, json);
  json["faces"] = floor.facing_floor           ? "floor"
                  : faces_base(problem, floor) ? "base"
                  : plan != nullptr            ? "edge"
                                               : "column";
  json["width"] = floor.width;
  return json;
}

Json codes_json(const std::vector<CodeSeparation>& codes) {
  Json json = Json::array();
  for (const CodeSeparation& code : codes) json.push_back(code_separation_json(code));
  return json;
}

/// What a level needs, or a whole gap.
Json separation_json(const LevelSeparation& separation) {
  Json json = {{"gap_needed", or_null_if_unknown(separation.gap_needed)},
               {"abs", or_null_if_unknown(separation.abs)},
               {"srss", or_null_if_unknown(separation.srss)},
               {"ddc", or_null_if_unknown(separation.ddc)},
               {"codes", codes_json(separation.codes)}};
  if (separation.gap_needed_reversed) json["gap_needed_reversed"] = *separation.gap_needed_reversed;
  return json;
}

/// What each rule asks where it falls short the most.
Json findings_json(const std::vector<RuleFinding>& findings, const std::vector<LevelSeparation>& levels,
                   const Problem& problem, const PlanProblem* plan) {
  Json json = Json::array();
  for (const RuleFinding& found : findings) {
    Json one = {{"rule", found.rule}};
    if (found.at) {
      const FacingLevel& level = levels[*found.at].level;
      one.update({{"gap", found.gap}, {"elevation", level.elevation}});
      put_place(plan, problem, level.is_point, level.index, one);
      one.update({{"width", level.width},
                  {"given_is", found.is_short ? "too_small" : "enough"},
                  {"understates", found.lacks.has_value()}});
    } else {
      one.update({{"given_is", "not_evaluated"}, {"reason", silence_name(found.silence)}});
    }
    json.push_back(one);
  }
  return json;
}

Json screening_json(const std::vector<ScreeningFinding>& findings, const Units& units) {
  Json json = Json::array();
  for (const ScreeningFinding& found : findings) {
    json.push_back({{"rule", found.rule->name},
                    {"value", found.value},
                    {"limit", or_null(found.limit)},
                    {"unit", found.rule->unit == "length" ? units.length : std::string(found.rule->unit)},
                    {"verdict", verdict_text(found.verdict)},
                    {"source", found.rule->source},
                    {"wording", found.rule->wording}});
  }
  return json;
}

}  // namespace

void put_judgements(const std::vector<ToldJudgement>& told, Json& gaps) {
  for (std::size_t gap = 0; gap < told.size(); ++gap) {
    gaps.at(gap)["judgement"] = told[gap].is_facing() ? Json::parse(judgement_json(told[gap])) : Json(nullptr);
  }
}

Json between_json(const Problem& problem, Eigen::Index gap) {
  const GapPair sides = sides_of(problem, gap);
  return {problem.buildings[sides.left].name, problem.buildings[sides.right].name};
}

Json watched_list(const Problem& problem, const Response& response, const Gap& gap, const PlanProblem* plan) {
  Json list = Json::array();
  for (const Eigen::Index i : gap.watched) {
    Json json = watched_json(problem, i, plan);
    const WatchedSummary& summary = response.watched.at(i);
    json["gap_needed"] = response.collapse_no_contact ? Json(nullptr) : Json(summary.gap_needed);
    json["gap_needed_reversed"] = or_null(summary.gap_needed_reversed);
    json["peak_left_no_contact"] = or_null_if_unknown(summary.peak_left);
    json["peak_right_no_contact"] = or_null_if_unknown(summary.peak_right);
    json["least_opening"] = summary.least_opening;
    json["time"] = summary.least_time;
    list.push_back(json);
  }
  return list;
}

Json unmodelled_list(const Problem& problem, const Response& response, Eigen::Index gap, const std::string& length,
                     const PlanProblem* plan) {
  Json list = Json::array();
  for (const Eigen::Index i : unmodelled_contacts(problem, response.watched, gap)) {
    const WatchedFloor& floor = problem.watched[i];
    Json json = {{"floor_of", problem.buildings[floor.floor_of].name}, {"elevation", floor.elevation}};
    put_place(plan, problem, false, i, json);
    json.update({{"least_opening", response.watched[i].least_opening},
                 {"time", response.watched[i].least_time},
                 {"to_model", remedy_text(problem, floor, length, plan != nullptr)}});
    list.push_back(std::move(json));
  }
  return list;
}

void forget_needs(std::vector<LevelSeparation>& levels) {
  for (LevelSeparation& one : levels) {
    one.gap_needed = one.abs = one.srss = one.ddc = not_known;
    one.gap_needed_reversed.reset();
    for (CodeSeparation& code : one.codes) code.gap = not_known, code.to_left = code.to_right = {};
  }
}

Json gap_json_of(const Case& c, const Problem& problem, const std::vector<LevelSeparation>& levels,
                 const std::vector<RuleFinding>& findings, Eigen::Index gap,
                 const std::vector<ScreeningFinding>& screened, const PlanProblem* plan) {
  Json points = Json::array(), watched = Json::array();
  for (const LevelSeparation& one : levels) {
    if (one.level.is_point) {
      points.push_back({{"elevation", one.level.elevation}});
      put_place(plan, problem, true, one.level.index, points.back());
      points.back()["width"] = one.level.width;
    } else {
      watched.push_back(watched_json(problem, one.level.index, plan));
    }
    (one.level.is_point ? points : watched).back().update(separation_json(one));
  }
  Json json = {{"between", between_json(problem, gap)}};
  json.update(separation_json(largest_of(levels)));
  json["rules"] = findings_json(findings, levels, problem, plan);
  json["points"] = points;
  json["watched_floors"] = watched;
  json["screening"] = screening_json(screened, c.units);
  return json;
}

}  // namespace bentur
