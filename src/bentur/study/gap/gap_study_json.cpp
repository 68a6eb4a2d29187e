#include <nlohmann/json.hpp>

#include "bentur/study/gap/gap_study.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

Json need_json(const GapNeed& need, const CodeSpec& code) {
  Json codes = Json::array();
  for (std::size_t i = 0; i < need.codes.size(); ++i) {
    codes.push_back({{"rule", code.rules[i].rule}, {"gap", need.codes[i]}});
  }
  return {{"simulated", need.simulated}, {"abs", need.abs}, {"srss", need.srss}, {"ddc", need.ddc}, {"codes", codes}};
}

Json gap_json(const GapStudy& study, const RecordNeeds& needs, std::size_t gap) {
  const auto left = static_cast<int>(gap);
  Json records = Json::array();
  for (const RecordNeed& record : needs.records) {
    Json json = {{"record", record.record}};
    json.update(need_json(record.gaps[gap], study.code));
    Json points = Json::array();
    for (const PointSeparation& one : record.separations) {
      const ContactPoint& point = study.problem.points.at(static_cast<std::size_t>(one.point));
      if (point.left != left) continue;
      points.push_back({{"elevation", point.elevation},
                        {"simulated", one.simulated},
                        {"abs", one.abs},
                        {"srss", one.srss},
                        {"ddc", one.ddc}});
    }
    json["points"] = points;
    records.push_back(json);
  }
  const GapOverRecords& over = needs.gaps[gap];
  Json quantiles = Json::array(), given = Json::array();
  for (const GapQuantile& one : over.quantiles) {
    Json json = {{"probability", one.probability}};
    json.update(need_json(one.need, study.code));
    quantiles.push_back(json);
  }
  for (const GivenGap& one : over.given) {
    Json with = Json::object();
    for (const auto& [name, value] : one.others) with[name] = value;
    given.push_back({{"with", with},
                     {"widths", one.widths},
                     {"records_beyond", one.beyond},
                     {"share_beyond", static_cast<double>(one.beyond) / static_cast<double>(needs.records.size())}});
  }
  return {{"between", {study.problem.buildings[gap].name, study.problem.buildings[gap + 1].name}},
          {"largest", need_json(over.largest, study.code)},
          {"median", need_json(over.median, study.code)},
          {"quantiles", quantiles},
          {"given", given},
          {"records", records}};
}

}  // namespace

std::string gap_study_json(const GapStudy& study, std::string_view version) {
  Json rules = Json::array();
  for (const CodeRuleSpec& spec : study.code.rules) {
    const CodeRule* const rule = find_code_rule(spec.rule);
    rules.push_back(
        {{"rule", rule->name}, {"title", rule->title}, {"clause", rule->clause}, {"wording", rule->wording}});
  }
  Json all = Json::array();
  for (const RecordNeeds& needs : study.needs) {
    Json others = Json::object();
    for (const auto& [name, value] : needs.others) others[name] = value;
    Json gaps = Json::array();
    for (std::size_t gap = 0; gap < needs.gaps.size(); ++gap) gaps.push_back(gap_json(study, needs, gap));
    all.push_back({{"with", others}, {"gaps", gaps}});
  }
  Json intensity = nullptr;
  if (study.at) intensity = {{"name", study.intensity}, {"unit", study.intensity_unit}, {"value", *study.at}};
  const Json json = {{"title", study.title}, {"units", {{"length", study.units.length}, {"force", study.units.force}}},
                     {"version", version},   {"intensity", intensity},
                     {"code_rules", rules},  {"studied", all}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
