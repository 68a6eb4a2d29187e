#include "bentur/io/results/story_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

Json values_json(const std::vector<StoryValue>& values) {
  Json json = Json::object();
  for (const StoryValue& value : values) {
    if (const auto* real = std::get_if<double>(&value.value)) {
      json[value.name] = {{"value", std::isnan(*real) ? Json(nullptr) : Json(*real)}, {"unit", value.unit}};
    } else if (const auto* count = std::get_if<long>(&value.value)) {
      json[value.name] = *count;
    } else if (!std::get<std::string>(value.value).empty()) {
      json[value.name] = std::get<std::string>(value.value);
    }
  }
  return json;
}

}  // namespace

std::string judgement_json(const ToldJudgement& told) {
  Json reasons = Json::array();
  for (std::size_t i = 0; i < told.reasons.size(); ++i) {
    const Reason& reason = told.judgement.reasons.at(i);
    const double level = told.elevations.at(i);
    Json values = values_json(told.reasons[i]);
    values.erase("why");
    values.erase("level");
    reasons.push_back({{"kind", word_of(reason.kind)},
                       {"way", reason.way == Way::given ? "given" : "reversed"},
                       {"level", std::isnan(level) ? Json(nullptr) : Json(level)},
                       {"values", values}});
  }
  return Json({{"value", word_of(told.judgement.value)},
               {"if_no_other_gap_closes", told.judgement.alone},
               {"reasons", reasons}})
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string statements_json(const Problem& problem, const std::vector<Statement>& statements) {
  std::vector<std::string> names;
  for (const Building& building : problem.buildings) names.push_back(building.name);
  return statements_json(names, statements);
}

std::string statements_json(const std::vector<std::string>& names, const std::vector<Statement>& statements) {
  Json json = Json::array();
  for (const Statement& statement : statements) {
    Json buildings = Json::array(), items = Json::array();
    for (const Eigen::Index b : statement.buildings) buildings.push_back(names.at(b));
    for (const auto& item : statement.items) items.push_back(values_json(item));
    Json one = {{"kind", statement.kind},
                {"severity", severity_name(statement.severity)},
                {"buildings", buildings},
                {"level", statement.level ? Json(*statement.level) : Json(nullptr)},
                {"values", values_json(statement.values)},
                {"shown", shown_name(statement.shown)}};
    if (statement.rank) one["rank"] = *statement.rank;
    if (!statement.subject.empty()) one["subject"] = statement.subject;
    if (!items.empty()) one["items"] = items;
    if (const auto& many = statement.many) {
      one["many"] = {{"count", many->count}, {"runs", many->runs}, {"worst", many->worst}};
    }
    json.push_back(one);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur
