#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {

std::string sensitivity_json(const Sensitivity& found, std::string_view version) {
  using Json = nlohmann::ordered_json;
  Json numbers = Json::array(), left_out = Json::array(), peaks = Json::array();
  for (const CaseNumber& number : found.numbers) numbers.push_back({{"path", number.path}, {"value", number.value}});
  for (const auto& [path, why] : found.left_out) left_out.push_back({{"path", path}, {"why", why}});
  for (const SensitivePeak& peak : found.peaks) {
    const Derivative& of = peak.derivative;
    if (of.by.size() == 0) continue;
    Json gradient = Json::array(), elasticity = Json::array();
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
      gradient.push_back(of.by(static_cast<Eigen::Index>(i)));
      elasticity.push_back(found.elasticity(peak, i));
    }
    const bool of_gap = peak.kind == SensitivePeak::Kind::gap_needed || peak.kind == SensitivePeak::Kind::peak_force;
    peaks.push_back({{"quantity", key_of(peak.kind)},
                     {of_gap ? "gap" : "building", peak.name},
                     {"level", peak.level},
                     {"value", of.value},
                     {"time", of.time},
                     {"largest", peak.is_largest},
                     {"grazing", of.grazing},
                     {"equalled", of.is_equalled},
                     {"simultaneous", of.is_simultaneous},
                     {"gradient", gradient},
                     {"elasticity", elasticity}});
  }
  const Json json = {{"title", found.title},
                     {"version", version},
                     {"units", {{"length", found.units.length}, {"force", found.units.force}}},
                     {"numbers", numbers},
                     {"left_out", left_out},
                     {"peaks", peaks}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
