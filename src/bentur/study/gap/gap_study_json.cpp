#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/io/results/story_json.h"
#include "bentur/io/results/suite_json.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/gap/gap_study_story.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

Json object_of(const std::vector<std::pair<std::string, std::string>>& named) {
  Json json = Json::object();
  for (const auto& [name, value] : named) json[name] = value;
  return json;
}

/// Neither what is not known nor what no gap would do is a number.
Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// @param need a GapNeed or a LevelSeparation
Json numbers_json(const auto& need) {
  return {{"gap_needed", or_null(need.gap_needed)},
          {"abs", or_null(need.abs)},
          {"srss", or_null(need.srss)},
          {"ddc", or_null(need.ddc)}};
}

Json need_json(const GapNeed& need, const CodeSpec& code) {
  Json codes = Json::array();
  for (std::size_t i = 0; i < need.codes.size(); ++i) {
    codes.push_back({{"rule", code.rules[i].rule}, {"gap", or_null(need.codes[i])}});
  }
  Json json = numbers_json(need);
  json["codes"] = codes;
  return json;
}

/// What the code takes of a suite's records; numbers only where it takes any.
Json demand_json(const SuiteDemand& demand, const CodeSpec& code) {
  const SuiteMeasure& measure = demand.measure;
  const bool is_mean = measure.kind == SuiteMeasure::Kind::mean;
  const bool is_known = demand.is_known();
  Json codes = Json::array();
  for (std::size_t i = 0; i < demand.codes.size() && is_known; ++i) {
    codes.push_back({{"rule", code.rules[i].rule}, {"gap", or_null(demand.codes[i])}});
  }
  return {{"code", measure.code},
          {"clause", measure.clause},
          {"takes", is_known ? Json(is_mean ? "mean" : "largest") : Json(nullptr)},
          {"gap_needed", is_known ? Json(demand.taken()) : Json(nullptr)},
          {"elevation", is_known ? Json(demand.elevation) : Json(nullptr)},
          {"too_narrow", is_known ? Json(demand.is_short) : Json(nullptr)},
          {"collapsed", demand.collapsed},
          {"codes", codes}};
}

/// Over the records, without them.
Json over_json(const GapStudy& study, const RecordNeeds& needs, std::size_t gap) {
  const GapOverRecords& over = needs.gaps[gap];
  Json quantiles = Json::array(), given = Json::array();
  for (const GapQuantile& one : over.quantiles) {
    quantiles.push_back({{"probability", one.probability}});
    quantiles.back().update(need_json(one.need, study.code));
  }
  for (const GivenGap& one : over.given) {
    given.push_back({{"with", object_of(one.others)},
                     {"widths", one.widths},
                     {"records_beyond", one.beyond},
                     {"records_open", one.open.runs},
                     {"share_beyond", static_cast<double>(one.beyond) / static_cast<double>(needs.records.size())}});
  }
  Json json = {{"between", {study.buildings.at(study.gaps[gap].left), study.buildings.at(study.gaps[gap].right)}},
               {"largest", need_json(over.largest, study.code)},
               {"median", need_json(over.median, study.code)},
               {"mean", need_json(over.mean, study.code)},
               {"quantiles", quantiles},
               {"given", given}};
  if (over.demand) json["code"] = demand_json(*over.demand, study.code);
  Json rules = Json::array();
  for (const RuleOverRecords& one : over.rules) {
    rules.push_back(
        {{"rule", one.rule},
         {"takes", one.takes_mean ? "mean" : "largest"},
         {"gap", or_null(one.asked)},
         {"elevation", or_null(std::isnan(one.asked) ? one.asked : one.elevation)},
         {"too_small", std::isnan(one.asked) || (one.too_few && !one.is_short) ? Json(nullptr) : Json(one.is_short)}});
  }
  json["rules"] = rules;
  return json;
}

Json gap_json(const GapStudy& study, const RecordNeeds& needs, std::size_t gap) {
  Json records = Json::array();
  for (const RecordNeed& record : needs.records) {
    records.push_back({{"record", record.record}, {"collapsed", record.falls}});
    Json open = Json::array();
    for (std::size_t i = 0; i < open_need_keys().size(); ++i) {
      if ((record.open >> i & 1U) != 0) open.push_back(open_need_keys()[i]);
    }
    records.back()["open_needs"] = open;
    if (record.intensity) records.back()["intensity"] = *record.intensity;
    records.back().update(need_json(record.gaps[gap], study.code));
    Json points = Json::array(), watched = Json::array();
    for (const LevelSeparation& one : of_gap(record.separations, static_cast<Eigen::Index>(gap))) {
      Json& list = one.level.is_point ? points : watched;
      list.push_back({{"elevation", one.level.elevation}});
      list.back().update(numbers_json(one));
    }
    records.back()["watched_floors"] = watched;
    records.back()["points"] = points;
  }
  Json json = over_json(study, needs, gap);
  json["records"] = records;
  return json;
}

}  // namespace

std::string gap_study_json(const GapStudy& study, std::string_view version, std::string_view said) {
  Json rules = Json::array();
  for (const CodeRuleSpec& spec : study.code.rules) {
    const CodeRule* const rule = find_code_rule(spec.rule);
    rules.push_back({{"rule", rule->name},
                     {"title", rule->title},
                     {"clause", rule->clause},
                     {"wording", rule->wording},
                     {"assumes", rule->assumes},
                     {"motion", rule->motion}});
  }
  Json all = Json::array();
  for (const RecordNeeds& needs : study.needs) {
    Json gaps = Json::array();
    for (std::size_t gap = 0; gap < needs.gaps.size(); ++gap) gaps.push_back(gap_json(study, needs, gap));
    all.push_back({{"with", object_of(needs.others)}, {"gaps", gaps}});
  }
  Json intensity = nullptr;
  if (!study.intensity.empty()) {
    intensity = {{"name", study.intensity},
                 {"unit", study.intensity_unit},
                 {"value", study.at ? Json(*study.at) : Json(nullptr)}};
  }
  Json json = {{"title", study.title},
               {"units", {{"length", study.units.length}, {"force", study.units.force}}},
               {"version", version},
               {"intensity", intensity},
               {"statements", Json::parse(statements_json(study.buildings, gap_study_story(study).statements))},
               {"code_rules", rules},
               {"studied", all}};
  if (!said.empty()) json.update(Json::parse(said));
  if (study.suite) json["suite"] = Json::parse(suite_json(*study.suite));
  if (!study.is_whole()) json["stopped"] = {{"done", study.done}, {"asked", study.asked}};
  if (study.together) {
    Json gaps = Json::array();
    for (std::size_t gap = 0; gap < study.together->gaps.size(); ++gap) {
      gaps.push_back(over_json(study, *study.together, gap));
    }
    json["together"] = {{"runs", study.together->records.size()}, {"gaps", gaps}};
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
