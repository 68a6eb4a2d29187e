#include "bentur/io/results/spectrum_files.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/io/results/internal/record_json.h"

namespace bentur {

std::string spectrum_csv(const RecordSpectrum& spectrum) {
  std::string csv = fmt::format(
      "period [s],displacement [{0}],pseudo_velocity [{0}/s],pseudo_acceleration [{0}/s2],"
      "absolute_acceleration [{0}/s2],pseudo_acceleration [g]\n",
      spectrum.units.length);
  for (std::size_t i = 0; i < spectrum.periods.size(); ++i) {
    const OscillatorPeaks& p = spectrum.peaks.at(i);
    csv += fmt::format("{},{},{},{},{},{}\n", spectrum.periods[i], p.displacement, p.pseudo_velocity,
                       p.pseudo_acceleration, p.absolute_acceleration, p.pseudo_acceleration / spectrum.units.gravity);
  }
  return csv;
}

std::string spectrum_json(const RecordSpectrum& spectrum, std::string_view version) {
  using Json = nlohmann::ordered_json;
  Json displacement, pseudo_velocity, pseudo_acceleration, absolute_acceleration;
  for (const OscillatorPeaks& p : spectrum.peaks) {
    displacement.push_back(p.displacement);
    pseudo_velocity.push_back(p.pseudo_velocity);
    pseudo_acceleration.push_back(p.pseudo_acceleration);
    absolute_acceleration.push_back(p.absolute_acceleration);
  }
  Json record;
  put_record(spectrum.record, record);
  const Json json = {{"file", spectrum.record.file},
                     {"record", record},
                     {"units", {{"length", spectrum.units.length}, {"gravity", spectrum.units.gravity}}},
                     {"version", version},
                     {"damping_ratio", spectrum.damping_ratio},
                     {"pga", spectrum.record.pga},
                     {"remarks", remarks_json(remarks(spectrum.record, spectrum.units))},
                     {"period", spectrum.periods},
                     {"displacement", displacement},
                     {"pseudo_velocity", pseudo_velocity},
                     {"pseudo_acceleration", pseudo_acceleration},
                     {"absolute_acceleration", absolute_acceleration}};
  return text_of(json);
}

}  // namespace bentur
