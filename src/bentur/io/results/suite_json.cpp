#include "bentur/io/results/suite_json.h"

#include <nlohmann/json.hpp>

namespace bentur {

std::string suite_json(const SuiteSpec& suite) {
  using Json = nlohmann::ordered_json;
  const auto [first, last] = suite.target.band();
  Json records = Json::array(), buildings = Json::array();
  for (const SuiteRecord& record : suite.records) {
    records.push_back({{"file", record.echo.file},
                       {"factor", record.factor},
                       {"misfit", record.misfit},
                       {"event", record.event.empty() ? Json(nullptr) : Json(record.event)},
                       {"pga", record.echo.pga},
                       {"sha256", record.echo.sha256},
                       {"spectrum", record.spectrum}});
    if (record.along_y) {
      const RecordEcho& echo = record.along_y->echo;
      records.back()["along_y"] = {{"file", echo.file}, {"pga", echo.pga}, {"sha256", echo.sha256}};
    }
  }
  for (const SuitePeriods& one : suite.buildings) {
    buildings.push_back({{"building", one.name},
                         {"first_period", one.first},
                         {"second_period", one.second ? Json(*one.second) : Json(nullptr)}});
  }
  const Json json = {{"scale", suite.request.scale},
                     {"band", {first, last}},
                     {"periods", suite.target.periods},
                     {"target", suite.target.ordinates},
                     {"mean", suite.mean},
                     {"zero_period", {{"target", suite.target.at_zero}, {"mean", suite.mean_at_zero}}},
                     {"common_factor", suite.common_factor},
                     {"files", suite.files},
                     {"buildings", buildings},
                     {"records", records}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur
