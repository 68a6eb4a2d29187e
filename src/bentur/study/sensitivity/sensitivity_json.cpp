#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {

namespace {

using Json = nlohmann::ordered_json;

Json peaks_json(const Sensitivity& found, const std::vector<SensitivePeak>& of_all) {
  Json peaks = Json::array();
  for (const SensitivePeak& peak : of_all) {
    const Derivative& of = peak.derivative;
    if (of.by.size() == 0) continue;
    Json gradient = Json::array(), elasticity = Json::array();
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
      gradient.push_back(of.by(static_cast<Eigen::Index>(i)));
      elasticity.push_back(found.elasticity(peak, i));
    }
    peaks.push_back({{"quantity", key_of(peak.kind)},
                     {is_of_gap(peak.kind) ? "gap" : "building", peak.name},
                     {"level", peak.level},
                     {"value", of.value},
                     {"time", std::isnan(of.time) ? Json(nullptr) : Json(of.time)},
                     {"largest", peak.is_largest},
                     {"grazing", of.grazing},
                     {"equalled", of.is_equalled},
                     {"simultaneous", of.is_simultaneous},
                     {"gradient", gradient},
                     {"elasticity", elasticity}});
    if (peak.at) peaks.back()["at"] = {peak.at->x(), peak.at->y()};
    if (!peak.record.empty()) peaks.back()["record"] = peak.record;
  }
  return peaks;
}

}  // namespace

std::string sensitivity_json(const Sensitivity& found, std::string_view version) {
  Json numbers = Json::array(), left_out = Json::array();
  for (const CaseNumber& number : found.numbers) numbers.push_back({{"path", number.path}, {"value", number.value}});
  for (const auto& [path, why] : found.left_out) left_out.push_back({{"path", path}, {"why", why}});
  Json json = {{"title", found.title},
               {"version", version},
               {"units", {{"length", found.units.length}, {"force", found.units.force}}},
               {"numbers", numbers},
               {"left_out", left_out},
               {"peaks", peaks_json(found, found.peaks)}};
  if (!found.records.empty()) {
    json["takes"] = found.takes_mean ? "mean" : "largest";
    json["records"] = Json::array();
    for (const Sensitivity::OfRecord& one : found.records) {
      json["records"].push_back({{"record", one.record}, {"peaks", peaks_json(found, one.peaks)}});
    }
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
