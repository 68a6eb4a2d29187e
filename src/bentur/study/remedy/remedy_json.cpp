#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/io/results/story_json.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/remedy/remedy_story.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

Json trial_json(const RemedySearch& search, const RemedyTrial& trial) {
  Json values = Json::object();
  for (std::size_t i = 0; i < search.parameters.size(); ++i) values[search.parameters[i].name] = trial.values[i];
  return {{"values", values},
          {"objective", std::isfinite(trial.objective) ? Json(trial.objective) : Json(nullptr)},
          {"size", trial.size},
          {"failed", trial.failed},
          {"not_known", trial.open.runs}};
}

Json found_json(const RemedySearch& search, const RemedyTrial* trial) {
  if (trial == nullptr) return nullptr;
  Json json = trial_json(search, *trial);
  Json ends = Json::array();
  for (const std::size_t i : search.at_bounds(*trial)) ends.push_back(search.parameters[i].name);
  json["at_bounds"] = ends;
  return json;
}

}  // namespace

std::string remedy_json(const RemedySearch& search, std::string_view version) {
  Json parameters = Json::array(), trials = Json::array();
  for (const RemedyParameter& one : search.parameters) {
    parameters.push_back({{"name", one.name},
                          {"parameter", one.parameter},
                          {"unit", one.unit},
                          {"from", one.range.from},
                          {"to", one.range.to}});
  }
  for (const RemedyTrial& one : search.trials) trials.push_back(trial_json(search, one));
  const RemedySpec& spec = search.spec();
  const Json json = {{"title", search.title},
                     {"version", version},
                     {"objective", spec.objective},
                     {"unit", search.unit},
                     {"of_records", spec.mean ? "mean" : "largest"},
                     {"both_ways", search.both_ways},
                     {"limit", spec.limit ? Json(*spec.limit) : Json(nullptr)},
                     {"parameters", parameters},
                     {"runs_each", search.runs_each},
                     {"with_derivatives", search.with_slopes},
                     {"stopped", search.stopped},
                     {"statements", Json::parse(statements_json(search.buildings, remedy_story(search).statements))},
                     {"best", found_json(search, search.best())},
                     {"smallest", found_json(search, search.smallest())},
                     {"evaluations", trials}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
